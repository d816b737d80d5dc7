// The stage: counts down, shows the match from its kick-off on, and loads the page again after it.
"use strict";
const SPREAD_MS = 10000; // not all spectators ask at the same moment
const stage = document.getElementById("stage"), left = document.getElementById("left"), frame = stage.querySelector("iframe");
const begins = Date.now() + Number(stage.dataset.beginsMs);
const again = (ms) => setTimeout(() => location.reload(), ms + Math.random() * SPREAD_MS);
again(Number(stage.dataset.againMs));
addEventListener("message", ({source, data}) => {
  if (source === frame?.contentWindow && data === "gone") again(0); // taken off the stage
});
const tick = () => {
  const seconds = Math.ceil((begins - Date.now()) / 1000);
  left.hidden = seconds <= 0;
  frame.hidden = seconds > 0;
  document.body.classList.toggle("on", seconds <= 0);
  if (seconds <= 0) return;
  const two = (number) => String(number).padStart(2, "0"), hours = Math.floor(seconds / 3600);
  left.textContent = `${hours ? `${hours}:` : ""}${two(Math.floor(seconds / 60) % 60)}:${two(seconds % 60)}`;
  setTimeout(tick, 250);
};
if (frame) tick();

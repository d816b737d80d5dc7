// Waits for a check: asks every 3 s while the page is seen, and loads it again when something has changed.
"use strict";
const {state, tag} = document.currentScript.dataset;  // the tag is that of the state which the page shows
const look = async () => {
  if (document.hidden) return;
  try {
    const answer = await fetch(state, {headers: {"If-None-Match": tag}, cache: "no-store"});
    if (answer.ok && answer.headers.get("ETag")?.replace(/^W\//, "") !== tag) location.reload();
  } catch { /* the network is away for a moment */ }
};
look();
setInterval(look, 3000);

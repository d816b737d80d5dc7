// Waits for a check: asks every 3 s while the page is seen, and loads it again when something has changed.
"use strict";
const address = document.currentScript.dataset.state;
let tag = null;
const look = async () => {
  if (document.hidden) return;
  try {
    const answer = await fetch(address, {headers: tag ? {"If-None-Match": tag} : {}, cache: "no-store"});
    const now = answer.headers.get("ETag");
    if (tag && answer.ok && now !== tag) location.reload();
    if (answer.ok) tag = now;
  } catch { /* the network is away for a moment */ }
};
look();
setInterval(look, 3000);

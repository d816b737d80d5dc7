// The last of the parts of the live page: begins.

const spectator = new Spectator(JSON.parse(document.getElementById("facts").textContent), (app) => {
  window.replay = Object.assign(app.handle(), { spectator });
  document.body.classList.add("ready");
});
spectator.feed.follow().catch((error) => {
  spectator.tell(`This match cannot be shown: ${error.message}`);
  console.error(error);
});

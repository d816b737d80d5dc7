// The last of the parts of the live page: begins.

const spectator = new Spectator(JSON.parse(document.getElementById("facts").textContent), (app) => {
  const { recording } = app;
  // What tests and other pages may use: where the match is, and to go elsewhere.
  window.replay = {
    recording,
    app,
    spectator,
    get place() { return app.player.place; },
    get half() { return recording.at(app.player.place).track.facts.half; },
    get tick() { return recording.at(app.player.place).tick; },
    seek: (half, tick) => app.go(recording.placeOf(half, tick), false),
  };
  document.body.classList.add("ready");
});
spectator.feed.follow().catch((error) => {
  spectator.tell(`This match cannot be shown: ${error.message}`);
  console.error(error);
});

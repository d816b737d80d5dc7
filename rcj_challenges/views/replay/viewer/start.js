// The last of the parts: begins.

Embedded.recording()
  .then((recording) => {
    const app = new App(recording);
    // What tests and other pages may use: where the match is, and to go elsewhere.
    window.replay = {
      recording,
      app,
      get place() { return app.player.place; },
      get half() { return recording.at(app.player.place).track.facts.half; },
      get tick() { return recording.at(app.player.place).tick; },
      seek: (half, tick) => app.go(recording.placeOf(half, tick), false),
    };
    document.body.classList.add("ready");
  })
  .catch((error) => {
    const problem = document.getElementById("problem");
    const old = typeof DecompressionStream === "undefined";
    problem.textContent = old ? "This browser is too old to read the recording; a current one can." : `This recording cannot be shown: ${error.message}`;
    problem.hidden = false;
    console.error(error);
  });

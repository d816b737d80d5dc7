// The last of the parts: begins.

Embedded.recording()
  .then((recording) => {
    window.replay = new App(recording).handle();
    document.body.classList.add("ready");
  })
  .catch((error) => {
    const problem = document.getElementById("problem");
    const old = typeof DecompressionStream === "undefined";
    problem.textContent = old ? "This browser is too old to read the recording; a current one can." : `This recording cannot be shown: ${error.message}`;
    problem.hidden = false;
    console.error(error);
  });

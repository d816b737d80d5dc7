// Drag and drop, and a bar while the archive goes; without this script the form works as it is.
"use strict";
const form = document.getElementById("upload");
if (form) {
  const field = form.elements.archive, bar = form.querySelector("progress"), state = document.getElementById("upload-state");
  const button = form.querySelector("button");
  const send = () => {
    const request = new XMLHttpRequest();
    bar.hidden = false;
    button.disabled = true;
    state.textContent = "";
    request.upload.onprogress = (event) => { bar.value = event.loaded / event.total; };
    request.onload = () => {
      let answer = {};
      try { answer = JSON.parse(request.responseText); } catch { answer = {message: request.responseText.slice(0, 200)}; }
      if (request.status === 201) { location.assign(answer.address); return; }
      fail(answer.message || String(request.status));
    };
    request.onerror = () => fail("…");
    request.open("POST", form.action);
    request.setRequestHeader("Accept", "application/json");
    request.send(new FormData(form));
  };
  const fail = (text) => { bar.hidden = true; button.disabled = false; state.textContent = text; };
  form.addEventListener("submit", (event) => { event.preventDefault(); send(); });
  for (const kind of ["dragover", "dragenter"]) {
    addEventListener(kind, (event) => { event.preventDefault(); form.classList.add("dropping"); });
  }
  addEventListener("dragleave", (event) => { if (!event.relatedTarget) form.classList.remove("dropping"); });
  addEventListener("drop", (event) => {
    event.preventDefault();
    form.classList.remove("dropping");
    if (event.dataTransfer.files.length === 1) { field.files = event.dataTransfer.files; send(); }
  });
}

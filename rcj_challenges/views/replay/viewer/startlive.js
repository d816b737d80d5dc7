// The last of the parts of the live page: begins.

const liveClient = new LiveClient(JSON.parse(document.getElementById("facts").textContent), (app) => {
  window.replay = Object.assign(app.handle(), { liveClient });
  document.body.classList.add("ready");
});
liveClient.feed.follow().catch((error) => {
  liveClient.tell(`This match cannot be shown: ${error.message}`);
  console.error(error);
});

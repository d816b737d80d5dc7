// The last of the parts of the page of a stage: begins. The page stands in a frame and tells the one around it when the
// match is over, or gone.

if (new URLSearchParams(location.search).has("stage")) document.body.classList.add("bare");
const stageFacts = JSON.parse(document.getElementById("facts").textContent);
const liveClient = new LiveClient(stageFacts, (app) => {
  window.replay = Object.assign(app.handle(), { liveClient });
  document.body.classList.add("ready");
}, (take, lost) => new LiveFeed("", take, lost));
liveClient.feed.follow().then(() => parent.postMessage(liveClient.recording.over ? "over" : "gone", "*")).catch((error) => {
  liveClient.tell(`This match cannot be shown: ${error.message}`);
  console.error(error);
});

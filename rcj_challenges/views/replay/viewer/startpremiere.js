// The last of the parts of a premiere: counts down, waits for the recording, begins.

const RETRY_DATA_MS = 5000;

class Premiere {
  constructor(facts) {
    this.facts = facts;
    this.offset = 0;
    this.asked = -Infinity;
    this.begun = false;
    this.overlay = element("div", "premiere");
    this.overlay.id = "premiere";
    this.left = element("output", "left");
    this.left.id = "countdown";
    this.state = element("p", "news");
    this.state.setAttribute("role", "status");
    const pair = element("h1", "pair");
    facts.teams.forEach((team, index) => pair.append(...(index ? [" – "] : []), element("bdi", "", team.title)));
    const home = element("a", "home", "← To the tournament");
    home.href = facts.home;
    this.overlay.append(element("bdi", "match", facts.what), pair, this.left, element("p", "starts", this.when()), this.state, home);
    document.body.append(this.overlay);
    window.premiere = (data) => this.begin(data);
  }

  now() { return Date.now() + this.offset; }

  when() {
    const local = new Date(this.facts.start).toLocaleString([], { weekday: "long", hour: "2-digit", minute: "2-digit", timeZoneName: "short" });
    return `${this.facts.when} · here: ${local}`;
  }

  static leftText(ms) {
    const seconds = Math.max(0, Math.ceil(ms / 1000));
    const two = (number) => String(number).padStart(2, "0");
    const days = Math.floor(seconds / 86400), hours = Math.floor(seconds / 3600) % 24;
    const clock = `${two(Math.floor(seconds / 60) % 60)}:${two(seconds % 60)}`;
    return `${days ? `${days} d ` : ""}${days || hours ? `${two(hours)}:` : ""}${clock}`;
  }

  async run() {
    this.tick();
    this.offset = await clockOffset();
  }

  tick() {
    if (this.begun) return;
    const left = this.facts.start - this.now();
    const text = Premiere.leftText(left);
    if (this.left.textContent !== text) this.left.textContent = text;
    if (left <= 0) this.ask();
    setTimeout(() => this.tick(), 200);
  }

  /** Load the recording: it is uploaded when the premiere begins, perhaps a little later. */
  ask() {
    if (Date.now() - this.asked < RETRY_DATA_MS) return;
    this.asked = Date.now();
    const script = element("script");
    script.src = `${this.facts.data}?${Math.floor(this.asked / RETRY_DATA_MS)}`; // no cache may say that it is not there
    script.addEventListener("error", () => {
      script.remove();
      this.state.textContent = "The recording is not there yet; trying again…";
    });
    document.head.append(script);
  }

  begin(data) {
    if (this.begun || data.id !== this.facts.id) return;
    this.begun = true;
    const liveClient = new LiveClient(PremiereFeed.factsBefore(data.facts), (app) => {
      window.replay = Object.assign(app.handle(), { liveClient });
      this.overlay.remove();
      document.body.classList.add("ready");
    }, (take, lost) => new PremiereFeed(data, { start: this.facts.start, halfTime: this.facts.half_time_s }, () => this.now(), take, lost));
    liveClient.feed.follow().catch((error) => {
      this.state.textContent = `This match cannot be shown: ${error.message}`;
      console.error(error);
    });
  }
}

new Premiere(JSON.parse(document.getElementById("facts").textContent)).run();

// Watching a match that is being played: the picture follows the match a moment behind, until one looks back.

const FEED_EVERY_S = 0.1; // unless the facts say otherwise
const CUSHION_S = 0.1; // beyond the time from one part of the feed to the next
const QUIET_S = 0.4;
const MARKS_EVERY_S = 0.5;

class LivePlayer extends Player {
  constructor(recording) {
    super(recording);
    const every = recording.facts.feed_every_s ?? FEED_EVERY_S;
    this.cushion = every + CUSHION_S;
    this.quiet = every + QUIET_S;
    this.following = true;
    this.arrivals = [];
    this.playing = true;
  }

  /** More of the match has come. */
  arrived(now) {
    this.arrivals.push([now, this.recording.last]);
    while (this.arrivals.length > 2 && now - this.arrivals[0][0] > 1.5) this.arrivals.shift();
  }

  /** Ticks a second at which the match comes. */
  pulse(now) {
    const first = this.arrivals[0], last = this.arrivals[this.arrivals.length - 1];
    if (!first || now - last[0] > this.quiet || last[0] - first[0] < 0.05) return 0;
    return (last[1] - first[1]) / (last[0] - first[0]);
  }

  get moves() {
    if (!this.following) return this.playing;
    return this.place < this.recording.last;
  }

  follow() {
    this.following = true;
    this.start(1, 1);
    this.jumped = true;
    this.place = this.recording.last;
  }

  leave() {
    this.following = false;
  }

  seek(place) {
    this.leave();
    super.seek(place);
  }

  pause() {
    this.leave();
    super.pause();
  }

  start(direction, winding) {
    if (direction < 0 || winding > 1) this.leave();
    super.start(direction, winding);
  }

  toggle() {
    if (this.following) return this.pause();
    if (!this.playing && this.place >= this.recording.last && !this.recording.over) return this.follow();
    return super.toggle();
  }

  advance(seconds) {
    if (this.following) return this.keepUp(seconds, performance.now() / 1000);
    const forward = this.playing && this.direction > 0;
    super.advance(seconds);
    // Playing on to the present follows the match from there.
    if (forward && !this.playing && this.place >= this.recording.last && !this.recording.over) this.follow();
    return undefined;
  }

  /** Stay a little behind what has come, at its pace, so that pictures follow each other evenly. */
  keepUp(seconds, now) {
    const { last } = this.recording;
    const pulse = this.pulse(now);
    const next = this.place + pulse * seconds;
    const late = last - pulse * this.cushion - next;
    if (late > pulse * 1.5 + 60) {
      this.jumped = true;
      this.place = last - pulse * this.cushion;
    } else {
      const share = 1 - Math.exp(-seconds * (pulse ? 3 : 12));
      this.place = Maths.clamp(next + late * share, this.place, last);
      if (!pulse && last - this.place < 0.6) this.place = last;
    }
    if (this.recording.over && this.place >= last) {
      this.following = false;
      super.pause();
    }
  }
}

/** Holds the page together while the match is played. */
class LiveClient {
  /** openFeed(take, lost): returns the feed; lost is called with a text while nothing comes. */
  constructor(facts, begun, openFeed = (take, lost) => new LiveFeed(facts.match, take, lost)) {
    this.recording = new LiveRecording(facts);
    this.begun = begun;
    this.app = null;
    this.marked = 0;
    this.pace = { paused: false, speed: 1 };
    this.badge = element("button", "live");
    this.badge.type = "button";
    this.badge.id = "live";
    this.badge.addEventListener("click", () => { this.app?.player.follow(); this.app?.changed(); });
    document.querySelector(".time").prepend(this.badge);
    this.notice = document.getElementById("problem");
    this.feed = openFeed(this, (text) => this.tell(text));
    this.matchControls = facts.match ? MatchControls.fromAddress() : null;
    this.tell("The match is about to begin…");
  }

  // --- what the feed brings --------------------------------------------------------------------------------------------

  poses(half, tick, rows) {
    this.recording.poses(half, tick, rows);
    this.grew = true;
  }

  sensed(half, robot, rows, bytes) {
    this.recording.senses.rows(half, robot, rows, bytes);
  }

  said(message) {
    if (message.say === "half") this.recording.half(message.facts);
    if (message.say === "sensors") this.sensors(message);
    if (message.say === "printed") this.recording.lines(message.half, message.lines);
    if (message.say === "news") this.added = (this.added || []).concat(this.recording.news(message));
    if (message.say === "pace") this.pace = message;
    if (message.say === "over") this.finish(message);
  }

  /** All that has come so far is taken in: show it. */
  settled() {
    if (!this.app && this.recording.begun) this.open();
    const { app } = this;
    if (app) {
      const now = performance.now() / 1000;
      if (this.grew) app.player.arrived(now);
      if (this.added?.length) app.events.grown(this.added);
      this.added = [];
      if (this.recording.over) app.events.finished();
      if (this.grew && (now - this.marked > MARKS_EVERY_S || this.recording.over)) {
        this.marked = now;
        app.transport.grown();
      }
      this.grew = false;
      app.changed();
    }
    this.showBadge();
    this.matchControls?.show(this.pace, this.recording.over);
  }

  sensors({ half, facts }) {
    this.recording.sensors(half, facts);
    this.app?.sensors.known();
  }

  open() {
    const player = new LivePlayer(this.recording);
    player.place = this.recording.last;
    this.tell(null);
    this.added = [];
    this.app = new App(this.recording, player);
    this.app.afterDraw = () => this.showBadge();
    this.begun(this.app);
  }

  finish({ about, places, complete, replay }) {
    const { recording } = this;
    recording.over = true;
    Object.assign(recording.facts, { places, complete });
    recording.measure();
    if (about.length) recording.facts.about = about;
    document.getElementById("about").replaceChildren();
    this.app?.panels.about();
    this.grew = true;
    if (replay) this.offerReplay();
  }

  /** The finished page, to keep: one file that needs no server. */
  offerReplay() {
    const link = element("a", "keep", "Save the replay");
    link.href = "replay.html";
    link.download = "replay.html";
    document.getElementById("about").after(link);
  }

  // --- what is said of it ----------------------------------------------------------------------------------------------

  tell(text) {
    if (!this.app && text === null && !this.recording.begun) return;
    const said = text ?? this.recording.facts.problem;
    if (this.notice.textContent !== said) this.notice.textContent = said;
    this.notice.hidden = !said;
  }

  showBadge() {
    const { over } = this.recording;
    const following = Boolean(this.app?.player.following) && !over;
    const speed = this.pace.speed === null ? "full speed" : `${this.pace.speed} ×`;
    const more = this.pace.paused ? " · paused" : this.pace.speed === 1 ? "" : ` · ${speed}`;
    const text = over ? "Over" : `Live${more}`;
    if (this.badge.textContent !== text) this.badge.textContent = text;
    const pressed = String(following);
    if (this.badge.getAttribute("aria-pressed") === pressed && this.badge.disabled === over) return;
    this.badge.setAttribute("aria-pressed", pressed);
    this.badge.title = over ? "The match is over: all of it can be seen" : following ? "What you see is happening now" : "Go to where the match is now";
    this.badge.disabled = over;
  }
}

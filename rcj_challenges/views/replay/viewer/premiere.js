// A recorded match, shown to everybody at the same time: a feed whose messages come from the recording when the clock
// says so. Nothing later than now is on the page, so neither the score nor the time line reveals what will happen.

const FEED_EVERY_MS = 100;
const CLOCK_OFF_MS = 2000;

class PremiereFeed {
  /**
   * data: {facts, poses} of a replay page; when: {start, halfTime}: when it begins, in ms, and the length of the breaks,
   * in s; now: the clock, in ms.
   */
  constructor(data, when, now, take, lost) {
    this.now = now;
    this.when = when;
    this.take = take;
    this.lost = lost;
    this.facts = data.facts;
    this.poses = data.poses;
    this.halves = data.facts.halves.map((facts) => ({ facts, sent: -1 }));
  }

  /** What is known before the first tick. */
  static factsBefore(facts) {
    const planned = facts.halves.map((half) => half.planned_ticks);
    while (planned.length < facts.halves_planned) planned.push(planned[planned.length - 1]);
    return { ...facts, halves: [], events: [], places: [], complete: false, about: facts.about.slice(0, 1), sensors: {}, half_ticks_planned: planned };
  }

  /** What happens in a half after a tick, up to another: parts of its lists. */
  news(half, after, until) {
    const part = (rows, tickOf) => rows.filter((row) => after < tickOf(row) && tickOf(row) <= until);
    const [first, own] = [([tick]) => tick, ({ tick }) => tick];
    const news = Object.fromEntries(["score_changes", "counted", "phases", "held"].map((list) => [list, part(half[list], first)]));
    const events = this.facts.events.filter((event) => event.half === half.half);
    const jumps = half.jumps.map((ticks) => part(ticks, (tick) => tick));
    return { say: "news", half: half.half, ...news, jumps, faults: part(half.faults, own), events: part(events, own) };
  }

  async follow() {
    for (const half of this.halves) half.track = await this.track(half.facts);
    return new Promise((done, fail) => {
      const step = () => {
        try {
          if (this.step()) return done();
        } catch (error) {
          return fail(error);
        }
        return setTimeout(step, FEED_EVERY_MS);
      };
      step();
    });
  }

  async track(facts) {
    return Embedded.half(this.facts, facts, await Embedded.inflate(this.poses[facts.half]));
  }

  /** Bring what has happened by now; returns whether that is all. */
  step() {
    const tickSeconds = this.facts.tick_s;
    let begins = 0;
    const elapsed = (this.now() - this.when.start) / 1000;
    for (const half of this.halves) {
      if (elapsed < begins) {
        this.lost(`Break: it goes on in ${Math.ceil(begins - elapsed)} s.`);
        this.take.settled();
        return false;
      }
      this.lost(null);
      this.bring(half, Math.min(half.facts.ticks, Math.floor((elapsed - begins) / tickSeconds)));
      begins += half.facts.ticks * tickSeconds;
      if (elapsed < begins) break;
      begins += this.when.halfTime;
    }
    const over = this.halves.every((half) => half.sent === half.facts.ticks);
    if (over) this.take.said({ say: "over", about: this.facts.about, places: this.facts.places, complete: this.facts.complete, replay: false });
    this.take.settled();
    return over;
  }

  /** Bring a half up to a tick. */
  bring(half, until) {
    if (half.sent < 0) this.take.said({ say: "half", facts: PremiereFeed.begun(half.facts) });
    if (until <= half.sent) return;
    this.take.poses(half.facts.half, half.sent + 1, this.rows(half.track, half.sent + 1, until));
    this.take.said(this.news(half.facts, half.sent, until));
    half.sent = until;
  }

  static begun(facts) {
    return { ...facts, ticks: 0, score_changes: [], counted: [], phases: [], held: [], jumps: [], faults: [] };
  }

  /** Poses as a live match sends them: [tick][channel][entity]. */
  rows(track, first, last) {
    const rows = [];
    for (let tick = first; tick <= last; tick++) {
      for (const { name } of this.facts.channels) for (const column of track.channels[name]) rows.push(column[tick]);
    }
    return rows;
  }
}

/** The clock of the web server, if that of this computer is wrong by more than the answer can tell. */
async function clockOffset() {
  if (!location.protocol.startsWith("http")) return 0;
  try {
    const before = Date.now();
    const answer = await fetch(location.pathname, { method: "HEAD", cache: "no-store" });
    const offset = Date.parse(answer.headers.get("Date")) + 500 - (before + Date.now()) / 2;
    return Math.abs(offset) > CLOCK_OFF_MS ? offset : 0;
  } catch {
    return 0;
  }
}

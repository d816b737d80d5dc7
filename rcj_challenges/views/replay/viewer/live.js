// Reading the feed of a match that is being played (views/live/feed.py): messages in one long answer, which goes on for
// as long as the match does. After a lost connection the page asks again from the byte that it had reached.

const HEAD_BYTES = 5;
const SAID = 1, POSES = 2, SENSED = 3;
const RETRY_S = [0.3, 1, 2, 5];

class LiveFeed {
  /** take: {said(message), poses(half, tick, rows), sensed(half, robot, rows, bytes), settled()}; lost(text): nothing comes at present, or (null) it does again. */
  constructor(match, take, lost) {
    this.match = match;
    this.take = take;
    this.lost = lost;
    this.read = 0;
    this.tries = 0;
    this.over = false;
    this.reader = null;
  }

  async follow() {
    while (!this.over) {
      try {
        await this.once();
      } catch (error) {
        if (error instanceof FeedRefused) return this.lost(error.message);
        if (error instanceof FeedDamaged) throw error;
        // The connection was lost, as happens: asked for again below.
      }
      if (this.over) break;
      this.lost("The connection to the match is lost; trying again…");
      const wait = RETRY_S[Math.min(this.tries, RETRY_S.length - 1)];
      this.tries += 1;
      await new Promise((done) => setTimeout(done, wait * 1000));
    }
    return this.lost(null);
  }

  async once() {
    const answer = await fetch(`feed?match=${encodeURIComponent(this.match)}&from=${this.read}`, { cache: "no-store" });
    if (answer.status === 409) throw new FeedRefused("Another match is played here now: reload this page to watch it.");
    if (!answer.ok || !answer.body) throw new Error(`the server says ${answer.status}`);
    const reader = this.reader = answer.body.getReader();
    let rest = new Uint8Array(0);
    for (;;) {
      const { value, done } = await reader.read();
      if (done) return;
      this.tries = 0;
      this.lost(null);
      rest = this.messages(LiveFeed.joined(rest, value));
    }
  }

  /** Take all whole messages; returns what is left of the last. Empty ones only say that somebody is there. */
  messages(bytes) {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    let at = 0;
    while (bytes.length - at >= HEAD_BYTES) {
      const kind = view.getUint8(at), length = view.getUint32(at + 1, true);
      if (bytes.length - at < HEAD_BYTES + length) break;
      const body = at + HEAD_BYTES;
      if (kind === SAID) this.said(JSON.parse(new TextDecoder().decode(bytes.subarray(body, body + length))));
      else if (kind === POSES) this.take.poses(view.getUint16(body, true), view.getUint32(body + 2, true), LiveFeed.numbers(bytes, body + 6, length - 6));
      else if (kind === SENSED) this.take.sensed(view.getUint16(body, true), view.getUint16(body + 2, true), view.getUint32(body + 4, true), bytes.subarray(body + 8, body + length));
      else if (kind !== 0) throw new FeedDamaged(`a message of kind ${kind}`);
      at = body + length;
      if (kind !== 0) this.read += HEAD_BYTES + length;
    }
    this.take.settled();
    return bytes.slice(at);
  }

  said(message) {
    if (message.say === "over") this.over = true;
    this.take.said(message);
  }

  static joined(before, after) {
    if (!before.length) return after;
    const all = new Uint8Array(before.length + after.length);
    all.set(before);
    all.set(after, before.length);
    return all;
  }

  /** int16 numbers, little-endian on any machine, from any byte on. */
  static numbers(bytes, first, length) {
    const numbers = new Int16Array(length / 2);
    for (let index = 0; index < numbers.length; index++) {
      numbers[index] = (bytes[first + 2 * index] | (bytes[first + 2 * index + 1] << 8)) << 16 >> 16;
    }
    return numbers;
  }
}

class FeedRefused extends Error {}
class FeedDamaged extends Error {}

/** A half that grows. */
class LiveTrack extends HalfTrack {
  constructor(facts, units, entities, names) {
    const room = facts.planned_ticks + 1;
    const channels = Object.fromEntries(names.map((name) => [name, entities.map(() => new Int16Array(room))]));
    super({ ...facts, ticks: 0, jumps: [], faults: [] }, channels, units, entities);
    this.names = names;
    this.begun = false;
  }

  /** rows: [tick][channel][entity], the first of them at `first`. */
  append(first, rows) {
    const { names } = this, entities = this.jumps.length;
    const count = rows.length / (names.length * entities);
    this.reserve(first + count);
    let at = 0;
    for (let tick = first; tick < first + count; tick++) {
      for (const name of names) for (let entity = 0; entity < entities; entity++) this.channels[name][entity][tick] = rows[at++];
    }
    const before = this.ticks;
    this.begun = true;
    this.ticks = this.facts.ticks = first + count - 1;
    this.roll(before);
  }

  reserve(ticks) {
    if (ticks <= this.channels.x[0].length) return;
    for (const name of this.names) {
      this.channels[name] = this.channels[name].map((numbers) => {
        const more = new Int16Array(Math.max(ticks, 2 * numbers.length));
        more.set(numbers);
        return more;
      });
    }
  }
}

/** A recording that grows. */
class LiveRecording extends Recording {
  constructor(facts) {
    facts.sensors = {};
    super(facts, []);
    this.over = false;
    this.senses = new LiveSenses();
    this.printed = new Map();
  }

  get begun() {
    return this.halves.length > 0 && this.halves[0].begun;
  }

  half(facts) {
    const units = Object.fromEntries(this.facts.channels.map((channel) => [channel.name, channel.unit]));
    const track = new LiveTrack(facts, units, this.entities, this.facts.channels.map((channel) => channel.name));
    this.coming = track;
  }

  /** Of a half there will be readings. */
  sensors(half, facts) {
    this.facts.sensors[half] = facts;
    this.senses.begin(half, facts);
  }

  /** Lines that programs printed: [robot, tick, text]. */
  lines(half, lines) {
    this.printed.set(half, [...(this.printed.get(half) ?? []), ...lines]);
  }

  /** A half is shown from its first picture on. */
  poses(half, tick, rows) {
    if (this.coming && this.coming.facts.half === half) {
      this.halves.push(this.coming);
      this.coming = null;
    }
    this.halves.find((track) => track.facts.half === half).append(tick, rows);
    this.measure();
  }

  /** The time line is as long as the match is planned, so that nothing on it moves; it ends where the match did. */
  measure() {
    super.measure();
    if (this.over || !this.halves.length) return;
    const current = this.halves[this.halves.length - 1];
    const missing = Math.max(0, current.facts.planned_ticks - current.ticks);
    this.span = this.last + missing + this.facts.half_ticks_planned.slice(this.halves.length).reduce((sum, ticks) => sum + ticks + 1, 0);
  }

  /** What happened on some ticks, as the lists of the half have it; returns the events that were added. */
  news(news) {
    const track = this.halves.find((candidate) => candidate.facts.half === news.half);
    const { facts } = track;
    for (const list of ["score_changes", "counted", "phases", "held", "faults"]) facts[list].push(...(news[list] || []));
    for (const [entity, ticks] of Object.entries(news.jumps || {})) for (const tick of ticks) track.jumps[entity].add(tick);
    const added = this.placed(news.events || []);
    this.events.push(...added);
    return added;
  }
}

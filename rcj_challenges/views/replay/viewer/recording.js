// What was recorded, and where everything was at any moment. A moment is a *place*: a number of ticks counted over all
// halves, with a fraction between ticks. Half i covers the places from its `offset` to `offset + ticks`.
// This is all that the rest of the viewer knows of a match; while it is played, live.js lets the same objects grow.

const OFF_FIELD = 32767; // as x: it was taken off the field, where no picture reaches
const OFF_FIELD_M = 1000;

class HalfTrack {
  /**
   * facts: the half's part of the page's facts; channels: {x, y, yaw, z, tilt}, each one Int16Array for each entity, a
   * number for each tick from 0 on; units: what 1 is worth in each channel, in m and rad.
   */
  constructor(facts, channels, units, entities) {
    this.facts = facts;
    this.ticks = facts.ticks;
    this.offset = 0;
    this.channels = channels;
    this.units = units;
    this.jumps = entities.map((_, index) => new Set(facts.jumps[index] || []));
    this.radii = entities.map((entity) => (entity.kind === "ball" ? entity.radius_m : 0));
    this.spins = entities.map(() => null);
    this.roll(0);
  }

  /**
   * The pose at a tick, with a fraction: positions in m, angles in rad; `off`: it is not on the field.
   * Nothing glides where it was put elsewhere.
   * `out` is written to and returned; drawing passes the same object each time.
   */
  pose(entity, tick, out = { x: 0, y: 0, z: 0, yaw: 0, tilt: 0, off: false }) {
    const { channels, units } = this;
    const from = Math.floor(tick);
    const share = from >= this.ticks ? 0 : tick - from;
    const to = share === 0 || this.jumps[entity].has(from) ? from : from + 1;
    const x = channels.x[entity], y = channels.y[entity], z = channels.z[entity];
    out.off = this.off(entity, from);
    const yaws = channels.yaw[entity], tilts = channels.tilt[entity];
    out.x = out.off ? OFF_FIELD_M : (x[from] + (x[to] - x[from]) * share) * units.x;
    out.y = (y[from] + (y[to] - y[from]) * share) * units.y;
    out.z = (z[from] + (z[to] - z[from]) * share) * units.z;
    out.yaw = Maths.wrap(yaws[from] * units.yaw + Maths.wrap((yaws[to] - yaws[from]) * units.yaw) * share);
    out.tilt = (tilts[from] + (tilts[to] - tilts[from]) * share) * units.tilt;
    return out;
  }

  off(entity, tick) {
    return this.channels.x[entity][tick] === OFF_FIELD;
  }

  /** Metres per second over the ticks around this one. */
  speed(entity, tick, tickSeconds) {
    const to = Maths.clamp(Math.round(tick), 1, Math.max(1, this.ticks));
    const from = this.jumps[entity].has(to - 1) ? to : to - 1;
    if (from === to || to > this.ticks) return 0;
    const dx = (this.channels.x[entity][to] - this.channels.x[entity][from]) * this.units.x;
    const dy = (this.channels.y[entity][to] - this.channels.y[entity][from]) * this.units.y;
    return Math.hypot(dx, dy) / tickSeconds;
  }

  /** How the ball lies at a tick: it is not recorded, so it is what rolling without slipping makes of its path. */
  spin(entity, tick, out = [0, 0, 0, 1]) {
    const all = this.spins[entity];
    const first = 4 * Math.round(tick);
    for (let part = 0; part < 4; part++) out[part] = all[first + part];
    return out;
  }

  /** Work out how balls lie after tick `after`, up to the last there is. */
  roll(after) {
    this.radii.forEach((radius, entity) => {
      if (!radius) return;
      const room = 4 * this.channels.x[entity].length;
      if (!this.spins[entity] || this.spins[entity].length < room) {
        const spins = new Float32Array(room);
        spins.set(this.spins[entity] || [0, 0, 0, 1]);
        this.spins[entity] = spins;
      }
      this.rolled(entity, radius, after);
    });
  }

  rolled(entity, radius, after) {
    const x = this.channels.x[entity], y = this.channels.y[entity], spins = this.spins[entity];
    let q = [...spins.subarray(4 * after, 4 * after + 4)];
    for (let tick = after + 1; tick <= this.ticks; tick++) {
      const dx = (x[tick] - x[tick - 1]) * this.units.x, dy = (y[tick] - y[tick - 1]) * this.units.y;
      const length = Math.hypot(dx, dy);
      if (length > 0 && !this.jumps[entity].has(tick - 1)) {
        const half = length / radius / 2, s = Math.sin(half) / length, c = Math.cos(half);
        const i = -dy * s, j = dx * s;
        const [qi, qj, qk, qw] = q;
        q = [c * qi + i * qw + j * qk, c * qj + j * qw - i * qk, c * qk + i * qj - j * qi, c * qw - i * qi - j * qj];
        const scale = 1 / Math.hypot(q[0], q[1], q[2], q[3]);
        q = q.map((part) => part * scale);
      }
      spins.set(q, 4 * tick);
    }
  }
}

class Recording {
  constructor(facts, halves) {
    this.facts = facts;
    this.entities = facts.entities;
    this.halves = halves;
    this.tickSeconds = facts.tick_s;
    this.senses = null;
    this.measure();
    this.events = this.placed(facts.events);
  }

  /** Count the places: how far the match is recorded, and how long the time line is. */
  measure() {
    let offset = 0;
    for (const half of this.halves) {
      half.offset = offset;
      offset += half.ticks + 1;
    }
    this.last = Math.max(0, offset - 1);
    this.span = this.last;
  }

  /** Whether a place is the end of a match that was played to its end. */
  isOver(place) {
    return Boolean(this.facts.complete) && place >= this.last - 0.5;
  }

  placed(events) {
    return events
      .map((event) => ({ ...event, place: this.placeOf(event.half, event.tick) }))
      .filter((event) => event.place !== null);
  }

  /** What a half is called; pages of older versions do not say it. */
  get period() {
    return this.facts.period ?? "half";
  }

  /** The place of a tick of a half (1-based), or null if that was not recorded. */
  placeOf(half, tick) {
    const track = this.halves.find((candidate) => candidate.facts.half === half);
    return track ? track.offset + Maths.clamp(tick, 0, track.ticks) : null;
  }

  /** {track, tick} of a place: which half, and which tick of it. */
  at(place) {
    const track = this.trackAt(place);
    return { track, tick: Maths.clamp(place - track.offset, 0, track.ticks) };
  }

  trackAt(place) {
    const { halves } = this;
    let index = halves.length - 1;
    while (index > 0 && halves[index].offset > place) index -= 1;
    return halves[index];
  }

  /** Let robots look as in a half: teams that change sides take theirs along. Returns a key of how they look. */
  dress({ half, bodies = {} }) {
    const key = Object.keys(bodies).length ? half : 0;
    if (key !== this.dressed) for (const [index, body] of Object.entries(bodies)) Object.assign(this.entities[index], body);
    return (this.dressed = key);
  }

  pose(entity, place) {
    const { track, tick } = this.at(place);
    return track.pose(entity, tick);
  }

  /** How many events are at or before a place: they are in order. */
  eventsUntil(place) {
    let low = 0, high = this.events.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.events[middle].place <= place) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  /** The events after one place, up to and with another. */
  eventsBetween(after, until) {
    return this.events.slice(this.eventsUntil(after), this.eventsUntil(until));
  }

  /** Points by team at a place. */
  scores(place) {
    const { track, tick } = this.at(place);
    let scores = track.facts.scores;
    for (const [at, standing] of track.facts.score_changes) if (at <= tick) scores = standing;
    return scores;
  }

  /** What a team is called. */
  title(team) {
    return this.facts.teams.find(({ name }) => name === team)?.title ?? "";
  }

  /** The seat from which a team plays the half at a place, or undefined. */
  seat(team, place) {
    const { sides } = this.at(place).track.facts;
    return this.facts.seats.find(({ name }) => sides[name] === team);
  }

  /** By team what the counters that decide the ranking count for it at a place. */
  counted(place) {
    const { track, tick } = this.at(place);
    let counted = {};
    for (const [at, values] of track.facts.counted) if (at <= tick) counted = values;
    return counted;
  }

  /** {name, waiting, held, stopped} of the referee's phase at a place: whether it holds all robots, stops the clock. */
  phase(place) {
    const { track, tick } = this.at(place);
    let phase = { name: "", waiting: false };
    for (const [at, name, waiting] of track.facts.phases) if (at <= tick) phase = { name, waiting };
    return { ...phase, held: this.facts.held_phases.includes(phase.name), stopped: this.stops(phase.name) };
  }

  stops(phase) { return (this.facts.stopped_phases || []).includes(phase); }

  /** For how many seconds of the half phases have stopped its clock up to a place. */
  stoppedSeconds(place) {
    const { track, tick } = this.at(place);
    const { phases } = track.facts;
    const ticks = phases.map(([at, name], index) => {
      const until = Math.min(tick, index + 1 < phases.length ? phases[index + 1][0] : tick);
      return this.stops(name) ? Math.max(0, until - at) : 0;
    });
    return ticks.reduce((sum, one) => sum + one, 0) * this.tickSeconds;
  }

  /** The names of the robots that rules hold at a place. */
  held(place) {
    const { track, tick } = this.at(place);
    let held = [];
    for (const [at, robots] of track.facts.held) if (at <= tick) held = robots;
    return held;
  }

  /** Where an entity was in the `seconds` before a place: pieces of path, cut where it was put elsewhere. */
  trail(entity, place, seconds) {
    const { track, tick } = this.at(place);
    const first = Math.max(0, Math.ceil(tick - seconds / this.tickSeconds));
    const stride = Math.max(1, Math.floor((tick - first) / 400));
    const pieces = [[]];
    for (let at = first; at <= tick; at++) {
      const cut = at > first && track.jumps[entity].has(at - 1);
      if (cut) pieces.push([]);
      if (track.off(entity, at)) continue;
      if (cut || at === first || at % stride === 0) {
        pieces[pieces.length - 1].push([
          track.channels.x[entity][at] * track.units.x,
          track.channels.y[entity][at] * track.units.y,
        ]);
      }
    }
    const now = track.pose(entity, tick);
    if (!now.off) pieces[pieces.length - 1].push([now.x, now.y]);
    return pieces.filter((piece) => piece.length > 1);
  }

  clock(place) {
    return Recording.clockText(this.at(place).tick * this.tickSeconds);
  }

  static clockText(seconds) {
    const tenths = Math.round(seconds * 10);
    return `${Math.floor(tenths / 600)}:${String(Math.floor(tenths / 10) % 60).padStart(2, "0")}.${tenths % 10}`;
  }

  /** The address of a moment: `#h1t3560`; and back: a place, or null. */
  fragment(place) {
    const { track, tick } = this.at(place);
    return `#h${track.facts.half}t${Math.round(tick)}`;
  }

  placeOfFragment(fragment) {
    const parts = /^#h(\d+)t(\d+)$/.exec(fragment);
    return parts ? this.placeOf(Number(parts[1]), Number(parts[2])) : null;
  }
}

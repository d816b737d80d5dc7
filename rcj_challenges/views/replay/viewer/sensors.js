// What programs saw and set, if it was recorded: readings on the robots' cards, rays on the field.
// Blocks are read when they are first wanted: int32 differences, four planes of bytes for each column, lowest first.

const NO_NUMBER = -(2 ** 31), INFINITE = 2 ** 31 - 1, MINUS_INFINITE = -(2 ** 31) + 1;
const RAY_WIDTH_M = 0.003;
const SENSOR_COLOURS = { sonar: [0.45, 0.95, 1], lidar: [1, 0.55, 0.85], ball: [1, 0.6, 0.2] };

class Sensors {
  constructor(recording, find, cards, changed) {
    this.recording = recording;
    this.changed = changed;
    this.facts = recording.facts.sensors || {};
    this.blocks = new Map();
    this.rays = new Set();
    this.pictures = new Pictures(changed);
    this.cards = [];
    this.shownAt = 0;
    this.box = find("show").querySelector("input[name=rays]");
    this.none = find("no-sensors");
    this.robotCards = cards;
    this.known();
  }

  /** Robots of which there are recordings have their place; while the match is played, more may come to be known. */
  known() {
    this.box.disabled = !this.any;
    this.none.hidden = this.any;
    const recorded = new Set(Object.values(this.facts).flatMap(({ robots }) => robots.map(({ name }) => name)));
    for (const { name } of this.cards) recorded.delete(name);
    this.recording.entities.forEach((entity, index) => { if (recorded.has(entity.name)) this.addCard(entity, index, this.robotCards[index]); });
  }

  get any() {
    return Object.keys(this.facts).length > 0;
  }

  addCard(entity, index, card) {
    const item = card.numbers.parentElement;
    const button = element("button", "", "Rays");
    button.type = "button";
    button.setAttribute("aria-label", `Rays of the sensors of ${entity.name}`);
    button.setAttribute("aria-pressed", "false");
    button.addEventListener("click", () => {
      if (!this.rays.delete(index)) this.rays.add(index);
      button.setAttribute("aria-pressed", String(this.rays.has(index)));
      this.changed();
    });
    item.querySelector(".buttons").append(button);
    const box = element("div", "sensing");
    box.hidden = true;
    const readings = element("dl", "readings");
    box.append(readings);
    item.append(box);
    this.cards.push({ index, name: entity.name, box, readings, values: [], key: "" });
  }

  // --- blocks ----------------------------------------------------------------------------------------------------------

  /** What is known of a half: robots by name, or null as long as it is being read, or if there is nothing. */
  half(number) {
    const facts = this.facts[number];
    if (!facts) return null;
    if (this.recording.senses) return this.recording.senses.of(number);
    if (!this.blocks.has(number)) {
      this.blocks.set(number, null);
      this.read(number, facts).then((robots) => { this.blocks.set(number, robots); this.changed(); })
        .catch((error) => console.error(`the sensor recording of ${this.recording.period} ${number} cannot be shown: ${error.message}`));
    }
    return this.blocks.get(number);
  }

  async read(number, facts) {
    const bytes = await Embedded.inflate(document.getElementById(`sensors-${number}`).textContent);
    const robots = new Map();
    let first = 0;
    const take = (rows) => {
      const numbers = Sensors.column(bytes, first, rows);
      first += 4 * rows;
      return numbers;
    };
    for (const robot of facts.robots) {
      const ticks = take(robot.rows), columns = robot.units.map(() => take(robot.rows));
      robots.set(robot.name, { facts: robot, ticks, columns });
    }
    if (first !== bytes.length) throw new Error("it is not complete");
    return robots;
  }

  static column(bytes, first, rows) {
    const numbers = new Int32Array(rows);
    let value = 0;
    for (let row = 0; row < rows; row++) {
      const at = first + row;
      value = (value + (bytes[at] | (bytes[at + rows] << 8) | (bytes[at + 2 * rows] << 16) | (bytes[at + 3 * rows] << 24))) | 0;
      numbers[row] = value;
    }
    return numbers;
  }

  /** The last index whose number is at most `limit`, or -1; `number` says which number an entry has. */
  static last(entries, limit, number = (entry) => entry) {
    let low = 0, high = entries.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (number(entries[middle]) <= limit) low = middle + 1;
      else high = middle;
    }
    return low - 1;
  }

  /** {robot, tick, value(column), speed(column)} of the last observation of a robot at a place, or null. */
  observation(index, place) {
    const { track, tick } = this.recording.at(place);
    const robot = this.half(track.facts.half)?.get(this.recording.entities[index].name);
    if (!robot) return null;
    const row = Sensors.last(robot.ticks, Math.floor(tick + 1e-6));
    if (row < 0) return null;
    const value = (column, at = row) => {
      const number = at < 0 ? NO_NUMBER : robot.columns[column][at];
      if (number === NO_NUMBER) return NaN;
      if (number === INFINITE) return Infinity;
      return number === MINUS_INFINITE ? -Infinity : number * robot.facts.units[column];
    };
    const passed_s = (robot.ticks[row] - robot.ticks[row - 1]) * this.recording.facts.tick_s;
    const speed = (column) => (value(column) - value(column, row - 1)) / passed_s;
    return { robot, tick: robot.ticks[row], value, speed };
  }

  // --- cards -----------------------------------------------------------------------------------------------------------

  /** Show readings; while the match plays, ten times a second are enough to read. */
  show(place, playing) {
    const now = performance.now();
    if (!this.any || (playing && now - this.shownAt < 100)) return;
    this.shownAt = now;
    for (const card of this.cards) {
      const seen = this.observation(card.index, place);
      card.box.hidden = !seen;
      if (!seen) continue;
      this.showReadings(card, seen);
      const { half } = this.recording.at(place).track.facts;
      this.pictures.show(card, half, seen.robot.facts, seen.tick, this.facts[half].picture_ticks);
    }
  }

  showReadings(card, seen) {
    const rows = Sensors.readings(seen);
    const key = rows.map(([name]) => name).join("\n");
    if (key !== card.key) {
      card.key = key;
      card.values = rows.map(() => element("dd"));
      card.readings.replaceChildren(...rows.flatMap(([name], at) => [element("dt", "", name), card.values[at]]));
    }
    rows.forEach(([, text], at) => { if (card.values[at].textContent !== text) card.values[at].textContent = text; });
  }

  /** [name, text] of each device at an observation, wheels first. */
  static readings({ robot, tick, value, speed }) {
    const { devices, packets, motors, units } = robot.facts;
    const shown = (one, digits) => (Number.isNaN(one) ? "–" : one.toFixed(digits).replace("Infinity", "∞"));
    const number = (column, digits) => shown(value(column), digits);
    const firstMotor = units.length - motors.length, firstPacket = firstMotor - 4 * packets;
    const rows = [["observation", `frame ${tick}`]];
    motors.forEach(([name, unit], at) => rows.push([name, `set to ${number(firstMotor + at, 2)} ${unit}`]));
    const off = [];
    let column = 0;
    for (const device of devices) {
      const all = Array.from({ length: device.columns }, (_, part) => column + part);
      column += device.columns;
      if (Number.isNaN(value(all[0]))) off.push(device.name);
      else if (device.kind === "position_sensor") rows.push([device.name, `${number(all[0], 2)} rad, turned ${shown(speed(all[0]), 2)} rad/s`]);
      else if (device.kind === "lidar") rows.push([device.name, Sensors.lidarText(all.map(value))]);
      else rows.push([device.name, all.map((one) => number(one, device.kind === "distance_sensor" ? 1 : 3)).join("  ")]);
    }
    for (let at = firstPacket; at < firstMotor; at += 4) {
      const heard = !Number.isNaN(value(at));
      rows.push(["ball", heard ? `strength ${number(at, 1)}, direction ${[1, 2, 3].map((axis) => number(at + axis, 2)).join("  ")}` : "not heard"]);
    }
    if (off.length) rows.push(["not enabled", off.join(", ")]);
    return rows;
  }

  static lidarText(ranges) {
    const seen = ranges.filter((range) => Number.isFinite(range) && range > 0);
    return seen.length ? `${Math.min(...seen).toFixed(3)} to ${Math.max(...seen).toFixed(3)} m (${ranges.length} rays shown)` : "no ray yet";
  }

  // --- lights ----------------------------------------------------------------------------------------------------------

  /** The lights of robots that are lit: {index, at, of, colour}; the first of a robot is the leftmost. */
  lightsAt(place) {
    if (!this.any) return [];
    return this.cards.flatMap(({ index }) => {
      const seen = this.observation(index, place);
      if (!seen) return [];
      const { lights = [], motors, units } = seen.robot.facts;
      const all = lights.flatMap((colours, at) => (colours ? [{ colours, at }] : []));
      return all.flatMap(({ colours, at }, number) => {
        const colour = colours[Math.round(seen.value(units.length - motors.length + at)) - 1];
        return colour ? [{ index, at: number, of: all.length, colour: Colours.rgb(colour) }] : [];
      });
    });
  }

  // --- rays ------------------------------------------------------------------------------------------------------------

  /** Rays of the chosen robots (of all, if `all`), as lines on the floor: {pieces, colour, width}. */
  raysAt(place, all) {
    if (!this.any) return [];
    const robots = all ? this.cards.map((card) => card.index) : [...this.rays];
    return robots.flatMap((index) => {
      const seen = this.observation(index, place);
      return seen ? this.raysOf(index, seen, this.recording.pose(index, place)) : [];
    });
  }

  raysOf(index, { robot, value }, pose) {
    const { devices, packets, motors, units } = robot.facts;
    const half = this.recording.entities[index].size_m / 2;
    const at = (bearing, distance) => [pose.x + Math.cos(pose.yaw + bearing) * distance, pose.y + Math.sin(pose.yaw + bearing) * distance];
    const lines = { sonar: [], lidar: [], ball: [] };
    let column = 0;
    for (const { kind, columns, facts } of devices) {
      if (kind === "distance_sensor") {
        const reach = Math.min(value(column), facts.max_value) / 1000;
        if (reach >= 0) lines.sonar.push([at(facts.bearing_rad, half), at(facts.bearing_rad, half + reach)]);
      }
      if (kind === "lidar") {
        for (let ray = 0; ray < columns; ray++) {
          const range = value(column + ray), bearing = facts.first_bearing_rad + ray * facts.bearing_step_rad;
          if (Number.isFinite(range) && range > 0) lines.lidar.push([at(bearing, Math.max(half, range - 0.03)), at(bearing, range)]);
        }
      }
      column += columns;
    }
    for (let packet = column; packet < column + 4 * packets; packet += 4) {
      const strength = value(packet), bearing = Math.atan2(value(packet + 2), value(packet + 1));
      if (strength > 0) lines.ball.push([at(bearing, half), at(bearing, Math.max(half, 1 / Math.sqrt(strength)))]);
    }
    if (column + 4 * packets + motors.length !== units.length) return [];
    return Object.entries(lines).filter(([, pieces]) => pieces.length)
      .map(([kind, pieces]) => ({ pieces, colour: SENSOR_COLOURS[kind], width: RAY_WIDTH_M }));
  }
}

// What programs see and set while the match is played: tables that grow, one for each robot and half. They look
// like what sensors.js reads from a finished page, so cards and rays are the same.

const FIRST_ROOM = 256;

class LiveSensed {
  /** facts: which columns there are (views/replay/sensor_blocks.py); the first of the table is the tick. */
  constructor(facts) {
    this.facts = facts;
    this.rows = 0;
    this.room = FIRST_ROOM;
    this.table = Array.from({ length: 1 + facts.units.length }, () => new Int32Array(this.room));
    this.cut();
  }

  /** What there is so far: ticks as long as rows, columns at least so long. */
  cut() {
    this.ticks = this.table[0].subarray(0, this.rows);
    this.columns = this.table.slice(1);
  }

  /** Take rows: int32 numbers, little-endian, from any byte on. */
  append(count, bytes) {
    const { table } = this, view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    if (bytes.length !== 4 * count * table.length) throw new FeedDamaged("readings that are not complete");
    this.reserve(this.rows + count);
    let at = 0;
    for (let index = this.rows; index < this.rows + count; index++) {
      for (const column of this.table) {
        column[index] = view.getInt32(at, true);
        at += 4;
      }
    }
    this.rows += count;
    this.cut();
  }

  reserve(rows) {
    if (rows <= this.room) return;
    this.room = Math.max(rows, 2 * this.room);
    this.table = this.table.map((numbers) => {
      const more = new Int32Array(this.room);
      more.set(numbers);
      return more;
    });
  }
}

/** All of a match: robots by name, by half. */
class LiveSenses {
  constructor() {
    this.halves = new Map();
  }

  begin(half, facts) {
    this.halves.set(half, new Map(facts.robots.map((robot) => [robot.name, new LiveSensed(robot)])));
  }

  of(half) {
    return this.halves.get(half) ?? null;
  }

  rows(half, robot, count, bytes) {
    [...this.halves.get(half).values()][robot].append(count, bytes);
  }
}

// Where an entity was during a half: cells of five centimetres on the floor, the warmer the longer.

const HEAT_CELL_M = 0.05;
const HEAT_STEPS = 8;
const HEAT_AGAIN_TICKS = 250;

class Heat {
  constructor(recording, find, changed) {
    this.recording = recording;
    this.select = find("heat");
    this.text = find("heat-text");
    this.key = "";
    this.shapes = [];
    this.fill();
    this.select.addEventListener("change", changed);
  }

  fill() {
    const { facts, entities } = this.recording;
    this.select.append(new Option("off", ""));
    entities.forEach((entity, index) => this.select.append(new Option(entity.name, String(index))));
    for (const team of facts.teams) this.select.append(new Option(team.title.slice(0, 60), `team ${team.name}`));
  }

  /** Indices of the entities that are counted in a half. */
  chosen(track) {
    const { value } = this.select;
    if (!value.startsWith("team ")) return value === "" ? [] : [Number(value)];
    const seats = Object.entries(track.facts.sides).filter(([, team]) => team === value.slice(5)).map(([seat]) => seat);
    return this.recording.entities.flatMap((entity, index) => (entity.kind === "robot" && seats.includes(entity.seat) ? [index] : []));
  }

  /** {key, shapes} of the half at a place: shapes as in ground.js, faint ones first. */
  at(place) {
    const { track } = this.recording.at(place);
    const key = this.select.value === "" ? "" : `${this.select.value} ${track.facts.half} ${Math.floor(track.ticks / HEAT_AGAIN_TICKS)}`;
    if (key !== this.key) {
      this.key = key;
      this.shapes = key ? this.build(track) : [];
      if (!key) this.text.textContent = "";
    }
    return { key: this.key, shapes: this.shapes };
  }

  build(track) {
    const counts = new Map(), chosen = this.chosen(track);
    for (const index of chosen) {
      const x = track.channels.x[index], y = track.channels.y[index];
      for (let tick = 0; tick <= track.ticks; tick++) {
        if (track.off(index, tick)) continue;
        const cell = `${Math.floor((x[tick] * track.units.x) / HEAT_CELL_M)} ${Math.floor((y[tick] * track.units.y) / HEAT_CELL_M)}`;
        counts.set(cell, (counts.get(cell) || 0) + 1);
      }
    }
    const sorted = [...counts.values()].sort((a, b) => a - b);
    const most = sorted[sorted.length - 1] || 1, warmest = sorted[Math.floor(sorted.length * 0.98)] || 1;
    const share = (100 * most) / Math.max(1, chosen.length * (track.ticks + 1));
    this.text.textContent = `whole ${this.recording.period}; the warmest 5 cm: ${share.toFixed(1)} % of the time`;
    const cells = [...counts].map(([cell, count]) => {
      // The root, and no more than the warmest fiftieth: else one place with a long stay would make all others pale.
      return { cell: cell.split(" ").map(Number), step: Math.ceil(HEAT_STEPS * Math.sqrt(Math.min(1, count / warmest))) };
    });
    cells.sort((a, b) => a.step - b.step);
    const { field } = this.recording.facts;
    const furthest = 2 * Math.max(...Ground.floor(field));
    return cells.map(({ cell: [column, row], step }) => {
      const left = column * HEAT_CELL_M, low = row * HEAT_CELL_M, warm = step / HEAT_STEPS;
      return {
        points: Ground.rectangle(left, low, left + HEAT_CELL_M, low + HEAT_CELL_M),
        fill: Colours.mix([1, 0.86, 0.2], [0.9, 0.08, 0.1], warm),
        alpha: 0.12 + 0.68 * warm,
      };
    }).filter(({ points: [[x, y]] }) => Math.abs(x) < furthest && Math.abs(y) < furthest);
  }
}

// Names over the picture of what is shown of the scenario; in 2-D of robots too. They are text, placed by the page.

class Labels {
  constructor(recording, box) {
    this.recording = recording;
    this.box = box;
    this.shown = null;
    this.placed = [];
    this.width = this.height = 1;
  }

  resize(width, height) {
    this.width = width;
    this.height = height;
  }

  show(frame, view) {
    if (frame.show !== this.shown) {
      this.shown = frame.show;
      this.rebuild(frame.show, this.recording.facts, !view.writesNames);
    }
    const taken = [];
    for (const sign of this.placed) {
      const place = view.project(...sign.at(frame.poses));
      const seen = place && place[0] > 0 && place[0] < 1 && place[1] > 0 && place[1] < 1;
      const x = seen ? this.within(place[0] * this.width, sign) : 0, y = seen ? (place[1] - place[2] * sign.reach) * this.height : 0;
      const down = seen && sign.still ? Labels.room(sign, x, y, taken) : 0;
      if (sign.robot !== undefined) sign.label.classList.toggle("failed", frame.failed.has(sign.robot));
      const style = seen ? `translate(${x.toFixed(1)}px, ${(y + down).toFixed(1)}px) translate(-50%, ${100 * sign.lift}%)` : "";
      // Only what changed is written to the page: most of these stand still.
      if (style === sign.style) continue;
      sign.style = style;
      sign.label.style.display = seen ? "" : "none";
      sign.label.style.transform = style;
    }
  }

  /** Where the middle of a name stands so that its ends are not cut off at the picture's edge. */
  within(x, sign) {
    const half = sign.width / 2 + 1; // it is known in whole pixels
    return this.width < sign.width ? this.width / 2 : Math.min(Math.max(x, half), this.width - half);
  }

  /** How far down a name moves so that it covers none of those that are written already; only a zone's has the choice. */
  static room(sign, x, y, taken) {
    const left = x - sign.width / 2, right = x + sign.width / 2, wanted = y + sign.lift * sign.height;
    const covers = (other) => left < other.right && other.left < right && top < other.bottom && other.top < top + sign.height;
    let top = wanted;
    for (let other; sign.below && (other = taken.find(covers));) top = other.bottom + 1;
    taken.push({ left, right, top, bottom: top + sign.height });
    return top - wanted;
  }

  /** A robot's name stands just above its picture, a spot's above the spot, a zone's below its middle. */
  rebuild(show, facts, robots) {
    this.placed = [];
    if (show.names && robots) {
      facts.entities.forEach((entity, index) => {
        if (entity.kind !== "robot") return;
        const label = element("bdi", "label", entity.name);
        this.placed.push({ label, robot: index, lift: -1, reach: entity.size_m * 0.8, at: (poses) => [poses[index].x, poses[index].y, poses[index].z] });
      });
    }
    // What has its place comes first, then zones, whose names may move a little.
    const names = Ground.names(facts, show).sort((one, other) => Number(!!one.below) - Number(!!other.below));
    for (const { text, at, below, moves } of names) {
      const label = element("bdi", "label mark", text);
      this.placed.push({ label, lift: below ? 0.3 : -1.3, reach: 0, below, still: !moves, at: (poses) => [...at(poses), 0] });
    }
    this.box.replaceChildren(...this.placed.map(({ label }) => label));
    for (const sign of this.placed) [sign.width, sign.height] = [sign.label.offsetWidth, sign.label.offsetHeight];
  }
}

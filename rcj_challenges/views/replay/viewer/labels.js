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
    for (const sign of this.placed) {
      const place = view.project(...sign.at(frame.poses));
      const seen = place && place[0] > 0 && place[0] < 1 && place[1] > 0 && place[1] < 1;
      const x = seen ? place[0] * this.width : 0, y = seen ? (place[1] - place[2] * sign.reach) * this.height : 0;
      const style = seen ? `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px) translate(-50%, ${sign.lift})` : "";
      // The page is told of what changed only: most of these stand still.
      if (style === sign.style) continue;
      sign.style = style;
      sign.label.style.display = seen ? "" : "none";
      sign.label.style.transform = style;
    }
  }

  /** A robot's name stands just above its picture, a spot's above the spot, a zone's below its middle. */
  rebuild(show, facts, robots) {
    this.placed = [];
    if (show.names && robots) {
      facts.entities.forEach((entity, index) => {
        if (entity.kind !== "robot") return;
        const label = element("bdi", "label", entity.name);
        this.placed.push({ label, lift: "-100%", reach: entity.size_m * 0.8, at: (poses) => [poses[index].x, poses[index].y, poses[index].z] });
      });
    }
    for (const { text, at, below } of Ground.names(facts, show)) {
      this.placed.push({ label: element("bdi", "label mark", text), lift: below ? "30%" : "-130%", reach: 0, at: (poses) => [...at(poses), 0] });
    }
    this.box.replaceChildren(...this.placed.map(({ label }) => label));
  }
}

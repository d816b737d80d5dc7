// Names over the picture: robots, and what is shown of the scenario. They are text, placed by the page.

class Labels {
  constructor(recording, box) {
    this.recording = recording;
    this.box = box;
    this.key = "";
    this.placed = [];
    this.width = this.height = 1;
  }

  resize(width, height) {
    this.width = width;
    this.height = height;
  }

  show(frame, view) {
    const key = JSON.stringify(frame.show);
    if (key !== this.key) {
      this.key = key;
      this.rebuild(frame.show, this.recording.facts);
    }
    for (const { label, at, lift, reach } of this.placed) {
      const place = view.project(...at(frame.poses));
      const seen = place && place[0] > 0 && place[0] < 1 && place[1] > 0 && place[1] < 1;
      label.style.display = seen ? "" : "none";
      if (!seen) continue;
      const x = place[0] * this.width, y = (place[1] - place[2] * reach) * this.height;
      label.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px) translate(-50%, ${lift})`;
    }
  }

  /** A robot's name stands just above its picture, a spot's above the spot, a zone's below its middle. */
  rebuild(show, facts) {
    this.placed = [];
    if (show.names) {
      facts.entities.forEach((entity, index) => {
        if (entity.kind !== "robot") return;
        const label = element("bdi", "label", entity.name);
        this.placed.push({ label, lift: "-100%", reach: entity.size_m * 0.8, at: (poses) => [poses[index].x, poses[index].y, poses[index].z] });
      });
    }
    for (const { text, at, below } of Ground.names(facts, show)) {
      this.placed.push({ label: element("bdi", "label mark", text), lift: below ? "30%" : "-130%", reach: 0, at: () => [...at, 0] });
    }
    this.box.replaceChildren(...this.placed.map(({ label }) => label));
  }
}

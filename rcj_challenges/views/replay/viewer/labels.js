// Names over the picture: robots, and what is shown of the scenario. They are text, placed by the page.

class Labels {
  constructor(recording, box) {
    this.recording = recording;
    this.box = box;
    this.key = "";
    this.placed = [];
  }

  show(frame, view) {
    const { facts } = this.recording;
    const key = JSON.stringify(frame.show);
    if (key !== this.key) {
      this.key = key;
      this.rebuild(frame.show, facts);
    }
    const width = this.box.clientWidth, height = this.box.clientHeight;
    for (const { label, at, lift } of this.placed) {
      const [x, y, z] = at(frame.poses);
      const place = view.project(x, y, z);
      const seen = place && place[0] > 0 && place[0] < 1 && place[1] > 0 && place[1] < 1;
      label.style.display = seen ? "" : "none";
      if (seen) label.style.transform = `translate(${(place[0] * width).toFixed(1)}px, ${(place[1] * height).toFixed(1)}px) translate(-50%, ${lift})`;
    }
  }

  rebuild(show, facts) {
    this.placed = [];
    if (show.names) {
      facts.entities.forEach((entity, index) => {
        if (entity.kind !== "robot") return;
        const label = element("bdi", "label", entity.name);
        this.placed.push({ label, lift: "-115%", at: (poses) => [poses[index].x, poses[index].y, poses[index].z + entity.size_m * 0.55] });
      });
    }
    for (const { text, at } of Ground.names(facts, show)) {
      this.placed.push({ label: element("bdi", "label mark", text), lift: "-50%", at: () => [...at, 0] });
    }
    this.box.replaceChildren(...this.placed.map(({ label }) => label));
  }
}

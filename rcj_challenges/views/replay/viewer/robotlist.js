// One card for each robot: who it is, what it does now, its trail, and whether its program still runs.

const TRAIL_WIDTH_M = 0.006;

/** A number in a box as wide as the widest of its kind, so that nothing beside it moves while the match plays. */
function steady(value, decimals, digits) {
  const box = element("span", "steady", value.toFixed(decimals).replace("-", "−"));
  box.style.minWidth = `${digits}ch`;
  return box;
}

class RobotList {
  constructor(recording, find, changed, follow) {
    this.recording = recording;
    this.trails = new Set();
    this.cards = [];
    const list = find("robots");
    recording.entities.forEach((entity, index) => {
      const card = element("li", "robot");
      const chip = element("i", "chip", entity.kind === "robot" ? String(entity.number) : "");
      chip.style.background = entity.colour;
      chip.style.color = Colours.onTop(Colours.rgb(entity.colour));
      const name = element("strong", "", entity.name), team = element("bdi", "of", "");
      const numbers = element("output", "numbers"), fault = element("p", "fault");
      const trail = this.button("Trail", `Trail of ${entity.name}`, () => this.toggle(index, trail, changed));
      const buttons = element("span", "buttons");
      buttons.append(trail);
      if (entity.kind === "robot") {
        buttons.append(this.button("Camera", `Camera behind ${entity.name}`, () => follow(index)));
      }
      const head = element("span", "head");
      head.append(chip, name, team);
      card.append(head, buttons, numbers, fault);
      list.append(card);
      this.cards.push({ entity, team, numbers, fault, trail });
    });
  }

  button(text, label, act) {
    const button = element("button", "", text);
    button.type = "button";
    button.setAttribute("aria-label", label);
    button.addEventListener("click", act);
    return button;
  }

  toggle(index, button, changed) {
    if (!this.trails.delete(index)) this.trails.add(index);
    button.setAttribute("aria-pressed", String(this.trails.has(index)));
    changed();
  }

  /** Robots whose program has failed before a place. */
  failed(place) {
    const { track, tick } = this.recording.at(place);
    const gone = new Map();
    this.recording.entities.forEach((entity, index) => {
      const fault = track.facts.faults.find((candidate) => candidate.robot === entity.name && candidate.tick <= tick);
      if (fault) gone.set(index, fault);
    });
    return gone;
  }

  show(place, failed) {
    const { recording } = this;
    const { track, tick } = recording.at(place);
    const all = recording.phase(place).held, held = recording.held(place);
    this.cards.forEach((card, index) => {
      const { entity } = card;
      const pose = recording.pose(index, place);
      const degrees = Math.round((pose.yaw * 180) / Math.PI);
      const speed = track.speed(index, tick, recording.tickSeconds);
      const looks = entity.kind === "robot" ? ["   facing ", steady(degrees, 0, 4.5), "°"] : [];
      const stands = entity.kind === "robot" && (all || held.includes(entity.name)) ? "   held" : "";
      const numbers = ["x ", steady(pose.x, 3, 6), "   y ", steady(pose.y, 3, 6), " m", ...looks, `   ${speed.toFixed(2)} m/s${stands}`];
      card.numbers.replaceChildren(...(pose.off ? ["off the field"] : numbers));
      const team = recording.facts.teams.find((candidate) => candidate.name === track.facts.sides[entity.seat]);
      card.team.textContent = team ? team.title : entity.idle ? "no program" : "";
      const fault = failed.get(index);
      card.fault.hidden = !fault;
      if (fault) card.fault.textContent = `Failed at ${Recording.clockText(fault.tick * recording.tickSeconds)} (${fault.kind.replaceAll("_", " ")}): ${fault.detail}`;
    });
  }

  trailsAt(place, seconds) {
    return [...this.trails].map((index) => ({
      pieces: this.recording.trail(index, place, seconds),
      colour: Colours.mix(Colours.rgb(this.recording.entities[index].colour), [1, 1, 1], 0.35),
      width: TRAIL_WIDTH_M,
    }));
  }
}

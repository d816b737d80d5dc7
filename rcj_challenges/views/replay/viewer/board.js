// Scoreboard: teams, score, clock, phase.

class Board {
  constructor(recording, find) {
    this.recording = recording;
    this.teams = find("teams");
    this.clockText = find("clock");
    this.half = find("half");
    this.phase = find("phase");
    this.shown = "";
    this.rows = recording.facts.teams.map((team) => {
      const row = element("div", "team");
      const name = element("bdi", "name", team.title);
      name.title = team.title.slice(0, 200);
      const score = element("output", "score"), counted = element("output", "counted");
      score.setAttribute("aria-label", "Points");
      score.hidden = !recording.facts.score_counts;
      counted.setAttribute("aria-label", "What counts in the ranking");
      counted.hidden = !recording.facts.counted.length;
      row.append(element("i", "chip"), name, score, counted);
      this.teams.append(row);
      return { team, row, chip: row.firstChild, score, counted };
    });
    this.teams.classList.toggle("pair", this.rows.length === 2);
  }

  /** Beside the clock there is room for some names only. */
  static heldText(robots) {
    if (!robots.length) return "";
    return `${robots.length > 3 ? `${robots.length} robots` : robots.join(", ")} held`;
  }

  /** `best 10.48 s`, one for each counter that decides the ranking. */
  tell(box, values) {
    box.replaceChildren(...values.map((value, index) => {
      const { name, unit } = this.recording.facts.counted[index];
      const one = element("span", "", `${name} `);
      one.append(element("b", "", String(value ?? "none")), unit && value !== null ? ` ${unit}` : "");
      return one;
    }));
  }

  show(place) {
    const { recording } = this;
    const { track } = recording.at(place);
    const clock = recording.clock(place);
    if (clock !== this.clock) this.clockText.textContent = this.clock = clock;
    const phase = recording.phase(place);
    const scores = recording.scores(place);
    const counted = recording.counted(place);
    const held = phase.held ? "robots held" : Board.heldText(recording.held(place));
    const stopped = Math.floor(recording.stoppedSeconds(place) + 1e-9);
    const key = JSON.stringify([track.facts.half, phase, held, scores, counted, stopped, recording.isOver(place)]);
    if (key === this.shown) return;
    this.shown = key;
    const length = Recording.clockText(track.facts.planned_ticks * recording.tickSeconds).replace(/\.0$/, "");
    this.half.textContent = recording.facts.halves_planned > 1 ? `${recording.period} ${track.facts.half} of ${recording.facts.halves_planned} · ${length}` : `of ${length}`;
    if (stopped) this.half.append(" ", element("span", "stopped", `+ ${Recording.clockText(stopped).replace(/\.0$/, "")} stopped`));
    const name = phase.name === "play" ? "" : phase.name.replaceAll("_", " ");
    const special = [name, held, phase.stopped ? "clock stopped" : ""].filter(Boolean).join(" · ");
    this.phase.textContent = this.phase.title = special || (recording.isOver(place) ? "finished" : "in play");
    this.phase.classList.toggle("plain", !special);
    for (const { team, chip, score, counted: box } of this.rows) {
      if (!box.hidden) this.tell(box, counted[team.name] || []);
      const seat = recording.seat(team.name, place);
      chip.style.background = seat ? seat.colour : "";
      chip.style.color = seat ? Colours.onTop(Colours.rgb(seat.colour)) : "";
      chip.textContent = seat ? seat.letter : "";
      chip.title = seat ? `plays ${seat.name}` : "";
      score.textContent = String(scores[team.name] ?? 0);
    }
  }
}

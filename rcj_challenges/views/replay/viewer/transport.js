// Time line and keys under the picture.

const PLAY_ICON = "M7 4v16l13-8z";
const RESTART_ICON = "M12 5V1L6 6l6 5V7a6 6 0 1 1-6 6H4a8 8 0 1 0 8-8z";
const PAUSE_ICON = "M6 4h4v16H6zM14 4h4v16h-4z";
const KNOB_PX = 8; // half of it: so far from both ends of the time line the first and the last place are

class Transport {
  constructor(recording, player, find, changed, toEvent) {
    this.recording = recording;
    this.player = player;
    this.find = find;
    this.seek = find("seek");
    this.marks = find("marks");
    this.hover = find("hover");
    this.frame = find("frame");
    this.speed = find("speed");
    this.winding = find("winding");
    this.knob = -1;
    this.shown = "";
    this.seek.max = String(recording.span);
    const act = (id, action) => find(id).addEventListener("click", () => { action(); changed(); });
    act("play", () => player.toggle());
    act("rewind", () => player.wind(-1));
    act("forward", () => player.wind(1));
    act("back", () => player.frames(-1));
    act("step", () => player.frames(1));
    act("previous", () => toEvent(-1));
    act("next", () => toEvent(1));
    for (const speed of SPEEDS) this.speed.append(new Option(`${speed} ×`, String(speed)));
    this.speed.addEventListener("change", () => { player.speed = Number(this.speed.value); this.speed.blur(); changed(); });
    this.seek.addEventListener("input", () => { player.seek(Number(this.seek.value)); changed(); });
    this.seek.addEventListener("pointermove", (event) => this.tell(event));
    this.seek.addEventListener("pointerleave", () => { this.hover.hidden = true; });
    // The arrow keys move by seconds and frames, as everywhere on the page: app.js handles them.
    this.seek.addEventListener("keydown", (event) => { if (event.key.startsWith("Arrow")) event.preventDefault(); });
  }

  /** The match went on: the time line may be longer, and has more marks. */
  grown() {
    this.seek.max = String(this.recording.span);
    this.knob = -1;
    this.drawMarks();
  }

  /** Time and event under the pointer. */
  tell(event) {
    const box = this.seek.getBoundingClientRect();
    const across = event.clientX - box.left, length = box.width - 2 * KNOB_PX;
    const share = Maths.clamp((across - KNOB_PX) / length, 0, 1);
    const place = Math.min(this.recording.last, Math.round(share * this.recording.span));
    const reach = (6 / length) * this.recording.span;
    const near = this.recording.events.filter((candidate) => Math.abs(candidate.place - place) <= reach);
    const best = near.find((candidate) => candidate.scored) || near[0];
    this.hover.textContent = best ? [this.recording.clock(best.place), eventName(best), this.recording.title(best.team), best.standing].filter(Boolean).join("  ") : this.recording.clock(place);
    this.hover.hidden = false;
    this.hover.style.left = `${Maths.clamp((100 * across) / box.width, 4, 96)}%`;
  }

  /** Draw a mark for each event: points tall in the colour of whose they are, a ring for points that are lost, faults red, the rest small. */
  drawMarks() {
    const { marks, recording } = this;
    const density = window.devicePixelRatio || 1;
    const width = marks.clientWidth, height = marks.clientHeight;
    if (!width || !height) return;
    marks.width = Math.round(width * density);
    marks.height = Math.round(height * density);
    const pen = marks.getContext("2d");
    pen.scale(density, density);
    const styles = getComputedStyle(marks);
    const at = (place) => KNOB_PX + ((width - 2 * KNOB_PX) * place) / Math.max(1, recording.span);
    if (recording.last < recording.span) {
      pen.fillStyle = styles.getPropertyValue("--quiet");
      pen.fillRect(at(0), height - 2, at(recording.last) - at(0), 2);
    }
    pen.fillStyle = styles.getPropertyValue("--quiet");
    for (const half of recording.halves.slice(1)) pen.fillRect(at(half.offset) - 1, 0, 2, height);
    pen.fillStyle = styles.getPropertyValue("--soft");
    for (const event of recording.events) if (event.kind === "call") pen.fillRect(at(event.place) - 1, height - 8, 2, 8);
    for (const event of recording.events) {
      if (event.kind === "fault") {
        pen.fillStyle = styles.getPropertyValue("--fault");
        pen.fillRect(at(event.place) - 1, height - 12, 2, 12);
      }
      if (event.kind === "goal" || event.kind === "loss") {
        const x = at(event.place), lost = event.kind === "loss";
        // In the colour that the team has on the scoreboard now: sides change at half-time.
        const seat = recording.seat(event.team, this.player.place);
        pen.fillStyle = seat?.colour || styles.getPropertyValue("--accent");
        pen.strokeStyle = lost ? pen.fillStyle : styles.getPropertyValue("--text");
        pen.lineWidth = lost ? 2 : 1;
        pen.beginPath();
        pen.arc(x, 6, lost ? 3.5 : 4.5, 0, 2 * Math.PI);
        if (!lost) pen.fill();
        pen.stroke();
        pen.fillRect(x - 1, 11, 2, height - 11);
      }
    }
  }

  show(place) {
    const { recording, player } = this;
    const { track, tick } = recording.at(place);
    const text = `frame ${Math.round(tick)}`;
    if (this.frame.textContent !== text) this.frame.textContent = text;
    if (track !== this.track) {
      this.track = track;
      this.drawMarks();
    }
    // While the match plays, the knob moves by less than a pixel a frame: redrawing it each time would be for nothing.
    const step = player.playing ? recording.span / 2000 : 0;
    if (Math.abs(place - this.knob) <= step && step > 0) return this.showKeys(player);
    this.knob = place;
    this.seek.value = String(Math.round(place));
    this.seek.setAttribute("aria-valuetext", `${recording.period} ${track.facts.half}, ${recording.clock(place)}`);
    this.seek.style.setProperty("--done", `${(100 * place) / Math.max(1, recording.span)}%`);
    this.showKeys(player);
  }

  showKeys(player) {
    const again = !player.playing && this.recording.isOver(player.place);
    const key = `${player.playing} ${player.direction} ${player.winding} ${player.speed} ${again}`;
    if (key === this.shown) return;
    this.shown = key;
    const plain = player.playing && player.direction > 0 && player.winding === 1;
    const play = this.find("play");
    play.querySelector("path").setAttribute("d", plain ? PAUSE_ICON : again ? RESTART_ICON : PLAY_ICON);
    play.setAttribute("aria-label", plain ? "Pause" : again ? "Play again" : "Play");
    this.find("rewind").setAttribute("aria-pressed", String(player.playing && player.direction < 0));
    this.find("forward").setAttribute("aria-pressed", String(player.playing && player.direction > 0 && player.winding > 1));
    if (this.speed.value !== String(player.speed)) this.speed.value = String(player.speed);
    this.winding.hidden = !player.playing || plain;
    this.winding.textContent = `${player.direction < 0 ? "◀◀" : "▶▶"} ${player.speed * player.winding} ×`;
  }
}

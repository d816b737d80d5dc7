// What programs print, of all robots in the order of time, up to the moment that is shown; crashes stand among it.

const MOST_PRINTED = 200;
const LONGEST_PRINTED = 20000;

class Output {
  /** go(place): called when the time of a line is chosen. */
  constructor(recording, find, changed, go) {
    this.recording = recording;
    this.changed = changed;
    this.go = go;
    this.list = find("printed");
    this.none = find("no-output");
    this.whose = find("printed-by");
    this.blocks = new Map();
    this.shown = "";
    for (const { kind, name } of recording.entities) if (kind === "robot") this.whose.append(new Option(name, name));
    this.whose.addEventListener("change", changed);
  }

  /** `[robot, tick, text]` of a half in the order of ticks; null: it is still being read, or was not recorded. */
  of(half) {
    if (this.recording.printed) return this.recording.printed.get(half) ?? null;
    const block = document.getElementById(`output-${half}`);
    if (!block || this.blocks.has(half)) return this.blocks.get(half) ?? null;
    this.blocks.set(half, null);
    Embedded.inflate(block.textContent).then((bytes) => {
      this.blocks.set(half, JSON.parse(new TextDecoder().decode(bytes)).sort(([, one], [, other]) => one - other));
      this.changed();
    }).catch((error) => console.error(`the output of ${this.recording.period} ${half} cannot be shown: ${error.message}`));
    return null;
  }

  show(place) {
    const { track, tick } = this.recording.at(place), now = Math.floor(tick + 1e-6), { value: whose } = this.whose;
    const printed = this.of(track.facts.half);
    const faults = track.facts.faults.map(({ robot, tick: at, kind, detail }) => [robot, at, `${kind}: ${detail}`, true]);
    const until = [...(printed || []), ...faults].filter(([robot, at]) => at <= now && (!whose || robot === whose));
    const key = `${track.facts.half} ${whose} ${until.length} ${printed === null}`;
    if (key === this.shown) return;
    this.shown = key;
    until.sort(([, one], [, other]) => one - other);
    this.list.replaceChildren(...until.slice(-MOST_PRINTED).map((line) => this.line(track.facts.half, line)));
    this.list.scrollTop = this.list.scrollHeight;
    this.list.hidden = !until.length;
    this.none.hidden = until.length > 0;
    this.none.textContent = printed === null ? "What programs printed was not recorded." : "Nothing has been printed so far.";
  }

  line(half, [robot, tick, text, failed]) {
    const entity = this.recording.entities.find(({ name }) => name === robot), colour = entity?.colour ?? "grey";
    const line = element("li", failed ? "line fault" : "line"), place = this.recording.placeOf(half, tick);
    const time = element("a", "when", this.recording.clock(place)), chip = element("i", "chip", robot);
    time.href = this.recording.fragment(place);
    time.addEventListener("click", (click) => { click.preventDefault(); this.go(place); });
    chip.style.background = colour;
    chip.style.color = Colours.onTop(Colours.rgb(colour));
    line.append(time, chip, element("bdi", "", text.length > LONGEST_PRINTED ? `${text.slice(0, LONGEST_PRINTED)}…` : text.replace(/\n$/, "")));
    return line;
  }
}

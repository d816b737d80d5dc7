// The list of events: filters, links to moments, and what the referee measured.

const MOST_ROWS = 1500;

/** `LACK OF PROGRESS`: the name of an event as people read it. */
const eventName = ({ title, name }) => title ?? name.replaceAll("_", " ");
const LEAD_IN_S = 3;

class EventList {
  /** go(place, playing): called when a moment is chosen. */
  constructor(recording, find, go) {
    this.recording = recording;
    this.go = go;
    this.list = find("events");
    this.empty = find("no-events");
    this.filters = find("filters");
    this.kind = null;
    this.rows = [];
    this.current = null;
    this.opened = null;
    this.buildFilters();
    this.build();
    // Nothing scrolls in a list that is not shown, nor on a phone that stands upright: so when that is over.
    new ResizeObserver(() => this.follow()).observe(this.list);
  }

  /** The heading of a half: `Round 2`. */
  divider(half) {
    const { period } = this.recording;
    return element("li", "divider", `${period[0].toUpperCase()}${period.slice(1)} ${half}`);
  }

  /** Events were added while the match is played: rows are appended, counts brought up to date. */
  grown(added) {
    this.buildFilters();
    const chosen = added.filter((event) => this.kind === null || eventName(event) === this.kind);
    const room = Math.max(0, MOST_ROWS - this.rows.length);
    for (const event of chosen.slice(0, room)) {
      const row = this.row(event);
      const before = this.rows[this.rows.length - 1];
      if (before ? before.event.half !== event.half : event.half > 1) this.list.append(this.divider(event.half));
      this.rows.push(row);
      this.list.append(row.item);
    }
    this.empty.hidden = this.rows.length > 0;
  }

  buildFilters() {
    this.filters.replaceChildren();
    const counts = new Map();
    for (const event of this.recording.events) counts.set(eventName(event), (counts.get(eventName(event)) || 0) + 1);
    const named = (events) => new Set(events.map(eventName));
    const scoring = named(this.recording.events.filter((event) => event.scored));
    const failing = named(this.recording.events.filter((event) => event.kind === "fault"));
    const rank = (name) => (scoring.has(name) ? 0 : failing.has(name) ? 1 : 2);
    const names = [...counts.keys()].sort((a, b) => rank(a) - rank(b) || counts.get(b) - counts.get(a));
    const add = (kind, text, count) => {
      const button = element("button", "filter", text);
      button.type = "button";
      button.dataset.kind = kind ?? "";
      button.append(element("span", "count", String(count)));
      button.setAttribute("aria-pressed", String(kind === this.kind));
      button.addEventListener("click", () => this.filter(kind));
      this.filters.append(button);
    };
    add(null, "All", this.recording.events.length);
    for (const name of names) add(name, name, counts.get(name));
  }

  filter(kind) {
    this.kind = kind;
    for (const button of this.filters.children) button.setAttribute("aria-pressed", String(button.dataset.kind === (kind ?? "")));
    this.opened = this.current = this.colouredFor = null;
    this.build();
  }

  get shown() {
    return this.recording.events.filter((event) => this.kind === null || eventName(event) === this.kind);
  }

  build() {
    const events = this.shown;
    this.rows = events.slice(0, MOST_ROWS).map((event) => this.row(event));
    const items = [];
    let half = 0;
    for (const { event, item } of this.rows) {
      if (event.half !== half && this.recording.halves.length > 1) items.push(this.divider(event.half));
      half = event.half;
      items.push(item);
    }
    items.push(...this.places());
    if (events.length > MOST_ROWS) items.push(element("li", "divider", `${events.length - MOST_ROWS} more: choose a kind above`));
    this.list.replaceChildren(...items);
    this.list.scrollTop = 0;
    this.empty.hidden = events.length > 0;
  }

  /** The ranking, if more than the score decides it: below the last event, with a link to the end. */
  places() {
    const { facts } = this.recording;
    if (this.kind !== null || !facts.places.length) return [];
    const end = this.recording.last;
    return [element("li", "divider", "Result"), ...facts.places.map(({ place, team, values }) => {
      const item = element("li", "event place"), link = element("a", "moment");
      link.href = this.recording.fragment(end);
      link.append(element("span", "when", place), element("bdi", "what", team), element("bdi", "values", values));
      link.addEventListener("click", (click) => {
        if (click.ctrlKey || click.metaKey || click.shiftKey) return;
        click.preventDefault();
        this.go(end, false);
      });
      item.append(link);
      return item;
    })];
  }

  /** A live match is over, and its ranking is known. */
  finished() {
    if (!this.list.querySelector(".place")) this.list.append(...this.places());
  }

  row(event) {
    const item = element("li", `event ${event.kind}`);
    const link = element("a", "moment");
    link.href = this.recording.fragment(event.place);
    const what = element("span", "what", eventName(event));
    const team = this.recording.title(event.team);
    if (team) what.append(" ", element("bdi", "by", team));
    item.dataset.team = event.team ?? "";
    link.append(element("span", "when", this.recording.clock(event.place)), what);
    if (event.standing) link.append(element("span", "standing", event.standing));
    if (event.about) link.append(element("bdi", "about", event.about));
    if (event.payload_text) link.append(element("bdi", "values", event.payload_text));
    const row = { event, item, link };
    link.addEventListener("click", (click) => {
      if (click.ctrlKey || click.metaKey || click.shiftKey) return;
      click.preventDefault();
      this.open(row);
      this.go(event.place, false);
    });
    item.append(link);
    return row;
  }

  /** Unfold what is known of an event under its row. */
  open(row) {
    if (this.opened) {
      this.opened.item.querySelector(".details")?.remove();
      this.opened.item.classList.remove("open");
    }
    this.opened = row;
    row.item.classList.add("open");
    const { event } = row;
    const details = element("div", "details");
    if (event.says) details.append(element("p", "says", event.says));
    const facts = element("dl", "");
    const add = (name, value) => facts.append(element("dt", "", name), element("dd", "", value));
    if (event.measured !== null) add("measured", `${event.measured} ${event.unit}`.trim());
    if (event.limit !== null) add("limit", `${event.limit} ${event.unit}`.trim());
    if (event.rule) add("rule", `${event.rule}${event.copy ? ` for ${event.copy}` : ""} (${event.trigger})`);
    for (const [name, value] of event.payload) add(name, value);
    details.append(facts);
    const before = Math.round(LEAD_IN_S / this.recording.tickSeconds);
    const watch = element("button", "", `▶ from ${LEAD_IN_S} s before`);
    watch.type = "button";
    watch.addEventListener("click", () => this.go(this.recording.placeOf(event.half, event.tick - before), true));
    details.append(watch);
    row.item.append(details);
  }

  /** Mark the last event that has happened, and keep it in sight unless the pointer or the focus is in the list. */
  show(place) {
    this.colour(place);
    let current = null;
    for (const row of this.rows) {
      if (row.event.place > place + 0.5) break;
      current = row;
    }
    if (current === this.current) return;
    this.current?.link.removeAttribute("aria-current");
    this.current = current;
    if (!current) return;
    current.link.setAttribute("aria-current", "true");
    this.follow();
  }

  /** Goals have the colour that the team has on the scoreboard now. */
  colour(place) {
    const { track } = this.recording.at(place), { rows } = this;
    if (this.colouredFor === track && this.colouredRows === rows.length) return;
    [this.colouredFor, this.colouredRows] = [track, rows.length];
    for (const { item } of rows) {
      const seat = item.dataset.team && this.recording.seat(item.dataset.team, place);
      if (seat) item.style.setProperty("--team", seat.colour);
    }
  }

  follow() {
    if (this.current && !this.list.matches(":hover, :focus-within")) this.keepInSight(this.current.item);
  }

  keepInSight(item) {
    const list = this.list;
    const above = item.offsetTop - list.offsetTop;
    const covered = list.querySelector(".divider")?.offsetHeight ?? 0; // the heading of a half stays at the top
    const hidden = above < list.scrollTop + covered || above + item.offsetHeight > list.scrollTop + list.clientHeight;
    if (hidden) list.scrollTop = above - list.clientHeight / 2;
  }

  /** The next event (1) or the one before (-1), seen from a place, or null. */
  neighbour(place, direction) {
    const events = this.shown;
    return direction > 0
      ? events.find((event) => event.place > place + 0.5) || null
      : events.filter((event) => event.place < place - 0.5).pop() || null;
  }
}

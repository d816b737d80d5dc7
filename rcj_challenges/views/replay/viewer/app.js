// The page: puts the parts together, draws when something changed, listens to keys and addresses.

const KEYS = [
  ["space, K", "play or pause"], ["J, L", "rewind, fast forward"], [", .", "one frame back, forward"],
  ["← →", "5 s back, forward"], ["↑ ↓", "faster, slower"], ["P, N", "previous, next event of the list"],
  ["Home, End", "start, end"], ["F, H", "full screen, hide the panel"], ["1 2 3 4 5", "cameras: field, top, side, ball, behind a robot"],
  ["Z", "zones, gates and spots"], ["drag", "turn"], ["shift-drag, two fingers", "move"], ["wheel, pinch", "zoom"],
  ["double click", "the whole field again"], ["click on a robot", "its trail"], ["click elsewhere", "play or pause"],
];
const SLOW_FRAME_MS = 20;
const COARSEST = 0.5;
const WRITTEN_EVERY_MS = 100;
const CAPTION_S = 2;

class App {
  constructor(recording, player = new Player(recording)) {
    this.recording = recording;
    this.find = (id) => document.getElementById(id);
    this.player = player;
    this.shot = {
      poses: recording.entities.map(() => ({ x: 0, y: 0, z: 0, yaw: 0, tilt: 0, off: false })),
      spins: recording.entities.map((entity) => (entity.kind === "ball" ? [0, 0, 0, 1] : null)),
    };
    this.slowness = 0;
    this.written = 0;
    this.view = this.bestView();
    this.sharp = this.density = Math.min(this.view.finest, window.devicePixelRatio || 1);
    this.camera = new Camera(recording.facts.field, this.view instanceof Canvas2d);
    this.drawn = 0;
    const changed = () => this.changed();
    this.board = new Board(recording, this.find);
    this.events = new EventList(recording, this.find, (place, playing) => this.go(place, playing));
    this.robots = new RobotList(recording, this.find, changed, (index) => this.look("robot", index));
    this.transport = new Transport(recording, this.player, this.find, changed, (direction) => this.toEvent(direction));
    this.sensors = new Sensors(recording, this.find, this.robots.cards, changed);
    this.output = new Output(recording, this.find, changed, (place) => this.go(place, false));
    this.heat = new Heat(recording, this.find, changed);
    this.logos = new Logos(recording, this.board.rows, changed);
    this.labels = new Labels(recording, this.find("labels"));
    this.pointerInput = new PointerInput(this.find("view"), this.camera, {
      changed: () => { this.showCamera(); changed(); },
      tapped: (x, y) => this.tapped(x, y),
      flat: () => this.view instanceof Canvas2d,
    });
    this.panels = new Panels(this, changed);
    this.showCamera();
    this.bindWindow();
    this.fromAddress();
    this.resize();
  }

  /** What tests and other pages may use: where the match is, and to go elsewhere. */
  handle() {
    const app = this, { recording } = this;
    return {
      recording,
      app,
      get place() { return app.player.place; },
      get half() { return recording.at(app.player.place).track.facts.half; },
      get tick() { return recording.at(app.player.place).tick; },
      seek: (half, tick) => app.go(recording.placeOf(half, tick), false),
    };
  }

  bestView() {
    const canvas = this.find("view"), { facts } = this.recording;
    if (!new URLSearchParams(location.search).has("flat")) {
      try {
        return new Scene(canvas, facts);
      } catch (error) {
        console.info(`drawing from above: ${error.message}`);
      }
    }
    const plain = canvas.cloneNode(true);
    canvas.replaceWith(plain);
    document.body.classList.add("flat");
    return new Canvas2d(plain, facts);
  }

  bindWindow() {
    new ResizeObserver(() => this.resize()).observe(this.find("view").parentElement);
    new ResizeObserver(() => this.transport.drawMarks()).observe(this.find("marks"));
    window.addEventListener("hashchange", () => this.fromAddress());
    window.addEventListener("keydown", (event) => this.key(event));
    for (const kind of ["click", "change"]) document.addEventListener(kind, (event) => App.releaseKeyboard(event));
    window.addEventListener("beforeprint", () => this.draw()); // else the picture has been given to the screen: a black box
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.panels.retheme());
    this.find("view").addEventListener("webglcontextlost", (event) => { event.preventDefault(); });
    this.find("view").addEventListener("webglcontextrestored", () => { this.view = new Scene(this.find("view"), this.recording.facts); this.resize(); });
  }

  resize() {
    const stage = this.find("view").parentElement;
    const width = stage.clientWidth, height = stage.clientHeight;
    if (!width || !height) return;
    this.view.resize(width, height, this.moving ? this.density : this.sharp);
    this.labels.resize(width, height);
    const top = stage.getBoundingClientRect().top;
    const buttons = [...stage.querySelectorAll("[role=toolbar]")].map((bar) => bar.getBoundingClientRect().bottom - top);
    this.camera.resize(width, height, Math.max(...buttons) + 4);
    this.draw();
  }

  // --- moments ---------------------------------------------------------------------------------------------------------

  go(place, playing) {
    this.player.pause();
    this.player.seek(place);
    if (playing) this.player.start(1, 1);
    this.changed();
  }

  toEvent(direction) {
    const event = this.events.neighbour(this.player.place, direction);
    if (!event) return;
    this.go(event.place, false);
    this.say(`${event.name}, ${this.recording.clock(event.place)}`);
  }

  fromAddress() {
    const place = this.recording.placeOfFragment(location.hash);
    if (place !== null) this.go(place, false);
    if (location.hash === "#play") this.go(0, true);
  }

  /** What was chosen with the mouse keeps no focus: keys steer the match again. By the keyboard one stays where one is. */
  static releaseKeyboard({ type, detail, target }) {
    const byPointer = type === "change" ? !target.matches(":focus-visible") || target.matches("select") : detail > 0;
    if (byPointer && !target.closest("dialog")) document.activeElement?.blur();
  }

  /** Keep the address at the moment that is shown, so that copying it shares the moment. */
  toAddress() {
    const fragment = this.recording.fragment(this.player.place);
    if (fragment === location.hash) return;
    try {
      history.replaceState(null, "", fragment);
    } catch {
      // Some browsers forbid it for pages from disk; the Link button still works.
    }
  }

  // --- cameras ---------------------------------------------------------------------------------------------------------

  get hasBall() { return this.recording.entities.some((entity) => entity.kind === "ball"); }

  look(mode, robot = null) {
    if (mode === "ball" && !this.hasBall) return;
    this.camera.preset(mode, !matchMedia("(prefers-reduced-motion: reduce)").matches, robot);
    this.showCamera();
    this.changed();
  }

  nextRobot() {
    const robots = this.recording.entities.map((entity, index) => [entity, index]).filter(([entity]) => entity.kind === "robot");
    if (!robots.length) return;
    const at = robots.findIndex(([, index]) => index === this.camera.robot);
    this.look("robot", robots[(at + 1) % robots.length][1]);
  }

  showCamera() {
    const { mode, robot } = this.camera;
    for (const button of this.find("cameras").querySelectorAll("button")) {
      button.setAttribute("aria-pressed", String(button.dataset.camera === mode));
    }
    this.find("behind").value = mode === "robot" ? String(robot) : "";
  }

  get leader() {
    const { mode, robot } = this.camera;
    const leads = mode === "robot" ? robot : mode === "ball" ? this.recording.entities.findIndex((entity) => entity.kind === "ball") : -1;
    const pose = leads < 0 ? null : this.recording.pose(leads, this.player.place);
    if (!pose || pose.off) return null; // the camera waits where it was last
    return this.recording.entities[leads].front < 0 ? { ...pose, yaw: pose.yaw + Math.PI } : pose;
  }

  /** A click starts the match; later, one near a robot or ball switches its trail, any other plays or pauses. */
  tapped(x, y) {
    const { player } = this;
    const { clientWidth: width, clientHeight: height } = this.find("view");
    let best = null, least = 20;
    this.recording.entities.forEach((_, index) => {
      const pose = this.recording.pose(index, this.player.place);
      const place = this.view.project(pose.x, pose.y, pose.z);
      const away = place ? Math.hypot((place[0] - x) * width, (place[1] - y) * height) : Infinity;
      if (away < least) [best, least] = [index, away];
    });
    if (best !== null && !this.atStart) this.robots.cards[best].trail.click();
    else if (!player.following) player.toggle();
    this.changed();
  }

  get atStart() { return this.player.place === 0 && !this.player.playing; }

  // --- drawing ---------------------------------------------------------------------------------------------------------

  /** Something is different: draw, and write what is written around the picture. */
  changed() {
    this.written = -Infinity;
    this.again();
  }

  again() {
    if (this.waiting) return;
    this.waiting = requestAnimationFrame((now) => this.tick(now));
  }

  tick(now) {
    this.waiting = null;
    const passed = this.before === undefined ? 16 : now - this.before;
    const seconds = Math.min(0.25, passed / 1000);
    this.before = now;
    this.player.advance(seconds);
    const moving = this.camera.advance(seconds, this.leader, this.player.jumped && !this.camera.goal);
    this.player.jumped = false;
    this.move(this.player.moves || moving);
    this.draw(now);
    if (this.player.playing) this.adapt(passed);
    if (this.moving) this.again();
    else {
      this.before = undefined;
      this.toAddress();
    }
  }

  /** Where frames come slowly, what moves is drawn with fewer pixels: smooth motion matters more than sharp edges. */
  move(moving) {
    if (moving === this.moving) return;
    this.moving = moving;
    if (this.density < this.sharp) this.resize();
  }

  adapt(passed) {
    this.slowness = Maths.mix(this.slowness, passed > SLOW_FRAME_MS ? 1 : 0, 0.06);
    if (this.slowness > 0.6 && this.density > COARSEST) {
      this.density = Math.max(COARSEST, this.density * 0.8);
      this.slowness = 0;
      this.resize();
    }
  }

  get frame() {
    const { place } = this.player;
    const { track, tick } = this.recording.at(place);
    const failed = this.robots.failed(place);
    const { poses, spins } = this.shot;
    for (let index = 0; index < poses.length; index++) {
      track.pose(index, tick, poses[index]);
      if (spins[index]) track.spin(index, tick, spins[index]);
    }
    return {
      bodies: this.recording.dress(track.facts),
      poses,
      spins,
      trails: [...this.robots.trailsAt(place, this.panels.trailSeconds), ...this.sensors.raysAt(place, this.panels.shown.rays)],
      heat: this.heat.at(place),
      logos: this.logos.at(place),
      lights: this.sensors.lightsAt(place),
      show: this.shownNow,
      failed,
      background: PALETTE.outside[this.panels.themeNow],
    };
  }

  /** What the switches say: the same object until one of them changes. */
  get shownNow() {
    const shown = this.panels.shown;
    const changed = !this.switches || Object.keys(shown).some((name) => shown[name] !== this.switches[name]);
    if (changed) this.switches = shown;
    return this.switches;
  }

  /** The picture is drawn each time; the text around it is updated ten times a second while the match plays. */
  draw(now = performance.now()) {
    const frame = this.frame;
    this.view.draw(frame, this.camera);
    this.labels.show(frame, this.view);
    this.drawn += 1;
    if (this.player.moves && now - this.written < WRITTEN_EVERY_MS) return;
    this.written = now;
    this.write(frame);
  }

  write(frame) {
    const { place } = this.player;
    this.find("begin").toggleAttribute("hidden", !this.atStart); // an SVG element has no property for it
    this.board.show(place);
    this.transport.show(place);
    this.events.show(place);
    if (!this.find("panel-robots").hidden) {
      this.robots.show(place, frame.failed);
      this.sensors.show(place, this.player.moves);
    }
    if (!this.find("panel-output").hidden) this.output.show(place);
    this.caption(place);
    this.afterDraw?.();
  }

  /** What the referee said just now, over the picture. */
  caption(place) {
    const box = this.find("caption"), result = this.result(place), event = result ? null : this.eventAt(place);
    const text = result || event?.caption || "";
    box.hidden = !text;
    box.style.setProperty("--team", event?.kind === "fault" ? "var(--fault)" : this.recording.seat(event?.team, place)?.colour ?? "transparent");
    if (box.textContent !== text) box.textContent = text;
  }

  eventAt(place) {
    const recent = this.recording.eventsBetween(place - CAPTION_S / this.recording.tickSeconds, place + 0.5).filter((event) => event.kind !== "start");
    return recent.filter((event) => event.scored).pop() || recent[recent.length - 1];
  }

  /** At the end: the ranking, if more than the score decides it, else the score. */
  result(place) {
    const { recording } = this, { places, teams, score_counts: counts } = recording.facts;
    if (!recording.isOver(place)) return "";
    if (places.length || !counts || teams.length !== 2) return places.map((one) => `${one.place}: ${one.team}, ${one.values}`).join("\n");
    const [first, second] = teams, scores = recording.scores(place);
    return `Final score: ${first.title} ${scores[first.name] ?? 0} : ${scores[second.name] ?? 0} ${second.title}`;
  }

  say(text) {
    this.find("spoken").textContent = text;
  }

  // --- keys ------------------------------------------------------------------------------------------------------------

  key(event) {
    const field = event.target.closest?.(/^(Arrow|Home|End)/.test(event.key) ? "select, dialog, [role=tablist]" : "select, dialog");
    const pressable = event.target.closest?.("button, input[type=checkbox]");
    if (field || event.ctrlKey || event.metaKey || event.altKey) return;
    if (pressable && event.key === " ") return;
    if (event.target.id === "trail" && /^(Arrow|Home|End|Page)/.test(event.key)) return;
    const { player } = this;
    const actions = {
      " ": () => player.toggle(), k: () => player.toggle(), j: () => player.wind(-1), l: () => player.wind(1),
      ",": () => player.frames(-1), ".": () => player.frames(1),
      ArrowLeft: () => player.seconds(-5), ArrowRight: () => player.seconds(5),
      ArrowUp: () => player.faster(1), ArrowDown: () => player.faster(-1),
      p: () => this.toEvent(-1), n: () => this.toEvent(1),
      Home: () => player.seek(0), End: () => player.seek(this.recording.last),
      1: () => this.look("overview"), 2: () => this.look("top"), 3: () => this.look("side"), 4: () => this.look("ball"),
      f: () => this.panels.toggleFullscreen(), h: () => this.panels.togglePanel(),
      5: () => this.nextRobot(), z: () => this.panels.toggleMarks(), "?": () => this.panels.help(),
    };
    const action = actions[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (!action) return;
    event.preventDefault();
    action();
    this.changed();
  }
}

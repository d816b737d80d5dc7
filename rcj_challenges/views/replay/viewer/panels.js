// Tabs, switches, theme, help, and what is known of the run.

class Panels {
  constructor(app, changed) {
    this.app = app;
    this.find = app.find;
    this.changed = changed;
    this.theme = "";
    this.tabs();
    this.switches();
    this.cameras();
    this.about();
    this.dialogs();
    this.room();
  }

  tabs() {
    const tabs = [...document.querySelectorAll("[role=tab]")];
    const choose = (chosen) => {
      for (const tab of tabs) {
        tab.setAttribute("aria-selected", String(tab === chosen));
        tab.tabIndex = tab === chosen ? 0 : -1;
        this.find(tab.getAttribute("aria-controls")).hidden = tab !== chosen;
      }
      this.changed();
    };
    tabs.forEach((tab, index) => {
      tab.addEventListener("click", () => choose(tab));
      tab.addEventListener("keydown", (event) => {
        const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
        if (!step) return;
        const next = tabs[(index + step + tabs.length) % tabs.length];
        choose(next);
        next.focus();
      });
    });
  }

  switches() {
    this.boxes = [...this.find("show").querySelectorAll("input[type=checkbox]")];
    for (const box of this.boxes) {
      box.addEventListener("change", this.changed);
      const none = { zones: "zones", gates: "gates", spots: "spots" }[box.name];
      if (none && !this.app.recording.facts[none].length) box.disabled = true;
      // Gates by which rules judge are part of the course: without them a spectator cannot see where a race begins.
      if (box.name === "gates" && this.app.recording.facts.gates.some((gate) => gate.used)) box.checked = box.defaultChecked = true;
    }
    this.find("trail").addEventListener("input", () => {
      this.find("trail-text").textContent = `${this.trailSeconds} s`;
      this.changed();
    });
  }

  get shown() {
    return Object.fromEntries(this.boxes.map((box) => [box.name, box.checked]));
  }

  get trailSeconds() {
    return Number(this.find("trail").value);
  }

  toggleMarks() {
    const marks = this.boxes.filter((box) => ["zones", "gates", "spots"].includes(box.name) && !box.disabled);
    const on = !marks.every((box) => box.checked);
    for (const box of marks) box.checked = on;
  }

  cameras() {
    const { app } = this;
    for (const button of this.find("cameras").querySelectorAll("button")) {
      button.hidden = button.dataset.camera === "ball" && !app.hasBall;
      button.addEventListener("click", () => app.look(button.dataset.camera));
    }
    const behind = this.find("behind");
    behind.append(new Option("Behind…", ""));
    app.recording.entities.forEach((entity, index) => {
      if (entity.kind === "robot") behind.append(new Option(entity.name, String(index)));
    });
    behind.addEventListener("change", () => {
      if (behind.value) app.look("robot", Number(behind.value));
      else app.look("overview");
      behind.blur();
    });
  }

  about() {
    const { facts } = this.app.recording;
    const list = this.find("about");
    for (const [name, value] of facts.about) list.append(element("dt", "", name), element("dd", "", value));
    const problem = this.find("problem");
    problem.textContent = facts.problem;
    problem.hidden = !facts.problem;
  }

  dialogs() {
    for (const [keys, what] of KEYS) this.find("help-keys").append(element("dt", "", keys), element("dd", "", what));
    this.find("help").addEventListener("click", () => this.help());
    this.find("theme").addEventListener("click", () => {
      this.theme = this.themeNow === "dark" ? "light" : "dark";
      document.documentElement.dataset.theme = this.theme;
      this.retheme();
    });
    this.find("copy").addEventListener("click", () => this.copy());
  }

  /** More room for the field: without the panel, or on the whole screen. */
  room() {
    this.find("panel").addEventListener("click", () => this.togglePanel());
    const low = matchMedia("(max-height: 520px) and (min-aspect-ratio: 1/1)"); // a phone held sideways
    low.addEventListener("change", () => this.togglePanel(low.matches));
    this.togglePanel(low.matches);
    this.find("fullscreen").hidden = !document.fullscreenEnabled;
    this.find("fullscreen").addEventListener("click", () => this.toggleFullscreen());
  }

  togglePanel(hidden = !document.body.classList.contains("no-panel")) {
    document.body.classList.toggle("no-panel", hidden);
    this.find("panel").setAttribute("aria-pressed", String(hidden));
  }

  toggleFullscreen() {
    if (document.fullscreenElement) document.exitFullscreen();
    else document.documentElement.requestFullscreen?.();
  }

  help() {
    const dialog = this.find("help-text");
    if (!dialog.open) dialog.showModal();
  }

  get themeNow() {
    return this.theme || (matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light");
  }

  retheme() {
    this.app.transport.drawMarks();
    this.changed();
  }

  async copy() {
    const { app } = this;
    const address = location.href.split("#")[0] + app.recording.fragment(app.player.place);
    try {
      await navigator.clipboard.writeText(address);
      app.say("Link copied");
      this.flash("Copied");
    } catch {
      app.toAddress();
      this.flash("In the address bar");
    }
  }

  flash(text) {
    const button = this.find("copy");
    button.setAttribute("aria-pressed", "true");
    button.title = text;
    clearTimeout(this.flashing);
    this.flashing = setTimeout(() => {
      button.removeAttribute("aria-pressed");
      button.title = button.getAttribute("aria-label");
    }, 1500);
  }
}

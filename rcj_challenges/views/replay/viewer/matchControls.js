// Controls of the match itself, for the person who started it. The token comes in the address, behind "#", and is sent
// with orders only. It is kept for this tab, so that a reload keeps the controls, and removed from the address, so that
// a link that is passed on does not grant them.

const TOKEN_KEY = "rcj-token";
const MATCH_SPEEDS = [0.25, 0.5, 1, 2, 4, 8, 16, 32];

class MatchControls {
  /** The controls, if the address has the token or had it before; else null. */
  static fromAddress() {
    const given = /^#token=([\w-]{16,})$/.exec(location.hash);
    if (given) {
      sessionStorage.setItem(TOKEN_KEY, given[1]);
      history.replaceState(null, "", location.pathname);
    }
    const token = sessionStorage.getItem(TOKEN_KEY);
    return token ? new MatchControls(token) : null;
  }

  constructor(token) {
    this.token = token;
    this.pace = null;
    this.bar = element("div", "match-controls");
    this.bar.setAttribute("role", "toolbar");
    this.bar.setAttribute("aria-label", "The match itself, for everybody");
    this.pause = this.button("Pause match", () => this.order({ do: this.pace?.paused ? "resume" : "pause" }));
    this.pause.id = "match-pause";
    this.step = this.button("Step", () => this.order({ do: "step", ticks: 1 }));
    this.step.id = "match-step";
    this.step.title = "Play one tick of the match (32 ms)";
    this.speed = element("select");
    this.speed.id = "match-speed";
    this.speed.setAttribute("aria-label", "Speed of the match");
    for (const speed of MATCH_SPEEDS) this.speed.append(new Option(`${speed} ×`, String(speed)));
    this.speed.append(new Option("full speed", "max"));
    this.speed.addEventListener("change", () => {
      this.order({ do: "speed", speed: this.speed.value === "max" ? null : Number(this.speed.value) });
      this.speed.blur();
    });
    this.bar.append(this.pause, this.step, this.speed);
    document.querySelector(".stage").append(this.bar);
  }

  button(text, act) {
    const button = element("button", "", text);
    button.type = "button";
    button.addEventListener("click", act);
    return button;
  }

  async order(order) {
    try {
      const answer = await fetch("steer", {
        method: "POST",
        headers: { "Authorization": `Bearer ${this.token}`, "Content-Type": "application/json" },
        body: JSON.stringify(order),
      });
      if (answer.ok) return;
      if (answer.status === 403) this.resign();
    } catch {
      // The feed reports a lost connection.
    }
  }

  /** The token is none of this match: another one is played at this address. */
  resign() {
    sessionStorage.removeItem(TOKEN_KEY);
    this.bar.remove();
  }

  show(pace, over) {
    this.bar.hidden = over;
    if (over || pace === this.pace) return;
    this.pace = pace;
    this.pause.textContent = pace.paused ? "Resume match" : "Pause match";
    const value = pace.speed === null ? "max" : String(pace.speed);
    if (![...this.speed.options].some((option) => option.value === value)) this.speed.append(new Option(`${value} ×`, value));
    this.speed.value = value;
  }
}

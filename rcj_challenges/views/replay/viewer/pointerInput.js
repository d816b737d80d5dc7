// Mouse, pen and fingers on the picture: turn, move, zoom.

const TURN_PER_PIXEL = 0.006;

class PointerInput {
  /** changed(): the camera moved; tapped(x, y): a click without a move, in parts of the picture. */
  constructor(canvas, camera, { changed, tapped, flat }) {
    this.canvas = canvas;
    this.camera = camera;
    this.changed = changed;
    this.flat = flat;
    this.pointers = new Map();
    this.travelled = 0;
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    canvas.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    canvas.addEventListener("dblclick", () => { camera.preset("overview"); changed(); });
    canvas.addEventListener("pointerdown", (event) => {
      canvas.setPointerCapture(event.pointerId);
      this.pointers.set(event.pointerId, [event.clientX, event.clientY]);
      if (this.pointers.size === 1) this.travelled = 0;
    });
    canvas.addEventListener("pointermove", (event) => this.moved(event));
    for (const end of ["pointerup", "pointercancel"]) {
      canvas.addEventListener(end, (event) => {
        const alone = this.pointers.size === 1;
        if (!this.pointers.delete(event.pointerId)) return;
        if (end === "pointerup" && alone && this.travelled < 6) tapped(...this.inPicture(event));
      });
    }
  }

  inPicture(event) {
    const box = this.canvas.getBoundingClientRect();
    return [(event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height];
  }

  wheel(event) {
    event.preventDefault();
    const unit = event.deltaMode === 1 ? 16 : 1;
    this.camera.zoom(Math.exp(Maths.clamp(event.deltaY * unit, -200, 200) * 0.0015));
    this.changed();
  }

  moved(event) {
    const before = this.pointers.get(event.pointerId);
    if (!before) return;
    const dx = event.clientX - before[0], dy = event.clientY - before[1];
    this.travelled += Math.abs(dx) + Math.abs(dy);
    const height = this.canvas.clientHeight || 1;
    if (this.pointers.size === 1) {
      this.pointers.set(event.pointerId, [event.clientX, event.clientY]);
      const moves = this.flat() || event.shiftKey || event.ctrlKey || event.buttons & 6;
      if (moves) this.camera.pan(dx / height, -dy / height);
      else this.camera.orbit(dx * TURN_PER_PIXEL, dy * TURN_PER_PIXEL);
    } else if (this.pointers.size === 2) {
      this.pinched(event, height);
    }
    this.changed();
  }

  /** Two fingers: their distance zooms, their middle moves, their direction turns. */
  pinched(event, height) {
    const measure = () => {
      const [[x0, y0], [x1, y1]] = [...this.pointers.values()];
      return { x: (x0 + x1) / 2, y: (y0 + y1) / 2, apart: Math.hypot(x1 - x0, y1 - y0) || 1, turn: Math.atan2(y1 - y0, x1 - x0) };
    };
    const before = measure();
    this.pointers.set(event.pointerId, [event.clientX, event.clientY]);
    const after = measure();
    this.camera.zoom(before.apart / after.apart);
    if (!this.flat()) this.camera.orbit(-Maths.wrap(after.turn - before.turn), 0);
    this.camera.pan((after.x - before.x) / height, -(after.y - before.y) / height);
  }
}

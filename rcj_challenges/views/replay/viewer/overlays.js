// Names that float over robots, written once into a picture: the graphics card moves them, the page has nothing to do.
// They are for the eye only; the list of robots has the same names as text.

const SIGN_PIXELS = 16;
const SIGN_SHARPNESS = 2;
const SIGN_WIDEST = 170;
const SIGN_FONT = '650 11px system-ui, "Segoe UI", Roboto, "Noto Sans", "Noto Sans CJK SC", "Noto Naskh Arabic", sans-serif';

const Overlays = {
  /** {canvas, mesh}: one sign for each robot, its lower edge on the robot's upper end; red ones, for a program that failed, half the canvas below. */
  of(entities) {
    const robots = entities.map((entity, index) => ({ entity, body: index + 1 })).filter(({ entity }) => entity.kind === "robot");
    const canvas = document.createElement("canvas");
    canvas.width = (SIGN_WIDEST + 2) * SIGN_SHARPNESS;
    canvas.height = 2 * Math.max(1, robots.length) * (SIGN_PIXELS + 2) * SIGN_SHARPNESS;
    const pen = canvas.getContext("2d");
    pen.scale(SIGN_SHARPNESS, SIGN_SHARPNESS);
    pen.font = SIGN_FONT;
    pen.textBaseline = "middle";
    const mesh = new Mesh();
    robots.forEach(({ entity, body }, row) => {
      const top = row * (SIGN_PIXELS + 2) + 1;
      const text = Overlays.fitting(pen, entity.name);
      const width = Math.ceil(pen.measureText(text).width) + 10;
      for (const [ground, y] of [["rgb(10 15 20 / 62%)", top], ["rgb(176 28 28 / 90%)", top + canvas.height / SIGN_SHARPNESS / 2]]) {
        pen.fillStyle = ground;
        pen.beginPath();
        pen.roundRect(1, y, width, SIGN_PIXELS, 5);
        pen.fill();
        pen.fillStyle = "#fff";
        pen.fillText(text, 6, y + SIGN_PIXELS / 2 + 0.5);
      }
      mesh.join(Overlays.quad(entity, width, top, canvas), body);
    });
    return { canvas, mesh };
  },

  fitting(pen, name) {
    let text = name;
    while (text.length > 1 && pen.measureText(text).width > SIGN_WIDEST - 12) text = `${[...text].slice(0, -2).join("")}…`;
    return text;
  },

  quad(entity, width, top, canvas) {
    const reach = entity.size_m * 0.8, half = Math.round(width / 2);
    const place = (x, y) => [(x * SIGN_SHARPNESS) / canvas.width, (y * SIGN_SHARPNESS) / canvas.height];
    const left = -half, right = width - half;
    return new Mesh().quad(
      [left, 0, reach], [right, 0, reach], [right, SIGN_PIXELS, reach], [left, SIGN_PIXELS, reach], [1, 1, 1],
      [place(1, top + SIGN_PIXELS), place(1 + width, top + SIGN_PIXELS), place(1 + width, top), place(1, top)],
    );
  },
};

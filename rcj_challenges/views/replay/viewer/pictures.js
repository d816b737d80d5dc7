// What cameras took and recognized, if it was recorded: pictures on the cards of their robots, with a box around each
// thing. Blocks of some seconds are read when they are first wanted; a picture is a palette and a number for each pixel.

const RECOGNITION = 0x8000, THING_BYTES = 63, THING_BOX_AT = 55;
const THINGS = ["robot", "ball", "obstacle"];
const PICTURE_SCALE = 4;
const MOST_BLOCKS = 4;

class Pictures {
  constructor(changed) {
    this.changed = changed;
    this.blocks = new Map();
  }

  /** {tick, bytes} of all packets of a robot's cameras, by their number; null as long as they are being read. */
  block(half, number) {
    const id = `pictures-${half}-${number}`;
    if (!this.blocks.has(id)) {
      const text = document.getElementById(id)?.textContent;
      this.blocks.set(id, text ? null : new Map());
      if (text) {
        Pictures.read(text).then((robots) => { this.blocks.set(id, robots); this.changed(); })
          .catch((error) => console.error(`the pictures of cameras cannot be shown: ${error.message}`));
      }
      if (this.blocks.size > MOST_BLOCKS) this.blocks.delete(this.blocks.keys().next().value);
    }
    return this.blocks.get(id);
  }

  static async read(text) {
    const bytes = await Embedded.inflate(text), robots = new Map();
    const size = new DataView(bytes.buffer).getUint32(0, true);
    let at = 4 + size;
    for (const [robot, number, tick, length] of JSON.parse(new TextDecoder().decode(bytes.subarray(4, at)))) {
      if (!robots.has(robot)) robots.set(robot, new Map());
      const cameras = robots.get(robot);
      if (!cameras.has(number)) cameras.set(number, []);
      cameras.get(number).push({ tick, bytes: bytes.subarray(at, at += length) });
    }
    if (at !== bytes.length) throw new Error("they are not complete");
    return robots;
  }

  /** Draw the latest pictures of a robot at a tick into its card. */
  show(card, half, { name, cameras }, tick, blockTicks) {
    if (!cameras?.length) return;
    const packets = this.block(half, Math.floor(tick / blockTicks))?.get(name);
    card.views ??= new Map();
    for (const [index, camera, width, height] of cameras) {
      const latest = [index, index + RECOGNITION].map((number) => Pictures.latest(packets?.get(number), tick));
      let view = card.views.get(index);
      if (!view && latest.some(Boolean)) card.views.set(index, view = Pictures.add(card.box, camera, width, height));
      if (!view || latest.every((packet, at) => packet === view.shown[at])) continue;
      view.shown = latest;
      view.figure.hidden = !latest.some(Boolean);
      Pictures.draw(view, ...latest.map((packet) => packet?.bytes));
    }
  }

  static latest(packets, tick) {
    return packets?.[Sensors.last(packets, tick, (packet) => packet.tick)];
  }

  static add(box, name, width, height) {
    const figure = element("figure", "camera"), canvas = element("canvas");
    canvas.width = PICTURE_SCALE * width;
    canvas.height = PICTURE_SCALE * height;
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", `Picture of ${name}`);
    figure.append(canvas, element("figcaption", "", name));
    box.append(figure);
    return { figure, canvas, width, height, shown: [] };
  }

  static draw({ canvas, width, height }, picture, things) {
    const pen = canvas.getContext("2d");
    pen.fillStyle = Colours.css(PALETTE.dark);
    pen.fillRect(0, 0, canvas.width, canvas.height);
    if (picture) {
      const image = new ImageData(width, height), pixels = image.data, begin = 1 + 3 * picture[0];
      for (let pixel = 0; pixel < width * height; pixel++) {
        const colour = 1 + 3 * picture[begin + pixel];
        pixels.set([picture[colour], picture[colour + 1], picture[colour + 2], 255], 4 * pixel);
      }
      const small = document.createElement("canvas");
      small.width = width;
      small.height = height;
      small.getContext("2d").putImageData(image, 0, 0);
      pen.imageSmoothingEnabled = false;
      pen.drawImage(small, 0, 0, canvas.width, canvas.height);
    }
    for (let at = 0; at < (things?.length ?? 0); at += THING_BYTES) {
      const data = new DataView(things.buffer, things.byteOffset + at, THING_BYTES);
      const [left, top, wide, high] = [0, 2, 4, 6].map((part) => PICTURE_SCALE * data.getUint16(THING_BOX_AT + part, true));
      pen.strokeStyle = pen.fillStyle = "#fff";
      pen.lineWidth = 1;
      pen.strokeRect(left + 0.5, top + 0.5, wide - 1, high - 1);
      pen.font = "11px system-ui, sans-serif";
      pen.fillText(`${THINGS[data.getUint16(2, true)]} ${data.getUint16(0, true)}`, left + 1, top > 12 ? top - 3 : top + high + 11);
    }
  }
}

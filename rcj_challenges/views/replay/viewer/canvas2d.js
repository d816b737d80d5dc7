// The field from above on a plain canvas: for browsers without WebGL 2. Same frames, same camera (without tilt).

class Canvas2d {
  constructor(canvas, facts) {
    this.canvas = canvas;
    this.facts = facts;
    this.name = "2-D";
    this.finest = 2;
    this.pen = canvas.getContext("2d");
    this.ground = Ground.field(facts);
    this.matrix = [1, 0, 0, 1, 0, 0];
  }

  resize(width, height, density) {
    this.canvas.width = Math.max(1, Math.round(width * density));
    this.canvas.height = Math.max(1, Math.round(height * density));
  }

  draw(frame, camera) {
    const { pen, canvas } = this;
    pen.setTransform(1, 0, 0, 1, 0, 0);
    pen.fillStyle = Colours.css(frame.background);
    pen.fillRect(0, 0, canvas.width, canvas.height);
    this.matrix = this.seenFrom(camera.pose);
    pen.setTransform(...this.matrix);
    for (const shape of this.ground) this.shape(shape);
    for (const shape of frame.heat.shapes) this.shape(shape);
    for (const shape of Ground.marks(this.facts, frame.show)) this.shape(shape);
    for (const shape of Ground.movingMarks(this.facts, frame.show, frame.poses)) this.shape(shape);
    for (const trail of frame.trails) {
      for (const points of trail.pieces) this.shape({ points, line: trail.colour, width: trail.width, alpha: 0.75 });
    }
    for (const wall of Bodies.walls(this.facts.field)) {
      this.shape({ points: [wall.from, wall.to], line: wall.colour, width: 0.012, alpha: 1 });
    }
    this.shadows = frame.show.shadows;
    this.facts.fixed.forEach((thing) => this.thing(thing, { x: thing.centre_m?.[0] ?? 0, y: thing.centre_m?.[1] ?? 0, yaw: thing.yaw_rad || 0 }));
    this.facts.entities.forEach((entity, index) => this.thing(entity, frame.poses[index], frame.failed.has(index), frame.logos[index]));
    for (const light of frame.lights) {
      const { x, y, yaw } = frame.poses[light.index], [ahead, left] = Bodies.light(this.facts.entities[light.index], light);
      const at = [x + Math.cos(yaw) * ahead - Math.sin(yaw) * left, y + Math.sin(yaw) * ahead + Math.cos(yaw) * left];
      this.shape({ points: Mesh.circle(...at, LIGHT_M, 16), fill: light.colour, alpha: 1 });
    }
  }

  /** The 2-D matrix of a camera that looks straight down. */
  seenFrom({ azimuth, distance, target }) {
    const scale = this.canvas.height / (2 * distance * Math.tan(VIEW_ANGLE / 2));
    const c = Math.cos(azimuth) * scale, s = Math.sin(azimuth) * scale;
    const [x, y] = target;
    return [-s, c, c, s, this.canvas.width / 2 + s * x - c * y, this.canvas.height / 2 - c * x - s * y];
  }

  shape({ points, fill, line, width, closed, alpha }) {
    const { pen } = this;
    pen.beginPath();
    points.forEach(([x, y], index) => (index ? pen.lineTo(x, y) : pen.moveTo(x, y)));
    if (fill || closed) pen.closePath();
    if (fill) {
      pen.fillStyle = Colours.css(fill, alpha);
      pen.fill();
    } else {
      pen.strokeStyle = Colours.css(line, alpha);
      pen.lineWidth = width;
      pen.stroke();
    }
  }

  thing(thing, pose, failed = false, logo = undefined) {
    const { pen } = this;
    if (thing.shape === "wall") {
      this.shape({ points: [thing.from_m, thing.to_m], line: Colours.rgb(thing.colour), width: thing.thickness_m, alpha: 1 });
      return;
    }
    pen.save();
    pen.translate(pose.x, pose.y);
    pen.rotate(pose.yaw);
    const colour = failed ? PALETTE.failed : Colours.rgb(thing.colour);
    if (this.shadows) {
      const { a, b } = pen.getTransform();
      pen.shadowColor = "rgb(0 0 0 / 50%)";
      pen.shadowBlur = Math.hypot(a, b) * SHADOW_M;
    }
    if (thing.kind === "robot") this.robot(thing, colour, logo);
    else if (thing.radius_m) this.shape({ points: Mesh.circle(0, 0, thing.radius_m, 32), fill: colour, alpha: 1 });
    else {
      const [x, y] = thing.size_m;
      this.shape({ points: Ground.rectangle(-x / 2, -y / 2, x / 2, y / 2), fill: colour, alpha: 1 });
    }
    pen.restore();
  }

  robot(entity, colour, logo) {
    const { pen } = this;
    const half = entity.size_m / 2;
    for (const { x_m, y_m, yaw_rad, radius_m, width_m } of entity.wheels) {
      const along = [Math.cos(yaw_rad) * radius_m, Math.sin(yaw_rad) * radius_m];
      this.shape({ points: [-1, 1].map((way) => [x_m + way * along[0], y_m + way * along[1]]), line: PALETTE.dark, width: width_m, alpha: 1 });
    }
    for (const jaw of entity.jaws) this.shape({ points: jaw, fill: PALETTE.dark, alpha: 1 });
    this.shape({ points: entity.body, fill: colour, alpha: 1 });
    pen.shadowColor = "transparent";
    const ahead = entity.front > 0 ? entity.front_m : half;
    const tip = ahead * entity.front, foot = (ahead - 0.014) * entity.front;
    this.shape({ points: [[tip, 0], [foot, 0.016], [foot, -0.016]], fill: PALETTE.mark, alpha: 1 });
    // Letters are drawn in pixels: fonts of some hundredths of a unit come out ragged.
    const { a, b, e, f } = pen.getTransform();
    const pixels = Math.hypot(a, b) * entity.size_m * 0.55;
    pen.setTransform(1, 0, 0, 1, e, f);
    pen.fillStyle = Colours.onTop(colour);
    pen.font = `800 ${logo ? pixels * 0.7 : pixels}px system-ui, "Noto Sans", sans-serif`;
    pen.textAlign = "center";
    pen.textBaseline = "middle";
    pen.fillText(String(entity.number), 0, logo ? -pixels * 0.42 : pixels * 0.05);
    if (logo) Logos.draw(pen, logo, 0, pixels * 0.42, pixels * 0.78);
  }

  project(x, y) {
    const [a, b, c, d, e, f] = this.matrix;
    return [(a * x + c * y + e) / this.canvas.width, (b * x + d * y + f) / this.canvas.height, Math.hypot(a, b) / this.canvas.height];
  }
}

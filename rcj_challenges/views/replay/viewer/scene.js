// The field in 3-D.

const LIGHT = Maths.unit([-0.35, 0.25, 0.9]);
const IDENTITY = new Float32Array([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
const SHADOW = Maths.flatten(LIGHT);

class Scene {
  /** Throws if the browser has no WebGL 2. */
  constructor(canvas, facts) {
    this.canvas = canvas;
    this.facts = facts;
    this.painter = new Painter(canvas);
    this.name = "3-D";
    this.finest = this.painter.software ? 1 : 2;
    this.painter.useLetters(Bodies.atlas(facts.entities));
    this.bodies = facts.entities.map((entity) => this.painter.upload(Bodies.of(entity)));
    this.numbers = facts.entities.map((entity, cell) =>
      entity.kind === "robot" ? this.painter.upload(Bodies.number(entity, cell)) : null);
    const { panes, rims } = Bodies.wallMeshes(facts.field);
    this.panes = this.painter.upload(panes);
    this.rims = this.painter.upload(rims);
    this.fixed = this.painter.upload(Bodies.fixed(facts));
    this.ground = this.layers(Ground.field(facts));
    this.marks = [];
    this.markKey = "";
    this.view = IDENTITY;
  }

  /** Shapes of equal opacity that follow each other are one mesh. */
  layers(shapes) {
    const layers = [];
    for (const shape of shapes) {
      if (!layers.length || layers[layers.length - 1].alpha !== shape.alpha) layers.push({ alpha: shape.alpha, mesh: new Mesh() });
      const { mesh } = layers[layers.length - 1];
      if (shape.fill) mesh.floor(shape.points, shape.fill);
      else mesh.line(shape.points, shape.width, shape.line, shape.closed);
    }
    return layers.map(({ alpha, mesh }) => ({ alpha, mesh: this.painter.upload(mesh) }));
  }

  resize(width, height, density) {
    this.canvas.width = Math.max(1, Math.round(width * density));
    this.canvas.height = Math.max(1, Math.round(height * density));
  }

  /** frame: {poses, spins, trails, show, background, ghost}; camera: where from. */
  draw(frame, camera) {
    const painter = this.painter;
    this.view = camera.matrix();
    painter.begin(frame.background, this.view, camera.eye(), LIGHT);
    const models = this.facts.entities.map((entity, index) => this.model(entity, frame.poses[index], frame.spins[index]));
    this.drawFloor(frame, models);
    painter.solid();
    models.forEach((model, index) => painter.draw(this.bodies[index], model, this.style(frame, index)));
    painter.draw(this.fixed, IDENTITY);
    painter.draw(this.rims, IDENTITY);
    painter.glass();
    models.forEach((model, index) => {
      if (this.numbers[index]) painter.draw(this.numbers[index], model, { way: "lettered" });
    });
    painter.draw(this.panes, IDENTITY, { opacity: 0.34 });
  }

  drawFloor(frame, models) {
    const painter = this.painter;
    painter.onFloor();
    for (const { alpha, mesh } of this.ground) painter.draw(mesh, IDENTITY, { way: "plain", opacity: alpha });
    const key = JSON.stringify([frame.show.zones, frame.show.gates, frame.show.spots]);
    if (key !== this.markKey) {
      this.markKey = key;
      this.marks = this.layers(Ground.marks(this.facts, frame.show));
    }
    for (const { alpha, mesh } of this.marks) painter.draw(mesh, IDENTITY, { way: "plain", opacity: alpha });
    for (const trail of frame.trails) {
      const mesh = new Mesh();
      for (const piece of trail.pieces) mesh.line(piece, trail.width, trail.colour);
      painter.drawOnce(mesh, IDENTITY, { way: "plain", opacity: 0.75 });
    }
    if (!frame.show.shadows) return;
    painter.shadows();
    const dark = { tint: [0, 0.02, 0.05], share: 1, way: "plain", opacity: 0.34 };
    models.forEach((model, index) => painter.draw(this.bodies[index], Maths.multiply(SHADOW, model), dark));
    painter.draw(this.fixed, SHADOW, dark);
  }

  model(entity, pose, spin) {
    if (spin) return Maths.poseOfQuaternion(pose.x, pose.y, pose.z, spin);
    return Maths.pose(pose.x, pose.y, pose.z, pose.yaw, pose.tilt);
  }

  style(frame, index) {
    return frame.failed.has(index) ? { tint: [0.45, 0.46, 0.5], share: 0.7 } : {};
  }

  /**
   * Where a point of the field is in the picture: [x, y, scale], in parts of its width and height from the upper left,
   * and how much of the height a metre takes there; or null.
   */
  project(x, y, z) {
    const [px, py, , w] = Maths.transform(this.view, x, y, z);
    return w > 0 ? [(px / w + 1) / 2, (1 - py / w) / 2, 1 / (2 * w * Math.tan(VIEW_ANGLE / 2))] : null;
  }
}

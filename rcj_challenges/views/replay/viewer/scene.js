// The field in 3-D: about seven calls for a picture, whatever moves.

const LIGHT = Maths.unit([-0.35, 0.25, 0.9]);
const GLASS = 0.34;
const LIGHT_M = 0.004;
const TRAIL_OPACITY = 0.75;
const SHADOW_OPACITY = 0.5;

class Scene {
  /** Throws if the browser has no WebGL 2. */
  constructor(canvas, facts) {
    this.canvas = canvas;
    this.facts = facts;
    const { entities } = facts;
    if (entities.length >= MOST_BODIES) throw new Error(`more than ${MOST_BODIES - 1} things that move`);
    const painter = this.painter = new Painter(canvas);
    this.name = "3-D";
    this.writesNames = true;
    this.finest = painter.software ? 1 : 2;
    painter.useLetters(Bodies.atlas(entities));
    const { panes, rims } = Bodies.wallMeshes(facts.field);
    this.rims = rims;
    this.dress(0);
    this.panes = painter.upload(panes);
    this.ground = this.layers(Ground.field(facts));
    this.signs = this.nameSigns(entities);
    this.marks = [];
    this.shown = null;
    this.view = new Float32Array(16);
    this.begin();
  }

  /** Build what stands and moves; `key` says how robots look. */
  dress(key) {
    const { painter, facts } = this;
    const standing = new Mesh().join(Bodies.fixed(facts)).join(this.rims);
    const shadows = new Mesh().join(Bodies.fixedShadows(facts));
    const numbers = new Mesh();
    facts.entities.forEach((entity, index) => {
      standing.join(Bodies.of(entity), index + 1);
      shadows.join(Bodies.shadow(entity), index + 1);
      if (entity.kind === "robot") numbers.join(Bodies.number(entity, index), index + 1);
    });
    for (const mesh of [this.bodies, this.shadows, this.numbers]) if (mesh) painter.forget(mesh);
    this.bodies = painter.upload(standing);
    this.shadows = painter.upload(shadows);
    this.numbers = painter.upload(numbers);
    this.dressed = key;
  }

  /** What is the same in every picture. */
  begin() {
    const { block } = this.painter;
    block.set([...LIGHT, 0], FAR_OFF.light);
    block.set([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1], FAR_OFF.models);
    block[FAR_OFF.lens] = 1 / Math.tan(VIEW_ANGLE / 2);
  }

  nameSigns(entities) {
    const { canvas, mesh } = Overlays.of(entities);
    if (mesh.vertices) this.painter.useLetters(canvas, "sign");
    return this.painter.upload(mesh);
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
    const across = Math.max(1, Math.round(width * density)), down = Math.max(1, Math.round(height * density));
    if (this.canvas.width !== across) this.canvas.width = across;
    if (this.canvas.height !== down) this.canvas.height = down;
    this.painter.block.set([width, height, across, down], FAR_OFF.screen);
  }

  /** frame: {bodies, poses, spins, trails, heat, logos, show, failed, background}; camera: where from. */
  draw(frame, camera) {
    const { painter } = this;
    if (frame.logos !== this.logos) {
      this.logos = frame.logos;
      painter.useLetters(Bodies.atlas(this.facts.entities, this.logos));
    }
    if (frame.bodies !== this.dressed) this.dress(frame.bodies);
    this.pose(frame, camera);
    painter.begin(frame.background);
    this.drawFloor(frame);
    painter.solid();
    painter.draw("lit", this.bodies);
    this.drawLights(frame);
    painter.glass();
    painter.draw("lettered", this.numbers);
    painter.panes(this.panes, GLASS);
    if (!frame.show.names) return;
    painter.onFloor();
    painter.draw("sign", this.signs);
  }

  /** Where everything is: written straight into the block of numbers that is sent. */
  pose(frame, camera) {
    const { block } = this.painter;
    camera.matrix(this.view);
    block.set(this.view, FAR_OFF.view);
    block.set(camera.eye(), FAR_OFF.eye);
    for (let index = 0; index < frame.poses.length; index++) {
      const at = FAR_OFF.models + 16 * (index + 1), pose = frame.poses[index], spin = frame.spins[index];
      if (spin) Maths.poseOfQuaternion(pose.x, pose.y, pose.z, spin, block, at);
      else Maths.pose(pose.x, pose.y, pose.z, pose.yaw, pose.tilt, block, at);
      block[FAR_OFF.shades + 4 * (index + 1)] = frame.failed.has(index) ? 0.7 : 0;
    }
  }

  /** Lights shine: their colours are not darkened by what they are turned to. */
  drawLights({ lights, poses }) {
    const mesh = new Mesh();
    for (const light of lights) {
      const entity = this.facts.entities[light.index], { x, y, z, yaw } = poses[light.index];
      const [ahead, left] = Bodies.light(entity, light), c = Math.cos(yaw), s = Math.sin(yaw);
      mesh.cylinder([x + c * ahead - s * left, y + s * ahead + c * left, z + entity.height_m / 2 + 0.002], LIGHT_M, 0.004, [0, 0, 1], light.colour);
    }
    this.painter.drawOnce(mesh, 1);
  }

  drawFloor(frame) {
    const { painter } = this;
    painter.onFloor();
    for (const { alpha, mesh } of this.ground) painter.draw("plain", mesh, alpha);
    if (frame.show !== this.shown || frame.heat.key !== this.heatKey) {
      this.shown = frame.show;
      this.heatKey = frame.heat.key;
      for (const { mesh } of this.marks) painter.forget(mesh);
      this.marks = this.layers([...frame.heat.shapes, ...Ground.marks(this.facts, frame.show)]);
    }
    for (const { alpha, mesh } of this.marks) painter.draw("plain", mesh, alpha);
    const gates = new Mesh();
    for (const { points, width, line } of Ground.movingMarks(this.facts, frame.show, frame.poses)) gates.line(points, width, line);
    painter.drawOnce(gates, GATE_OPACITY);
    for (const trail of frame.trails) {
      const mesh = new Mesh();
      for (const piece of trail.pieces) mesh.line(piece, trail.width, trail.colour);
      painter.drawOnce(mesh, TRAIL_OPACITY);
    }
    if (frame.show.shadows) painter.draw("shadow", this.shadows, SHADOW_OPACITY);
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

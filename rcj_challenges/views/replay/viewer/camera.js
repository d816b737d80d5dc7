// Where one looks from: an eye on a sphere around a target. Presets move it, robots and balls can lead it.

const VIEW_ANGLE = 0.5;
const NEAR = 0.02;
const FAR = 40;
const LOWEST = 0.04;
const CAPTION_PX = 64; // two lines of it, on a phone three of smaller letters
const BUTTONS_PX = 52; // one row of them
const MOST_BESIDE = 0.16;
const LOW_PX = 320; // a phone that lies: the field needs all of the height, captions and buttons may stand before it
const BESIDE_IF_LOW = 0.07;
const HIGHEST = Math.PI / 2 - 0.001;

class Camera {
  /** flat: the picture is a plan, so the eye is always above. */
  constructor(field, flat) {
    this.field = field;
    this.flat = flat;
    this.aspect = 1;
    this.below = this.above = 0.05;
    this.mode = "overview";
    this.fitted = true;
    this.robot = null;
    this.pose = { azimuth: Math.PI, elevation: 0.8, distance: 2, target: [0, 0, 0] };
    this.goal = null;
    this.offset = { azimuth: 0, elevation: 0.42, distance: 0.62 };
  }

  /** Portrait: the field stands upright on the screen; landscape: it lies. Blue is at the top or on the left. */
  get upright() {
    return this.aspect < 0.95;
  }

  /** buttonsPx: how far down from the upper edge buttons stand before the field. */
  resize(width, height, buttonsPx) {
    const wasUpright = this.upright;
    this.aspect = width / height;
    const most = height < LOW_PX ? BESIDE_IF_LOW : MOST_BESIDE;
    this.below = Math.min(most, CAPTION_PX / height);
    this.above = Math.min(buttonsPx > BUTTONS_PX ? 2 * most : most, buttonsPx / height);
    if (["overview", "top", "side"].includes(this.mode) && (this.fitted || wasUpright !== this.upright)) {
      this.preset(this.mode, false);
    }
  }

  /** Go to a preset: overview, top, side, ball, or robot (with its index). */
  preset(mode, glide = true, robot = null) {
    this.mode = mode;
    this.robot = robot;
    this.fitted = true;
    this.atOnce = !glide;
    if (mode === "robot") {
      this.offset = { azimuth: 0, elevation: 0.42, distance: 0.62 };
      this.goal = null;
      return;
    }
    const facing = this.upright ? -Math.PI / 2 : Math.PI;
    const elevation = this.flat ? HIGHEST : { overview: 0.82, top: HIGHEST, side: 0.3, ball: 0.7 }[mode];
    const next = { azimuth: facing, elevation, distance: 1.1, target: [0, 0, 0] };
    if (mode === "ball") next.target = [...this.pose.target];
    else this.fit(next);
    this.goal = glide ? next : null;
    if (!glide) this.pose = next;
  }

  /**
   * Set target and distance so that the whole field just fits into the picture. Along each of the picture's two axes
   * the two outermost corners touch its edges; the axis that needs more distance decides.
   */
  fit(pose) {
    const corners = this.outermost();
    const { azimuth, elevation } = pose;
    const right = [-Math.sin(azimuth), Math.cos(azimuth), 0];
    const forward = [-Math.cos(azimuth) * Math.cos(elevation), -Math.sin(azimuth) * Math.cos(elevation), -Math.sin(elevation)];
    const up = Maths.cross(right, forward);
    const open = Math.tan(VIEW_ANGLE / 2);
    // `before` and `beyond`: how far from the picture's middle they may come, as slopes; below there is room for a caption, above for buttons.
    const along = (axis, before, beyond) => {
      const reach = (side, slope) => Math.max(...corners.map((corner) => side * Maths.dot(corner, axis) - Maths.dot(corner, forward) * slope));
      const high = reach(1, beyond), low = reach(-1, before);
      return { distance: (high + low) / (before + beyond), middle: (away) => ((high - beyond * away) + (before * away - low)) / 2 };
    };
    const wide = open * this.aspect * 0.97;
    const across = along(right, wide, wide), upwards = along(up, open * (1 - 2 * this.below), open * (1 - 2 * this.above));
    const away = Math.max(across.distance, upwards.distance);
    const eye = [0, 1, 2].map((k) => right[k] * across.middle(away) + up[k] * upwards.middle(away) - forward[k] * away);
    pose.distance = eye[2] / -forward[2];
    pose.target = eye.map((part, k) => part + forward[k] * pose.distance);
  }

  /** Corners of the field and of its goals, at the floor and at the walls' tops. */
  outermost() {
    const x = this.field.width_m / 2 + 0.01, y = this.field.length_m / 2 + 0.01;
    const ends = [[x, y], [-x, y], [x, -y], [-x, -y]];
    for (const goal of this.field.goals) {
      const end = (goal.end === "positive_y" ? 1 : -1) * (y + goal.depth_m);
      ends.push([goal.width_m / 2, end], [-goal.width_m / 2, end]);
    }
    return ends.flatMap(([cx, cy]) => [0, this.field.wall_height_m].map((cz) => [cx, cy, cz]));
  }

  eye(pose = this.pose) {
    const flat = Math.cos(pose.elevation) * pose.distance;
    return [
      pose.target[0] + Math.cos(pose.azimuth) * flat,
      pose.target[1] + Math.sin(pose.azimuth) * flat,
      pose.target[2] + Math.sin(pose.elevation) * pose.distance,
    ];
  }

  matrix(out = new Float32Array(16)) {
    const projection = Maths.perspective(VIEW_ANGLE, this.aspect, NEAR, FAR);
    return Maths.multiply(projection, Maths.lookAt(this.eye(), this.pose.target, [0, 0, 1]), out);
  }

  orbit(right, up) {
    if (this.mode === "robot") {
      this.offset.azimuth -= right;
      this.offset.elevation = Maths.clamp(this.offset.elevation + up, LOWEST, HIGHEST);
      return;
    }
    this.goal = null;
    this.fitted = false;
    this.pose.azimuth -= right;
    this.pose.elevation = Maths.clamp(this.pose.elevation + up, LOWEST, HIGHEST);
    if (this.mode !== "ball") this.mode = "free";
  }

  /** Move the target along the floor by parts of the picture's height. */
  pan(right, up) {
    if (this.mode === "robot" || this.mode === "ball") this.mode = "free";
    this.goal = null;
    this.fitted = false;
    const { azimuth, elevation, distance, target } = this.pose;
    const scale = 2 * distance * Math.tan(VIEW_ANGLE / 2);
    const side = [-Math.sin(azimuth), Math.cos(azimuth)], ahead = [-Math.cos(azimuth), -Math.sin(azimuth)];
    const forward = (up * scale) / Math.max(0.35, Math.sin(elevation));
    const reach = Math.max(this.field.width_m, this.field.length_m);
    for (const axis of [0, 1]) {
      target[axis] = Maths.clamp(target[axis] - side[axis] * right * scale - ahead[axis] * forward, -reach, reach);
    }
    this.mode = "free";
  }

  zoom(factor) {
    if (this.mode === "robot") {
      this.offset.distance = Maths.clamp(this.offset.distance * factor, 0.15, 4);
      return;
    }
    this.fitted = false;
    if (this.goal) this.goal.distance = Maths.clamp(this.goal.distance * factor, 0.12, 12);
    this.pose.distance = Maths.clamp(this.pose.distance * factor, 0.12, 12);
  }

  /** Follow what leads, glide towards the preset. Returns whether the picture still changes by itself. */
  advance(seconds, leader, jumped) {
    const snap = jumped || this.atOnce;
    this.atOnce = false;
    if (this.mode === "robot" && leader) return this.followRobot(seconds, leader, snap);
    const share = snap ? 1 : 1 - Math.exp(-seconds * 9);
    if (this.mode === "ball" && leader) {
      const lead = [leader.x, leader.y, leader.z];
      if (this.goal) this.goal.target = lead;
      else this.pose.target = this.pose.target.map((part, axis) => Maths.mix(part, lead[axis], share));
    }
    if (!this.goal) return this.mode === "ball" && leader !== null && !this.near(this.pose.target, leader);
    const { pose, goal } = this;
    pose.azimuth += Maths.wrap(goal.azimuth - pose.azimuth) * share;
    pose.elevation = Maths.mix(pose.elevation, goal.elevation, share);
    pose.distance = Maths.mix(pose.distance, goal.distance, share);
    pose.target = pose.target.map((part, axis) => Maths.mix(part, goal.target[axis], share));
    const left = Math.abs(Maths.wrap(goal.azimuth - pose.azimuth)) + Math.abs(goal.distance - pose.distance);
    if (left < 1e-3 && Math.abs(goal.elevation - pose.elevation) < 1e-3) {
      this.pose = { ...goal, target: [...goal.target] };
      this.goal = null;
    }
    return true;
  }

  near(target, leader) {
    return Math.hypot(target[0] - leader.x, target[1] - leader.y, target[2] - leader.z) < 1e-3;
  }

  followRobot(seconds, robot, snap) {
    const share = snap ? 1 : 1 - Math.exp(-seconds * 7);
    const ahead = 0.16;
    const next = {
      azimuth: robot.yaw + Math.PI + this.offset.azimuth,
      elevation: this.offset.elevation,
      distance: this.offset.distance,
      target: [robot.x + Math.cos(robot.yaw) * ahead, robot.y + Math.sin(robot.yaw) * ahead, 0.03],
    };
    const turn = Maths.wrap(next.azimuth - this.pose.azimuth);
    const change = Math.abs(turn) + Math.abs(next.distance - this.pose.distance) + Math.abs(next.elevation - this.pose.elevation);
    this.pose.azimuth += turn * share;
    this.pose.elevation = Maths.mix(this.pose.elevation, next.elevation, share);
    this.pose.distance = Maths.mix(this.pose.distance, next.distance, share);
    this.pose.target = this.pose.target.map((part, axis) => Maths.mix(part, next.target[axis], share));
    return change > 1e-3 || !this.near(this.pose.target, { x: next.target[0], y: next.target[1], z: next.target[2] });
  }
}

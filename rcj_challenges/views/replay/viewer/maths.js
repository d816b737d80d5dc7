// Vectors, matrices (column-major, as WebGL wants them) and quaternions [x, y, z, w].

const Maths = {
  clamp: (value, least, most) => Math.min(most, Math.max(least, value)),

  mix: (from, to, share) => from + (to - from) * share,

  /** The same angle in (-pi, pi]. */
  wrap(angle) {
    const turned = angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
    return turned <= -Math.PI ? Math.PI : turned;
  },

  subtract: (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]],

  cross: (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]],

  dot: (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2],

  unit(a) {
    const length = Math.hypot(a[0], a[1], a[2]) || 1;
    return [a[0] / length, a[1] / length, a[2] / length];
  },

  multiply(a, b, out = new Float32Array(16)) {
    for (let column = 0; column < 4; column++) {
      for (let row = 0; row < 4; row++) {
        let sum = 0;
        for (let k = 0; k < 4; k++) sum += a[k * 4 + row] * b[column * 4 + k];
        out[column * 4 + row] = sum;
      }
    }
    return out;
  },

  perspective(verticalAngle, aspect, near, far) {
    const f = 1 / Math.tan(verticalAngle / 2);
    const range = 1 / (near - far);
    return new Float32Array([f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, (near + far) * range, -1, 0, 0, 2 * near * far * range, 0]);
  },

  /** From the world to an eye that looks at a target; `up` need not be at a right angle. */
  lookAt(eye, target, up) {
    const z = Maths.unit(Maths.subtract(eye, target));
    const x = Maths.unit(Maths.cross(up, z));
    const y = Maths.cross(z, x);
    return new Float32Array([
      x[0], y[0], z[0], 0, x[1], y[1], z[1], 0, x[2], y[2], z[2], 0,
      -Maths.dot(x, eye), -Maths.dot(y, eye), -Maths.dot(z, eye), 1,
    ]);
  },

  /** [x, y, z, w] of a point under a matrix, before the division by w. */
  transform(m, x, y, z) {
    return [
      m[0] * x + m[4] * y + m[8] * z + m[12],
      m[1] * x + m[5] * y + m[9] * z + m[13],
      m[2] * x + m[6] * y + m[10] * z + m[14],
      m[3] * x + m[7] * y + m[11] * z + m[15],
    ];
  },

  /**
   * A body's pose as a matrix: at (x, y, z), turned by yaw about z, then tilted by `tilt` about its own x axis. It is
   * written into `out` from `at` on, as all matrices that change with each picture.
   */
  pose(x, y, z, yaw, tilt, out, at) {
    const c = Math.cos(yaw), s = Math.sin(yaw), ct = Math.cos(tilt), st = Math.sin(tilt);
    Maths.column(out, at, c, s, 0, 0);
    Maths.column(out, at + 4, -s * ct, c * ct, st, 0);
    Maths.column(out, at + 8, s * st, -c * st, ct, 0);
    Maths.column(out, at + 12, x, y, z, 1);
  },

  /** A pose whose rotation is a unit quaternion. */
  poseOfQuaternion(x, y, z, q, out, at) {
    const i = q[0], j = q[1], k = q[2], w = q[3];
    Maths.column(out, at, 1 - 2 * (j * j + k * k), 2 * (i * j + k * w), 2 * (i * k - j * w), 0);
    Maths.column(out, at + 4, 2 * (i * j - k * w), 1 - 2 * (i * i + k * k), 2 * (j * k + i * w), 0);
    Maths.column(out, at + 8, 2 * (i * k + j * w), 2 * (j * k - i * w), 1 - 2 * (i * i + j * j), 0);
    Maths.column(out, at + 12, x, y, z, 1);
  },

  column(out, at, a, b, c, d) {
    out[at] = a;
    out[at + 1] = b;
    out[at + 2] = c;
    out[at + 3] = d;
  },
};

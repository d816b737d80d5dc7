// Shapes as triangles. A vertex is position, normal, colour, a place in the atlas of numbers, and the number of the body
// that it belongs to; metres.

const VERTEX_PARTS = [3, 3, 3, 2, 1];
const FLOATS_PER_VERTEX = 12;

class Mesh {
  constructor() {
    this.numbers = [];
    this.vertices = 0;
  }

  triangle(points, normals, colour, places = null) {
    points.forEach((point, index) => {
      const place = places ? places[index] : [0, 0];
      this.numbers.push(...point, ...normals[index], ...colour, ...place, 0);
    });
    this.vertices += 3;
    return this;
  }

  /** Take in another mesh, as a part of a body. */
  join(other, body = 0) {
    for (let at = 0; at < other.numbers.length; at++) {
      this.numbers.push(at % FLOATS_PER_VERTEX === FLOATS_PER_VERTEX - 1 ? body : other.numbers[at]);
    }
    this.vertices += other.vertices;
    return this;
  }

  /** Four corners, counter-clockwise seen from outside. */
  quad(a, b, c, d, colour, places = null) {
    const normal = Maths.unit(Maths.cross(Maths.subtract(b, a), Maths.subtract(c, a)));
    const normals = [normal, normal, normal];
    const [pa, pb, pc, pd] = places || [[0, 0], [0, 0], [0, 0], [0, 0]];
    this.triangle([a, b, c], normals, colour, [pa, pb, pc]);
    return this.triangle([a, c, d], normals, colour, [pa, pc, pd]);
  }

  /** A box with its own x along (c, s); `faces` may colour its top, bottom, front, back and sides. */
  box(centre, size, yaw, colour, faces = {}) {
    const [hx, hy, hz] = size.map((length) => length / 2);
    const c = Math.cos(yaw), s = Math.sin(yaw);
    const at = (x, y, z) => [centre[0] + c * x - s * y, centre[1] + s * x + c * y, centre[2] + z];
    const paint = (face) => faces[face] || colour;
    this.quad(at(-hx, -hy, hz), at(hx, -hy, hz), at(hx, hy, hz), at(-hx, hy, hz), paint("top"));
    this.quad(at(hx, -hy, -hz), at(hx, hy, -hz), at(hx, hy, hz), at(hx, -hy, hz), paint("front"));
    this.quad(at(-hx, hy, -hz), at(-hx, -hy, -hz), at(-hx, -hy, hz), at(-hx, hy, hz), paint("back"));
    this.quad(at(hx, hy, -hz), at(-hx, hy, -hz), at(-hx, hy, hz), at(hx, hy, hz), paint("side"));
    this.quad(at(-hx, -hy, -hz), at(hx, -hy, -hz), at(hx, -hy, hz), at(-hx, -hy, hz), paint("side"));
    return this.quad(at(-hx, hy, -hz), at(hx, hy, -hz), at(hx, -hy, -hz), at(-hx, -hy, -hz), paint("bottom"));
  }

  /** An upright prism over a convex outline; `face` returns a side's colour by its normal. It has no bottom. */
  prism(outline, low, high, face, lid) {
    outline.forEach(([x0, y0], index) => {
      const [x1, y1] = outline[(index + 1) % outline.length];
      this.quad([x0, y0, low], [x1, y1, low], [x1, y1, high], [x0, y0, high], face(Maths.unit([y1 - y0, x0 - x1, 0])));
    });
    return this.floor(outline, lid, high);
  }

  /** A wall that stands on the floor between two points. */
  wall(from, to, thickness, height, colour, faces = {}) {
    const dx = to[0] - from[0], dy = to[1] - from[1];
    const centre = [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2, height / 2];
    return this.box(centre, [Math.hypot(dx, dy), thickness, height], Math.atan2(dy, dx), colour, faces);
  }

  /** A cylinder along a level or upright axis around a centre, with a light spoke so that turning can be seen. */
  cylinder(centre, radius, length, axis, colour, cap = colour, parts = 16) {
    const first = axis[2] ? [1, 0, 0] : [axis[1], -axis[0], 0], second = Maths.cross(axis, first);
    const at = (angle, along) => {
      const a = radius * Math.cos(angle), b = radius * Math.sin(angle);
      return [0, 1, 2].map((k) => centre[k] + a * first[k] + b * second[k] + along * axis[k]);
    };
    const outward = (angle) => Maths.unit(Maths.subtract(at(angle, 0), centre));
    const h = length / 2;
    const end = axis, other = end.map((part) => -part);
    const tip = end.map((part, k) => centre[k] + part * h), tail = end.map((part, k) => centre[k] - part * h);
    for (let part = 0; part < parts; part++) {
      const a = (2 * Math.PI * part) / parts, b = (2 * Math.PI * (part + 1)) / parts;
      const na = outward(a), nb = outward(b);
      this.triangle([at(a, -h), at(b, -h), at(b, h)], [na, nb, nb], colour);
      this.triangle([at(a, -h), at(b, h), at(a, h)], [na, nb, na], colour);
      this.triangle([tip, at(a, h), at(b, h)], [end, end, end], cap);
      this.triangle([tail, at(b, -h), at(a, -h)], [other, other, other], cap);
    }
    return this;
  }

  /** A ball whose eight octants change colour, so that rolling can be seen. */
  sphere(radius, colours, rings = 12, parts = 20) {
    const at = (ring, part) => {
      const polar = (Math.PI * ring) / rings, round = (2 * Math.PI * part) / parts;
      return [Math.sin(polar) * Math.cos(round), Math.sin(polar) * Math.sin(round), Math.cos(polar)];
    };
    const grown = (normal) => normal.map((number) => number * radius);
    for (let ring = 0; ring < rings; ring++) {
      for (let part = 0; part < parts; part++) {
        const a = at(ring, part), b = at(ring + 1, part), c = at(ring + 1, part + 1), d = at(ring, part + 1);
        const colour = colours[(Math.floor((part * 4) / parts) + (ring * 2 < rings ? 0 : 1)) % 2];
        if (ring > 0) this.triangle([a, c, d].map(grown), [a, c, d], colour);
        this.triangle([a, b, c].map(grown), [a, b, c], colour);
      }
    }
    return this;
  }

  /** A flat polygon on the floor, given by its corners; convex, or cut into triangles by ears. */
  floor(points, colour, z = 0) {
    const up = [[0, 0, 1], [0, 0, 1], [0, 0, 1]];
    for (const corners of Mesh.ears(points)) this.triangle(corners.map(([x, y]) => [x, y, z]), up, colour);
    return this;
  }

  /** A line of a width on the floor, through points; closed if it is an outline. */
  line(points, width, colour, closed = false, z = 0) {
    const all = closed ? [...points, points[0]] : points;
    for (let index = 1; index < all.length; index++) {
      const [x0, y0] = all[index - 1], [x1, y1] = all[index];
      const length = Math.hypot(x1 - x0, y1 - y0);
      if (length < 1e-6) continue;
      const ux = ((x1 - x0) / length) * (width / 2), uy = ((y1 - y0) / length) * (width / 2);
      this.quad(
        [x0 - ux + uy, y0 - uy - ux, z], [x1 + ux + uy, y1 + uy - ux, z],
        [x1 + ux - uy, y1 + uy + ux, z], [x0 - ux - uy, y0 - uy + ux, z], colour,
      );
    }
    return this;
  }

  static circle(x, y, radius, parts = 48) {
    return Array.from({ length: parts }, (_, part) => {
      const angle = (2 * Math.PI * part) / parts;
      return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)];
    });
  }

  /** Cut a simple polygon into triangles. */
  static ears(points) {
    const area = points.reduce((sum, [x, y], index) => {
      const [nextX, nextY] = points[(index + 1) % points.length];
      return sum + x * nextY - nextX * y;
    }, 0);
    const rest = area < 0 ? [...points].reverse() : [...points];
    const side = (a, b, p) => (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
    const triangles = [];
    let tries = 0;
    while (rest.length > 3 && tries < rest.length) {
      const [a, b, c] = [rest[rest.length - 1], rest[0], rest[1]];
      const others = rest.slice(2, -1);
      const inside = (p) => side(a, b, p) >= 0 && side(b, c, p) >= 0 && side(c, a, p) >= 0;
      if (side(a, b, c) > 0 && !others.some(inside)) {
        triangles.push([a, b, c]);
        rest.shift();
        tries = 0;
      } else {
        rest.push(rest.shift());
        tries += 1;
      }
    }
    if (rest.length === 3) triangles.push(rest);
    return triangles;
  }

  data() {
    return new Float32Array(this.numbers);
  }

  /** The same with each vertex once, and the order in which the triangles use them: half as many to compute. */
  indexed() {
    const known = new Map(), corners = [], order = new Uint32Array(this.vertices);
    for (let vertex = 0; vertex < this.vertices; vertex++) {
      const numbers = this.numbers.slice(vertex * FLOATS_PER_VERTEX, (vertex + 1) * FLOATS_PER_VERTEX);
      const key = numbers.join();
      if (!known.has(key)) {
        known.set(key, known.size);
        corners.push(...numbers);
      }
      order[vertex] = known.get(key);
    }
    return { corners: new Float32Array(corners), order };
  }
}

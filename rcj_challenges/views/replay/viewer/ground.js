// What lies flat on the floor, as polygons and lines: the same list is drawn in 3-D and on a plain canvas.
// Each shape is {points, fill, alpha} or {points, line, width, closed, alpha}; colours [red, green, blue].

const STRIPES = 8;
const FORWARD_M = 0.05;
const SPOT_M = 0.012;
const GATE_OPACITY = 0.95;
const MARK_HUES = [310, 175, 20, 275, 150, 340];

const Ground = {
  LINE_M: 0.008,

  /** The floor itself: grass in stripes, lines of the scenario, goals' floors. */
  field(facts) {
    const { width_m: width, length_m: length, corner_cut_m: cut } = facts.field;
    const x = width / 2, y = length / 2, floor = Ground.floor(facts.field);
    const shapes = [];
    const [right, top] = floor, deep = (2 * top) / STRIPES;
    for (let stripe = 0; stripe < STRIPES; stripe++) {
      const band = Ground.rectangle(-right, -top + stripe * deep, right, -top + (stripe + 1) * deep);
      shapes.push({ points: Ground.within(band, ...floor, cut), fill: PALETTE.grass[(stripe + 1) % 2], alpha: 1 });
    }
    for (const goal of facts.field.goals) {
      const colour = Colours.mix(Colours.rgb(goal.colour), [0.1, 0.2, 0.15], 0.35);
      shapes.push({ points: Ground.goalFloor(facts.field, goal), fill: colour, alpha: 1 });
    }
    const line = (points, closed = false, colour = PALETTE.line) =>
      shapes.push({ points, line: colour, width: Ground.LINE_M, closed, alpha: 1 });
    line(Ground.outline(x - 0.006, y - 0.006, cut), true);
    if (facts.field.goals.length) line([[-x, 0], [x, 0]]);
    for (const zone of facts.zones) {
      const colour = zone.colour ? Colours.rgb(zone.colour) : PALETTE.line;
      if (zone.drawn) line(Ground.within(Ground.zone(zone, facts.field), ...floor, cut), true, colour);
    }
    for (const spot of facts.spots) {
      if (spot.drawn) shapes.push({ points: Ground.dot(spot), fill: spot.colour ? Colours.rgb(spot.colour) : PALETTE.line, alpha: 1 });
    }
    return shapes;
  },

  /** Zones, gates that stand still and spots, which a spectator may switch on. */
  marks(facts, shown) {
    const shapes = [];
    if (shown.zones) {
      facts.zones.forEach((zone, index) => {
        if (zone.anchor !== null) return;
        const points = Ground.zone(zone, facts.field);
        const colour = zone.colour ? Colours.rgb(zone.colour) : Ground.markColour(index);
        if (!zone.inverted) shapes.push({ points, fill: colour, alpha: 0.16 });
        shapes.push({ points, line: colour, width: 0.007, closed: true, alpha: 0.95 });
      });
    }
    if (shown.gates) for (const gate of facts.gates) if (gate.anchor === null) shapes.push(...Ground.gate(gate));
    if (shown.spots) {
      for (const spot of facts.spots) {
        shapes.push({ points: Ground.dot(spot), fill: PALETTE.spot, alpha: 0.9 });
        shapes.push({ points: Ground.dot(spot), line: PALETTE.mark, width: 0.004, closed: true, alpha: 0.9 });
      }
    }
    return shapes;
  },

  /** Circles and gates that move with an entity, where it is now. */
  movingMarks(facts, shown, poses) {
    const moving = (things) => things.filter((thing) => thing.anchor !== null);
    const gates = shown.gates ? moving(facts.gates).flatMap((gate) => Ground.gate(Ground.moved(gate, poses))) : [];
    const circles = (shown.zones ? moving(facts.zones) : []).map((zone) => {
      const points = Mesh.circle(...Ground.beside(poses[zone.anchor], zone.centre_m), zone.radius_m);
      const line = zone.colour ? Colours.rgb(zone.colour) : Ground.markColour(facts.zones.indexOf(zone));
      return { points: [...points, points[0]], line, width: 0.007, closed: false, alpha: 0.95 };
    });
    return [...circles, ...gates];
  },

  dot: ({ x_m, y_m }) => Mesh.circle(x_m, y_m, SPOT_M, 20),

  /** A point in the frame of something that moves, x ahead and y to its left, as a point of the field. */
  beside({ x: x0, y: y0, yaw }, [x, y]) {
    const c = Math.cos(yaw), s = Math.sin(yaw);
    return [x0 + c * x - s * y, y0 + s * x + c * y];
  },

  gate(gate) {
    return [[gate.from_m, gate.to_m], Ground.forward(gate)].map(
      (points) => ({ points, line: PALETTE.gate, width: 0.012, closed: false, alpha: GATE_OPACITY }),
    );
  },

  /** A gate with its posts on the field. */
  moved(gate, poses) {
    if (gate.anchor === null) return gate;
    const [from_m, to_m] = [gate.from_m, gate.to_m].map((post) => Ground.beside(poses[gate.anchor], post));
    return { ...gate, from_m, to_m };
  },

  /** Names of what is shown, and where they stand: `at(poses)` of all that moves. */
  names(facts, shown) {
    const middle = (points) => [0, 1].map((axis) => {
      const numbers = points.map((point) => point[axis]);
      return (Math.min(...numbers) + Math.max(...numbers)) / 2;
    });
    const names = [];
    if (shown.zones) {
      for (const zone of facts.zones) {
        const text = zone.inverted ? `outside ${zone.name}` : zone.name, at = middle(Ground.zone(zone, facts.field));
        const moves = zone.anchor !== null;
        names.push({ text, moves, at: (poses) => (moves ? Ground.beside(poses[zone.anchor], at) : at), below: true });
      }
    }
    if (shown.gates) {
      for (const gate of facts.gates) {
        const end = Ground.outerEnd(gate); // the same one always: a name does not jump while its gate moves
        names.push({ text: gate.name, moves: gate.anchor !== null, at: (poses) => Ground.moved(gate, poses)[end] });
      }
    }
    if (shown.spots) for (const spot of facts.spots) names.push({ text: spot.name, at: () => [spot.x_m, spot.y_m] });
    return names;
  },

  /** A short mark from a gate's middle to where forward is, as in the drawing. */
  forward({ from_m: [x0, y0], to_m: [x1, y1] }) {
    const length = Math.hypot(x1 - x0, y1 - y0) || 1, x = (x0 + x1) / 2, y = (y0 + y1) / 2;
    return [[x, y], [x - (FORWARD_M * (y1 - y0)) / length, y + (FORWARD_M * (x1 - x0)) / length]];
  },

  /** The post at which a gate's name stands: the one farther from the field's middle, where it hides no robot. */
  outerEnd({ from_m, to_m }) {
    return Math.hypot(...from_m) > Math.hypot(...to_m) ? "from_m" : "to_m";
  },

  /** Of a zone without a colour and an owner: none that could be taken for that of a team. */
  markColour: (index) => Colours.rgb(`hsl(${MARK_HUES[index % MARK_HUES.length]} 85% 70%)`),

  rectangle: (x0, y0, x1, y1) => [[x0, y0], [x1, y0], [x1, y1], [x0, y1]],

  /** The field's inner edge: a rectangle whose corners are cut off. */
  outline(x, y, cut) {
    if (cut <= 0) return Ground.rectangle(-x, -y, x, y);
    return [
      [-x + cut, -y], [x - cut, -y], [x, -y + cut], [x, y - cut], [x - cut, y], [-x + cut, y], [-x, y - cut], [-x, -y + cut],
    ];
  },

  /** How far the floor reaches along x and y: without walls beyond the field. */
  floor: (field) => field.floor_m ?? [field.width_m / 2, field.length_m / 2],

  goalFloor(field, goal) {
    const side = goal.end === "positive_y" ? 1 : -1;
    const edge = (field.length_m / 2) * side, half = goal.width_m / 2;
    return Ground.rectangle(-half, Math.min(edge, edge + side * goal.depth_m), half, Math.max(edge, edge + side * goal.depth_m));
  },

  /** A zone's outline. One with an open side ends where the floor does, as in the drawing; one that begins behind the floor a little outside. */
  zone(zone, field) {
    if (zone.shape === "circle") return Mesh.circle(...zone.centre_m, zone.radius_m);
    if (zone.shape === "polygon") return zone.points_m;
    const sides = [zone.x_min_m, zone.y_min_m, zone.x_max_m, zone.y_max_m];
    if (zone.shape === "rect" && sides.every((side) => side !== null)) return Ground.rectangle(...sides);
    const whole = Ground.openZone(zone, field);
    const inside = Ground.within(whole, ...Ground.floor(field), field.corner_cut_m);
    return inside.length > 2 ? inside : whole;
  },

  openZone(zone, field) {
    const [x, y] = Ground.floor(field).map((half) => half + 0.16);
    if (zone.shape === "half_plane") {
      const [nx, ny] = zone.normal, [px, py] = zone.through_m;
      return Ground.clipped(Ground.rectangle(-x, -y, x, y), nx, ny, nx * px + ny * py);
    }
    return Ground.rectangle(zone.x_min_m ?? -x, zone.y_min_m ?? -y, zone.x_max_m ?? x, zone.y_max_m ?? y);
  },

  /** The part of a convex polygon where nx·x + ny·y ≥ least. */
  clipped(points, nx, ny, least) {
    const kept = [];
    points.forEach((from, index) => {
      const to = points[(index + 1) % points.length];
      const a = nx * from[0] + ny * from[1] - least, b = nx * to[0] + ny * to[1] - least;
      if (a >= 0) kept.push(from);
      if (a >= 0 !== b >= 0) kept.push([0, 1].map((axis) => Maths.mix(from[axis], to[axis], a / (a - b))));
    });
    return kept;
  },

  within(points, x, y, cut) {
    let kept = points;
    for (const [nx, ny, least] of [[1, 0, -x], [-1, 0, -x], [0, 1, -y], [0, -1, -y]]) kept = Ground.clipped(kept, nx, ny, least);
    if (cut > 0) {
      for (const [nx, ny] of [[1, 1], [1, -1], [-1, 1], [-1, -1]]) kept = Ground.clipped(kept, nx, ny, cut - x - y);
    }
    return kept;
  },
};

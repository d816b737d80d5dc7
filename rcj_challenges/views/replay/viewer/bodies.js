// What stands or moves: robots, balls, obstacles, walls and goals, as meshes in their own frames.

const ATLAS_CELLS = 8;
const ATLAS_CELL_PIXELS = 128;
const SHADOW_M = 0.028;

const Bodies = {
  /** Numbers (and logos) of all robots in one picture; numbers black or white, whichever can be read on the robot. */
  atlas(entities, logos = []) {
    const canvas = document.createElement("canvas");
    canvas.width = canvas.height = ATLAS_CELLS * ATLAS_CELL_PIXELS;
    const pen = canvas.getContext("2d");
    pen.textAlign = "center";
    pen.textBaseline = "middle";
    entities.slice(0, ATLAS_CELLS * ATLAS_CELLS).forEach((entity, cell) => {
      if (entity.kind !== "robot") return;
      pen.fillStyle = Colours.onTop(Colours.rgb(entity.colour));
      const x = ((cell % ATLAS_CELLS) + 0.5) * ATLAS_CELL_PIXELS, top = Math.floor(cell / ATLAS_CELLS) * ATLAS_CELL_PIXELS;
      const logo = logos[cell];
      pen.font = `800 ${ATLAS_CELL_PIXELS * (logo ? 0.62 : 0.8)}px system-ui, "Segoe UI", Roboto, "Noto Sans", sans-serif`;
      pen.fillText(String(entity.number), x, top + ATLAS_CELL_PIXELS * (logo ? 0.26 : 0.54), ATLAS_CELL_PIXELS * 0.9);
      if (logo) Logos.draw(pen, logo, x, top + ATLAS_CELL_PIXELS * 0.76, ATLAS_CELL_PIXELS * 0.46);
    });
    return canvas;
  },

  /** The lid's number; its upper edge is towards the robot's front, so it reads well from behind. */
  number(entity, cell) {
    const half = entity.size_m * 0.3, top = entity.height_m / 2 + 0.0008;
    const x = cell % ATLAS_CELLS, y = Math.floor(cell / ATLAS_CELLS);
    const place = (column, row) => [(x + column) / ATLAS_CELLS, (y + row) / ATLAS_CELLS];
    const back = -half - 0.006 * entity.front, front = half - 0.006 * entity.front;
    const at = (along, left) => [along * entity.front, left * entity.front, top];
    return new Mesh().quad(
      at(back, half), at(back, -half), at(front, -half), at(front, half), [1, 1, 1],
      [place(0, 1), place(1, 1), place(1, 0), place(0, 0)],
    );
  },

  /** How far a robot's body reaches towards its front, beside its middle. */
  reach({ body, front }, y) {
    const crossings = body.map(([ax, ay], index) => {
      const [bx, by] = body[(index + 1) % body.length];
      return (ay - y) * (by - y) > 0 || ay === by ? -Infinity : front * (ax + ((bx - ax) * (y - ay)) / (by - ay));
    });
    return Math.max(...crossings);
  },

  robot(entity) {
    const colour = Colours.rgb(entity.colour);
    const size = entity.size_m, half = size / 2, top = entity.height_m / 2, low = entity.height_m * 0.36;
    const mesh = new Mesh();
    // A dark base, the team's colour above it, a lid with a bright arrow that shows the front.
    mesh.prism(entity.body, -top, low - top, () => PALETTE.dark, PALETTE.dark);
    const face = ([x]) => (x * entity.front > 0.9 ? Colours.mix(colour, PALETTE.dark, 0.55) : colour);
    for (const jaw of entity.jaws) mesh.prism(jaw, -top, top, () => PALETTE.dark, PALETTE.dark);
    mesh.prism(entity.body, low - top, top, face, Colours.mix(colour, [1, 1, 1], 0.08));
    const ahead = entity.front > 0 ? entity.front_m : half;
    const tip = (ahead - 0.002) * entity.front, foot = (ahead - 0.014) * entity.front, wide = 0.016 * entity.front;
    const z = top + 0.0007, up = [0, 0, 1];
    mesh.triangle([[tip, 0, z], [foot, wide, z], [foot, -wide, z]], [up, up, up], PALETTE.mark);
    for (const side of [-1, 1]) {
      mesh.box([(Bodies.reach(entity, side * size * 0.2) + 0.001) * entity.front, side * size * 0.2, entity.height_m * 0.14], [0.004, size * 0.15, size * 0.15], 0, [0.93, 0.96, 1]);
    }
    for (const { x_m, y_m, yaw_rad, radius_m, width_m } of entity.wheels) {
      const axle = [-Math.sin(yaw_rad), Math.cos(yaw_rad), 0];
      mesh.cylinder([x_m, y_m, radius_m - top - 0.0001], radius_m, width_m, axle, [0.07, 0.07, 0.08], [0.24, 0.26, 0.29]);
    }
    return mesh;
  },

  /** Where one of a robot's lights is, in its frame: in a row behind its number. */
  light(entity, { at, of }) {
    return [-0.44 * entity.size_m * entity.front, (((of - 1) / 2 - at) * 0.16 * entity.size_m) * entity.front];
  },

  ball(entity) {
    const colour = Colours.rgb(entity.colour);
    return new Mesh().sphere(entity.radius_m, [colour, Colours.mix(colour, [1, 1, 1], 0.55)]);
  },

  obstacle(entity) {
    const colour = Colours.rgb(entity.colour);
    const height = entity.height_m;
    if (entity.shape === "cylinder") return new Mesh().cylinder([0, 0, 0], entity.radius_m, height, [0, 0, 1], colour, Colours.mix(colour, [1, 1, 1], 0.25));
    return new Mesh().box([0, 0, 0], [...entity.size_m, height], 0, colour, { top: Colours.mix(colour, [1, 1, 1], 0.25) });
  },

  /** A soft shadow on the floor under a body: darkest below it, gone a little outside of its outline. */
  shadow({ size_m: size, radius_m: radius, shape }) {
    const [half_x, half_y] = radius || shape === "cylinder" ? [0, 0] : [].concat(size, size).map((length) => length / 2 - SHADOW_M / 3);
    return Bodies.blob([0, 0], 0, half_x, half_y, SHADOW_M + (radius || 0));
  },

  /** A rectangle with a border in which the shadow fades; the shader finds the extent in the place of the normal. */
  blob([x, y], yaw, half_x, half_y, border) {
    const reach_x = half_x + border, reach_y = half_y + border, c = Math.cos(yaw), s = Math.sin(yaw);
    const places = [[-reach_x, -reach_y], [reach_x, -reach_y], [reach_x, reach_y], [-reach_x, reach_y]];
    const at = places.map(([u, v]) => [x + c * u - s * v, y + s * u + c * v, 0]), extent = [half_x, half_y, border];
    const mesh = new Mesh();
    for (const corners of [[0, 1, 2], [0, 2, 3]]) {
      mesh.triangle(corners.map((one) => at[one]), [extent, extent, extent], [0, 0, 0], corners.map((one) => places[one]));
    }
    return mesh;
  },

  /** Shadows of obstacles that cannot move. */
  fixedShadows(facts) {
    const mesh = new Mesh();
    for (const thing of facts.fixed) {
      if (thing.shape !== "wall") {
        const [x, y] = thing.shape === "box" ? thing.size_m.map((length) => length / 2) : [0, 0];
        mesh.join(Bodies.blob(thing.centre_m, thing.yaw_rad || 0, x, y, SHADOW_M + (thing.radius_m || 0)));
        continue;
      }
      const dx = thing.to_m[0] - thing.from_m[0], dy = thing.to_m[1] - thing.from_m[1];
      const middle = [0, 1].map((axis) => (thing.from_m[axis] + thing.to_m[axis]) / 2);
      mesh.join(Bodies.blob(middle, Math.atan2(dy, dx), Math.hypot(dx, dy) / 2, thing.thickness_m / 2, SHADOW_M));
    }
    return mesh;
  },

  of(entity) {
    if (entity.kind === "robot") return Bodies.robot(entity);
    return entity.kind === "ball" ? Bodies.ball(entity) : Bodies.obstacle(entity);
  },

  /** Obstacles that cannot move. */
  fixed(facts) {
    const mesh = new Mesh();
    for (const thing of facts.fixed) {
      const colour = Colours.rgb(thing.colour), top = { top: Colours.mix(colour, [1, 1, 1], 0.25) };
      if (thing.shape === "wall") mesh.wall(thing.from_m, thing.to_m, thing.thickness_m, thing.height_m, colour, top);
      else if (thing.shape === "box") mesh.box([...thing.centre_m, thing.height_m / 2], [...thing.size_m, thing.height_m], thing.yaw_rad, colour, top);
      else mesh.cylinder([...thing.centre_m, thing.height_m / 2], thing.radius_m, thing.height_m, [0, 0, 1], colour, top.top);
    }
    return mesh;
  },

  /** The walls as {from, to, height, colour}: around the field with gaps for goals, and round the goals. */
  walls(field) {
    const x = field.width_m / 2, y = field.length_m / 2, cut = field.corner_cut_m, height = field.wall_height_m;
    const walls = [];
    if (field.floor_m) return walls;
    const add = (from, to, tall = height, colour = PALETTE.wall) => walls.push({ from, to, height: tall, colour });
    for (const side of [-1, 1]) {
      add([side * x, -y + cut], [side * x, y - cut]);
      if (cut > 0) for (const end of [-1, 1]) add([side * (x - cut), end * y], [side * x, end * (y - cut)]);
      const goals = field.goals.filter((goal) => (goal.end === "positive_y" ? 1 : -1) === side);
      if (!goals.length) add([-x + cut, side * y], [x - cut, side * y]);
      for (const goal of goals) {
        const half = goal.width_m / 2, back = side * (y + goal.depth_m), colour = Colours.rgb(goal.colour);
        add([-x + cut, side * y], [-half, side * y]);
        add([half, side * y], [x - cut, side * y]);
        add([-half, side * y], [-half, back], goal.wall_height_m, colour);
        add([half, side * y], [half, back], goal.wall_height_m, colour);
        add([-half, back], [half, back], goal.wall_height_m, colour);
      }
    }
    return walls;
  },

  /** Panes of glass, and the solid rim on top of them that shows where they stand. */
  wallMeshes(field) {
    const panes = new Mesh(), rims = new Mesh();
    for (const { from, to, height, colour } of Bodies.walls(field)) {
      const dx = to[0] - from[0], dy = to[1] - from[1];
      const middle = [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2];
      const length = Math.hypot(dx, dy), yaw = Math.atan2(dy, dx);
      const along = [dx / length, dy / length], across = [-along[1] * 0.004, along[0] * 0.004];
      for (const side of [-1, 1]) {
        const at = (end, z) => [...[0, 1].map((k) => middle[k] + side * (end * (length / 2 + 0.004) * along[k] - across[k])), z];
        panes.quad(at(-1, 0), at(1, 0), at(1, height), at(-1, height), colour);
      }
      rims.box([...middle, height], [length + 0.012, 0.012, 0.008], yaw, Colours.mix(colour, [1, 1, 1], 0.15));
    }
    return { panes, rims };
  },
};

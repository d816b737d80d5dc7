// WebGL 2, no more of it than this viewer needs. On a software GPU each call, each vertex and each instruction of a pixel
// counts, so: few large meshes, all poses in one block of numbers that is sent once a picture, light computed at corners.

const MOST_BODIES = 128;
const FAR_OFF = { view: 0, eye: 16, light: 20, screen: 24, lens: 28, models: 32, shades: 32 + 16 * MOST_BODIES };
const BLOCK_FLOATS = FAR_OFF.shades + 4 * MOST_BODIES;

// Each vertex belongs to a body; body 0 is what stands still. A model is its pose, shades.x how grey it is.
const VERTEX_HEAD = `#version 300 es
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 colour;
layout(location = 3) in vec2 place;
layout(location = 4) in float body;
layout(std140) uniform Now {
  mat4 view;
  vec4 eye;
  vec4 light;
  vec4 screen;  // width and height of the picture on the page, then in its own pixels
  vec4 lens;    // x: how much of half the picture's height a metre takes at a distance of one metre
  mat4 models[${MOST_BODIES}];
  vec4 shades[${MOST_BODIES}];
};
`;

const VERTEX_SHADERS = {
  plain: `
flat out vec3 paint;
void main() {
  paint = colour;
  gl_Position = view * vec4(position, 1.0);
}`,
  lit: `
out vec3 paint;
void main() {
  int b = int(body);
  vec4 world = models[b] * vec4(position, 1.0);
  vec3 n = normalize(mat3(models[b]) * normal);
  vec3 halfway = normalize(light.xyz + normalize(eye.xyz - world.xyz));
  float shine = pow(max(dot(n, halfway), 0.0), 40.0) * 0.18;
  // Shade is never deep: a dark yellow is an olive green.
  paint = mix(colour, vec3(0.45, 0.46, 0.5), shades[b].x) * (0.78 + 0.02 * n.z + 0.28 * max(dot(n, light.xyz), 0.0)) + shine;
  gl_Position = view * world;
}`,
  // A blob under a body: it turns with it, and stays on the floor. The normal is its extent: half its sides, its border.
  shadow: `
out vec2 at;
flat out vec3 extent;
void main() {
  mat4 model = models[int(body)];
  vec2 ahead = length(normal.xy) > 0.0 ? normalize(model[0].xy + vec2(1e-6, 0.0)) : vec2(1.0, 0.0);
  vec2 offset = position.x * ahead + position.y * vec2(-ahead.y, ahead.x);
  at = place;
  extent = normal;
  gl_Position = view * vec4(model[3].xy + offset, 0.0, 1.0);
}`,
  lettered: `
out vec2 atlas;
void main() {
  atlas = place;
  gl_Position = view * models[int(body)] * vec4(position, 1.0);
}`,
  // Signs stand upright over a body, at a fixed size on the page: position is in its pixels, z how far above in m.
  sign: `
out vec2 atlas;
void main() {
  atlas = place + vec2(0.0, shades[int(body)].x > 0.0 ? 0.5 : 0.0);
  vec4 at = view * models[int(body)] * vec4(0.0, 0.0, 0.0, 1.0);
  at.y += position.z * lens.x;
  vec2 pixel = floor((at.xy / at.w * 0.5 + 0.5) * screen.zw + 0.5) + floor(position.xy / screen.xy * screen.zw + 0.5);
  at.xy = (pixel / screen.zw * 2.0 - 1.0) * at.w;
  gl_Position = at;
}`,
};

const PAINTED = `#version 300 es
precision mediump float;
in vec3 paint;
uniform float opacity;
out vec4 pixel;
void main() {
  pixel = vec4(paint * opacity, opacity);
}`;

const FLAT = PAINTED.replace("in vec3 paint", "flat in vec3 paint");

const SHADED = `#version 300 es
precision mediump float;
in vec2 at;
flat in vec3 extent;
uniform float opacity;
out vec4 pixel;
void main() {
  float away = length(max(abs(at) - extent.xy, 0.0)) / extent.z;
  float left = 1.0 - min(away, 1.0);
  pixel = vec4(0.0, 0.0, 0.0, opacity * left * left);
}`;

const WRITTEN = `#version 300 es
precision mediump float;
in vec2 atlas;
uniform sampler2D letters;
out vec4 pixel;
void main() {
  pixel = texture(letters, atlas);
}`;

const PIXEL_SHADERS = { plain: FLAT, lit: PAINTED, shadow: SHADED, lettered: WRITTEN, sign: WRITTEN };
const TEXTURES = { lettered: 0, sign: 1 };

class Painter {
  /** Throws if there is no WebGL 2. */
  constructor(canvas) {
    // Smooth edges cost a software GPU four times the work: it gets none, so that motion is smooth instead.
    this.software = Painter.drawsInSoftware();
    const gl = canvas.getContext("webgl2", { antialias: !this.software, alpha: false, powerPreference: "low-power" });
    if (!gl) throw new Error("no WebGL 2");
    this.gl = gl;
    this.block = new Float32Array(BLOCK_FLOATS);
    this.buffer = gl.createBuffer();
    gl.bindBufferBase(gl.UNIFORM_BUFFER, 0, this.buffer);
    gl.bufferData(gl.UNIFORM_BUFFER, this.block.byteLength, gl.DYNAMIC_DRAW);
    this.programs = Object.fromEntries(Object.keys(VERTEX_SHADERS).map((way) => [way, this.build(way)]));
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    this.changing = this.room();
    this.textures = [];
  }

  /** Whether WebGL is computed by the processor, as far as the browser reports it. */
  static drawsInSoftware() {
    const gl = document.createElement("canvas").getContext("webgl2");
    let name = gl ? String(gl.getParameter(gl.RENDERER)) : "";
    // Chromium and Safari report it only by an extension; Firefox does directly, and is about to drop the extension.
    const info = /^webkit/i.test(name) && gl.getExtension("WEBGL_debug_renderer_info");
    if (info) name = String(gl.getParameter(info.UNMASKED_RENDERER_WEBGL));
    gl?.getExtension("WEBGL_lose_context")?.loseContext();
    return /swiftshader|llvmpipe|software|basic render/i.test(name);
  }

  build(way) {
    const gl = this.gl;
    const program = gl.createProgram();
    for (const [kind, source] of [[gl.VERTEX_SHADER, VERTEX_HEAD + VERTEX_SHADERS[way]], [gl.FRAGMENT_SHADER, PIXEL_SHADERS[way]]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program) || "no shader");
    gl.uniformBlockBinding(program, gl.getUniformBlockIndex(program, "Now"), 0);
    gl.useProgram(program);
    if (way in TEXTURES) gl.uniform1i(gl.getUniformLocation(program, "letters"), TEXTURES[way]);
    return { program, opacity: gl.getUniformLocation(program, "opacity"), was: null };
  }

  /** Room for vertices, in the order of their triangles. */
  room() {
    const gl = this.gl;
    const array = gl.createVertexArray(), buffer = gl.createBuffer();
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    let first = 0;
    VERTEX_PARTS.forEach((size, location) => {
      gl.enableVertexAttribArray(location);
      gl.vertexAttribPointer(location, size, gl.FLOAT, false, FLOATS_PER_VERTEX * 4, first * 4);
      first += size;
    });
    return { array, buffer, order: null, vertices: 0 };
  }

  /** Take over a mesh that is drawn in every picture from now on. */
  upload(mesh) {
    const gl = this.gl, room = this.room(), { corners, order } = mesh.indexed();
    gl.bufferData(gl.ARRAY_BUFFER, corners, gl.STATIC_DRAW);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, (room.order = gl.createBuffer()));
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, order, gl.STATIC_DRAW);
    return { ...room, vertices: mesh.vertices };
  }

  forget(mesh) {
    this.gl.deleteVertexArray(mesh.array);
    this.gl.deleteBuffer(mesh.buffer);
    this.gl.deleteBuffer(mesh.order);
  }

  /** Draw a mesh that is thrown away afterwards. */
  drawOnce(mesh, opacity) {
    if (!mesh.vertices) return;
    const gl = this.gl;
    gl.bindBuffer(gl.ARRAY_BUFFER, this.changing.buffer);
    gl.bufferData(gl.ARRAY_BUFFER, mesh.data(), gl.DYNAMIC_DRAW);
    this.changing.vertices = mesh.vertices;
    this.draw("plain", this.changing, opacity);
  }

  /** Use a picture as what is written in one of the ways that write: `lettered` or `sign`. */
  useLetters(canvas, way = "lettered") {
    const gl = this.gl, unit = TEXTURES[way];
    if (this.textures[unit]) gl.deleteTexture(this.textures[unit]);
    this.textures[unit] = gl.createTexture();
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(gl.TEXTURE_2D, this.textures[unit]);
    gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, true); // else the black of what is empty darkens small letters
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, gl.RGBA, gl.UNSIGNED_BYTE, canvas);
    gl.generateMipmap(gl.TEXTURE_2D);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, way === "sign" ? gl.LINEAR : gl.LINEAR_MIPMAP_LINEAR);
  }

  /** Begin a picture: `block` says all that is different from the last. */
  begin(background) {
    const gl = this.gl;
    gl.bufferSubData(gl.UNIFORM_BUFFER, 0, this.block);
    gl.viewport(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight);
    gl.clearColor(background[0], background[1], background[2], 1);
    gl.depthMask(true);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  }

  /** What lies on the floor: painted in order, nothing can hide it but what stands. */
  onFloor() {
    this.gl.disable(this.gl.DEPTH_TEST);
    this.gl.disable(this.gl.CULL_FACE);
  }

  solid() {
    this.gl.enable(this.gl.CULL_FACE);
    this.gl.enable(this.gl.DEPTH_TEST);
  }

  /** What one can see through: drawn last, hides nothing. */
  glass() {
    this.gl.depthMask(false);
  }

  /** Panes of glass: of several behind each other only the nearest is mixed with what is behind, so once. */
  panes(mesh, opacity) {
    const gl = this.gl;
    gl.depthMask(true);
    gl.colorMask(false, false, false, false);
    this.draw("lit", mesh);
    gl.colorMask(true, true, true, true);
    gl.depthMask(false);
    gl.depthFunc(gl.EQUAL);
    this.draw("lit", mesh, opacity);
    gl.depthFunc(gl.LESS);
  }

  /** way: plain (its colours as they are), lit, shadow, lettered (numbers and logos) or sign (names). */
  draw(way, mesh, opacity = 1) {
    if (!mesh.vertices) return;
    const gl = this.gl, program = this.programs[way];
    gl.useProgram(program.program);
    if (program.opacity && program.was !== opacity) {
      program.was = opacity;
      gl.uniform1f(program.opacity, opacity);
    }
    if (opacity < 1 || way in TEXTURES) gl.enable(gl.BLEND);
    else gl.disable(gl.BLEND);
    gl.bindVertexArray(mesh.array);
    if (mesh.order) gl.drawElements(gl.TRIANGLES, mesh.vertices, gl.UNSIGNED_INT, 0);
    else gl.drawArrays(gl.TRIANGLES, 0, mesh.vertices);
  }
}

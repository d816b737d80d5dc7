// WebGL 2, no more of it than this viewer needs: one program, meshes, a few ways of laying one over another.

const VERTEX_SHADER = `#version 300 es
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 colour;
layout(location = 3) in vec2 place;
uniform mat4 view;
uniform mat4 model;
out vec3 worldNormal;
out vec3 worldPosition;
out vec3 paint;
out vec2 atlas;
void main() {
  vec4 world = model * vec4(position, 1.0);
  worldNormal = mat3(model) * normal;
  worldPosition = world.xyz;
  paint = colour;
  atlas = place;
  gl_Position = view * world;
}`;

// Three ways of painting, a program for each: on a software GPU every instruction of a pixel counts.
const PIXEL_HEAD = `#version 300 es
precision mediump float;
in vec3 worldNormal;
in vec3 worldPosition;
in vec3 paint;
in vec2 atlas;
uniform vec4 tint;       // rgb: mixed in by its share; a: opacity
uniform float tintShare;
uniform vec3 light;
uniform vec3 eye;
uniform sampler2D letters;
out vec4 pixel;
`;

const PIXEL_SHADERS = {
  plain: `${PIXEL_HEAD}
void main() {
  pixel = vec4(mix(paint, tint.rgb, tintShare) * tint.a, tint.a);
}`,
  lit: `${PIXEL_HEAD}
void main() {
  vec3 n = normalize(worldNormal);
  vec3 halfway = normalize(light + normalize(eye - worldPosition));
  float shine = pow(max(dot(n, halfway), 0.0), 40.0) * 0.18;
  vec3 colour = mix(paint, tint.rgb, tintShare) * (0.52 + 0.1 * n.z + 0.5 * max(dot(n, light), 0.0)) + shine;
  pixel = vec4(colour * tint.a, tint.a);
}`,
  lettered: `${PIXEL_HEAD}
void main() {
  vec4 ink = texture(letters, atlas);
  pixel = vec4(ink.rgb * ink.a, ink.a);
}`,
};

class Painter {
  /** Throws if there is no WebGL 2. */
  constructor(canvas) {
    // Smooth edges cost a software GPU four times the work: it gets none, so that motion is smooth instead.
    this.software = Painter.drawsInSoftware();
    const gl = canvas.getContext("webgl2", { antialias: !this.software, stencil: true, alpha: false, powerPreference: "low-power" });
    if (!gl) throw new Error("no WebGL 2");
    this.gl = gl;
    this.programs = Object.fromEntries(Object.entries(PIXEL_SHADERS).map(([way, source]) => [way, this.build(source)]));
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.enable(gl.CULL_FACE);
    this.changing = this.upload(new Mesh(), gl.DYNAMIC_DRAW);
  }

  /** Whether WebGL is computed by the processor, as far as the browser tells. */
  static drawsInSoftware() {
    const gl = document.createElement("canvas").getContext("webgl2");
    const info = gl?.getExtension("WEBGL_debug_renderer_info");
    const name = info ? String(gl.getParameter(info.UNMASKED_RENDERER_WEBGL)) : "";
    gl?.getExtension("WEBGL_lose_context")?.loseContext();
    return /swiftshader|llvmpipe|software|basic render/i.test(name);
  }

  /** A program, and the places of what it is told. */
  build(pixels) {
    const gl = this.gl;
    const program = gl.createProgram();
    for (const [kind, source] of [[gl.VERTEX_SHADER, VERTEX_SHADER], [gl.FRAGMENT_SHADER, pixels]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program) || "no shader");
    const names = ["view", "model", "tint", "tintShare", "light", "eye", "letters"];
    return { program, places: Object.fromEntries(names.map((name) => [name, gl.getUniformLocation(program, name)])) };
  }

  upload(mesh, usage = this.gl.STATIC_DRAW) {
    const gl = this.gl;
    const array = gl.createVertexArray(), buffer = gl.createBuffer();
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, mesh.data(), usage);
    let first = 0;
    [3, 3, 3, 2].forEach((size, location) => {
      gl.enableVertexAttribArray(location);
      gl.vertexAttribPointer(location, size, gl.FLOAT, false, FLOATS_PER_VERTEX * 4, first * 4);
      first += size;
    });
    return { array, buffer, vertices: mesh.vertices };
  }

  /** Draw a mesh that is thrown away afterwards. */
  drawOnce(mesh, model, style) {
    if (!mesh.vertices) return;
    const gl = this.gl;
    gl.bindBuffer(gl.ARRAY_BUFFER, this.changing.buffer);
    gl.bufferData(gl.ARRAY_BUFFER, mesh.data(), gl.DYNAMIC_DRAW);
    this.changing.vertices = mesh.vertices;
    this.draw(this.changing, model, style);
  }

  useLetters(canvas) {
    const gl = this.gl;
    gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
    gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, gl.RGBA, gl.UNSIGNED_BYTE, canvas);
    gl.generateMipmap(gl.TEXTURE_2D);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
  }

  begin(background, view, eye, light) {
    const gl = this.gl;
    gl.viewport(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight);
    gl.clearColor(...background, 1);
    gl.depthMask(true);
    gl.stencilMask(0xff);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT);
    for (const { program, places } of Object.values(this.programs)) {
      gl.useProgram(program);
      gl.uniformMatrix4fv(places.view, false, view);
      gl.uniform3fv(places.eye, eye);
      gl.uniform3fv(places.light, light);
    }
  }

  /** What lies on the floor: painted in order, nothing can hide it but what stands. */
  onFloor() {
    this.gl.disable(this.gl.DEPTH_TEST);
    this.gl.disable(this.gl.STENCIL_TEST);
  }

  /** Shadows: each spot of the floor is darkened once, however many things stand in its light. */
  shadows() {
    const gl = this.gl;
    gl.disable(gl.DEPTH_TEST);
    gl.disable(gl.CULL_FACE);
    gl.enable(gl.STENCIL_TEST);
    gl.stencilFunc(gl.EQUAL, 0, 0xff);
    gl.stencilOp(gl.KEEP, gl.KEEP, gl.INCR);
  }

  solid() {
    const gl = this.gl;
    gl.disable(gl.STENCIL_TEST);
    gl.enable(gl.CULL_FACE);
    gl.enable(gl.DEPTH_TEST);
    gl.depthMask(true);
  }

  /** What one can see through: drawn last, hides nothing. */
  glass() {
    this.gl.depthMask(false);
  }

  /** way: plain (its colours as they are), lit, or lettered (from the atlas of numbers). */
  draw(mesh, model, { way = "lit", tint = [0, 0, 0], share = 0, opacity = 1 } = {}) {
    const gl = this.gl;
    const { program, places } = this.programs[way];
    gl.useProgram(program);
    gl.uniformMatrix4fv(places.model, false, model);
    gl.uniform4f(places.tint, tint[0], tint[1], tint[2], opacity);
    gl.uniform1f(places.tintShare, share);
    if (opacity < 1 || way === "lettered") gl.enable(gl.BLEND);
    else gl.disable(gl.BLEND);
    gl.bindVertexArray(mesh.array);
    gl.drawArrays(gl.TRIANGLES, 0, mesh.vertices);
  }
}

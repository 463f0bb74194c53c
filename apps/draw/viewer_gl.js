// Drawing with WebGL2: triangles with their edges in one pass, thick lines, round points, spheres.
const canvas = document.getElementById("view");
const gl = canvas.getContext("webgl2", { antialias: true, alpha: false });
const cutting = "uniform vec4 cut; void trim(vec3 p) { if (dot(cut.xyz, p) + cut.w > 0.0) discard; }\n";
const head = "#version 300 es\nprecision highp float;\n";
function program(vertex, fragment) {
  const result = gl.createProgram();
  for (const [type, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, head + text);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
    gl.attachShader(result, shader);
  }
  gl.linkProgram(result);
  if (!gl.getProgramParameter(result, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(result));
  const places = {};
  for (let i = 0; i < gl.getProgramParameter(result, gl.ACTIVE_UNIFORMS); ++i) {
    const { name } = gl.getActiveUniform(result, i);
    places[name] = gl.getUniformLocation(result, name);
  }
  return { result, places };
}
function makePrograms() {
  const varying = (way) => `${way} vec3 p; ${way} vec4 c;`;
  return {
    cells: program(
      `layout(location=0) in vec3 position; layout(location=1) in vec4 colour; uniform mat4 all; ${varying("out")} out vec3 b;
      void main() { p = position; c = colour; int k = gl_VertexID % 3; b = vec3(k == 0, k == 1, k == 2); gl_Position = all * vec4(p, 1.0); }`,
      `${varying("in")} in vec3 b; uniform vec3 eye; uniform vec4 edge; uniform float fill; out vec4 o; ${cutting}
      void main() { trim(p);
        vec3 n = normalize(cross(dFdx(p), dFdy(p))); float light = 0.6 + 0.4 * abs(dot(n, normalize(eye - p)));
        vec3 w = fwidth(b); vec3 s = smoothstep(w * 0.3, w * 1.3, b); float line = 1.0 - min(s.x, min(s.y, s.z));
        line *= edge.a * (1.0 - smoothstep(0.12, 0.4, max(w.x, max(w.y, w.z))));
        o = vec4(mix(c.rgb * light, edge.rgb, fill > 0.0 ? line : 1.0), max(fill, line)); if (o.a < 0.01) discard; }`),
    lines: program(
      `layout(location=0) in vec3 from; layout(location=1) in vec3 to; uniform mat4 all; uniform vec2 screen; uniform float width, bias; out vec3 p;
      void main() { vec4 a = all * vec4(from, 1.0), z = all * vec4(to, 1.0); float near = 1e-6; vec3 f = from, t = to;
        if (a.w < near) { float s = (near - a.w) / (z.w - a.w); a = mix(a, z, s); f = mix(f, t, s); } else if (z.w < near) { float s = (near - z.w) / (a.w - z.w); z = mix(z, a, s); t = mix(t, f, s); }
        vec2 d = (z.xy / z.w - a.xy / a.w) * screen; d = length(d) > 0.0 ? normalize(d) : vec2(1.0, 0.0);
        bool end = gl_VertexID >= 2; float side = gl_VertexID % 2 == 0 ? -1.0 : 1.0; vec4 q = end ? z : a; p = end ? t : f;
        q.xy += vec2(-d.y, d.x) * side * width / screen * q.w; q.z -= bias * q.w; gl_Position = q; }`,
      `in vec3 p; uniform vec4 colour; out vec4 o; ${cutting} void main() { trim(p); o = colour; }`),
    points: program(
      `layout(location=0) in vec3 position; layout(location=1) in vec4 colour; uniform mat4 all; uniform float width, bias; ${varying("out")}
      void main() { p = position; c = colour; gl_Position = all * vec4(p, 1.0); gl_Position.z -= bias * gl_Position.w; gl_PointSize = width; }`,
      `${varying("in")} out vec4 o; ${cutting} void main() { trim(p); if (length(gl_PointCoord - 0.5) > 0.5) discard; o = c; }`),
    balls: program(
      `layout(location=0) in vec3 normal; layout(location=1) in vec4 ball; uniform mat4 all; out vec3 p; out vec3 n;
      void main() { n = normal; p = ball.xyz + ball.w * normal; gl_Position = all * vec4(p, 1.0); }`,
      `in vec3 p; in vec3 n; uniform vec3 eye; uniform vec4 colour; out vec4 o; ${cutting}
      void main() { trim(p); float rim = 1.0 - abs(dot(normalize(n), normalize(eye - p))); o = vec4(colour.rgb, colour.a * (0.12 + 0.88 * rim * rim * rim)); }`),
  };
}
function buffer(values, usage) {
  const result = gl.createBuffer();
  gl.bindBuffer(gl.ARRAY_BUFFER, result);
  gl.bufferData(gl.ARRAY_BUFFER, values, usage || gl.STATIC_DRAW);
  return result;
}
// attributes: [location, buffer, components, type, normalised, stride, offset, divisor]
function arrays(attributes) {
  const result = gl.createVertexArray();
  gl.bindVertexArray(result);
  for (const [location, source, count, type, normal, stride, offset, divisor] of attributes) {
    gl.bindBuffer(gl.ARRAY_BUFFER, source);
    gl.enableVertexAttribArray(location);
    gl.vertexAttribPointer(location, count, type || gl.FLOAT, normal || false, stride || 0, offset || 0);
    gl.vertexAttribDivisor(location, divisor || 0);
  }
  return result;
}
function lineArrays(ends) {
  const values = new Float32Array(3 * ends.length);
  for (let i = 0; i < ends.length; ++i) values.set(place.subarray(3 * ends[i], 3 * ends[i] + 3), 3 * i);
  return rawLines(values);
}
function rawLines(values) {
  const source = buffer(values);
  return { count: values.length / 6, source, array: arrays([[0, source, 3, gl.FLOAT, false, 24, 0, 1], [1, source, 3, gl.FLOAT, false, 24, 12, 1]]) };
}
function pointArrays(list, colours) {
  const positions = new Float32Array(3 * list.length), bytes = new Uint8Array(4 * list.length);
  list.forEach((p, i) => { positions.set(place.subarray(3 * p, 3 * p + 3), 3 * i); bytes.set(colours(p), 4 * i); });
  const sources = [buffer(positions), buffer(bytes)];
  return { count: list.length, sources, array: arrays([[0, sources[0], 3], [1, sources[1], 4, gl.UNSIGNED_BYTE, true]]) };
}
let sphereStrip = null;
const sphereCount = 36 * 18 * 6;
function ballArrays(balls) {
  if (!sphereStrip) {
    const values = [], around = (i, k) => { const u = (2 * Math.PI * i) / 36, v = (Math.PI * k) / 18; return [Math.sin(v) * Math.cos(u), Math.sin(v) * Math.sin(u), Math.cos(v)]; };
    for (let i = 0; i < 36; ++i) for (let k = 0; k < 18; ++k) for (const [x, y] of [[0, 0], [1, 0], [1, 1], [0, 0], [1, 1], [0, 1]]) values.push(...around(i + x, k + y));
    sphereStrip = buffer(new Float32Array(values));
  }
  const source = buffer(new Float32Array(balls));
  return { count: balls.length / 4, source, array: arrays([[0, sphereStrip, 3], [1, source, 4, gl.FLOAT, false, 0, 0, 1]]) };
}
function freeArrays(list) {
  if (!list) return;
  gl.deleteVertexArray(list.array);
  for (const source of list.sources || [list.source]) gl.deleteBuffer(source);
}

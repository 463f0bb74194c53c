// The viewer: camera, layers, colours, choosing, and what the panel says.
const $ = (id) => document.getElementById(id);
const number = (v, digits) => {
  if (!Number.isFinite(v)) return "none";
  return v !== 0 && Math.abs(v) < 1e-3 ? v.toExponential((digits || 6) - 1).replace(/\.?0+e/, "e") : String(Number(v.toPrecision(digits || 6)));
};
const dark = matchMedia("(prefers-color-scheme: dark)");
const rgb = (hex) => [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16));

// Okabe and Ito's colours for kinds, cividis for slack.
const kindColours = ["#e69f00", "#56b4e9", "#f0e442", "#b4b4b4"], badColour = "#d55e00";
const stageColours = ["#b4b4b4", "#f0e442", "#e69f00", "#56b4e9", "#009e73"];
const facetColours = ["#56b4e9", "#e69f00", "#009e73", "#f0e442", "#cc79a7", "#b4b4b4", "#7f9fd0", "#d8b070"];
const slackColours = ["#00224e", "#2a3f6d", "#575d6d", "#8a8779", "#c4b56c", "#fee838"].map(rgb);
const pointColours = { vertex: ["#000000", "#ffffff"], projection: ["#d55e00", "#ff9a55"], edge: ["#8f3f00", "#ffb080"], offset: ["#7a6a00", "#fff08a"], arc: ["#0072b2", "#7cc8ff"], interior: ["#3c3c3c", "#dcdcdc"] };
const layers = [
  ["cells", "cells", true, cellCount], ["edges", "edges of cells", true, cellCount], ["rest", "the other cells, faintly", true, null],
  ["segments", "input edges", true, lineSets.segments.length / 2], ["hanging", "hanging subsegments", false, lineSets.hanging.length / 2],
  ["rows", "edge protectors", false, data.rowCount], ["chew", "boundary of P″", false, lineSets.chew.length / 2],
  ["balls", "protecting spheres", false, ballVertex.length], ["vertices", "vertices", true, data.vertexCount], ["points", "Steiner points", false, pointCount - data.vertexCount],
  ["violations", "violated spheres", true, violated.size],
  ["witness", "witness of the refutation", true, data.witness.cells.length],
];
const state = { tightest: cellCount, colour: "kind", axis: "", cut: 0, flip: false, picked: -1, layers: Object.fromEntries(layers.map(([id, , on]) => [id, on])) };
const camera = { target: [0, 0, 0], distance: 3.4, turn: [[1, 0, 0], [0, 1, 0], [0, 0, 1]] };
let gpu = null, asked = false;

function colourOf(cell) {
  if (state.colour === "kind") return violated.has(cell) ? rgb(badColour) : rgb(kindColours[cellKind[cell]]);
  if (state.colour === "stage") return rgb(stageColours[stageOf(cell)]);
  if (state.colour === "facet") return rgb(facetColours[cellFacet[cell] % facetColours.length]);
  const lemma = lemmas.get(state.colour), [i, count] = lemma ? [lemma.places.get(cell), lemma.cells.length] : [rank[cell], cellCount];
  if (i === undefined) return [200, 200, 200];
  const t = count > 1 ? (i / (count - 1)) * (slackColours.length - 1) : 0, k = Math.min(Math.floor(t), slackColours.length - 2);
  return slackColours[k].map((v, j) => Math.round(v + (t - k) * (slackColours[k + 1][j] - v)));
}
function fillColours() {
  const bytes = new Uint8Array(12 * cellCount);
  order.forEach((cell, i) => { const c = colourOf(cell); for (let k = 0; k < 3; ++k) bytes.set([...c, 255], 12 * i + 4 * k); });
  gl.bindBuffer(gl.ARRAY_BUFFER, gpu.colours);
  gl.bufferData(gl.ARRAY_BUFFER, bytes, gl.DYNAMIC_DRAW);
}
// In the order of the slider, so that the first ones can be drawn alone.
function fillPlaces() {
  order.forEach((cell, i) => { for (let k = 0; k < 3; ++k) { const p = corners[3 * cell + k]; gpu.positions.set(place.subarray(3 * p, 3 * p + 3), 9 * i + 3 * k); } });
  gl.bindBuffer(gl.ARRAY_BUFFER, gpu.places);
  gl.bufferData(gl.ARRAY_BUFFER, gpu.positions, gl.DYNAMIC_DRAW);
}
function pointColour(p) { return [...rgb(pointColours[pointKinds[pointKind[p]]][dark.matches ? 1 : 0]), 255]; }
function fillPoints() {
  freeArrays(gpu.vertices);
  freeArrays(gpu.points);
  const all = Array.from({ length: pointCount }, (_, i) => i);
  gpu.vertices = pointArrays(all.slice(0, data.vertexCount), pointColour);
  gpu.points = pointArrays(all.slice(data.vertexCount), pointColour);
}
const ballOf = (centre, radius) => [...centre.map((v, k) => (v - middle[k]) / size), radius / size];
function prepare() {
  gpu = { programs: makePrograms(), positions: new Float32Array(9 * cellCount), places: gl.createBuffer(), colours: gl.createBuffer() };
  fillPlaces();
  fillColours();
  gpu.cells = arrays([[0, gpu.places, 3], [1, gpu.colours, 4, gl.UNSIGNED_BYTE, true]]);
  for (const name in lineSets) gpu[name] = lineArrays(lineSets[name]);
  gpu.balls = ballArrays(Array.from(ballVertex).flatMap((v, i) => ballOf(at(v), ballRadius[i])));
  gpu.violations = ballArrays(data.violated.slice(0, 500).flatMap((cell) => { const s = sphereOf(cell); return ballOf(s.centre, s.radius); }));
  gpu.witness = ballArrays(data.witness.cells.flatMap((cell) => { const s = sphereOf(cell); return ballOf(s.centre, s.radius); }));
  gpu.witnessPoints = pointArrays(data.witness.points, () => [213, 94, 0, 255]);
  gpu.witnessLines = lineArrays(Int32Array.from(data.witness.cells.flatMap((cell) => [0, 1, 1, 2, 2, 0].map((k) => corners[3 * cell + k]))));
  fillPoints();
}

// Matrices act on columns; those for WebGL are stored by columns.
const turned = (v) => camera.turn.map((row) => dot(row, v));
const back = (v) => [0, 1, 2].map((k) => camera.turn[0][k] * v[0] + camera.turn[1][k] * v[1] + camera.turn[2][k] * v[2]);
const eye = () => plus(camera.target, back([0, 0, camera.distance]));
const half = Math.tan((17.5 * Math.PI) / 180);
function matrix(width, height) {
  const from = Math.hypot(...eye()), near = Math.max(from - 1.3, camera.distance * 0.01), far = Math.max(from + 3, near * 2);
  const x = 1 / (half * Math.max(1, width / height)), y = x * (width / height), a = -(far + near) / (far - near), b = (-2 * far * near) / (far - near);
  const r = camera.turn, t = turned(camera.target).map((v) => -v);
  t[2] -= camera.distance;
  const out = [];
  for (let k = 0; k < 3; ++k) out.push(x * r[0][k], y * r[1][k], a * r[2][k], -r[2][k]);
  out.push(x * t[0], y * t[1], a * t[2] + b, -t[2]);
  return new Float32Array(out);
}
function cutPlane() {
  if (!state.axis) return [0, 0, 0, -1];
  const normal = state.axis === "view" ? back([0, 0, 1]) : ["x", "y", "z"].map((n) => (n === state.axis ? 1 : 0)), side = state.flip ? -1 : 1;
  return [...times(side, normal), -side * state.cut];
}
function rotate(dx, dy) {
  const [cx, sx, cy, sy] = [Math.cos(dx), Math.sin(dx), Math.cos(dy), Math.sin(dy)], r = camera.turn;
  const q = [plus(times(cx, r[0]), times(sx, r[2])), r[1], plus(times(-sx, r[0]), times(cx, r[2]))];
  camera.turn = [q[0], minus(times(cy, q[1]), times(sy, q[2])), plus(times(sy, q[1]), times(cy, q[2]))];
  const x = normalised(camera.turn[0]), y = normalised(minus(camera.turn[1], times(dot(x, camera.turn[1]), x)));
  camera.turn = [x, y, cross(x, y)];
}
function move(dx, dy) { camera.target = plus(camera.target, back([-dx * camera.distance * half, -dy * camera.distance * half, 0])); }
function zoom(factor) { camera.distance = Math.min(60, Math.max(1e-5, camera.distance * factor)); }

function draw() {
  asked = false;
  const ratio = window.devicePixelRatio || 1, width = Math.max(1, Math.round(canvas.clientWidth * ratio)), height = Math.max(1, Math.round(canvas.clientHeight * ratio));
  if (canvas.width !== width || canvas.height !== height) { canvas.width = width; canvas.height = height; }
  const all = matrix(width, height), cut = cutPlane(), from = eye(), { programs } = gpu, ground = dark.matches ? [0.086, 0.094, 0.11] : [1, 1, 1], ink = dark.matches ? [1, 1, 1] : [0, 0, 0];
  const use = (p, values) => {
    gl.useProgram(p.result);
    gl.uniformMatrix4fv(p.places.all, false, all);
    gl.uniform4fv(p.places.cut, cut);
    if (p.places.eye) gl.uniform3fv(p.places.eye, from);
    if (p.places.screen) gl.uniform2f(p.places.screen, width, height);
    for (const [name, value] of Object.entries(values)) typeof value === "number" ? gl.uniform1f(p.places[name], value) : gl.uniform4fv(p.places[name], value);
  };
  gl.viewport(0, 0, width, height);
  gl.clearColor(...ground, 1);
  gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  gl.enable(gl.DEPTH_TEST);
  gl.depthFunc(gl.LEQUAL);
  gl.enable(gl.BLEND);
  gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
  gl.depthMask(true);
  gl.bindVertexArray(gpu.cells);
  const k = state.tightest;
  if ((state.layers.cells || state.layers.edges) && k > 0) {
    use(programs.cells, { edge: [...ink, state.layers.edges ? 0.55 : 0], fill: state.layers.cells ? 1 : 0 });
    gl.drawArrays(gl.TRIANGLES, 0, 3 * k);
  }
  const lines = (list, colour, thick, bias) => {
    if (!list || !list.count) return;
    use(programs.lines, { colour, width: thick * ratio, bias });
    gl.bindVertexArray(list.array);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, list.count);
  };
  if (state.layers.rows) lines(gpu.rows, dark.matches ? [0.94, 0.72, 0.31, 1] : [0.54, 0.35, 0, 1], 2, 2e-4);
  if (state.layers.chew) lines(gpu.chew, dark.matches ? [0, 0.8, 0.6, 1] : [0, 0.5, 0.36, 1], 2.4, 3e-4);
  if (state.layers.hanging) lines(gpu.hanging, dark.matches ? [1, 0.6, 0.33, 1] : [0.72, 0.29, 0, 1], 4, 3e-4);
  if (state.layers.segments) lines(gpu.segments, [...ink, 1], 2.2, 4e-4);
  const dots = (list, wide) => {
    if (!list || !list.count) return;
    use(programs.points, { width: wide * ratio, bias: 6e-4 });
    gl.bindVertexArray(list.array);
    gl.drawArrays(gl.POINTS, 0, list.count);
  };
  if (state.layers.points) dots(gpu.points, 5);
  if (state.layers.vertices) dots(gpu.vertices, 8);
  if (state.layers.witness) lines(gpu.witnessLines, dark.matches ? [1, 0.48, 0.75, 1] : [0.63, 0, 0.38, 1], 4, 7e-4);
  lines(gpu.pickedLines, dark.matches ? [1, 0.72, 0.9, 1] : [0.55, 0.1, 0.4, 1], 4, 8e-4);
  gl.depthMask(false);
  if (state.layers.rest && k < cellCount) {
    use(programs.cells, { edge: [...ink, 0.22], fill: 0 });
    gl.bindVertexArray(gpu.cells);
    gl.drawArrays(gl.TRIANGLES, 3 * k, 3 * (cellCount - k));
  }
  const spheres = (list, colour) => {
    if (!list || !list.count) return;
    use(programs.balls, { colour });
    gl.bindVertexArray(list.array);
    gl.drawArraysInstanced(gl.TRIANGLES, 0, sphereCount, list.count);
  };
  if (state.layers.balls) spheres(gpu.balls, [0.2, 0.6, 0.9, 0.55]);
  if (state.layers.violations) spheres(gpu.violations, [0.84, 0.37, 0, 0.7]);
  if (state.layers.witness) spheres(gpu.witness, dark.matches ? [1, 0.48, 0.75, 0.8] : [0.63, 0, 0.38, 0.7]);
  spheres(gpu.pickedBall, dark.matches ? [0.95, 0.6, 0.8, 0.9] : [0.7, 0.3, 0.55, 0.8]);
  gl.depthMask(true);
  gl.disable(gl.DEPTH_TEST);
  if (state.layers.witness) dots(gpu.witnessPoints, 12);
  dots(gpu.pickedPoints, 11);
}
function render() {
  if (asked || !gpu) return;
  asked = true;
  requestAnimationFrame(draw);
}

// The ray through a place of the canvas, against the cells that are shown.
function cellAt(x, y) {
  const width = canvas.clientWidth, height = canvas.clientHeight, m = Math.max(1, width / height) * half;
  const o = eye(), d = back([((2 * x) / width - 1) * m, ((1 - (2 * y) / height) * m * height) / width, -1]), cut = cutPlane(), t = gpu.positions;
  let best = Infinity, found = -1;
  if (!state.layers.cells && !state.layers.edges) return -1;
  for (let i = 0; i < state.tightest; ++i) {
    const j = 9 * i, e1 = [t[j + 3] - t[j], t[j + 4] - t[j + 1], t[j + 5] - t[j + 2]], e2 = [t[j + 6] - t[j], t[j + 7] - t[j + 1], t[j + 8] - t[j + 2]];
    const q = cross(d, e2), determinant = dot(e1, q);
    if (determinant === 0) continue;
    const s = [o[0] - t[j], o[1] - t[j + 1], o[2] - t[j + 2]], u = dot(s, q) / determinant;
    if (u < 0 || u > 1) continue;
    const r = cross(s, e1), v = dot(d, r) / determinant;
    if (v < 0 || u + v > 1) continue;
    const far = dot(e2, r) / determinant;
    if (far <= 0 || far >= best || dot(cut, plus(o, times(far, d))) + cut[3] > 0) continue;
    best = far;
    found = order[i];
  }
  return found;
}

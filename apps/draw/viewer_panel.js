// The panel, and what keys and the mouse do.
const element = (name, text, attributes) => {
  const result = document.createElement(name);
  if (text !== undefined) result.textContent = text;
  return Object.assign(result, attributes || {});
};
const pointName = (p) => `${p} (${pointKinds[pointKind[p]]})`;
function pick(cell) {
  state.picked = cell;
  for (const name of ["pickedBall", "pickedLines", "pickedPoints"]) { freeArrays(gpu[name]); gpu[name] = null; }
  const panel = $("picked");
  panel.replaceChildren();
  if (cell >= 0) {
    if (rank[cell] >= state.tightest) setTightest(rank[cell] + 1);
    const own = Array.from(corners.subarray(3 * cell, 3 * cell + 3)), { centre, radius } = sphereOf(cell), near = nearestPoints(cell, 6);
    if (near.length && nearest[cell] >= 0 && !near.some(([p]) => p === nearest[cell])) near.push([nearest[cell], slack[cell]]);
    if (Number.isFinite(radius)) gpu.pickedBall = ballArrays(ballOf(centre, radius));
    const ends = new Float32Array(18);
    own.forEach((p, k) => { ends.set(place.subarray(3 * p, 3 * p + 3), 6 * k); const q = own[(k + 1) % 3]; ends.set(place.subarray(3 * q, 3 * q + 3), 6 * k + 3); });
    gpu.pickedLines = rawLines(ends);
    gpu.pickedPoints = pointArrays(near.map(([p]) => p), (p) => [...rgb(p === nearest[cell] ? (dark.matches ? "#ff9a55" : "#d55e00") : dark.matches ? "#f2a0cc" : "#a03a78"), 255]);
    panel.append(element("h2", `cell ${cell}`));
    const lines = [`line ${cellLine[cell]} of the certificate, facet ${cellFacet[cell]}, kind ${cellKinds[cellKind[cell]]}, number ${rank[cell] + 1} by slack${lemmas.has(state.colour) ? ` of ${state.colour}` : ""}`, `corners ${own.map(pointName).join(", ")}`, `radius of its sphere ${number(radius, 9)}`];
    if (nearest[cell] >= 0) lines.push(`relative power of the nearest point${data.dimension === 3 ? " off its plane" : ""}: ${number(slack[cell], 12)}, point ${pointName(nearest[cell])}`);
    for (const [id, { values }] of lemmas) if (!Number.isNaN(values[cell])) lines.push(`slack of ${id}: ${number(values[cell], 6)}`);
    for (const text of lines) panel.append(element("p", text));
    if (violated.has(cell)) panel.append(element("p", "violated: a point lies where none may", { className: "bad" }));
    const table = element("table"), top = element("tr");
    for (const text of ["nearest points", "relative power", "where"]) top.append(element("th", text));
    table.append(top);
    for (const [p, power] of near) {
      const row = element("tr");
      row.append(element("td", pointName(p)), element("td", number(power, 6), { className: "number" }), element("td", at(p).map((v) => number(v, 6)).join(", ")));
      table.append(row);
    }
    panel.append(table);
  }
  render();
}
function goTo(cell) {
  if (cell < 0) return;
  pick(cell);
  const { centre, radius } = sphereOf(cell), ball = ballOf(centre, radius), corner = Array.from(place.subarray(3 * corners[3 * cell], 3 * corners[3 * cell] + 3));
  camera.target = ball[3] < 2 ? ball.slice(0, 3) : corner;
  camera.distance = Math.min(3.4, Math.max(1e-4, 6 * Math.min(ball[3], 1)));
  render();
}
function step(by) {
  const next = state.picked < 0 ? (by > 0 ? 0 : cellCount - 1) : rank[state.picked] + by;
  if (next >= 0 && next < cellCount) pick(order[next]);
}

// The slider is logarithmic: few cells and all cells are both within reach.
const countOf = (value) => (value >= 1000 ? cellCount : Math.min(cellCount, Math.round(Math.pow(cellCount + 1, value / 1000) - 1)));
function setTightest(count) {
  state.tightest = Math.max(0, Math.min(cellCount, count));
  const value = state.tightest === cellCount ? 1000 : Math.min(999, Math.round((1000 * Math.log(state.tightest + 1)) / Math.log(cellCount + 1)));
  if (countOf(Number($("tightest").value)) !== state.tightest) $("tightest").value = value;
  $("shown").textContent = String(state.tightest);
  render();
}
// Colouring by a lemma also makes its slack the slider's.
function setColour(name) {
  state.colour = name;
  orderBy(lemmas.get(name));
  if (gpu) { fillPlaces(); fillColours(); }
  $("by").textContent = lemmas.has(name) ? ` (slack of ${name})` : "";
  legend();
  render();
}
function legend() {
  const entries = { kind: cellKinds.map((k, i) => [kindColours[i], { T: "T at an edge's end", S: "S spoke", R: "R rectangle", C: "C Chew" }[k], cellKind.includes(i)]), stage: stages.map((s, i) => [stageColours[i], s, true]) }[state.colour] || [];
  if (state.colour === "kind" && violated.size) entries.push([badColour, "violated", true]);
  const lemma = lemmas.get(state.colour);
  if (state.colour === "slack" || lemma)
    slackColours.forEach((c, i) => {
      const list = lemma ? lemma.cells : order, cell = list[Math.round((i / (slackColours.length - 1)) * (list.length - 1))];
      if (cell !== undefined) entries.push([`rgb(${c})`, number((lemma ? lemma.values : slack)[cell], 3), true]);
    });
  if (lemma) entries.push(["rgb(200,200,200)", "not spoken of", true]);
  if (state.colour === "facet") entries.push([facetColours[0], "colours repeat", true]);
  $("legend").replaceChildren(...entries.filter((e) => e[2]).map(([colour, text]) => { const span = element("span"); const box = element("i"); box.style.background = colour; span.append(box, text); return span; }));
}
function table() {
  const body = $("table"), add = (cells, cell) => {
    const row = element("tr");
    cells.forEach((text, i) => row.append(element("td", text, { className: i ? "number" : "" })));
    const last = element("td");
    if (cell >= 0) last.append(element("button", `cell ${cell}`, { onclick: () => goTo(cell) }));
    row.append(last);
    body.append(row);
  };
  const top = element("tr");
  for (const [text, name] of [["", ""], ["objects", "number"], ["smallest slack", "number"], ["where", ""]]) top.append(element("th", text, { className: name }));
  body.append(top);
  const byLine = new Map();
  cellLine.forEach((line, cell) => byLine.set(line, cell));
  for (const row of data.table) add([row.name, row.objects, row.slack], row.line !== undefined && byLine.has(row.line) ? byLine.get(row.line) : -1);
  cellKinds.forEach((kind, k) => {
    const first = order.find((cell) => cellKind[cell] === k), count = cellKind.reduce((sum, v) => sum + (v === k ? 1 : 0), 0);
    if (count) add([`cells ${kind}`, String(count), number(slack[first], 6)], first);
  });
}
function panel() {
  $("name").textContent = data.file;
  $("verdict").textContent = data.verdict === "not checked" ? "not checked" : `confidel-check: ${data.verdict}`;
  if (data.verdict !== "s VERIFIED") $("verdict").className = "bad";
  $("counts").textContent = data.counts;
  const { statement, cells, points: marked } = data.witness;
  if (statement) {
    $("witness").append(element("p", `The certificate refutes ${statement}. Its witness: ${marked.map((p) => `point ${pointName(p)}`).join(" and ")}, against the sphere of`, { className: "bad" }));
    for (const cell of cells) if (cell < cellCount) $("witness").append(element("button", `cell ${cell}`, { onclick: () => goTo(cell) }), " ");
  }
  $("made").textContent = data.made;
  $("all").textContent = String(cellCount);
  $("shown").textContent = String(cellCount);
  for (const [id, name, , count] of layers) {
    const box = element("input", undefined, { type: "checkbox", checked: state.layers[id], id: `layer-${id}`, disabled: count === 0 }), label = element("label");
    box.addEventListener("change", () => { state.layers[id] = box.checked; render(); });
    label.append(box, count === null ? name : `${name} (${count})`);
    $("layers").append(label);
  }
  for (const id of lemmas.keys()) $("colour").append(element("option", `slack of ${id}`, { value: id }));
  $("tightest").addEventListener("input", () => setTightest(countOf(Number($("tightest").value))));
  $("colour").addEventListener("change", () => { setColour($("colour").value); });
  $("axis").addEventListener("change", () => { state.axis = $("axis").value; $("cut-label").hidden = !state.axis; render(); });
  $("cut").addEventListener("input", () => { state.cut = Number($("cut").value); render(); });
  $("flip").addEventListener("change", () => { state.flip = $("flip").checked; render(); });
  legend();
  table();
}
function whole() { camera.target = [0, 0, 0]; camera.distance = 3.4; render(); }
function control() {
  let drag = null, way = 0;
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener("pointerdown", (event) => { canvas.setPointerCapture(event.pointerId); drag = [event.clientX, event.clientY, event.shiftKey || event.button !== 0]; way = 0; });
  canvas.addEventListener("pointermove", (event) => {
    if (!drag) return;
    const dx = event.clientX - drag[0], dy = event.clientY - drag[1];
    way += Math.abs(dx) + Math.abs(dy);
    if (drag[2]) move((2 * dx) / canvas.clientHeight, (-2 * dy) / canvas.clientHeight);
    else rotate(dx * 0.008, dy * 0.008);
    drag[0] = event.clientX;
    drag[1] = event.clientY;
    render();
  });
  canvas.addEventListener("pointerup", (event) => {
    if (drag && way < 4 && event.button === 0) { const box = canvas.getBoundingClientRect(); pick(cellAt(event.clientX - box.left, event.clientY - box.top)); }
    drag = null;
  });
  canvas.addEventListener("wheel", (event) => { zoom(Math.pow(1.0013, event.deltaY)); render(); event.preventDefault(); }, { passive: false });
  canvas.addEventListener("keydown", (event) => {
    const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    if (arrows && event.shiftKey) move(-0.1 * arrows[0], 0.1 * arrows[1]);
    else if (arrows) rotate(0.12 * arrows[0], 0.12 * arrows[1]);
    else if (event.key === "+" || event.key === "=") zoom(0.8);
    else if (event.key === "-") zoom(1.25);
    else if (event.key === "n") step(1);
    else if (event.key === "p") step(-1);
    else if (event.key === "g") goTo(state.picked);
    else if (event.key === "f") whole();
    else if (event.key === "Escape") pick(-1);
    else return;
    event.preventDefault();
    render();
  });
  dark.addEventListener("change", () => { fillPoints(); pick(state.picked); });
  new ResizeObserver(render).observe(canvas);
}
panel();
if (!gl) {
  $("message").hidden = false;
  $("message").textContent = "This browser gives no WebGL2, which the picture needs. The table works without; `confidel draw FILE.cert -o FILE.vtu` makes a file for ParaView.";
} else {
  prepare();
  rotate(-0.6, 0);
  rotate(0, 0.45);
  control();
  canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
  canvas.addEventListener("webglcontextrestored", () => { sphereStrip = null; for (const name of Object.keys(gpu)) if (name.startsWith("picked")) gpu[name] = null; const old = gpu; prepare(); void old; pick(state.picked); });
  draw();
}
// For scripts: the state, and a picture that can be read in the same task.
window.confidel = { state, camera, pick, goTo, setTightest, cellAt, cellCount, get order() { return Array.from(order.subarray(0, 1000)); }, pixels() { draw(); const bytes = new Uint8Array(4 * canvas.width * canvas.height); gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, bytes); return bytes; } };

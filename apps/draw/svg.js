// Layers, zoom and circumcircles of picked cells. The picture is complete without this script.
(function () {
  "use strict";
  var root = document.documentElement, plot = document.getElementById("plot"), scene = document.getElementById("scene");
  var whole = plot.getAttribute("viewBox").split(" ").map(Number), view = whole.slice();
  function toggle(item) {
    var on = item.getAttribute("aria-checked") !== "true", layer = item.getAttribute("data-layer");
    item.setAttribute("aria-checked", String(on));
    if (layer === "by-slack") root.classList.toggle("by-slack", on);
    else document.getElementById(layer).classList.toggle("off", !on);
  }
  document.querySelectorAll(".item").forEach(function (item) {
    item.addEventListener("click", function () { toggle(item); });
    item.addEventListener("keydown", function (event) {
      if (event.key === "Enter" || event.key === " ") { toggle(item); event.preventDefault(); }
    });
  });
  function show(next) { view = next; plot.setAttribute("viewBox", view.join(" ")); }
  function zoom(factor, x, y) {
    var width = view[2] * factor;
    if (width > whole[2] * 4 || width < whole[2] * 1e-5) return;
    show([x - (x - view[0]) * factor, y - (y - view[1]) * factor, width, view[3] * factor]);
  }
  function place(event) {
    var at = new DOMPoint(event.clientX, event.clientY).matrixTransform(scene.getScreenCTM().inverse());
    return [at.x, at.y];
  }
  function middle() { return [view[0] + view[2] / 2, view[1] + view[3] / 2]; }
  plot.addEventListener("wheel", function (event) {
    var at = place(event);
    zoom(Math.pow(1.0015, event.deltaY), at[0], at[1]);
    event.preventDefault();
  }, { passive: false });
  var from = null, moved = false;
  plot.addEventListener("pointerdown", function (event) { if (event.button === 0) { from = place(event); moved = false; } });
  plot.addEventListener("pointermove", function (event) {
    if (!from || !(event.buttons & 1)) { from = null; return; }
    var at = place(event);
    if (Math.abs(at[0] - from[0]) + Math.abs(at[1] - from[1]) > view[2] * 0.003) moved = true;
    if (moved) show([view[0] + from[0] - at[0], view[1] + from[1] - at[1], view[2], view[3]]);
  });
  plot.addEventListener("click", function (event) {
    from = null;
    if (moved || !event.target.classList.contains("cell") || !event.target.id) return;
    var circle = document.getElementById("o" + event.target.id.slice(1));
    if (circle) circle.classList.toggle("shown");
  });
  plot.addEventListener("dblclick", function () { show(whole.slice()); });
  document.addEventListener("keydown", function (event) {
    var at = middle(), step = view[2] / 10;
    if (event.key === "+" || event.key === "=") zoom(0.8, at[0], at[1]);
    else if (event.key === "-") zoom(1.25, at[0], at[1]);
    else if (event.key === "0") show(whole.slice());
    else if (event.key === "ArrowLeft") show([view[0] - step, view[1], view[2], view[3]]);
    else if (event.key === "ArrowRight") show([view[0] + step, view[1], view[2], view[3]]);
    else if (event.key === "ArrowUp") show([view[0], view[1] - step, view[2], view[3]]);
    else if (event.key === "ArrowDown") show([view[0], view[1] + step, view[2], view[3]]);
    else return;
    event.preventDefault();
  });
})();

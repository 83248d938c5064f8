"use strict";
// Draws the charts of the page: any column against any other, stable parts solid, unstable ones
// dashed. Drag zooms, a double click shows everything, the nearest point tells its numbers.

const SVG = "http://www.w3.org/2000/svg";
const [WIDTH, HEIGHT] = [900, 430];
const FRAME = { left: 78, right: 882, top: 14, bottom: 376 };

function element(name, attributes, parent, text) {
  const made = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  if (text !== undefined) made.textContent = text;
  if (parent) parent.append(made);
  return made;
}

function html(name, attributes, parent, text) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  if (text !== undefined) made.textContent = text;
  if (parent) parent.append(made);
  return made;
}

// "tip_u1_mm" as "tip u1 (mm)".
function label(column) {
  const units = ["kV_mm", "kV", "mm", "mJ", "uC", "nF", "deg", "K", "s", "N", "mW"];
  const unit = units.find(u => column.endsWith("_" + u));
  const name = (unit ? column.slice(0, -unit.length - 1) : column).replaceAll("_", " ");
  return unit ? `${name} (${unit.replace("_", "/")})` : name;
}

// Round numbers between low and high.
function ticks(low, high) {
  const raw = (high - low) / 6, power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map(m => m * power).find(s => s >= raw);
  const result = [];
  for (let k = Math.ceil(low / step); k * step <= high + 1e-9 * step; ++k) result.push(k * step);
  return { values: result, step };
}

function tickText(value, step) {
  const size = Math.abs(value);
  if (size >= 1e6 || (size > 0 && step < 1e-4)) return value.toExponential(Math.max(0, Math.ceil(
    Math.log10(size / step) - 1e-9)));
  return value.toFixed(Math.max(0, Math.ceil(-Math.log10(step) - 1e-9)));
}

function range(values) {
  let low = Math.min(...values), high = Math.max(...values);
  if (!(low < high)) [low, high] = [low - 0.5 * (Math.abs(low) || 1), high + 0.5 * (Math.abs(high) || 1)];
  const margin = 0.04 * (high - low);
  return [low >= 0 && low < 0.15 * high ? 0 : low - margin, high + margin];
}

class Chart {
  constructor(place, data) {
    Object.assign(this, { place, ...data, hidden: new Set(), zoom: null });
    this.marks = place.dataset.marks === "yes";
    if (place.dataset.choose === "yes") this.addControls();
    this.svg = element("svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: "img",
      "aria-label": "chart" }, place);
    this.tip = html("div", { class: "tip", hidden: "" }, place);
    if (this.series.length > 1) this.addLegend();
    this.svg.addEventListener("pointermove", event => this.moved(event));
    this.svg.addEventListener("pointerleave", () => { this.tip.hidden = true; this.spot?.remove(); });
    this.svg.addEventListener("pointerdown", event => this.pressed(event));
    window.addEventListener("pointerup", event => this.released(event)); // also beside the chart
    this.svg.addEventListener("dblclick", () => { this.zoom = null; this.draw(); });
    this.draw();
  }

  addControls() {
    const bar = html("div", { class: "controls" }, this.place);
    const columns = [...new Set(this.series.flatMap(s => Object.keys(s.columns)))];
    for (const axis of ["y", "x"]) {
      const holder = html("label", {}, bar, axis === "y" ? "show " : "against ");
      const choice = html("select", { "data-axis": axis }, holder);
      for (const column of columns) html("option", { value: column }, choice, label(column));
      choice.value = this[axis];
      choice.addEventListener("change", () => { this[axis] = choice.value; this.zoom = null; this.draw(); });
    }
    const reset = html("button", { type: "button" }, bar, "show everything");
    reset.addEventListener("click", () => { this.zoom = null; this.draw(); });
  }

  addLegend() {
    const legend = html("div", { class: "legend" }, this.place);
    for (const one of this.series) {
      const button = html("button", { type: "button", "aria-pressed": "true" }, legend);
      html("i", { style: `background:${one.color}` }, button);
      button.append(one.label);
      button.addEventListener("click", () => {
        if (!this.hidden.delete(one)) this.hidden.add(one);
        button.setAttribute("aria-pressed", String(!this.hidden.has(one)));
        this.draw();
      });
    }
  }

  // Points that have both columns, with their rows.
  points(one) {
    const x = one.columns[this.x] || [], y = one.columns[this.y] || [], result = [];
    for (let row = 0; row < Math.min(x.length, y.length); ++row)
      if (x[row] !== null && y[row] !== null) result.push({ row, x: x[row], y: y[row], one });
    return result;
  }

  draw() {
    this.svg.replaceChildren();
    this.tip.hidden = true;
    const shown = this.series.filter(one => !this.hidden.has(one)).map(one => this.points(one));
    this.all = shown.flat();
    if (this.all.length === 0) {
      element("text", { x: WIDTH / 2, y: HEIGHT / 2, "text-anchor": "middle" }, this.svg, "nothing to show");
      return;
    }
    this.limits = this.zoom || { x: range(this.all.map(p => p.x)), y: range(this.all.map(p => p.y)) };
    this.drawAxes();
    const clip = "clip-" + this.place.id;
    const shape = element("clipPath", { id: clip }, this.svg);
    element("rect", { x: FRAME.left, y: FRAME.top, width: FRAME.right - FRAME.left,
      height: FRAME.bottom - FRAME.top }, shape);
    this.layer = element("g", { "clip-path": `url(#${clip})` }, this.svg);
    for (const points of shown) this.drawCurve(points);
  }

  at(axis, value) {
    const [low, high] = this.limits[axis], part = (value - low) / (high - low);
    return axis === "x" ? FRAME.left + part * (FRAME.right - FRAME.left)
                        : FRAME.bottom - part * (FRAME.bottom - FRAME.top);
  }

  drawAxes() {
    for (const axis of ["x", "y"]) {
      const { values, step } = ticks(...this.limits[axis]);
      for (const value of values) {
        const p = this.at(axis, value);
        const line = axis === "x" ? { x1: p, x2: p, y1: FRAME.top, y2: FRAME.bottom }
                                  : { x1: FRAME.left, x2: FRAME.right, y1: p, y2: p };
        element("line", { class: "grid", ...line }, this.svg);
        const place = axis === "x" ? { x: p, y: FRAME.bottom + 19, "text-anchor": "middle" }
                                   : { x: FRAME.left - 8, y: p + 4, "text-anchor": "end" };
        element("text", place, this.svg, tickText(value, step));
      }
    }
    element("rect", { class: "axis", x: FRAME.left, y: FRAME.top, width: FRAME.right - FRAME.left,
      height: FRAME.bottom - FRAME.top }, this.svg);
    element("text", { x: (FRAME.left + FRAME.right) / 2, y: HEIGHT - 12, "text-anchor": "middle" },
      this.svg, label(this.x));
    const middle = (FRAME.top + FRAME.bottom) / 2;
    element("text", { x: 16, y: middle, "text-anchor": "middle", transform: `rotate(-90 16 ${middle})` },
      this.svg, label(this.y));
  }

  drawCurve(points) {
    let path = "", dashed = null;
    const finish = () => {
      if (path) element("path", { class: "curve" + (dashed ? " unstable" : ""), d: path,
        stroke: points[0].one.color }, this.layer);
    };
    for (let i = 0; i + 1 < points.length; ++i) {
      const [a, b] = [points[i], points[i + 1]];
      const unstable = a.one.unstable[a.row] === true;
      if (unstable !== dashed) {
        finish();
        path = `M${this.at("x", a.x)} ${this.at("y", a.y)}`;
        dashed = unstable;
      }
      path += `L${this.at("x", b.x)} ${this.at("y", b.y)}`;
    }
    finish();
    for (const p of points) this.drawMark(p, points.length === 1);
  }

  drawMark(p, alone) {
    const event = p.one.events[p.row] || "", [x, y] = [this.at("x", p.x), this.at("y", p.y)];
    const look = { fill: "#fff", stroke: p.one.color, "stroke-width": 1.5 };
    if (event.endsWith("bifurcation"))
      element("rect", { class: "event", x: x - 4, y: y - 4, width: 8, height: 8, ...look }, this.layer);
    else if (event)
      element("circle", { class: "event", cx: x, cy: y, r: 4.5, ...look }, this.layer);
    else if (this.marks || alone)
      element("circle", { cx: x, cy: y, r: 2.2, fill: p.one.color }, this.layer);
  }

  // Of the event, in the units of the drawing.
  where(event) {
    const box = this.svg.getBoundingClientRect();
    return { x: (event.clientX - box.left) * WIDTH / box.width,
             y: (event.clientY - box.top) * HEIGHT / box.height };
  }

  value(axis, place) {
    const [low, high] = this.limits[axis];
    return axis === "x" ? low + (place - FRAME.left) / (FRAME.right - FRAME.left) * (high - low)
                        : low + (FRAME.bottom - place) / (FRAME.bottom - FRAME.top) * (high - low);
  }

  moved(event) {
    const place = this.where(event);
    if (this.start) {
      const box = { x: Math.min(place.x, this.start.x), y: Math.min(place.y, this.start.y),
        width: Math.abs(place.x - this.start.x), height: Math.abs(place.y - this.start.y) };
      this.box ??= element("rect", { class: "box" }, this.svg);
      for (const [key, value] of Object.entries(box)) this.box.setAttribute(key, value);
      return;
    }
    let nearest = null, distance = 30;
    for (const p of this.all) {
      const d = Math.hypot(this.at("x", p.x) - place.x, this.at("y", p.y) - place.y);
      if (d < distance) [nearest, distance] = [p, d];
    }
    this.spot?.remove();
    this.tip.hidden = nearest === null;
    if (nearest) this.tell(nearest);
  }

  tell(p) {
    const [x, y] = [this.at("x", p.x), this.at("y", p.y)];
    this.spot = element("circle", { cx: x, cy: y, r: 4, fill: p.one.color }, this.layer);
    const unstable = (p.one.columns.unstable_directions || [])[p.row];
    const lines = [p.one.label, `${label(this.x)}: ${+p.x.toPrecision(7)}`,
      `${label(this.y)}: ${+p.y.toPrecision(7)}`];
    if (unstable > 0) lines.push(`unstable directions: ${unstable}`);
    if (p.one.events[p.row]) lines.push(p.one.events[p.row]);
    this.tip.replaceChildren();
    for (const line of lines) html("div", {}, this.tip, line);
    const scale = this.svg.getBoundingClientRect().width / WIDTH;
    const onLeft = x > WIDTH / 2;
    this.tip.style.left = onLeft ? "" : `${x * scale + 14}px`;
    this.tip.style.right = onLeft ? `${this.place.clientWidth - x * scale + 14}px` : "";
    this.tip.style.top = `${this.svg.offsetTop + y * scale - 10}px`;
  }

  pressed(event) {
    if (this.all.length === 0) return;
    this.start = this.where(event);
    this.tip.hidden = true;
  }

  released(event) {
    const [a, b] = [this.start, this.where(event)];
    this.start = null;
    this.box?.remove();
    this.box = null;
    if (!a || Math.abs(a.x - b.x) < 8 || Math.abs(a.y - b.y) < 8) return;
    const sorted = (p, q) => [Math.min(p, q), Math.max(p, q)];
    this.zoom = { x: sorted(this.value("x", a.x), this.value("x", b.x)),
                  y: sorted(this.value("y", a.y), this.value("y", b.y)) };
    this.draw();
  }
}

for (const data of document.querySelectorAll("script[data-for]"))
  new Chart(document.getElementById(data.dataset.for), JSON.parse(data.textContent));

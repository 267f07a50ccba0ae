// Which part of the map the canvas shows: everything at first; zoomed and moved by hand.

/** The box around all that any keyframe shows, m. */
function extentOf(replay) {
  const size = replay.map.tile * replay.map.pixel_m;
  const { box } = replay;
  const tight = { x0: Infinity, y0: Infinity, x1: -Infinity, y1: -Infinity };
  const add = (x, y, margin) => {
    tight.x0 = Math.min(tight.x0, x - margin);
    tight.y0 = Math.min(tight.y0, y - margin);
    tight.x1 = Math.max(tight.x1, x + margin);
    tight.y1 = Math.max(tight.y1, y + margin);
  };
  if (replay.map.tiles > 1) {
    add(replay.map.x_m + box.x * size, replay.map.y_m + box.y * size, 0);
    add(replay.map.x_m + (box.x + box.columns) * size, replay.map.y_m + (box.y + box.rows) * size, 0);
  }
  for (const p of replay.steps.pose) add(p.x, p.y, 1);
  for (const p of replay.steps.truth) if (p) add(p.x, p.y, 1);
  return tight;
}

class View {
  constructor(canvas, extent, changed) {
    this.canvas = canvas;
    this.extent = extent;
    this.changed = changed;
    this.fit();
    canvas.addEventListener("wheel", (e) => this.wheel(e), { passive: false });
    canvas.addEventListener("dblclick", () => this.fit());
    canvas.addEventListener("pointerdown", (e) => this.grab(e));
    new ResizeObserver(() => this.resize()).observe(canvas);
  }

  fit() {
    this.zoom = 1;
    this.x = (this.extent.x0 + this.extent.x1) / 2;
    this.y = (this.extent.y0 + this.extent.y1) / 2;
    this.update();
  }

  resize() {
    const ratio = window.devicePixelRatio || 1;
    this.canvas.width = Math.max(1, Math.round(this.canvas.clientWidth * ratio));
    this.canvas.height = Math.max(1, Math.round(this.canvas.clientHeight * ratio));
    this.update();
  }

  update() {
    const { extent } = this;
    const whole = Math.min(this.canvas.width / (extent.x1 - extent.x0), this.canvas.height / (extent.y1 - extent.y0));
    this.scale = whole * this.zoom; // device pixels a metre
    this.canvas.classList.toggle("zoomed", this.zoom > 1);
    this.changed();
  }

  toX(x) { return this.canvas.width / 2 + (x - this.x) * this.scale; }
  toY(y) { return this.canvas.height / 2 - (y - this.y) * this.scale; }

  /** Zooms about a point of the canvas, device pixels from its middle. */
  zoomBy(factor, dx = 0, dy = 0) {
    const zoom = Math.min(Math.max(this.zoom * factor, 1), 40);
    if (zoom === 1) return this.fit();
    const change = 1 / this.scale - (1 / this.scale) * (this.zoom / zoom);
    this.x += dx * change;
    this.y -= dy * change;
    this.zoom = zoom;
    this.update();
  }

  wheel(event) {
    if (!event.ctrlKey && !event.metaKey) return;
    event.preventDefault();
    const ratio = this.canvas.width / this.canvas.clientWidth;
    this.zoomBy(Math.exp(-event.deltaY / 300), event.offsetX * ratio - this.canvas.width / 2, event.offsetY * ratio - this.canvas.height / 2);
  }

  grab(event) {
    if (this.zoom === 1 || event.button !== 0) return;
    this.canvas.setPointerCapture(event.pointerId);
    this.canvas.classList.add("dragged");
    const ratio = this.canvas.width / this.canvas.clientWidth;
    const drag = (e) => {
      this.x -= (e.movementX * ratio) / this.scale;
      this.y += (e.movementY * ratio) / this.scale;
      this.update();
    };
    const release = () => {
      this.canvas.classList.remove("dragged");
      this.canvas.removeEventListener("pointermove", drag);
    };
    this.canvas.addEventListener("pointermove", drag);
    this.canvas.addEventListener("pointerup", release, { once: true });
    this.canvas.addEventListener("pointercancel", release, { once: true });
  }
}

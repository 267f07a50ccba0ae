// The map at one moment with the layers over it.

class Scene extends Layers {
  constructor(replay, view, map) {
    super();
    Object.assign(this, { replay, view, map, context: view.canvas.getContext("2d"), hidden: new Set() });
    this.recolour();
  }

  recolour() {
    this.colours = Object.fromEntries([...kLayers.map((l) => l.name), "text", "card"].map((n) => [n, colour(n)]));
    this.map.recolour();
  }

  draw(step) {
    const frame = this.replay.frameOf[step];
    this.unit = window.devicePixelRatio || 1;
    this.drawMap(frame);
    for (const layer of kLayers) {
      if (this.hidden.has(layer.name)) continue;
      this.context.save();
      this.context.strokeStyle = this.context.fillStyle = this.colours[layer.name];
      this.context.lineWidth = 2 * this.unit;
      this.context.lineJoin = this.context.lineCap = "round";
      this[layer.name](frame, step);
      this.context.restore();
    }
    this.scaleBar();
  }

  drawMap(frame) {
    const { context, view, replay } = this;
    this.map.show(frame.table);
    context.clearRect(0, 0, view.canvas.width, view.canvas.height);
    const size = replay.map.tile * replay.map.pixel_m;
    const left = replay.map.x_m + replay.box.x * size;
    const top = replay.map.y_m + (replay.box.y + replay.box.rows) * size;
    context.imageSmoothingEnabled = replay.map.pixel_m * view.scale < 2;
    context.imageSmoothingQuality = "high";
    context.drawImage(this.map.canvas, view.toX(left), view.toY(top), replay.box.columns * size * view.scale, replay.box.rows * size * view.scale);
  }

  /** The longest round length under a quarter of the canvas. */
  scaleBar() {
    const { context, view, unit } = this;
    const most = view.canvas.width / 4 / view.scale;
    const decade = 10 ** Math.floor(Math.log10(most));
    const length = decade * ([5, 2].find((n) => n * decade <= most) || 1);
    const [x, y] = [12 * unit, view.canvas.height - 12 * unit];
    const label = `${Number(length.toPrecision(1))} m`;
    context.font = `${12 * unit}px system-ui, sans-serif`;
    context.fillStyle = this.colours.card;
    context.globalAlpha = 0.8;
    context.fillRect(x - 6 * unit, y - 22 * unit, Math.max(length * view.scale, context.measureText(label).width) + 12 * unit, 28 * unit);
    context.globalAlpha = 1;
    context.fillStyle = this.colours.text;
    context.fillRect(x, y - 2 * unit, length * view.scale, 2 * unit);
    context.fillText(label, x, y - 7 * unit);
  }
}

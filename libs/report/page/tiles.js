// The map as a picture of its own, in which only the tiles that change are drawn again.

/** Reads the pictures of tiles, a tile a row: a byte a pixel, 0 unknown, 1 free, 2 occupied. */
async function readTiles(map) {
  const area = map.tile * map.tile;
  const pixels = new Uint8Array(map.tiles * area);
  const canvas = element("canvas");
  const context = canvas.getContext("2d", { willReadFrequently: true });
  for (let p = 0; p < map.pictures.length; ++p) {
    const image = new Image();
    image.src = map.pictures[p];
    await image.decode();
    canvas.width = image.width;
    canvas.height = image.height;
    context.drawImage(image, 0, 0);
    const rgba = context.getImageData(0, 0, image.width, image.height).data;
    const first = p * map.per_picture * area;
    for (let i = 0; 4 * i < rgba.length; ++i) pixels[first + i] = Math.round(rgba[4 * i] / 85);
  }
  return pixels;
}

class TiledMap {
  constructor(replay, pixels) {
    this.side = replay.map.tile;
    this.box = replay.box;
    this.pixels = pixels;
    this.canvas = element("canvas", { width: this.box.columns * this.side, height: this.box.rows * this.side });
    this.context = this.canvas.getContext("2d");
    this.image = this.context.createImageData(this.side, this.side);
    this.recolour();
  }

  /** Takes the style sheet's colours anew; all tiles are drawn again with the next table. */
  recolour() {
    const probe = element("canvas", { width: 1, height: 1 }).getContext("2d", { willReadFrequently: true });
    this.colours = ["unknown", "free", "occupied"].map((name) => {
      probe.fillStyle = colour(name);
      probe.fillRect(0, 0, 1, 1);
      return probe.getImageData(0, 0, 1, 1).data;
    });
    this.shown = new Int32Array(this.box.columns * this.box.rows).fill(-1);
  }

  show(table) {
    for (let i = 0; i < table.length; ++i)
      if (table[i] !== this.shown[i]) this.drawTile(i % this.box.columns, Math.floor(i / this.box.columns), table[i]);
    this.shown = table.slice();
  }

  /** Tiles are stored from the south up, the canvas runs down. */
  drawTile(column, row, tile) {
    const { side, image } = this;
    for (let y = 0; y < side; ++y)
      for (let x = 0; x < side; ++x)
        image.data.set(this.colours[this.pixels[(tile * side + side - 1 - y) * side + x]], 4 * (y * side + x));
    this.context.putImageData(image, column * side, (this.box.rows - 1 - row) * side);
  }
}

// What is drawn over the map, layer by layer; each can be switched off.

/** Layers in the order they are drawn; `has` tells whether the replay holds any of it. */
const kLayers = [
  { name: "frontiers", label: "frontiers", has: (r) => r.frames.some((f) => f.frontiers) },
  { name: "graph", label: "graph of places G", has: (r) => r.frames.some((f) => f.places.length) },
  { name: "truth", label: "true path", has: (r) => known(r.steps.truth) },
  { name: "path", label: "path of the best particle s*", has: () => true },
  { name: "plan", label: "planned path and goal", has: (r) => r.frames.some((f) => f.plan || f.goal) },
  { name: "particles", label: "particles", has: () => true },
  { name: "shortcut", label: "shortcut that fired", has: (r) => r.frames.some((f) => f.shortcut) },
];

/** How each layer is drawn: a method of its name, on the canvas of Scene. */
class Layers {
  /** A line through x, y, x, y, ... in cm. */
  line(list, from = 0) {
    this.context.beginPath();
    for (let i = from; i < list.length; i += 2) this.context.lineTo(this.view.toX(list[i] / 100), this.view.toY(list[i + 1] / 100));
  }

  dot(x, y, radius) {
    this.context.beginPath();
    this.context.arc(this.view.toX(x), this.view.toY(y), radius * this.unit, 0, 2 * Math.PI);
  }

  frontiers(frame) {
    const size = Math.max(0.1 * this.view.scale, 2 * this.unit);
    for (const cluster of frame.frontiers || [])
      for (let i = 0; i < cluster.length; i += 2)
        this.context.fillRect(this.view.toX(cluster[i] / 100) - size / 2, this.view.toY(cluster[i + 1] / 100) - size / 2, size, size);
  }

  graph(frame) {
    const at = (i) => frame.places.slice(2 * i, 2 * i + 2);
    this.context.globalAlpha = 0.75;
    this.context.lineWidth = 1.5 * this.unit;
    for (let i = 0; i < frame.edges.length; i += 2) {
      this.line([...at(frame.edges[i]), ...at(frame.edges[i + 1])]);
      this.context.stroke();
    }
    for (let i = 0; i < frame.places.length; i += 2) {
      this.dot(frame.places[i] / 100, frame.places[i + 1] / 100, 3);
      this.context.fill();
    }
  }

  truth(frame, step) {
    const { truth } = this.replay.steps;
    this.line(truth.slice(0, step + 1).flatMap((p) => (p ? [100 * p.x, 100 * p.y] : [])));
    this.context.setLineDash([7 * this.unit, 5 * this.unit]);
    this.context.stroke();
    this.context.setLineDash([]);
    if (truth[step]) this.robot(truth[step], false);
  }

  /** The keyframe's path, and on from it the poses of the updates since. */
  path(frame, step) {
    const since = this.replay.steps.pose.slice(frame.step + 1, step + 1);
    this.line(frame.path.concat(since.flatMap((p) => [100 * p.x, 100 * p.y])));
    this.context.stroke();
    this.robot(this.replay.steps.pose[step], true);
  }

  plan(frame) {
    if (frame.plan) {
      this.context.setLineDash([6 * this.unit, 5 * this.unit]);
      this.line(frame.plan);
      this.context.stroke();
      this.context.setLineDash([]);
    }
    if (!frame.goal) return;
    this.dot(frame.goal[0] / 100, frame.goal[1] / 100, 7);
    this.context.stroke();
    this.dot(frame.goal[0] / 100, frame.goal[1] / 100, 2);
    this.context.fill();
  }

  particles(frame, step) {
    const { context, view, unit } = this;
    const { particles } = this.replay.cloudOf[step];
    context.lineWidth = 1.5 * unit;
    for (let i = 0; i < particles.length; i += 4) {
      const [x, y, phi, weight] = particles.slice(i, i + 4);
      context.globalAlpha = 0.25 + 0.65 * (weight / 100);
      const px = view.toX(x / 100);
      const py = view.toY(y / 100);
      context.beginPath();
      context.arc(px, py, 2.2 * unit, 0, 2 * Math.PI);
      context.fill();
      context.beginPath();
      context.moveTo(px, py);
      context.lineTo(px + 9 * unit * Math.cos(phi / 1000), py - 9 * unit * Math.sin(phi / 1000));
      context.stroke();
    }
  }

  shortcut(frame) {
    if (!frame.shortcut) return;
    this.context.setLineDash([3 * this.unit, 5 * this.unit]);
    this.line(frame.shortcut);
    this.context.stroke();
    this.context.setLineDash([]);
    this.dot(frame.shortcut[0] / 100, frame.shortcut[1] / 100, 6);
    this.context.stroke();
  }

  robot(pose, solid) {
    const { context, view, unit } = this;
    context.save();
    context.translate(view.toX(pose.x), view.toY(pose.y));
    context.rotate(-pose.phi);
    context.beginPath();
    context.moveTo(11 * unit, 0);
    context.lineTo(-7 * unit, 6.5 * unit);
    context.lineTo(-7 * unit, -6.5 * unit);
    context.closePath();
    if (solid) context.fill();
    context.lineWidth = (solid ? 1.5 : 2) * unit;
    if (solid) context.strokeStyle = this.colours.card;
    context.stroke();
    context.restore();
  }
}

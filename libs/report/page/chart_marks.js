// What all charts show alike: loop states as bands, moments as lines, the chosen moment.

class Marks {
  constructor(charts) {
    this.id = "marks";
    this.charts = charts;
  }

  /** What the loop state was, and a line at every moment. */
  beforeDatasetsDraw(chart) {
    const { ctx, chartArea: area, scales } = chart;
    const { x, replay } = this.charts;
    const { loop, count } = replay.steps;
    ctx.save();
    loop.forEach(([from, state], i) => {
      if (state === 0) return;
      const to = i + 1 < loop.length ? loop[i + 1][0] : count - 1;
      const left = scales.x.getPixelForValue(x[from]);
      ctx.fillStyle = colour(state === 1 ? "approaching" : "closing");
      ctx.fillRect(left, area.top, Math.max(scales.x.getPixelForValue(x[to]) - left, 1), area.height);
    });
    ctx.setLineDash([2, 3]);
    for (const moment of replay.moments) {
      ctx.strokeStyle = colour(moment.kind);
      this.drawLine(chart, moment.step);
    }
    ctx.restore();
  }

  afterDatasetsDraw(chart) {
    chart.ctx.save();
    chart.ctx.strokeStyle = colour("text");
    chart.ctx.lineWidth = 1.5;
    this.drawLine(chart, this.charts.step);
    chart.ctx.restore();
  }

  drawLine({ ctx, chartArea, scales }, step) {
    const x = scales.x.getPixelForValue(this.charts.x[step]);
    ctx.beginPath();
    ctx.moveTo(x, chartArea.top);
    ctx.lineTo(x, chartArea.bottom);
    ctx.stroke();
  }
}

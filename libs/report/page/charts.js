// Curves by Chart.js, with one cursor at the chosen moment.

class Charts {
  constructor(replay, goTo) {
    Object.assign(this, { replay, goTo, step: 0, x: replay.steps.time, format: clock, charts: [] });
    const place = document.getElementById("charts");
    const plans = chartPlans(replay.steps, replay.particles);
    for (const plan of plans) {
      const canvas = element("canvas", { role: "img", "aria-label": `${plan.title} over the run` });
      place.append(element("section", { class: "chart card" }, element("h3", {}, term(plan.title)), element("p", {}, plan.text), element("div", { class: "chart-box" }, canvas)));
      this.charts.push(new Chart(canvas, this.config(plan)));
    }
  }

  show(step) {
    this.step = step;
    for (const chart of this.charts) chart.draw();
  }

  /** Time (s) or distance (m) along all charts. */
  over(axis) {
    this.x = this.replay.steps[axis];
    this.format = axis === "time" ? clock : (v) => `${Number(v.toFixed(1))} m`;
    const end = this.x[this.x.length - 1] || 1;
    const ticks = roundTicks(axis, end);
    for (const chart of this.charts) {
      chart.data.datasets.forEach((set) => (set.data = this.pointsOf(set.values)));
      chart.options.scales.x.max = end;
      // Chart.js itself moves ticks off round values so that one comes to lie at the end.
      chart.options.scales.x.afterBuildTicks = (scale) => (scale.ticks = ticks.map((value) => ({ value })));
      chart.update("none");
    }
  }

  recolour() {
    for (const chart of this.charts) {
      for (const set of chart.data.datasets) set.borderColor = set.backgroundColor = colour(set.colour);
      for (const scale of Object.values(chart.options.scales)) {
        scale.ticks.color = colour("quiet");
        scale.grid.color = colour("line");
      }
      chart.options.plugins.legend.labels.color = colour("quiet");
      chart.update("none");
    }
  }

  pointsOf(values) {
    return values.flatMap((y, i) => (y === null ? [] : [{ x: this.x[i], y }]));
  }

  /** The step nearest to a place on the x axis. */
  stepAt(x) {
    let [low, high] = [0, this.x.length - 1];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.x[middle] < x) low = middle + 1;
      else high = middle;
    }
    return low > 0 && x - this.x[low - 1] < this.x[low] - x ? low - 1 : low;
  }

  config(plan) {
    const scale = (more) => ({ ticks: { maxRotation: 0, autoSkipPadding: 14 }, grid: { drawBorder: false }, ...more });
    const scales = { x: scale({ type: "linear", min: 0 }), y: scale({ beginAtZero: plan.most !== undefined, suggestedMax: plan.most }) };
    scales.x.ticks.callback = (v) => this.format(v);
    if (plan.curves.some((c) => c.axis)) scales.y2 = scale({ position: "right", grid: { drawOnChartArea: false } });
    return {
      type: "line",
      data: { datasets: plan.curves.map((c) => this.dataset(c)) },
      options: {
        parsing: false, normalized: true, animation: false, responsive: true, maintainAspectRatio: false, scales,
        interaction: { mode: "nearest", axis: "x", intersect: false },
        onClick: (event, active, chart) => this.goTo(this.stepAt(chart.scales.x.getValueForPixel(event.x))),
        plugins: {
          legend: { display: plan.curves.length > 1, align: "start", labels: { boxWidth: 22, usePointStyle: true } },
          decimation: { enabled: true, algorithm: "min-max" },
          tooltip: { callbacks: { title: (items) => (items.length ? this.format(items[0].parsed.x) : "") } },
        },
      },
      plugins: [new Marks(this)],
    };
  }

  dataset(curve) {
    const line = { borderWidth: 1.6, pointStyle: "line", pointRadius: 0, pointHitRadius: 0 };
    const points = { showLine: false, pointStyle: "triangle", pointRadius: 4, borderWidth: 1 };
    return { label: curve.label, colour: curve.colour, values: curve.values, data: [], yAxisID: curve.axis || "y", ...(curve.points ? points : line) };
  }
}

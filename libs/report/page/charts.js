// Curves by Chart.js, with one cursor at the chosen moment.

/** Curves of the report; `curves` are drawn as far as the replay has values. */
function chartPlans(steps, particles) {
  const plans = [
    {
      title: "Effective number of particles",
      text: `Neff, Eq. (10), before resampling; triangles: resampled. ${particles} particles.`,
      most: particles,
      curves: [
        { label: "Neff", colour: "path", values: steps.neff },
        { label: "resampled", colour: "particles", values: steps.neff.map((v, i) => (steps.resampled[i] ? v : null)), points: true },
      ],
    },
    {
      title: "Coalescence",
      text: "Unique ancestors: of the set at te of the open closing, else c2 of way ago. Copies that a recovery made count apart.",
      most: particles,
      curves: [{ label: "unique ancestors", colour: "truth", values: steps.ancestors }],
    },
    {
      title: "Entropy, Eq. (6)",
      text: "Of the pose: Gaussian fit of the particles, left scale. Of the map: known cells of s*, which stands for the mean over the particles; right scale.",
      curves: [
        { label: "pose, nats", colour: "path", values: steps.poseEntropy },
        { label: "map, nats", colour: "graph", values: steps.mapEntropy, axis: "y2" },
      ],
    },
    {
      title: "Error to the truth",
      text: "Distance of s*, as believed at that moment, from the true position, m.",
      most: 0.1,
      curves: [{ label: "error, m", colour: "shortcut", values: steps.error }],
    },
  ];
  return plans.filter((plan) => plan.curves.some((c) => known(c.values)));
}

/** Round distances between ticks, s and m. */
const kRound = {
  time: [1, 2, 5, 10, 20, 30, 60, 120, 300, 600, 1200, 1800, 3600, 7200, 14400, 28800, 86400],
  distance: [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000],
};

/** Over time, unless one pause of the log takes most of it. */
function firstAxis(time) {
  const longest = time.reduce((most, t, i) => Math.max(most, i ? t - time[i - 1] : 0), 0);
  return longest > (time[time.length - 1] - time[0]) / 2 && time.length > 3 ? "distance" : "time";
}

class Charts {
  constructor(replay, goTo) {
    Object.assign(this, { replay, goTo, step: 0, x: replay.steps.time, format: clock, charts: [] });
    const place = document.getElementById("charts");
    const plans = chartPlans(replay.steps, replay.particles);
    place.dataset.count = String(plans.length);
    for (const plan of plans) {
      const canvas = element("canvas", { role: "img", "aria-label": `${plan.title} over the run` });
      place.append(element("section", { class: "chart card" }, element("h3", {}, plan.title), element("p", {}, plan.text), element("div", { class: "chart-box" }, canvas)));
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
    const step = kRound[axis].find((n) => n >= end / 8);
    for (const chart of this.charts) {
      chart.data.datasets.forEach((set) => (set.data = this.pointsOf(set.values)));
      chart.options.scales.x.max = end;
      chart.options.scales.x.ticks.stepSize = step;
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
      plugins: [{ beforeDatasetsDraw: (chart) => this.drawBands(chart), afterDatasetsDraw: (chart) => this.drawCursor(chart) }],
    };
  }

  dataset(curve) {
    const line = { borderWidth: 1.6, pointStyle: "line", pointRadius: 0, pointHitRadius: 0 };
    const points = { showLine: false, pointStyle: "triangle", pointRadius: 4, borderWidth: 1 };
    return { label: curve.label, colour: curve.colour, values: curve.values, data: [], yAxisID: curve.axis || "y", ...(curve.points ? points : line) };
  }

  /** What the loop state was, and a line at every moment. */
  drawBands(chart) {
    const { ctx, chartArea: area, scales } = chart;
    const { loop, count } = this.replay.steps;
    ctx.save();
    loop.forEach(([from, state], i) => {
      if (state === 0) return;
      const to = i + 1 < loop.length ? loop[i + 1][0] : count - 1;
      const left = scales.x.getPixelForValue(this.x[from]);
      ctx.fillStyle = colour(state === 1 ? "approaching" : "closing");
      ctx.fillRect(left, area.top, Math.max(scales.x.getPixelForValue(this.x[to]) - left, 1), area.height);
    });
    ctx.setLineDash([2, 3]);
    for (const moment of this.replay.moments) {
      ctx.strokeStyle = colour(moment.kind);
      this.drawLine(chart, moment.step);
    }
    ctx.restore();
  }

  drawCursor(chart) {
    chart.ctx.save();
    chart.ctx.strokeStyle = colour("text");
    chart.ctx.lineWidth = 1.5;
    this.drawLine(chart, this.step);
    chart.ctx.restore();
  }

  drawLine({ ctx, chartArea, scales }, step) {
    const x = scales.x.getPixelForValue(this.x[step]);
    ctx.beginPath();
    ctx.moveTo(x, chartArea.top);
    ctx.lineTo(x, chartArea.bottom);
    ctx.stroke();
  }
}

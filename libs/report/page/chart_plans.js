// Which curves there are, and how their axes are divided.

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
      text: "How many particles of an earlier moment still have descendants. The moment is te while a loop is being closed, else that when the path was c2 shorter. Copies that a recovery made count one by one.",
      most: particles,
      curves: [{ label: "unique ancestors", colour: "truth", values: steps.ancestors }],
    },
    {
      title: "Entropy, Eq. (6)",
      text: "Left scale: entropy of the pose, by a Gaussian fitted to the particles, at each update. Right scale: entropy of the map, of the known cells of s*, at keyframes; s* stands for the mean over the particles.",
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

/** About eight ticks from 0 to `end`. */
function roundTicks(axis, end) {
  const step = kRound[axis].find((n) => n >= end / 8) || end / 8;
  return Array.from({ length: Math.floor(end / step) + 1 }, (_, i) => i * step);
}

/** Over time, unless one pause of the log takes most of it. */
function firstAxis(time) {
  const longest = time.reduce((most, t, i) => Math.max(most, i ? t - time[i - 1] : 0), 0);
  return longest > (time[time.length - 1] - time[0]) / 2 && time.length > 3 ? "distance" : "time";
}

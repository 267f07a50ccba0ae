// Puts the page together.

function showFacts(replay) {
  const pair = ([name, value]) => element("div", {}, element("dt", {}, name), element("dd", {}, value));
  document.getElementById("facts").append(...replay.facts.map(pair));
  document.getElementById("notes").append(...replay.notes.map((note) => element("li", {}, note)));
}

/** The figures under the map; those that no step has are left out. */
function makeReadout(replay) {
  const { steps } = replay;
  const latest = (values, step) => {
    while (step >= 0 && values[step] === null) --step;
    return step < 0 ? null : values[step];
  };
  const number = (values, digits, unit) => (step) => {
    const v = latest(values, step);
    return v === null ? "–" : v.toFixed(digits) + unit;
  };
  const rows = [
    ["Update", (step) => `${step} of ${steps.count - 1}`, true],
    ["Time", (step) => clock(steps.time[step]), true],
    ["Travelled", number(steps.distance, 1, " m"), true],
    ["Neff", (step) => steps.neff[step].toFixed(1) + (steps.resampled[step] ? ", resampled" : ""), true],
    ["Unique ancestors", number(steps.ancestors, 0, ""), known(steps.ancestors)],
    ["Entropy of the pose", number(steps.poseEntropy, 1, " nats"), true],
    ["Entropy of the map", number(steps.mapEntropy, 0, " nats"), known(steps.mapEntropy)],
    ["Error to the truth", number(steps.error, 2, " m"), known(steps.error)],
    ["Map as of", (step) => `update ${replay.frameOf[step].step}`, true],
  ].filter((row) => row[2]);
  const values = rows.map(() => element("dd"));
  document.getElementById("readout").append(...rows.map((row, i) => element("div", {}, element("dt", {}, term(row[0])), values[i])));
  return (step) => rows.forEach((row, i) => (values[i].textContent = row[1](step)));
}

function makeLayers(replay, scene, redraw) {
  for (const layer of kLayers.filter((l) => l.has(replay))) {
    const box = element("input", { type: "checkbox", checked: "" });
    box.addEventListener("change", () => {
      if (box.checked) scene.hidden.delete(layer.name);
      else scene.hidden.add(layer.name);
      redraw();
    });
    document.getElementById("layers").append(element("label", {}, box, element("i", { style: `--colour: var(--${layer.name})` }), term(layer.label)));
  }
}

function say(text) {
  const message = document.getElementById("message");
  message.textContent = text;
  message.hidden = false;
}

async function start() {
  const replay = decodeReplay(JSON.parse(document.getElementById("replay-data").textContent));
  showFacts(replay);
  if (!replay.steps.count || !replay.frames.length) {
    say("There is nothing to replay: the filter was never updated in this run.");
    return;
  }
  const pixels = await readTiles(replay.map);
  document.getElementById("content").hidden = false;
  let player = null;
  let scene = null;
  const redraw = () => scene && player && scene.draw(player.step);
  const view = new View(document.getElementById("map"), extentOf(replay), redraw);
  scene = new Scene(replay, view, new TiledMap(replay, pixels));
  const charts = new Charts(replay, (step) => player.goTo(step));
  const moments = new Moments(replay, (step) => player.goTo(step));
  const readout = makeReadout(replay);
  const state = document.getElementById("state");
  const link = new MomentLink(replay.steps.count);
  player = new Player(replay.steps.count, (step) => {
    state.textContent = replay.steps.state[step];
    readout(step);
    player.slider.setAttribute("aria-valuetext", `update ${step}, ${clock(replay.steps.time[step])}, ${replay.steps.state[step]}`);
    moments.show(step);
    charts.show(step);
    link.show(step, player.playing);
    redraw();
  });
  link.follow((step) => player.goTo(step));
  makeLayers(replay, scene, redraw);
  charts.recolour();
  const axis = document.getElementById("axis");
  axis.value = firstAxis(replay.steps.time);
  charts.over(axis.value);
  axis.addEventListener("change", () => charts.over(axis.value));
  document.getElementById("zoom-in").addEventListener("click", () => view.zoomBy(1.5));
  document.getElementById("zoom-out").addEventListener("click", () => view.zoomBy(1 / 1.5));
  document.getElementById("zoom-fit").addEventListener("click", () => view.fit());
  window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
    colours.clear();
    scene.recolour();
    charts.recolour();
    redraw();
  });
}

start().then(
  () => (document.body.dataset.ready = "true"),
  (error) => {
    say(`The replay cannot be drawn: ${error.message}`);
    throw error;
  },
);

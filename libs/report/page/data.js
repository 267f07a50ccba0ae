"use strict";
// The replay's data in the units and shapes that the rest draws from: metres, radians, seconds.

/** A list from the one before: the first `list[0]` numbers of it, then the others of `list`. */
function grown(before, list) {
  return before.slice(0, list[0]).concat(list.slice(1));
}

/** [first step, value] runs as a value a step. */
function spread(runs, count) {
  const out = new Array(count);
  runs.forEach(([from, value], i) => out.fill(value, from, i + 1 < runs.length ? runs[i + 1][0] : count));
  return out;
}

const scaled = (list, factor) => list.map((v) => (v === null ? null : v * factor));
const poses = (list) => list.map((p) => p && { x: p[0] / 100, y: p[1] / 100, phi: p[2] / 1000 });
const known = (list) => list.some((v) => v !== null);

function decodeSteps(json) {
  const count = json.time_ms.length;
  return {
    count,
    time: scaled(json.time_ms, 1e-3),
    distance: scaled(json.distance_cm, 1e-2),
    neff: scaled(json.neff_milli, 1e-3),
    resampled: json.resampled,
    ancestors: json.ancestors,
    poseEntropy: scaled(json.pose_entropy_milli, 1e-3),
    mapEntropy: scaled(json.map_entropy_milli, 1e-3),
    error: scaled(json.error_mm, 1e-3),
    pose: poses(json.pose),
    truth: poses(json.truth),
    loop: json.loop,
    state: spread(json.state, count),
  };
}

/** Keyframes, each whole; `table` is the number of the tile at every place of `box`. */
function decodeFrames(frames, box) {
  let before = { path: [], places: [], edges: [], table: new Int32Array(box.columns * box.rows) };
  return frames.map((frame) => {
    const table = before.table.slice();
    for (let i = 0; i < frame.map.length; i += 3)
      table[(frame.map[i + 1] - box.y) * box.columns + frame.map[i] - box.x] = frame.map[i + 2];
    before = {
      ...frame,
      path: grown(before.path, frame.path),
      places: grown(before.places, frame.places),
      edges: grown(before.edges, frame.edges),
      table,
    };
    return before;
  });
}

/** [step, x, y, phi, weight, x, ...] with poses but the first as differences to the first. */
function decodeClouds(clouds) {
  return clouds.map(([step, ...list]) => ({
    step,
    particles: list.map((v, i) => (i % 4 === 3 || i < 4 ? v : v + list[i % 4])),
  }));
}

/** Of every step the last of the list that is not after it. */
function lastOf(list, count) {
  const out = new Array(count);
  for (let step = 0, i = 0; step < count; ++step) {
    while (i + 1 < list.length && list[i + 1].step <= step) ++i;
    out[step] = list[i];
  }
  return out;
}

/** The box around all tiles that any keyframe shows, in tiles. */
function tileBox(frames) {
  let [x0, y0, x1, y1] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const frame of frames)
    for (let i = 0; i < frame.map.length; i += 3) {
      x0 = Math.min(x0, frame.map[i]);
      x1 = Math.max(x1, frame.map[i]);
      y0 = Math.min(y0, frame.map[i + 1]);
      y1 = Math.max(y1, frame.map[i + 1]);
    }
  return x0 > x1 ? { x: 0, y: 0, columns: 1, rows: 1 } : { x: x0, y: y0, columns: x1 - x0 + 1, rows: y1 - y0 + 1 };
}

function decodeReplay(json) {
  const box = tileBox(json.frames);
  const steps = decodeSteps(json.steps);
  const frames = decodeFrames(json.frames, box);
  const frameOf = lastOf(frames, steps.count);
  const cloudOf = lastOf(decodeClouds(json.clouds), steps.count);
  const moments = json.moments.slice().sort((a, b) => a.step - b.step);
  return { title: json.title, facts: json.facts, notes: json.notes, particles: json.particles, map: json.map, box, steps, frames, frameOf, cloudOf, moments };
}

function clock(seconds) {
  const s = Math.max(0, Math.round(seconds));
  const two = (n) => String(n).padStart(2, "0");
  return s < 3600 ? `${Math.floor(s / 60)}:${two(s % 60)}` : `${Math.floor(s / 3600)}:${two(Math.floor(s / 60) % 60)}:${two(s % 60)}`;
}

const colours = new Map();
/** Colour of the style sheet; asked for anew after colours.clear(). */
function colour(name) {
  if (!colours.has(name)) colours.set(name, getComputedStyle(document.documentElement).getPropertyValue("--" + name).trim());
  return colours.get(name);
}

function element(tag, attributes = {}, ...children) {
  const e = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) e.setAttribute(name, value);
  e.append(...children);
  return e;
}

// MCAP recordings by @mcap/core, with CDR by @foxglove/rosmsg2-serialization; the payloads as lines
// of JSON for sqlite_samples.py.
import { McapWriter } from "@mcap/core";
import { ros2humble } from "@foxglove/rosmsg-msgs-common";
import { MessageWriter } from "@foxglove/rosmsg2-serialization";
import { spawnSync } from "node:child_process";
import fs from "node:fs";

const [out, ros1Lines, ros2Lines] = process.argv.slice(2);
const steps = fs
  .readFileSync(`${out}/drive.txt`, "utf8")
  .split("\n")
  .filter((line) => line && !line.startsWith("#"))
  .map((line) => {
    const words = line.split(" ");
    const [x, y, yaw, ...ranges] = words.slice(1).map((w) => (w === "inf" ? Infinity : Number(w)));
    return { ns: BigInt(words[0]), x, y, yaw, ranges };
  });

const stamp = (ns) => ({ sec: Number(ns / 1000000000n), nanosec: Number(ns % 1000000000n) });
const header = (ns, frame_id) => ({ stamp: stamp(ns), frame_id });
const turn = (yaw) => ({ x: 0, y: 0, z: Math.sin(yaw / 2), w: Math.cos(yaw / 2) });
const level = { x: 0, y: 0, z: 0, w: 1 };

const scan = (s) => ({
  type: "sensor_msgs/msg/LaserScan",
  message: {
    header: header(s.ns, "laser"),
    angle_min: -Math.fround(Math.PI / 2),
    angle_max: Math.fround(Math.PI / 2),
    angle_increment: Math.PI / 60,
    time_increment: 0.0001,
    scan_time: 0.5,
    range_min: 0.05,
    range_max: 6,
    ranges: s.ranges,
    intensities: [],
  },
});
const odometry = (s) => ({
  type: "nav_msgs/msg/Odometry",
  message: {
    header: header(s.ns, "odom"),
    child_frame_id: "base_footprint",
    pose: { pose: { position: { x: s.x, y: s.y, z: 0 }, orientation: turn(s.yaw) }, covariance: Array(36).fill(0) },
    twist: {
      twist: { linear: { x: 0, y: 0, z: 0 }, angular: { x: 0, y: 0, z: 0 } },
      covariance: Array(36).fill(0),
    },
  },
});
const transforms = (list) => ({ type: "tf2_msgs/msg/TFMessage", message: { transforms: list } });
const transform = (ns, parent, child_frame_id, translation, rotation) => ({
  header: header(ns, parent),
  child_frame_id,
  transform: { translation, rotation },
});
const fixed = (ns) =>
  transforms([
    transform(ns, "base_link", "laser", { x: 0.2, y: 0, z: 0.15 }, level),
    transform(ns, "base_footprint", "base_link", { x: 0, y: 0, z: 0.1 }, level),
  ]);
const moving = (s) => transforms([transform(s.ns, "odom", "base_footprint", { x: s.x, y: s.y, z: 0 }, turn(s.yaw))]);

const writers = {};
function cdr({ type, message }) {
  const root = ros2humble[type.replace("/msg/", "/")];
  writers[type] ??= new MessageWriter([root, ...Object.values(ros2humble).filter((d) => d !== root)]);
  return writers[type].writeMessage(message);
}

class File {
  parts = [];
  size = 0n;
  position() { return this.size; }
  async write(bytes) { this.parts.push(Buffer.from(bytes)); this.size += BigInt(bytes.byteLength); }
}
const pack = (tool) => (bytes) => {
  const done = spawnSync(tool, ["-c", "-q"], { input: bytes });
  if (done.status !== 0) throw new Error(`${tool} failed`);
  return { compression: tool, compressedData: done.stdout };
};

/// messages: {topic, type, encoding, definition, ns, data} in the order of the file.
async function write(path, profile, messages, compressChunk, useChunks = true) {
  const file = new File();
  const writer = new McapWriter({ writable: file, chunkSize: 2500, compressChunk, useChunks });
  await writer.start({ profile, library: "" });
  const channels = {};
  let sequence = 0;
  for (const m of messages) {
    if (channels[m.topic] === undefined) {
      const schemaId = await writer.registerSchema({
        name: m.type,
        encoding: profile === "ros1" ? "ros1msg" : "ros2msg",
        data: Buffer.from(m.definition ?? ""),
      });
      channels[m.topic] = await writer.registerChannel({
        schemaId,
        topic: m.topic,
        messageEncoding: profile === "ros1" ? "ros1" : "cdr",
        metadata: new Map(),
      });
    }
    await writer.addMessage({
      channelId: channels[m.topic],
      sequence: sequence++,
      logTime: m.ns,
      publishTime: m.ns,
      data: m.data,
    });
  }
  await writer.end();
  fs.writeFileSync(path, Buffer.concat(file.parts));
}

const message = (topic, ns, content) => ({ topic, ns, type: content.type, data: cdr(content) });
const withOdometry = [message("/tf_static", steps[0].ns, fixed(steps[0].ns))];
const withTransforms = [message("/tf_static", steps[0].ns, fixed(steps[0].ns))];
for (const s of steps) {
  withOdometry.push(message("/odom", s.ns, odometry(s)), message("/scan", s.ns + 20000000n, scan(s)));
  withTransforms.push(message("/tf", s.ns, moving(s)), message("/scan", s.ns + 20000000n, scan(s)));
}

await write(`${out}/tf.mcap`, "ros2", withTransforms);
await write(`${out}/odom_plain.mcap`, "ros2", withOdometry, undefined, false);
await write(`${out}/odom_zstd.mcap`, "ros2", withOdometry, pack("zstd"));
await write(`${out}/tf_lz4.mcap`, "ros2", withTransforms, pack("lz4"));
const ros1 = fs
  .readFileSync(ros1Lines, "utf8")
  .trim()
  .split("\n")
  .map((line) => JSON.parse(line))
  .map((m) => ({ ...m, ns: BigInt(m.time), data: Buffer.from(m.data, "base64") }));
await write(`${out}/ros1_zstd.mcap`, "ros1", ros1, pack("zstd"));

fs.mkdirSync(`${out}/split`, { recursive: true });
const half = withTransforms.length / 2;
await write(`${out}/split/split_0.mcap`, "ros2", withTransforms.slice(0, half), pack("zstd"));
await write(`${out}/split/split_1.mcap`, "ros2", withTransforms.slice(half), pack("zstd"));
fs.writeFileSync(
  `${out}/split/metadata.yaml`,
  `rosbag2_bagfile_information:
  version: 8
  storage_identifier: mcap
  duration:
    nanoseconds: ${steps.at(-1).ns - steps[0].ns}
  starting_time:
    nanoseconds_since_epoch: ${steps[0].ns}
  message_count: ${withTransforms.length}
  topics_with_message_count: []
  compression_format: ""
  compression_mode: ""
  relative_file_paths:
    - split_0.mcap
    - split_1.mcap
`,
);

fs.writeFileSync(
  ros2Lines,
  withTransforms
    .map((m) => JSON.stringify({ topic: m.topic, type: m.type, time: String(m.ns), data: Buffer.from(m.data).toString("base64") }))
    .join("\n"),
);

"""ROS 1 bags by Debian's python3-rosbag, and their payloads for an MCAP of ROS 1."""
import base64
import io
import json
import math
import struct
import sys

import genpy
import rosbag
from geometry_msgs.msg import TransformStamped
from nav_msgs.msg import Odometry
from sensor_msgs.msg import LaserScan
from tf2_msgs.msg import TFMessage

import drive

HALF = struct.unpack("f", struct.pack("f", math.pi / 2))[0]


def stamp(ns):
    return genpy.Time(ns // 1_000_000_000, ns % 1_000_000_000)


def scan(step, frame="laser", clockwise=False):
    m = LaserScan()
    m.header.stamp = stamp(step[0])
    m.header.frame_id = frame
    side = -1 if clockwise else 1
    m.angle_min, m.angle_max = -HALF * side, HALF * side
    m.angle_increment = side * math.pi / 60
    m.range_min, m.range_max = 0.05, 6.0
    m.ranges = step[4]
    return m


def transform(ns, parent, child, x=0.0, y=0.0, z=0.0, q=(0.0, 0.0, 0.0, 1.0)):
    t = TransformStamped()
    t.header.stamp = stamp(ns)
    t.header.frame_id, t.child_frame_id = parent, child
    v, r = t.transform.translation, t.transform.rotation
    v.x, v.y, v.z = x, y, z
    r.x, r.y, r.z, r.w = q
    return t


def turn(yaw):
    return (0.0, 0.0, math.sin(yaw / 2), math.cos(yaw / 2))


def odometry(step):
    m = Odometry()
    m.header.stamp = stamp(step[0])
    m.header.frame_id, m.child_frame_id = "odom", "base_footprint"
    p, q = m.pose.pose.position, m.pose.pose.orientation
    p.x, p.y = step[1], step[2]
    q.x, q.y, q.z, q.w = turn(step[3])
    return m


def fixed(ns, q=(0.0, 0.0, 0.0, 1.0), slash=""):
    return [
        transform(ns, slash + "base_footprint", slash + "base_link", z=0.1),
        transform(ns, slash + "base_link", slash + "laser", x=0.2, z=0.15, q=q),
    ]


def main(out, payloads):
    steps = drive.read(out + "/drive.txt")
    begin = steps[0][0]
    # As rosbag record writes it: nav_msgs/Odometry, /tf_static latched.
    with rosbag.Bag(out + "/odom.bag", "w", chunk_threshold=4000) as bag:
        bag.write("/tf_static", TFMessage(fixed(begin)), stamp(begin))
        for s in steps:
            bag.write("/odom", odometry(s), stamp(s[0]))
            bag.write("/scan", scan(s), stamp(s[0] + 20_000_000))
    # As of old robots: all on /tf with slashes, the fixed transforms repeated; a localization and a
    # wheel that move as well. Compressed with bz2.
    with rosbag.Bag(out + "/tf_bz2.bag", "w", compression="bz2", chunk_threshold=4000) as bag:
        for i, s in enumerate(steps):
            moving = [
                transform(s[0], "/odom", "/base_footprint", s[1], s[2], q=turn(s[3])),
                transform(s[0], "/base_link", "/wheel", y=0.2, q=(0.0, math.sin(i), 0.0, math.cos(i))),
                transform(s[0], "/map", "/odom", x=0.01 * i),
            ]
            bag.write("/tf", TFMessage(fixed(s[0], slash="/") + moving), stamp(s[0]))
            bag.write("/scan", scan(s, "/laser"), stamp(s[0]))
    # One topic after the other; a clockwise laser that hangs, so that its beams go round as above. lz4.
    with rosbag.Bag(out + "/hanging_lz4.bag", "w", compression="lz4", chunk_threshold=4000) as bag:
        for s in steps:
            bag.write("/scan", scan(s, clockwise=True), stamp(s[0]))
        for s in steps:
            bag.write("/odom", odometry(s), stamp(s[0]))
        bag.write("/tf_static", TFMessage(fixed(begin, (1.0, 0.0, 0.0, 0.0))), stamp(begin))

    with open(payloads, "w") as lines:

        def line(topic, m, ns):
            data = io.BytesIO()
            m.serialize(data)
            lines.write(
                json.dumps(
                    {
                        "topic": topic,
                        "type": m._type,
                        "definition": m._full_text,
                        "time": str(ns),
                        "data": base64.b64encode(data.getvalue()).decode(),
                    }
                )
                + "\n"
            )

        line("/tf_static", TFMessage(fixed(begin)), begin)
        for s in steps:
            line("/tf", TFMessage([transform(s[0], "odom", "base_footprint", s[1], s[2], q=turn(s[3]))]), s[0])
            line("/scan", scan(s), s[0])


if __name__ == "__main__":
    main(*sys.argv[1:])

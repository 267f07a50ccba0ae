"""A simulated drive as the text that all samples are made of: see datasets/ros/README.md."""
import math
import sys

BEGIN_NS = 1_700_000_000_000_000_000


def read(path):
    """The steps of drive.txt: (time_ns, x, y, yaw, ranges)."""
    steps = []
    for line in open(path):
        if line.startswith("#"):
            continue
        words = line.split()
        numbers = [float(w) for w in words[1:]]
        steps.append((int(words[0]), *numbers[:3], numbers[3:]))
    return steps


def main(log, out):
    with open(out, "w") as text:
        text.write("# time_ns x y yaw ranges: robot in odom, m and rad; 61 beams from -90 to 90 degrees\n")
        for line in open(log):
            words = line.split()
            if not words or words[0] != "ROBOTLASER1":
                continue
            count = int(words[8])
            ranges = [float(w) for w in words[9 : 9 + count]]
            pose = words[9 + count + 1 + 3 :][:3]
            reach = float(words[5])
            time_ns = BEGIN_NS + round(float(words[-3]) * 1e9)
            beams = ["inf" if r >= reach else "%.3f" % r for r in ranges]
            text.write(" ".join([str(time_ns), *pose, *beams]) + "\n")


if __name__ == "__main__":
    main(*sys.argv[1:])

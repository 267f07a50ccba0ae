#!/usr/bin/env python3
"""Reads what ariadne-slam writes, with Python's standard library alone: results.py RUN [TRUTH.tum]

Prints the figures of a run from summary.json, steps.csv and loops.json, and with a true path the ATE as ariadne-eval
and evo compute it: positions of equal stamps, after the rotation and shift that fit best, root mean square.
"""
import csv
import json
import math
import pathlib
import sys


def read_tum(path):
    """{stamp: (x, y)} in s and m."""
    poses = {}
    for line in pathlib.Path(path).read_text().splitlines():
        if line and not line.startswith("#"):
            stamp, x, y = (float(word) for word in line.split()[:3])
            poses[stamp] = (x, y)
    return poses


def nearest(stamps, stamp, within_s=0.01):
    """The stamp of a sorted list that is nearest, if it is near."""
    low, high = 0, len(stamps)
    while low < high:
        middle = (low + high) // 2
        low, high = (middle + 1, high) if stamps[middle] < stamp else (low, middle)
    best = min(stamps[max(low - 1, 0):low + 1], key=lambda s: abs(s - stamp))
    return best if abs(best - stamp) <= within_s else None


def ate_rmse(estimate, truth):
    """RMSE in m after the best rotation and shift (Horn 1987, in the plane), and the number of pairs."""
    stamps = sorted(truth)
    pairs = [(p, truth[s]) for stamp, p in estimate.items() if (s := nearest(stamps, stamp)) is not None]
    n = len(pairs)
    mean = [sum(pair[i][j] for pair in pairs) / n for i in (0, 1) for j in (0, 1)]
    centred = [((a[0] - mean[0], a[1] - mean[1]), (b[0] - mean[2], b[1] - mean[3])) for a, b in pairs]
    along = sum(a[0] * b[0] + a[1] * b[1] for a, b in centred)
    across = sum(a[0] * b[1] - a[1] * b[0] for a, b in centred)
    turn = math.atan2(across, along)
    c, s = math.cos(turn), math.sin(turn)
    squares = sum((c * a[0] - s * a[1] - b[0]) ** 2 + (s * a[0] + c * a[1] - b[1]) ** 2 for a, b in centred)
    return math.sqrt(squares / n), n


def main():
    run = pathlib.Path(sys.argv[1])
    summary = json.loads((run / "summary.json").read_text())
    loops = json.loads((run / "loops.json").read_text())
    with open(run / "steps.csv", newline="") as file:
        steps = list(csv.DictReader(file))
    print(f"{summary['dataset']['scans']} scans, {len(steps)} updates, path of {summary['path_length_m']:.1f} m")
    print(f"least Neff {min(float(step['neff']) for step in steps):.1f} of {steps[0]['particles']}")
    for closing in loops["closings"]:
        end = closing["end"]["reason"] if closing["end"] else "still open at the end of the log"
        print(f"closing {closing['closing']}: loop of {closing['detection']['loop_length_m']:.1f} m; {end}")
    if len(sys.argv) > 2:
        ate, pairs = ate_rmse(read_tum(run / "trajectory.tum"), read_tum(sys.argv[2]))
        print(f"ATE {ate:.9f} m over {pairs} poses")


if __name__ == "__main__":
    main()

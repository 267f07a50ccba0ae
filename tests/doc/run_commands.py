#!/usr/bin/python3
"""Runs the commands of README, tutorial and how-tos as they stand there: run_commands.py [--slow] BIN_DIR [PAGE...]

A block of commands is fenced as sh, and a comment in the line before the fence says whether it is run: `run`, `run: slow`
(only with --slow) or `not run: WHY`. The blocks of a page are run one after the other by bash, in a new folder that looks like
the clone and holds the logs that the pages name: my.log, next.log (its second half), drive.bag and a folder of ROS 2.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGES = ["README.md", "doc/tutorial/*.md", "doc/howto/*.md"]
BLOCK = re.compile(r"^(?:<!-- (.*?) -->\n)?```sh\n(.*?)^```", re.M | re.S)
MARK = re.compile(r"run|run: slow|not run: .+")


def blocks(page):
    """(mark, commands) of each block; ends the program where a block has no mark or commands stand in no block."""
    text = page.read_text()
    found = []
    for match in BLOCK.finditer(text):
        mark = match.group(1) or ""
        if not MARK.fullmatch(mark):
            sys.exit(f"{page}:{text.count(chr(10), 0, match.start()) + 1}: a block of commands needs <!-- run -->, "
                     "<!-- run: slow --> or <!-- not run: WHY --> in the line before it")
        found.append((mark, match.group(2)))
    stray = re.search(r"^    (ariadne-|scripts/|build/|example-).*$", BLOCK.sub("", text), re.M)
    if stray:
        sys.exit(f"{page}: \"{stray.group(0).strip()}\" stands in no block fenced as sh")
    return found


def furnish(folder, bin_dir):
    """What a reader has: the clone, its build, a log."""
    for name in ("doc", "ini", "datasets", "examples", "scripts"):
        (folder / name).symlink_to(ROOT / name)
    (folder / "build").mkdir()
    (folder / "build/release").symlink_to(bin_dir.parent)
    subprocess.run([bin_dir / "ariadne-dataset", "export", ROOT / "datasets/drives/small.rawlog", folder / "my.log"],
                   check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    lines = (folder / "my.log").read_text().splitlines(keepends=True)
    (folder / "next.log").write_text("".join(lines[len(lines) // 2:]))
    shutil.copy(ROOT / "datasets/ros/odom.bag", folder / "drive.bag")
    shutil.copytree(ROOT / "datasets/ros/split", folder / "rosbag2_2024_05_01-10_00_00")


def run_page(page, bin_dir, slow):
    """The number of blocks that were run; ends the program when a command fails."""
    wanted = [text for mark, text in blocks(page) if mark == "run" or (slow and mark == "run: slow")]
    if not wanted:
        return 0
    with tempfile.TemporaryDirectory(prefix="ariadne-commands-") as name:
        folder = pathlib.Path(name)
        furnish(folder, bin_dir)
        environment = dict(os.environ, PATH=f"{bin_dir}:{os.environ['PATH']}", ARIADNE_BIN_DIR=str(bin_dir))
        script = "set -euo pipefail\nset -v\n" + "".join(wanted)
        done = subprocess.run(["bash", "-c", script], cwd=folder, env=environment, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
    if done.returncode != 0:
        sys.exit(f"{page}: a command ended with {done.returncode}; the last lines:\n" +
                 "\n".join(done.stdout.splitlines()[-30:]))
    return len(wanted)


def main():
    words = sys.argv[1:]
    slow = "--slow" in words
    words = [word for word in words if word != "--slow"]
    if not words:
        sys.exit(__doc__)
    bin_dir = pathlib.Path(words[0]).resolve()
    pages = [pathlib.Path(word).resolve() for word in words[1:]]
    pages = pages or [page for pattern in PAGES for page in sorted(ROOT.glob(pattern))]
    for page in pages:
        count = run_page(page, bin_dir, slow)
        print(f"{page.relative_to(ROOT)}: {count} blocks run")
    sys.exit(0)


if __name__ == "__main__":
    main()

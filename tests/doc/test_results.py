#!/usr/bin/python3
"""examples/results.py, Python's standard library alone, against ariadne-eval on one run."""
import importlib.util
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(os.environ["ARIADNE_SOURCE_DIR"])
BIN = pathlib.Path(os.environ["ARIADNE_BIN_DIR"])


def load_results():
    spec = importlib.util.spec_from_file_location("results", ROOT / "examples/results.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def run(program, *words):
    return subprocess.run([BIN / program, *words], check=True, capture_output=True, text=True).stdout


class Results(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.keep = tempfile.TemporaryDirectory(prefix="ariadne-results-")
        cls.folder = pathlib.Path(cls.keep.name) / "run"
        run("ariadne-slam", ROOT / "datasets/drives/small.rawlog", "--out", cls.folder, "--particles", "5", "--no-pictures",
            "--quiet")
        cls.truth = ROOT / "datasets/drives/small.rawlog.truth.tum"
        cls.results = load_results()

    @classmethod
    def tearDownClass(cls):
        cls.keep.cleanup()

    def test_ate_is_that_of_ariadne_eval(self):
        told = json.loads(run("ariadne-eval", self.folder / "trajectory.tum", self.truth, "--json"))["truth"]["ate_m"]
        ate, pairs = self.results.ate_rmse(self.results.read_tum(self.folder / "trajectory.tum"),
                                           self.results.read_tum(self.truth))
        self.assertEqual(pairs, told["count"])
        self.assertGreater(ate, 0.001)
        # Both read the same decimals; what is left is the order of sums of some hundred squares.
        self.assertAlmostEqual(ate, told["rmse"], delta=1e-12)

    def test_a_turned_and_shifted_estimate_has_the_same_ate(self):
        truth = self.results.read_tum(self.truth)
        estimate = self.results.read_tum(self.folder / "trajectory.tum")
        moved = {stamp: (3 - y, x - 7) for stamp, (x, y) in estimate.items()}
        self.assertAlmostEqual(self.results.ate_rmse(moved, truth)[0], self.results.ate_rmse(estimate, truth)[0],
                               delta=1e-9)

    def test_the_program_prints_the_figures_of_the_run(self):
        told = subprocess.run([sys.executable, ROOT / "examples/results.py", self.folder, self.truth], check=True,
                              capture_output=True, text=True).stdout
        summary = json.loads((self.folder / "summary.json").read_text())
        self.assertIn(f"{summary['dataset']['scans']} scans, {summary['filter']['updates']} updates", told)
        self.assertIn(f"least Neff {summary['filter']['neff_min']:.1f} of 5", told)
        self.assertIn("ATE ", told)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

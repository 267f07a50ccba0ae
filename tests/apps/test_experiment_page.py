#!/usr/bin/python3
"""test_experiment_page.py ARIADNE_EXPERIMENT: an experiment's report.html in a browser."""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

from selenium import webdriver
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.chrome.service import Service

NASTY = "<script>document.title='hacked'</script> \"it's\" _x^2 {/Bold y} `date`"
# It writes figures and a page; on seed 2 it fails with words that are HTML.
PROGRAM = """#!/bin/sh
config=$1; shift
while [ $# -gt 0 ]; do case $1 in
  --set) sets="$sets
[${2%%.*}]
${2#*.}"; shift 2;;
  --print-config) print=1; shift;;
  --seed) seed=$2; shift 2;;
  --out) out=$2; shift 2;;
  *) shift;;
esac; done
[ -n "$print" ] && { cat "$config"; echo "$sets"; exit 0; }
[ $seed = 2 ] && { echo "<img src=x onerror=\\"document.title='hacked'\\">" >&2; exit 3; }
echo "{\\"ok\\": true, \\"way_m\\": $seed}" > "$out/summary.json"
echo "<title>a run</title>" > "$out/report.html"
"""
EXPERIMENT = f"""[experiment]
title = {NASTY}
[arm.{NASTY}]
program = ./program.sh
config = arm.ini
[arm.other]
program = ./program.sh
config = arm.ini
set.more.key = <b>bold</b>
[factor.laps]
key = factor.laps
values = 1, 2, 4
[seeds]
last = 3
[figures]
names = way_m
success = ok
[limits]
keep_files = true
"""


def start_browser():
    options = webdriver.ChromeOptions()
    options.binary_location = "/usr/bin/chromium"
    for argument in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--disable-gpu"):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    return webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="ariadne-page-")
        here = pathlib.Path(cls.folder.name)
        (here / "program.sh").write_text(PROGRAM)
        (here / "program.sh").chmod(0o755)
        (here / "arm.ini").write_text("[a]\nb = 1\n")
        (here / "e.ini").write_text(EXPERIMENT)
        subprocess.run([PROGRAM_UNDER_TEST, "run", here / "e.ini", "--out", here / "results", "--quiet"])
        (here / "results").rename(here / "moved")  # links must not mind
        cls.browser = start_browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.quit()
        cls.folder.cleanup()

    def setUp(self):
        self.open(1400)

    def tearDown(self):
        severe = [e["message"] for e in self.browser.get_log("browser") if e["level"] == "SEVERE"]
        self.assertEqual(severe, [])
        for entry in self.browser.get_log("performance"):
            message = json.loads(entry["message"])["message"]
            if message["method"] == "Network.requestWillBeSent":
                url = message["params"]["request"]["url"]
                self.assertTrue(url.startswith(("file://" + self.folder.name, "data:")), url)

    def open(self, width):
        self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": width, "height": 1000, "deviceScaleFactor": 1, "mobile": False})
        self.browser.get((pathlib.Path(self.folder.name) / "moved" / "report.html").as_uri())

    def script(self, text):
        return self.browser.execute_script("return " + text)

    def test_names_are_text(self):
        self.assertEqual(self.browser.title, NASTY)
        self.assertEqual(self.browser.find_element(By.TAG_NAME, "h1").text, NASTY)
        self.assertEqual(self.script("document.querySelectorAll('script, img, b').length"), 0)
        self.assertIn("<b>bold</b>", self.browser.find_element(By.ID, "arms").text)
        self.assertIn("<img src=x", self.browser.find_element(By.ID, "failed").text)

    @unittest.skipUnless(shutil.which("gnuplot"), "gnuplot-nox is not installed")
    def test_plots_are_drawn(self):
        boxes = self.script("[...document.querySelectorAll('figure svg')].map((s) => "
                            "[s.getBBox().width, s.querySelectorAll('g > use').length])")
        self.assertEqual(len(boxes), 2)
        for width, marks in boxes:
            self.assertGreater(width, 400)
            self.assertEqual(marks, 6 + 2, "points and legend")
        twice = self.script("(() => { const ids = [...document.querySelectorAll('[id]')].map((e) => "
                            "e.id); return ids.filter((id, i) => ids.indexOf(id) !== i); })()")
        self.assertEqual(twice, [])

    def test_a_run_leads_to_its_report(self):
        summary = self.browser.find_element(By.CSS_SELECTOR, "#runs summary")
        summary.send_keys(Keys.ENTER)
        rows = self.browser.find_element(By.CSS_SELECTOR, "#runs details").text
        self.assertIn("failed: exit code 3", rows)
        self.browser.find_element(By.LINK_TEXT, "report").send_keys(Keys.ENTER)
        self.assertEqual(self.browser.title, "a run")

    def test_it_fits_a_phone(self):
        self.open(360)
        for details in self.browser.find_elements(By.TAG_NAME, "summary"):
            details.send_keys(Keys.ENTER)
        self.assertLessEqual(self.script("document.documentElement.scrollWidth"), 360)

    def test_light_and_dark(self):
        looks = []
        for scheme in ("light", "dark"):
            self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {
                "features": [{"name": "prefers-color-scheme", "value": scheme}]})
            looks.append(self.script("[document.body, ...document.querySelectorAll('figure svg text')]"
                                     ".map((e) => getComputedStyle(e).fill + "
                                     "getComputedStyle(e).backgroundColor)"))
        for light, dark in zip(*looks):
            self.assertNotEqual(light, dark)


if __name__ == "__main__":
    PROGRAM_UNDER_TEST = sys.argv.pop(1)
    unittest.main()

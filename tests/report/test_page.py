#!/usr/bin/python3
"""test_page.py MAKE_PAGES: report.html in a browser, as somebody would use it."""
import hashlib
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

from selenium import webdriver
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.support.ui import WebDriverWait

NASTY = "</script><b>bold</b> \"it's\" & <!-- &amp;.rawlog"


def start_browser():
    options = webdriver.ChromeOptions()
    options.binary_location = "/usr/bin/chromium"
    for argument in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--disable-gpu",
                     "--window-size=1400,1000"):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    return webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="ariadne-page-")
        subprocess.run([MAKE_PAGES, cls.folder.name], check=True)
        cls.browser = start_browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.quit()
        cls.folder.cleanup()

    def tearDown(self):
        severe = [e["message"] for e in self.browser.get_log("browser") if e["level"] == "SEVERE"]
        self.assertEqual(severe, [], "script errors")
        for entry in self.browser.get_log("performance"):
            message = json.loads(entry["message"])["message"]
            if message["method"] == "Network.requestWillBeSent":
                url = message["params"]["request"]["url"]
                self.assertTrue(url.startswith(("file://" + self.folder.name, "data:")), url)

    def open(self, name, width=1400, height=1000, moment="#update=0"):
        self.cdp("Emulation.setDeviceMetricsOverride",
                 {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False})
        self.browser.get("about:blank")  # another moment of the same page would not load it again
        self.browser.get((pathlib.Path(self.folder.name) / name).as_uri() + moment)
        WebDriverWait(self.browser, 10, 0.02).until(
            lambda b: b.execute_script("return document.body.dataset.ready"))

    def cdp(self, command, arguments):
        return self.browser.execute_cdp_cmd(command, arguments)

    def get(self, selector):
        return self.browser.find_element(By.CSS_SELECTOR, selector)

    def all(self, selector):
        return self.browser.find_elements(By.CSS_SELECTOR, selector)

    def keys(self, *keys):
        ActionChains(self.browser).send_keys(*keys).perform()

    def step(self):
        return int(self.get("#slider").get_attribute("value"))

    def last(self):
        return int(self.get("#slider").get_attribute("max"))

    def picture(self, canvas="#map"):
        """A digest of the canvas' pixels once it has been drawn."""
        pixels = self.browser.execute_async_script(
            "const done = arguments[1]; requestAnimationFrame(() => requestAnimationFrame(() => "
            "done(document.querySelector(arguments[0]).toDataURL())))", canvas)
        return hashlib.sha256(pixels.encode()).hexdigest()

    def test_keys_step_and_the_moment_changes(self):
        self.open("full.html")
        self.assertEqual(self.step(), 0)
        self.assertEqual(self.get("#state").text, "at update 0 <u>")
        first, first_chart = self.picture(), self.picture(".chart canvas")
        self.keys(Keys.ARROW_RIGHT, Keys.ARROW_RIGHT, Keys.ARROW_LEFT)
        self.assertEqual(self.step(), 1)
        self.keys(Keys.PAGE_DOWN)
        self.assertEqual(self.step(), 21)
        self.assertEqual(self.get("#state").text, "at update 21 <u>")
        self.assertIn("21 of ", self.get("#readout").text)
        self.assertNotEqual(self.picture(), first)
        self.assertNotEqual(self.picture(".chart canvas"), first_chart, "no cursor in the chart")
        self.keys(Keys.END, Keys.ARROW_RIGHT)
        self.assertEqual(self.step(), self.last())
        self.assertGreater(self.last(), 100)
        self.keys(Keys.HOME, Keys.ARROW_LEFT)
        self.assertEqual(self.step(), 0)
        self.assertEqual(self.picture(), first)

    def test_keys_on_the_slider_step_once(self):
        self.open("full.html")
        self.get("#slider").send_keys(Keys.ARROW_RIGHT, Keys.ARROW_RIGHT)
        self.assertEqual(self.step(), 2)
        self.assertEqual(self.get("#state").text, "at update 2 <u>")

    def test_the_slider_scrubs(self):
        self.open("full.html")
        first = self.picture()
        ActionChains(self.browser).move_to_element(self.get("#slider")).click().perform()
        self.assertAlmostEqual(self.step(), self.last() / 2, delta=3)
        self.assertEqual(self.get("#state").text, f"at update {self.step()} <u>")
        self.assertNotEqual(self.picture(), first)

    def test_a_click_on_a_moment_jumps_there(self):
        self.open("full.html")
        item = next(i for i in self.all("#moments li") if "Decided at 60 <i>" in i.text)
        item.find_element(By.TAG_NAME, "button").click()
        self.assertEqual(self.step(), 60)
        self.assertIn("now", item.get_attribute("class"))
        item.find_element(By.TAG_NAME, "summary").click()
        self.assertIn("utility", item.find_element(By.TAG_NAME, "table").text)

    def test_curves_over_time_or_distance_have_round_ticks(self):
        self.open("full.html")
        ticks = ("return Chart.getChart(document.querySelector('.chart canvas'))"
                 ".scales.x.ticks.map((t) => t.label)")
        self.assertEqual(self.browser.execute_script(ticks)[:3], ["0:00", "0:20", "0:40"])
        self.get("#axis").send_keys("d")
        self.assertEqual(self.browser.execute_script(ticks)[:3], ["0 m", "10 m", "20 m"])

    def test_a_click_in_a_chart_jumps_there(self):
        self.open("full.html")
        canvas = self.get(".chart canvas")
        self.browser.execute_script("arguments[0].scrollIntoView({block: 'center'})", canvas)
        ActionChains(self.browser).move_to_element(canvas).click().perform()
        self.assertAlmostEqual(self.step(), self.last() / 2, delta=0.15 * self.last())

    def test_space_plays_and_stops(self):
        self.open("full.html")
        self.keys(" ")
        WebDriverWait(self.browser, 5, 0.02).until(lambda b: self.step() > 2)
        self.assertEqual(self.get("#play").get_attribute("aria-label"), "Pause")
        self.keys(" ")
        stopped = self.step()
        self.picture()
        self.assertEqual(self.step(), stopped)
        self.assertEqual(self.get("#play").get_attribute("aria-label"), "Play")

    def test_layers_can_be_switched_off_and_all_that_is_known_has_one(self):
        self.open("full.html")
        self.keys(Keys.END)
        labels = self.all("#layers label")
        self.assertEqual([label.text for label in labels],
                         ["frontiers", "graph of places G", "true path",
                          "path of the best particle s*", "planned path and goal", "particles",
                          "shortcut that fired"])
        for label in labels:
            before = self.picture()
            label.click()
            self.assertNotEqual(self.picture(), before, label.text)

    def test_the_map_zooms_and_fits_again(self):
        self.open("full.html")
        whole = self.picture()
        self.get("#zoom-in").click()
        zoomed = self.picture()
        self.assertNotEqual(zoomed, whole)
        ActionChains(self.browser).drag_and_drop_by_offset(self.get("#map"), 60, 30).perform()
        self.assertNotEqual(self.picture(), zoomed)
        self.get("#zoom-fit").click()
        self.assertEqual(self.picture(), whole)

    def test_what_is_not_known_is_absent(self):
        self.open("plain.html")
        self.assertEqual([h.text for h in self.all(".chart h3")],
                         ["Effective number of particles", "Entropy, Eq. (6)"])
        self.assertEqual([label.text for label in self.all("#layers label")],
                         ["path of the best particle s*", "particles"])
        self.open("full.html")
        self.assertEqual(len(self.all(".chart")), 4)

    def test_opens_at_the_end_of_the_run(self):
        self.open("full.html", moment="")
        self.assertEqual(self.step(), self.last())
        self.assertEqual(self.get("#state").text, f"at update {self.last()} <u>")

    def address(self):
        return self.browser.execute_script("return location.hash")

    def test_the_address_names_the_moment(self):
        self.open("full.html", moment="#update=60")
        self.assertEqual(self.step(), 60)
        self.keys(Keys.ARROW_RIGHT)
        self.assertEqual(self.get("#link").text, "#update=61")
        WebDriverWait(self.browser, 5, 0.02).until(lambda b: self.address() == "#update=61")
        self.browser.execute_script("location.hash = '#update=30'")
        WebDriverWait(self.browser, 5, 0.02).until(lambda b: self.step() == 30)
        for nonsense in ("#update=999999", "#update=-1", "#update=x"):
            self.open("full.html", moment=nonsense)
            self.assertEqual(self.step(), self.last())

    def test_moments_can_be_filtered(self):
        self.open("full.html")
        shown = lambda: [i for i in self.all("#moments li") if i.is_displayed()]
        everything, ticks = len(shown()), len(self.all("#ticks i:not([hidden])"))
        self.assertEqual(ticks, everything)
        decisions = next(b for b in self.all("#moment-kinds button") if b.text == "decisions")
        decisions.click()
        self.assertEqual(decisions.get_attribute("aria-pressed"), "false")
        self.assertGreater(len(shown()), 0)
        self.assertLess(len(shown()), everything)
        self.assertEqual([i.text for i in shown() if "· decision" in i.text], [])
        self.assertEqual(len(self.all("#ticks i:not([hidden])")), len(shown()))
        self.assertEqual(self.get("#moments-count").text, f"{len(shown())} of {everything}")
        decisions.click()
        self.assertEqual(len(shown()), everything)

    def test_words_are_explained_by_the_glossary(self):
        self.open("full.html")
        explained = {e.text: e.get_attribute("title") for e in self.all(".term")}
        self.assertIn("effective number of particles", explained["Neff"])
        self.assertIn("Eq. (8)", explained["path of the best particle s*"])
        missing = self.browser.execute_script("return Object.values(kTerms).filter((t) => !kGlossary[t])")
        self.assertEqual(missing, [])

    def in_sight(self, selector):
        return self.browser.execute_script(
            "const box = document.querySelector(arguments[0]).getBoundingClientRect();"
            "return box.height > 0 && box.top >= 0 && box.bottom <= innerHeight;", selector)

    def test_map_and_transport_are_always_in_sight(self):
        for width, height in ((1600, 950), (700, 900), (400, 800)):
            self.open("full.html", width, height)
            for place in ("header", ".chart:last-child", "footer"):
                self.browser.execute_script("document.querySelector(arguments[0]).scrollIntoView()", place)
                for part in ("#map", "#play", "#slider"):
                    self.assertTrue(self.in_sight(part), f"{part} with {place} at {width} x {height}")

    def test_text_is_shown_literally(self):
        self.open("full.html")
        self.assertEqual(self.browser.title, NASTY)
        self.assertEqual(self.get("h1").text, NASTY)
        self.assertIn(NASTY, self.get("#facts").text)
        self.assertIn(NASTY, self.get("#moments").text)
        self.assertEqual(self.all("b, u, #moments li i"), [])

    def test_nothing_overflows_at_any_width(self):
        for width in (320, 400, 900, 1400):
            self.open("full.html", width)
            self.assertLessEqual(
                self.browser.execute_script("return document.documentElement.scrollWidth"), width)
            wide = self.browser.execute_script(
                "return [...document.querySelectorAll('button, select, canvas, input, h1, dd, p')]"
                ".filter((e) => e.getBoundingClientRect().right > innerWidth + 0.5)"
                ".map((e) => e.outerHTML.slice(0, 80))")
            self.assertEqual(wide, [], f"at {width} px")

    def test_dark_and_light(self):
        self.open("full.html")
        looks = []
        for scheme in ("light", "dark"):
            self.cdp("Emulation.setEmulatedMedia",
                     {"features": [{"name": "prefers-color-scheme", "value": scheme}]})
            body = self.get("body").value_of_css_property("background-color")
            looks.append((body, self.picture(), self.picture(".chart canvas")))
        self.cdp("Emulation.setEmulatedMedia", {"features": []})
        for light, dark in zip(*looks):
            self.assertNotEqual(light, dark)

    def test_controls_have_names(self):
        self.open("full.html")
        nameless = self.browser.execute_script(
            "return [...document.querySelectorAll('button, input, select')].filter((e) => "
            "!e.getAttribute('aria-label') && !e.closest('label') && !e.textContent.trim())"
            ".map((e) => e.outerHTML)")
        self.assertEqual(nameless, [])

    def test_a_run_without_steps_says_so(self):
        self.open("empty.html")
        self.assertIn("nothing to replay", self.get("#message").text)
        self.assertFalse(self.get("#content").is_displayed())


if __name__ == "__main__":
    MAKE_PAGES = sys.argv.pop(1)
    unittest.main()

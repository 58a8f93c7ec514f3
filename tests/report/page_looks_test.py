"""Pages of answers in headless Chromium at three widths, light and dark: nothing is cut, no word of a header broken.

Usage: page_looks_test.py THENAR. The demo has the same blocks; `npm run check-folder` in viewer/ looks at its pages.
"""

import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/live"))
from browser import Browser, chromium  # noqa: E402

SKIPPED = 77  # the status that tells ctest so
WIDTHS = [1400, 1024, 390]  # [px]
THENAR = ""

# Commands whose pages have every kind of block: OUT is the page, FOLDER where results go.
ASKED = {
    "fit": ["fit synek2019_H01 --subject an_chao_middle --cross-validate posture -o FOLDER/fit.h5 --report OUT"],
    "posterior": ["fit synek2019_H01 --subject an_chao_middle --method mcmc --draws 100 --warm-up 100 "
                  "--allow-unconverged -o FOLDER/p.nc", "posterior plot FOLDER/p.nc --allow-unconverged -o OUT"],
    "net": ["tendon sweep synek2019_middle --tension EDC=2.9 LU=0.4 --vary PIP3=0:60:20 -o OUT"],
    "forces": ["feasible-force synek2019_middle --posture MCP3_FE=20 PIP3=30 DIP3=15 --axes tip --direction 0 -1 0 "
               "--report OUT"],
    "grasp": ["grasp barrett_bobbin --report OUT"],
    "hands": ["compare --hands barrett,parallel_jaw --objects sphere_70 --approaches 2 --report OUT"],
    "scene": ["simulate pendulum -o OUT"],
    "motion": ["simulate an_chao_index --excitation FDP=0.1 --seconds 0.05 -o OUT"],
    "types": ["study thumb-types --draws 200 --report OUT"],
}


def probe(name):
    """A function that is sent into the page, as an expression that calls it."""
    text = (ROOT / "viewer/tests/probes.js").read_text()
    found = re.search(rf"^export ((?:async )?function {name}\(.*?^}})", text, re.M | re.S)
    return f"({found[1]})()"


class Looks(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.browser = Browser()
        cls.folder = tempfile.mkdtemp(prefix="thenar-pages-")

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()

    def page(self, name):
        out = f"{self.folder}/{name}.html"
        for line in ASKED[name]:
            words = line.replace("OUT", out).replace("FOLDER", self.folder).split()
            done = subprocess.run([THENAR, *words], capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, f"{line}: {done.stderr}")
        return out

    def faults(self, page, width, dark):
        browser = self.browser
        browser.messages.clear()
        browser.resize(width, 900, dark)
        browser.open(f"file://{page}")
        browser.wait("document.readyState === 'complete' && document.querySelector('#report > header')", "the page")
        found = browser.value(probe("openEverything"))
        # Tables and charts take their room a frame later.
        browser.value("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
        for name in ("clippedParts", "brokenWords"):
            found += browser.value(probe(name))
        return found + browser.messages

    def test_every_page_is_whole_at_every_width(self):
        for name in ASKED:
            page = self.page(name)
            for width in WIDTHS:
                for dark in (False, True):
                    with self.subTest(page=name, width=width, dark=dark):
                        self.assertEqual(self.faults(page, width, dark), [])

    # A word that is broken, and text beyond its box, are found: the probes would else find nothing anywhere.
    def test_the_probes_find_faults(self):
        page = pathlib.Path(self.folder) / "bad.html"
        page.write_text("<!doctype html><main id=report><table><tr><th style='display:block;width:3ch;"
                        "overflow-wrap:anywhere'>friction</table><p style='width:3ch;overflow:hidden;"
                        "white-space:nowrap'>cut in the middle</main>")
        self.browser.open(f"file://{page}")
        self.browser.wait("document.readyState === 'complete' && document.querySelector('p')", "the page")
        self.assertEqual(len(self.browser.value(probe("brokenWords"))), 1)
        self.assertEqual(len(self.browser.value(probe("clippedParts"))), 1)


if __name__ == "__main__":
    if chromium() is None:
        print("skipped: the browser chromium is not installed")
        sys.exit(SKIPPED)
    THENAR = str(pathlib.Path(sys.argv.pop(1)).resolve())
    unittest.main(verbosity=2)

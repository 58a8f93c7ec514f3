"""Draws the pictures of docs/live/ and docs/remote.md: `python3 docs/images/draw_live.py PROGRAM`, from the repository root."""

import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tests/live"))
import live_page  # noqa: E402
from browser import Browser  # noqa: E402

IMAGES = pathlib.Path(__file__).parent
SIZE = (1200, 760)
REST = "new Promise((done) => setTimeout(done, 1200))"


class Picture:
    """A program that shows something, and the page that looks at it."""

    def __init__(self, browser, *words):
        self.browser = browser
        self.program = live_page.Program(*words)
        browser.open(self.program.address)
        browser.wait(live_page.FIRST, "the first picture")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.browser.open("about:blank")
        self.program.close()

    def ask(self, method, **params):
        return self.browser.value(f"thenarLive.call('{method}', {json.dumps(params)})")

    def save(self, name):
        self.browser.value(REST)
        self.browser.value("thenarLive.view.fit()")
        self.browser.value(REST)
        self.browser.screenshot(IMAGES / f"{name}.png")


def draw_world(browser):
    with Picture(browser, "human_mug") as page:
        page.ask("hand.grasp")
        page.save("live_world")
        browser.value("thenarLive.tabs.choose('grasp')")
        browser.wait("document.querySelector('.page.grasp')?.textContent.includes('certified')", "the quality")
        browser.click("#show-wrenches")
        browser.wait("document.querySelectorAll('.page.grasp canvas').length >= 2", "wrench sets")
        page.save("live_grasp")


def draw_joint(browser):
    with Picture(browser, "human:tendons") as page:
        page.ask("hand.set_joints", joints={"MCP2_FE": 0.7, "PIP2": 0.8, "DIP2": 0.4})
        browser.value("thenarLive.select({owner: 'human:tendons', joint: 'PIP2'})")
        page.save("live_joint")


def draw_tendons(browser):
    with Picture(browser, "an_chao_middle") as page:
        page.ask("tendons.set", posture={"MCP3_FE": 0.6, "PIP3": 0.7, "DIP3": 0.35}, tensions={"EDC": 3, "FDP": 12, "FDS": 6})
        browser.value("thenarLive.tabs.choose('tendons')")
        browser.wait("[...document.querySelectorAll('.page.tendons option')].some((one) => one.value === 'PIP3')", "joints")
        browser.click("#plot-sweep")
        browser.wait("document.querySelectorAll('.page.tendons .charts figure .u-over').length === 2", "two charts")
        browser.value("document.querySelector('#plot-sweep').scrollIntoView()")
        page.save("live_tendons")


def draw_dynamics(browser):
    with Picture(browser, "wine_glass") as page:
        browser.value("thenarLive.tabs.choose('time')")
        browser.resize(1200, 1000)
        for _ in range(20):
            page.ask("motion.step", steps=100)
        page.save("live_dynamics")
        browser.resize(*SIZE)


def main():
    if len(sys.argv) > 1:
        live_page.PROGRAM = str(pathlib.Path(sys.argv[1]).resolve())
    wanted = sys.argv[2:]
    with Browser(*SIZE) as browser:
        for draw in (draw_world, draw_joint, draw_tendons, draw_dynamics):
            if not wanted or draw.__name__ in wanted:
                draw(browser)
                print(draw.__name__, browser.errors)


if __name__ == "__main__":
    main()

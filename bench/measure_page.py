"""Measures the live page: first picture, from a slider to the picture, memory of script and server while time plays.

Usage: measure_page.py PROGRAM [minutes of play, default 10]. Prints a line a figure; see docs/live/README.md.
"""

import json
import os
import pathlib
import statistics
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "tests" / "live"))
import live_page  # noqa: E402
from browser import Browser  # noqa: E402

# From the input of a slider until the frame that shows the joint there is decoded, its picture is given to
# the browser, and its pixels are finished [ms].
LATENCY = """(async (k) => {
  const app = thenarLive;
  const { store, picture } = app;
  const { stage } = picture;
  const gl = stage.renderer.getContext();
  const index = store.scene.joints.findIndex((j) => !j.led_by);
  const joint = store.scene.joints[index];
  const goal = joint.lower + (joint.upper - joint.lower) * (0.2 + 0.6 * (k % 7) / 7);
  const row = [...document.querySelectorAll('.page.pose .slider')].find((one) => one.dataset.joint === joint.name);
  const slider = row.querySelector('input[type=range]');
  const begin = performance.now();
  return await new Promise((done) => {
    const painted = () => {
      if (Math.abs((picture.frame()?.joints[index] ?? NaN) - goal) > 1e-4) return;
      stage.painted.splice(stage.painted.indexOf(painted), 1);
      const given = performance.now();
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4)); // waits for the pixels
      done([app.frameAt, given, performance.now()].map((at) => at - begin));
    };
    stage.painted.push(painted);
    slider.value = slider.min * 1 + (slider.max - slider.min) * (goal - joint.lower) / (joint.upper - joint.lower);
    slider.dispatchEvent(new Event('input'));
  });
})"""

# From a frame's arrival to its picture [ms].
FRAME = """(() => new Promise((done) => {
  const { stage } = thenarLive.picture;
  const painted = () => {
    stage.painted.splice(stage.painted.indexOf(painted), 1);
    done(performance.now() - thenarLive.frameAt);
  };
  stage.painted.push(painted);
  thenarLive.ask('motion.step', { steps: 1 });
}))()"""


# What came over the network: page, scripts, styles, meshes [bytes].
TRANSFERRED = """[...performance.getEntriesByType('navigation'), ...performance.getEntriesByType('resource')]
  .reduce((sum, entry) => sum + entry.encodedBodySize, 0)"""


def told(name, values, unit):
    values = sorted(values)
    print(f"{name}: median {statistics.median(values):.1f}, worst {values[-1]:.1f} {unit} of {len(values)}", flush=True)


SIZES = [(1400, 900), (1024, 700)]  # of the window [px]


def slider_ways(browser, count):
    """Frame decoded, picture given, pixels finished [ms] of each of so many moves of a slider."""
    browser.value("new Promise((done) => setTimeout(done, 1500))")  # the fine picture is over
    return [browser.value(f"{LATENCY}({k})") for k in range(count)]


def slider_to_pixels(browser, count):
    """The median of so many [ms]."""
    return statistics.median(way[-1] for way in slider_ways(browser, count))


def latencies(browser):
    for width, height in SIZES:
        browser.resize(width, height)
        found = slider_ways(browser, 30)
        for what, values in zip(("frame decoded", "picture given", "pixels finished"), zip(*found)):
            told(f"{width} x {height}, from slider to {what}", values, "ms")
    browser.resize(*SIZES[0])


def resident(program):
    """Memory of the server that is in use [MB]."""
    with open(f"/proc/{program.process.pid}/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 1e6


def first_picture_of(browser, program):
    """Opens the page of a program; when its first picture was there after navigation [ms]."""
    browser.open(program.address)
    browser.wait(live_page.FIRST, "the first picture")
    return browser.value("performance.getEntriesByName('thenar first picture')[0].startTime")


def first_picture(browser):
    begin = time.monotonic()
    program = live_page.Program("human:tendons")
    started = time.monotonic()
    page = first_picture_of(browser, program)
    print(f"human:tendons: address after {1e3 * (started - begin):.0f} ms, first picture {page:.0f} ms after navigation, "
          f"{browser.value(TRANSFERRED) / 1e6:.2f} MB")
    return program


def main():
    live_page.PROGRAM = os.path.abspath(sys.argv[1])
    minutes = float(sys.argv[2]) if len(sys.argv) > 2 else 10
    with Browser() as browser:
        program = first_picture(browser)
        latencies(browser)
        browser.value(f"thenarLive.call('motion.open', {json.dumps({'scene': 'stack'})})")
        browser.wait("thenarLive.store.scene.mode === 'motion' && thenarLive.store.frame")
        told("frame to picture", [browser.value(FRAME) for _ in range(30)], "ms")
        browser.click("#play")
        end = time.monotonic() + 60 * minutes
        while time.monotonic() < end:
            browser.send("HeapProfiler.collectGarbage")
            heap = browser.value("performance.memory.usedJSHeapSize")
            paints = browser.value("thenarLive.picture.stage.paints")
            print(f"heap {heap / 1e6:.1f} MB, server {resident(program):.1f} MB after {paints} pictures, "
                  f"errors {browser.errors}", flush=True)
            # A scene pauses where its time ends.
            if not browser.value("thenarLive.store.state.motion.playing"):
                browser.click("#play")
            time.sleep(min(60, max(1, 60 * minutes / 5)))
        program.close()


if __name__ == "__main__":
    main()

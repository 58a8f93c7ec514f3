"""The program `thenar view` with a browser that looks at it, for tests of the live page."""

import os
import pathlib
import re
import select
import signal
import subprocess
import sys
import tempfile
import time
import unittest

from browser import PATIENCE, Browser, PageError, chromium

ROOT = pathlib.Path(__file__).resolve().parents[2]
WORLDS = sorted((ROOT / "data/worlds").glob("*.toml"))
SKIPPED = 77  # the status that tells ctest so
PROGRAM = os.environ.get("THENAR", "thenar")
PICTURES = pathlib.Path(os.environ.get("LIVE_PICTURES", tempfile.gettempdir()))

FIRST = "performance.getEntriesByName('thenar first picture').length > 0"

# Share of the picture's pixels that have a colour: a grid on an empty page has none.
COLORED = """(() => {
  const canvas = thenarLive.picture.stage.picture();
  const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
  let found = 0;
  for (let i = 0; i < data.length; i += 4) {
    const most = Math.max(data[i], data[i + 1], data[i + 2]);
    if (most - Math.min(data[i], data[i + 1], data[i + 2]) > 24) ++found;
  }
  return found / (data.length / 4);
})()"""


class Program:
    """`thenar view` on a port of its own, in a folder of its own."""

    def __init__(self, *words, port=0, folder=None):
        self.folder = folder or tempfile.mkdtemp(prefix="thenar-live-")
        command = [PROGRAM, "view", *map(str, words), "--port", str(port), "--no-open"]
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, cwd=self.folder)
        self.said, end = "", time.monotonic() + PATIENCE
        out = self.process.stdout.fileno()
        while not (found := re.search(r"(http://127\.0\.0\.1:(\d+)/\S*)\s", self.said)):
            ready, _, _ = select.select([out], [], [], max(0, end - time.monotonic()))
            part = os.read(out, 65536) if ready else b""
            if not part:
                self.close()
                raise RuntimeError(f"{' '.join(command)} gives no address: {self.said}")
            self.said += part.decode()
        self.address, self.port = found[1], int(found[2])

    def kill(self):
        self.process.kill()
        self.process.wait()

    def close(self):
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGINT)
            try:
                self.process.wait(20)
            except subprocess.TimeoutExpired:
                self.kill()
        self.process.stdout.close()


class LivePage(unittest.TestCase):
    """A test with one browser; every test starts its own program."""

    @classmethod
    def setUpClass(cls):
        cls.browser = Browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()

    def setUp(self):
        self.programs = []
        self.browser.errors.clear()

    def tearDown(self):
        self.browser.open("about:blank")
        for program in self.programs:
            program.close()

    def start(self, *words, **more):
        program = Program(*words, **more)
        self.programs.append(program)
        self.browser.open(program.address)
        self.browser.wait(FIRST, "the first picture")
        return program

    def ask(self, method, params="{}"):
        """The answer to a request that the page makes; `params` are JavaScript."""
        return self.browser.value(f"thenarLive.call('{method}', {params})")

    def settle(self):
        """Waits until the server has nothing to do and the page has drawn its last frame."""
        self.browser.value("thenarLive.call('session.hello')")
        self.browser.value("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")

    def assert_no_errors(self):
        notes = self.browser.value("[...document.querySelectorAll('.note-box.error p')].map((n) => n.textContent)")
        self.assertEqual(self.browser.errors + notes, [])


def main():
    """Runs the tests of the file that calls; arguments: program, folder for pictures."""
    global PROGRAM, PICTURES
    if chromium() is None:
        print("skipped: the browser chromium is not installed")
        sys.exit(SKIPPED)
    if len(sys.argv) > 1:
        PROGRAM = sys.argv.pop(1)
    if len(sys.argv) > 1:
        PICTURES = pathlib.Path(sys.argv.pop(1))
    unittest.main(module="__main__", verbosity=2)


__all__ = ["COLORED", "FIRST", "PICTURES", "ROOT", "WORLDS", "LivePage", "PageError", "Program", "main"]

"""Files to and from the page: drops, pictures, glTF, drawings, films, downloads.

Usage: live_files_test.py PROGRAM [folder for pictures].
"""

import json
import pathlib
import tempfile
import time
import tomllib
import xml.etree.ElementTree as xml

import live_page
from browser import PATIENCE
from live_page import ROOT, LivePage

WORLD = ROOT / "data/worlds/jaw_box.toml"

# A tetrahedron with sides of 40 mm, outward faces.
TETRAHEDRON = """v 0 0 0
v 0.04 0 0
v 0 0.04 0
v 0 0 0.04
f 1 3 2
f 1 2 4
f 1 4 3
f 2 3 4
"""


class Files(LivePage):
    def setUp(self):
        super().setUp()
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="thenar-files-"))
        self.browser.send("Page.setDownloadBehavior", behavior="allow", downloadPath=str(self.folder))

    def saved(self, pattern):
        """The file that the page saves under a name like this, once it is whole."""
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            found = [f for f in self.folder.glob(pattern) if f.stat().st_size]
            if found and not list(self.folder.glob("*.crdownload")):
                return found[0]
            time.sleep(0.05)
        self.fail(f"{pattern} was not saved; there is {[f.name for f in self.folder.iterdir()]}")

    def drop(self, files):
        """Drops files { name: text } onto the page."""
        self.browser.value("(() => { const data = new DataTransfer();"
                           f"for (const [name, text] of Object.entries({json.dumps(files)}))"
                           "  data.items.add(new File([text], name));"
                           "document.body.dispatchEvent(new DragEvent('drop', { dataTransfer: data, bubbles: true }));"
                           "})()")

    def test_a_dropped_mesh_becomes_an_object(self):
        self.start(WORLD)
        before = len(self.ask("world.get")["bodies"])
        self.drop({"wedge.obj": TETRAHEDRON})
        self.browser.wait("document.querySelector('dialog[open] .main')", "the question what it is")
        self.browser.click("dialog[open] .main")
        self.browser.wait(f"thenarLive.call('world.get').then((w) => w.bodies.length === {before + 1})", "one body more")
        self.browser.wait("document.querySelector('.tree').textContent.includes('wedge')", "its name in the tree")
        self.browser.wait("!document.querySelector('#undo').disabled")
        self.browser.click("#undo")
        self.browser.wait(f"thenarLive.call('world.get').then((w) => w.bodies.length === {before})", "it is undone")
        self.assert_no_errors()

    def test_what_is_no_mesh_is_refused_in_words(self):
        self.start(WORLD)
        self.drop({"noise.stl": "this is no mesh"})
        self.browser.wait("document.querySelector('dialog[open] .main')")
        self.browser.click("dialog[open] .main")
        self.browser.wait("document.querySelector('.note-box.error')", "a note")
        self.assertIn("world.import", self.browser.value("document.querySelector('.note-box.error p').textContent"))

    def test_a_dropped_world_is_opened(self):
        self.start()
        text = self.start(WORLD) and self.ask("world.text")["toml"]
        self.ask("world.new")
        self.browser.wait("thenarLive.store.scene.bodies.length === 0")
        self.browser.value("thenarLive.mayLeave = async () => true")
        self.drop({"mine.toml": text})
        self.browser.wait("thenarLive.store.scene.bodies.length > 0", "the world")

    def test_picture_scene_and_world_are_saved(self):
        self.start(WORLD)
        self.browser.value("thenarLive.savePicture()")
        self.assertEqual(self.saved("*.png").read_bytes()[:8], b"\x89PNG\r\n\x1a\n")
        self.browser.value("thenarLive.saveGltf()")
        scene = json.loads(self.saved("*.gltf").read_text())
        self.assertEqual(scene["asset"]["version"], "2.0")
        self.browser.click("#save")
        self.browser.wait("document.querySelector('#save-download')")
        self.browser.click("#save-download")
        self.assertIn("hand", tomllib.loads(self.saved("*.toml").read_text()))
        self.assert_no_errors()

    def test_a_film_is_recorded(self):
        self.start(WORLD)
        self.browser.value("thenarLive.film()")
        turn = "(thenarLive.picture.stage.controls.rotateLeft(0.1), thenarLive.picture.stage.paints)"
        begin = self.browser.value(turn)
        self.browser.wait(f"{turn} > {begin + 20}", "twenty pictures")
        self.browser.value("thenarLive.film()")
        film = self.saved("*.webm").read_bytes()
        self.assertEqual(film[:4], b"\x1a\x45\xdf\xa3")
        self.assertGreater(len(film), 2000)

    def test_a_film_is_pictures_where_the_browser_cannot_record(self):
        self.start(WORLD)
        self.browser.value("(window.MediaRecorder = undefined, thenarLive.film())")
        self.browser.value("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
        for k in range(2):
            self.browser.value(f"(thenarLive.picture.stage.controls.rotateLeft({0.1 * (k + 1)}),"
                               "thenarLive.picture.stage.paintNow(false))")
        self.browser.value("thenarLive.film()")
        first, second = self.saved("*_0001.png").read_bytes(), self.saved("*_0002.png").read_bytes()
        for picture in (first, second):
            self.assertEqual(picture[:8], b"\x89PNG\r\n\x1a\n")
            self.assertEqual(int.from_bytes(picture[16:20], "big"), 1400)
        self.assertNotEqual(first, second)

    def test_charts_are_saved_as_drawings(self):
        self.start()
        self.ask("tendons.open", json.dumps({"subject": "an_chao_middle"}))
        self.browser.wait("thenarLive.tabs.chosen() === 'tendons' && document.querySelector('#plot-sweep')")
        self.browser.wait("document.querySelectorAll('.page.tendons .table-frame tbody tr').length", "tensions")
        self.browser.click("#plot-sweep")
        self.browser.wait("document.querySelectorAll('.page.tendons .charts figure .u-over').length === 2")
        self.browser.value("thenarLive.saveCharts()")
        drawing = xml.fromstring(self.saved("*oment*.svg").read_text())
        self.assertTrue(drawing.tag.endswith("svg"))
        self.assertGreater(len(list(drawing.iter("{http://www.w3.org/2000/svg}path"))), 2)
        self.assert_no_errors()


if __name__ == "__main__":
    live_page.main()

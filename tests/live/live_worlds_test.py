"""Every built-in world is opened in a browser: no error, a picture, nothing from elsewhere.

Usage: live_worlds_test.py PROGRAM [folder for pictures].
"""

import live_page
from live_page import COLORED, WORLDS, LivePage


class Worlds(LivePage):
    def test_every_world_is_drawn(self):
        for world in WORLDS:
            with self.subTest(world=world.stem):
                self.start(world)
                self.assertGreater(self.browser.value(COLORED), 0.0005)
                meshes = self.browser.value("thenarLive.store.scene.bodies.filter((b) => b.mesh).length")
                drawn = self.browser.value("thenarLive.picture.bodies.meshes().length")
                self.assertEqual(drawn, meshes)
                self.assert_no_errors()

    def test_nothing_comes_from_elsewhere(self):
        self.browser.requests.clear()
        program = self.start(WORLDS[0])
        self.settle()
        self.assertTrue(self.browser.requests)
        for request in self.browser.requests:
            self.assertTrue(request.startswith((f"http://127.0.0.1:{program.port}/", "about:", "blob:")), request)

    def test_page_and_assets_are_small(self):
        self.start(WORLDS[0])
        sizes = self.browser.value("Promise.all(['', 'live.js', 'live.css'].map((name) => fetch('/' + name)"
                                   ".then((r) => r.arrayBuffer()).then((b) => b.byteLength)))")
        print("page, script, style [bytes]:", sizes)
        self.assertLess(sum(sizes), 2_000_000)

    def test_an_empty_world_says_what_to_do(self):
        self.start()
        self.assertIn("Nothing is here yet", self.browser.value("document.querySelector('.tree').textContent"))
        self.assert_no_errors()


if __name__ == "__main__":
    live_page.main()

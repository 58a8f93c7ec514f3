"""The page in three widths, light and dark: nothing overlaps or is cut; pictures are left to be looked at.

Usage: live_looks_test.py PROGRAM [folder for pictures].
"""

import live_page
from live_page import ROOT, LivePage

WORLD = ROOT / "data/worlds/human_mug.toml"
WIDTHS = {1400: 900, 1024: 700, 390: 800}

# Buttons and inputs that are shown but do not lie in the window, or that another thing covers.
LOST = """[...document.querySelectorAll('.bar button, .bar .link, .side-head button')].filter((node) => {
  if (!node.offsetParent) return false;
  const { left, right, top, bottom, width } = node.getBoundingClientRect();
  if (!width) return false;
  const seen = document.elementFromPoint((left + right) / 2, (top + bottom) / 2);
  return left < 0 || right > innerWidth + 0.5 || top < 0 || bottom > innerHeight || !(seen && (node.contains(seen) || seen.contains(node)));
}).map((node) => node.id || node.textContent)"""

# Rows of sliders whose words or numbers do not fit.
CUT = """[...document.querySelectorAll('.slider .value')].filter((node) => node.offsetParent && node.scrollWidth > node.clientWidth + 1)
  .map((node) => node.getAttribute('aria-label'))"""

# Parts of the page that is shown beside the picture which are wider than it.
WIDE = """(() => {
  const pages = document.querySelector('.pages');
  const room = pages.getBoundingClientRect().left + pages.clientWidth + 0.5;
  if (pages.scrollWidth <= pages.clientWidth) return [];
  return [...pages.querySelectorAll('.page:not([hidden]) *')]
    .filter((node) => node.offsetParent && node.getBoundingClientRect().right > room)
    .map((node) => `${node.tagName} ${node.className}`).slice(0, 8).concat([`${pages.scrollWidth} in ${pages.clientWidth}`]);
})()"""

# The tabs that are offered, which are more in a narrow window.
TABS = "[...document.querySelectorAll('.tabs button')].filter((b) => b.offsetParent).map((b) => b.id.slice(4))"

# Whether the legend lies below the triad or the scale bar.
LEGEND = """(() => {
  const { width, height, insets } = thenarLive.picture.stage;
  const box = document.querySelector('.key-box').getBoundingClientRect();
  const [right, bottom] = [width - insets.right, height - insets.bottom];
  const triad = box.left < insets.left + 84 && box.bottom > bottom - 84;
  const bar = box.right > right - 110 && box.bottom > bottom - 36;
  return box.width > 0 && (triad || bar) ? [box.left, box.right, box.bottom, right, bottom] : [];
})()"""


class Looks(LivePage):
    def tearDown(self):
        self.browser.resize(1400, 900)
        super().tearDown()

    def look(self, name):
        self.assertGreater(len(self.browser.screenshot(live_page.PICTURES / f"{name}.png")), 5000)
        self.assertEqual(self.browser.value(LOST), [])
        self.assertEqual(self.browser.value(CUT), [])
        self.assertEqual(self.browser.value(WIDE), [])
        self.assertEqual(self.browser.value(LEGEND), [])
        self.assertLessEqual(self.browser.value("document.documentElement.scrollWidth - innerWidth"), 0)

    def rest(self):
        self.settle()
        self.browser.value("new Promise((done) => setTimeout(done, 600))")

    def test_every_width_and_colour_scheme(self):
        self.start(WORLD)
        for width, height in WIDTHS.items():
            for dark in (False, True):
                with self.subTest(width=width, dark=dark):
                    self.browser.resize(width, height, dark)
                    self.browser.value("thenarLive.tabs.choose('pose')")
                    self.browser.value("thenarLive.view.fit()")
                    self.rest()
                    self.look(f"world_{width}_{'dark' if dark else 'light'}")
        self.assert_no_errors()

    def test_a_grasp_with_its_wrench_sets(self):
        self.start(WORLD)
        self.browser.value("thenarLive.tabs.choose('grasp')")
        self.browser.click("#do-grasp")
        self.browser.wait("document.querySelector('.page.grasp').quality", "the quality")
        # Words go with their arrows.
        words = "thenarLive.picture.stage.labels().map(({ text }) => text).filter((text) => /worst/.test(text)).length"
        self.browser.wait(f"{words} > 0", "words at the worst disturbance")
        self.browser.value("thenarLive.view.vectors(false)")
        self.assertEqual(self.browser.value(words), 0)
        self.browser.value("thenarLive.view.vectors(true)")
        self.browser.click("#show-wrenches")
        self.browser.wait("document.querySelectorAll('.wrenches').length === 2", "two sets")
        self.rest()
        for width, height in WIDTHS.items():
            with self.subTest(width=width):
                self.browser.resize(width, height)
                self.rest()
                self.look(f"grasp_{width}")
        self.assert_no_errors()

    def every_tab(self, name):
        """Looks at each tab while the window goes from wide to narrow."""
        for width, height in WIDTHS.items():
            self.browser.resize(width, height)
            for tab in self.browser.value(TABS):
                with self.subTest(width=width, tab=tab):
                    self.browser.value(f"thenarLive.tabs.choose('{tab}')")
                    self.rest()
                    self.look(f"{name}_{tab}_{width}")

    def test_panels_with_charts_are_not_cut_as_the_window_narrows(self):
        self.start()
        self.browser.value("thenarLive.call('tendons.open', { subject: 'an_chao_middle' })")
        self.browser.wait("thenarLive.store.scene.mode === 'tendons' && thenarLive.store.frame", "a digit")
        self.browser.wait("document.querySelectorAll('.page.tendons .table-frame tbody tr').length", "tensions")
        self.browser.click("#plot-sweep")
        self.browser.wait("document.querySelectorAll('.page.tendons .charts figure .u-over').length === 2", "two charts")
        self.every_tab("tendons")
        self.assert_no_errors()

    def test_panels_of_a_motion_are_not_cut_as_the_window_narrows(self):
        self.start()
        self.browser.value("thenarLive.call('motion.open', { scene: 'pendulum' })")
        self.browser.wait("thenarLive.store.scene.mode === 'motion' && thenarLive.tabs.chosen() === 'time'")
        self.browser.value("thenarLive.call('motion.step', { steps: 20 })")
        self.browser.wait("document.querySelector('.page.time .charts figure .u-over')", "the chart of energies")
        self.every_tab("motion")
        self.assert_no_errors()

    def test_handles_and_dialogs(self):
        self.start(WORLD)
        self.browser.value("thenarLive.select({ owner: thenarLive.store.scene.bodies.find((b) => b.role === 'object').owner })")
        self.browser.wait("thenarLive.picture.place.shown()")
        self.rest()
        self.look("placing_1400")
        self.browser.value("(() => { const j = thenarLive.store.scene.joints.find((j) => !j.led_by);"
                           "return thenarLive.select({ owner: j.hand, joint: j.name }); })()")
        self.rest()
        self.look("joint_1400")
        self.browser.value("thenarLive.openDialog('hands')")
        self.browser.wait("document.querySelector('.catalogue button')")
        self.browser.screenshot(live_page.PICTURES / "open_1400.png")
        self.browser.press("Escape")
        self.browser.value("thenarLive.help()")
        self.browser.screenshot(live_page.PICTURES / "help_1400.png")
        self.browser.press("Escape")
        self.assert_no_errors()

    def test_what_moves_is_drawn_plainly_and_what_rests_finely(self):
        self.start("human:tendons")
        self.rest()
        state = """(() => {
          const { stage, bodies } = thenarLive.picture;
          const triangles = bodies.meshes().map(({ geometry }) => geometry.index?.count ?? 0);
          const skin = bodies.meshes().filter(({ userData }) => userData.layer === "hands");
          return { share: stage.canvas.width / stage.width, shadows: stage.sun.castShadow,
                   triangles: triangles.reduce((a, b) => a + b) / 3,
                   veils: skin.every(({ userData }) => userData.veil.visible),
                   order: skin.map(({ renderOrder }) => renderOrder) };
        })()"""
        fine = self.browser.value(state)
        self.browser.value("thenarLive.picture.stage.paintNow(false)")
        plain = self.browser.value(state)
        self.rest()
        self.assertEqual(self.browser.value(state), fine)
        self.assertGreaterEqual(fine["share"], 1)
        self.assertLess(plain["share"], 1)
        self.assertLess(plain["triangles"], 0.4 * fine["triangles"])
        self.assertEqual([fine["veils"], fine["shadows"], plain["veils"], plain["shadows"]], [True, True, False, False])
        # Near bodies first, each in a place of its own.
        self.assertEqual(len(set(plain["order"])), len(plain["order"]))
        self.assert_no_errors()

    def test_paper_holds_the_picture_alone(self):
        self.start(WORLD)
        self.browser.value("dispatchEvent(new Event('beforeprint'))")
        self.browser.send("Emulation.setEmulatedMedia", media="print")
        self.assertEqual(self.browser.value("getComputedStyle(document.querySelector('.printed')).display"), "block")
        self.assertEqual(self.browser.value("getComputedStyle(document.querySelector('.side')).display"), "none")
        self.browser.send("Emulation.setEmulatedMedia", media="screen")
        self.browser.value("dispatchEvent(new Event('afterprint'))")
        self.assertIsNone(self.browser.value("document.querySelector('.printed')"))


if __name__ == "__main__":
    live_page.main()

"""The page by keys alone, and a server that goes and comes back.

Usage: live_keys_test.py PROGRAM [folder for pictures].
"""

import live_page
from live_page import ROOT, LivePage

WORLD = ROOT / "data/worlds/barrett_bobbin.toml"
CTRL = 2


class Keys(LivePage):
    def tab_to(self, condition):
        """Presses Tab until the element with the focus fulfils a condition on `e`; returns how often."""
        for count in range(120):
            self.browser.press("Tab")
            if self.browser.value(f"(() => {{ const e = document.activeElement; return {condition}; }})()"):
                return count + 1
        self.fail(f"Tab never leads to {condition}")

    def test_a_walk_by_keys_alone(self):
        self.start(WORLD)
        # Every stop of Tab has a name for screen readers, and is seen.
        self.tab_to("e.id === 'new'")
        for _ in range(25):
            self.browser.press("Tab")
            named = self.browser.value("(() => { const e = document.activeElement; return e === document.body || "
                                       "Boolean(e.getAttribute('aria-label') || e.textContent.trim() || e.labels?.length); })()")
            self.assertTrue(named, self.browser.value("document.activeElement.outerHTML"))
        # The picture: the next joint by a key, and a step of it.
        self.browser.value("document.activeElement.blur()")
        self.tab_to("e.classList.contains('gl')")
        self.browser.press("]")
        self.browser.wait("thenarLive.store.selected?.joint", "a joint selected by a key")
        index = self.browser.value("thenarLive.store.scene.joints.findIndex((j) => j.name === thenarLive.store.selected.joint)")
        before = self.browser.value(f"thenarLive.store.frame.joints[{index}]")
        limits = self.browser.value(f"thenarLive.store.scene.joints[{index}]")
        step = 1 if before + 0.02 < limits["upper"] else -1
        self.browser.press("+" if step > 0 else "-")
        self.browser.wait(f"Math.abs(thenarLive.store.frame.joints[{index}] - {before} - {step} * Math.PI / 180) < 1e-5",
                          "a step of one degree")
        said = self.browser.value("document.querySelector('[role=status][aria-live=polite]').textContent")
        self.assertIn(limits["name"], said)
        self.assertIn("\u00b0", said)
        # Undo by keys.
        self.browser.wait("!document.querySelector('#undo').disabled")
        self.browser.press("z", CTRL)
        self.browser.wait(f"Math.abs(thenarLive.store.frame.joints[{index}] - {before}) < 1e-6", "undo by keys")
        # Escape deselects, "?" tells all keys, Escape closes the help.
        self.browser.press("Escape")
        self.browser.wait("thenarLive.store.selected === null")
        self.browser.press("?", 8)
        self.browser.wait("document.querySelector('.help-dialog[open]')", "the help")
        self.browser.press("Escape")
        self.browser.wait("!document.querySelector('.help-dialog[open]')")
        self.assert_no_errors()

    def test_a_thing_is_moved_by_arrow_keys(self):
        self.start(WORLD)
        self.browser.value("thenarLive.select({ owner: thenarLive.store.scene.bodies.find((b) => b.role === 'object').owner })")
        self.browser.wait("thenarLive.picture.place.shown()")
        before = self.browser.value("thenarLive.poseOf(thenarLive.store.selected.owner)")
        self.browser.value("thenarLive.picture.stage.canvas.focus()")
        self.browser.press("z")
        self.browser.press("ArrowUp")
        self.browser.press("ArrowRight")
        self.browser.wait(f"Math.abs(thenarLive.poseOf(thenarLive.store.selected.owner)[2] - {before[2]} - 0.011) < 1e-6",
                          "11 mm up")
        self.assert_no_errors()

    def test_a_number_beyond_its_limit_becomes_the_limit(self):
        self.start(WORLD)
        self.browser.wait("document.querySelectorAll('.page.pose .slider').length", "sliders")
        told = self.browser.value("""(() => {
          const row = [...document.querySelectorAll('.page.pose .slider')].find((one) => !one.classList.contains('off'));
          const value = row.querySelector('.value');
          value.focus();
          value.value = '9999';
          value.dispatchEvent(new Event('change'));
          return [Number(value.value), Number(row.querySelector('input[type=range]').max)];
        })()""")
        self.assertAlmostEqual(told[0], told[1], delta=0.05)  # a digit of it is shown

    def test_a_slider_goes_to_its_limit_by_the_end_key(self):
        self.start(WORLD)
        self.browser.value("thenarLive.tabs.choose('pose')")
        self.browser.value("document.querySelector('.page.pose input[type=range]:not(:disabled)').focus()")
        self.browser.press("End")
        joint = self.browser.value("document.activeElement.closest('.slider').dataset.joint")
        self.browser.wait("(() => { const s = thenarLive.store; const i = s.scene.joints.findIndex((j) => j.name === "
                          f"{joint!r}); return Math.abs(s.frame.joints[i] - s.scene.joints[i].upper) < 1e-6; }})()",
                          "the joint at its upper limit")
        self.assert_no_errors()

    def test_a_server_that_comes_back_is_found_again(self):
        token = ["--token", "0123456789abcdef"]  # one that is made is another one every time
        program = self.start(WORLD, *token)
        self.browser.value("globalThis.stillHere = true")
        program.kill()
        self.browser.wait("!document.querySelector('.lost').hidden", "the banner")
        self.assertIn("lost", self.browser.value("document.querySelector('.lost').textContent"))
        self.browser.value("thenarLive.ask('world.get')")
        self.browser.wait("document.querySelector('.note-box.error')", "a note that nobody is there")
        again = live_page.Program(WORLD, *token, port=program.port)
        self.programs.append(again)
        self.browser.wait("document.querySelector('.lost').hidden && thenarLive.link.connected()", "the link again")
        self.browser.wait("thenarLive.store.frame", "a frame of the new server")
        self.assertTrue(self.browser.value("globalThis.stillHere"))
        self.assertTrue(self.browser.value("thenarLive.call('session.hello').then((h) => h.program === 'thenar')"))


if __name__ == "__main__":
    live_page.main()

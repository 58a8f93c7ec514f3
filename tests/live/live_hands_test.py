"""A hand is moved and grasps, in a browser; numbers that are shown are held against the command's.

Usage: live_hands_test.py PROGRAM [folder for pictures].
"""

import json
import math
import pathlib
import subprocess

import live_page
from live_page import ROOT, LivePage

WORLD = ROOT / "data/worlds/barrett_bobbin.toml"


def command(*words):
    return json.loads(subprocess.run([live_page.PROGRAM, *map(str, words)], capture_output=True, text=True,
                                     check=True).stdout)

# What the panel says of the grasp: { term: words }.
FACTS = """Object.fromEntries([...document.querySelectorAll('#quality dt')].map((term) =>
  [term.textContent, term.nextElementSibling.textContent]))"""


class Hands(LivePage):
    def select_joint(self):
        """Selects the first joint that turns; returns it with its place."""
        self.browser.value("(() => { const s = thenarLive.store; const j = s.scene.joints.find((j) => !j.slides && "
                           "!j.led_by); return thenarLive.select({ owner: j.hand, joint: j.name }); })()")
        self.settle()
        return self.browser.value("(() => { const s = thenarLive.store; const i = s.scene.joints.findIndex((j) => "
                                  "j.name === s.selected.joint && j.hand === s.selected.owner);"
                                  "return { ...s.scene.joints[i], index: i, value: s.frame.joints[i] }; })()")

    def rim(self, angle):
        """Where the rim of the joint's disc is seen, at an angle from its needle."""
        return self.browser.value(f"(() => {{ const p = thenarLive.picture; return p.stage.pixel(p.joint.rim({angle}));"
                                  "})()")

    def drag(self, way):
        """Drags the needle of the joint that is selected round the rim."""
        points = [self.rim(way * k / 24) for k in range(25)]
        self.browser.mouse("mouseMoved", **points[0])
        self.browser.mouse("mousePressed", **points[0], buttons=1)
        for point in points[1:]:
            self.browser.mouse("mouseMoved", **point, buttons=1)
        self.browser.mouse("mouseReleased", **points[-1])
        self.settle()

    def test_the_first_picture_is_drawn_once_and_of_little_data(self):
        self.start("human:tendons")
        self.assertEqual(self.browser.value("performance.getEntriesByName('thenar first picture')[0].detail.paints"), 1)
        # Page, scripts, fonts and meshes together.
        came = self.browser.value("[...performance.getEntriesByType('navigation'), "
                                  "...performance.getEntriesByType('resource')]"
                                  ".reduce((sum, entry) => sum + entry.encodedBodySize, 0)")
        self.assertGreater(came, 1e5)
        self.assertLess(came, 2e6)
        self.assert_no_errors()

    def test_undo_takes_back_a_drag_and_no_more(self):
        self.start(WORLD)
        joint = self.select_joint()
        now = f"thenarLive.store.frame.joints[{joint['index']}]"
        values = [joint["value"]]
        for _ in range(2):  # the disc turns with the joint
            self.drag(0.2)
            values.append(self.browser.value(now))
        # Two pulls of its slider.
        for share in (0.7, 0.9):
            self.browser.value("(() => { const s = document.querySelector('.slider.marked input[type=range]');"
                               f"for (const part of [0.98, 0.99, 1]) {{ s.value = s.min * 1 + {share} * part * (s.max - s.min);"
                               "s.dispatchEvent(new Event('input', { bubbles: true })); }"
                               "s.dispatchEvent(new Event('change', { bubbles: true })); })()")
            self.settle()
            values.append(self.browser.value(now))
        self.assertEqual(values, sorted(set(values)))
        for before in reversed(values[:-1]):
            self.browser.click("#undo")
            self.browser.wait(f"Math.abs({now} - {before}) < 1e-6", f"the joint back at {before}")
        self.assert_no_errors()

    def test_a_joint_is_dragged_to_its_limit(self):
        self.start(WORLD)
        joint = self.select_joint()
        # Well past the upper limit.
        self.drag(joint["upper"] - joint["value"] + 0.5)
        self.browser.wait(f"Math.abs(thenarLive.store.frame.joints[{joint['index']}] - {joint['upper']}) < 1e-6",
                          "the joint at its limit")
        self.settle()
        shown = self.browser.value("document.querySelector('.slider.marked .value').value")
        self.assertEqual(shown, f"{math.degrees(joint['upper']):.1f}")
        asked = self.ask("hand.get", json.dumps({"hand": joint["hand"]}))
        found = next(j for j in asked["joints"] if j["name"] == joint["name"])
        self.assertAlmostEqual(found["value"], joint["upper"], places=12)
        self.assert_no_errors()

    def test_the_quality_shown_is_that_of_the_command(self):
        self.start(WORLD)
        self.browser.value("thenarLive.tabs.choose('grasp')")
        self.browser.click("#do-grasp")
        self.browser.wait("document.querySelector('.page.grasp').quality", "the quality")
        shown = self.browser.value("document.querySelector('.page.grasp').quality")
        said = command("grasp", WORLD, "--json")
        self.assertAlmostEqual(shown["epsilon"]["lower"], said["epsilon"]["lower"], places=12)
        self.assertAlmostEqual(shown["epsilon"]["upper"], said["epsilon"]["upper"], places=12)
        # What is read on the page, in four figures.
        facts = self.browser.value(FACTS)
        bounds = [f"{said['epsilon'][end]:.4g}" for end in ("lower", "upper")]
        self.assertEqual(facts["Epsilon [N per N]"], f"between {bounds[0]} and {bounds[1]} (certified)")
        self.assertIn("\u2713 yes" if said["force_closure"] else "\u2717 no", facts["Force closure"])
        self.assertEqual(facts["Contacts"], str(len(said["contacts"])))
        self.assert_no_errors()

    def test_the_worst_disturbance_is_told_as_its_arrows_point(self):
        self.start(WORLD)
        self.browser.value("thenarLive.tabs.choose('grasp')")
        self.browser.click("#do-grasp")
        self.browser.wait("document.querySelector('.page.grasp').quality", "the quality")
        arrows = ("thenarLive.store.scene.arrows.map(({ name }, i) => "
                  "[name, [...thenarLive.store.frame.arrows.slice(6 * i + 3, 6 * i + 6)]])")
        self.browser.wait(f"({arrows}).some(([, v]) => Math.hypot(...v) > 0)", "arrows of the disturbance")
        drawn = dict(self.browser.value(arrows))
        scale = self.browser.value("document.querySelector('.page.grasp').quality.torque_scale")
        wrench = drawn["worst disturbance: force"] + [m / scale for m in drawn["worst disturbance: moment"]]
        largest = max(map(abs, wrench))
        told = self.browser.value(FACTS)["Worst disturbance"]
        for k, part in enumerate(wrench):
            word = f"{'force along' if k < 3 else 'torque about'} {'+' if part > 0 else chr(0x2212)}{'xyz'[k % 3]}"
            if abs(abs(part) - largest / 3) > 1e-3 * largest:  # too near to the limit to say
                self.assertEqual(word in told, abs(part) > largest / 3, f"{word} in {told}")
        self.assert_no_errors()

    def test_wrench_sets_are_drawn(self):
        self.start(WORLD)
        self.browser.value("thenarLive.tabs.choose('grasp')")
        self.browser.click("#do-grasp")
        self.browser.wait("document.querySelector('.page.grasp').quality", "the quality")
        self.browser.click("#show-wrenches")
        self.browser.wait("document.querySelectorAll('.wrenches canvas, .wrenches .hint:not(.beside)').length === 2", "two sets")
        self.assertTrue(self.browser.value("document.querySelectorAll('.wrenches canvas').length"))
        self.assert_no_errors()

    def test_a_saved_world_comes_back(self):
        program = self.start(WORLD)
        joint = self.select_joint()
        middle = 0.5 * (joint["lower"] + joint["upper"])
        self.browser.value(f"thenarLive.moveJoint(thenarLive.store.scene.joints[{joint['index']}], {middle})")
        before = self.ask("world.text")["toml"]
        self.browser.click("#save")
        self.browser.wait("document.querySelector('#save-here')")
        self.browser.value("document.querySelector('dialog[open] input').value = 'mine.toml'")
        self.browser.click("#save-here")
        self.browser.wait("thenarLive.store.state.world.unsaved === false", "the world saved")
        file = pathlib.Path(program.folder) / "mine.toml"
        self.ask("world.new")
        self.browser.wait("thenarLive.store.scene.bodies.length === 0", "an empty world")
        self.ask("world.load", json.dumps({"world": str(file)}))
        self.browser.wait("thenarLive.store.scene.bodies.length > 0", "the world again")
        self.assertEqual(self.ask("world.text")["toml"], before)
        self.assert_no_errors()

    def test_undo_and_redo(self):
        self.start(WORLD)
        joint = self.select_joint()
        value = f"thenarLive.store.frame.joints[{joint['index']}]"
        goal = 0.5 * (joint["value"] + joint["upper"])
        self.browser.value(f"thenarLive.moveJoint(thenarLive.store.scene.joints[{joint['index']}], {goal})")
        self.browser.wait(f"Math.abs({value} - {goal}) < 1e-6")
        self.browser.wait("!document.querySelector('#undo').disabled")
        self.browser.click("#undo")
        self.browser.wait(f"Math.abs({value} - {joint['value']}) < 1e-6", "the joint back")
        self.browser.wait("!document.querySelector('#redo').disabled")
        self.browser.click("#redo")
        self.browser.wait(f"Math.abs({value} - {goal}) < 1e-6", "the joint moved again")
        self.assert_no_errors()

    def test_a_thing_is_moved_by_its_arrow(self):
        self.start(WORLD)
        name = self.browser.value("thenarLive.store.scene.bodies.find((b) => b.role === 'object').owner")
        self.browser.value(f"thenarLive.select({{ owner: {json.dumps(name)} }})")
        self.browser.wait("thenarLive.picture.place.shown()")
        before = self.browser.value("thenarLive.picture.place.pose().position")
        ends = self.browser.value("""(() => {
          const { stage, place } = thenarLive.picture;
          const at = place.pose().position;
          const metre = (0.06 * (stage.camera.right - stage.camera.left)) / stage.camera.zoom;
          const pixel = (dz) => { const p = stage.camera.position.clone().set(at[0], at[1], at[2] + dz); return stage.pixel(p); };
          return [pixel(metre), pixel(2 * metre), metre];
        })()""")
        self.browser.mouse("mouseMoved", **ends[0])
        self.browser.mouse("mousePressed", **ends[0], buttons=1)
        for k in range(1, 9):
            at = {c: ends[0][c] + (ends[1][c] - ends[0][c]) * k / 8 for c in "xy"}
            self.browser.mouse("mouseMoved", **at, buttons=1)
        self.browser.mouse("mouseReleased", **ends[1])
        self.settle()
        world = self.ask("world.get")
        after = next(b for b in world["bodies"] if b["name"] == name)["position"]
        self.assertAlmostEqual(after[0], before[0], places=9)
        self.assertAlmostEqual(after[1], before[1], places=9)
        self.assertAlmostEqual(after[2] - before[2], ends[2], delta=0.1 * ends[2])
        self.assert_no_errors()


if __name__ == "__main__":
    live_page.main()

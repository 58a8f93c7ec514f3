"""Time, tendons and fits in a browser: every shipped scene opens, plays and is scrubbed; tendons follow sliders.

Usage: live_modes_test.py PROGRAM [folder for pictures].
"""

import json
import subprocess
import tempfile

import live_page
from live_page import COLORED, ROOT, LivePage, PageError

SUBJECT = "an_chao_middle"

TIP_FORCE = """[...document.querySelectorAll('.page.tendons dt')]
  .find((term) => term.textContent === 'along x, y, z')?.nextElementSibling.textContent"""

# Corners of the bodies' box in pixels that are not in the part of the window that no panel covers.
OUTSIDE = """(() => {
  const { stage, bodies } = thenarLive.picture, box = bodies.box(), points = [];
  for (const x of [box.min.x, box.max.x]) for (const y of [box.min.y, box.max.y])
    for (const z of [box.min.z, box.max.z]) points.push(stage.pixel(box.min.clone().set(x, y, z)));
  const { insets } = stage, room = stage.canvas.getBoundingClientRect();
  return points.filter(({ x, y }) => x < room.left + insets.left || x > room.right - insets.right
    || y < room.top + insets.top || y > room.bottom - insets.bottom).length; })()"""


class Modes(LivePage):
    def test_scenes_open_and_step(self):
        self.start()
        for scene in sorted(path.stem for path in (ROOT / "data/scenes").glob("*.toml")):
            with self.subTest(scene=scene):
                self.browser.errors.clear()
                before = self.browser.value("thenarLive.store.scene?.revision ?? -1")
                self.ask("motion.open", json.dumps({"scene": scene}))
                # The scene may come after the answer, while that of before is shown.
                self.browser.wait(f"thenarLive.store.scene.revision !== {before} && thenarLive.store.scene.mode === 'motion' "
                                  "&& thenarLive.store.frame", "a frame")
                self.browser.wait("thenarLive.picture.complete() && !thenarLive.picture.fitting()", "all meshes")
                self.assertGreater(self.browser.value(COLORED), 0.002)
                self.ask("motion.step", "{steps: 3}")
                self.browser.wait("thenarLive.store.frame.time > 0", "time goes on")
                self.assert_no_errors()

    def test_play_pause_and_scrub(self):
        self.start()
        self.ask("motion.open", json.dumps({"scene": "pendulum"}))
        self.browser.wait("thenarLive.store.scene.mode === 'motion' && thenarLive.tabs.chosen() === 'time'")
        self.browser.click("#play")
        self.browser.wait("thenarLive.store.frame?.time > 0.3", "time plays")
        self.browser.wait("document.querySelector('.page.time .charts figure')", "the chart of energies")
        self.browser.screenshot(live_page.PICTURES / "time_1400.png")
        self.browser.click("#play")
        self.browser.wait("thenarLive.store.state.motion.playing === false", "a pause")
        self.settle()
        self.browser.value("(() => { const s = document.querySelector('.scrub'); s.value = 0.1;"
                           "s.dispatchEvent(new Event('input')); })()")
        self.browser.wait("thenarLive.store.frame.time < 0.15", "an instant before")
        self.assertGreater(self.browser.value("Number(document.querySelector('.scrub').max)"), 0.3)
        # Another scene has an end of its own.
        self.ask("motion.open", json.dumps({"scene": "incline_stick"}))
        self.browser.wait("thenarLive.store.frame?.time === 0 && thenarLive.store.state.motion.t === 0", "the other scene")
        self.assertEqual(self.browser.value("document.querySelector('.scrub').max"), "1")
        self.ask("motion.step", "{steps: 2}")
        self.browser.wait("thenarLive.store.frame.time > 0", "time goes on")
        self.assertLess(self.browser.value("Number(document.querySelector('.scrub').max)"), 0.3)
        self.assert_no_errors()

    def test_play_pauses_where_the_scene_ends_and_says_so(self):
        self.start()
        self.ask("motion.open", json.dumps({"scene": "falling_ball"}))
        self.browser.wait("thenarLive.store.scene.mode === 'motion' && thenarLive.tabs.chosen() === 'time' && thenarLive.store.frame")
        words = "!document.querySelector('#scene-end').hidden"
        self.assertFalse(self.browser.value(words))
        self.browser.click("#play")
        self.browser.wait(words, "words of the end")
        self.assertEqual(self.browser.value("document.querySelector('#play').textContent"), "Play")
        self.assertAlmostEqual(self.browser.value("thenarLive.store.frame.time"), 0.6, 9)  # duration_s of the file
        # Play goes on from there, and an instant before is no end.
        self.browser.click("#play")
        self.browser.wait("thenarLive.store.frame.time > 0.7", "time goes on")
        self.assertFalse(self.browser.value(words))
        self.browser.click("#play")
        self.browser.wait("thenarLive.store.state.motion.playing === false", "a pause")
        self.ask("motion.seek", "{t: 0.3}")
        self.browser.wait("thenarLive.store.frame.time < 0.35", "an instant before")
        self.assertFalse(self.browser.value(words))
        self.ask("motion.seek", "{t: 0.6}")
        self.browser.wait(words, "words of the end, sought")
        self.assert_no_errors()

    def test_a_motion_says_how_far_to_believe_it(self):
        self.start()
        self.ask("motion.open", json.dumps({"scene": "falling_ball"}))
        self.browser.wait("thenarLive.store.scene.mode === 'motion' && thenarLive.tabs.chosen() === 'time' && thenarLive.store.frame")
        account = "document.querySelector('.page.time .account')?.textContent ?? ''"
        warning = "[...document.querySelectorAll('.page.time p.warning')].filter((p) => !p.hidden).map((p) => p.textContent).join()"
        self.ask("motion.step", "{steps: 300}")
        self.browser.wait(f"({account}).includes('Restitution ignored')", "the account of the ball")
        for words in ("Energy error", "turned over", "Deepest overlap", "up to 0.8"):
            self.assertIn(words, self.browser.value(account))
        self.assertEqual(self.browser.value(warning), "")
        # A pendulum in steps as long as a tenth of its period makes energy of nothing.
        self.ask("motion.open", json.dumps({"scene": "pendulum", "step": 0.1}))
        self.ask("motion.step", "{steps: 12}")
        self.browser.wait(f"({warning}).includes('Energy does not balance')", "a warning")
        self.browser.screenshot(live_page.PICTURES / "account_1400.png")
        self.assert_no_errors()

    def test_the_camera_steps_back_from_what_leaves_the_picture(self):
        self.start()
        self.ask("motion.open", json.dumps({"scene": "pendulum"}))
        self.browser.wait("thenarLive.store.scene.mode === 'motion' && thenarLive.store.frame && thenarLive.picture.complete()"
                          "&& !thenarLive.picture.fitting()", "the pendulum")
        self.assertEqual(self.browser.value(OUTSIDE), 0)
        for _ in range(10):
            self.ask("motion.step", "{steps: 50}")
            self.settle()
            self.assertEqual(self.browser.value(OUTSIDE), 0)
        # Half a period later it has been on the other side; who zooms in by hand stays there.
        zoom = "thenarLive.picture.stage.camera.zoom"
        self.browser.value("(() => { const { camera } = thenarLive.picture.stage; camera.zoom = 3; "
                           "camera.updateProjectionMatrix(); })()")
        self.ask("motion.step", "{steps: 200}")
        self.settle()
        self.assertEqual(self.browser.value(zoom), 3)
        self.assert_no_errors()

    def test_the_camera_steps_back_in_recorded_runs(self):
        folder = tempfile.mkdtemp(prefix="thenar-live-")
        subprocess.run([live_page.PROGRAM, "simulate", "pendulum", "-o", f"{folder}/run.h5"], check=True, capture_output=True)
        self.start(f"{folder}/run.h5")
        self.browser.wait("thenarLive.store.scene.mode === 'motion' && thenarLive.store.frame && thenarLive.picture.complete()"
                          "&& !thenarLive.picture.fitting()", "the run")
        # Also where the run is sought far from what was shown before.
        for t in (0, 1.9, 0.3, 1.2, 0.6, 0.9):
            self.ask("motion.seek", json.dumps({"t": t}))
            self.settle()
            self.assertEqual(self.browser.value(OUTSIDE), 0, f"at {t} s")
        self.assert_no_errors()

    def test_a_program_that_connects_leaves_the_chart_and_the_slider_alone(self):
        program = self.start()
        self.ask("motion.open", json.dumps({"scene": "pendulum"}))
        self.browser.wait("thenarLive.store.scene.mode === 'motion' && thenarLive.tabs.chosen() === 'time'")
        self.ask("motion.step", "{steps: 50}")
        self.browser.wait("document.querySelector('.page.time .charts figure')", "the chart of energies")
        self.ask("motion.seek", "{t: 0.01}")
        self.settle()
        seen = ("[Number(document.querySelector('.scrub').max), "
                "document.querySelectorAll('.page.time .charts figure').length]")
        before = self.browser.value(seen)
        # Another page of the same session is told the scene, and with it all others.
        self.browser.value("""new Promise((done) => {
          const other = new WebSocket(location.href.replace(/^http/, 'ws').replace(/\\/(\\?|$)/, '/ws$1'));
          other.onmessage = () => { other.close(); done(true); };
        })""")
        self.settle()
        self.browser.value("thenarLive.call('motion.seek', { t: 0.005 })")
        self.settle()
        self.assertEqual(self.browser.value(seen), before)
        self.assertGreater(before[0], 0.02)
        self.assert_no_errors()

    def test_a_recorded_run_has_no_empty_heading(self):
        folder = tempfile.mkdtemp(prefix="thenar-live-")
        subprocess.run([live_page.PROGRAM, "simulate", "pendulum", "-o", f"{folder}/run.h5"], check=True, capture_output=True)
        self.start(f"{folder}/run.h5")
        self.browser.wait("thenarLive.store.scene.mode === 'motion' && thenarLive.store.frame", "the run")
        self.assertIsNone(self.browser.value("document.querySelector('.page.time .part[aria-label=Energy]').offsetParent"))

    def test_a_world_moves_after_a_grasp(self):
        self.start(ROOT / "data/worlds/jaw_box.toml")
        self.browser.value("thenarLive.tabs.choose('grasp')")
        self.browser.click("#do-grasp")
        self.browser.wait("document.querySelector('.page.grasp').quality", "the quality")
        # Words at the arrows of its worst disturbance are of the world alone.
        self.browser.wait("thenarLive.picture.tips().length > 0", "arrows")
        self.assertEqual(self.browser.value("""(() => {
          const { store, picture } = thenarLive, scene = { ...store.scene, arrows: [] };
          picture.show(scene);
          store.scene = scene;
          return picture.stage.labels();
        })()"""), [])
        self.browser.value("thenarLive.tabs.choose('time')")
        self.browser.click("#begin-motion")
        self.browser.wait("thenarLive.store.scene.mode === 'motion' && thenarLive.store.frame", "the world in time")
        self.settle()
        self.assert_no_errors()

    def test_a_world_begins_to_move(self):
        self.start(ROOT / "data/worlds/jaw_box.toml")
        self.browser.value("thenarLive.tabs.choose('time')")
        self.browser.click("#begin-motion")
        self.browser.wait("thenarLive.store.scene.mode === 'motion' && thenarLive.store.frame", "the world in time")
        self.browser.click("#step")
        self.browser.wait("thenarLive.store.frame.time > 0", "one step")

    def test_tendons_follow_sliders(self):
        self.start()
        self.ask("tendons.open", json.dumps({"subject": SUBJECT}))
        self.browser.wait("thenarLive.store.scene.mode === 'tendons' && thenarLive.store.frame", "a digit")
        self.browser.wait("document.querySelectorAll('.page.tendons .table-frame tbody tr').length", "tensions")
        muscle = self.ask("tendons.state")["muscles"][0]
        self.browser.value(f"""(() => {{
          const row = [...document.querySelectorAll('.page.tendons .part[aria-label=Tensions] .slider')]
            .find((one) => one.dataset.name === {json.dumps(muscle['name'])});
          const value = row.querySelector('.value');
          value.focus(); value.value = '4.5'; value.dispatchEvent(new Event('change'));
        }})()""")
        self.browser.wait("thenarLive.store.frame.tensions.some((t) => Math.abs(t - 4.5) < 1e-4)", "a line under 4.5 N")
        self.assertAlmostEqual(self.ask("tendons.state")["muscles"][0]["tension"], 4.5)
        # The tip force is told as its arrow points, in the frame of the triad.
        self.browser.wait(f"({TIP_FORCE})", "a tip force")
        told = [float(v.replace(chr(0x2212), "-")) for v in self.browser.value(TIP_FORCE).split(" N")[0].split(",")]
        drawn = self.browser.value("(() => { const i = thenarLive.store.scene.arrows.findIndex(({ name }) => name === 'tip force');"
                                   "return [...thenarLive.store.frame.arrows.slice(6 * i + 3, 6 * i + 6)]; })()")
        self.assertGreater(max(map(abs, drawn)), 0.1)
        for a, b in zip(told, drawn):
            self.assertAlmostEqual(a, b, delta=0.00501)  # two decimals are shown
        self.browser.click("#plot-sweep")
        self.browser.wait("document.querySelectorAll('.page.tendons .charts figure .u-over').length === 2", "two charts")
        self.browser.value("new Promise((done) => setTimeout(done, 600))")
        self.browser.screenshot(live_page.PICTURES / "tendons_1400.png")
        # The line that marks the posture goes with the joint.
        joint = self.browser.value("thenarLive.store.scene.joints.find((j) => !j.led_by)")
        self.ask("tendons.set", json.dumps({"posture": {joint["name"]: 0.5 * (joint["lower"] + joint["upper"])}}))
        self.settle()
        self.assert_no_errors()

    def test_a_fit_shows_its_trials(self):
        folder = tempfile.mkdtemp(prefix="thenar-fit-")
        subprocess.run([live_page.PROGRAM, "fit", "synek2019_H01", "--subject", SUBJECT, "-o", "fit.h5"], cwd=folder,
                       check=True, stdout=subprocess.DEVNULL)
        self.start("fit.h5", folder=folder)
        self.browser.wait("thenarLive.tabs.chosen() === 'fit' && thenarLive.store.frame", "the fit")
        state = self.ask("fit.state")
        self.browser.wait(f"document.querySelectorAll('.page.fit .table-frame tbody tr').length === {len(state['trials'])}")
        kinds = self.browser.value("thenarLive.store.scene.arrows.map(({ kind }) => kind)")
        # Components are the experiment's: lengths and the angle between arrows are those of the chosen trial's forces.
        for trial in (state["trials"][0], state["trials"][-1]):
            self.ask("fit.trial", json.dumps({"trial": trial["trial"]}))
            self.settle()
            numbers = self.browser.value("[...thenarLive.store.frame.arrows]")
            drawn = {k: numbers[6 * kinds.index(k) + 3:][:3] for k in ("measured", "predicted")}
            for one, other in (("measured", "measured"), ("predicted", "predicted"), ("measured", "predicted")):
                wanted = sum(a * b for a, b in zip(trial[one], trial[other]))
                self.assertAlmostEqual(sum(a * b for a, b in zip(drawn[one], drawn[other])), wanted, places=4)
        self.assert_no_errors()

    def test_every_subject_opens_or_says_why_not(self):
        self.start()
        for subject in self.ask("catalogue.list", "{what: 'subjects'}")["entries"]:
            digits = self.ask("catalogue.list", json.dumps({"what": "digits", "of": subject["name"]}))["entries"]
            digit = {"digit": digits[-1]["name"]} if digits else {}
            with self.subTest(subject=subject["name"], **digit):
                try:
                    self.ask("tendons.open", json.dumps({"subject": subject["name"], **digit}))
                except PageError as refused:  # a digit without muscles or bones says so
                    self.assertRegex(str(refused), "no muscle|has no bones")
                    continue
                self.settle()
                self.browser.wait("thenarLive.store.scene.mode === 'tendons' && thenarLive.picture.complete()"
                                  " && !thenarLive.picture.fitting()")
                self.assertGreater(self.browser.value(COLORED), 0.001)
                self.assert_no_errors()


if __name__ == "__main__":
    live_page.main()

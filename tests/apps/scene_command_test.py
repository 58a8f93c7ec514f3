"""Scenes in motion by the command `thenar simulate SCENE`; expected numbers are closed forms, computed here.

Usage: scene_command_test.py [path of the program [MPIEXEC]]; else the environment's THENAR. Run from anywhere.
"""
import hashlib
import json
import math
import os
import pathlib
import signal
import subprocess
import sys
import time
import unittest

from files import Files
from patience import HANG, stopped

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENES = ROOT / "data/scenes"
PROGRAM = os.environ.get("THENAR", "thenar")
MPIEXEC = None
G = 9.81

BALL = """name = "ball"
source = "Mine"
[sources]
Mine = "Own"
[[body]]
name = "ball"
mass_g = 100
position_mm = [0, 0, 0]
velocity_m_s = [1, 0, 2]
[[body.shape]]
kind = "sphere"
size_mm = [10]
[stepping]
duration_s = 0.5
"""


def run(*words):
    return subprocess.run([PROGRAM, "simulate", *map(str, words)], capture_output=True, text=True,
                          check=False, cwd=ROOT)


def ask(*words):
    """The JSON answer."""
    result = run(*words, "--json")
    assert result.returncode == 0, result.stderr
    return json.loads(result.stdout)


def body(answer, name):
    return next(each for each in answer["bodies"] if each["body"] == name)


def complete_elliptic(k):
    """K(k) by the arithmetic-geometric mean."""
    a, b = 1.0, math.sqrt(1 - k * k)
    while abs(a - b) > 1e-15:
        a, b = (a + b) / 2, math.sqrt(a * b)
    return math.pi / (2 * a)


class Near(Files):
    def near(self, got, want, tolerance):
        for g, w in zip(got, want, strict=True):
            self.assertAlmostEqual(g, w, delta=tolerance)


class ClosedForms(Near):
    def test_thrown_ball_flies_a_parabola(self):
        answer = ask(self.path("ball.toml", BALL))
        end = body(answer, "ball")
        self.near(end["centre_m"], [0.5, 0, 1 - G * 0.125], 1e-9)
        self.near(end["velocity_m_s"], [1, 0, 2 - G * 0.5], 1e-9)
        self.assertAlmostEqual(answer["dissipated_J"], 0, delta=1e-10)
        self.assertEqual(answer["status"], "done")

    def test_pinched_cube_does_not_slip(self):
        answer = ask("pinch")
        self.assertLess(answer["largest_slip_m"], 1e-12)
        self.assertLess(math.hypot(*body(answer, "cube")["moved_m"]), 1e-12)
        for pair in answer["pairs"]:
            self.assertEqual(pair["end"], "sticks")
            # The drive across, half of the weight along.
            self.assertAlmostEqual(math.hypot(*pair["end_force_N"]), math.hypot(2, 0.05 * G),
                                   delta=1e-9)

    def test_swinging_cube_keeps_its_arm(self):
        answer = ask("swinging_pinch")
        x, y, z = body(answer, "cube")["centre_m"]
        self.assertAlmostEqual(math.hypot(y, z - 0.0054), 0.0054, delta=1e-9)
        self.assertAlmostEqual(answer["dissipated_J"], 0, delta=1e-9)

    def test_incline_sticks_below_and_slides_above_the_threshold(self):
        self.assertLess(math.hypot(*body(ask("incline_stick"), "cube")["moved_m"]), 1e-12)
        answer = ask("incline_slide")
        slope, friction = math.radians(30), math.radians(29.9)
        way = 0.5 * G * (math.sin(slope) - math.tan(friction) * math.cos(slope)) * 4
        self.assertAlmostEqual(math.hypot(*body(answer, "cube")["moved_m"]), way, delta=1e-6 * way)
        # Slip is that way, and friction times it is the energy lost.
        self.assertAlmostEqual(answer["largest_slip_m"], way, delta=1e-6 * way)
        lost = math.tan(friction) * 0.1 * G * math.cos(slope) * way
        self.assertAlmostEqual(answer["dissipated_J"], lost, delta=1e-6 * lost)

    def test_pendulum_is_back_after_its_period(self):
        period = 4 * complete_elliptic(math.sin(math.radians(30))) * math.sqrt(0.6 / (3 * G))
        answer = ask("pendulum", "--seconds", period)
        angle, = answer["coordinates"]
        self.assertAlmostEqual(angle["end"], math.radians(60), delta=1e-8)
        half = ask("pendulum", "--seconds", period / 2)["coordinates"][0]
        self.assertAlmostEqual(half["end"], -math.radians(60), delta=1e-7)

    def test_top_precesses_steadily(self):
        tilt, spin, l = math.radians(30), 200, 0.05
        a, b, c = (3e-5 + 0.1 * l * l) * math.cos(tilt), -4e-5 * spin, 0.1 * G * l
        rate = (-b - math.sqrt(b * b - 4 * a * c)) / (2 * a)
        x, y, z = body(ask("spinning_top"), "top")["centre_m"]
        self.near([x, y, z], [l * math.sin(tilt) * math.cos(2 * rate),
                              l * math.sin(tilt) * math.sin(2 * rate), l * math.cos(tilt)], 1e-7)

    def test_ball_bounces(self):
        answer = ask("falling_ball")
        left, up = 0.6 - math.sqrt(0.2 / G), 0.8 * math.sqrt(0.2 * G)
        while left > 2 * up / G:
            left, up = left - 2 * up / G, 0.8 * up
        self.assertAlmostEqual(body(answer, "ball")["centre_m"][2],
                               0.02 + up * left - G * left * left / 2, delta=1e-6)

    # The file has the derivation: the motor runs up, falls behind by tau, and stops dead on the ball.
    def test_ball_is_caught_where_friction_stops_it(self):
        mass, jaw, damping, speed, tau = 0.12, 0.05, 80, 0.5, 0.1 / 80
        met = 0.16 + 0.02 / speed + tau
        fall = G * met - 2 * jaw * speed / mass
        slip = fall * fall / (2 * (damping * speed / mass - G))
        answer = ask("ball_catch")
        self.near(body(answer, "ball")["centre_m"], [0, 0, 0.24 - G * met * met / 2 - slip], 1e-8)
        for pair in answer["pairs"]:
            self.assertEqual(pair["end"], "sticks")
            self.near([abs(each) for each in pair["end_force_N"]],
                      [damping * speed / 2, 0, mass * G / 2], 1e-8)
        # Kinetic energy and height of the ball, and the motor's work, are all gone.
        lost = answer["energy_start_J"]["total"] + answer["work_J"] - answer["energy_end_J"]["total"]
        self.assertAlmostEqual(answer["dissipated_J"], lost, delta=1e-8)
        self.assertAlmostEqual(answer["energy_error_J"], 0, delta=1e-8)

    def test_stack_is_quiet(self):
        answer = ask("stack")
        for each in answer["bodies"]:
            self.assertLess(math.hypot(*each["moved_m"]), 1e-12)

    def test_cradle_hands_its_speed_on(self):
        answer = ask("newtons_cradle", "--seconds", 0.4)
        # Impacts are located to within 1e-6 of what moves: 0.1 kg falls by 0.2 (1 - cos 30 deg) m.
        self.assertAlmostEqual(answer["dissipated_J"], 0,
                               delta=1e-6 * 0.1 * G * 0.2 * (1 - math.cos(math.radians(30))))
        first, *_, last = answer["coordinates"]
        self.assertLess(abs(first["end"]), math.radians(1))
        self.assertGreater(abs(last["end"]), math.radians(20))


HUMAN = """name = "human"
source = "Mine"
gravity_m_s2 = [0, 0, 0]
[sources]
Mine = "Own"
[[hand]]
name = "human:skewed"
passive = "off"
skin_triangles = 100
[[muscle]]
hand = "human:skewed"
excitation = {FDP3 = 0.05}
rung = "bounds"
[[tendon]]
hand = "human:skewed"
tension_N = {FDP4 = 2}
[stepping]
duration_s = 0.03
tolerance = 1e-6
"""


class HumanHands(Near):
    # From rest at excitation e:  -(0.5 + 1.5 e) log(1 - a / e) - 1.5 a = t / 15 ms  [Thelen2003].
    def test_muscles_are_told_at_the_end(self):
        answer = ask(self.path("human.toml", HUMAN))
        muscles = {each["muscle"]: each for each in answer["muscles"]}
        self.assertEqual(muscles["human:skewed/ring/FDP4"]["tension_N"], 2)
        self.assertNotIn("activation", muscles["human:skewed/ring/FDP4"])
        e, a = 0.05, muscles["human:skewed/middle/FDP3"]["activation"]
        self.near([-(0.5 + 1.5 * e) * math.log(1 - a / e) - 1.5 * a], [2], 1e-6)
        self.assertEqual(muscles["human:skewed/middle/FDS3"]["activation"], 0)
        ends = {each["coordinate"]: each["end"] - each["start"] for each in answer["coordinates"]}
        self.assertGreater(ends["human:skewed/DIP3"], 0.1)
        self.assertGreater(ends["human:skewed/DIP4"], 0.01)


class Shipped(Near):
    def test_every_scene_is_solved_to_its_end(self):
        for path in sorted(SCENES.glob("*.toml")):
            told = run(path.stem)
            self.assertEqual(told.returncode, 0, f"{path.stem}: {told.stderr}")

    # The founding paper's figure 3: the hand closes on a tapered glass, which slips out and falls.
    def test_glass_is_squeezed_out_and_falls(self):
        answer = ask("wine_glass")
        pairs = [" - ".join(pair["bodies"]) for pair in answer["pairs"]]
        self.assertTrue(any("finger" in pair and "glass" in pair for pair in pairs), pairs)
        self.assertLess(body(answer, "glass")["centre_m"][2], -0.3)


    # What holds the mug at the end is its weight, and nothing of it moves any more.
    def test_mug_hangs_in_the_grip(self):
        answer = ask("mug_lift")
        mug = body(answer, "mug")
        self.near(mug["velocity_m_s"], [0, 0, 0], 1e-9)
        self.assertGreater(mug["moved_m"][2], 0.09)
        held = [pair for pair in answer["pairs"] if "mug" in pair["bodies"] and pair["end"] != "apart"]
        self.assertTrue(all(pair["end"] == "sticks" for pair in held) and len(held) == 4, held)
        forces = [[-each if pair["bodies"][0] != "mug" else each for each in pair["end_force_N"]]
                  for pair in held]
        self.near([sum(axis) for axis in zip(*forces)], [0, 0, 0.3 * G], 1e-6)
        # Three fingers meet the mug; they do not push each other off again and again.
        self.assertLess(answer["impacts"], 200)

    # Each pad bears half of the weight across the grip, which the drive makes, less what its damper takes.
    def test_jaws_with_pads_carry_the_cube(self):
        answer = ask("soft_jaws")
        cube, weight = body(answer, "cube"), 0.0216 * G
        self.assertEqual(answer["unsolved"], 0)
        self.near(cube["velocity_m_s"], [0, 0, 0], 5e-5)
        self.assertGreater(cube["moved_m"][2], 0.025)
        held = [pair for pair in answer["pairs"] if pair["end"] != "apart"]
        self.assertEqual(["parallel_jaw/left jaw - cube", "parallel_jaw/right jaw - cube"],
                         [" - ".join(pair["bodies"]) for pair in held])
        for pair, side in zip(held, (-1, 1)):
            self.assertEqual(pair["end"], "sticks")
            self.near(pair["end_force_N"], [side * 0.5, 0, -weight / 2], 2e-3)

    # The hand of capsules holds as the hand of triangles does; its error is told in mm.
    def test_hand_of_capsules_carries_the_cylinder(self):
        self.path("human_cylinder.csv", (SCENES / "human_cylinder.csv").read_text())
        text = (SCENES / "human_cylinder.toml").read_text()
        scene = self.path("capsules.toml", text.replace("skin_triangles = 150", 'skin = "capsules"'))
        answer = ask(scene, "--tolerance", "1e-4")
        self.assertTrue(any("skin of digits is tapered capsules" in told and "mm at most" in told
                            for told in answer["warnings"]), answer["warnings"])
        cylinder = body(answer, "cylinder")
        self.near(cylinder["velocity_m_s"], [0, 0, 0], 1e-6)
        self.assertGreater(cylinder["moved_m"][2], 0.09)
        held = [pair for pair in answer["pairs"] if "cylinder" in pair["bodies"] and pair["end"] != "apart"]
        forces = [[-each if pair["bodies"][0] != "cylinder" else each for each in pair["end_force_N"]]
                  for pair in held]
        self.near([sum(axis) for axis in zip(*forces)], [0, 0, 0.3 * G], 1e-4)

    # The key goes with the wrist; what this holds at the end is the spring, give or take the friction.
    def test_key_is_turned_without_slip(self):
        answer = ask("key_turn")
        end = {each["coordinate"]: each["end"] for each in answer["coordinates"]}
        turn, wrist, spring, friction = end["key"], end["parallel_jaw/base"], 0.0127324, 0.05
        self.assertAlmostEqual(turn, wrist, delta=1e-9)
        self.assertAlmostEqual(50 * (math.pi / 2 - wrist), spring * turn, delta=friction + 1e-9)
        self.assertAlmostEqual(answer["energy_end_J"]["springs"], spring * turn * turn / 2, delta=1e-12)
        self.assertGreater(answer["dissipated_J"], friction * turn)
        self.assertAlmostEqual(answer["energy_error_J"], 0, delta=1e-8)
        # Work and losses do not depend on the instants that are kept.
        finer = ask("key_turn", "--sample-ms", "1")
        for each in ("work_J", "dissipated_J"):
            self.assertAlmostEqual(answer[each], finer[each], delta=1e-8)
        for pair in answer["pairs"]:
            self.assertEqual(pair["end"], "sticks")
            self.assertLess(pair["slip_m"], 1e-9)


class ResultFiles(Near):
    def test_result_file_holds_every_instant(self):
        out = self.path("run.h5")
        result = run("pinch", "--seconds", 0.1, "-o", out)
        self.assertEqual(result.returncode, 0, result.stderr)
        told = subprocess.run([PROGRAM, "validate", out], capture_output=True, text=True, check=False)
        self.assertIn("1 run of scene 'pinch'", told.stdout)
        again = subprocess.run([PROGRAM, "rerun", out, "--print"], capture_output=True, text=True,
                               check=False)
        self.assertIn("thenar simulate pinch --seconds 0.1 -o", again.stdout)

    # A table of tensions is a source as the scene is: its text stands in the file as it was read.
    def test_result_file_holds_tables_that_were_read(self):
        table = "time_s,FDP4\n0,1.9\n0.01,0\n"
        self.path("ramp.csv", table)
        scene = HUMAN.replace("tension_N = {FDP4 = 2}", 'tension_file = "ramp.csv"')
        out = self.path("run.h5")
        result = run(self.path("human.toml", scene), "--seconds", 0.02, "-o", out)
        self.assertEqual(result.returncode, 0, result.stderr)
        held = pathlib.Path(out).read_bytes()
        self.assertIn(table.encode(), held)
        self.assertIn(hashlib.sha256(table.encode()).hexdigest().encode(), held)

    def test_result_file_of_a_sweep_holds_every_run(self):
        out = self.path("runs.h5")
        result = run("pinch", "--seconds", 0.1, "--vary", "friction=0.4:0.8:3", "-o", out)
        self.assertEqual(result.returncode, 0, result.stderr)
        told = subprocess.run([PROGRAM, "validate", out], capture_output=True, text=True, check=False)
        self.assertIn("3 runs of scene 'pinch'", told.stdout)

    def test_page_and_table_are_written(self):
        page, table = self.path("run.html"), self.path("run.csv")
        result = run("incline_slide", "--seconds", 0.6, "-o", page, "-o", table)
        self.assertEqual(result.returncode, 0, result.stderr)
        text = pathlib.Path(page).read_text()
        self.assertTrue("contact forces at" in text)
        rows = pathlib.Path(table).read_text().splitlines()
        self.assertEqual(rows[0], "time_s,kinetic_J,weight_J,springs_J,contacts,cube_x_m,cube_y_m,cube_z_m")
        self.assertEqual(len(rows), 1 + 61)
        # The page plays the same places, and shows the force of every corner both ways.
        start = text.index('id="thenar-report">') + len('id="thenar-report">')
        report = json.loads(text[start:text.index("</script>", start)])
        scene, = (block for block in report["sections"][0]["blocks"] if block["type"] == "scene")
        self.assertEqual((len(scene["strip"]), scene["strip"][0], scene["strip"][-1]), (8, 0, 0.6))
        last = [layer for layer in scene["layers"] if layer.get("time") == 0.6]
        self.assertEqual([layer["name"] for layer in last],
                         ["bodies at 0.6 s", "contact forces at 0.6 s"])
        cube, = last[0]["items"]
        self.near(cube["position"], [1e3 * float(each) for each in rows[-1].split(",")[-3:]], 1e-6)
        self.assertTrue(cube["mesh"] in report["meshes"])
        vectors = [item["vector"] for item in last[1]["items"]]
        self.near([sum(axis) for axis in zip(*vectors)], [0, 0, 0], 1e-9)

    def test_scenes_are_listed_and_valid(self):
        listed = subprocess.run([PROGRAM, "list", "scenes", "--json"], capture_output=True, text=True,
                                check=True, cwd=ROOT)
        names = {each["name"] for each in json.loads(listed.stdout)}
        self.assertEqual(names, {path.stem for path in SCENES.glob("*.toml")})
        for path in sorted(SCENES.glob("*.toml")):
            told = subprocess.run([PROGRAM, "validate", path], capture_output=True, text=True,
                                  check=False)
            self.assertEqual(told.returncode, 0, told.stdout)


class Variations(Files):
    def test_friction_decides_who_slides(self):
        answer = ask("incline_stick", "--seconds", 0.5, "--vary", "friction=0.1:1:10")
        self.assertEqual(len(answer["runs"]), 10)
        slope = math.radians(30)
        for each in answer["runs"]:
            mu = each["varied"]["friction"]
            way = max(0, 0.5 * G * (math.sin(slope) - mu * math.cos(slope)) * 0.25)
            self.assertAlmostEqual(each["largest_slip_m"], way, delta=1e-8)

    def test_runs_of_a_sweep_are_those_by_themselves(self):
        words = ("swinging_pinch", "--seconds", 0.5)
        many = ask(*words, "--vary", "tolerance=1e-9:1e-7:3")
        for each in many["runs"]:
            alone = ask(*words, "--tolerance", repr(each["varied"]["tolerance"]))
            self.assertEqual(each["bodies"], alone["bodies"])
            self.assertEqual(each["steps"], alone["steps"])

    def test_all_combinations_run(self):
        answer = ask(self.path("ball.toml", BALL), "--vary", "mass/ball=0.1:0.2:2", "tolerance=1e-9:1e-8:3")
        self.assertEqual([tuple(each["varied"].values()) for each in answer["runs"]],
                         [(m, t) for m in (0.1, 0.2) for t in (1e-9, 5.5e-9, 1e-8)])


class Processes(Files):
    # Processes of this machine only, more of them than cores, and by root in containers.
    ENVIRONMENT = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
                   "OMPI_MCA_btl": "self,vader", "OMPI_MCA_mpi_yield_when_idle": "1",
                   "OMPI_MCA_hwloc_base_binding_policy": "none",
                   "ASAN_OPTIONS": "detect_leaks=0"}  # Open MPI keeps what it allocates

    def swept(self, ranks, *words):
        """By one process without mpirun if ranks is 0; files carry the same date."""
        if MPIEXEC is None:
            self.skipTest("no MPI")
        start = [MPIEXEC, "-n", str(ranks), "--oversubscribe"] if ranks else []
        return subprocess.run([*start, PROGRAM, "simulate", *map(str, words)], capture_output=True,
                              text=True, check=False, cwd=ROOT, timeout=HANG,
                              env={**os.environ, "SOURCE_DATE_EPOCH": "0",
                                   **(self.ENVIRONMENT if ranks else {})})

    # Five runs by two processes and by three: the last of them has one.
    def test_sweep_by_processes_is_that_by_threads_to_the_byte(self):
        out = self.path("runs.h5")
        words = ("swinging_pinch", "--seconds", 0.3, "--vary", "friction=0.5:1:5", "-o", out, "--json")
        answers, files = [], []
        for ranks in (0, 2, 3):
            result = self.swept(ranks, *words)
            self.assertEqual(result.returncode, 0, result.stderr)
            answers.append(json.loads(result.stdout))
            for each in answers[-1]["runs"]:
                each.pop("cpu_s_per_simulated_s", None)
            files.append(pathlib.Path(out).read_bytes())
            os.remove(out)
        self.assertEqual(answers[0], answers[1])
        self.assertEqual(answers[0], answers[2])
        self.assertTrue(files[0] == files[1] == files[2])

    def test_processes_fail_once_and_in_peace(self):
        result = self.swept(2, "pinch", "--vary", "fricton=0:1:2")
        self.assertNotEqual(result.returncode, 0)
        self.assertEqual(result.stderr.count("cannot vary 'fricton'"), 1, result.stderr)
        self.assertNotIn("MPI_ABORT", result.stderr)

    def test_more_processes_than_runs_do_no_harm(self):
        result = self.swept(3, "pinch", "--seconds", 0.1, "--vary", "friction=0.5:1:2", "--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(len(json.loads(result.stdout)["runs"]), 2)


class Refusals(Files):
    def complaint(self, *words):
        result = run(*words)
        self.assertEqual(result.returncode, 1, result.stdout)
        return result.stderr

    def test_mistakes_are_told_by_line(self):
        text = BALL.replace("mass_g", "mas_g")
        self.assertIn("ball.toml:7: unknown key 'mas_g'", self.complaint(self.path("ball.toml", text)))

    def test_options_of_subjects_are_refused(self):
        self.assertIn("--digit applies only to subjects", self.complaint("pinch", "--digit", "index"))
        subject = ROOT / "data/subjects/an_chao_index.toml"
        self.assertIn("--vary applies only to scenes", self.complaint(subject, "--vary", "friction=0:1:2"))

    def test_variations_that_nothing_has_are_refused(self):
        self.assertIn("cannot vary 'fricton'", self.complaint("pinch", "--vary", "fricton=0:1:2"))
        self.assertIn("wanted NAME=from:to:count", self.complaint("pinch", "--vary", "friction=0:1"))
        self.assertIn("a whole number of values", self.complaint("pinch", "--vary", "friction=0:1:1.5"))

    def test_skin_of_a_robot_is_refused(self):
        text = (SCENES / "wine_glass.toml").read_text()
        result = run(self.path("skin.toml", text.replace("[[hand]]", '[[hand]]\nskin = "capsules"')))
        self.assertEqual(result.returncode, 1, result.stdout)
        self.assertRegex(result.stderr, r"skin\.toml:\d+: 'barrett' is not a human hand")

    def test_names_that_nobody_has_are_refused(self):
        self.assertIn("did you mean 'pinch'", self.complaint("pinc"))

    def test_motion_that_does_not_stay_finite_ends_with_an_error(self):
        # 1e9 N on 1e-300 kg: the acceleration is no number.
        text = BALL.replace("mass_g = 100", "mass_kg = 1e-300")
        text += '[[force]]\nbody = "ball"\nforce_N = [1e9, 0, 0]\nfrom_s = 0.1\n'
        result = run(self.path("ball.toml", text), "--json")
        self.assertEqual(result.returncode, 1, result.stdout)
        self.assertEqual(json.loads(result.stdout)["status"], "not finite")
        self.assertIn("do not use it", result.stderr)


class Signals(Files):
    def test_interrupt_keeps_what_is_there(self):
        out = self.path("run.h5")
        command = [PROGRAM, "simulate", "swinging_pinch", "--seconds", "5000", "--json", "-o", out]
        code, stdout, stderr = stopped(
            command, signal.SIGINT, lambda _, out: out and json.loads(out)["simulated_s"] > 0, cwd=ROOT)
        self.assertNotEqual(code, 0)
        answer = json.loads(stdout)
        self.assertEqual(answer["status"], "stopped")
        self.assertGreater(answer["simulated_s"], 0)
        self.assertIn("all up to then", stderr)
        self.assertTrue(os.path.exists(out))


if __name__ == "__main__":
    if len(sys.argv) > 1 and not sys.argv[1].startswith("-"):
        PROGRAM = os.path.abspath(sys.argv.pop(1))
    if len(sys.argv) > 1 and "/" in sys.argv[1]:
        MPIEXEC = sys.argv.pop(1)
    unittest.main()

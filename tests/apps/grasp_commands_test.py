"""End-to-end tests of the commands `thenar grasp` and `close`; expected numbers are derived here by hand.

Usage: grasp_commands_test.py [path of the program]; else the environment's THENAR.
"""
import json
import math
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import unittest

from patience import HANG, stopped

PROGRAM = os.environ.get("THENAR", "thenar")
EXACT = 1e-9
ROBOTS = pathlib.Path(__file__).resolve().parents[2] / "data" / "robots"
RADIUS = 0.01  # [m] of the ball
GAP = 1e-4  # [m] within which links touch
PALM = 0.012883  # [m] from the base of the jaws back to the face between them

WORLD = """name = "ball"
description = "A ball and a gripper that goes along +y and closes along x"
source = "Scene"
[sources]
Scene = "Arranged for this test"
[[hand]]
name = "jaws"
file = "{robots}/parallel_jaw.toml"
position_m = {hand}
ways_mm = {{{ways}}}
[[body]]
role = "object"
name = "ball"
material = "wood"
mass_kg = 0.01
position_m = {ball}
[[body.shape]]
kind = "{kind}"
{size}
"""


PARCEL = """name = "parcel"
description = "A parcel of tea in the air, for any hand"
source = "Scene"
[sources]
Scene = "Arranged for this test"
[[body]]
role = "object"
file = "{data}/objects/box.toml"
"""


class WorldsOfData(unittest.TestCase):
    """Every world that comes with thenar shows a grasp that holds."""

    def test_hands_close_on_their_objects(self):
        worlds = pathlib.Path(__file__).parents[2] / "data" / "worlds"
        for name in sorted(path.stem for path in worlds.glob("*.toml")):
            result = subprocess.run([PROGRAM, "grasp", str(worlds / f"{name}.toml"), "--json",
                                     "--wrenches"],
                                    capture_output=True, text=True, check=False, timeout=HANG)
            self.assertEqual(result.returncode, 0, result.stderr)
            answer = json.loads(result.stdout)
            self.assertTrue(answer["force_closure"], name)
            self.assertGreater(answer["epsilon"]["lower"], 0, name)
            self.assertNotIn(None, answer["wrench_set"].values(), name)

    # Each jaw presses with 80 N and has friction 1 on wood. Nobody states efforts of arm and base.
    def test_an_arm_of_unknown_efforts_is_locked(self):
        result = subprocess.run([PROGRAM, "close", "arm_cube", "--json"], capture_output=True,
                                text=True, check=False, timeout=HANG)
        answer = json.loads(result.stdout)
        self.assertAlmostEqual(answer["pull_N"], 160, delta=1e-4)
        self.assertAlmostEqual(answer["hold_actuated_N"], answer["weight_N"], delta=1e-6)
        [warning] = answer["warnings"]
        for words in ("xr4000", "puma560", "locked"):
            self.assertIn(words, warning)

    def test_a_hand_that_closes_on_nothing_says_what_to_do(self):
        for command, hint in ((["close"], "`thenar grasp` approaches the object first"),
                              (["grasp", "--no-approach"], "approaches the object first"),
                              (["grasp"], "grasped")):
            result = subprocess.run([PROGRAM, command[0], "jaw_box", *command[1:]],
                                    capture_output=True, text=True, check=False, timeout=HANG)
            self.assertIn(hint, result.stdout.splitlines()[0])


class DataFromAnywhere(unittest.TestCase):
    """What comes with thenar is found by name, in the order of the search."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_in(self, *words, **more):
        return subprocess.run([pathlib.Path(PROGRAM).resolve(), *words], capture_output=True,
                              text=True, check=False, timeout=HANG, cwd=self.folder,
                              env={**os.environ, **more})

    def test_a_world_is_found_from_any_folder(self):
        result = self.run_in("grasp", "jaw_box", "--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(json.loads(result.stdout)["outcome"], "grasped")

    def test_given_data_goes_first_then_the_environment_then_here(self):
        world = (pathlib.Path(__file__).parents[2] / "data" / "worlds" / "jaw_box.toml").read_text()
        world = world.replace("../", str(pathlib.Path(__file__).parents[2] / "data") + "/")
        for place in ("given", "named", "data"):
            (self.folder / place / "worlds").mkdir(parents=True)
            (self.folder / place / "worlds" / "jaw_box.toml").write_text(world)
        here = json.loads(self.run_in("close", "jaw_box", "--json").stdout)
        named = json.loads(self.run_in("close", "jaw_box", "--json", THENAR_DATA="named").stdout)
        given = json.loads(self.run_in("close", "jaw_box", "--json", "--data", "given",
                                       THENAR_DATA="named").stdout)
        self.assertEqual([a["world"] for a in (given, named, here)],
                         [f"{place}/worlds/jaw_box.toml" for place in ("given", "named", "data")])

    def test_tells_what_structure_bears_of_a_load(self):
        self.assertRegex(self.run_in("grasp", "barrett_bobbin").stdout,
                         "pull along z +46.* N .by efforts and friction; 714.* N with rigid structure")

    def test_contacts_are_rows_and_pages_have_the_run(self):
        text = self.run_in("grasp", "barrett_bobbin", "--csv").stdout
        contacts = json.loads(self.run_in("grasp", "barrett_bobbin", "--json").stdout)["contacts"]
        header, *rows = text.splitlines()
        self.assertEqual(header, "surface,digit,x_mm,y_mm,z_mm,nx,ny,nz,friction,torsion_mm,patch")
        self.assertEqual([row.split(",")[0] for row in rows], [c["surface"] for c in contacts])
        result = self.run_in("grasp", "barrett_bobbin", "-o", "out/g.html", "-o", "out/g.csv",
                             "--approach-distance", "1")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual((self.folder / "out" / "g.csv").read_text(), text)
        self.assertIn("thenar grasp barrett_bobbin", (self.folder / "out" / "g.html").read_text())

    def test_a_complaint_names_all_places(self):
        result = self.run_in("grasp", "jaw_boy", THENAR_DATA="/tmp/nowhere")
        self.assertEqual(result.returncode, 1)
        for words in ("there is no world 'jaw_boy', did you mean 'jaw_box'?", "no such name in worlds/ of",
                      "/tmp/nowhere, data, ", "/share/thenar, ", "/data"):
            self.assertIn(words, result.stderr)
        self.assertIn("there is no command 'graps', did you mean 'grasp'?",
                      self.run_in("graps", "jaw_box").stderr)
        mug = str(ROBOTS.parent / "objects" / "mug.toml")
        self.assertIn("is an object, wanted a world; commands that take it: thenar explain",
                      self.run_in("grasp", mug).stderr)
        self.assertIn("body 'table' is an obstacle",
                      self.run_in("grasp", "barrett_bobbin", "--object", "table").stderr)
        self.assertIn("has no body 'bobin', did you mean 'bobbin'?",
                      self.run_in("grasp", "barrett_bobbin", "--object", "bobin").stderr)
        self.assertIn("there is no folder elsewhere (--data)",
                      self.run_in("grasp", "jaw_box", "--data", "elsewhere").stderr)


class GraspOfJaws(unittest.TestCase):
    """A ball of 10 mm, or a cube as wide, between two flat jaws."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def world(self, hand=(0, 0, 0), ball=(0, 0.03, 0), kind="sphere", size="size_mm = [10]",
              ways="opening = 55"):
        path = self.folder / "world.toml"
        path.write_text(WORLD.format(robots=ROBOTS, hand=list(hand), ball=list(ball), kind=kind,
                                     size=size, ways=ways))
        return str(path)

    def run_it(self, *words):
        return subprocess.run([PROGRAM, *words], capture_output=True, text=True, check=False,
                              timeout=HANG)

    def ask(self, *words):
        result = self.run_it(*words, "--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        return json.loads(result.stdout)

    # Two hard points on a line cannot twist the ball about it, whatever the friction.
    def test_a_ball_between_jaws_turns_about_the_line_of_contacts(self):
        answer = self.ask("close", self.world())
        self.assertEqual(answer["outcome"], "touched")
        self.assertEqual(answer["rank"], 5)
        self.assertFalse(answer["force_closure"])
        self.assertAlmostEqual(answer["epsilon"]["upper"], 0, delta=EXACT)
        (a, b), torque = [c["position_m"] for c in answer["contacts"]], answer["missing_direction"][3:]
        line = [q - p for p, q in zip(a, b)]
        cosine = sum(t * d for t, d in zip(torque, line)) / math.hypot(*torque) / math.hypot(*line)
        self.assertAlmostEqual(abs(cosine), 1, delta=1e-9)
        self.assertRegex(answer["missing_direction_words"], "^torque about [+-]x$")
        self.assertEqual(sorted(c["surface"] for c in answer["contacts"]), ["left jaw", "right jaw"])
        [opening] = answer["coordinates"]
        self.assertEqual((opening["coordinate"], opening["kind"], opening["stopped_by"]),
                         ("opening", "slides", "contact"))
        self.assertIn("jaw on ball", opening["why"])
        self.assertTrue(RADIUS < opening["value"] <= RADIUS + GAP, opening["value"])

    # All eight corners touch, with friction 1. A twist about the line of closing is borne worst: unit
    # forces across it at a sqrt(2) from it, over the reach a sqrt(3). The motor's 160 N are 160 times
    # that.
    def test_a_cube_between_jaws_is_held(self):
        answer = self.ask("close", self.world(kind="box", size="size_mm = [20, 20, 20]"))
        self.assertEqual(len(answer["contacts"]), 8)
        self.assertTrue(answer["force_closure"])
        for bounds, wanted in ((answer["epsilon"], math.sqrt(2 / 3)),
                               (answer["actuated_epsilon_N"], 160 * math.sqrt(2 / 3))):
            self.assertLessEqual(bounds["lower"], wanted * (1 + 1e-6))
            self.assertGreaterEqual(bounds["upper"], wanted * (1 - 1e-6))
            self.assertLess(bounds["upper"] - bounds["lower"], 0.01 * wanted)

    # The palm goes on until it touches the ball, 10 mm before the ball's middle.
    def test_the_approach_ends_at_the_palm(self):
        answer = self.ask("grasp", self.world(hand=(0, -0.3, 0), ball=(0, 0, 0)))
        gone = answer["hand_pose"]["position_m"][1]
        self.assertTrue(-GAP <= gone - (PALM - RADIUS) < 0, gone)
        self.assertIn("body", [c["surface"] for c in answer["contacts"]])

    def test_a_start_in_the_object_is_no_grasp(self):
        for command in (["close"], ["grasp", "--no-approach"], ["grasp"]):
            result = self.run_it(command[0], self.world(ball=(0.055, 0.03, 0)), *command[1:],
                                 "--json")
            self.assertEqual((result.returncode, result.stdout), (1, ""))
            depth = float(re.search("right jaw is ([0-9.]+) mm in ball", result.stderr)[1])
            self.assertAlmostEqual(depth, 1e3 * RADIUS, delta=1e3 * GAP)

    def test_what_is_saved_is_where_it_ended(self):
        saved = str(self.folder / "new" / "saved.toml")
        world = self.world(hand=(0, -0.3, 0), ball=(0, 0, 0))
        answer = self.ask("grasp", world, "--save", saved)
        again = self.ask("close", saved)
        # The palm is a third contact: three hard points hold the ball.
        self.assertTrue(again["force_closure"])
        self.assertEqual(again["outcome"], "grasped")
        self.assertEqual(again["hand_pose"], answer["hand_pose"])
        self.assertAlmostEqual(again["coordinates"][0]["value"], answer["coordinates"][0]["value"],
                               delta=GAP)

    # Stopped in the draws of --robustness, which would take minutes.
    def test_a_grasp_that_is_found_survives_a_stop(self):
        world = self.world(kind="box", size="size_mm = [20, 20, 20]")
        for words in (["--no-approach", "--robustness", "100000"], ["--random", "100000"]):
            code, text, complaint = stopped([PROGRAM, "grasp", world, *words], signal.SIGINT,
                                            lambda _, out: "force closure" in out)
            self.assertEqual(code, 130)
            self.assertIn("force closure", text)
            self.assertIn("stopped", complaint)

    def test_the_same_seed_gives_the_same_grasp(self):
        world = self.world(kind="box", size="size_mm = [20, 30, 40]")
        answers = [self.ask("grasp", world, "--random", "20", "--seed", "3") for _ in range(2)]
        for answer in answers:
            self.assertEqual(sum(answer["starts"]["outcomes"].values()), 20)
            answer.pop("cpu_s")
        self.assertEqual(answers[0], answers[1])

    # Jaws of rubber of 80 N each bear mu 80 N apiece along z.
    def test_materials_of_the_world_stand_over_those_that_come_with_thenar(self):
        world = self.world(kind="box", size="size_mm = [20, 20, 20]")
        text = pathlib.Path(world).read_text()
        for friction in (0.25, 0):
            pathlib.Path(world).write_text('materials = "own.toml"\n' + text)
            (self.folder / "own.toml").write_text(
                f'name = "own"\nsource = "Own"\n[sources]\nOwn = "Made up"\n[[friction]]\nbetween = ["wood", "rubber"]\n'
                f'static = {friction}\nkinetic = {friction}\n')
            for command in ("close", "grasp"):
                answer = self.ask(command, world)
                self.assertEqual({c["friction"] for c in answer["contacts"]
                                  if "jaw" in c["surface"]}, {friction})
            self.assertAlmostEqual(self.ask("close", world)["pull_N"], 160 * friction, delta=1e-3)
        # Without friction no force across the line of closing is borne: a zero is told as one.
        text = self.run_it("close", world).stdout
        self.assertNotRegex(text, r"[0-9]e-[0-9]|inf|-0 ")
        self.assertRegex(text, "epsilon within the hand.s limits +0 N, nothing withstands force along -[yz]")
        ball = self.ask("close", world)["actuated_epsilon_N"]
        self.assertEqual((ball["lower"], ball["upper"]), (0, 0))
        self.assertRegex(text, "multiple of its weight supported  .*nothing withstands force along -[yz]")

    # Two faces of the cube are pressed, nothing below it: each of the two sides bears half the
    # weight m g by friction, so the squeeze is m g / mu; wood on the jaws' rubber has mu = 1.
    def test_a_cube_is_held_by_its_weight_over_friction(self):
        answer = self.ask("close", self.world(kind="box", size="size_mm = [20, 20, 20]"))
        weight = 0.01 * 9.81
        self.assertAlmostEqual(answer["weight_N"], weight, delta=1e-12)
        sides = {c["friction"] for c in answer["contacts"]}
        self.assertEqual(len(sides), 1)
        self.assertAlmostEqual(answer["hold_N"], weight / sides.pop(), delta=1e-6)
        self.assertGreaterEqual(answer["hold_actuated_N"], answer["hold_N"] - 1e-6)

    def test_every_measure_has_a_value_or_a_reason(self):
        for kind, size in (("sphere", "size_mm = [10]"), ("box", "size_mm = [20, 20, 20]")):
            answer = self.ask("close", self.world(kind=kind, size=size))
            for key in ("actuated_epsilon_N", "weight_N", "hold_N", "hold_actuated_N",
                        "times_weight", "pull_N", "turn_Nm", "stiffness_N_per_m",
                        "manipulability"):
                self.assertTrue(answer[key] is not None or answer["reasons"][key], (kind, key))

    def test_robustness_is_of_its_seed(self):
        world = self.world(kind="box", size="size_mm = [20, 20, 20]")
        ask = lambda seed: self.ask("grasp", world, "--no-approach", "--robustness", "10",
                                    "--seed", seed)["robustness"]
        found = ask("3")
        self.assertEqual(found, ask("3"))
        self.assertNotEqual(found["contacts"], ask("4")["contacts"])
        for kind in ("contacts", "pose"):
            self.assertTrue(0 <= found[kind]["closure_lower"] <= found[kind]["closure"]
                            <= found[kind]["closure_upper"] <= 1)
            self.assertEqual(found[kind]["epsilon_5_percent"] is None, found[kind]["misses"] > 0)

    # Unit forces: no wrench of the set has a force longer than a contact's own, sqrt(1 + mu^2).
    def test_wrench_sets_are_printed_as_meshes(self):
        world = self.world(kind="box", size="size_mm = [20, 20, 20]")
        answer = self.ask("grasp", world, "--no-approach", "--wrenches")
        forces = answer["wrench_set"]["forces"]
        longest = max(math.hypot(*v) for v in forces["vertices_N"])
        friction = max(c["friction"] for c in answer["contacts"])
        self.assertTrue(0 < longest <= math.hypot(1, friction) + 1e-6, longest)
        self.assertLess(max(max(t) for t in forces["triangles"]), len(forces["vertices_N"]))

    # A square has less area than its circle, and cones are discs here: their hull is smaller.
    def test_pyramids_are_weaker_than_cones_by_what_they_lack(self):
        world = self.world(kind="box", size="size_mm = [20, 20, 20]")
        cone = self.ask("grasp", world, "--no-approach")
        pyramid = self.ask("grasp", world, "--no-approach", "--edges", "4")
        self.assertLess(pyramid["volume"], cone["volume_bounds"]["lower"])
        self.assertEqual((cone["friction_edges"], pyramid["friction_edges"]), (0, 4))
        self.assertEqual(pyramid["actuated_epsilon_N"], cone["actuated_epsilon_N"])

    # Both jaws go with one motor, against each other: nothing between them can follow.
    def test_jaws_of_one_motor_move_nothing_they_hold(self):
        answer = self.ask("close", self.world(kind="box", size="size_mm = [20, 20, 20]"))
        moved = answer["manipulability"]
        self.assertEqual((moved["rank"], moved["drives"], moved["unit"]), (0, 1, "m/m"))
        self.assertEqual(moved["singular_values"], [])

    # The same draws, hand and object: the same grasps.
    def test_random_starts_are_those_of_compare(self):
        data = ROBOTS.parent
        world = self.folder / "parcel.toml"
        world.write_text(PARCEL.format(data=data))
        for hand in ("parallel_jaw", "barrett"):
            drawn = self.ask("grasp", str(world), "--hand", hand, "--random", "12", "--seed", "2")
            cell = self.ask("compare", "--hands", hand, "--objects", "box", "--approaches", "12",
                            "--seed", "2", "--best", "0")["cells"][0]
            self.assertGreater(cell["closures"], 0)
            self.assertEqual(drawn["starts"]["force_closures"], cell["closures"])
            self.assertAlmostEqual(drawn["epsilon"]["lower"], max(cell["epsilon"]), delta=1e-12)

    # An L of 32 cm^3 from overlapping boxes of 16 and 24 in one mesh: its centre is at 25, 0, 15 mm and its farthest
    # corner sqrt(15^2 + 10^2 + 35^2) mm off. To count the overlap twice would give 26, 0, 12 mm and another epsilon.
    def test_overlapping_boxes_are_grasped_and_compared_about_the_centre_of_their_union(self):
        text, first = "", 1
        for low, high in [((0, -10, -10), (40, 10, 10)), ((20, -10, -10), (40, 10, 50))]:
            for i in range(8):
                text += "v {} {} {}\n".format(*[(high if i >> k & 1 else low)[k] for k in range(3)])
            for face in [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]:
                text += "f " + " ".join(str(first + corner) for corner in face) + "\n"
            first += 8
        (self.folder / "ell.obj").write_text(text)
        (self.folder / "ell.toml").write_text(
            'name = "ell"\ndescription = "Two boxes"\nsource = "Own"\nmaterial = "wood"\nmass_g = 20\n[sources]\n'
            'Own = "Arranged for this test"\n[[shape]]\nkind = "mesh"\nfile = "ell.obj"\nscale = 0.001\n')
        world = self.folder / "parcel.toml"
        world.write_text(PARCEL.format(data=self.folder).replace("/objects/box.toml", "/ell.toml"))
        seed = ("--seed", "2")
        drawn = self.ask("grasp", str(world), "--hand", "parallel_jaw", "--random", "12", *seed)
        cell = self.ask("compare", "--hands", "parallel_jaw", "--objects", str(self.folder / "ell.toml"),
                        "--approaches", "12", "--best", "0", *seed)["cells"][0]
        self.assertGreater(cell["closures"], 0)
        self.assertEqual(drawn["starts"]["force_closures"], cell["closures"])
        self.assertAlmostEqual(drawn["epsilon"]["lower"], max(cell["epsilon"]), delta=1e-12)

        def about(centre, reach):
            contacts = [{"position": c["position_m"], "normal": c["normal"], "friction": c["friction"],
                         "torsion": c["torsion_m"], "patch": c["patch"]} for c in drawn["contacts"]]
            path = self.folder / "contacts.json"
            path.write_text(json.dumps({"centre_of_mass": centre, "torque_scale": reach, "contacts": contacts}))
            return self.ask("quality", str(path), "--no-volume", "--gap", "1e-6")["epsilon"]
        union = about([0.025, 0, 0.015], math.sqrt(1550) * 1e-3)
        twice = about([0.026, 0, 0.012], math.sqrt(14**2 + 10**2 + 38**2) * 1e-3)
        self.assertLessEqual(drawn["epsilon"]["lower"], union["upper"] + EXACT)
        self.assertGreaterEqual(drawn["epsilon"]["upper"], union["lower"] - EXACT)
        self.assertGreater(abs(twice["lower"] - union["lower"]), 0.01)  # the two can be told apart

    def test_zeros_have_no_sign_and_time_counts_all(self):
        world = self.world(kind="box", size="size_mm = [20, 20, 20]")
        words = ("grasp", world, "--no-approach", "--robustness", "600", "--json")
        text = self.run_it(*words).stdout
        self.assertIsNone(re.search(r"-0\.0\b(?!\d)", text))
        few = json.loads(self.run_it("grasp", world, "--no-approach", "--json").stdout)
        self.assertGreater(json.loads(text)["cpu_s"], few["cpu_s"])

    def test_the_page_holds_its_pictures(self):
        page = self.folder / "page.html"
        self.ask("close", self.world(), "--out", str(page))
        text = page.read_text()
        report = json.loads(text.split('id="thenar-report">')[1].split("</script>")[0])
        named = [item["mesh"] for section in report["sections"] for block in section["blocks"]
                 for layer in block.get("layers", []) for item in layer["items"]
                 if item["kind"] == "mesh"]
        self.assertGreaterEqual(len(named), 4)  # body, two jaws, ball
        self.assertLessEqual(set(named), set(report["meshes"]))

    # A tetrahedron without its last side.
    def test_a_leaky_mesh_is_named_with_what_mends_it(self):
        (self.folder / "leaky.obj").write_text("v 0 0 0\nv 0.02 0 0\nv 0 0.02 0\nv 0 0 0.02\n"
                                               "f 1 3 2\nf 1 2 4\nf 1 4 3\n")
        world = self.world(kind="mesh", size='file = "leaky.obj"')
        complaint = self.run_it("close", world).stderr
        for words in ("body 'ball'", "leaky.obj", "1 hole(s)", "thenar import", "repairs"):
            self.assertIn(words, complaint)

    def test_has_its_grasp_matrix_which_quality_reads(self):
        out = self.folder / "grasp.json"
        done = self.run_it("grasp", self.world(hand=(0, -0.3, 0), ball=(0, 0, 0)),
                           "-o", str(out))
        self.assertEqual(done.returncode, 0, done.stderr)
        answer = json.loads(out.read_text())
        G, contacts = answer["grasp_matrix"], answer["contacts"]
        # Hard points with friction: a normal and two tangents each; torques are arm x force / scale.
        self.assertEqual(len(G["columns"]), 3 * len(contacts))
        for row in G["matrix"]:
            self.assertEqual(len(row), 3 * len(contacts))
        for k, contact in enumerate(contacts):
            arm = [(p - c) / answer["torque_scale_m"]
                   for p, c in zip(contact["position_m"], answer["centre_of_mass_m"])]
            for column in range(3 * k, 3 * k + 3):
                f, t = ([row[column] for row in G["matrix"][part]]
                        for part in (slice(0, 3), slice(3, 6)))
                self.assertAlmostEqual(math.hypot(*f), 1, delta=1e-9)
                moment = [arm[1] * f[2] - arm[2] * f[1], arm[2] * f[0] - arm[0] * f[2],
                          arm[0] * f[1] - arm[1] * f[0]]
                for one, other in zip(t, moment):
                    self.assertAlmostEqual(one, other, delta=1e-9)
            for one, other in zip(contact["normal"], (row[3 * k] for row in G["matrix"])):
                self.assertAlmostEqual(one, other, delta=1e-9)
        told = json.loads(self.run_it("quality", str(out), "--no-volume", "--json").stdout)
        self.assertFalse([words for words in told["warnings"] if "ignored" in words])
        self.assertAlmostEqual(told["grasp_matrix"]["isotropy"], G["isotropy"], delta=1e-9)
        self.assertLessEqual(told["epsilon"]["lower"], answer["epsilon"]["upper"])
        self.assertGreaterEqual(told["epsilon"]["upper"], answer["epsilon"]["lower"])

    def test_a_mesh_of_millimetres_is_asked_for_its_unit(self):
        (self.folder / "big.obj").write_text("v 0 0 0\nv 20 0 0\nv 0 20 0\nv 0 0 20\n"
                                             "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n")
        asked = self.run_it("validate", self.world(kind="mesh", size='file = "big.obj"'))
        self.assertEqual(asked.returncode, 1)
        self.assertIn("20 m across: are its numbers millimetres? scale = 0.001",
                      asked.stderr + asked.stdout)
        for scale in ("0.001", "1"):
            told = self.world(kind="mesh", size=f'file = "big.obj"\nscale = {scale}')
            self.assertEqual(self.run_it("validate", told).returncode, 0, scale)

    def test_wrong_names_are_told(self):
        world = self.world(ways="openin = 55")
        self.assertIn("has no coordinate 'openin', did you mean 'opening'?",
                      self.run_it("close", world).stderr)
        self.assertIn("the world has no hand 'claw'",
                      self.run_it("close", self.world(), "--hand", "claw").stderr)
        self.assertIn("outside its limits", self.run_it("close", self.world(ways="opening = 56")).stderr)


if __name__ == "__main__":
    if len(sys.argv) > 1 and not sys.argv[1].startswith("-"):
        PROGRAM = sys.argv.pop(1)
    unittest.main()

"""End-to-end tests of the commands `thenar quality`, `grasp` and `close`; expected numbers are derived here by hand.

Usage: grasp_commands_test.py [path of the program]; else the environment's THENAR.
"""
import itertools
import json
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

PROGRAM = os.environ.get("THENAR", "thenar")
KEYS = ["epsilon", "volume", "force_closure", "rank", "missing_direction", "worst_wrench", "cpu_s"]
EXACT = 1e-9  # of polytopes

# Six fingers that press without friction along +-x, +-y, +-z would leave torques free; generators
# along the twelve half axes of the wrench space do not: their hull is the cross-polytope.
CROSS = [[s if k == i else 0 for k in range(6)] for i in range(6) for s in (1, -1)]


def contact(position, normal, friction, **more):
    return {"position": position, "normal": normal, "friction": friction, **more}


def generators(wrenches):
    return contact([0, 0, 0], [0, 0, 1], 0, wrenches=wrenches)


def grasp(contacts, scale=1.0):
    return {"centre_of_mass": [0, 0, 0], "torque_scale": scale, "contacts": contacts}


PINCH = grasp([contact([-1, 0, 0], [1, 0, 0], 0.5), contact([1, 0, 0], [-1, 0, 0], 0.5)])


class Quality(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, content, name="contacts.json"):
        path = self.folder / name
        path.write_text(content if isinstance(content, str) else json.dumps(content))
        return str(path)

    def run_on(self, content, *words):
        return subprocess.run([PROGRAM, "quality", self.write(content), *words],
                              capture_output=True, text=True, check=False, timeout=60)

    def ask(self, content, *words):
        result = self.run_on(content, "--json", *words)
        self.assertEqual(result.returncode, 0, result.stderr)
        answer = json.loads(result.stdout)
        self.assertLessEqual(answer["epsilon"]["lower"], answer["epsilon"]["upper"])
        return answer

    def complaint(self, content):
        result = self.run_on(content)
        self.assertEqual((result.returncode, result.stdout), (1, ""), result.stderr)
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        return result.stderr.strip().removeprefix(f"thenar: {self.folder}/contacts.json:")

    def test_answers_with_the_promised_keys(self):
        answer = self.ask(PINCH)
        self.assertEqual(list(answer)[:len(KEYS)], KEYS)
        self.assertEqual(len(answer["worst_wrench"]), 6)
        self.assertEqual(len(answer["missing_direction"]), 6)

    # The cross-polytope's facets are 1 / sqrt 6 off its centre; its volume is 2^6 / 6!.
    def test_cross_polytope_is_exact(self):
        for contacts in ([generators(CROSS)], [generators([w]) for w in CROSS]):
            answer = self.ask(grasp(contacts))
            for bound in ("lower", "upper"):
                self.assertAlmostEqual(answer["epsilon"][bound], 1 / math.sqrt(6), delta=EXACT)
            self.assertAlmostEqual(answer["volume"], 64 / 720, delta=EXACT)
            self.assertTrue(answer["force_closure"])
            self.assertIsNone(answer["missing_direction"])
            self.assertEqual(answer["rank"], 6)

    # The cube's 64 corners: facets at 1, volume 2^6. As one contact its hull is the same for both
    # norms, as it holds 0.
    def test_cube_is_exact_in_both_norms(self):
        cube = grasp([generators([list(c) for c in itertools.product((-1, 1), repeat=6)])])
        for norm in ("l1", "linf"):
            answer = self.ask(cube, "--norm", norm)
            self.assertAlmostEqual(answer["epsilon"]["lower"], 1, delta=EXACT)
            self.assertAlmostEqual(answer["volume"], 64, delta=64 * EXACT)

    # Twelve contacts of one generator each, every one with a limit of its own, add up to the cube.
    def test_linf_adds_contacts_up(self):
        answer = self.ask(grasp([generators([w]) for w in CROSS]), "--norm", "linf")
        self.assertAlmostEqual(answer["epsilon"]["lower"], 1, delta=EXACT)
        self.assertAlmostEqual(answer["volume"], 64, delta=64 * EXACT)

    # Moved by 2 along x, the origin is 2 - 1 beyond the cross-polytope's corner.
    def test_epsilon_is_negative_outside(self):
        moved = [[w[0] + 2, *w[1:]] for w in CROSS]
        answer = self.ask(grasp([generators(moved)]))
        self.assertFalse(answer["force_closure"])
        self.assertAlmostEqual(answer["epsilon"]["lower"], -1, delta=EXACT)
        self.assertAlmostEqual(answer["epsilon"]["upper"], -1, delta=EXACT)
        self.assertAlmostEqual(answer["volume"], 64 / 720, delta=EXACT)
        self.assertAlmostEqual(answer["missing_direction"][0], -1, delta=1e-6)

    # Two hard fingers cannot stop a ball from turning about the line between them.
    def test_pinch_misses_the_twist_about_its_line(self):
        answer = self.ask(PINCH)
        self.assertFalse(answer["force_closure"])
        self.assertEqual(answer["rank"], 5)
        self.assertAlmostEqual(answer["epsilon"]["upper"], 0, delta=EXACT)
        self.assertAlmostEqual(abs(answer["missing_direction"][3]), 1, delta=1e-6)
        self.assertEqual(answer["volume"], 0)

    def test_one_contact_and_none_have_honest_answers(self):
        one = self.ask(grasp([contact([0, 0, 0], [0, 0, 1], 0.5)]))
        self.assertFalse(one["force_closure"])
        self.assertAlmostEqual(one["epsilon"]["upper"], -1, delta=EXACT)  # the normal itself
        none = self.ask(grasp([]))
        self.assertEqual((none["force_closure"], none["rank"], none["volume"]), (False, 0, 0))

    def test_pyramids_are_no_better_than_cones(self):
        third = 2 * math.pi / 3
        ring = [[math.cos(k * third), math.sin(k * third), 0] for k in range(3)]
        three = grasp([contact(p, [-x for x in p], 0.8) for p in ring])
        cone = self.ask(three)["epsilon"]["upper"]
        pyramids = [self.ask(three, "--edges", str(m))["epsilon"]["lower"] for m in (4, 8, 64)]
        self.assertTrue(0 < pyramids[0] <= pyramids[1] + 1e-3 <= pyramids[2] + 2e-3 <= cone + 3e-3,
                        (pyramids, cone))

    def test_several_files_give_a_line_each(self):
        other = self.write(grasp([generators(CROSS)]), "other.json")
        out = self.folder / "answers" / "all.jsonl"
        result = self.run_on(PINCH, other, "--json", "--out", str(out))
        lines = [json.loads(line) for line in result.stdout.splitlines()]
        self.assertEqual([line["force_closure"] for line in lines], [False, True])
        self.assertEqual(out.read_text(), result.stdout)

    def test_speaks_in_words_without_json(self):
        text = self.run_on(PINCH).stdout
        for words in ("force closure", "no", "epsilon", "rank", "5 of 6", "cannot make"):
            self.assertIn(words, text)

    def test_bad_files_say_where_and_what(self):
        def pretty(change):
            content = json.loads(json.dumps(PINCH))
            change(content)
            return json.dumps(content, indent=1)

        def first(**values):
            return lambda content: content["contacts"][0].update(values)

        cases = [
            ("{\n\"centre_of_mass\": [0, 0, NaN]}", "2: wanted JSON: "),
            ("{\n\"centre_of_mass\": [0, 0,\n Infinity]}", "3: wanted JSON: "),
            ("{\n\n\"torque_scale\": 1e999}", "3: wanted JSON: number overflow"),
            ("", "1: wanted JSON: "),
            ("[]", "1: wanted an object, got []"),
            ("{\"contacts\":\n" + 100000 * "[" + 100000 * "]" + "}",
             "2: wanted brackets at most 32 deep"),
            ("{\"torque_scale\": 1,\n\"torque_scale\": 2}", "2: 'torque_scale' is given twice"),
            (pretty(lambda c: c.pop("torque_scale")), "1: the file has no 'torque_scale'"),
            (pretty(lambda c: c.update(torque_scale=0)),
             "7: wanted a number > 0 as torque_scale, got 0"),
            (pretty(lambda c: c.update(torque_scale="1")),
             "7: wanted a number > 0 as torque_scale, got \"1\""),
            (pretty(lambda c: c.update(centre_of_mass=[0, 0])),
             "2: wanted 3 numbers as centre_of_mass, got [0,0]"),
            (pretty(lambda c: c.update(colour=1)),
             "36: the file knows no 'colour', only centre_of_mass, torque_scale, contacts, name, "
             "source"),
            (pretty(lambda c: c.update(contacts=3)), "8: wanted a list of contacts as contacts, got 3"),
            (pretty(lambda c: c["contacts"].append(5)), "35: wanted an object as contacts.2, got 5"),
            (pretty(lambda c: c["contacts"][1].pop("normal")), "22: contacts.1 has no 'normal'"),
            (pretty(first(friction=-0.1)),
             "20: wanted a number >= 0 as contacts.0.friction, got -0.1"),
            (pretty(first(torsion=[1])), "21: wanted a number >= 0 as contacts.0.torsion, got [1]"),
            (pretty(first(normal=[0, 0, 0])),
             "15: wanted a unit vector (its length is 0) as contacts.0.normal, got [0,0,0]"),
            (pretty(first(normal=[1, 0.1, 0])),
             "15: wanted a unit vector (its length is 1.00499) as contacts.0.normal, got [1,0.1,0]"),
            (pretty(first(normal=[1, None, 0])),
             "15: wanted 3 numbers as contacts.0.normal, got [1,null,0]"),
            (pretty(first(wrenches=[])),
             "21: wanted at least one wrench as contacts.0.wrenches, got []"),
            (pretty(first(position=[1e300, 0, 0])),
             "10: wanted no more than 1e+12 as contacts.0.position, got [1e+300,0,0]"),
            (pretty(first(position=["0", 0, 0])),
             "10: wanted 3 numbers as contacts.0.position, got [\"0\",0,0]"),
            (pretty(first(position=None)),
             "10: wanted 3 numbers as contacts.0.position, got null"),
            (pretty(first(friction=True)),
             "20: wanted a number >= 0 as contacts.0.friction, got true"),
            (pretty(first(friction=1e300)),
             "20: wanted no more than 1e+12 as contacts.0.friction, got 1e+300"),
            (pretty(lambda c: c.update(torque_scale=1e-300)),
             "7: wanted at least 1e-12 as torque_scale, got 1e-300"),
            (pretty(lambda c: c.update(contacts=None)),
             "8: wanted a list of contacts as contacts, got null"),
            (pretty(first(wrenches=[[1e300, 0, 0, 0, 0, 0]])),
             "22: wanted no more than 1e+12 as contacts.0.wrenches.0, got [1e+300,0,0,0,0,0]"),
            (pretty(first(wrenches=[[1, 2]])),
             "22: wanted 6 numbers as contacts.0.wrenches.0, got [1,2]"),
        ]
        for content, wanted in cases:
            with self.subTest(wanted=wanted):
                self.assertTrue(self.complaint(content).startswith(wanted),
                                (self.complaint(content), wanted))

    def test_null_leaves_out_what_is_optional(self):
        plain = self.ask(PINCH)
        nulls = grasp([{**c, "wrenches": None, "torsion": None} for c in PINCH["contacts"]])
        answer = self.ask(nulls)
        for key in ("epsilon", "volume", "rank"):
            self.assertEqual(answer[key], plain[key])

    # Five soft fingers each with a limit of its own: either the hull is done, or nothing is quoted.
    def test_a_volume_is_whole_or_null(self):
        ring = [2 * math.pi * k / 5 for k in range(5)]
        soft = [contact([math.cos(a), math.sin(a), 0.1 * k], [-math.cos(a), -math.sin(a), 0], 0.8,
                        torsion=0.3) for k, a in enumerate(ring)]
        answer = self.ask(grasp(soft), "--norm", "linf")
        self.assertEqual(answer["volume"] is None, not answer["volume_complete"])
        self.assertGreater(answer["volume_bounds"]["lower"], 0)

    def test_nearly_unit_normals_are_made_unit(self):
        self.assertEqual(
            self.ask(grasp([contact([0, 0, 0], [0, 0, 1.0009], 0)]))["epsilon"]["lower"],
            self.ask(grasp([contact([0, 0, 0], [0, 0, 1], 0)]))["epsilon"]["lower"])

    def test_a_file_that_is_not_there_is_named(self):
        missing = str(self.folder / "missing.json")
        result = subprocess.run([PROGRAM, "quality", missing], capture_output=True, text=True,
                                check=False)
        self.assertEqual((result.returncode, result.stderr),
                         (1, f"thenar: {missing}:1: cannot be read\n"))


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
            result = subprocess.run([PROGRAM, "grasp", str(worlds / f"{name}.toml"), "--json"],
                                    capture_output=True, text=True, check=False, timeout=60)
            self.assertEqual(result.returncode, 0, result.stderr)
            answer = json.loads(result.stdout)
            self.assertTrue(answer["force_closure"], name)
            self.assertGreater(answer["epsilon"]["lower"], 0, name)


class DataFromAnywhere(unittest.TestCase):
    """What comes with thenar is found by name, in the order of the search."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_in(self, *words, **more):
        return subprocess.run([pathlib.Path(PROGRAM).resolve(), *words], capture_output=True,
                              text=True, check=False, timeout=60, cwd=self.folder,
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

    def test_a_complaint_names_all_places(self):
        result = self.run_in("grasp", "jaw_boy", THENAR_DATA="/tmp/nowhere")
        self.assertEqual(result.returncode, 1)
        for words in ("there is no world 'jaw_boy', did you mean 'jaw_box'?", "looked in",
                      "/tmp/nowhere, data, ", "/share/thenar, ", "/data"):
            self.assertIn(words, result.stderr)
        self.assertIn("--data: there is no folder elsewhere",
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
                              timeout=60)

    def ask(self, *words):
        result = self.run_it(*words, "--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        return json.loads(result.stdout)

    # Two hard points on a line cannot twist the ball about it, whatever the friction.
    def test_a_ball_between_jaws_turns_about_the_line_of_contacts(self):
        answer = self.ask("close", self.world())
        self.assertEqual(answer["outcome"], "grasped")
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
        self.assertEqual(again["outcome"], "grasped")
        self.assertEqual(again["hand_pose"], answer["hand_pose"])
        self.assertAlmostEqual(again["coordinates"][0]["value"], answer["coordinates"][0]["value"],
                               delta=GAP)

    def test_the_same_seed_gives_the_same_grasp(self):
        world = self.world(kind="box", size="size_mm = [20, 30, 40]")
        answers = [self.ask("grasp", world, "--random", "20", "--seed", "3") for _ in range(2)]
        for answer in answers:
            self.assertEqual(sum(answer["starts"]["outcomes"].values()), 20)
            answer.pop("cpu_s")
        self.assertEqual(answers[0], answers[1])

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

    def test_zeros_have_no_sign_and_time_counts_all(self):
        world = self.world(kind="box", size="size_mm = [20, 20, 20]")
        words = ("grasp", world, "--no-approach", "--robustness", "30", "--json")
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

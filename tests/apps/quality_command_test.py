"""End-to-end tests of the command `thenar quality`; expected numbers are derived here by hand.

Usage: quality_command_test.py [path of the program]; else the environment's THENAR.
"""
import itertools
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

from patience import HANG

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

# Three fingers around a ball, 120 degrees apart.
THREE = grasp([contact([math.cos(a), math.sin(a), 0], [-math.cos(a), -math.sin(a), 0], 0.8)
               for a in (0, 2 * math.pi / 3, 4 * math.pi / 3)])


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
                              capture_output=True, text=True, check=False, timeout=HANG)

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

    def test_contacts_have_names_and_answers_have_tables(self):
        csv, whole = self.folder / "all.csv", self.folder / "all.json"
        result = subprocess.run([PROGRAM, "quality", "two_soft_fingers", self.write(PINCH), "--csv",
                                 "-o", str(csv), "-o", str(whole)],
                                capture_output=True, text=True, check=False, timeout=HANG)
        self.assertEqual(result.returncode, 0, result.stderr)
        rows = [line.split(",") for line in csv.read_text().splitlines()]
        self.assertEqual(result.stdout, csv.read_text())
        self.assertEqual([row[rows[0].index("force_closure")] for row in rows[1:]], ["yes", "no"])
        answers = json.loads(whole.read_text())
        self.assertEqual([a["rank"] for a in answers["answers"]], [6, 5])
        self.assertTrue(answers["provenance"]["command"].startswith("thenar quality"))
        wrong = subprocess.run([PROGRAM, "quality", "two_soft_finger"], capture_output=True, text=True,
                               check=False)
        self.assertIn("did you mean 'two_soft_fingers'", wrong.stderr)

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
             "2: wanted JSON that nests at most 32 deep, got more"),
            ("{\"torque_scale\": 1,\n\"torque_scale\": 2}", "2: 'torque_scale' is given twice"),
            (pretty(lambda c: c.pop("torque_scale")), "1: the file has no 'torque_scale'"),
            (pretty(lambda c: c.update(torque_scale=0)),
             "7: wanted a number > 0 as torque_scale, got 0"),
            (pretty(lambda c: c.update(torque_scale="1")),
             "7: wanted a number > 0 as torque_scale, got \"1\""),
            (pretty(lambda c: c.update(centre_of_mass=[0])),
             "2: wanted 3 numbers as centre_of_mass, got [0]"),
            (pretty(lambda c: c.update(centre_of_mass=[0, 0])),  # a plane's, which the places are not
             "9: wanted 2 numbers as contacts.0.position, got [-1,0,0]"),
            (pretty(first(patch=-1)), "21: wanted an integer of 0 to 1000000000 as contacts.0.patch, got -1"),
            (pretty(lambda c: c.update(task={})), "36: wanted one of loads, box and ellipsoid as task, got {}"),
            (pretty(lambda c: c.update(task={"loads": []})),
             "37: wanted a list of loads as task.loads, got []"),
            (pretty(lambda c: c.update(center_of_mass=[0, 0, 0])),
             "36: the file knows no 'center_of_mass', did you mean 'centre_of_mass'?"),
            (pretty(first(torsoin=1)), "21: contacts.0 knows no 'torsoin', did you mean 'torsion'?"),
            (pretty(lambda c: c.update(contacts=3)), "8: wanted a list of contacts as contacts, got 3"),
            (pretty(lambda c: c["contacts"].append(5)), "35: wanted an object as contacts.2, got 5"),
            (pretty(lambda c: c["contacts"][1].pop("normal")), "22: contacts.1 has no 'normal'"),
            (pretty(first(friction=-0.1)),
             "20: wanted a number >= 0 as contacts.0.friction, got -0.1"),
            (pretty(first(torsion=[1])), "21: wanted a number >= 0 as contacts.0.torsion, got [1]"),
            (pretty(first(normal=[0, 0, 0])),
             "15: wanted a non-zero vector as contacts.0.normal, got [0,0,0]"),
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

    # Two faces in each place, as of two bodies one behind the other, make a set of twice the size, 2^6
    # times the volume; a place written twice is one contact.
    def test_volumes_of_six_contacts_are_known(self):
        words = ("--norm", "linf", "--edges", "6")
        once = self.ask(THREE, *words)["volume"]
        faces = [{**c, "patch": k} for k, c in enumerate(2 * THREE["contacts"])]
        self.assertAlmostEqual(self.ask(grasp(faces), *words)["volume"] / once, 64, delta=64e-6)
        again = self.ask(grasp(2 * THREE["contacts"]), *words)
        self.assertAlmostEqual(again["volume"] / once, 1, delta=1e-6)
        self.assertIn("the place and normal of another contact: contacts 3, 4, 5", again["warnings"][0])
        ring = [contact([math.cos(k), math.sin(k), 0.1 * k], [-math.cos(k), -math.sin(k), 0], 0.5)
                for k in range(6)]
        self.assertTrue(self.ask(grasp(ring), *words)["volume_complete"])

    # Five soft fingers each with a limit of its own: either the hull is done, or nothing is quoted.
    def test_a_volume_is_whole_or_null(self):
        ring = [2 * math.pi * k / 5 for k in range(5)]
        soft = [contact([math.cos(a), math.sin(a), 0.1 * k], [-math.cos(a), -math.sin(a), 0], 0.8,
                        torsion=0.3) for k, a in enumerate(ring)]
        answer = self.ask(grasp(soft), "--norm", "linf")
        self.assertEqual(answer["volume"] is None, not answer["volume_complete"])
        self.assertGreater(answer["volume_bounds"]["lower"], 0)

    def test_normals_are_made_unit_with_a_warning_if_it_matters(self):
        unit = self.ask(THREE)
        for length, warnings in ((1.0009, []), (2, ["a normal of length 2 was made unit: contact 1"])):
            given = json.loads(json.dumps(THREE))
            given["contacts"][1]["normal"] = [length * x for x in given["contacts"][1]["normal"]]
            answer = self.ask(given)
            self.assertEqual(answer["warnings"], warnings)
            for bound in ("lower", "upper"):
                self.assertAlmostEqual(answer["epsilon"][bound], unit["epsilon"][bound], delta=1e-3)

    def warning(self, content):
        warnings = self.ask(content)["warnings"]
        self.assertEqual(len(warnings), 1, warnings)
        self.assertIn("warning", self.run_on(content).stdout)
        return warnings[0]

    def test_what_looks_like_a_mistake_is_said(self):
        self.assertEqual(self.ask(THREE)["warnings"], [])
        in_mm = grasp([{**c, "position": [1000 * x for x in c["position"]]}
                       for c in THREE["contacts"]], 1000)
        self.assertIn("1000 m, or 1 torque scales, from the centre of mass: contacts 0, 1, 2; lengths "
                      "are in metres", self.warning(in_mm))
        self.assertIn("point away", self.warning(grasp([{**c, "normal": [-x for x in c["normal"]]}
                                                        for c in THREE["contacts"]])))
        self.assertIn("friction 30: contact 1;",
                      self.warning(grasp([THREE["contacts"][0], {**THREE["contacts"][1], "friction": 30}])))
        self.assertEqual(self.warning({**THREE, "expected": 1}), "ignored, as it is not known: expected")

    # A pyramid up along z with mu 0.5 from a point down it, in a wrench space 10 wide elsewhere. With
    # corners along x the nearest facet (4, 0.1, -1, 0.1, 0.1, 0.1) holds one of them and (0, 10, ..);
    # turned by 45 degrees it holds two, at x = sqrt 0.125, and is (2 / x, 0, -1, 0.1, 0.1, 0.1).
    def test_the_first_edge_turns_pyramids(self):
        wide = [[s * 10 if k == i else 0 for k in range(6)] for i in (1, 3, 4, 5) for s in (1, -1)]
        up = grasp([contact([0, 0, 0], [0, 0, 1], 0.5), generators([[0, 0, -1, 0, 0, 0], *wide])])
        for angle, squares in ((0, 17.04), (45, 33.03), (90, 17.04)):
            found = self.ask(up, "--edges", "4", "--first-edge", str(angle))["epsilon"]["lower"]
            self.assertAlmostEqual(found, 1 / math.sqrt(squares), delta=EXACT)
        self.assertEqual(self.run_on(THREE, "--first-edge", "3").returncode, 1)

    # Jaws on a box: two faces of four corners. Corners written twice, or the middle of a face added,
    # are the same faces; without patches eight hands would push.
    def test_a_patch_has_one_limit_however_it_is_cut(self):
        def faces(cut):
            return grasp([contact([side, y, z], [-side, 0, 0], 0.5, patch=side + 1)
                          for side in (-1, 1)
                          for y, z in cut * ((1, 1), (1, -1), (-1, -1), (-1, 1)) + ((0, 0),) * (cut - 1)])
        once, cut = (self.ask(faces(k), "--norm", "linf", "--no-volume")["epsilon"] for k in (1, 2))
        self.assertLessEqual(cut["lower"], once["upper"])
        self.assertLessEqual(once["lower"], cut["upper"])
        free = grasp([{k: v for k, v in c.items() if k != "patch"} for c in faces(1)["contacts"]])
        self.assertGreater(self.ask(free, "--norm", "linf", "--no-volume")["epsilon"]["lower"],
                           2 * once["upper"])

    def test_the_volume_may_be_left_out(self):
        answer = self.ask(THREE, "--no-volume")
        self.assertEqual([answer[k] for k in ("volume", "volume_bounds", "volume_complete")], 3 * [None])
        self.assertEqual(answer["epsilon"], self.ask(THREE)["epsilon"])

    # Two fingers of friction mu press with N each along x. A pull of 1 N across takes 2 mu N = 1, so a
    # sum of 1 / mu; along x one finger of 1 N alone. With one limit a finger it is 1 / (2 mu).
    def test_least_squeeze_of_loads(self):
        loads = [[0, 1, 0, 0, 0, 0], [2, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 1, 0, 0]]
        for norm, squeezes in (("l1", [2, 2, 0, None]), ("linf", [1, 2, 0, None])):
            task = self.ask({**PINCH, "task": {"loads": loads}}, "--norm", norm)["task"]
            for found, wanted in zip(task["squeezes_N"], squeezes):
                self.assertEqual(found is None, wanted is None)
                if wanted is not None:
                    self.assertAlmostEqual(found, wanted, delta=1e-7)
            self.assertEqual(task["margin"], {"lower": 0, "upper": 0})
            self.assertEqual(task["worst_load"], loads[3])
            held = self.ask({**PINCH, "task": {"loads": loads[:3]}}, "--norm", norm)["task"]
            self.assertAlmostEqual(held["squeeze_N"], max(squeezes[:3]), delta=1e-7)
        self.assertIn("not withstood", self.run_on({**PINCH, "task": {"loads": loads}}).stdout)

    # A box of +-1 N across and +-1 N vertically: its corners pull by sqrt 2, so a sum of sqrt 2 / mu;
    # the ball of 1 N across has 1 / mu.
    def test_least_squeeze_of_boxes_and_ellipsoids(self):
        box = {"box": [[0, -1, -1, 0, 0, 0], [0, 1, 1, 0, 0, 0]]}
        task = self.ask({**PINCH, "task": box})["task"]
        self.assertAlmostEqual(task["squeeze_N"], 2 * math.sqrt(2), delta=1e-6)
        ball = {"ellipsoid": [[0, 1, 0, 0, 0, 0], [0, 0, 1, 0, 0, 0]]}
        margin = self.ask({**PINCH, "task": ball})["task"]["margin"]
        self.assertLessEqual(margin["lower"], 0.5 + 1e-9)
        self.assertGreaterEqual(margin["upper"], 0.5 - 1e-9)

    # Forces along x of both fingers, squared singular value 2, along y and z 2, torques about y and z
    # 2 at the distance 1, none about x.
    def test_measures_of_the_grasp_matrix(self):
        found = self.ask(PINCH)["grasp_matrix"]
        self.assertEqual((found["rank"], found["internal_forces"], found["least_singular_value"]),
                         (5, 1, 0))
        soft = grasp([{**c, "torsion": 0.1} for c in PINCH["contacts"]])
        found = self.ask(soft)["grasp_matrix"]
        self.assertEqual((found["rank"], found["internal_forces"]), (6, 2))
        for key, wanted in (("least_singular_value", math.sqrt(2)), ("isotropy", 1), ("volume", 8)):
            self.assertAlmostEqual(found[key], wanted, delta=1e-12)
        self.assertIsNone(self.ask(grasp([generators(CROSS)]))["grasp_matrix"])

    # tests/grasp/quality/planar_grasp_test.cpp derives mu / sqrt(2 + mu^2).
    def test_planar_grasps(self):
        pinch = {"centre_of_mass": [0, 0], "torque_scale": 1,
                 "contacts": [contact([-1, 0], [1, 0], 0.5), contact([1, 0], [-1, 0], 0.5)]}
        answer = self.ask({**pinch, "task": {"loads": [[0, 1, 0]]}})
        self.assertTrue(answer["planar"] and answer["force_closure"])
        self.assertAlmostEqual(answer["epsilon"]["lower"], 0.5 / math.sqrt(2.25), delta=EXACT)
        self.assertEqual((answer["rank"], len(answer["worst_wrench"])), (3, 3))
        self.assertAlmostEqual(answer["task"]["squeeze_N"], 2, delta=1e-7)
        self.assertEqual(answer["grasp_matrix"]["internal_forces"], 1)
        self.assertIn("3 of 3", self.run_on(pinch).stdout)
        smooth = {**pinch, "contacts": [{**c, "friction": 0} for c in pinch["contacts"]]}
        answer = self.ask(smooth)
        self.assertEqual((answer["force_closure"], answer["rank"], answer["epsilon"]["upper"]),
                         (False, 1, 0))

    # Each line has its answer, or its error by number; nothing stops the stream.
    def test_a_stream_has_a_line_for_each(self):
        lines = [json.dumps(PINCH), "{\"contacts\": 3", "", json.dumps(THREE),
                 json.dumps({**THREE, "torque_scale": 0})]
        result = subprocess.run([PROGRAM, "quality", "-", "--no-volume"], input="\n".join(lines),
                                capture_output=True, text=True, check=False, timeout=HANG)
        self.assertEqual(result.returncode, 1)
        answers = [json.loads(line) for line in result.stdout.splitlines()]
        self.assertEqual([a["line"] for a in answers], [1, 2, 4, 5])
        self.assertEqual(["error" in a for a in answers], [False, True, False, True])
        self.assertTrue(answers[2]["force_closure"])
        self.assertTrue(answers[1]["error"].startswith("stdin:2: wanted JSON"), answers[1])
        self.assertTrue(answers[3]["error"].startswith("stdin:5: wanted a number > 0"), answers[3])
        self.assertEqual(result.stderr.count("\n"), 2)
        self.assertEqual(self.run_on(PINCH, "-").returncode, 1)

    # The commonest grasp, to 1e-9: min(e, 1 / sqrt(1 + 2 / mu^2)) at the distance of the scale.
    def test_soft_pinches_are_certified(self):
        for mu, e in ((0.5, 0.9), (0.5, 0.1)):
            soft = grasp([{**c, "friction": mu, "torsion": e} for c in PINCH["contacts"]])
            answer = self.ask(soft, "--gap", "1e-9", "--no-volume")
            self.assertTrue(answer["converged"])
            wanted = min(e, 1 / math.sqrt(1 + 2 / mu**2))
            self.assertLessEqual(answer["epsilon"]["lower"], wanted)
            self.assertAlmostEqual(answer["epsilon"]["lower"], wanted, delta=1e-9)

    def test_a_broken_file_hinders_no_other(self):
        broken = self.write("{", "broken.json")
        last = self.write(grasp([generators(CROSS)]), "last.json")
        out = self.folder / "all.jsonl"
        result = self.run_on(THREE, broken, last, "--json", "--out", str(out))
        self.assertEqual(result.returncode, 1)
        self.assertEqual([json.loads(line)["file"] for line in result.stdout.splitlines()],
                         [str(self.folder / "contacts.json"), last])
        self.assertTrue(result.stderr.startswith(f"thenar: {broken}:1: wanted JSON"), result.stderr)
        self.assertEqual(out.read_text(), result.stdout)

    # Whatever the contacts, all promised keys are there, in JSON that knows no NaN.
    def test_degenerate_contacts_have_whole_answers(self):
        one = contact([0.5, 0, 0], [-1, 0, 0], 0.5)
        sets = [[], [one], [one] * 2, [one] * 5, THREE["contacts"][:2], [{**one, "friction": 0}],
                [{**c, "friction": 0} for c in THREE["contacts"]], [contact([0, 0, 0], [0, 0, 1], 0)],
                [generators([[0] * 6])], [generators([[1, 0, 0, 0, 0, 0]] * 3)]]
        files = [self.write(grasp(contacts, scale), f"{i} {scale}.json")
                 for i, contacts in enumerate(sets) for scale in (1e-3, 1, 1e3)]
        for norm, edges in itertools.product(("l1", "linf"), "04"):
            text = self.run_on(THREE, *files, "--json", "--norm", norm, "--edges", edges).stdout
            self.assertNotIn("-0.0,", text)
            lines = text.splitlines()[1:]
            self.assertEqual(len(lines), len(files))
            for line in lines:
                answer = json.loads(line, parse_constant=self.fail)
                self.assertEqual(list(answer)[:len(KEYS)], KEYS)
                self.assertFalse(answer["force_closure"])
                self.assertEqual(answer["volume"], 0)
                self.assertAlmostEqual(math.hypot(*answer["missing_direction"]), 1, delta=1e-6)
                self.assertLessEqual(answer["epsilon"]["upper"], 0)
                self.assertLess(answer["rank"], 6)

    def test_a_file_that_is_not_there_is_named(self):
        missing = str(self.folder / "missing.json")
        result = subprocess.run([PROGRAM, "quality", missing], capture_output=True, text=True,
                                check=False)
        self.assertEqual((result.returncode, result.stderr),
                         (1, f"thenar: there is no file '{missing}'\n"))


if __name__ == "__main__":
    if len(sys.argv) > 1 and not sys.argv[1].startswith("-"):
        PROGRAM = sys.argv.pop(1)
    unittest.main()

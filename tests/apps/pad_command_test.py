"""Pads that are pressed, fitted and reduced to laws, by `thenar pad press`, `fit` and `laws`: forces, files, refusals.

Usage: pad_command_test.py [path of the program]; else the environment's THENAR. Run from anywhere.
"""
import csv
import io
import json
import math
import os
import pathlib
import re
import signal
import subprocess
import sys
import unittest

from files import Files
from patience import HANG, stopped

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("THENAR", "thenar")
QUICK = ["--error", "20", "--points", "2"]

# A cube of 10 mm, in millimetres.
CUBE = """OFF
8 6 0
0 0 0
10 0 0
10 10 0
0 10 0
0 0 10
10 0 10
10 10 10
0 10 10
4 3 2 1 0
4 4 5 6 7
4 0 1 5 4
4 1 2 6 5
4 2 3 7 6
4 3 0 4 7
"""


# Measured presses of index_fitted; its exponent is known to start where it is.
PRESSES = """title = "Presses"
pad = "index_fitted"
source = "Own"
[sources]
Own = "Own measurement"
[cells]
across = 2
around = 1
through = 2
[[constant]]
constant = "shear_modulus"
[[constant]]
constant = "exponent"
prior_factor = 1.3
[[press]]
name = "flat"
object = "plane"
imposed = "force"
[[press.data]]
force_N = [0.5, 2]
indentation_mm = [2, 3]
sd_indentation_mm = [0.2, 0.3]
"""

# A pad without relaxation, whose numbers but one are measured.
COARSE = """name = "coarse"
source = "Own"
[sources]
Own = "Own measurement"
[shape]
length_mm = 24
width_mm = 16
height_mm = 10
bone_length_mm = 14
bone_width_mm = 7
bone_height_mm = 4.5
[pulp]
law = "neo-hookean"
shear_modulus_kPa = 12
poisson_ratio = 0.45
assumed = ["law"]
[cells]
across = 2
around = 2
through = 2
"""


def run(*words, command="press"):
    return subprocess.run([PROGRAM, "pad", command, *map(str, words)], capture_output=True, text=True,
                          check=False, cwd=ROOT, timeout=HANG)


def interrupted(test, command, *words):
    """What a command prints that gets Ctrl-C once it works, and writes no file of its own."""
    code, out, told = stopped([PROGRAM, "pad", command, *words], signal.SIGINT, lambda code, _: code == 130, cwd=ROOT)
    test.assertEqual(code, 130, told)
    test.assertIn("was not written", told)
    return out


def ask(*words):
    """The JSON answer."""
    result = run(*words, "--json")
    assert result.returncode == 0, result.stderr
    return json.loads(result.stdout)


def normal_sum(answer):
    return sum(node["normal_N"] for node in answer["patch"])


class Answers(Files):
    def test_force_is_reached_and_is_that_of_its_nodes(self):
        answer = ask("--force", 0.3, "--friction", 0, *QUICK)
        self.assertAlmostEqual(answer["force_N"], 0.3, delta=1e-7)
        self.assertAlmostEqual(normal_sum(answer), 0.3, delta=1e-6)
        self.assertLessEqual(answer["force_error"], 0.2)
        self.assertEqual([each["phase"] for each in answer["instants"]], ["way", "way"])
        # Nodes of the patch lie on the plate, whose top is the object's place.
        for node in answer["patch"]:
            # Off the wall by what the curved skin has more than its faces: in the mean it is on it.
            self.assertLess(node["place_mm"][2], answer["object_place_mm"][2] + 1e-5)
            self.assertGreater(node["place_mm"][2], answer["object_place_mm"][2] - 0.5)
            self.assertGreater(node["pressure_kPa"], 0)
        self.assertTrue(any("shear_modulus" in each for each in answer["assumed"]))

    def test_depth_goes_from_the_apex(self):
        answer = ask("--depth", 0.8, *QUICK)
        # The skin of index_pad is 10 mm below the nail.
        self.assertAlmostEqual(answer["object_place_mm"][2], 10 - 0.8, delta=1e-5)
        self.assertEqual([round(each["depth_mm"], 9) for each in answer["instants"]], [0.4, 0.8])

    def test_angle_presses_the_distal_part(self):
        answer = ask("--depth", 0.6, "--angle", 30, "--friction", 0, *QUICK)
        self.assertAlmostEqual(answer["along"][0], -0.5, delta=1e-12)
        self.assertAlmostEqual(answer["along"][2], -math.sqrt(0.75), delta=1e-12)
        mean = sum(node["normal_N"] * node["place_mm"][0] for node in answer["patch"]) / normal_sum(answer)
        # Where the ellipsoid of 24 x 16 x 10 mm has that normal.
        self.assertAlmostEqual(mean, 144 * 0.5 / math.hypot(12 * 0.5, 10 * math.sqrt(0.75)), delta=1)

    def test_every_object_presses(self):
        cube = self.path("cube.off", CUBE)
        forces = {}
        for name, more in {"sphere": ["--radius", 4], "cylinder": ["--radius", 4], "edge": ["--radius", 3],
                           cube: []}.items():
            forces[name] = ask("--object", name, *more, "--depth", 0.8, "--error", 40, "--points", 2)["force_N"]
            self.assertGreater(forces[name], 0)
        # A ball touches less than a cylinder of its radius, and this less than a plate.
        self.assertLess(forces["sphere"], forces["cylinder"])
        self.assertLess(forces["cylinder"], ask("--depth", 0.8, *QUICK)["force_N"])

    def test_relaxes_while_held(self):
        answer = ask("--depth", 0.6, "--rate", 100, "--hold", 10, "--hold-points", 4, "--friction", 0,
                     *QUICK)
        way = [each for each in answer["instants"] if each["phase"] == "way"]
        held = [each["force_N"] for each in answer["instants"] if each["phase"] == "hold"]
        self.assertAlmostEqual(way[-1]["time_s"], 6e-3, delta=1e-12)
        self.assertEqual(held, sorted(held, reverse=True))
        self.assertAlmostEqual(answer["time_s"], 10.006, delta=1e-9)
        # Slower than that it can only be softer.
        self.assertLess(ask("--depth", 0.6, "--rate", 0, "--friction", 0, *QUICK)["force_N"], held[-1] * 1.01)


class Outputs(Files):
    def test_table_has_a_row_an_instant(self):
        result = run("--depth", 0.6, "--csv", *QUICK)
        rows = list(csv.DictReader(io.StringIO(result.stdout)))
        self.assertEqual(len(rows), 2)
        self.assertEqual(float(rows[-1]["depth_mm"]), 0.6)
        self.assertGreater(float(rows[-1]["area_mm2"]), float(rows[0]["area_mm2"]))

    def test_page_json_and_rerun(self):
        page, answer = self.path("pad.html"), self.path("pad.json")
        result = run("--depth", 0.5, *QUICK, "-o", page, "-o", answer)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("index_pad under a plane", result.stdout)
        self.assertIn("thenar-report", pathlib.Path(page).read_text())
        again = subprocess.run([PROGRAM, "rerun", answer, "--print"], capture_output=True, text=True,
                               check=False, cwd=ROOT)
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertIn("inputs: 1, unchanged", again.stdout)

    def test_pads_are_listed_validated_and_explained(self):
        for words in (["list", "pads"], ["validate", "data/pads/index_pad.toml"], ["explain", "index_pad"]):
            told = subprocess.run([PROGRAM, *words], capture_output=True, text=True, check=False, cwd=ROOT)
            self.assertEqual(told.returncode, 0, told.stderr)
            self.assertIn("index_pad", told.stdout)


class Refusals(Files):
    def refused(self, *words):
        result = run(*words)
        self.assertEqual(result.returncode, 1, result.stdout)
        self.assertEqual(result.stdout, "")
        return result.stderr

    def test_of_numbers_and_names(self):
        self.assertIn("wanted a force or a depth, got none", self.refused())
        self.assertIn("got both", self.refused("--force", 1, "--depth", 1))
        self.assertIn("wanted a force above 0 N", self.refused("--force", -1))
        self.assertIn("wanted a number [mm], got 'nan'", self.refused("--depth", "nan"))
        self.assertIn("within 60 deg either way, got 75 deg", self.refused("--depth", 1, "--angle", 75))
        self.assertIn("there is no object 'plain', did you mean 'plane'?",
                      self.refused("--depth", 1, "--object", "plain"))
        self.assertIn("there is no pad 'indexpad', did you mean 'index_pad'?",
                      self.refused("--depth", 1, "--pad", "indexpad"))
        self.assertIn("is a subject, wanted a pad",
                      self.refused("--depth", 1, "--pad", "data/subjects/an_chao_index.toml"))
        self.assertIn("no law of tissue 'ogdon', did you mean 'ogden'?",
                      self.refused("--depth", 1, "--law", "ogdon"))
        self.assertIn("after a rate above 0 only", self.refused("--depth", 1, "--hold", 1))

    def test_of_files_names_their_lines(self):
        text = (ROOT / "data/pads/index_pad.toml").read_text()
        line = 1 + text[:text.index("poisson_ratio =")].count("\n")
        bad = self.path("pad.toml", text.replace("poisson_ratio = 0.49", "poisson_ratio = 0.6"))
        self.assertIn(f"pad.toml:{line}: wanted 'poisson_ratio'", self.refused("--depth", 1, "--pad", bad))
        leaking = self.path("cube.off", CUBE.replace("8 6 0", "8 5 0").replace("4 3 0 4 7\n", ""))
        self.assertIn("hole", self.refused("--depth", 1, "--object", leaking))

    def test_a_press_that_fails_tells_how_far_it_got(self):
        result = run("--depth", 9, "--error", 1000, "--points", 6, "--json")
        self.assertEqual(result.returncode, 1)
        self.assertIn("the press ended early", result.stderr)
        answer = json.loads(result.stdout)
        self.assertNotEqual(answer["status"], "solved")
        self.assertIn(f"{answer['depth_mm']:.4g} mm", result.stderr)

    def test_interrupt_keeps_what_there_is(self):
        command = [PROGRAM, "pad", "press", "--depth", "1.5", "--error", "3", "--points", "400", "--json"]
        code, out, told = stopped(command, signal.SIGINT, lambda code, out: code == 130 and out, cwd=ROOT)
        self.assertEqual(code, 130, told)
        answer = json.loads(out)
        self.assertEqual(answer["status"], "stopped")
        self.assertLess(len(answer["instants"]), 400)


class Fits(Files):
    def fit(self, *words, presses=PRESSES):
        return run(self.path("presses.toml", presses), *words, command="fit")

    def test_pad_that_is_written_presses_as_it_was_fitted(self):
        pad, page = self.path("mine.toml"), self.path("fit.html")
        result = self.fit("--json", "-o", pad, "--report", page)
        self.assertEqual(result.returncode, 0, result.stderr)
        answer = json.loads(result.stdout)
        self.assertEqual(answer["search"], "converged")
        self.assertEqual([each["constant"] for each in answer["constants"]],
                         ["pulp: shear modulus", "pulp: exponent"])
        self.assertIn("thenar-report", pathlib.Path(page).read_text())
        # On the cells of the fit: no error makes them refine.
        depth = answer["data"][1]["predicted"]
        force = ask("--pad", pad, "--depth", depth, "--friction", 0, "--error", 1e6, "--points", 4)["force_N"]
        self.assertAlmostEqual(force, 2, delta=1e-4)
        checked = subprocess.run([PROGRAM, "validate", pad], capture_output=True, text=True, check=False)
        self.assertEqual(checked.returncode, 0, checked.stderr)
        again = subprocess.run([PROGRAM, "rerun", page, "--print"], capture_output=True, text=True, check=False)
        self.assertIn("inputs: 2, unchanged", again.stdout)

    def test_index_fitted_is_what_is_found_in_what_is_published(self):
        result = run("index_published", "--no-mesh-check", "--json", command="fit")
        text = (ROOT / "data/pads/index_fitted.toml").read_text()
        for each, key in zip(json.loads(result.stdout)["constants"], ["shear_modulus_kPa", "exponent"]):
            # The file has three digits.
            self.assertEqual(f"{each['value']:.3g}", re.search(rf"^{key} = (\S+)", text, re.M)[1])
            self.assertFalse(each["determined"])
            self.assertIn(f'"{key}"', re.search(r"^assumed = \[\"law\".*", text, re.M)[0])

    def test_one_datum_determines_no_constant_of_three(self):
        presses = PRESSES.replace("prior_factor = 1.3", '[[constant]]\nconstant = "bone_height"')
        for old, new in [("[0.5, 2]", "[2]"), ("[2, 3]", "[3]"), ("[0.2, 0.3]", "[0.3]")]:
            presses = presses.replace(old, new)
        result = self.fit("--json", presses=presses)
        self.assertEqual(result.returncode, 0, result.stderr)
        answer = json.loads(result.stdout)
        self.assertEqual([each["sd_factor"] for each in answer["constants"]], [None] * 3)
        self.assertEqual(answer["degrees_of_freedom"], -2)
        self.assertIsNone(answer["correlations"])
        self.assertEqual(result.stderr.count("is not determined by the data"), 3)

    def test_data_that_contradict_each_other_are_told(self):
        again = PRESSES.split("[[press.data]]")[1].replace("[2, 3]", "[3.5, 1]")
        result = self.fit(presses=PRESSES + "[[press.data]]" + again)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertRegex(result.stderr, r"the pad misses the data: \S+ times what their sds allow")

    def test_table_has_a_row_a_constant(self):
        rows = list(csv.DictReader(io.StringIO(self.fit("--csv", "--no-mesh-check").stdout)))
        self.assertEqual([row["unit"] for row in rows], ["kPa", "-"])
        self.assertGreater(float(rows[0]["sd_factor_by_data"]), float(rows[0]["sd_factor"]))

    def test_what_is_refused_is_told_with_its_line_and_writes_nothing(self):
        pad = pathlib.Path(self.path("mine.toml"))
        lines = PRESSES.splitlines()
        for old, new, told in [("[0.2, 0.3]", "[0.2, 0]", "wanted 'sd_indentation_mm'"),
                               ("indentation_mm = [2, 3]", "indentation_mm = [2]", "indentation_mm"),
                               ('constant = "exponent"', 'constant = "exponent"\nlayer = 1',
                                "has 0 layers of skin, wanted layer 1"),
                               ("[0.5, 2]", "[0.5, 1e6]", "press 'flat' cannot be done")]:
            # Of a constant or a press, the line is that of its table.
            line = next(i for i, text in enumerate(lines, 1) if old in text)
            at = {"has": line - 1, "press": lines.index("[[press]]") + 1}.get(told.split()[0], line)
            result = self.fit("-o", pad, presses=PRESSES.replace(old, new))
            self.assertEqual(result.returncode, 1, result.stdout)
            self.assertEqual(result.stdout, "")
            self.assertIn(f"presses.toml:{at}: ", result.stderr)
            self.assertIn(told, result.stderr)
            self.assertFalse(pad.exists())

    def test_a_pad_is_no_file_of_presses(self):
        self.assertIn("it is a pad: thenar pad press", run("index_pad", command="fit").stderr)
        self.assertIn("is a pad, wanted presses of a pad", run("data/pads/index_pad.toml", command="fit").stderr)

    def test_interrupt_writes_no_pad(self):
        pad = pathlib.Path(self.path("mine.toml"))
        fine = PRESSES.replace("across = 2", "across = 28").replace("around = 1", "around = 20")
        out = interrupted(self, "fit", self.path("presses.toml", fine), "--json", "-o", pad)
        self.assertEqual(json.loads(out)["search"], "stopped")
        self.assertEqual([each.name for each in pad.parent.iterdir()], ["presses.toml"])


class Laws(Files):
    QUICK = ["--error", "30", "--max-elements", "200"]

    def pad(self, text=COARSE):
        return self.path("coarse.toml", text)

    def test_laws_that_are_written_are_those_of_the_pad(self):
        pad, page = self.pad(), self.path("laws.html")
        laws = pathlib.Path(pad).parent / "laws" / "coarse.toml"
        laws.parent.mkdir()
        result = run("--pad", pad, *self.QUICK, "--json", "-o", laws, "--report", page, command="laws")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("is assumed, not measured, in one number", result.stderr)
        answer = json.loads(result.stdout)
        self.assertEqual((answer["status"], answer["fitted"], answer["checked"]), ("solved", 20, 12))
        self.assertEqual(answer["depths_mm"], [0.5, 1, 1.5, 2])
        for law in answer["errors"].values():
            for error in law.values():
                self.assertLessEqual(error["rms"], error["worst"])
        self.assertIn(f'pad_digest = "{answer["pad_digest"]}"', laws.read_text())
        self.assertIn("thenar-report", pathlib.Path(page).read_text())
        checked = subprocess.run([PROGRAM, "validate", laws], capture_output=True, text=True, check=False)
        self.assertEqual(checked.returncode, 0, checked.stderr)
        again = subprocess.run([PROGRAM, "rerun", page, "--print"], capture_output=True, text=True, check=False)
        self.assertIn("inputs: 1, unchanged", again.stdout)
        # A press finds them by the pad's name, and doubts them once the pad has changed.
        chart = ["--depth", 0.8, "--error", 400, "--max-elements", 1, "--points", 1, "--chart", "--json", "--pad"]
        for text, doubts in [(COARSE, 0), (COARSE.replace("kPa = 12", "kPa = 13"), 1)]:
            pressed = run(*chart, self.pad(text))
            self.assertEqual(pressed.returncode, 0, pressed.stderr)
            self.assertEqual(pressed.stderr.count("fitted to another version of pad 'coarse'"), doubts)
            finger = next(each for each in json.loads(pressed.stdout)["rungs"] if each["element"] == "soft finger")
            self.assertGreater(finger["force_N"], 0)

    def test_table_has_two_rows_a_law(self):
        result = run("--pad", self.pad(), *self.QUICK, "--csv", command="laws")
        rows = list(csv.DictReader(io.StringIO(result.stdout)))
        self.assertEqual([row["error"] for row in rows], ["rms", "worst"] * 4)
        self.assertGreater(float(rows[0]["force_%"]), float(rows[2]["force_%"]))  # a plane is no ball

    def test_what_is_refused_or_not_solved_writes_nothing(self):
        laws = pathlib.Path(self.path("laws.toml"))
        # 0.1 mm of tissue over the bone: a single node of such cells touches.
        thin = self.pad(COARSE.replace("height_mm = 10", "height_mm = 4.6", 1))
        result = run("--pad", thin, "--error", 99, "--max-elements", 1, "--json", "-o", laws, command="laws")
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn("too few nodes touch", result.stderr)
        self.assertRegex(result.stderr, "laws were not found .*was not written")
        self.assertEqual(json.loads(result.stdout)["status"], "stalled")
        self.assertFalse(laws.exists())
        for words, told in [(["--error", "0"], "wanted an error of the elements' force above 0 and below 100 %, got 0 %"),
                            (["--error", "100"], "below 100 %, got 100 %"),
                            (["--pad", "indexpad"], "did you mean 'index_pad'?")]:
            result = run(*words, "-o", laws, command="laws")
            self.assertEqual((result.returncode, result.stdout), (1, ""))
            self.assertIn(told, result.stderr)
            self.assertFalse(laws.exists())

    def test_interrupt_writes_no_laws(self):
        laws = pathlib.Path(self.path("laws.toml"))
        out = interrupted(self, "laws", "--error", 1, "-o", laws)
        self.assertIn("stopped", out)
        self.assertNotIn("wrote", out)
        self.assertEqual(list(laws.parent.iterdir()), [])

    def test_laws_do_not_overwrite_their_pad(self):
        pad = self.pad()
        result = run("--pad", pad, *self.QUICK, "-o", pad, command="laws")
        self.assertEqual((result.returncode, result.stdout), (1, ""))
        self.assertIn("wanted another file to write", result.stderr)
        self.assertEqual(pathlib.Path(pad).read_text(), COARSE)


if __name__ == "__main__":
    if len(sys.argv) > 1:
        PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main()

"""End-to-end tests of `thenar compare`: what it keeps, when it goes on, and when it refuses to.

Usage: compare_command_test.py [path of the program]; else the environment's THENAR.
"""
import hashlib
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

from patience import HANG

PROGRAM = os.environ.get("THENAR", "thenar")
DATA = pathlib.Path(__file__).resolve().parents[2] / "data"

# A tetrahedron of 60 mm edges on the axes, and one with a corner farther out.
MESH = "v 0 0 0\nv {x} 0 0\nv 0 60 0\nv 0 0 60\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
OBJECT = """name = "wedge"
description = "A corner of a box"
source = "Own"
material = "wood"
mass_g = 100
[sources]
Own = "Made up for this test"
[[shape]]
kind = "mesh"
file = "wedge.obj"
scale = 0.001
"""


# Two jaws 100 mm apart inside, of 70 mm, that a motor slides together.
GRIPPER = """<robot name="grip">
  <link name="palm"><collision><origin xyz="0 0 -0.02"/>
    <geometry><box size="0.16 0.05 0.04"/></geometry></collision></link>
  <link name="left"><collision><origin xyz="-0.006 0 0.035"/>
    <geometry><box size="0.012 0.03 0.07"/></geometry></collision></link>
  <link name="right"><collision><origin xyz="0.006 0 0.035"/>
    <geometry><box size="0.012 0.03 0.07"/></geometry></collision></link>
  <joint name="slide" type="prismatic"><parent link="palm"/><child link="left"/>
    <origin xyz="-0.05 0 0"/><axis xyz="1 0 0"/>
    <limit lower="0" upper="0.05" effort="60" velocity="0.1"/></joint>
  <joint name="mirrored" type="prismatic"><parent link="palm"/><child link="right"/>
    <origin xyz="0.05 0 0"/><axis xyz="-1 0 0"/><mimic joint="slide"/>
    <limit lower="0" upper="0.05" effort="60" velocity="0.1"/></joint>
</robot>
"""


class Compare(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        for part in ("robots", "objects"):
            shutil.copytree(DATA / part, self.folder / part)
        self.out = self.folder / "out.json"

    def words(self, *more, hands="parallel_jaw", objects="sphere_70"):
        return [PROGRAM, "compare", "--hands", hands, "--objects", objects, "--approaches", "3",
                "--data", str(self.folder), "-o", str(self.out), *more]

    def run_it(self, *more, **choice):
        return subprocess.run(self.words(*more, **choice), capture_output=True, text=True,
                              check=False, timeout=HANG)

    def keep(self, *more, **choice):
        result = self.run_it(*more, **choice)
        self.assertEqual(result.returncode, 0, result.stderr)
        return json.loads(self.out.read_text())

    def answer(self):
        """What the file holds, without which runs computed it."""
        kept = json.loads(self.out.read_text())
        self.assertIn("command", kept.pop("provenance"))
        del kept["sha256"]
        return kept

    def refusal(self, *more, **choice):
        result = self.run_it(*more, **choice)
        self.assertEqual(result.returncode, 1, result.stdout)
        return result.stderr

    def test_keys_have_units_and_nothing_is_not_a_number(self):
        kept = self.keep()
        [cell] = kept["cells"]
        self.assertEqual(cell["approaches"], 3)
        self.assertEqual(len(cell["epsilon"]), cell["closures"])
        for digit in kept["abilities"][0]["digits"]:
            self.assertIn("closing_force_N", digit)
            self.assertEqual(digit["dimension"], 1)
            self.assertIn("workspace_m", digit)
        self.assertNotIn("NaN", self.out.read_text())

    # Places of ten that a thumb reaches are no share of tips: 10 of jaws once stood beside 8 of a hand.
    def test_opposition_of_jaws_and_thumbs_is_on_two_scales(self):
        jaws, human = self.keep(hands="parallel_jaw,human:orthogonal")["abilities"]
        self.assertEqual((jaws["kapandji_of_10"], jaws["tips_met_share"]), (None, 1))
        self.assertIsNone(human["tips_met_share"])
        self.assertTrue(0 < human["kapandji_of_10"] <= 10, human["kapandji_of_10"])
        self.out.unlink()
        table = self.run_it(hands="parallel_jaw,human:orthogonal").stdout.split("Hands by themselves")[1]
        header, *rows = [line.split() for line in table.splitlines()[1:4]]
        for row in rows:
            places, share = (row[header.index(key)] for key in ("kapandji_of_10", "tips_met_percent"))
            self.assertEqual((places == "-", share == "-"),
                             (row[0] == "parallel_jaw", row[0] != "parallel_jaw"))

    def test_threads_change_nothing(self):
        self.keep("--threads", "1")
        first = self.answer()
        self.out.unlink()
        self.keep("--threads", "2")
        self.assertEqual(self.answer(), first)

    def test_goes_on_where_it_was_stopped_to_the_same_answer(self):
        choice = {"hands": "parallel_jaw,barrett,allegro", "objects": "sphere_70,mug,jar_lid"}
        self.keep(**choice)
        whole = self.answer()
        self.out.unlink()
        with subprocess.Popen(self.words(**choice), stdout=subprocess.DEVNULL,
                              stderr=subprocess.PIPE, text=True) as work:
            while not self.out.exists() and work.poll() is None:
                time.sleep(0.002)
            work.send_signal(signal.SIGINT)
            answer = work.stderr.readline()
            words = work.communicate(timeout=HANG)[1]
        self.assertIn(f"stopping: finished pairs are kept in '{self.out}'", answer)
        self.assertEqual(work.returncode, 128 + signal.SIGINT, words)
        kept = json.loads(self.out.read_text())
        self.assertFalse(kept["complete"])
        self.assertTrue(1 <= len(kept["cells"]) < 9, len(kept["cells"]))
        self.assertIn(f"{len(kept['cells'])} of 9 pairs are kept", words)
        both = self.keep(**choice)["provenance"]
        self.assertEqual(both.pop("earlier_runs"), [kept["provenance"]])
        self.assertEqual(set(both), set(kept["provenance"]))
        self.assertEqual(self.answer(), whole)

    def test_stopped_again_it_loses_nothing(self):
        choice = {"hands": "parallel_jaw,barrett,allegro", "objects": "sphere_70,jar_lid"}
        self.keep(**choice)
        whole = self.answer()
        with subprocess.Popen(self.words(**choice), stdout=subprocess.DEVNULL,
                              stderr=subprocess.PIPE, text=True) as work:
            begun = self.out.stat().st_mtime_ns
            while self.out.stat().st_mtime_ns == begun and work.poll() is None:
                time.sleep(0.002)
            work.send_signal(signal.SIGINT)
            words = work.communicate(timeout=HANG)[1]
        self.assertEqual(work.returncode, 128 + signal.SIGINT, words)
        self.assertEqual(len(json.loads(self.out.read_text())["cells"]), 6)
        self.keep(**choice)
        self.assertEqual(self.answer(), whole)

    def test_a_run_that_computes_nothing_leaves_the_file_alone(self):
        provenance = self.keep()["provenance"]
        self.assertEqual(provenance["folder"], os.getcwd())
        self.assertTrue(provenance["command"].startswith("thenar compare --hands parallel_jaw"))
        before = self.out.read_bytes()
        self.keep("--threads", "2")
        self.assertEqual(self.out.read_bytes(), before)

    # The same rows in a table, for spreadsheets; unknown cells are dashes.
    def test_writes_a_table_and_a_page(self):
        table, page = self.folder / "hands.csv", self.folder / "hands.html"
        cells = self.keep("-o", str(table), "--report", str(page))["cells"]
        header, row = table.read_text().splitlines()
        self.assertEqual(header.split(",")[:3], ["hand", "object", "closed_percent"])
        self.assertEqual(row.split(",")[:2], [cells[0]["hand"], cells[0]["object"]])
        self.assertIn('"command":"thenar compare', page.read_text())

    def test_does_not_go_on_with_another_question(self):
        self.keep()
        self.assertIn("another 'seed'", self.refusal("--seed", "2"))
        self.assertIn("another 'best'", self.refusal("--best", "1"))
        self.assertIn("another 'tasks'", self.refusal("--tasks", "pull"))

    def test_does_not_go_on_with_another_robot(self):
        self.keep()
        robot = self.folder / "robots" / "parallel_jaw.toml"
        robot.write_text(robot.read_text().replace("max_effort_N = 160", "max_effort_N = 161"))
        self.assertIn(f"another '{robot}' (SHA-256 ", self.refusal())

    def test_goes_on_where_only_a_comment_changed(self):
        self.keep()
        robot = self.folder / "robots" / "parallel_jaw.toml"
        robot.write_text(robot.read_text() + "# a comment changes nothing\n")
        self.keep()

    def test_goes_on_with_a_file_that_has_the_old_names_of_human_hands(self):
        kept = self.keep(hands="human:tier1")
        self.assertEqual(kept["inputs"]["hands"], ["human:orthogonal"])
        self.assertEqual([cell["hand"] for cell in kept["cells"]], ["human:orthogonal"])
        old = json.loads(self.out.read_text().replace("human:orthogonal", "human:tier1"))
        self.write_sealed(old)
        again = self.keep(hands="human:orthogonal")
        self.assertEqual(again["cells"], kept["cells"])

    def test_does_not_go_on_with_another_mesh(self):
        (self.folder / "objects" / "wedge.toml").write_text(OBJECT)
        mesh = self.folder / "objects" / "wedge.obj"
        mesh.write_text(MESH.format(x=60))
        self.keep(objects="wedge")
        mesh.write_text(MESH.format(x=61))
        now = hashlib.sha256(mesh.read_bytes()).hexdigest()[:8]
        self.assertIn(f"another '{mesh}' (SHA-256 ", self.refusal(objects="wedge"))
        self.assertIn(f" then, {now} now)", self.refusal(objects="wedge"))

    def write_sealed(self, kept):
        """Writes a comparison with the checksum that belongs to it."""
        del kept["sha256"]
        words = json.dumps(kept, sort_keys=True, separators=(",", ":"), ensure_ascii=False)
        kept["sha256"] = hashlib.sha256(words.encode()).hexdigest()
        self.out.write_text(json.dumps(kept))

    def sealed(self, change):
        """What it says of a file whose first cell was changed, and its checksum with it."""
        kept = json.loads(self.out.read_text())
        change(kept["cells"][0])
        before = self.out.read_bytes()
        self.write_sealed(kept)
        words = self.refusal()
        self.out.write_bytes(before)
        return words

    def test_refuses_numbers_that_no_comparison_holds(self):
        self.keep()
        for key, value in (("scale", 1e308), ("scale", None), ("approaches", 10**12),
                           ("closures", 4), ("success", -0.5), ("epsilon", [1e308])):
            words = self.sealed(lambda cell: cell.update({key: value}))
            self.assertIn("a cell of the comparison is broken", words, key)
            self.assertIn(f"'{key}': wanted", words, key)
        for key, value in (("friction", -0.1), ("friction", None), ("normal", [1, 1, 1]),
                           ("surface", 0.5)):
            def change(cell):
                cell["best"][0]["contacts"][0][key] = value
            self.assertIn(f"'{key}': wanted", self.sealed(change), key)

        def far(cell):
            cell["best"][0]["contacts"][0]["surface"] = 99
        self.assertIn("is on surface 99, and it has", self.sealed(far))

    def test_refuses_a_comparison_without_its_checksum(self):
        self.keep()
        text = self.out.read_text()
        self.out.write_text(text.replace('"sha256"', '"sha257"'))
        self.assertIn("its checksum (SHA-256) is missing", self.refusal())

    def test_suggests_the_nearest_name(self):
        self.assertIn("did you mean 'barrett'", self.refusal(hands="barret"))
        self.assertIn("did you mean 'sphere_70'", self.refusal(objects="spere_70"))

    def test_says_which_numbers_it_wants(self):
        words = self.refusal("--best", "-1")
        self.assertEqual(words, "thenar: best: wanted a whole number from 0 to 1000000000, got -1 (--best)\n")

    def test_says_how_a_mesh_becomes_an_object(self):
        mesh = self.folder / "wedge.obj"
        mesh.write_text(MESH.format(x=60))
        self.assertIn(f"'{mesh}' is not an object file (TOML): `thenar import`, given its mass and material, and the unit "
                      "of its numbers, makes one", self.refusal(objects=str(mesh)))
        self.assertIn("is a mesh and no hand", self.refusal(hands=str(mesh)))

    def test_takes_robots_by_their_files_and_refuses_files_of_other_kinds(self):
        self.keep(hands=str(self.folder / "robots" / "parallel_jaw.toml"))
        self.assertIn("is an object, wanted a robot or a subject", self.refusal(hands=str(self.folder / "objects/box.toml")))
        self.assertIn("is a robot, wanted an object", self.refusal(objects=str(self.folder / "robots/dlr.toml")))

    def test_compares_a_gripper_of_a_urdf_file(self):
        robot = self.folder / "grip.urdf"
        robot.write_text(GRIPPER)
        kept = self.keep(hands=str(robot))
        self.assertGreater(kept["cells"][0]["closures"], 0)
        # One motor of 60 N moves both jaws as far: by its power 30 N are left for each.
        for digit in kept["abilities"][0]["digits"]:
            self.assertAlmostEqual(digit["closing_force_N"], 30, delta=1e-6)
        self.assertTrue(any("2 guessed" in words for words in kept["warnings"]), kept["warnings"])

    # Jaws of rubber and a palm of metal on a cube of a material of one's own: the contacts have the
    # friction that the file states.
    def test_own_friction_by_a_file(self):
        pla = self.folder / "objects" / "pla.toml"
        cube = (self.folder / "objects" / "cube_50.toml").read_text()
        pla.write_text(re.sub(r'material = "\w+"', 'material = "pla"', cube, count=1))
        self.assertIn("pla.toml:", self.refusal(objects="pla"))
        self.assertIn("no material 'pla'", self.refusal(objects="pla"))
        table = self.folder / "mats.toml"
        table.write_text('[[material]]\nname = "pla"\n')
        self.assertIn("no friction between 'metal' and 'pla': give it in a materials file",
                      self.refusal("--materials", str(table), objects="pla"))
        table.write_text('source = "Mine"\n[[material]]\nname = "pla"\n[[friction]]\nbetween = ["pla", "rubber"]\n'
                         'static = 0.55\nkinetic = 0.5\n'
                         '[[friction]]\nbetween = ["pla", "metal"]\nstatic = 0.2\nkinetic = 0.2\n'
                         '[sources]\nMine = "Measured here"\n')
        kept = self.keep("--materials", str(table), objects="pla")
        frictions = {contact["friction"] for cell in kept["cells"] for best in cell["best"]
                     for contact in best["contacts"]}
        self.assertIn(0.55, frictions)
        self.assertIn(str(table), kept["provenance"])

    def test_says_where_the_mass_of_a_mesh_is_stated(self):
        mesh, made = self.folder / "wedge.obj", self.folder / "wedge.toml"
        mesh.write_text(MESH.format(x=60))
        subprocess.run([PROGRAM, "import", str(mesh), "--units", "mm", "--out", str(made)],
                       check=True, capture_output=True, timeout=HANG)
        self.assertIn("state mass_g or density_kg_m3", self.refusal(objects=str(made)))
        made.write_text("mass_g = 100\n" + made.read_text())
        self.keep(objects=str(made))

    def test_tells_how_approaches_ended_where_nothing_closed(self):
        (self.folder / "objects" / "wedge.toml").write_text(OBJECT.replace("0.001", "0.01"))
        (self.folder / "objects" / "wedge.obj").write_text(MESH.format(x=60))
        told = self.run_it(objects="wedge").stdout  # of 0.6 m: no jaw goes round it
        self.assertRegex(told, r"parallel_jaw +wedge +[123] (touched|closed|missed|began)")

    def test_refuses_a_hand_without_surfaces_before_any_work(self):
        words = self.refusal(hands="parallel_jaw,graspit_human_20dof")
        self.assertIn("hand 'graspit_human_20dof'", words)
        self.assertIn("no surface", words)
        self.assertFalse(self.out.exists())


if __name__ == "__main__":
    if len(sys.argv) > 1:
        PROGRAM = sys.argv.pop(1)
    unittest.main()

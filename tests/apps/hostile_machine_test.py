"""End-to-end tests of commands on a machine that is full, slow or asked to stop.

Usage: hostile_machine_test.py [path of the program]; else the environment's THENAR.
"""
import json
import math
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import sys
import time
import unittest

from files import Files
from patience import HANG, stopped

PROGRAM = os.environ.get("THENAR", "thenar")
DATA = pathlib.Path(__file__).resolve().parents[2] / "data"
INDEX, MIDDLE = (str(DATA / f"subjects/an_chao_{name}.toml") for name in ("index", "middle"))
SYNEK = str(DATA / "subjects/synek2019_middle.toml")
H01 = str(DATA / "experiments/synek2019_H01.toml")
PINCH = str(DATA / "contacts/two_soft_fingers.json")

# Two parameters, so that a fit takes a fraction of a second.
SETTINGS = """source = 'Synek2019'
[[parameter]]
match = 'hood/EDC/*'
state = 'free'
sd = 0.3
between_sd = 0.27
"""

# A box before the palm of the jaws, too far for them.
WORLD = """name = "far"
description = "A box held by jaws along x"
source = "Scene"
[sources]
Scene = "Arranged for this test"
[[hand]]
name = "jaws"
file = "{robots}/parallel_jaw.toml"
position_m = [0, -0.06, 0]
[[body]]
role = "object"
name = "box"
material = "wood"
mass_kg = 0.01
[[body.shape]]
kind = "box"
size_mm = [20, 20, 20]
"""

ROBOT = """<robot name="two"><link name="base"><collision><geometry><mesh filename="a.obj"/></geometry>
</collision></link><link name="tip"><collision><geometry><mesh filename="b.obj"/></geometry>
</collision></link><joint name="j" type="revolute"><parent link="base"/><child link="tip"/>
<axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint></robot>
"""


def leaky_cone(sides):
    """A cone on a regular polygon, one face of its mantle missing, as OBJ."""
    lines = ["v 0 0 1", "v 0 0 0"]
    lines += [f"v {math.cos(a)} {math.sin(a)} 0"
              for a in (2 * math.pi * k / sides for k in range(sides))]
    for k in range(sides):
        this, following = k + 3, (k + 1) % sides + 3
        lines += [f"f 2 {following} {this}"] + ([f"f 1 {this} {following}"] if k > 0 else [])
    return "\n".join(lines) + "\n"


def run(*words, **how):
    return subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True, check=False,
                          timeout=HANG, **how)


class Machine(Files):
    def few(self):
        return self.path("few.toml", SETTINGS)

    def fit(self, output):
        return ["fit", H01, "--subject", MIDDLE, "--settings", self.few(), "-o", output]


class FullDevice(Machine):
    """What cannot be written is an error, wherever it should have gone."""

    def fails(self, *words):
        with open("/dev/full", "w") as full:
            result = subprocess.run([PROGRAM, *map(str, words)], stdout=full, check=False,
                                    stderr=subprocess.PIPE, text=True, timeout=HANG)
        self.assertEqual(result.returncode, 1, (words, result.stderr))
        self.assertRegex(result.stderr, r"cannot write|cannot be written|No space left", words)

    def test_answers(self):
        for words in (["quality", PINCH], ["quality", PINCH, "--json"], ["validate", INDEX],
                      ["pose", INDEX, "--digit", "index"], ["pose", INDEX, "--json"],
                      ["tip-force", INDEX, "--tension", "FDP=5", "--posture", "PIP2=30"],
                      ["simulate", INDEX, "--excitation", "FDP=0.1", "--seconds", "0.01"],
                      ["explain", INDEX, "--digit", "index"]):
            self.fails(*words)

    def test_answers_of_tendons(self):
        pull = ["--digit", "middle", "--tension", "EDC=1"]
        for words in (["tendon", "solve", MIDDLE, *pull],
                      ["tendon", "sweep", MIDDLE, *pull, "--vary", "PIP3=0:10:10"],
                      ["tendon", "infer", H01, "--subject", SYNEK, "--net", "chao_an"]):
            self.fails(*words)

    def test_fits_and_predictions(self):
        output = self.path("fit.h5")
        self.fails(*self.fit(output))
        self.assertTrue(pathlib.Path(output).exists())  # what was found is kept
        self.fails("predict", output, H01)

    def test_comparisons(self):
        self.fails("compare", "--hands", "parallel_jaw", "--objects", "sphere_70", "--approaches",
                   "1", "-o", self.path("kept.json"))


class Pipes(Machine):
    """A FIFO that nobody writes to is refused at once, not waited for."""

    def test_no_reader_waits(self):
        pipe = self.path("pipe")
        os.mkfifo(pipe)
        for words in (["validate", pipe], ["pose", pipe], ["quality", pipe], ["predict", pipe, H01],
                      ["posterior", "summary", pipe], ["import", pipe], ["grasp", pipe],
                      ["fit", pipe, "--subject", MIDDLE, "-o", self.path("fit.h5")]):
            result = run(*words)  # which would run out of its time
            self.assertEqual(result.returncode, 1, words)
            # `validate` tells of every file on stdout, good or bad.
            self.assertRegex(result.stdout + result.stderr, "wanted a|neither a file", words)


class Comparisons(Machine):
    def words(self, hands="parallel_jaw"):
        return ["compare", "--hands", hands, "--objects", "sphere_70,jar_lid", "--approaches", "1",
                "--data", str(DATA), "-o", self.path("kept.json")]

    def cells(self):
        return len(json.loads(pathlib.Path(self.path("kept.json")).read_text())["cells"])

    def test_two_at_once_keep_all_pairs(self):
        both = [subprocess.Popen([PROGRAM, *self.words()], stdout=subprocess.DEVNULL,
                                 stderr=subprocess.PIPE, text=True) for _ in range(2)]
        said = [one.communicate(timeout=HANG)[1] for one in both]
        codes = sorted(one.returncode for one in both)
        # The second finds the first at work, or comes when it has ended.
        self.assertIn(codes, ([0, 0], [0, 1]), said)
        if codes == [0, 1]:
            self.assertTrue(any("another" in words for words in said), said)
        self.assertEqual(self.cells(), 2)

    def test_a_damaged_one_is_told_and_left_alone(self):
        self.assertEqual(run(*self.words()).returncode, 0)
        kept = pathlib.Path(self.path("kept.json"))
        whole = kept.read_text()
        content = json.loads(whole)
        changed = {"cells": {**content, "cells": 3}, "keyless": {"inputs": content["inputs"]},
                   "cell": {**content, "cells": [[]]}, "list": [1, 2]}
        for name, damaged in (("cut", whole[:len(whole) // 2]), ("empty", ""),
                              *((name, json.dumps(of)) for name, of in changed.items())):
            kept.write_text(damaged)
            result = run(*self.words())
            self.assertEqual(result.returncode, 1, (name, result.stderr))
            self.assertIn("kept.json", result.stderr, name)
            self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
            self.assertEqual(kept.read_text(), damaged, name)


class FullDisk(Machine):
    """A limit on the size of files stands for a disk that fills up."""

    def limited(self, *words, size):
        def limit():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))

        return run(*words, preexec_fn=limit)

    def test_a_robot_is_imported_with_its_meshes_or_not_at_all(self):
        self.path("in/a.obj", leaky_cone(5))
        self.path("in/b.obj", leaky_cone(200))
        robot = self.path("in/two.urdf", ROBOT)
        out = pathlib.Path(self.path("out"))
        words = ("import", robot, "--repair", "--out", out / "two.urdf")
        self.assertEqual(run(*words).returncode, 0)
        sizes = sorted(path.stat().st_size for path in out.rglob("*") if path.is_file())
        self.assertEqual(len(sizes), 3)
        shutil.rmtree(out)
        for size in (0, sizes[0], (sizes[1] + sizes[2]) // 2, sizes[2] - 1):
            result = self.limited(*words, size=size)
            self.assertEqual(result.returncode, 1, (size, result.stdout))
            self.assertIn("cannot", result.stderr)
            left = [path for path in out.rglob("*") if path.is_file()] if out.exists() else []
            self.assertEqual(left, [], size)

    def test_a_fit_leaves_the_older_one(self):
        output = pathlib.Path(self.path("fit.h5"))
        self.assertEqual(run(*self.fit(output)).returncode, 0)
        before = output.read_bytes()
        result = self.limited(*self.fit(output), size=4096)
        self.assertEqual(result.returncode, 1, result.stdout)
        self.assertEqual(output.read_bytes(), before)
        self.assertEqual(sorted(path.name for path in output.parent.iterdir()),
                         ["few.toml", "fit.h5"])


class Links(Machine):
    def test_outputs_are_written_through_links(self):
        real = pathlib.Path(self.path("real"))
        real.mkdir()
        for name, words in (("fit.h5", self.fit), ("page.html", lambda out: [
                "tendon", "solve", MIDDLE, "--digit", "middle", "--tension", "EDC=1", "-o", out]),
                            ("kept.json", lambda out: [
                                "compare", "--hands", "parallel_jaw", "--objects", "sphere_70",
                                "--approaches", "1", "-o", out])):
            link = pathlib.Path(self.path(name))
            link.symlink_to(real / name)
            result = run(*words(link))
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertTrue(link.is_symlink(), name)
            self.assertGreater((real / name).stat().st_size, 100, name)


class Signals(Machine):
    def test_pyramids_of_many_edges_are_left_at_once(self):
        world = self.path("world.toml", WORLD.format(robots=DATA / "robots"))
        # Polytopes of so many edges take minutes.
        command = [PROGRAM, "grasp", world, "--no-approach", "--edges", "100"]
        for number in (signal.SIGINT, signal.SIGTERM):
            code, _, words = stopped(command, number, lambda code, _: code == 128 + number)
            self.assertEqual(code, 128 + number, words)


if __name__ == "__main__":
    if len(sys.argv) > 1 and not sys.argv[1].startswith("-"):
        PROGRAM = sys.argv.pop(1)
    unittest.main()

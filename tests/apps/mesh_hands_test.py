"""thenar on robots and objects of many triangles: whether it reads them, what it keeps, what it weighs.

Usage: python3 mesh_hands_test.py THENAR
"""
import json
import os
import signal
import subprocess
import sys
import unittest

import mesh_hands
from files import Files
from patience import HANG, stopped

THENAR = sys.argv.pop(1)


def run(*arguments, **environment):
    return subprocess.run([THENAR, *arguments], capture_output=True, text=True, timeout=HANG,
                          env={**os.environ, **environment})


class MeshHands(Files):
    def test_imports_a_hand_of_meshes(self):
        """17 links of 7,938 triangles; how long it takes is a row of bench/program_ratios.py."""
        hand = mesh_hands.hand(self.folder.name)
        done = run("import", hand, "--out", self.path("hand.toml"))
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_ends_at_once_while_it_reads_a_hand(self):
        """Nothing is kept by then: it ends by the signal, and leaves no reader of meshes behind."""
        mesh_hands.gripper(self.folder.name, 120, 120)
        world = self.path("world.toml", 'name = "w"\nsource = "Own"\n[sources]\nOwn = "Made up"\n[[hand]]\n'
                          'name = "hand"\nfile = "mesh_gripper.urdf"\n[[body]]\nrole = "object"\nname = "ball"\n'
                          'mass_g = 9\n[[body.shape]]\nkind = "sphere"\nsize_mm = [30]\n')
        for number in [signal.SIGINT, signal.SIGTERM]:
            code, _, _ = stopped([THENAR, "grasp", world], number, pause=0.25)
            self.assertEqual(code, -number)

    def test_weighs_two_overlapping_boxes_as_their_union(self):
        """An L of 32 cm^3 from boxes of 16 and 24: its centre is at 25, 0, 15 mm."""
        text, first = "", 1
        for low, high in [((0, -10, -10), (40, 10, 10)), ((20, -10, -10), (40, 10, 50))]:
            for i in range(8):
                text += "v {} {} {}\n".format(*[(high if i >> k & 1 else low)[k] * 1e-3 for k in range(3)])
            for face in [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]:
                text += "f " + " ".join(str(first + corner) for corner in face) + "\n"
            first += 8
        done = run("import", self.path("boxes.obj", text), "--json")
        told = json.loads(done.stdout)
        self.assertEqual(told["parts"], 2)
        self.assertAlmostEqual(told["volume_m3"], 3.2e-5, 15)
        for found, wanted in zip(told["centre_of_mass_m"], [0.025, 0, 0.015]):
            self.assertAlmostEqual(found, wanted, 12)
        self.assertIn("parts overlap", told["warnings"][0])
        self.assertIn("25 % more", told["warnings"][0])


if __name__ == "__main__":
    unittest.main()

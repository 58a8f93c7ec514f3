"""End-to-end tests of `thenar import`; expected numbers are worked out by hand.

Usage: import_test.py [path of the program]; else the environment's THENAR.
"""
import json
import math
import os
import pathlib
import re
import subprocess
import sys
import unittest

from files import Files
from patience import HANG

PROGRAM = os.environ.get("THENAR", "thenar")

ARM = """<robot name="arm">
  <link name="base"/>
  <link name="upper"><inertial><mass value="2"/><inertia ixx="1" iyy="1" izz="1"/></inertial>
    <collision><geometry><box size="0.1 0.1 0.3"/></geometry></collision></link>
  <link name="lower"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1"/></inertial></link>
  <joint name="shoulder" type="revolute"><origin xyz="0 0 0.5"/><parent link="base"/>
    <child link="upper"/><axis xyz="0 1 0"/>
    <limit lower="-1" upper="1" effort="9" velocity="2"/></joint>
  <joint name="elbow" type="revolute"><origin xyz="0 0 0.3"/><parent link="upper"/>
    <child link="lower"/><axis xyz="0 1 0"/><limit lower="-1" upper="1" effort="9" velocity="2"/>
    <mimic joint="shoulder" multiplier="0.5"/></joint>
</robot>
"""

# Two jaws that a pin holds together, each with a motor.
PLIERS = """<mujoco model="pliers"><worldbody><body name="palm"><geom type="box" size=".03 .03 .03"/>
  <body name="a"><joint name="1" axis="0 1 0" range="-60 60"/>
    <geom type="box" size="0.01 0.01 0.03"/></body>
  <body name="b" pos="0.05 0 0"><joint name="2" axis="0 1 0" range="-60 60"/>
    <geom type="box" size="0.01 0.01 0.03"/></body></body></worldbody>
  <equality><connect body1="a" body2="b" anchor="0.02 0 0.03"/></equality>
  <actuator><motor joint="1"/><motor joint="2"/></actuator></mujoco>
"""

# The corner of a unit cube cut off; without its slanted face it has a hole of three edges, whose
# middle is the mean of the middles of those edges.
CORNER = "OFF\n4 {} 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n{}"


class Import(Files):
    def thenar(self, *arguments, code=0):
        done = subprocess.run([PROGRAM, "import", *arguments], capture_output=True, text=True,
                              timeout=HANG)
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def report(self, *arguments):
        return json.loads(self.thenar(*arguments, "--json").stdout)

    def test_tells_what_a_urdf_holds(self):
        told = self.report(self.path("arm.urdf", ARM))
        self.assertEqual(told["name"], "arm")
        self.assertEqual(told["kind"], "URDF")
        self.assertEqual(told["counts"], {"links": 3, "links_added": 0, "joints": 2,
                                          "joints_moving": 2, "dofs": 1})
        self.assertEqual(told["total_mass_kg"], 3)
        self.assertEqual(told["leaf_link_positions_at_zero_m"], {"lower": [0, 0, 0.8]})
        self.assertEqual(told["dofs"][0]["joints"], ["shoulder", "elbow"])
        self.assertEqual(told["warnings"], [])

    # 0.1 + 0.2 is 0.30000000000000004.
    def test_text_shows_no_rounding(self):
        arm = self.path("arm.urdf", ARM.replace('"2"', '"0.1"').replace('value="1"', 'value="0.2"'))
        self.assertIn("total_mass_kg: 0.3\n", self.thenar(arm).stdout)

    def test_tells_and_writes_latin1_in_utf8(self):
        arm = self.path("arm.urdf")
        pathlib.Path(arm).write_bytes(ARM.replace('"lower"', '"ärm"').encode("latin-1"))
        self.thenar(arm, "--out", self.path("arm.toml"))
        for file in [arm, self.path("arm.toml")]:
            self.assertEqual(self.report(file)["leaf_link_positions_at_zero_m"], {"ärm": [0, 0, 0.8]})

    def test_tells_of_files_whose_names_are_no_utf8(self):
        odd = os.fsencode(self.path("arm")) + b"\xe9.urdf"
        pathlib.Path(os.fsdecode(odd)).write_text(ARM)
        self.assertEqual(self.report(odd)["name"], "arm")

    def test_converts_there_and_back(self):
        arm = self.path("arm.urdf", ARM)
        self.thenar(arm, "--out", self.path("sub/arm.toml"))
        told = self.report(self.path("sub/arm.toml"))
        self.assertEqual(told["kind"], "thenar TOML")
        self.thenar(self.path("sub/arm.toml"), "--out", self.path("again.urdf"))
        again = self.report(self.path("again.urdf"))
        for key in ["counts", "total_mass_kg", "leaf_link_positions_at_zero_m", "dofs", "joints"]:
            self.assertEqual(told[key], self.report(arm)[key])
            self.assertEqual(again[key], self.report(arm)[key])

    def test_finds_meshes_again_from_another_folder(self):
        self.path("meshes/corner.off", CORNER.format(4, "3 1 2 3\n"))
        arm = self.path("arm.urdf", ARM.replace(
            '<box size="0.1 0.1 0.3"/>', '<mesh filename="meshes/corner.off" scale="0.1 0.1 0.1"/>'))
        for name in ["a/b/arm.toml", "c/arm.urdf"]:
            self.thenar(arm, "--out", self.path(name))
            told = self.report(self.path(name))
            self.assertEqual(told["warnings"], [])
            self.assertEqual(told["links"][1]["shapes"], 1)

    def test_mends_leaky_meshes_so_that_the_robot_is_of_use(self):
        self.path("open.OFF", CORNER.format(3, ""))
        arm = self.path("arm.urdf", ARM.replace(
            '<box size="0.1 0.1 0.3"/>', '<mesh filename="open.OFF" scale="0.1 0.1 0.1"/>'))
        told = self.thenar(arm, "--out", self.path("arm.toml"))
        self.assertIn("MENDED mesh 'open.OFF' of link 'upper': 1 hole(s) closed", told.stdout)
        subprocess.run([PROGRAM, "validate", self.path("arm.toml")], check=True, timeout=HANG,
                       stdout=subprocess.DEVNULL)
        again = self.report(self.path("arm.toml"))
        self.assertEqual(again["links"][1]["shapes"], 1)
        self.assertEqual(len(again["warnings"]), 1)  # the file keeps it; the mesh needs no more
        self.thenar(arm, "--strict", code=1)

    def test_fails_when_strict_and_something_is_lost(self):
        arm = self.path("arm.urdf", ARM.replace('<box size="0.1 0.1 0.3"/>',
                                                '<mesh filename="lost.stl"/>'))
        self.assertIn("lost.stl", self.thenar(arm).stdout)
        done = self.thenar(arm, "--strict", "--out", self.path("arm.toml"), code=1)
        self.assertIn("1 warning", done.stderr)
        self.assertFalse(os.path.exists(self.path("arm.toml")))

    def test_fails_when_strict_and_the_output_cannot_say_all(self):
        arm = self.path("arm.toml", 'name = "r"\nsource = "x"\n[sources]\nx = "y"\n[[link]]\n'
                        'name = "a"\n[[link]]\nname = "b"\n[[dof]]\nname = "j"\nkind = "compliant"\n'
                        'range_deg = [-90, 90]\n[[joint]]\nname = "j"\nkind = "revolute"\n'
                        'parent = "a"\nchild = "b"\ndof = "j"\nrange_deg = [-30, 30]\n')
        done = self.thenar(arm, "--strict", "--out", self.path("arm.urdf"), code=1)
        self.assertIn("no compliant couplings: 'j'", done.stderr)
        self.assertIn("1 warning", done.stderr)
        self.assertFalse(os.path.exists(self.path("arm.urdf")))
        self.assertIn("no compliant", self.thenar(arm, "--out", self.path("arm.urdf")).stderr)
        self.assertIn('lower="-0.52', pathlib.Path(self.path("arm.urdf")).read_text())
        self.thenar(arm, "--strict", "--out", self.path("again.toml"))

    def test_reads_mjcf_and_graspit(self):
        told = self.report(self.path("m.xml", "<mujoco model='m'><worldbody><body name='a' "
                                     "pos='0 0 1'><joint range='0 90'/><joint axis='1 0 0' "
                                     "range='0 90'/><geom size='0.1' mass='3'/></body></worldbody>"
                                     "</mujoco>"))
        self.assertEqual(told["kind"], "MJCF")
        self.assertEqual(told["counts"], {"links": 1, "links_added": 2, "joints": 2,
                                          "joints_moving": 2, "dofs": 2})
        self.assertEqual(told["leaf_link_positions_at_zero_m"], {"a": [0, 0, 1]})
        told = self.report(self.path("g.xml", "<robot type='G'><palm>none.xml</palm><dof type='r'/>"
                                     "<chain><joint type='Revolute'><theta>d0</theta><d>10</d>"
                                     "<a>20</a><alpha>0</alpha><minValue>0</minValue>"
                                     "<maxValue>90</maxValue></joint><link>none.xml</link></chain>"
                                     "</robot>"))
        self.assertEqual(told["kind"], "GraspIt! XML")
        self.assertEqual(told["leaf_link_positions_at_zero_m"], {"chain1 none": [0.02, 0, 0.01]})

    def test_names_robots_without_a_name_by_their_file(self):
        hand = ("<robot type='{}'><palm>lost.xml</palm><dof type='r'><Kp>1</Kp></dof></robot>")
        self.assertEqual(self.report(self.path("claw.urdf", "<robot><link name='l'/></robot>"))["name"],
                         "claw")
        told = self.report(self.path("pincer.xml", hand.format("Hand")))
        self.assertEqual(told["name"], "pincer")
        self.assertIn("MISSING BODY", told["warnings"][0])
        self.assertIn("<Kp>", told["warnings"][-1])
        self.assertEqual(self.report(self.path("b.xml", hand.format("Barrett")))["name"], "Barrett")

    def test_writes_no_robot_without_its_meshes_unless_told_to(self):
        robot = self.path("m.urdf", "<robot name='m'><link name='l'><collision><geometry>"
                                    "<mesh filename='package://m/meshes/tipp.stl'/></geometry>"
                                    "</collision></link></robot>")
        self.path("meshes/tip.stl", "")
        out = self.path("m.toml")
        refused = self.thenar(robot, "--out", out, code=1)
        self.assertIn("did you mean 'tip.stl'?", refused.stdout)
        self.assertIn("names a file that is missing", refused.stderr)
        self.assertIn("--allow-missing", refused.stderr)
        self.assertFalse(os.path.exists(out))
        self.thenar(robot, "--out", out, "--allow-missing")
        # The warning stays with the file, and is counted once.
        told = subprocess.run([PROGRAM, "validate", out], capture_output=True, text=True,
                              check=True).stdout
        self.assertEqual(told.count("MISSING MESH"), 1)

    def test_warnings_of_a_robot_in_millimetres_are_counted_once(self):
        robot = self.path("mm.urdf", "<robot name='mm'><link name='l'><collision><geometry>"
                                     "<box size='50 40 30'/></geometry></collision></link></robot>")
        out = self.path("mm.toml")
        once = self.report(robot, "--out", out)["warnings"]
        self.assertEqual(self.report(out)["warnings"], once)
        self.assertEqual(json.loads(subprocess.run([PROGRAM, "validate", out, "--json"],
                                                   capture_output=True, text=True, check=True)
                                    .stdout)[0]["warnings"], once)

    def test_materials_of_links_are_checked(self):
        robot = self.path("arm.toml")
        self.thenar(self.path("arm.urdf", ARM), "--out", robot)
        text = pathlib.Path(robot).read_text().replace('name = "upper"\n',
                                                       'name = "upper"\nmaterial = "plastc"\n')
        pathlib.Path(robot).write_text(text)
        line = text.split("\n").index('material = "plastc"') + 1
        told = subprocess.run([PROGRAM, "validate", robot], capture_output=True, text=True,
                              check=True).stdout
        self.assertIn(f"{robot}:{line}: no material 'plastc', did you mean 'plastic'?", told)
        table = self.path("m.toml", 'source = "Mine"\n[[material]]\nname = "plastc"\ndensity_kg_m3 = 1200\n'
                                   '[sources]\nMine = "Weighed here"\n')
        told = subprocess.run([PROGRAM, "validate", robot, "--materials", table],
                              capture_output=True, text=True, check=True).stdout
        self.assertNotIn("no material", told)
        # A mesh of that material has its density: 1/6 m3 of 1200 kg/m3.
        mesh = self.path("corner.off", CORNER.format(4, "3 1 2 3\n"))
        told = self.report(mesh, "--material", "plastc", "--materials", table)
        self.assertAlmostEqual(told["mass_kg"], 200, 9)

    def test_weighs_closed_meshes_and_names_holes(self):
        told = self.report(self.path("corner.off", CORNER.format(4, "3 1 2 3\n")))
        self.assertTrue(told["watertight"])
        self.assertEqual((told["vertices"], told["triangles"]), (4, 4))
        self.assertAlmostEqual(told["volume_m3"], 1 / 6, 12)
        for value in told["centre_of_mass_m"]:
            self.assertAlmostEqual(value, 0.25, 12)
        # Second moments 1/60 each, products 1/120, less those of the centre.
        self.assertAlmostEqual(told["inertia_m5"][0][0], 2 * (1 / 60 - 1 / 96), 12)
        self.assertAlmostEqual(told["inertia_m5"][0][1], 1 / 96 - 1 / 120, 12)
        told = self.report(self.path("open.off", CORNER.format(3, "")))
        self.assertFalse(told["watertight"])
        self.assertEqual(told["holes"][0]["edges"], 3)
        for value in told["holes"][0]["centre_m"]:
            self.assertAlmostEqual(value, 1 / 3, 12)
        self.assertIn("open in 1 place", told["warnings"][0])
        for nothing in ["volume_m3", "centre_of_mass_m", "inertia_m5"]:
            self.assertIsNone(told[nothing])

    def test_counts_triangles_that_face_the_wrong_way_and_turns_them(self):
        # The corner with its slanted face turned: three edges; all turned: inside out.
        turned = self.path("turned.off", CORNER.format(4, "3 3 2 1\n"))
        told = self.report(turned)
        self.assertEqual((told["reversed_edges"], told["volume_m3"]), (3, None))
        self.assertIn("repairing turns them", told["warnings"][0])
        body = self.path("body.toml", 'name = "b"\nsource = "x"\nmaterial = "wood"\n[sources]\n'
                         'x = "y"\n[[shape]]\nkind = "mesh"\nfile = "turned.off"\n')
        words = "mesh 'turned.off' of {} 'b': 3 edges lie between triangles"
        self.assertIn(words.format("body"), self.report(body)["warnings"][0])
        checked = subprocess.run([PROGRAM, "validate", body], capture_output=True, text=True,
                                 timeout=HANG, check=True)
        self.assertIn(words.format("object"), checked.stdout)
        told = self.report(turned, "--repair")
        self.assertEqual((told["reversed_edges"], told["watertight"]), (0, True))
        self.assertAlmostEqual(told["volume_m3"], 1 / 6, 12)
        told = self.report(self.path("inside.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
                                     "3 0 1 2\n3 0 3 1\n3 0 2 3\n3 1 3 2\n"))
        self.assertIsNone(told["volume_m3"])
        self.assertIn("inside out", told["warnings"][0])
        self.assertAlmostEqual(self.report(self.path("inside.off"), "--repair")["volume_m3"], 1 / 6, 12)

    def test_refuses_leaky_objects_unless_it_may_mend_them(self):
        self.path("open.off", CORNER.format(3, ""))
        body = self.path("body.xml", "<root><material>wood</material><mass>0.001</mass>"
                                     "<geometryFile type='off'>open.off</geometryFile></root>")
        done = self.thenar(body, "--out", self.path("body.toml"), code=1)
        for words in ["body.xml:1: mesh 'open.off' of body 'body'", "1 hole(s): 3 edges", "repairing mends it (--repair)"]:
            self.assertIn(words, done.stderr)
        told = self.report(body, "--repair", "--out", self.path("body.toml"))
        self.assertIn("1 hole(s) closed", told["warnings"][0])
        self.assertEqual(self.report(self.path("body.toml"))["warnings"], [])
        world = ("<world><{0}><filename>body.xml</filename></{0}></world>")
        self.thenar(self.path("object.xml", world.format("graspableBody")), code=1)
        told = self.report(self.path("still.xml", world.format("obstacle")))
        self.assertIn("MENDED mesh 'open.off' of obstacle 'body'", told["warnings"][0])

    def test_doubts_the_units_of_huge_meshes(self):
        huge = self.path("huge.off", CORNER.format(4, "3 1 2 3\n").replace("1 0 0\n", "80 0 0\n", 1))
        self.assertEqual(self.report(huge)["warnings"],
                         ["80 m across: are its numbers millimetres?"])
        self.assertEqual(self.report(huge, "--units", "mm")["warnings"], [])
        # It is not written as if the unit had been stated, unless it was.
        out = self.path("huge.toml")
        self.assertIn("--units mm", self.thenar(huge, "--out", out, code=1).stderr)
        self.assertFalse(os.path.exists(out))
        for stated in (("--units", "m"), ("--scale", "1"), ("--units", "mm")):
            self.thenar(huge, "--out", out, *stated)
        arm = ARM.replace('<box size="0.1 0.1 0.3"/>', '<mesh filename="huge.off"{}/>')
        told = self.report(self.path("arm.urdf", arm.format("")))
        self.assertIn("a mesh of link 'upper' is 80 m across", told["warnings"][0])
        self.assertEqual(self.report(self.path("arm.urdf", arm.format(' scale="0.001 0.001 0.001"')))
                         ["warnings"], [])

    def test_doubts_the_units_of_huge_links(self):
        told = self.report(self.path("arm.urdf", ARM.replace("0.1 0.1 0.3", "120 40 40")))
        self.assertIn("a box of link 'upper' has a size of 120 m: are its numbers millimetres",
                      told["warnings"][0])
        told = self.report(self.path("arm.urdf", ARM.replace("0 0 0.3", "0 0 300")))
        self.assertIn("joint 'elbow' lies 300 m", told["warnings"][0])

    def test_writes_no_robot_that_it_could_not_read(self):
        for old, new, what in (
                ('xyz="0 0 0.5"', 'xyz="0 0 150"',
                 "wanted the position of joint 'shoulder' of at most 100 m in size, got 150"),
                ('effort="9"', 'effort="1e308"',
                 "wanted the effort of degree of freedom 'shoulder' of at most 1e+09 Nm in size"),
                ('<mass value="2"/>', '<mass value="1e5"/>',
                 "wanted the mass of link 'upper' of at most 10000 kg in size, got 100000"),
                ('size="0.1 0.1 0.3"', 'size="1e308 1 1"',
                 "wanted the size of a shape of link 'upper' of at most 100 m in size")):
            arm = self.path("arm.urdf", ARM.replace(old, new))
            refused = self.thenar(arm, "--out", self.path("arm.toml"), code=1)
            self.assertIn(what, refused.stderr)
            self.assertFalse(os.path.exists(self.path("arm.toml")))

    def test_says_that_it_does_not_guess_how_what_comes_apart_grasps(self):
        pliers = self.path("pliers.xml", PLIERS)
        told = self.thenar(pliers, "--out", self.path("pliers.toml"))
        self.assertIn("pliers.toml: how it grasps is not guessed: robot 'pliers' cannot grasp",
                      told.stderr)
        self.assertIn("it is driven by several motors: 1, 2", told.stderr)

    def test_weighs_objects_by_their_density(self):
        told = self.report(self.path("cube.toml", 'name = "c"\nsource = "x"\ndensity_kg_m3 = 600\n'
                                     '[sources]\nx = "y"\n[[shape]]\nkind = "box"\n'
                                     'size_mm = [50, 50, 50]\n'))
        self.assertAlmostEqual(told["mass_kg"], 600 * 0.05**3, 12)

    def test_leaves_no_motor_to_a_slide_without_limits(self):
        told = self.report(self.path("arm.urdf", ARM.replace('type="revolute"', 'type="prismatic"', 1)
                                     .replace('<limit lower="-1" upper="1" effort="9" velocity="2"/>',
                                              "", 1)))
        self.assertIn("prismatic joint 'shoulder' has no <limit>: it stays at zero",
                      " ".join(told["warnings"]))
        self.assertEqual((told["counts"]["dofs"], told["counts"]["joints_moving"]), (0, 1))

    def test_says_whether_an_effort_is_nominal(self):
        joint = ("<joint type='Revolute'><theta>d0</theta><d>10</d><a>20</a><alpha>0</alpha>"
                 "<minValue>0</minValue><maxValue>90</maxValue></joint>")
        told = self.report(self.path("g.xml", "<robot type='G'><palm>none.xml</palm><dof type='r'>"
                                     "<maxEffort>5e9</maxEffort></dof><chain>" + joint +
                                     "<link>none.xml</link></chain></robot>"))
        self.assertEqual(told["dofs"][0]["effort_is"], "nominal")
        self.assertEqual(self.report(self.path("arm.urdf", ARM))["dofs"][0]["effort_is"], "published")

    def test_makes_objects_of_meshes(self):
        corner = self.path("corner.off", CORNER.format(4, "3 1 2 3\n"))
        self.thenar(corner, "--units", "cm", "--out", self.path("sub/corner.toml"))
        told = self.report(self.path("sub/corner.toml"))
        self.assertEqual((told["name"], told["kind"]), ("corner", "object"))
        self.assertEqual(told["shapes"][0]["triangles"], 4)
        self.assertIn("wanted units or a scale, got both (--scale)",
                      self.thenar(corner, "--units", "cm", "--scale", "2", code=1).stderr)
        self.assertIn("repairing mends it (--repair)",
                      self.thenar(self.path("open.off", CORNER.format(3, "")), "--out", self.path("open.toml"),
                                  code=1).stderr)

    def test_validate_names_a_leaky_link(self):
        self.path("open.off", CORNER.format(3, ""))
        robot = self.path("robot.toml", 'name = "r"\nsource = "x"\n[sources]\nx = "y"\n[[link]]\n'
                          'name = "palm"\n[[link.shape]]\nkind = "mesh"\nfile = "open.off"\n')
        done = subprocess.run([PROGRAM, "validate", robot], capture_output=True, text=True, timeout=HANG)
        self.assertEqual(done.returncode, 1)
        self.assertIn("mesh 'open.off' of link 'palm': a mesh bounds no solid: 1 hole(s)", done.stdout)

    def test_validate_says_which_kinds_it_reads(self):
        done = subprocess.run([PROGRAM, "validate", self.path("c.json", "{}")], capture_output=True,
                              text=True, timeout=HANG)
        self.assertEqual(done.returncode, 1)
        self.assertIn("c.json:1: wanted TOML or HDF5", done.stdout)

    def test_closes_holes_and_scales(self):
        told = self.report(self.path("open.off", CORNER.format(3, "")), "--repair", "--scale", "0.1",
                           "--out", self.path("closed.stl"))
        self.assertTrue(told["watertight"])
        self.assertEqual(told["holes_closed"], 1)
        self.assertIn("1 hole(s) closed", told["repaired"])
        self.assertAlmostEqual(told["volume_m3"], 1e-3 / 6, 12)
        again = self.report(self.path("closed.stl"))
        self.assertTrue(again["watertight"])
        self.assertAlmostEqual(again["volume_m3"], 1e-3 / 6, 9)  # single precision

    def solids(self, name, text, *arguments):
        """The report of a scene, skipped where there is no reader for it."""
        done = subprocess.run([PROGRAM, "import", self.path(name, text), *arguments, "--json"],
                              capture_output=True, text=True, timeout=HANG)
        if "libcoin-dev" in done.stderr:
            self.skipTest("built without Coin")
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def test_knows_the_solids_of_vrml_and_inventor(self):
        ball = 4 / 3 * math.pi * 0.035**3
        for name, text, kind, volume in [
                ("a.iv", "#Inventor V2.1 ascii\nSphere { radius 35 }", "sphere", ball),
                ("a.wrl", "#VRML V1.0 ascii\nCylinder { radius 35 height 100 }", "cylinder",
                 math.pi * 0.035**2 * 0.1),
                ("b.wrl", "#VRML V2.0 utf8\nShape { geometry Box { size 10 20 30 } }", "box", 6e-6)]:
            told = self.solids(name, text, "--units", "mm", "--out", self.path("a.toml"))
            self.assertEqual([shape["kind"] for shape in told["exact_shapes"]], [kind])
            self.assertAlmostEqual(told["volume_m3"] / volume, 1, 12)
            self.assertEqual(told["warnings"], [])
            again = self.report(self.path("a.toml"))
            self.assertEqual(again["shapes"][0]["size_m"], told["exact_shapes"][0]["size_m"])
        # Two balls that touch nothing, about the middle between them.
        two = self.solids("c.iv", "#Inventor V2.1 ascii\nSphere { radius 0.035 }\n"
                          "Translation { translation 0.1 0 0 }\nSphere { radius 0.035 }")
        self.assertAlmostEqual(two["volume_m3"] / (2 * ball), 1, 12)
        self.assertAlmostEqual(two["centre_of_mass_m"][0], 0.05, 12)
        # Half across one axis: triangles, inscribed in an ellipsoid.
        mesh = self.solids("d.iv", "#Inventor V2.1 ascii\nScale { scaleFactor 0.5 1 1 }\n"
                           "Sphere { radius 0.035 }")
        self.assertNotIn("exact_shapes", mesh)
        self.assertLess(mesh["volume_m3"], ball / 2)

    def test_makes_bodies_and_links_of_solids(self):
        self.solids("ball.iv", "#Inventor V2.1 ascii\nTranslation { translation 10 0 0 }\n"
                    "Sphere { radius 35 }")
        body = self.report(self.path("body.xml", "<root><geometryFile>ball.iv</geometryFile></root>"))
        self.assertEqual(body["shapes"][0]["kind"], "sphere")
        self.assertAlmostEqual(body["shapes"][0]["size_m"][0], 0.035, 15)
        arm = self.path("arm.urdf", ARM.replace(
            '<geometry><box size="0.1 0.1 0.3"/>', '<origin xyz="0 0 1" rpy="0 0 1.5707963267948966"/>'
            '<geometry><mesh filename="ball.iv" scale="0.001 0.001 0.001"/>'))
        self.thenar(arm, "--out", self.path("arm.toml"))
        with open(self.path("arm.toml"), encoding="utf-8") as file:
            text = file.read()
        self.assertIn('kind = "sphere"', text)
        self.assertIn("size_m = [0.035]", text)
        # 10 mm along its own x, which the link's origin turns to y.
        place = [float(x) for x in re.search(r"position_m = \[(.*)\]\nrotation", text)[1].split(",")]
        for value, wanted in zip(place, [0, 0.01, 1]):
            self.assertAlmostEqual(value, wanted, 12)

    def test_refuses_what_it_cannot_read(self):
        for name, text, words in [("a.xml", "<sdf/>", ["a.xml:1:"]),
                                  ("b.cfg", "Barrett\n", [".cfg"]),
                                  ("w.wld", "!World\n", [".wld"]),
                                  ("e.xml", "<EigenGrasps/>", ["e.xml:1:", "got <EigenGrasps>"]),
                                  ("c.urdf", "<robot>\n<xacro:x/></robot>", ["c.urdf:2:", "xacro"]),
                                  ("d.off", "OFF\n0 0 0\n", ["d.off"]),
                                  ("f.step", "ISO-10303-21;\n", ["f.step:1:", "URDF", ".stl"])]:
            done = self.thenar(self.path(name, text), code=1)
            for word in words:
                self.assertIn(word, done.stderr)


if __name__ == "__main__":
    if len(sys.argv) > 1:
        PROGRAM = sys.argv.pop(1)
    unittest.main()

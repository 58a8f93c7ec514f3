"""Hands of formats that say nothing of digits, materials and approaches grasp, end to end.

Usage: imported_hands_test.py [path of the program]; else the environment's THENAR.
"""
import json
import os
import pathlib
import re
import subprocess
import sys
import unittest

from files import Files
from patience import HANG

PROGRAM = os.environ.get("THENAR", "thenar")

# Two jaws that are closed at 0 and open upwards, on a wrist that turns them together.
JAWS_URDF = """<robot name="jaws">
  <link name="mount"/>
  <link name="palm"><collision><origin xyz="0 0 0.03"/><geometry><box size="0.16 0.05 0.06"/></geometry>
    </collision></link>
  <joint name="wrist" type="revolute"><parent link="mount"/><child link="palm"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="9" velocity="2"/></joint>
{}</robot>
"""
JAW = """  <link name="{0}"><collision><origin xyz="{1} 0 0.04"/><geometry><box size="0.01 0.03 0.08"/>
    </geometry></collision></link>
  <joint name="{0} slide" type="prismatic"><origin xyz="0 0 0.06"/><parent link="palm"/>
    <child link="{0}"/><axis xyz="{2} 0 0"/><limit lower="0" upper="0.05" effort="40" velocity="0.1"/>
    {3}</joint>
  <link name="{0} frame"/>
  <joint name="{0} end" type="fixed"><origin xyz="0 0 0.08"/><parent link="{0}"/>
    <child link="{0} frame"/></joint>
"""
JAWS_URDF = JAWS_URDF.format(JAW.format("left", 0.005, 1, "") +
                             JAW.format("right", -0.005, -1, '<mimic joint="left slide"/>'))

JAWS_MJCF = """<mujoco model="jaws"><worldbody><body name="palm">
  <geom type="box" size="0.08 0.025 0.03" pos="0 0 0.03"/>
  <body name="left" pos="0 0 0.06"><joint name="left slide" type="slide" axis="1 0 0" range="0 0.05"/>
    <geom type="box" size="0.005 0.015 0.04" pos="0.005 0 0.04"/></body>
  <body name="right" pos="0 0 0.06"><joint name="right slide" type="slide" axis="-1 0 0"
    range="0 0.05"/><geom type="box" size="0.005 0.015 0.04" pos="-0.005 0 0.04"/></body>
</body></worldbody>
<equality><joint joint1="right slide" joint2="left slide" polycoef="0 1 0 0 0"/></equality>
<actuator><position joint="left slide" forcerange="-40 40"/></actuator></mujoco>
"""

# Three fingers of two links round a palm of 100 mm; turned about -y' they curl inwards, and the
# first of them spreads about z.
FINGER_URDF = """  <link name="{0} root"><collision><geometry><sphere radius="0.008"/></geometry></collision></link>
  <link name="{0} near"><collision><origin xyz="0 0 0.025"/><geometry><box size="0.012 0.016 0.05"/>
    </geometry></collision></link>
  <link name="{0} far"><collision><origin xyz="0 0 0.02"/><geometry><box size="0.012 0.016 0.04"/>
    </geometry></collision></link>
  <joint name="{0} spread" type="revolute"><origin xyz="{1} {2} 0.03" rpy="0 0 {3}"/>
    <parent link="palm"/><child link="{0} root"/><axis xyz="0 0 1"/>
    <limit lower="-0.3" upper="0.3" effort="2" velocity="3"/></joint>
  <joint name="{0} curl" type="revolute"><parent link="{0} root"/><child link="{0} near"/>
    <axis xyz="0 1 0"/><limit lower="-1.4" upper="0.3" effort="2" velocity="3"/></joint>
  <joint name="{0} bend" type="revolute"><origin xyz="0 0 0.055"/><parent link="{0} near"/>
    <child link="{0} far"/><axis xyz="0 1 0"/>
    <limit lower="-1.2" upper="0" effort="1" velocity="2"/></joint>
"""
FINGER_MJCF = """  <body name="{0} root" pos="{1} {2} 0.03" euler="0 0 {3}">
    <joint name="{0} spread" axis="0 0 1" range="-0.3 0.3"/><geom size="0.008"/>
    <body name="{0} near"><joint name="{0} curl" axis="0 1 0" range="-1.4 0.3"/>
      <geom type="box" size="0.006 0.008 0.025" pos="0 0 0.025"/>
      <body name="{0} far" pos="0 0 0.055"><joint name="{0} bend" axis="0 1 0" range="-1.2 0"/>
        <geom type="box" size="0.006 0.008 0.02" pos="0 0 0.02"/></body></body></body>
"""
AROUND = [("thumb", 0.05, 0, 0), ("second", -0.025, 0.0433, 2.0944), ("third", -0.025, -0.0433, -2.0944)]
FINGERS_URDF = ('<robot name="fingers"><link name="palm"><collision><origin xyz="0 0 0.01"/><geometry>'
                '<cylinder radius="0.055" length="0.02"/></geometry></collision></link>\n' +
                "".join(FINGER_URDF.format(*finger) for finger in AROUND) + "</robot>\n")
FINGERS_MJCF = ('<mujoco model="fingers"><compiler angle="radian"/><worldbody><body name="palm">'
                '<geom type="cylinder" size="0.055 0.01" pos="0 0 0.01"/>\n' +
                "".join(FINGER_MJCF.format(*finger) for finger in AROUND) +
                "</body></worldbody></mujoco>\n")

HANDS = {"jaws.urdf": JAWS_URDF, "jaws.xml": JAWS_MJCF,
         "fingers.urdf": FINGERS_URDF, "fingers.xml": FINGERS_MJCF}

WORLD = """name = "w"
source = "Own"
[sources]
Own = "Made up for this test"
[[hand]]
name = "hand"
file = "{}"
position_mm = [0, 0, -{}]
[[body]]
role = "object"
name = "ball"
{}
mass_g = 100
[[body.shape]]
kind = "sphere"
size_mm = [40]
"""


class ImportedHands(Files):
    def thenar(self, *arguments):
        done = subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, timeout=HANG)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def world(self, name, text, material='material = "wood"'):
        self.path(name, text)
        return self.path(f"{name}.toml", WORLD.format(name, 150, material))

    def test_close_on_a_ball(self):
        for name, text in HANDS.items():
            with self.subTest(name):
                told = json.loads(self.thenar("grasp", self.world(name, text), "--json"))
                self.assertEqual(told["outcome"], "grasped", told["explanation"])
                self.assertTrue(told["force_closure"])
                digits = {contact["digit"] for contact in told["contacts"]} - {""}
                self.assertEqual(len(digits), 2 if "jaws" in name else 3)
                for contact in told["contacts"]:
                    self.assertEqual(contact["friction"], 0.4)  # plastic on wood
                warnings = " ".join(told["warnings"])
                for words in ["plastic is assumed for palm", "no digits are stated",
                              "along [0.000, 0.000, 1.000] from [0.0000, 0.0000, 0.0",
                              "no closing is stated"]:
                    self.assertIn(words, warnings)
                self.assertIn("slide downwards" if "jaws" in name else "curl downwards", warnings)
                self.assertNotIn("wrist upwards", warnings)
                self.assertNotIn("spread upwards", warnings)
                self.thenar("close", self.path(f"{name}.toml"))
                self.thenar("grasp", self.path(f"{name}.toml"), "--random", "3")

    def test_are_compared(self):
        names = []
        for name in HANDS:
            names.append(self.path(name, HANDS[name]))
        out = self.path("out.json")
        self.thenar("compare", "--hands", ",".join(names), "--objects", "cube_50", "--approaches", "12",
                    "-o", out)
        told = json.loads(pathlib.Path(out).read_text())
        self.assertIn("closures", json.dumps(told))
        for name in names:
            self.assertIn(name, json.dumps(told))

    def test_keep_what_they_know_as_toml(self):
        self.path("jaws.urdf", JAWS_URDF)
        self.thenar("import", self.path("jaws.urdf"), "--out", self.path("jaws.toml"))
        told = json.loads(self.thenar("grasp", self.world("jaws.toml",
                                                          pathlib.Path(self.path("jaws.toml"))
                                                          .read_text()), "--json"))
        self.assertEqual(told["outcome"], "grasped")

    def test_write_down_what_is_guessed_of_them(self):
        for name, text in HANDS.items():
            with self.subTest(name):
                self.thenar("import", self.path(name, text), "--out", self.path("hand.toml"))
                written = pathlib.Path(self.path("hand.toml")).read_text()
                self.assertIn('digit = "finger 1"  # guessed', written)
                self.assertIn('material = "plastic"  # guessed', written)
                self.assertRegex(written, r'speed = -[0-9.]+  # guessed')
                self.assertIn("[approach]  # guessed", written)
                told = [json.loads(self.thenar("grasp", self.world(file, text), "--json"))
                        for file, text in [(name, text), ("hand.toml", written)]]
                self.assertEqual(told[0]["contacts"], told[1]["contacts"])
                unstated = ("unknown effort", "no link has a mass")  # of these files
                self.assertEqual([w for w in told[1]["warnings"]
                                  if not any(u in w for u in unstated)], [])

    def test_name_a_digit_that_touches_nothing(self):
        far = FINGERS_URDF.replace('xyz="0.05 0 0.03"', 'xyz="0.4 0 0.03"')
        for text, idle in ((FINGERS_URDF, False), (far, True)):
            told = json.loads(self.thenar("grasp", self.world("fingers.urdf", text), "--json"))
            words = r"closed on a ball of 70 mm, .*thumb.* touch(es)? nothing"
            self.assertEqual(any(re.search(words, line) for line in told["warnings"]), idle, told)

    def test_may_be_given_digits_and_materials_by_hand(self):
        self.path("jaws.urdf", JAWS_URDF)
        self.thenar("import", self.path("jaws.urdf"), "--out", self.path("jaws.toml"))
        stated = pathlib.Path(self.path("jaws.toml")).read_text()
        stated = stated.replace("plastic", "rubber").replace('"finger 1"', '"upper jaw"')
        told = json.loads(self.thenar("grasp", self.world("jaws.toml", stated), "--json"))
        self.assertEqual(told["outcome"], "grasped")
        self.assertIn("upper jaw", {contact["digit"] for contact in told["contacts"]})

    def test_hold_a_body_without_material(self):
        told = json.loads(self.thenar("grasp", self.world("jaws.urdf", JAWS_URDF, ""), "--json"))
        self.assertEqual(told["contacts"][0]["friction"], 0.3)  # plastic on plastic
        self.assertIn("no material is stated of body 'ball': plastic is taken",
                      " ".join(told["warnings"]))

    def test_are_refused_while_their_loops_are_open(self):
        text = JAWS_MJCF.replace("<equality>", '<equality><connect body1="left" body2="right" '
                                 'anchor="0 0 0.08"/>')
        done = subprocess.run([PROGRAM, "grasp", self.world("loop.xml", text)], capture_output=True,
                              text=True, timeout=HANG)
        self.assertEqual(done.returncode, 1, done.stdout)
        self.assertIn("cannot grasp: its parts form loops that are not solved", done.stderr)
        self.assertIn("<connect> of 'left' and 'right'", done.stderr)
        self.thenar("import", self.path("loop.xml"), "--out", self.path("loop.toml"))
        self.assertIn("open_loops = [", pathlib.Path(self.path("loop.toml")).read_text())

    def test_name_a_description_that_is_not_read(self):
        done = subprocess.run([PROGRAM, "import", self.path("a.sdf", "<sdf version='1.6'><model/></sdf>")],
                              capture_output=True, text=True, timeout=HANG)
        self.assertEqual(done.returncode, 1)
        self.assertIn("a.sdf:1: SDF is not read", done.stderr)


class PosedRobots(Files):
    """Forward kinematics; numbers are worked out by hand."""

    def pose(self, *arguments, code=0):
        done = subprocess.run([PROGRAM, "pose", *arguments, "--json"], capture_output=True, text=True,
                              timeout=HANG)
        self.assertEqual(done.returncode, code, done.stderr)
        return json.loads(done.stdout) if code == 0 else done.stderr

    def link(self, told, name):
        return next(link for link in told["links"] if link["name"] == name)

    # The curl by 90 deg about y turns the finger from z to x: its far link's frame is 55 mm along x.
    def test_by_degrees_of_freedom(self):
        told = self.pose(self.path("fingers.urdf", FINGERS_URDF), "--posture", "thumb curl=90")
        for got, wanted in zip(self.link(told, "thumb far")["position_mm"], [105, 0, 30]):
            self.assertAlmostEqual(got, wanted, places=9)
        self.assertIn("outside", told["warnings"][0])
        self.assertEqual({tip["digit"] for tip in told["tips"]}, {"thumb", "finger 1", "finger 2"})

    def test_by_joints_that_follow_others(self):
        told = self.pose(self.path("jaws.urdf", JAWS_URDF), "--posture", "right slide=20")
        self.assertAlmostEqual(self.link(told, "left")["position_mm"][0], 20, places=9)
        self.assertAlmostEqual(self.link(told, "right")["position_mm"][0], -20, places=9)
        values = {joint["name"]: joint for joint in told["joints"]}
        self.assertAlmostEqual(values["left slide"]["value_mm"], 20, places=9)

    def test_of_the_library_by_name(self):
        told = self.pose("parallel_jaw")
        self.assertEqual(told["robot"], "parallel_jaw")

    def test_names_what_there_is_not(self):
        path = self.path("jaws.urdf", JAWS_URDF)
        self.assertIn("no degree of freedom or moving joint 'lefd slide'", self.pose(path, "--posture",
                                                                                  "lefd slide=2", code=1))
        self.assertIn("cannot be at", self.pose(path, "--posture", "left slide=2", "right slide=3",
                                                   code=1))


if __name__ == "__main__":
    if len(sys.argv) > 1:
        PROGRAM = sys.argv.pop(1)
    unittest.main()

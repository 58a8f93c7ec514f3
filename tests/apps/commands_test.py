"""End-to-end tests of the command `thenar`; expected numbers are computed here by hand.

Usage: commands_test.py [path of the program]; else the environment's THENAR. Run from anywhere.
"""
import csv
import hashlib
import json
import math
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import tomllib
import unittest

from patience import stopped

ROOT = pathlib.Path(__file__).resolve().parents[2]
SUBJECTS = ROOT / "data/subjects"
PROGRAM = os.environ.get("THENAR", "thenar")

MIDDLE = str(SUBJECTS / "an_chao_middle.toml")
INDEX = str(SUBJECTS / "an_chao_index.toml")
SYNEK = str(SUBJECTS / "synek2019_middle.toml")
INDEX_MAPS = str(SUBJECTS / "valero_cuevas_index.toml")
WHOLE = str(SUBJECTS / "mirakhorlo2016.toml")
HUMAN = str(SUBJECTS / "human_hand.toml")
SKEWED = str(SUBJECTS / "graspit_skewed_thumb.toml")
H01 = str(ROOT / "data/experiments/synek2019_H01.toml")

# Joint centres and tip of the straight middle finger along x [mm], from the head of its file.
MCP, PIP, DIP, TIP = 94.8694, 47.8457, 19.0171, 0.0


def run(*words):
    return subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True, check=False)


def ask(*words):
    """The JSON answer."""
    result = run(*words, "--json")
    assert result.returncode == 0, result.stderr
    return json.loads(result.stdout)


def complaint(*words):
    """The one line of an error, after checking that the program failed with code 1."""
    result = run(*words)
    assert result.returncode == 1, (result.returncode, result.stdout)
    assert result.stdout == "", result.stdout
    return result.stderr.removesuffix("\n")


class PlanarFinger:
    """The middle finger in its plane of flexion, angles in degrees from the wrist outwards."""

    def __init__(self, angles):
        bend = [math.radians(sum(angles[:k + 1])) for k in range(3)]
        self.joints = [(MCP, 0.0)]
        for length, turn in zip((MCP - PIP, PIP - DIP, DIP - TIP), bend):
            x, y = self.joints[-1]
            self.joints.append((x - length * math.cos(turn), y - length * math.sin(turn)))
        self.tip = self.joints.pop()
        self.bend = dict(zip(("PP3", "MP3", "DP3"), bend))
        self.centre = dict(zip(("PP3", "MP3", "DP3"), zip((MCP, PIP, DIP), self.joints)))

    def jacobian(self):
        """Rows: dx, dy of the tip by each flexion [mm/rad]."""
        x, y = self.tip
        return [[-(y - jy) for _, jy in self.joints], [x - jx for jx, _ in self.joints]]

    def place(self, segment, p):
        """Where a point of a segment is now; p in the straight finger [mm]."""
        if segment == "MC3":
            return p
        straight, (x, y) = self.centre[segment]
        c, s = math.cos(self.bend[segment]), math.sin(self.bend[segment])
        return (x + c * (p[0] - straight) - s * p[1], y + s * (p[0] - straight) + c * p[1], p[2])


def strand_points(name):
    """(segment, point of the straight finger [mm]) of a strand, read without thenar."""
    subject = tomllib.loads(pathlib.Path(MIDDLE).read_text())
    frames = {frame["name"]: frame for frame in subject["frame"]}
    unit = subject["reference_length_mm"]
    points = []
    for row in next(s for s in subject["strand"] if s["name"] == name)["path"]:
        frame = frames[row["frame"]]
        point = tuple(o + unit * r for o, r in zip(frame["origin_mm"], row["point_ratio"]))
        points.append((frame["segment"], point))
    return points


def path_length(points, angles):
    finger = PlanarFinger(angles)
    placed = [finger.place(*point) for point in points]
    return sum(math.dist(a, b) for a, b in zip(placed, placed[1:]))


def moment_arms(points, angles, step=1e-3):
    """-dL/dq of each flexion by central differences [mm/rad]."""
    arms = []
    for k in range(3):
        ends = []
        for sign in (1, -1):
            bent = list(angles)
            bent[k] += sign * step
            ends.append(path_length(points, bent))
        arms.append(-(ends[0] - ends[1]) / math.radians(2 * step))
    return arms


def least_squares(J, torque):
    """The (fx, fy) of least |J' f - torque|, by Cramer's rule on the normal equations."""
    dot = lambda a, b: sum(x * y for x, y in zip(a, b))
    xx, xy, yy = dot(J[0], J[0]), dot(J[0], J[1]), dot(J[1], J[1])
    bx, by = dot(J[0], torque), dot(J[1], torque)
    det = xx * yy - xy * xy
    return [(bx * yy - by * xy) / det, (xx * by - xy * bx) / det]


class Near(unittest.TestCase):
    def near(self, got, want, tolerance):
        self.assertEqual(len(got), len(want))
        for g, w in zip(got, want):
            self.assertAlmostEqual(g, w, delta=tolerance)


class Pose(Near):
    def test_straight_finger_lies_along_x(self):
        pose = ask("pose", MIDDLE)
        points = {joint["name"]: joint["point_mm"] for joint in pose["joints"]}
        for name, x in (("MCP3_FE", MCP), ("MCP3_AA", MCP), ("PIP3", PIP), ("DIP3", DIP)):
            self.near(points[name], [x, 0, 0], 1e-9)
        self.near(pose["tips"][0]["position_mm"], [TIP, 0, 0], 1e-9)

    def test_bent_finger_follows_planar_trigonometry(self):
        finger = PlanarFinger([40, 55, 35])
        tip = ask("pose", MIDDLE, "--posture", "MCP3_FE=40", "PIP3=55", "DIP3=35")["tips"][0]
        self.near(tip["position_mm"], [*finger.tip, 0], 1e-9)
        flexions = [tip["joints"].index(name) for name in ("MCP3_FE", "PIP3", "DIP3")]
        for got, want in zip(tip["jacobian_mm_per_rad"], finger.jacobian()):
            self.near([got[k] for k in flexions], want, 1e-9)

    def test_plain_angles_are_in_joint_order_and_may_be_negative(self):
        tip = ask("pose", MIDDLE, "--posture", -20, 0, 50, 45)["tips"][0]
        self.near(tip["position_mm"], [*PlanarFinger([-20, 50, 45]).tip, 0], 1e-9)

    def test_frozen_joint_poses_alike_and_leaves_the_jacobian(self):
        tip = ask("pose", MIDDLE, "--posture", "MCP3_FE=40", "PIP3=55",
                  "--frozen", "DIP3=35")["tips"][0]
        self.near(tip["position_mm"], [*PlanarFinger([40, 55, 35]).tip, 0], 1e-9)
        self.assertEqual(tip["joints"], ["MCP3_FE", "MCP3_AA", "PIP3"])

    def test_straight_finger_is_called_singular(self):
        tip = ask("pose", MIDDLE)["tips"][0]
        self.assertEqual(tip["rank"], 2)
        self.assertIsNone(tip["condition"])
        self.assertEqual(tip["mobility"], "singular: cannot move along (1, 0, 0), and carries any "
                                          "force there without tendons")

    def test_angle_beyond_its_limit_warns_but_answers(self):
        result = run("pose", MIDDLE, "--posture", "DIP3=95")
        self.assertEqual(result.returncode, 0)
        self.assertEqual(result.stderr, "thenar: warning: joint 'DIP3' at 95 deg is outside "
                                        "-8.4 .. 84.5 deg\n")

    def test_digits_can_be_chosen(self):
        pose = ask("pose", WHOLE, "--digit", "index", "thumb")
        self.assertEqual([tip["digit"] for tip in pose["tips"]], ["thumb", "index"])


class TipForce(Near):
    def test_pinned_force_balances_path_torques(self):
        angles = [40, 55, 35]
        torque = [7 * arm for arm in moment_arms(strand_points("FDP"), angles)]  # [N mm]
        J = PlanarFinger(angles).jacobian()
        force = least_squares(J, torque)
        answer = ask("tip-force", MIDDLE, "--posture", "MCP3_FE=40", "PIP3=55", "DIP3=35",
                     "--tension", "FDP=7")
        self.near(answer["force_N"][:2], force, 1e-6)
        left = [t - x * force[0] - y * force[1] for t, x, y in zip(torque, *J)]
        got = answer["leftover_torque_N_mm"]
        self.near([got[name] for name in ("MCP3_FE", "PIP3", "DIP3")], left, 1e-4)

    def test_tip_axes_turn_with_the_tip(self):
        # Bent by 90 degrees in all, proximal (x) looks along y and dorsal (y) along -x.
        answer = ask("tip-force", MIDDLE, "--posture", "MCP3_FE=40", "PIP3=50",
                     "--tension", "FDP=7")
        x, y, z = answer["force_N"]
        axes = answer["force_tip_axes_N"]
        self.near([axes["proximal"], axes["dorsal"], axes["radial"]], [y, -x, z], 1e-12)

    def test_rigid_hold_says_that_it_is_of_minimum_norm(self):
        answer = ask("tip-force", MIDDLE, "--posture", "PIP3=55", "--tension", "FDP=7",
                     "--hold", "rigid")
        self.assertTrue(answer["note"].startswith("minimum norm: 4 joints leave the wrench"))
        self.near(answer["leftover_torque_N_mm"].values(), [0] * 4, 1e-9)

    # Without abduction all axes are parallel: the same numbers, but regular in their plane.
    def test_finger_without_abduction_is_regular_in_its_plane(self):
        angles = [40, 55, 35]
        torque = [7 * arm for arm in moment_arms(strand_points("FDP"), angles)]  # [N mm]
        J = PlanarFinger(angles).jacobian()
        words = ("--posture", "MCP3_FE=40", "PIP3=55", "DIP3=35", "--frozen", "MCP3_AA=0")
        answer = ask("tip-force", MIDDLE, *words, "--tension", "FDP=7")
        self.near(answer["force_N"], [*least_squares(J, torque), 0], 1e-6)
        self.assertIn("across the plane of flexion", answer["note"])
        self.assertNotIn("singular", answer["note"])
        xx, xy, yy = (sum(a * b for a, b in zip(J[i], J[k])) for i, k in ((0, 0), (0, 1), (1, 1)))
        spread = math.hypot((xx - yy) / 2, xy)
        condition = math.sqrt(((xx + yy) / 2 + spread) / ((xx + yy) / 2 - spread))
        self.assertAlmostEqual(answer["condition"] / condition, 1, delta=1e-6)
        tip = ask("pose", MIDDLE, *words)["tips"][0]
        self.assertAlmostEqual(tip["condition"] / condition, 1, delta=1e-6)
        self.assertTrue(tip["mobility"].startswith("regular in the plane of flexion"))
        rigid = ask("tip-force", MIDDLE, *words, "--tension", "FDP=7", "--hold", "rigid")
        self.assertNotIn("minimum norm", rigid["note"])

    def test_nearly_straight_finger_says_what_a_degree_changes(self):
        def force(pip, posture=("DIP2=0.1", "--tension", "FDP=10")):
            return ask("tip-force", INDEX, "--posture", f"PIP2={pip}", *posture)
        answer = force(0.1)
        self.assertIn("nearly singular posture", answer["note"])
        self.assertIn("one degree of PIP2", answer["note"])
        step = 1e-4  # [deg]
        change = [(b - a) / (2 * step) for a, b in
                  zip(force(0.1 - step)["force_N"], force(0.1 + step)["force_N"])]
        told = answer["force_change_N_per_deg"]["PIP2"]
        self.assertAlmostEqual(math.hypot(*change) / told, 1, delta=1e-4)
        self.assertNotIn("note", force(30, ("DIP2=20", "--tension", "FDP=10")))

    def test_map_is_a_matrix_product(self):
        answer = ask("tip-force", INDEX_MAPS, "--tension", "FDP=10", "DI=2")
        self.near(answer["force_N"], [-0.8941 + 2 * 0.2087, -0.4689, 0.6472 + 2 * 0.0568], 1e-12)
        self.near([answer["tip_moment_N_mm"]["tx"]], [10 * 3.081 + 2 * 0.1579], 1e-9)

    def test_named_map_is_used(self):
        answer = ask("tip-force", INDEX_MAPS, "--tension", "FDP=10", "--map", "cadaver_hand4")
        self.near(answer["force_N"], [-0.55472, 0.085059, -0.4143], 1e-12)


class FeasibleForce(Near):
    def test_published_largest_force(self):
        # [CohnStf]: 28.81 N along +x.
        answer = ask("feasible-force", INDEX_MAPS, "--digit", "index", "--direction", 1, 0, 0)
        self.assertAlmostEqual(answer["component_N"], 28.81, delta=0.005)
        self.near(answer["force_N"], [answer["component_N"], 0, 0], 1e-9)
        self.assertEqual(list(answer["activation"]),
                         ["FDP", "FDS", "EIP", "EDC", "LUM", "DI", "PI"])
        self.assertTrue(all(0 <= a <= 1 for a in answer["activation"].values()))

    def test_force_is_the_map_times_its_tensions(self):
        answer = ask("feasible-force", INDEX_MAPS, "--direction", 1, 2, -1)
        subject = tomllib.loads(pathlib.Path(INDEX_MAPS).read_text())
        rows = subject["tip_map"][0]["rows"]
        tension = answer["tension_N"].values()
        product = lambda row: sum(a * t for a, t in zip(rows[row], tension))
        self.near(answer["force_N"], [product("Fx"), product("Fy"), product("Fz")], 1e-9)
        self.assertAlmostEqual(product("tx"), 0, delta=1e-9)

    def test_largest_moments_are_published(self):
        # [CohnStf], by vertex enumeration with all forces zero.
        for sign, published in ((1, 0.358), (-1, 0.176)):
            answer = ask("feasible-force", INDEX_MAPS, "--torque", sign, 0, 0)
            self.assertAlmostEqual(answer["component_Nm"], published, delta=5e-4)
            self.assertEqual(answer["forces"], "zero")
            self.assertLess(answer["certificate"]["gap_Nm"], 1e-9)
        self.assertIn("no row ty", complaint("feasible-force", INDEX_MAPS, "--torque", 0, 1, 0))

    def test_a_hold_that_carries_moments_can_only_help(self):
        finger = ("feasible-force", INDEX, "--posture", "MCP2_FE=45", "PIP2=45", "DIP2=10",
                  "--axes", "tip", "--direction", 0, -1, 0)
        last = ask(*finger)["component_N"]
        for most in (0.01, 0.1, "free"):
            answer = ask(*finger, "--moments", most)
            if answer["status"] == "unbounded":
                break
            self.assertGreater(answer["component_N"], last)
            self.assertEqual(len(answer["moment_Nm"]), 3)
            last = answer["component_N"]

    def test_cone_can_only_help(self):
        narrow = ask("feasible-force", INDEX_MAPS, "--direction", 0, 1, 0)["component_N"]
        wide = ask("feasible-force", INDEX_MAPS, "--direction", 0, 1, 0, "--tolerance-deg", 10)
        self.assertGreater(wide["component_N"], narrow)
        x, y, z = wide["force_N"]
        self.assertLessEqual(math.degrees(math.atan2(math.hypot(x, z), y)), 10 + 1e-6)

    def test_bent_finger_presses_ever_harder_in_wider_cones(self):
        # By another simplex method, with cuts of its own.
        for cone, certain in ((0, 30.396), (1, 30.47), (5, 30.77), (10, 31.15), (40, 31.26)):
            answer = ask("feasible-force", INDEX, "--posture", "MCP2_FE=45", "PIP2=45", "DIP2=10",
                         "--passive", "off", "--axes", "tip", "--direction", 0, -1, 0,
                         "--tolerance-deg", cone)
            self.assertAlmostEqual(answer["component_N"], certain, delta=0.006)
            self.assertLess(answer["certificate"]["gap_N"], 1e-9)
            self.assertLess(answer["certificate"]["imbalance_N_mm"], 1e-9)

    def test_directions_in_tip_axes_are_world_directions_turned(self):
        posture = ("--posture", "MCP3_FE=35", "PIP3=30", "DIP3=25")  # 90 degrees in all: palmar is x
        tip = ask("feasible-force", MIDDLE, *posture, "--direction", 0, -1, 0, "--axes", "tip")
        world = ask("feasible-force", MIDDLE, *posture, "--direction", 1, 0, 0)
        self.assertGreater(tip["component_N"], 1)
        self.assertAlmostEqual(tip["component_N"], world["component_N"], delta=1e-9)
        self.near(tip["force_N"], [0, -tip["component_N"], 0], 1e-9)

    def test_force_is_what_its_limits_are_worth(self):
        # Strong duality, with F0 from the table of the text.
        words = ("feasible-force", INDEX, "--passive", "off", "--posture", "MCP2_FE=45", "PIP2=45",
                 "DIP2=10", "--axes", "tip", "--direction", 0, -1, 0)
        answer = ask(*words)
        text = run(*words).stdout
        F0 = {line.split()[0]: float(line.split()[3]) for line in text.splitlines()
              if line.split()[:1] and line.split()[0] in answer["activation"]}
        worth = sum(limit["N_per_N_of_F0"] * F0[limit["muscle"]] for limit in answer["limited_by"])
        self.assertAlmostEqual(worth, answer["component_N"], delta=0.01 * len(F0))
        self.assertIn(f"limited by {answer['limited_by'][0]['muscle']}: the force rises by", text)

    def test_paralysis_takes_what_its_muscles_gave(self):
        # Only FDP flexes the DIP joint, so that no palmar force is left without it.
        words = ("feasible-force", SYNEK, "--posture", "MCP3_FE=20", "PIP3=30", "DIP3=15", "--axes",
                 "tip", "--direction", 0, -1, 0)
        intact = ask(*words)["component_N"]
        answer = ask(*words, "--without", "FDP")
        self.assertEqual(answer["without"], ["FDP"])
        self.assertAlmostEqual(answer["paralysis"]["loss"], 1, delta=1e-9)
        self.assertAlmostEqual(answer["paralysis"]["intact_component_N"], intact, delta=1e-9)
        half = ask(*words, "--weakened", f"FDP={4.1 * 45 / 2}")  # F0 is 4.1 cm^2 at 45 N/cm^2
        self.assertTrue(intact / 2 <= half["component_N"] < intact)  # concave, none at no FDP
        self.assertIn("no muscle 'FDQ', did you mean", complaint(*words, "--without", "FDQ"))

    def test_a_stop_holds_a_joint_one_way(self):
        # Without FPL no muscle flexes IP; its stop in extension does, and one in flexion does not.
        words = ("feasible-force", HUMAN, "--digit", "thumb", "--axes", "tip", "--direction",
                 0, -1, 0, "--tolerance-deg", 20, "--posture", "CMC1_FE=5", "CMC1_AA=10",
                 "MCP1_FE=26", "IP1=-38.8", "--without", "FPL", "--passive", "off")
        self.assertEqual(ask(*words)["status"], "no force")
        self.assertEqual(ask(*words, "--stop", "IP1=-inf")["status"], "no force")
        answer = ask(*words, "--stop", "IP1=inf")
        self.assertGreater(answer["component_N"], 5)
        stop = answer["stops"][0]
        self.assertEqual((stop["joint"], stop["most_Nm"]), ("IP1", None))
        self.assertGreater(stop["torque_Nm"], 0)
        half = ask(*words, "--stop", f"IP1={stop['torque_Nm'] / 2}")
        self.assertAlmostEqual(half["stops"][0]["torque_Nm"], stop["torque_Nm"] / 2, delta=1e-9)
        self.assertGreater(half["stops"][0]["N_per_Nm"], 0)
        self.assertIn("'IP1' is given twice", complaint(*words, "--stop", "IP1=1", "IP1=inf"))
        self.assertIn("wanted JOINT=N_m", complaint(*words, "--stop", "IP1"))

    def test_an_intact_wrist_takes_nothing_of_a_pinch(self):
        words = ("feasible-force", HUMAN, "--digit", "thumb", "--axes", "tip", "--direction",
                 0, -1, 0, "--posture", "CMC1_FE=5", "CMC1_AA=10", "MCP1_FE=26", "IP1=-3.8")
        held, pinch = ask(*words), ask(*words, "--wrist", "pinch")
        self.assertNotIn("wrist", held)
        self.assertEqual(pinch["wrist"], "pinch")
        self.assertAlmostEqual(pinch["component_N"], held["component_N"], delta=1e-6)
        # Without extensors nothing holds the wrist against FPL.
        lost = ask(*words, "--wrist", "pinch", "--without", "ECRL", "ECRB", "ECU", "EPL", "EPB",
                   "APL")
        self.assertAlmostEqual(lost["paralysis"]["loss"], 1, delta=1e-9)

    def test_postures_of_a_grid_are_those_asked_alone(self):
        for words in (("pose", MIDDLE), ("pose", "barrett"), ("moment-arms", MIDDLE),
                      ("tip-force", MIDDLE, "--tension", "FDP=10"),
                      ("feasible-force", MIDDLE, "--axes", "tip", "--direction", 0, -1, 0)):
            names = ("finger 1", "finger 2") if "barrett" in words else ("MCP3_FE", "PIP3")
            rows = ask(*words, "--vary", f"{names[0]}=20:30:10", f"{names[1]}=10:50:20")["postures"]
            self.assertEqual(len(rows), 6)
            alone = ask(*words, "--posture", f"{names[0]}=30", f"{names[1]}=30")
            for name, value in rows[4].items():
                self.assertEqual(value, alone[name], (words, name))
            printed = run(*words, "--vary", f"{names[1]}=10:50:20", "--csv").stdout
            count = len(ask("moment-arms", MIDDLE)["arms_mm"]) if words[0] == "moment-arms" else 1
            self.assertEqual(len(list(csv.DictReader(printed.splitlines()))), 3 * count)

    def test_moment_arms_are_slopes_of_lengths(self):
        rows = ask("moment-arms", MIDDLE, "--vary", "PIP3=29.9:30.1:0.1")["postures"]
        step = math.radians(0.2)
        for muscle, arms in rows[1]["arms_mm"].items():
            change = rows[2]["length_change_mm"][muscle] - rows[0]["length_change_mm"][muscle]
            self.assertAlmostEqual(arms.get("PIP3", 0), -change / step, delta=1e-4)

    def test_pages_of_a_digit(self):
        with tempfile.TemporaryDirectory() as folder:
            for words in (("pose", MIDDLE), ("pose", "barrett"), ("moment-arms", MIDDLE),
                          ("tip-force", MIDDLE, "--tension", "FDP=10"), ("feasible-force", MIDDLE)):
                page = pathlib.Path(folder) / "page.html"
                vary = "finger 1=0:20:10" if "barrett" in words else "PIP3=20:40:10"
                result = run(*words, "--vary", vary, "--report", page)
                self.assertEqual(result.returncode, 0, result.stderr)
                self.assertIn('"lines"', page.read_text())

    def test_set_holds_its_own_largest_forces(self):
        whole = ask("feasible-force", INDEX_MAPS)["set"]
        self.assertEqual((whole["status"], whole["dimension"]), ("solved", 3))
        self.assertGreater(whole["volume"], 0)
        self.assertAlmostEqual(whole["largest_N"]["+x"], 28.81, delta=0.005)
        self.assertGreaterEqual(max(v[0] for v in whole["vertices_N"]), whole["largest_N"]["+x"])

    def test_tells_directions_without_force_from_those_with_little(self):
        # Passive moments shift the set off the origin: no force along x, either way.
        whole = ask("feasible-force", "human_hand", "--digit", "index", "--posture", "MCP2_FE=30",
                    "MCP2_AA=5", "PIP2=40", "DIP2=20", "--without", "FDS2")["set"]
        self.assertEqual(whole["largest_status"]["+x"], "infeasible")
        self.assertEqual(whole["largest_N"]["+x"], 0)
        self.assertEqual(whole["largest_status"]["+y"], "solved")

    def test_straight_finger_carries_force_along_itself(self):
        answer = ask("feasible-force", MIDDLE, "--direction", 1, 0, 0)
        self.assertEqual(answer["status"], "unbounded")
        self.assertIsNone(answer["component_N"])


class Simulate(Near):
    def test_bounds_pull_with_activation_times_largest_force(self):
        last = ask("simulate", INDEX, "--muscle", "bounds", "--excitation", "FDP=0.2",
                   "--seconds", 0.02)["last"]
        a = last["activation"]["FDP"]
        # (0.5 + 1.5 a) a' / (0.2 - a) = 1 / 0.015 s, integrated.
        self.near([-1.5 * a - 0.8 * math.log(1 - a / 0.2)], [0.02 / 0.015], 1e-4)
        self.near([last["tension_N"]["FDP"]], [a * 4.79 * 30], 1e-6)  # PCSA, specific tension

    def test_energy_is_kept_on_every_rung(self):
        slack = [f"{m}=200" for m in ("EDC", "EIP", "FDP", "FDS", "RI", "LU", "UI")]
        for rung in ("bounds", "rigid-tendon", "elastic-tendon"):
            answer = ask("simulate", INDEX, "--muscle", rung, "--tendon-slack", *slack,
                         "--excitation", "FDP=0.1", "EDC=0.05", "--seconds", 0.3)
            self.assertEqual(answer["status"], "done")
            self.assertGreater(answer["work_J"], 1e-3)
            self.assertLess(answer["energy_error_J"], 1e-6)

    def test_energy_that_comes_of_nothing_is_no_answer(self):
        words = ["simulate", INDEX, "--passive", "off", "--muscle", "rigid-tendon",
                 "--excitation", "FDP=0.3", "--posture", 11, 11, 11, 11, "--seconds", 0.2, "--tolerance"]
        for tolerance, what in ((10, "energy does not balance: "), (1000, "the motion is stuck: ")):
            result = run(*words, tolerance)
            self.assertEqual(result.returncode, 1, result.stdout)
            self.assertIn("thenar: " + what, result.stderr)

    def test_table_starts_at_the_posture_and_names_units(self):
        with tempfile.TemporaryDirectory() as folder:
            table = pathlib.Path(folder) / "motion.csv"
            result = run("simulate", INDEX, "--posture", "PIP2=30", "--excitation", "FDS=0.1",
                         "--seconds", 0.1, "--sample-ms", 20, "-o", table)
            self.assertEqual(result.returncode, 0, result.stderr)
            header, *rows = (line.split(",") for line in table.read_text().splitlines())
            at = {name: float(cell) for name, cell in zip(header, rows[0])}
            self.assertAlmostEqual(at["angle_PIP2_deg"], 30, delta=1e-6)
            self.assertEqual([float(row[0]) for row in rows], [0, 0.02, 0.04, 0.06, 0.08, 0.1])
            self.assertIn("tension_FDS_N", header)

    def test_excitation_file_of_a_constant_moves_as_the_constant(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "excitation.csv"
            file.write_text("time_s,FDP\n0,0.1\n1,0.1\n")
            by_file = ask("simulate", INDEX, "--excitation-file", file, "--seconds", 0.1)
        by_words = ask("simulate", INDEX, "--excitation", "FDP=0.1", "--seconds", 0.1)
        self.assertEqual(by_file["last"], by_words["last"])

    def test_page_and_result_file_are_written(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, start in (("motion.html", b"<!doctype html>"), ("motion.h5", b"\x89HDF")):
                file = pathlib.Path(folder) / name
                result = run("simulate", INDEX, "--excitation", "FDP=0.1", "--seconds", 0.05,
                             "-o", file)
                self.assertEqual(result.returncode, 0, result.stderr)
                self.assertTrue(file.read_bytes().startswith(start))

    def test_net_moves_as_well(self):
        answer = ask("simulate", INDEX, "--net", ROOT / "data/nets/chao_an.toml", "--excitation",
                     "FDP=0.1", "EDC=0.1", "--seconds", 0.02)
        self.assertIn("floating net", answer["fidelity"])
        self.assertEqual(answer["status"], "done")
        self.assertGreater(answer["last"]["slips_N"]["terminal"], 0)

    def test_hood_that_is_a_net_is_the_extensor_hood_unless_named(self):
        words = ("simulate", INDEX, "--excitation", "EDC=0.1", "--seconds", 0.02)
        self.assertEqual(ask(*words, "--hood", "net")["last"],
                         ask(*words, "--net", "extensor_hood")["last"])

    def test_interrupt_keeps_what_there_is(self):
        with tempfile.TemporaryDirectory() as folder:
            table = pathlib.Path(folder) / "motion.csv"
            restless = pathlib.Path(folder) / "excitation.csv"  # minutes of work
            restless.write_text("time_s,FDP,EDC\n" + "".join(
                f"{k / 5},{0.1 * (k % 2)},{0.1 - 0.1 * (k % 2)}\n" for k in range(10000)))
            words = ["simulate", INDEX, "--excitation-file", restless, "--seconds", 2000,
                     "--sample-ms", 100, "-o", table]
            code, _, said = stopped(
                [PROGRAM, *words], signal.SIGINT,
                lambda *_: table.exists() and len(table.read_text().splitlines()) > 2)
            self.assertEqual(code, 130)
            self.assertIn("stopped", said)
            self.assertGreater(len(table.read_text().splitlines()), 2)

    def test_complaints_name_what_is_missing(self):
        self.assertEqual(complaint("simulate", INDEX, "--excitation", "FPL=1"),
                         "thenar: no muscle 'FPL', did you mean 'FDP'? there are EDC, EIP, FDP, FDS, RI, LU, UI (--excitation)")
        self.assertIn("muscle 'EDC' of subject 'an_chao_index' needs 'tendon_slack_mm'",
                      complaint("simulate", INDEX, "--excitation", "FDP=1", "--muscle",
                                "elastic-tendon"))
        self.assertIn("moves nothing that has mass",
                      complaint("simulate", MIDDLE, "--excitation", "FDP=1", "--muscle", "bounds"))
        self.assertIn("excitations of muscles, a file of them, or gravity", complaint("simulate", INDEX))
        self.assertIn("net 'winslow' needs a hood that is a net, got the hood 'fractions'",
                      complaint("simulate", INDEX, "--excitation", "FDP=1", "--net", "winslow",
                                "--hood", "fractions"))
        self.assertIn("wanted excitations from 0 to 1, got 2 of 'FDP'",
                      complaint("simulate", INDEX, "--excitation", "FDP=2"))
        self.assertIn("ends in .h5 or .html or .csv or .json, got 'motion.txt'",
                      complaint("simulate", INDEX, "--excitation", "FDP=1", "-o", "motion.txt"))


class Tendon(Near):
    EDC = ("--tension", "EDC=2.9", "LU=0.4")

    def test_solve_balances_every_knot_that_no_bone_touches(self):
        answer = ask("tendon", "solve", SYNEK, "--net", "winslow", *self.EDC)
        self.assertEqual(answer["status"], "balanced")
        place = {node["name"]: node["place_mm"] for node in answer["nodes"]}
        held = {contact["node"] for contact in answer["contacts"]}
        force = {node["name"]: [0, 0, 0] for node in answer["nodes"] if node["floating"]}
        for band in answer["bands"]:
            ends = band["from"], band["to"]
            if "on bone" in band["state"]:
                held.update(ends)  # its pull does not point at its other end
                continue
            way = [b - a for a, b in zip(place[ends[0]], place[ends[1]])]
            for end, sign in zip(ends, (1, -1)):
                if end in force:
                    pull = sign * band["tension_N"] / math.hypot(*way)
                    force[end] = [f + pull * w for f, w in zip(force[end], way)]
        loose = set(force) - held
        self.assertGreater(len(loose), 1)
        for node in loose:
            self.assertLess(math.hypot(*force[node]), 1e-8, node)

    def test_separate_tendons_have_the_arms_of_their_paths(self):
        answer = ask("tendon", "solve", MIDDLE, "--hood", "separate", "--tension", "FDP=2",
                     "--posture", "MCP3_FE=30", "PIP3=40", "DIP3=20")
        arms = moment_arms(strand_points("FDP"), (30, 40, 20))
        for joint, arm in zip(("MCP3_FE", "PIP3", "DIP3"), arms):
            self.near([answer["moment_arm_mm"]["FDP"][joint]], [arm], 1e-4)
            self.near([answer["torque_N_mm"][joint]], [2 * arm], 2e-4)

    # Nothing bends a straight finger's tip force: what tendons turn is left, and is said to be.
    def test_straight_finger_has_no_force_of_the_tip_to_trust(self):
        words = (SYNEK, "--tension", "EDC=2.9", "LU=0.4")
        answer = ask("tendon", "solve", *words)
        self.assertIsNone(answer["condition"])
        self.assertIn("singular posture", answer["note"])
        self.assertGreater(max(map(abs, answer["leftover_torque_N_mm"].values())), 1)
        for angle in (0, 30):
            text = run("tendon", "solve", *words, "--posture", f"PIP3={angle}", "MCP3_FE=20").stdout
            self.assertEqual("note: singular posture" in text, angle == 0)
        swept = run("tendon", "sweep", *words, "--vary", "PIP3=0:20:10", "--json")
        self.assertIn("at 1 of 3 postures, first at PIP3=0", swept.stderr)
        self.assertEqual([condition is None for condition in json.loads(swept.stdout)["condition"]],
                         [True, False, False])

    def test_sweep_has_a_row_a_posture_the_last_joint_fastest(self):
        result = run("tendon", "sweep", SYNEK, *self.EDC, "--vary", "MCP3_FE=0:20:20",
                     "--vary", "PIP3=0:25:10")
        self.assertEqual(result.returncode, 0, result.stderr)
        header, *rows = [line.split(",") for line in result.stdout.splitlines()]
        angles = [(float(row[header.index("MCP3_FE_deg")]), float(row[header.index("PIP3_deg")]))
                  for row in rows]
        self.assertEqual(angles, [(m, p) for m in (0, 20) for p in (0, 10, 20)])
        for row in rows:
            self.assertEqual(row[header.index("status")], "balanced")

    def test_the_radial_and_ulnar_bands_feed_the_terminal_slip_of_chao_and_an(self):
        answer = ask("tendon", "sweep", SYNEK, "--net", "chao_an", *self.EDC, "--vary",
                     "PIP3=0:20:10")
        for radial, ulnar, terminal in zip(answer["radial_N"], answer["ulnar_N"],
                                           answer["terminal_N"]):
            self.near([terminal], [radial + ulnar], 1e-6)

    def test_sweep_tells_at_which_postures_not_to_trust_it(self):
        words = ("tendon", "sweep", SYNEK, "--net", "dogadov2017", "--tension", "RI=5", "UI=0.1",
                 "--vary", "MCP3_FE=-20:80:50", "--vary", "DIP3=0:80:40")
        with tempfile.TemporaryDirectory() as folder:
            page, table = pathlib.Path(folder) / "net.html", pathlib.Path(folder) / "net.csv"
            for path in (page, table):  # refused as `tendon solve` refuses, but written
                result = run(*words, "-o", path)
                self.assertEqual(result.returncode, 1)
                self.assertIn("not to be trusted at", result.stderr)
            with table.open(newline="") as file:
                rows = list(csv.DictReader(file))
            text = page.read_text()
        self.assertEqual({row["status"] for row in rows}, {"balanced", "drawn in"})
        for row in rows:
            self.assertEqual("has drawn in" in row["trouble"], row["status"] == "drawn in")
        self.assertEqual([row["trouble"] for row in rows],
                         json.loads(run(*words, "--json").stdout)["trouble"])
        troubled = sum(row["trouble"] != "" for row in rows)
        self.assertIn(f"{troubled} of {len(rows)} postures, first", text)

    def test_sweep_without_a_net_has_no_status_of_one(self):
        answer = ask("tendon", "sweep", MIDDLE, "--hood", "separate", "--tension", "FDP=2",
                     "--vary", "PIP3=0:20:20")
        self.assertEqual(answer["status"], ["sound", "sound"])
        self.assertEqual(answer["trouble"], ["", ""])
        self.assertNotIn("snapped", answer)

    # One rule for both: a sweep fails if and only if solving one of its postures does.
    def test_sweep_refuses_what_solve_refuses(self):
        words = (SUBJECTS / "mirakhorlo2016.toml", "--digit", "little", "--net", "dogadov2017",
                 "--tension")
        for tension, code in ((2, 0), (20, 1)):
            pulled = (*words, f"ADM={tension}")
            solved = run("tendon", "solve", *pulled, "--posture", "MCP5_FE=60")
            swept = run("tendon", "sweep", *pulled, "--vary", "MCP5_FE=60:60:1")
            self.assertEqual(solved.returncode, code, solved.stderr)
            self.assertEqual(swept.returncode, code, swept.stderr)
        self.assertIn("more than tissue can", swept.stderr)

    def test_freezing_a_joint_where_it_stands_changes_no_slip(self):
        words = ("tendon", "solve", "human_hand", "--digit", "index", "--tension", "EDC2=2.9", "--posture",
                 "MCP2_FE=0", "PIP2=45")
        free = ask(*words, "DIP2=30")["slips_N"]
        frozen = ask(*words, "--frozen", "DIP2=30")["slips_N"]
        for slip, tension in free.items():
            self.assertAlmostEqual(tension, frozen[slip], 6)

    def test_more_than_a_muscle_can_make_is_told(self):
        said = "FDP2 is pulled with 1000 N, but can make"
        words = (SUBJECTS / "human_hand.toml", "--digit", "index", "--tension", "FDP2=1000")
        for question in ("tip-force", "tendon solve"):
            self.assertIn(said, run(*question.split(), *words).stderr)
            self.assertIn(said, " ".join(ask(*question.split(), *words)["warnings"]))

    def test_paths_can_be_chosen_and_are_told(self):
        words = (SUBJECTS / "mirakhorlo2016.toml", "--digit", "middle", "--posture", "MCP3_FE=60",
                 "PIP3=60", "--tension", "EDC3=10")
        answers = {path: ask("tip-force", *words, "--path", path) for path in ("via", "wrapped")}
        self.assertIn("via points", answers["via"]["fidelity"])
        self.assertIn("wrapped paths", answers["wrapped"]["fidelity"])
        self.assertNotAlmostEqual(answers["via"]["magnitude_N"],
                                  answers["wrapped"]["magnitude_N"], 3)

    def test_every_question_wraps_unless_another_path_is_named(self):
        finger = ("--digit", "index", "--posture", "MCP2_FE=60", "PIP2=60", "DIP2=30")
        pulled = (*finger, "--tension", "FDP2=3", "LU1=1")
        questions = {
            "explain": lambda *path: ask("explain", "mirakhorlo2016", "--digit", "index", *path)["fidelity"],
            "moment-arms": lambda *path: ask("moment-arms", "mirakhorlo2016", *finger, *path),
            "tip-force": lambda *path: ask("tip-force", "mirakhorlo2016", *pulled, *path),
            "feasible-force": lambda *path: ask("feasible-force", "mirakhorlo2016", *finger, "--direction", 0, -1, 0,
                                                "--axes", "tip", *path),
            "tendon solve": lambda *path: ask("tendon", "solve", "mirakhorlo2016", *pulled, "--hood", "separate", *path),
            "simulate": lambda *path: ask("simulate", "mirakhorlo2016", "--digit", "index", "--excitation", "LU1=0.1",
                                          "--muscle", "bounds", "--seconds", 0.02, *path)}
        for name, question in questions.items():
            with self.subTest(question=name):
                unasked = question()
                self.assertEqual(unasked, question("--path", "wrapped"))
                self.assertNotEqual(unasked, question("--path", "via"))

    def test_a_fit_refuses_to_wrap_and_says_why(self):
        for words in (("fit", H01, "--subject", MIDDLE), ("predict", "fit.h5", H01),
                      ("posterior", "predict", "P.nc", H01)):
            self.assertIn("kernel does not wrap", complaint(*words, "--path", "wrapped"))

    def test_collapsing_arm_is_told(self):
        words = ("tip-force", SUBJECTS / "mirakhorlo2016.toml", "--digit", "index", "--tension",
                 "FDP2=10", "--posture")
        self.assertIn("FDP2 at PIP2: 0.64 mm", run(*words, "PIP2=90").stderr)
        self.assertEqual(run(*words, "PIP2=45").stderr, "")

    def test_a_report_is_written(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "net.html"
            result = run("tendon", "solve", SYNEK, *self.EDC, "-o", path)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertIn("color_scale", path.read_text())

    def test_complaints(self):
        self.assertIn("there is no net 'winslo', nor a file of that name, did you mean 'winslow'? nets: chao_an",
                      complaint("tendon", "solve", SYNEK, "--net", "winslo", *self.EDC))
        self.assertIn("wanted NAME=from:to:step, got 'PIP3=5'",
                      complaint("tendon", "sweep", SYNEK, *self.EDC, "--vary", "PIP3=5"))
        self.assertIn("ends in .html or .csv or .json, got 'net.txt'",
                      complaint("tendon", "sweep", SYNEK, *self.EDC, "--vary", "PIP3=0:20:10",
                                "-o", "net.txt"))
        self.assertIn("steps of -5 deg do not lead from 0 to 90 deg",
                      complaint("tendon", "sweep", SYNEK, *self.EDC, "--vary", "PIP3=0:90:-5"))

    def test_explains_what_a_net_is_made_of(self):
        for name in ("chao_an", "dogadov2017", "extensor_hood", "winslow"):
            path = ROOT / f"data/nets/{name}.toml"
            net, said = tomllib.loads(path.read_text()), ask("explain", path)
            for kind, key in (("node", "node"), ("band", "band"), ("surface", "surface")):
                self.assertEqual([row[key] for row in said[kind + "s"]["rows"]],
                                 [part["name"] for part in net.get(kind, [])])
            for row, band in zip(said["bands"]["rows"], net["band"]):
                if "modulus_MPa" in band:
                    self.near([row["EA_N"]], [band["modulus_MPa"] * band["area_mm2"]], 0.051)
            self.assertEqual(len(said["muscles"]["rows"]),
                             sum(len(muscle["pulls"]) for muscle in net["muscle"]))
            self.assertEqual([row["rung"] for row in said["assumes"]["rows"]],
                             ["separate tendons", "fixed force fractions", "floating net"])

    def test_infers_the_bands_of_a_net(self):
        with tempfile.TemporaryDirectory() as folder:
            page = pathlib.Path(folder) / "bands.html"
            answer = ask("tendon", "infer", H01, "--subject", SYNEK, "--net", "chao_an",
                         "--propose", 2, "-o", page)
            text = page.read_text()
        net = tomllib.loads((ROOT / "data/nets/chao_an.toml").read_text())
        passive = {band["name"] for band in net["band"] if "muscle" not in band}
        self.assertEqual({band["band"] for band in answer["bands"]}, passive)
        # Muscles of the net that the experiment pulls, three force components a trial.
        trials = tomllib.loads(pathlib.Path(H01).read_text())["trials"]["rows"]
        pulled = [row for row in trials if not {"FDP", "FDS"} & set(row["load_g"])]
        self.assertEqual(answer["readings"], 3 * len(pulled))
        for band in answer["bands"]:
            decided = band["evidence"] is None or abs(band["evidence"]) >= 6
            self.assertEqual(band["verdict"] != "undecided", decided, band)
            self.assertIn(band["band"], text)
        self.assertTrue(answer["best_fit_converged"])
        self.assertLess(answer["out_of_balance_N"], 1e-4)
        # Where a band came from: hashes of all three files.
        for path in (H01, SYNEK, ROOT / "data/nets/chao_an.toml"):
            self.assertIn(hashlib.sha256(pathlib.Path(path).read_bytes()).hexdigest(), text)
        # A stiffness is told only where the data say more of it than its bounds 1/4 and 4 do.
        for band in answer["bands"]:
            sd = band["sd_of_log_EA"]
            told = sd is not None and sd < math.log(16) / math.sqrt(12)
            self.assertEqual(bool(band["EA_N"]), told, band)
        self.assertIn("not decided by the data", text)
        promises = [test["disagreement"] for test in answer["next_tests"]]
        self.assertEqual(promises, sorted(promises, reverse=True))
        self.assertLessEqual(len(promises), 2)

    def test_infers_bands_with_slack_lengths_free(self):
        answer = ask("tendon", "infer", H01, "--subject", "an_chao_middle", "--net", "extensor_hood",
                     "--free", "net/triangular/slack", "--bands", "triangular", "--propose", 1)
        band, = answer["bands"]
        self.assertEqual(band["band"], "triangular")
        self.assertTrue(0 <= band["probability"] <= 1)
        self.assertGreater(band["slack"]["prior_sd_mm"], 0)
        self.assertTrue(answer["all_sets"])
        self.assertEqual(len(answer["next_tests"]), 1)

    def test_interrupted_inference_says_what_it_has(self):
        words = ["tendon", "infer", H01, "--subject", SYNEK, "--method", "explore", "--json"]
        code, printed, said = stopped([PROGRAM, *words], signal.SIGINT, lambda code, out: code == 130 and out)
        self.assertEqual(code, 130)
        self.assertIn("stopped", said)
        self.assertGreater(len(json.loads(printed)["bands"]), 10)

    def test_inference_names_an_unknown_method(self):
        self.assertEqual(complaint("tendon", "infer", H01, "--subject", SYNEK, "--method", "guess"),
                         "thenar: method: wanted one of sparse, explore, got \"guess\" (--method)")


class Validate(Near):
    def test_every_data_file_is_recognised(self):
        files = sorted((ROOT / "data").glob("*/*.toml"))
        result = run("validate", *files)
        self.assertEqual(result.returncode, 0, result.stdout)
        lines = [line for line in result.stdout.splitlines() if not line.startswith("  warning: ")]
        self.assertEqual(len(lines), len(files))
        self.assertIn(f"{MIDDLE}: subject 'an_chao_middle': 5 segments, 4 joints, 6 muscles, "
                      "1 digit (middle)", lines)
        self.assertIn(f"{H01}: experiment 'synek2019_H01': human middle finger of specimen H01, "
                      "24 trials, 4 postures, 6 muscles loaded", lines)
        self.assertTrue(any(": human thumb of specimen " in line for line in lines), lines)

    def test_goes_on_after_an_error_and_fails(self):
        with tempfile.TemporaryDirectory() as folder:
            bad = pathlib.Path(folder) / "bad.toml"
            bad.write_text('name = "x"\nside = "upper"\n[[joint]]\n')
            result = run("validate", bad, MIDDLE)
        self.assertEqual(result.returncode, 1)
        first, second = result.stdout.splitlines()
        self.assertTrue(first.startswith(f"{bad}:2: "), first)
        self.assertTrue(second.startswith(f"{MIDDLE}: subject"), second)

    def test_names_that_no_file_can_have_are_names_of_no_file(self):
        name = 300 * "a"
        for words in (("pose", name), ("pose", name + ".toml"), ("grasp", name), ("close", name),
                      ("compare", "--hands", name), ("quality", name), ("import", name),
                      ("compare", "--hands", "barrett", "--objects", name),
                      ("tendon", "solve", SYNEK, "--tension", "EDC=1", "--net", name),
                      ("pose", "barrett", "--data", name)):
            self.assertRegex(complaint(*words), f"^thenar: .*{name}", words)
            self.assertNotIn("filesystem", complaint(*words))

    def test_holds_an_experiment_to_a_subject(self):
        self.assertIn("suits", run("validate", "synek2019_H01", "--subject", MIDDLE).stdout)
        result = run("validate", H01, "--subject", INDEX)
        self.assertEqual(result.returncode, 1)
        self.assertIn(f"{H01}:15: subject 'an_chao_index' has no bones of the middle", result.stdout)

    def test_absent_file_is_an_error(self):
        result = run("validate", "/nowhere.toml")
        self.assertEqual((result.returncode, result.stdout),
                         (1, "there is no file '/nowhere.toml'\n"))


class Explain(Near):
    def test_says_what_a_digit_of_a_whole_hand_keeps(self):
        said = ask("explain", WHOLE, "--digit", "index")
        kept = {row["part"]: row["count"] for row in said["kept"]["rows"]}
        # MCP 2, PIP, DIP of 22 joints; the radius, what the wrist moves, and what these move.
        self.assertEqual((kept["joints"], kept["segments"]), (4, 7))
        dropped = {}
        for row in said["dropped"]["rows"]:
            dropped[row["part"]] = dropped.get(row["part"], 0) + row["count"]
        self.assertEqual((dropped["joint"], dropped["segment"]), (22 - 4, 23 - 7))
        self.assertEqual(kept["muscles"] + dropped["muscle"], 41)
        why = {name: row["why"] for row in said["dropped"]["rows"]
               for name in row["names"].split(", ")}
        self.assertTrue(why["WRIST_FE"].startswith("welded"))

    def test_lists_parameters_with_their_priors(self):
        rows = {row["parameter"]: row for row in ask("explain", MIDDLE)["parameters"]["rows"]}
        self.assertEqual(rows["friction/FDS"]["state"], "tied to friction/FDP")
        self.assertEqual(rows["friction/FDP"], {
            "parameter": "friction/FDP", "unit": "1", "prior_mean": 0.1, "sd": 0.05,
            "between_sd": 0, "lower": 0, "upper": 0.5, "state": "free",
            "means": "friction of FDP in its sheath"})

    def test_names_the_rung_that_was_built(self):
        rung = lambda subject, *digit: {row["ladder"]: row["rung"] for row in
                                        ask("explain", subject, *digit)["fidelity"]["rows"]}
        self.assertEqual(rung(MIDDLE)["path"], "via points")
        self.assertEqual(rung(MIDDLE)["hood"], "fixed force fractions")
        self.assertEqual(rung(SUBJECTS / "arms_thumb.toml")["path"], "constant moment arms")
        self.assertEqual(rung(SKEWED, "--digit", "index")["path"], "no tendons")

    # 0.3 rad are 17.2 degrees.
    def test_tells_ratio_and_offset_of_coupled_joints(self):
        limits = '<limit lower="0" upper="1.2" effort="1" velocity="1"/>'
        joint = '<joint name="{}" type="revolute"><parent link="{}"/><child link="{}"/>{}{}</joint>'
        with tempfile.TemporaryDirectory() as folder:
            robot = pathlib.Path(folder) / "r.urdf"
            robot.write_text("<robot name='r'><link name='a'/><link name='b'/><link name='c'/>" +
                             joint.format("j", "a", "b", limits, "") +
                             joint.format("k", "b", "c", limits,
                                          '<mimic joint="j" multiplier="0.6" offset="0.3"/>') +
                             "</robot>")
            subprocess.run([PROGRAM, "import", robot, "-o", folder + "/r.toml"], check=True,
                           capture_output=True)
            self.assertIn("k x 0.600 + 17.2 deg", run("explain", folder + "/r.toml").stdout)

    def test_costs_are_measured(self):
        for row in ask("explain", MIDDLE)["cost"]["rows"]:
            self.assertGreater(row["median_us"], 0)

    def test_tells_an_experiment(self):
        said = ask("explain", H01)
        self.assertEqual([row["trials"] for row in said["postures"]["rows"]], [6] * 4)
        loads = {row["loaded"]: row for row in said["trials"]["rows"]}
        self.assertAlmostEqual(loads["FDS"]["tension_to_N"], 0.950 * 9.81 * 0.835, delta=1e-3)


class WrongKinds(unittest.TestCase):
    """A file of another kind is named, with what takes it."""

    def test_of_every_command(self):
        mug, jaw = ROOT / "data/objects/mug.toml", ROOT / "data/robots/parallel_jaw.toml"
        mesh = ROOT / "data/objects/mug.obj"
        with tempfile.TemporaryDirectory() as folder:
            urdf = pathlib.Path(folder) / "claw.urdf"
            urdf.write_text("<robot name='claw'><link name='palm'/></robot>")
            for words, wanted in (
                    (("grasp", urdf), "is a robot, wanted a world"),
                    (("grasp", urdf), "docs/tutorials/own_gripper.md"),
                    (("grasp", mesh), "is a mesh, wanted a world; try: thenar import"),
                    (("pose", mug), "is an object, wanted a subject or a robot; commands that take it: "
                                    f"thenar explain {mug}, thenar import {mug}"),
                    (("tip-force", "barrett", "--tension", "FDP=1"),
                     "there is no subject 'barrett'; it is a hand: thenar pose barrett"),
                    (("tip-force", jaw, "--tension", "FDP=1"), "is a robot, wanted a subject"),
                    (("fit", MIDDLE, "--subject", MIDDLE), "is a subject, wanted an experiment"),
                    (("compare", "--hands", mug, "--objects", "can"),
                     "is an object, wanted a robot or a subject"),
                    (("compare", "--hands", "barrett", "--objects", mesh),
                     "given its mass and material, and the unit of its numbers")):
                self.assertIn(wanted, complaint(*words))


class Strengths(unittest.TestCase):
    def test_are_explained_as_they_are_stated(self):
        stated = {muscle["name"]: muscle["max_force_N"]
                  for muscle in tomllib.loads(pathlib.Path(HUMAN).read_text())["muscle"] if "max_force_N" in muscle}
        rows = ask("explain", HUMAN, "--digit", "thumb")["muscles"]["rows"]
        for row in rows:
            self.assertEqual(row["F0_N"], stated[row["muscle"]])
        self.assertIn(16.765, [row["F0_N"] for row in rows])

    # RI of an_chao_middle: 2.8 cm2 at 45 N/cm2 are 126 N.
    def test_are_shown_without_rounding_errors(self):
        rows = ask("explain", MIDDLE)["muscles"]["rows"]
        self.assertEqual([row["F0_N"] for row in rows if row["muscle"] == "RI"], [126])


class Refused(unittest.TestCase):
    def test_numbers_that_are_not_decimal(self):
        for typed in ("0x10", "0X1p4"):
            self.assertIn(f"got '{typed}'", complaint("tip-force", SYNEK, "--tension", f"FDP={typed}"))

    def test_fits_that_have_not_converged_and_what_they_predict(self):
        # One evaluation certifies no minimum, by a file of a request as by the command; the answer is printed.
        with tempfile.TemporaryDirectory() as name:
            request, fit = pathlib.Path(name) / "r.toml", pathlib.Path(name) / "fit.h5"
            request.write_text('question = "fit"\nexperiments = ["synek2019_H01"]\nsubject = "an_chao_middle"\n'
                               'max_evaluations = 1\n')
            words = ("fit", "synek2019_H01", "--subject", "an_chao_middle", "--max-evaluations", "1",
                     "-o", fit)
            for result in (run("ask", request, "--json"), run(*words, "--json")):
                self.assertEqual(result.returncode, 1, result.stderr)
                self.assertIn("the fit has NOT converged", result.stderr)
                self.assertNotEqual(json.loads(result.stdout)["status"], "converged")
            predict = ("predict", fit, "synek2019_H01", "--json")
            self.assertEqual(run(*predict).returncode, 1)
            self.assertIn("do not use these forces", run(*predict).stderr)
            self.assertEqual(run(*predict, "--allow-unconverged").returncode, 0)


class Rerun(unittest.TestCase):
    def test_writes_the_same_answer_again(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "a.json"
            subprocess.run([PROGRAM, "explain", H01, "-o", "a.json"], cwd=folder, check=True,
                           capture_output=True)
            told = ask("rerun", file)
            self.assertEqual(told["arguments"], ["explain", H01, "-o", "a.json"])
            self.assertEqual(told["folder"], str(pathlib.Path(folder).resolve()))
            first = json.loads(file.read_text())
            os.rename(file, pathlib.Path(folder) / "b.json")
            again = run("rerun", pathlib.Path(folder) / "b.json")
            self.assertEqual(again.returncode, 0, again.stderr)
            self.assertEqual(json.loads(file.read_text())["trials"], first["trials"])

    def test_repeats_older_answers_on_straight_paths(self):
        words = ["tip-force", "mirakhorlo2016", "--digit", "index", "--posture", "MCP2_FE=60", "PIP2=60", "DIP2=30",
                 "--tension", "FDP2=10", "LU1=5", "-o", "a.json"]
        with tempfile.TemporaryDirectory() as name:
            file = pathlib.Path(name) / "a.json"
            subprocess.run([PROGRAM, *words], cwd=name, check=True, capture_output=True)
            answer = json.loads(file.read_text())
            self.assertIn("wrapped", answer["fidelity"])
            self.assertEqual(ask("rerun", file)["arguments"], words)
            # Before 0.2 files of this kind named no version.
            del answer["provenance"]["thenar"]
            old = pathlib.Path(name) / "old.json"
            old.write_text(json.dumps(answer))
            told = ask("rerun", old)
            self.assertEqual(told["arguments"], [*words, "--path", "via"])
            self.assertIn("'--path via' is added", told["warnings"][-1])
            self.assertEqual(run("rerun", old).returncode, 0)
            self.assertIn("via points", json.loads(file.read_text())["fidelity"])
            # Paths that were stated stay.
            for stated in (["--path", "wrapped"], ["--path=via"]):
                subprocess.run([PROGRAM, *words, *stated], cwd=name, check=True, capture_output=True)
                answer = json.loads(file.read_text())
                del answer["provenance"]["thenar"]
                old.write_text(json.dumps(answer))
                self.assertEqual(ask("rerun", old)["arguments"], [*words, *stated])

    def test_names_every_input_that_changed(self):
        # A world names a robot and an object, and the object a mesh: four files in all.
        jaw = (ROOT / "data/robots/parallel_jaw.toml").read_text()
        texts = {
            "jaw.toml": jaw,
            "box.off": "OFF\n8 12 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
                       "3 0 2 1\n3 0 3 2\n3 4 5 6\n3 4 6 7\n3 0 1 5\n3 0 5 4\n3 1 2 6\n3 1 6 5\n"
                       "3 2 3 7\n3 2 7 6\n3 3 0 4\n3 3 4 7\n",
            "box.toml": 'name = "box"\nsource = "Mine"\nmaterial = "wood"\nmass_g = 50\n'
                        '[sources]\nMine = "Weighed here"\n[[shape]]\nkind = "mesh"\n'
                        'file = "box.off"\nscale = 0.03\n',
            "scene.toml": 'name = "scene"\nsource = "Mine"\n[sources]\nMine = "Arranged here"\n'
                          '[[hand]]\nname = "jaws"\nfile = "jaw.toml"\nposition_m = [0, -0.2, 0]\n'
                          '[[body]]\nrole = "object"\nfile = "box.toml"\n'
                          'position_mm = [-15, 0, -15]\n'}
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            for file, text in texts.items():
                (folder / file).write_text(text)
            done = subprocess.run([PROGRAM, "grasp", "scene.toml", "-o", "a.json", "-o", "a.html"],
                                  cwd=folder, capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            record = json.loads((folder / "a.json").read_text())["provenance"]
            for file, text in texts.items():
                self.assertEqual(record[file], "sha256 " + hashlib.sha256(text.encode()).hexdigest())
            for answer in (folder / "a.json", folder / "a.html"):
                self.assertIn("inputs: 4, unchanged", run("rerun", answer, "--print").stdout)
                for file, text in texts.items():
                    (folder / file).write_text(text + "\n")
                    told = run("rerun", answer, "--print").stdout
                    self.assertIn("inputs: 4, 1 changed", told)
                    self.assertIn(f"input '{file}' has changed since", told)
                    (folder / file).write_text(text)
            (folder / "box.off").unlink()
            self.assertIn("input 'box.off' is gone", run("rerun", answer, "--print").stdout)

    def test_finds_its_inputs_unchanged(self):
        # Data folders hold the subject of a digit, and two files of the types of thumbs; nets are built in. A request
        # is a file, and so are contacts.
        motion = ("--excitation", "FDP=0.1", "--seconds", "0.01")
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "c.toml").write_text('question = "contacts"\ncontacts = "two_soft_fingers"\n')
            for count, words in (
                    (1, ("tendon", "solve", "synek2019_middle", "--tension", "EDC=2", "-o", "a.json")),
                    (1, ("tendon", "solve", "synek2019_middle", "--net", "winslow", "--tension", "EDC=2", "-o", "a.html")),
                    (2, ("tendon", "solve", "synek2019_middle", "--net", ROOT / "data/nets/winslow.toml", "--tension",
                         "EDC=2", "-o", "a.json")),
                    (1, ("simulate", "an_chao_index", "--net", "chao_an", *motion, "-o", "a.h5")),
                    (2, ("study", "thumb-types", "--draws", "10", "-o", "a.json")),
                    (2, ("ask", "c.toml", "-o", "a.json"))):
                done = subprocess.run([PROGRAM, *map(str, words)], cwd=folder, capture_output=True, text=True, check=False)
                self.assertEqual(done.returncode, 0, done.stderr)
                told = run("rerun", folder / words[-1], "--print").stdout
                self.assertIn(f"inputs: {count}, unchanged", told)
                self.assertNotIn("is gone", told)

    def test_refuses_what_records_no_command(self):
        self.assertIn("records no command", complaint("rerun", H01))


class List(unittest.TestCase):
    def test_has_every_subject(self):
        names = {row["name"] for row in ask("list", "subjects")}
        self.assertLessEqual({path.stem for path in SUBJECTS.glob("*.toml")}, names)
        self.assertIn("MCP3_FE", run("list", "joints", MIDDLE, "--csv").stdout)


class EverySubject(Near):
    def test_answers_parse_whatever_the_subject(self):
        for path in sorted(SUBJECTS.glob("*.toml")):
            subject = tomllib.loads(path.read_text())
            digits = {part["digit"] for part in subject.get("tip_map", [])}
            digits |= {digit["name"] for digit in subject.get("digit", [])}
            for digit in digits:
                with self.subTest(subject=path.name, digit=digit):
                    ask("explain", path, "--digit", digit)
                    if "digit" in subject:
                        ask("pose", path, "--digit", digit)


class Complaints(unittest.TestCase):
    def test_they_say_what_was_wanted_and_what_came(self):
        posed = ("pose", MIDDLE)
        cases = [
            (("pose", MIDDLE, "--posture", "PIP=3"),
             "no free joint 'PIP', did you mean 'PIP3'? there are MCP3_FE, MCP3_AA, PIP3, DIP3 (--posture)"),
            ((*posed, "--posture", 1, 2),
             "wanted 4 angles [deg], of MCP3_FE, MCP3_AA, PIP3, DIP3, got 2 (--posture)"),
            ((*posed, "--posture", "PIP3=ten"), "wanted JOINT=degrees for 'PIP3', got 'ten'"),
            ((*posed, "--posture", "PIP3=1", "PIP3=2"), "'PIP3' is given twice"),
            ((*posed, "--frozen", "PIP3=120"),
             "joint 'PIP3' can be frozen at -15.6 .. 96.2 deg, got 120 deg (--frozen)"),
            (("pose", INDEX_MAPS),
             "subject 'valero_cuevas_index' has no joints to pose, only maps from tendon tensions "
             "to tip forces; ask tip-force or feasible-force"),
            (("tip-force", MIDDLE, "--tension", "FPD=1"),
             "no muscle 'FPD', did you mean 'FDP'? there are EDC, FDP, FDS, RI, LU, UI (--tension)"),
            (("tip-force", MIDDLE, "--tension", "FDP=-1"),
             "wanted a tension >= 0 of 'FDP', got -1 N (--tension)"),
            (("tip-force", WHOLE, "--tension", "FDP=1"),
             "choose a digit; subject 'mirakhorlo2016' has thumb, index, middle, ring, little (--digit)"),
            (("tip-force", MIDDLE, "--digit", "thumb", "--tension", "FDP=1"),
             "subject 'an_chao_middle' has no digit 'thumb'; there are middle (--digit)"),
            (("tip-force", SKEWED, "--digit", "index", "--tension", "FPL=1"),
             "no muscle of subject 'graspit_skewed_thumb' crosses a free joint of digit 'index'; "
             "digits with muscles: thumb (--digit)"),
            (("feasible-force", INDEX_MAPS, "--map", "JinvTR"),
             "digit 'index' of subject 'valero_cuevas_index' has no tip map 'JinvTR'; there are "
             "JinvT_R, fvc_hentz_2002, cadaver_hand4 (--map)"),
            (("feasible-force", INDEX_MAPS, "--posture", "PIP2=3"),
             "tip map 'JinvT_R' is for one posture of its own: "
             "it takes no posture, frozen joints, swept joints or paths (--posture)"),
            (("feasible-force", WHOLE, "--digit", "ring", "--direction", 0, 0, 0),
             None),
            (("explain", H01, "--digit", "index"),
             f"a digit, settings and paths explain subjects; '{H01}' is of kind: experiment"),
        ]
        for words, text in cases:
            with self.subTest(words=words):
                said = complaint(*words)
                self.assertTrue(said.startswith("thenar: "), said)
                self.assertNotIn("\n", said)
                if text:
                    self.assertEqual(said, "thenar: " + text)

    def test_whole_numbers_are_not_cut_off(self):
        self.assertIn("wanted a whole number, got '2.5'", complaint("tendon", "infer", H01, "--subject", SYNEK, "--propose", 2.5))
        self.assertIn("wanted a whole number, got '1e30'", complaint("pad", "press", "--force", 1, "--points", "1e30"))

    def test_unknown_largest_forces_are_named(self):
        said = complaint("feasible-force", WHOLE, "--digit", "ring", "--direction", 1, 0, 0)
        self.assertIn("EDC4", said)
        self.assertNotIn("FDP3", said)  # known, and of another finger
        self.assertIn("max_force_N", said)
        self.assertIn(WHOLE, said)


if __name__ == "__main__":
    if len(sys.argv) > 1 and not sys.argv[1].startswith("-"):
        PROGRAM = sys.argv.pop(1)
    unittest.main()

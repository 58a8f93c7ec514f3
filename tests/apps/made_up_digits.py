"""Made-up fingers and thumbs whose joint axes are tilted, and the forces that they make.

Kinematics and statics are written here anew, so that a fit of these files is judged by numbers that
do not come from its own code. Only the tilts differ from the subject that is written: the limit of
what any fit could say of them is then the posterior of the tilts alone, posterior() below.

Needs numpy.
"""
import dataclasses
import math
import pathlib
import tomllib

import numpy as np

DATA = pathlib.Path(__file__).resolve().parents[2] / "data"
NOISE = 0.03  # sd of a force component [N]
TILT_SD = 5  # of each of the two tilts of an axis [deg]
HOLD_LENGTH = 23.6  # by which the flexion moment of a clamped tip is divided [mm]
OUT_OF_PLANE = {"finger": 50, "thumb": 0}  # the same of the other two moments [mm]; 0: no such load


def turn(direction, angle):
    """Rotation about a unit vector (Rodrigues) [rad]."""
    x, y, z = direction
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + math.sin(angle) * cross + (1 - math.cos(angle)) * cross @ cross


def tangents(direction):
    """The two tilts that docs/conventions.md counts: unit vectors square to an axis."""
    x, y, z = direction
    sign = math.copysign(1, z)
    a = -1 / (sign + z)
    b = x * y * a
    return (np.array([1 + sign * x * x * a, sign * b, -sign * x]),
            np.array([b, sign + y * y * a, -y]))


@dataclasses.dataclass
class Digit:
    """A digit in its reference posture; its joints are a chain, joint j moves segment j + 1."""
    kind: str  # finger or thumb
    joints: list  # names, from the base to the tip
    directions: np.ndarray  # unit, (joints, 3)
    points: np.ndarray  # on the axes [mm] (joints, 3)
    tip: np.ndarray  # [mm] (3)
    axes: np.ndarray  # proximal, dorsal, radial of the tip in columns (3, 3)
    paths: dict = dataclasses.field(default_factory=dict)  # strand -> [(segment, point [mm])]
    arms: dict = dataclasses.field(default_factory=dict)  # strand -> arms [mm] (joints)
    muscles: dict = dataclasses.field(default_factory=dict)  # muscle -> strand
    hood: dict = dataclasses.field(default_factory=dict)  # as in the subject's file

    def tilted(self, tilts):
        """The digit with its axes tilted; tilts (joints, 2) [deg]."""
        directions = []
        for direction, (u, v) in zip(self.directions, np.radians(tilts)):
            first, second = tangents(direction)
            new = direction + u * first + v * second
            directions.append(new / np.linalg.norm(new))
        return dataclasses.replace(self, directions=np.array(directions))

    def pose(self, angles):
        """Rotation and shift of every segment in a posture, angles in [deg] (joints)."""
        R, p = np.eye(3), np.zeros(3)
        placed = [(R, p)]
        for direction, point, angle in zip(self.directions, self.points, np.radians(angles)):
            here = R @ turn(direction, angle)
            p = p + R @ point - here @ point
            R = here
            placed.append((R, p))
        return placed

    def strand_arms(self, angles):
        """-d length / d angle of every strand [mm] by differences of lengths, or as stated."""
        arms = {name: np.array(row, float) for name, row in self.arms.items()}
        for name, path in self.paths.items():
            arms[name] = np.zeros(len(self.joints))
            for j in range(len(self.joints)):
                lengths = []
                for step in (1e-3, -1e-3):  # [deg]
                    moved = np.array(angles, float)
                    moved[j] += step
                    placed = self.pose(moved)
                    at = [placed[s][0] @ p + placed[s][1] for s, p in path]
                    lengths.append(sum(np.linalg.norm(b - a) for a, b in zip(at, at[1:])))
                arms[name][j] = -(lengths[0] - lengths[1]) / math.radians(2e-3)
        return arms

    def muscle_arms(self, angles):
        """Moment arms of every muscle, its share in the hood counted [mm] (joints)."""
        strands = self.strand_arms(angles)
        arms = {muscle: strands[strand].copy() for muscle, strand in self.muscles.items()}
        for branch in self.hood.get("branches", []):
            into, central = branch["into_hood"], branch["to_central"]
            radial = {"radial": 1, "ulnar": 0, "both": 0.5}[branch["side"]]
            arms[branch["muscle"]] += into * (
                central * strands[self.hood["central_slip"]] + (1 - central) *
                (radial * strands[self.hood["radial_band"]] +
                 (1 - radial) * strands[self.hood["ulnar_band"]] +
                 strands[self.hood["terminal_slip"]]))
        return arms

    def load_torques(self, angles, hold):
        """Torque about each joint of unit loads of the held tip [mm] (joints, loads)."""
        placed = self.pose(angles)
        R, p = placed[-1]
        tip, axes = R @ self.tip + p, R @ self.axes
        rows = []
        for j, (point, direction) in enumerate(zip(self.points, self.directions)):
            before = placed[j]
            axis, on = before[0] @ direction, before[0] @ point + before[1]
            row = list(np.cross(axis, tip - on) @ axes)
            if hold == "rigid":
                moments = axis @ axes
                row.append(HOLD_LENGTH * moments[2])
                if OUT_OF_PLANE[self.kind] > 0:
                    row += list(OUT_OF_PLANE[self.kind] * moments[:2])
            rows.append(row)
        return np.array(rows)

    def forces(self, postures, trials, hold):
        """Tip force of every trial (posture, muscle, tension) along the tip's axes [N]."""
        known = {}
        for name, angles in postures.items():
            # L c = torque: least squares, least norm, or exactly, whichever applies.
            known[name] = (np.linalg.pinv(self.load_torques(angles, hold)),
                           self.muscle_arms(angles))
        return np.array([(known[posture][0] @ known[posture][1][muscle] * tension)[:3]
                         for posture, muscle, tension in trials])


def middle_finger():
    """The middle finger of data/subjects/synek2019_middle.toml, read here by itself."""
    file = tomllib.loads((DATA / "subjects/synek2019_middle.toml").read_text())
    joints = file["joint"]
    order = [file["base"]] + [joint["child"] for joint in joints]
    frames = {frame["name"]: frame for frame in file["frame"]}
    length = file["reference_length_mm"]
    paths = {}
    for strand in file["strand"]:
        paths[strand["name"]] = [
            (order.index(frames[p["frame"]]["segment"]),
             np.array(frames[p["frame"]]["origin_mm"]) + length * np.array(p["point_ratio"]))
            for p in strand["path"]]
    digit = file["digit"][0]
    return Digit("finger", [j["name"] for j in joints],
                 np.array([j["direction"] for j in joints], float),
                 np.array([j["point_mm"] for j in joints]), np.array(digit["tip_mm"], float),
                 np.array([digit["proximal"], digit["dorsal"], digit["radial"]], float).T, paths,
                 {}, {m["name"]: m.get("strand", m["name"]) for m in file["muscle"]}, digit["hood"])


def skew_thumb(rng):
    """The thumb of data/subjects/arms_five_axis_thumb.toml, its CMC axes 60 to 110 deg apart."""
    file = tomllib.loads((DATA / "subjects/arms_five_axis_thumb.toml").read_text())
    joints = file["joint"]
    directions = np.array([j["direction"] for j in joints])
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    apart = math.radians(rng.uniform(60, 110))
    across = directions[1] - (directions[1] @ directions[0]) * directions[0]
    directions[1] = (math.cos(apart) * directions[0] +
                     math.sin(apart) * across / np.linalg.norm(across))
    digit = file["digit"][0]
    names = [j["name"] for j in joints]
    arms = {s["name"]: [s["arms_mm"].get(name, 0) for name in names] for s in file["strand"]}
    return Digit("thumb", names, directions, np.array([j["point_mm"] for j in joints], float),
                 np.array(digit["tip_mm"]),
                 np.array([digit["proximal"], digit["dorsal"], digit["radial"]]).T, {}, arms,
                 {m["name"]: m.get("strand", m["name"]) for m in file["muscle"]})


# What is loaded, in the order in which muscles are taken [N].
LOADS = {"finger": {"FDP": 7.8, "FDS": 7.8, "RI": 5.3, "UI": 4.1, "EDC": 3.3, "LU": 2},
         "thumb": {"FPL": 8, "EPL": 6, "APB": 8, "ADPt": 8, "OPP": 8, "FPB": 8}}
# Angles of postures [deg]; with four or five joints.
RANGES = {"finger": [(-10, 60), (-10, 10), (20, 70), (10, 50)],
          "thumb": [(-30, 15), (-20, 20), (-10, 40), (-10, 10), (0, 50)]}


@dataclasses.dataclass
class MadeUp:
    """A digit as it is known, its true tilts, and the forces that were measured."""
    digit: Digit
    tilts: np.ndarray  # [deg] (joints, 2)
    postures: dict
    trials: list
    hold: str
    forces: np.ndarray  # [N] (trials, 3)

    def posterior(self):
        """Covariance of the tilts where all else is known, linear about the truth [deg^2]."""
        J = []
        for k in range(self.tilts.size):
            step = np.zeros(self.tilts.size)
            step[k] = 0.01
            step = step.reshape(self.tilts.shape)
            ahead, back = (self.digit.tilted(self.tilts + s).forces(
                self.postures, self.trials, self.hold).ravel() for s in (step, -step))
            J.append((ahead - back) / 0.02)
        J = np.array(J).T / NOISE
        return np.linalg.inv(J.T @ J + np.eye(self.tilts.size) / TILT_SD**2)


def make_up(kind, count, seed, hold="rigid"):
    """A finger or a thumb with `count` forces: six muscles, one at a time, in postures."""
    rng = np.random.default_rng([count, seed, kind == "thumb"])
    digit = skew_thumb(rng) if kind == "thumb" else middle_finger()
    tilts = TILT_SD * rng.standard_normal((len(digit.joints), 2))
    muscles = LOADS[kind]
    postures = {f"p{i}": [round(rng.uniform(*r), 1) for r in RANGES[kind]]
                for i in range(count // len(muscles))}
    trials = [(posture, muscle, tension) for posture in postures
              for muscle, tension in muscles.items()]
    forces = digit.tilted(tilts).forces(postures, trials, hold)
    forces += NOISE * rng.standard_normal(forces.shape)
    return MadeUp(digit, tilts, postures, trials, hold, forces)


def vector(values):
    return "[" + ", ".join(repr(float(v)) for v in values) + "]"


def subject_text(digit):
    """The digit as a subject file: as it is known, without its tilts."""
    names = ["MC"] + [f"S{j + 1}" for j in range(len(digit.joints))]
    text = [f'name = "made_up_{digit.kind}"', 'side = "right"', 'base = "MC"', 'source = "Made"',
            "[sources]", 'Made = "Made up"']
    ends = list(digit.points) + [digit.tip]
    for j, name in enumerate(names):
        text += ["[[segment]]", f'name = "{name}"', f"proximal_mm = {vector(ends[max(j - 1, 0)])}",
                 f"distal_mm = {vector(ends[j])}"]
    for j, joint in enumerate(digit.joints):
        text += ["[[joint]]", f'name = "{joint}"', f'parent = "{names[j]}"',
                 f'child = "{names[j + 1]}"', f"direction = {vector(digit.directions[j])}",
                 f"point_mm = {vector(digit.points[j])}", "range_deg = [-90, 120]"]
    for strand, path in digit.paths.items():
        points = ", ".join(f'{{segment = "{names[s]}", point_mm = {vector(p)}}}' for s, p in path)
        text += ["[[strand]]", f'name = "{strand}"', f"path = [{points}]"]
    for strand, arms in digit.arms.items():
        row = ", ".join(f"{j} = {float(a)!r}" for j, a in zip(digit.joints, arms) if a != 0)
        text += ["[[strand]]", f'name = "{strand}"', f"arms_mm = {{{row}}}"]
    for muscle, strand in digit.muscles.items():
        text += ["[[muscle]]", f'name = "{muscle}"', f'strand = "{strand}"']
    text += ["[[digit]]", f'name = "{"thumb" if digit.kind == "thumb" else "middle"}"',
             f'tip_segment = "{names[-1]}"', f"tip_mm = {vector(digit.tip)}"]
    text += [f"{name} = {vector(digit.axes[:, k])}"
             for k, name in enumerate(("proximal", "dorsal", "radial"))]
    if digit.hood:
        text.append("[digit.hood]")
        text += [f'{key} = "{digit.hood[key]}"'
                 for key in ("central_slip", "radial_band", "ulnar_band", "terminal_slip")]
        rows = ", ".join(f'{{muscle = "{b["muscle"]}", side = "{b["side"]}", into_hood = '
                         f'{b["into_hood"]}, to_central = {b["to_central"]}}}'
                         for b in digit.hood["branches"])
        text.append(f"branches = [{rows}]")
    return "\n".join(text) + "\n"


def experiment_text(made, noise=NOISE):
    """The measured forces as an experiment file, their noise stated as `noise` [N]."""
    digit = made.digit
    text = ['name = "made_up"', f'digit = "{"thumb" if digit.kind == "thumb" else "middle"}"',
            'source = "Made"', "[sources]", 'Made = "Made up"', "[protocol]",
            f'hold = "{made.hold}"', "[force]", f'segment = "S{len(digit.joints)}"',
            'components = ["proximal", "dorsal", "radial"]', "[noise]", f"floor_N = {noise!r}"]
    for name, angles in made.postures.items():
        row = ", ".join(f"{j} = {float(a)!r}" for j, a in zip(digit.joints, angles))
        text += ["[[posture]]", f'name = "{name}"', f"angles_deg = {{{row}}}"]
    text += ["[trials]", "rows = ["]
    text += [f'{{posture = "{posture}", tension_N = {{{muscle} = {float(tension)!r}}}, '
             f"force_N = {vector(force)}}},"
             for (posture, muscle, tension), force in zip(made.trials, made.forces)]
    return "\n".join([*text, "]\n"])

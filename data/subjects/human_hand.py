"""Makes human_hand.toml from mirakhorlo2016.toml: python3 human_hand.py > human_hand.toml (numpy)

One specimen's hand, its thumb moved as little as its doubt allows towards what others measured. Unknowns
are the axes of the thumb's four joints and the path points of its muscles on the hand, their priors those
of data/fits/thumb.toml; data are moment arms at the neutral posture, each with the sd of the same file.
Nothing else is fitted.
"""
import pathlib
import re
import tomllib

import numpy as np

HEAD = """\
# The hand of comparisons: one specimen's [Mirakhorlo2016], with a thumb calibrated on moment arms of others.
#
# Written by human_hand.py from mirakhorlo2016.toml, which says what is not said here: frame, posture,
# inertia, paths, surfaces and fingers are those of the specimen.
# Thumb     Neutral is CMC1_FE={0:.1f}, CMC1_AA={1:.1f}, MCP1_FE={2:.1f}, IP1={3:.1f} deg: metacarpal I
#           points as in the ARMS thumb [McFarland2023], MCP and IP are straight.
# Axes      Helical axes, none of ab-adduction at the MCP joint. They moved within their priors, as did
# and paths the path points of the thumb's muscles on the hand, until moment arms about neutral were as
#           near to those of other sources as their sds allow. Both are those of data/fits/thumb.toml:
#           directions 10 deg and points 3 mm, with 6 deg and 2 mm between people; arms 1.5 mm of FPL and
#           EPL, 6 mm of the thenar muscles and 17 mm of the adductor about the CMC joint, 2.5 mm
#           beyond. Lines of broad muscles may lie anywhere on their patches. Away from neutral, arms
#           change as the paths do.
# Arms      [Smutz1998] in seven hands, as [Nakajima2022] has them, but for the abduction arm of FPB
#           (+10.5 mm there; Smutz found an adductor); and straight lines of [McFarland2023], but for
#           the adductor, whose lines run through the CMC joint without the model's wrapping. APL and
#           DI1_MC1 have no data: their lines are the specimen's, about axes that moved.
# Forces    Of no fingertip were any used: neither single tendons' nor pinch strength nor blocks.
# F0        Wrist [MyoHand], whose ECU and FCR are those of [McFarland2023]; else as in the specimen's file.
# Ranges    Of the thumb, from neutral. CMC [MyoHand], whose axes are those of [McFarland2023]: 73 and 85
#           deg in all, where others measured 53 and 42 [Cooney1981]. MCP [ThumbMcpRange]: means of 300
#           hands. IP [EHand].
# Passive   moments as in the specimen's file; the thumb's rest is told from neutral.
# Tip       Of the thumb: the middle of its pad, four tenths of the distal phalanx before its end, on the
#           bone's line. Thumbs press with their pads; fingers keep the end of the bone.

name = "human_hand"
description = "Whole right hand: a specimen's, its thumb calibrated on published moment arms"
side = "right"
base = "Radius"
source = "Mirakhorlo2016"

[sources]
Fit = "Calibrated: see above, Axes and paths. Mirakhorlo2016, Smutz1998, Nakajima2022, McFarland2023"
PassiveGuess = "Judgement: no measurement was found; spread is how far it may be off"

"""

HERE = pathlib.Path(__file__).parent
TEXT = (HERE / "mirakhorlo2016.toml").read_text()
SPECIMEN = tomllib.loads(TEXT)
JOINTS = ["CMC1_FE", "CMC1_AA", "MCP1_FE", "IP1"]
MUSCLES = ["FPL", "EPL", "EPB", "APL", "APB", "FPBs", "FPBd", "OPP", "ADPt", "ADPo", "DI1_MC1"]
WRIST_F0 = {"ECRL": 337.3, "ECRB": 252.2, "ECU": 192.9, "PL": 101.0, "FCU": 479.8, "FCR": 407.9}  # [N]
DIGITS = 2  # of the numbers that are written, as of those read [mm, parts of a unit direction / 100]

# Prior sds: root of the squares of a specimen's own doubt and of the spread between people.
DIRECTION_SD = np.radians(np.hypot(10, 6))  # [rad]
POINT_SD = np.hypot(3, 2)                   # of axes and of path points [mm]
# A broad muscle is one line from the middle of its patch. Where its fibres really pull from is as doubtful
# as an even spread over the patch: half its length over sqrt(3). By muscle and point, [mm].
PATCH = {("APB", 1): 12, ("OPP", 0): 17, ("OPP", 1): 6, ("ADPt", 1): 15, ("ADPo", 1): 3.5}

# Moment arms [mm] about CMC1_FE, CMC1_AA, MCP1_FE and IP1; None: not told. After [Smutz1998], of seven
# hands, as [Nakajima2022] has them; its abduction arm of FPB, +10.5, is left out, as Smutz found an
# adductor. Straight lines of the ARMS thumb [McFarland2023]; its adductor is left out, as its lines
# without the model's wrapping run through the CMC joint. Sources do not part the heads of FPB.
SMUTZ = {"FPL": (14.3, 0.2, 13.6, 8.7), "EPL": (-8.1, -9.5, -8.5, -4.1),
         "APB": (-3.9, 16.5, 2.6, None), "FPBs": (13.4, None, 8.8, None),
         "FPBd": (13.4, None, 8.8, None), "OPP": (12.9, 4.8, None, None),
         "ADPt": (36.9, -20.6, 9.7, None), "ADPo": (27.0, -17.0, 8.2, None)}
ARMS = {"FPL": (15.6, 0, 10.9, 6.3), "EPL": (-8.6, -9.0, -7.6, -5.2),
        "EPB": (-14.8, 3.0, -6.4, None), "APB": (-3.7, 6.0, -3.0, None),
        "FPBs": (5.5, -1.8, 5.7, None), "FPBd": (5.5, -1.8, 5.7, None),
        "OPP": (4.1, 1.2, None, None)}
DATA = [(muscle, joint, arm) for table in (SMUTZ, ARMS) for muscle, row in table.items()
        for joint, arm in enumerate(row) if arm is not None]

# Where passive moments of the thumb vanish, from neutral [deg]; as in the specimen's file.
REST = (0, 0, 15, 15)

# Bones of the ARMS thumb, the first straight out from the CMC joint in its neutral posture.
NEUTRAL_MC1 = np.array([16.5, -29.2, -12.7])
# Neutral flexion and abduction are averaged over: arms were measured over ranges of motion [deg].
ABOUT_NEUTRAL = (0, 15, -15)


def arm_sd(muscle, joint):
    """Of data/fits/thumb.toml [mm]."""
    if muscle in ("FPL", "EPL"):
        return 1.5
    if muscle == "EPB":
        return 4
    if joint >= 2:
        return 2.5
    return 17 if muscle.startswith("ADP") else 6


def named(kind, name):
    return next(each for each in SPECIMEN[kind] if each["name"] == name)


def unit(v):
    return np.asarray(v, float) / np.linalg.norm(v)


def turn(axis, angle):
    x, y, z = axis
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


def tangents(axis):
    first = unit(np.cross(axis, [0, 0, 1]))
    return first, np.cross(axis, first)


# How many of JOINTS move a segment; the wrist stands still.
MOVED_BY = {"CMC1_link": 1, "MC1": 2, "PP1": 3, "DP1": 4}
AXES = [(unit(named("joint", name)["direction"]) * named("joint", name).get("direction_sign", 1),
         np.array(named("joint", name)["point_mm"], float)) for name in JOINTS]
PATHS = {muscle: [(MOVED_BY.get(point["segment"], 0), np.array(point["point_mm"], float), point)
                  for point in named("strand", muscle)["path"] if "segment" in point]
         for muscle in MUSCLES}
ON_HAND = ("Palm", "MC2", "MC3", "MC1", "PP1", "DP1")
FREE = [(muscle, k) for muscle in MUSCLES for k, (_, _, point) in enumerate(PATHS[muscle])
        if point["segment"] in ON_HAND]
SD = [np.hypot(POINT_SD, PATCH.get(key, 0) / np.sqrt(3)) for key in FREE]
FIRST = 4 * len(JOINTS)  # path points stand after the axes


def unpack(u):
    """Axes and path points from unknowns in units of their sds."""
    axes = []
    for j, (direction, point) in enumerate(AXES):
        a, b = tangents(direction)
        c = u[4 * j:4 * j + 4]
        axes.append((unit(direction + DIRECTION_SD * (c[0] * a + c[1] * b)),
                     point + POINT_SD * (c[2] * a + c[3] * b)))
    paths = {muscle: [(moved, p) for moved, p, _ in PATHS[muscle]] for muscle in MUSCLES}
    for i, (muscle, k) in enumerate(FREE):
        moved, p = paths[muscle][k]
        paths[muscle][k] = (moved, p + SD[i] * u[FIRST + 3 * i:FIRST + 3 * i + 3])
    return axes, paths


def arms_at(axes, path, q):
    """Moment arms -dL/dq of a straight path [mm] (4)."""
    turns, shifts, now = [np.eye(3)], [np.zeros(3)], []
    for (direction, point), angle in zip(axes, q):
        R, p = turns[-1], shifts[-1]
        now.append((R @ direction, R @ point + p))
        r = turn(direction, angle)
        turns.append(R @ r)
        shifts.append(R @ (point - r @ point) + p)
    places = [(moved, turns[moved] @ p + shifts[moved]) for moved, p in path]
    arms = np.zeros(4)
    for (m0, p0), (m1, p1) in zip(places, places[1:]):
        along = unit(p0 - p1)
        for j, (direction, point) in enumerate(now):
            speed = (np.cross(direction, p0 - point) if m0 > j else 0) - (
                np.cross(direction, p1 - point) if m1 > j else 0)
            arms[j] -= along @ (np.zeros(3) + speed)
    return arms


def mean_arms(axes, path, neutral):
    return np.mean([arms_at(axes, path, neutral + np.radians([0, more, 0, 0]))
                    for more in ABOUT_NEUTRAL], 0)


def bone(name):
    segment = named("segment", name)
    return unit(np.subtract(segment["distal_mm"], segment["proximal_mm"]))


def bend(axis, before, after):
    """By how much bones are flexed about an axis as digitised [rad]."""
    a, b = (unit(v - v @ axis * axis) for v in (before, after))
    return np.arctan2(np.cross(a, b) @ axis, a @ b)


def neutral_of(axes):
    """Where the metacarpal points as in the ARMS thumb, MCP and IP straight [rad] (4)."""
    (flexion, _), (abduction, _) = axes[:2]
    q = np.radians([0, 35.0])
    for _ in range(50):  # Newton's method on both angles, by least squares
        f = lambda x: turn(flexion, x[0]) @ turn(abduction, x[1]) @ bone("MC1") - unit(NEUTRAL_MC1)
        J = np.stack([(f(q + 1e-6 * e) - f(q - 1e-6 * e)) / 2e-6 for e in np.eye(2)], 1)
        q = q - np.linalg.lstsq(J, f(q), rcond=None)[0]
    assert np.linalg.norm(f(q)) < 1e-9
    return np.array([*q, -bend(axes[2][0], bone("MC1"), bone("PP1")),
                     -bend(axes[3][0], bone("PP1"), bone("DP1"))])


def misfit(arms):
    return np.array([(arms[muscle][joint] - arm) / arm_sd(muscle, joint)
                     for muscle, joint, arm in DATA])


def solve(neutral):
    """The least sum of squares of unknowns and misfits: Levenberg and Marquardt's method."""
    u, damping = np.zeros(FIRST + 3 * len(FREE)), 1e-2

    def arms_of(u, only=None):
        axes, paths = unpack(u)
        return {m: mean_arms(axes, paths[m], neutral) for m in only or MUSCLES}

    for _ in range(200):
        arms = arms_of(u)
        r = np.concatenate([u, misfit(arms)])
        J = np.zeros((r.size, u.size))
        J[:u.size] = np.eye(u.size)
        for i in range(u.size):
            step = 1e-5 * np.eye(u.size)[i]
            only = None if i < FIRST else [FREE[(i - FIRST) // 3][0]]
            ahead, behind = (misfit({**arms, **arms_of(u + s, only)}) for s in (step, -step))
            J[u.size:, i] = (ahead - behind) / 2e-5
        slope = J.T @ r
        if np.abs(slope).max() < 1e-6:
            return u
        while True:
            trial = u - np.linalg.solve(J.T @ J + damping * np.eye(u.size), slope)
            left = np.concatenate([trial, misfit(arms_of(trial))])
            if left @ left < r @ r or damping > 1e8:
                break
            damping *= 4
        u, damping = trial, damping / 4
    raise RuntimeError("the fit does not settle")


def numbers(v, digits=DIGITS):
    return "[" + ", ".join(f"{x + 0:.{digits}f}".rstrip("0").rstrip(".") for x in v) + "]"


def replaced(text, kind, name, block):
    """The text with another table of that name in place of its own."""
    pattern = rf'\[\[{kind}\]\]\nname = "{name}"(?:\n[^\n]+)*'
    text, count = re.subn(pattern, lambda _: block, text)
    assert count == 1, (kind, name)
    return text


def joint_text(name, axis, reach, at, source):
    joint = named("joint", name)
    return "\n".join([
        "[[joint]]", f'name = "{name}"', f'parent = "{joint["parent"]}"', f'child = "{joint["child"]}"',
        f"direction = {numbers(axis[0], 4)}", f"point_mm = {numbers(axis[1])}",
        f"range_deg = {numbers(np.add(reach, at), 1)}"
        f"  # {reach[0]} .. {reach[1]} from neutral, at {at:.1f} deg",
        f'source = ["Fit", "{source}"]'])


def strand_text(muscle, path):
    rows, inner = [], iter(path)
    for point in named("strand", muscle)["path"]:
        where, p = (("segment", next(inner)[1]) if "segment" in point else
                    ("surface", point["side_mm"]))
        key = "point_mm" if where == "segment" else "side_mm"
        rows.append(f'  {{{where} = "{point[where]}", {key} = {numbers(p)}}},')
    return "\n".join(["[[strand]]", f'name = "{muscle}"', 'source = "Fit"', "path = [", *rows, "]"])


def thumb_digit():
    thumb, bone = named("digit", "thumb"), named("segment", "DP1")
    pad = np.add(bone["proximal_mm"], 0.6 * np.subtract(bone["distal_mm"], bone["proximal_mm"]))
    return "\n".join(["[[digit]]", 'name = "thumb"', 'tip_segment = "DP1"',
                      f"tip_mm = {numbers(pad)}",
                      *(f"{key} = {thumb[key]}" for key in ("proximal", "dorsal", "radial"))])


def main():
    # The neutral posture hangs on the axes: three rounds settle it to 0.1 deg.
    axes = AXES
    for _ in range(3):
        neutral = neutral_of(axes)
        axes, paths = unpack(solve(neutral))
    neutral = np.degrees(neutral_of(axes))
    # Ranges about neutral [deg] and their sources.
    reach = ([-44.7, 28.6], [-44.7, 40.1], [-7.9, 59.1], [-15, 80])
    sources = ("MyoHand", "MyoHand", "ThumbMcpRange", "EHand")
    text = TEXT[TEXT.index("[lengths]"):].rstrip()
    for j, name in enumerate(JOINTS):
        text = replaced(text, "joint", name,
                        joint_text(name, axes[j], reach[j], neutral[j], sources[j]))
        text, count = re.subn(rf'(joints = \["{name}"\]\nrest_deg = )\[[^]]*\]',
                              rf"\g<1>{numbers([neutral[j] + REST[j]], 1)}", text)
        assert count == 1, name
    for muscle in MUSCLES[:-1]:  # nothing is known of the last, which stays as it is
        text = replaced(text, "strand", muscle, strand_text(muscle, paths[muscle]))
    for name, force in WRIST_F0.items():
        text = replaced(text, "muscle", name,
                        f'[[muscle]]\nname = "{name}"\nmax_force_N = {force}\nsource = "MyoHand"')
    text = replaced(text, "digit", "thumb", thumb_digit())
    print(HEAD.format(*neutral).replace("[sources]", text[:text.index("[[segment]]")] + "[sources]")
          + text[text.index("[[segment]]"):])


if __name__ == "__main__":
    main()

"""Prints a hash of the numbers of many answers, to compare two builds of the program to the last bit.

  python3 tests/answer_hashes.py build/release/bin/thenar [-o hashes.json] [--against hashes.json] [--only WORD]

A change that moves code and no number leaves every hash as it is. Times, dates, commits and the words
of the command line are left out.
"""
import argparse
import hashlib
import json
import pathlib
import re
import subprocess
import sys
import tempfile

SCENES = """ball_on_ball coin_draw falling_ball incline_slide incline_stick loose_joint key_turn newtons_cradle
pendulum spinning_top stack swinging_pinch mug_lift pencil_pinch pinch human_cylinder""".split()
# Scenes whose whole takes long, and how much of them is enough [s].
LONG_SCENES = {"ball_catch": 0.3, "mug_pads": 0.05, "soft_jaws": 0.05, "thumb_key": 0.02, "thumb_mug": 0.02,
               "wine_glass": 0.1}
PRESSES = {"plane": "1", "sphere": "1", "edge": "0.5", "cylinder": "1"}  # objects, and how deep [mm]


def commands():
    """Names of answers, and the arguments that ask for them."""
    for scene in SCENES:
        yield f"simulate {scene}", ["simulate", scene, "-o", "OUT.csv"]
        if scene in ("coin_draw", "incline_slide", "stack", "newtons_cradle", "loose_joint"):
            yield f"simulate {scene} fixed steps", ["simulate", scene, "--method", "time-stepping", "-o", "OUT.csv"]
    for scene, seconds in LONG_SCENES.items():
        yield f"simulate {scene}", ["simulate", scene, "--seconds", str(seconds), "-o", "OUT.csv"]
    yield "simulate finger", ["simulate", "an_chao_index", "--net", "chao_an", "--excitation", "FDP=0.1", "EDC=0.1",
                              "--seconds", "0.1", "-o", "OUT.csv"]
    for shape, depth in PRESSES.items():
        for friction in ("0", "0.5"):
            yield (f"press {shape} {friction}",
                   ["pad", "press", "--object", shape, "--friction", friction, "--depth", depth, "--max-elements", "700",
                "-o", "OUT.json"])
    yield "press force", ["pad", "press", "--force", "1", "-o", "OUT.json"]
    yield "press fitted", ["pad", "press", "--pad", "index_fitted", "--force", "1", "-o", "OUT.json"]
    yield "fit two", ["fit", "synek2019_H01", "synek2019_H02", "--subject", "an_chao_middle", "-o", "OUT.json"]
    yield "fit net", ["fit", "synek2019_H01", "--subject", "an_chao_middle", "--net", "winslow", "-o", "OUT.json"]
    yield "fit rigid", ["fit", "synek2019_H01", "--subject", "synek2019_middle", "-o", "OUT.json"]
    yield ("posterior", ["fit", "synek2019_H01", "--subject", "synek2019_middle", "--method", "mcmc", "--draws", "100",
                         "-o", "OUT.nc", "--json"])
    for world in ("barrett_bobbin", "jaw_box"):
        yield f"grasp {world}", ["grasp", world, "-o", "OUT.json"]
        yield f"grasp {world} random", ["grasp", world, "--random", "5", "--seed", "2", "-o", "OUT.json"]
    yield "quality", ["quality", "data/contacts/two_soft_fingers.json", "--json"]
    yield "compare", ["compare", "--hands", "barrett", "human", "--objects", "sphere_70", "can", "-o", "OUT.json"]
    for net in ("chao_an", "winslow"):
        yield (f"tendons {net}", ["tendon", "solve", "an_chao_index", "--net", net, "--posture", "MCP2_FE=20", "PIP2=30",
                                  "--tension", "EDC=2.9", "-o", "OUT.json"])
    yield "tip force", ["tip-force", "an_chao_index", "--tension", "FDP=10", "--json"]
    for subject, digit in (("an_chao_index", "index"), ("mirakhorlo2016", "thumb"), ("human_hand", "index")):
        yield f"moment arms {subject}", ["moment-arms", subject, "--digit", digit, "--json"]
        yield f"feasible force {subject}", ["feasible-force", subject, "--digit", digit, "--json"]


TOLD = re.compile(r"seconds|_ms$|^ms|date|commit|version|command|machine|program|host|started|wall|cpu|threads|made_by|sha256"
                  r"|rate_per_s|per_second|bytes|memory|advice|^request$", re.I)


def numbers_of(value):
    """The value without what differs from run to run."""
    if isinstance(value, dict):
        return {k: numbers_of(v) for k, v in value.items() if not TOLD.search(k)}
    if isinstance(value, list):
        return [numbers_of(v) for v in value]
    return value


def hash_of(program, arguments):
    """Hash of an answer and the exit code, or what went wrong."""
    with tempfile.TemporaryDirectory() as folder:
        out = None
        arguments = list(arguments)
        for i, word in enumerate(arguments):
            if word.startswith("OUT."):
                out = pathlib.Path(folder) / word
                arguments[i] = str(out)
        ran = subprocess.run([program, *arguments], capture_output=True, text=True)
        printed = out is None or out.suffix == ".nc"
        text = ran.stdout if printed else out.read_text() if out.exists() else ""
        if not text:
            return f"no answer, exit {ran.returncode}: {ran.stderr.strip()[-160:]}"
        if not printed and out.suffix == ".csv":
            text = "\n".join(line for line in text.splitlines() if not line.startswith("#"))
        else:
            text = json.dumps(numbers_of(json.loads(text)), sort_keys=True)
        return f"{hashlib.sha256(text.encode()).hexdigest()[:16]} {len(text)} exit {ran.returncode}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("-o", "--out")
    parser.add_argument("--against")
    parser.add_argument("--only", default="")
    asked = parser.parse_args()
    program = str(pathlib.Path(asked.program).resolve())
    before = json.loads(pathlib.Path(asked.against).read_text()) if asked.against else {}
    hashes = {}
    changed = 0
    for name, arguments in commands():
        if asked.only not in name:
            continue
        hashes[name] = hash_of(program, arguments)
        differs = name in before and before[name] != hashes[name]
        changed += differs
        print(f"{'CHANGED ' if differs else ''}{name}: {hashes[name]}", flush=True)
        if asked.out:
            pathlib.Path(asked.out).write_text(json.dumps(hashes, indent=1) + "\n")
    if before:
        print(f"{changed} of {len(hashes)} answers changed")
    return 1 if changed else 0


if __name__ == "__main__":
    sys.exit(main())

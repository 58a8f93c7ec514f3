"""A folder may include only from floors below it. Run from the repository root."""
import pathlib
import re
import sys

MAY_SEE = {
    "base": [],
    "data/io": ["base"],
    "hand": ["base", "data/io"],
    "tendons": ["base", "data/io", "hand"],
    "kinematics_fit": ["base", "data/io", "hand", "tendons"],
    "grasp": ["base", "data/io", "hand/hand.h", "hand/multibody.h"],  # the interface, and nothing else of hand/
}

bad = []
for folder, below in MAY_SEE.items():
    for path in sorted(pathlib.Path(folder).rglob("*")):
        if path.suffix not in (".h", ".cpp"):
            continue
        for line, text in enumerate(path.read_text().splitlines(), 1):
            found = re.match(r'#include "([^"]+)"', text)
            if found and not found[1].startswith(tuple([folder + "/"] + below)):
                bad.append(f"{path}:{line}: {folder} may not include {found[1]}")
print("\n".join(bad))
sys.exit(bool(bad))

"""Every citation in code and documentation is an entry of data/sources.bib.

A citation is a bracketed key: [Murray1994], [An1983, Synek2019 eq. 3], [GraspIt]. Sources that
data files name in their `source` keys are checked by the reader. Run from the repository root.
"""
import pathlib
import re
import sys

FOLDERS = ["base", "solvers", "dynamics", "geometry", "sampling", "data", "hand", "tendons", "kinematics_fit", "posterior",
           "grasp", "viewer", "apps", "bench", "tests", "docs", "README.md", "CONTRIBUTING.md", "CHANGELOG.md"]
ENDINGS = (".h", ".cpp", ".md", ".toml", ".py")
BRACKETS = re.compile(r"\[([A-Z][^\[\]]*)\](?!\()")  # but no markdown link
YEAR_KEY = re.compile(r"\b[A-Z][A-Za-z]+(?:19|20)\d\d[a-z]?\b")

known = re.findall(r"^@\w+\{([^,\s]+),", pathlib.Path("data/sources.bib").read_text(), re.M)
bad = sorted(f"data/sources.bib: {key} stands twice" for key in set(known) if known.count(key) > 1)
for folder in map(pathlib.Path, FOLDERS):
    for path in sorted(folder.rglob("*")) if folder.is_dir() else [folder]:
        if path.suffix not in ENDINGS or not path.is_file() or "node_modules" in path.parts:
            continue
        text = path.read_text()
        own = re.findall(r"^(\w+) *= *\"", text, re.M)  # a data file's own [sources]
        for line, words in enumerate(text.splitlines(), 1):
            for bracket in BRACKETS.findall(words):
                for key in YEAR_KEY.findall(bracket):
                    if key not in known and key not in own:
                        bad.append(f"{path}:{line}: [{key}] is not in data/sources.bib")
print("\n".join(bad))
sys.exit(bool(bad))

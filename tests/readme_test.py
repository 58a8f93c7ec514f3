"""Programs in README.md and docs/cpp.md are those of examples/, without the comments at their heads; README.md is short."""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PROGRAMS = {"README.md": 1, "docs/cpp.md": 2}
MAX_LINES = 120  # of README.md: the rest is in docs/


def main():
    programs = {re.sub(r"\A(//.*\n)+", "", f.read_text()) for f in (ROOT / "examples").glob("*.cpp")}
    for page, count in PROGRAMS.items():
        shown = re.findall(r"^```cpp\n(.*?)^```$", (ROOT / page).read_text(), re.M | re.S)
        if len(shown) != count:
            sys.exit(f"{page}: wanted {count} programs, got {len(shown)}")
        for program in shown:
            if program not in programs:
                sys.exit(f"{page}: this program is none of examples/\n{program}")
    lines = len((ROOT / "README.md").read_text().splitlines())
    if lines > MAX_LINES:
        sys.exit(f"README.md: wanted at most {MAX_LINES} lines, got {lines}")


main()

"""Programs in README.md are those of examples/, without the comments at their heads."""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def main():
    shown = re.findall(r"^```cpp\n(.*?)^```$", (ROOT / "README.md").read_text(), re.M | re.S)
    programs = {re.sub(r"\A(//.*\n)+", "", f.read_text()) for f in (ROOT / "examples").glob("*.cpp")}
    if len(shown) != 2:
        sys.exit(f"README.md: wanted 2 programs, got {len(shown)}")
    for program in shown:
        if program not in programs:
            sys.exit(f"README.md: this program is none of examples/\n{program}")


main()

"""A tutorial does what it says: tutorials_test.py TUTORIAL.md THENAR.

Its fenced blocks are run in order in an empty folder: ```toml file=NAME (or xml, csv) writes a file, ```sh
runs commands, which must succeed, and ```text holds lines that the last commands printed, in their order;
"..." stands for lines left out. Words must be the same; a number may differ by one unit of its last digit,
which is what compilers and processors differ by, and the time that a fit took by anything.
"""

import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

FENCE = re.compile(r"^```(\w+)(?: file=(\S+))?\n(.*?)^```$", re.M | re.S)
SECONDS = re.compile(r"(?<=evaluations, )\d+\.\d+ s\b")
NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[+-]?\d+)?")


def unit(number):
    """One unit of the last digit: of 12.5 it is 0.1."""
    mantissa, _, power = number.partition("e")
    return 10.0 ** (int(power or 0) - len(mantissa.partition(".")[2]))


def same(wanted, got):
    """Whether two lines agree: words exactly, however wide their columns are, and numbers but for a unit."""
    wanted, got = (SECONDS.sub("some s", line) for line in (wanted, got))
    words = [" ".join(NUMBER.sub("#", line).split()) for line in (wanted, got)]
    if words[0] != words[1]:
        return False
    pairs = zip(NUMBER.findall(wanted), NUMBER.findall(got))
    return all(abs(float(a) - float(b)) <= 1.001 * unit(a) for a, b in pairs)


def first_missing(quoted, printed):
    """The first quoted line that is not where it should be; None if all are there."""
    at, anywhere = 0, True
    for line in filter(str.strip, quoted):
        if line.strip() == "...":
            anywhere = True
            continue
        rest = [i for i in range(at, len(printed)) if printed[i].strip()]
        found = [i for i in (rest if anywhere else rest[:1]) if same(line, printed[i])]
        if not found:
            return line
        at, anywhere = found[0] + 1, False
    return None


def main():
    tutorial, thenar = Path(sys.argv[1]), Path(sys.argv[2])
    printed, commands = [], 0
    with tempfile.TemporaryDirectory() as folder:
        environment = {**os.environ, "PATH": f"{thenar.parent}:{os.environ['PATH']}",
                       "XDG_CACHE_HOME": f"{folder}/.cache"}
        for kind, name, body in FENCE.findall(tutorial.read_text()):
            if name:
                Path(folder, name).write_text(body)
            elif kind == "sh":
                run = subprocess.run(["bash", "-euo", "pipefail", "-c", body], cwd=folder, env=environment,
                                     stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
                printed, commands = run.stdout.splitlines(), commands + 1
                if run.returncode:
                    sys.exit(f"{tutorial.name}: exit code {run.returncode} of\n{body}\n{run.stdout}")
            elif kind == "text":
                if (line := first_missing(body.splitlines(), printed)) is not None:
                    sys.exit(f"{tutorial.name}: wanted the line\n{line}\ngot\n" + "\n".join(printed))
            else:
                sys.exit(f"{tutorial.name}: wanted a block of sh or text, or one with file=NAME, got {kind}")
    if not commands:
        sys.exit(f"{tutorial.name}: no commands")
    print(f"{tutorial.name}: {commands} blocks of commands")


main()

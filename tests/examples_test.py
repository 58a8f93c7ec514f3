"""An example prints what its head says: examples_test.py SOURCE PROGRAM."""

import subprocess
import sys
from pathlib import Path


def promised(source):
    """Lines of the first comment below "Prints:"."""
    head = source.split("\n#include", 1)[0].splitlines()
    if "// Prints:" not in head:
        sys.exit("wanted a line '// Prints:' in the head")
    return [line[5:] for line in head[head.index("// Prints:") + 1:]]


def main():
    source, program = Path(sys.argv[1]), sys.argv[2]
    text = source.read_text()
    lines = len(text.splitlines())
    if lines >= 40:
        sys.exit(f"{source.name}: wanted less than 40 lines, got {lines}")
    run = subprocess.run([program], capture_output=True, text=True)
    printed = [line.rstrip() for line in run.stdout.splitlines()]
    if run.returncode or run.stderr or printed != promised(text):
        sys.exit(f"{source.name}: exit code {run.returncode}, wanted\n" + "\n".join(promised(text)) +
                 "\ngot\n" + "\n".join(printed) + "\n" + run.stderr)


main()

"""The list of methods in docs/remote.md is what the program prints.

Usage: remote_docs_test.py THENAR [--write]    --write puts it there
"""
import pathlib
import subprocess
import sys

DOCS = pathlib.Path(__file__).resolve().parents[2] / "docs" / "remote.md"
BEGIN, END = "<!-- methods begin -->\n", "<!-- methods end -->\n"

printed = subprocess.run([sys.argv[1], "serve", "--methods", "markdown"], capture_output=True, text=True, check=True).stdout
text = DOCS.read_text()
before, _, rest = text.partition(BEGIN)
held, _, after = rest.partition(END)
if sys.argv[2:] == ["--write"]:
    DOCS.write_text(before + BEGIN + "\n" + printed + END + after)
elif held != "\n" + printed:
    sys.exit(f"{DOCS} has other methods than the program: run {sys.argv[0]} THENAR --write")

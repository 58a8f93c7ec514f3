"""How every file is compiled: without NDEBUG, since Simbody's State changes its layout with it and would
crash; without fused multiplications, since which are fused depends on what stands around them, so that moving code
would move numbers; with a precompiled header of the same optimisation, since gcc takes that of the header and drops
the file's own without a word.

Argument: compile_commands.json.
"""
import json
import re
import sys

commands = json.load(open(sys.argv[1]))
bad = []
levels = {}  # of the files that read a precompiled header, the one that makes it among them
for entry in commands:
    line = entry.get("command") or " ".join(entry["arguments"])
    if re.search(r"-D\s*NDEBUG\b", line):
        bad.append(f"{entry['file']}: compiled with -DNDEBUG")
    if "-ffp-contract=off" not in line.split():
        bad.append(f"{entry['file']}: compiled without -ffp-contract=off")
    header = re.search(r"\S+cmake_pch\.hxx(?=\s|$)", line)
    level = re.findall(r"-O\S*", line)[-1:]
    if header and levels.setdefault(header[0], level) != level:
        bad.append(f"{entry['file']}: compiled with {level}, its precompiled header with {levels[header[0]]}")
print("\n".join(bad))
sys.exit(bool(bad) or not commands)

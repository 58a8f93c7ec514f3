"""How every file is compiled: without NDEBUG, since Simbody's State changes its layout with it and would
crash; without fused multiplications, since which are fused depends on what stands around them, so that moving code
would move numbers.

Argument: compile_commands.json.
"""
import json
import re
import sys

commands = json.load(open(sys.argv[1]))
bad = []
for entry in commands:
    line = entry.get("command") or " ".join(entry["arguments"])
    if re.search(r"-D\s*NDEBUG\b", line):
        bad.append(f"{entry['file']}: compiled with -DNDEBUG")
    if "-ffp-contract=off" not in line.split():
        bad.append(f"{entry['file']}: compiled without -ffp-contract=off")
print("\n".join(bad))
sys.exit(bool(bad) or not commands)

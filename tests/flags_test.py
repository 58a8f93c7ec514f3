"""No file is compiled with NDEBUG: Simbody's State changes its layout with it, and would crash.

Argument: compile_commands.json.
"""
import json
import re
import sys

commands = json.load(open(sys.argv[1]))
bad = [entry["file"] for entry in commands
       if re.search(r"-D\s*NDEBUG\b", entry.get("command") or " ".join(entry["arguments"]))]
print("\n".join(f"{path}: compiled with -DNDEBUG" for path in bad))
sys.exit(bool(bad) or not commands)

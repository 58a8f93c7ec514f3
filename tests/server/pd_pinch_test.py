"""The example of a controller in Python holds its cube, by a server of its own.

Usage: pd_pinch_test.py THENAR
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

RUNTIME = tempfile.TemporaryDirectory()
os.environ["XDG_RUNTIME_DIR"] = RUNTIME.name  # where the server leaves its token, and the example finds it
ROOT = pathlib.Path(__file__).resolve().parents[2]

server = subprocess.Popen([sys.argv[1], "serve", "--port", "0", "--data", str(ROOT / "data")], stdout=subprocess.PIPE,
                          text=True)
try:
    port = re.search(r":(\d+)", server.stdout.readline()).group(1)
    done = subprocess.run([sys.executable, str(ROOT / "clients" / "python" / "examples" / "pd_pinch.py"), port],
                          capture_output=True, text=True)
    print(done.stdout, done.stderr)
    if done.returncode != 0:
        sys.exit("wanted the cube to be held")
finally:
    server.terminate()
    server.wait()

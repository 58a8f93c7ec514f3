"""Kills runs twenty times at seeded moments: resumed, they end with the bytes of undisturbed ones.

kill_test.py SEEDED_RUN
"""
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

PROGRAM = sys.argv[1]
KILLS = 20
DRAWS = {"nuts": 6000, "adaptive-metropolis": 8000}  # about a second of work each
MEMORY = "/dev/shm" if pathlib.Path("/dev/shm").is_dir() else None  # syncs cost nothing there


def run(method, temperatures, out, *folder):
    return [PROGRAM, method, str(temperatures), str(DRAWS[method]), str(out), *map(str, folder)]


def killed_after(seconds, command):
    """True if the process was still running then."""
    with subprocess.Popen(command, stdout=subprocess.DEVNULL) as process:
        try:
            assert process.wait(seconds) == 0, f"{command}: {process.returncode}"
            return False
        except subprocess.TimeoutExpired:
            process.send_signal(signal.SIGKILL)
        return process.wait() == -signal.SIGKILL


def check(method, temperatures, moments, work):
    undisturbed, out, folder = work / "undisturbed", work / "out", work / "run"
    start = time.monotonic()
    subprocess.run(run(method, temperatures, undisturbed), check=True, stdout=subprocess.DEVNULL)
    whole = time.monotonic() - start

    span, sizes = 1.5 * whole / KILLS, []  # longest time to a kill [s], bytes kept at each

    def enough():
        """Where other programs take the processors, the first kills may come before anything is kept."""
        return len(sizes) >= KILLS and max(sizes) > 0

    while not enough() or not out.exists():
        assert len(sizes) < 10 * KILLS, "no draw was kept before the last kill"
        if out.exists():  # faster than expected: once more from the start
            assert out.read_bytes() == undisturbed.read_bytes(), f"{method} differs"
            out.unlink()
            shutil.rmtree(folder)
        command = run(method, temperatures, out, folder)
        if enough():
            subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        elif killed_after(moments.uniform(0, span), command):
            sizes.append(sum(file.stat().st_size for file in folder.glob("group_*")))
            if sizes[-2:-1] == sizes[-1:]:
                span *= 1.2  # slower than expected: let it come further
    assert out.read_bytes() == undisturbed.read_bytes(), f"{method} differs"
    print(f"{method}, {temperatures} temperatures: {len(sizes)} kills, {whole:.2f} s undisturbed, "
          f"bytes kept {sizes}")


with tempfile.TemporaryDirectory(dir=MEMORY) as name:
    moments = random.Random(5)
    for method, temperatures in (("nuts", 1), ("adaptive-metropolis", 3)):
        work = pathlib.Path(name) / method
        work.mkdir()
        check(method, temperatures, moments, work)

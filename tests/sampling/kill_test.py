"""Kills a run twenty times at seeded moments: resumed, it ends with the bytes of an undisturbed run.

kill_test.py SEEDED_RUN
"""
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time

PROGRAM = sys.argv[1]
KILLS = 20
DRAWS = {"nuts": 10000, "adaptive-metropolis": 12000}  # about a second of work each
MEMORY = "/dev/shm" if pathlib.Path("/dev/shm").is_dir() else None  # syncs cost nothing there


def run(method, temperatures, out, *folder):
    return [PROGRAM, method, str(temperatures), str(DRAWS[method]), str(out), *map(str, folder)]


def killed_after(seconds, command):
    """True if the process was still running then."""
    with subprocess.Popen(command, stdout=subprocess.DEVNULL) as process:
        try:
            return process.wait(seconds) != 0
        except subprocess.TimeoutExpired:
            process.send_signal(signal.SIGKILL)
        return process.wait() == -signal.SIGKILL


def check(method, temperatures, kills, moments, work):
    start = time.monotonic()
    subprocess.run(run(method, temperatures, work / "undisturbed"), check=True,
                   stdout=subprocess.DEVNULL)
    whole = time.monotonic() - start

    folder, killed, sizes = work / "run", 0, []
    while killed < kills:
        # So short that the run is not done before the last of them.
        if not killed_after(moments.uniform(0, 1.5 * whole / kills),
                            run(method, temperatures, work / "out", folder)):
            break
        killed += 1
        sizes.append(sum(file.stat().st_size for file in folder.glob("group_*")))
    assert killed == kills, f"{method}: done after {killed} kills"
    assert not (work / "out").exists()
    subprocess.run(run(method, temperatures, work / "out", folder), check=True,
                   stdout=subprocess.DEVNULL)
    assert max(sizes) > 0, "no draw was kept before the last kill"
    assert (work / "out").read_bytes() == (work / "undisturbed").read_bytes(), f"{method} differs"
    print(f"{method}, {temperatures} temperatures: {kills} kills, {whole:.2f} s undisturbed, "
          f"kept after them {sizes}")


with tempfile.TemporaryDirectory(dir=MEMORY) as name:
    moments = random.Random(5)
    for method, temperatures, kills in (("nuts", 1, KILLS), ("adaptive-metropolis", 3, KILLS)):
        work = pathlib.Path(name) / method
        work.mkdir()
        check(method, temperatures, kills, moments, work)

"""How fast the program and its live page are, as ratios to something that this machine does in the same run.

Usage: program_ratios.py PROGRAM. Prints a line each, as bench/ratios does; exit code 1 if one misses. The live page is
left out, with a message, where chromium is not installed.
"""

import json
import os
import pathlib
import resource
import socket
import statistics
import subprocess
import sys
import tempfile
import threading
import time

TESTS = pathlib.Path(__file__).resolve().parents[1] / "tests"
sys.path[:0] = [str(TESTS / folder) for folder in ("live", "server", "apps")]
import bare_page  # noqa: E402
import live_page  # noqa: E402
import measure_page  # noqa: E402
import mesh_hands  # noqa: E402
from browser import Browser, chromium  # noqa: E402
from live_client import Lines, Server  # noqa: E402

PROGRAM = os.path.abspath(sys.argv[1])


def row(name, ours, rival, required):
    """Prints a line; times in ms. Returns whether ours is short enough: rival / ours at least what is required."""
    good = rival / ours >= required
    print(f"{name:<44}{1e3 * ours:>11.3f}{1e3 * rival:>12.2f}{rival / ours:>9.2f}{required:>10.3g}{'-':>10}"
          f"{'PASS' if good else 'MISS':>11}", flush=True)
    return good


# ---- the page

FIRST, SLIDER = 0.05, 1  # least bare pictures in the time of the page's


def page_rows():
    """First picture and slider of a whole hand with tendons, against a bare picture of as many triangles."""
    first, slider, bare = [], [], []
    for _ in range(5):
        with Browser() as browser:
            program = live_page.Program("human:tendons")
            try:
                bare.append(bare_page.bare_picture(browser)[1])
                first.append(measure_page.first_picture_of(browser, program))
                slider.append(measure_page.slider_to_pixels(browser, 15))
            finally:
                program.close()
    picture = statistics.median(bare)
    print(f"  first picture {', '.join(f'{t:.0f}' for t in first)} ms; slider {', '.join(f'{t:.0f}' for t in slider)} ms; "
          f"a bare picture {', '.join(f'{t:.0f}' for t in bare)} ms")
    return [row("first picture of human:tendons: bare picture", statistics.median(first), picture, FIRST),
            row("its pictures follow a slider: bare picture", statistics.median(slider), picture, SLIDER)]


# ---- the server


def echo(listener):
    """Sends back lines, as the shortest server can."""
    connection, _ = listener.accept()
    with connection, connection.makefile("rb") as lines:
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        for line in lines:
            connection.sendall(line)


def median_time(work, count):
    times = []
    for _ in range(count):
        begin = time.perf_counter()
        work()
        times.append(time.perf_counter() - begin)
    return statistics.median(times)


def server_rows():
    """Round trips over TCP against those of a bare echo; a motion that plays, against the clock."""
    with socket.create_server(("127.0.0.1", 0)) as listener, Server(PROGRAM, "serve", "--port", "0") as server:
        threading.Thread(target=echo, args=[listener], daemon=True).start()
        bare, client = Lines(listener.getsockname()[1]), Lines(server.port)
        ours = median_time(lambda: client.ask("session.hello"), 2000)
        rival = median_time(lambda: bare.ask("session.hello"), 2000)
        rows = [row("round trip over TCP: bare echo", 1e3 * ours, 1e3 * rival, 0.2)]

        client.ask("motion.open", scene="pinch")
        begin = client.ask("motion.state")["result"]["t"]
        client.ask("motion.play")
        at = time.perf_counter()
        time.sleep(1)
        played = client.ask("motion.state")["result"]["t"] - begin
        passed = time.perf_counter() - at
        rows.append(row("pinch plays: clock", 1e3 * passed, 1e3 * played, 0.9))
        bare.close(), client.close()
        server.stop()
    return rows


# ---- files


def processor_time(*words):
    """Seconds of the processor that a command takes."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([PROGRAM, *words], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                   env={**os.environ, "THENAR_CACHE": "off"})
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def import_rows():
    """A hand of 17 meshes, against as many meshes that are read one by one: no list of nearest triangles is filled."""
    with tempfile.TemporaryDirectory() as folder:
        hand = mesh_hands.hand(folder)
        ours = processor_time("import", hand, "--out", os.path.join(folder, "hand.toml"))
        rival = 17 * processor_time("import", os.path.join(folder, "palm.stl"), "--json")
        return [row("import of a hand of 17 meshes: 17 meshes", 1e3 * ours, 1e3 * rival, 1)]


def main():
    live_page.PROGRAM = PROGRAM
    print(f"{'':<44}{'ours [us]':>11}{'rival [us]':>12}{'ratio':>9}{'required':>10}{'error':>10}{'verdict':>11}")
    rows = server_rows() + import_rows()
    if chromium():
        rows += page_rows()
    else:
        print("The live page: skipped, as chromium is not installed.")
    sys.exit(not all(rows))


if __name__ == "__main__":
    main()

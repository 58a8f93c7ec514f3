"""No test decides by a clock: how fast things are is measured by ./run bench. Run from the repository root.

Sources of tests may read no clock and state no limit of time, but for those that are listed here with the reason.
"""
import pathlib
import re
import sys

CLOCK = re.compile(r"steady_clock|system_clock|high_resolution_clock|std::clock\b|clock_gettime|gettimeofday|\bru_[us]time"
                   r"|perf_counter|process_time|\btime\.time\(|time\.monotonic|performance\.now|Date\.now")
LIMIT = re.compile(r"\btimeout ?= ?[\d.]+|settimeout\([1-9]|\bwait(_for|_until)?\(.*(seconds|minutes)\(|-timeout=\d")

MAY = {
    "tests/apps/posterior_commands_test.py": "runs are killed at moments of how long one takes that is left alone",
    "tests/live/browser.py": "guards against hangs: minutes",
    "tests/live/live_files_test.py": "guards against hangs: minutes",
    "tests/live/live_page.py": "guards against hangs: minutes",
    "tests/tendons/muscle/net_excitation_test.cpp": "the processor's time is told, and decides nothing",
    "tests/sampling/kill_test.py": "runs are killed at moments of how long one takes that is left alone",
    "tests/server/engine_test.cpp": "frames and motions keep to the clock: bounds from above, which slow machines meet",
    "tests/server/flood_test.py": "a server that reads no further is told by a send that waits: slow machines wait, too",
    "tests/server/live_client.py": "guards against hangs: minutes",
    "tests/server/remote_test.py": "as flood_test.py",
}

bad, found = [], set()
for path in sorted(pathlib.Path("tests").rglob("*")):
    if path.suffix not in (".h", ".cpp", ".py") or path.name == "clocks_test.py":
        continue
    for line, text in enumerate(path.read_text().splitlines(), 1):
        if not CLOCK.search(text) and not LIMIT.search(text):
            continue
        found.add(str(path))
        if str(path) not in MAY:
            bad.append(f"{path}:{line}: a test decides by no clock: count work, or measure it in bench/: {text.strip()}")
bad += [f"tests/clocks_test.py: {path} needs no leave any more" for path in sorted(set(MAY) - found)]
print("\n".join(bad))
sys.exit(bool(bad))

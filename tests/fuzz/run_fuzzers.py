"""Runs libFuzzer on every kind of file that thenar reads: run_fuzzers.py FUZZ_FILES SECONDS [KIND...]

Corpora grow in FUZZ_FILES' folder, under corpus/KIND, and are begun from again. An input that crashes, takes
for ever or 1.5 GB is kept in crashes/KIND and fails the run; what libFuzzer said of it is in crashes/KIND.log.
"""
import os
import pathlib
import re
import subprocess
import sys

HANG = 240  # of one input [s]: guards against hangs alone


def fuzz(program, kind, seconds):
    """Executions, and whether none did harm."""
    home = program.parent
    corpus, crashes = home / "corpus" / kind, home / "crashes" / kind
    crashes.mkdir(parents=True, exist_ok=True)
    environment = dict(os.environ, THENAR_FUZZ_KIND=kind,
                       THENAR_MESH_READER="/bin/true",  # parsers of others are not what is tested here
                       ASAN_OPTIONS="detect_leaks=0:allocator_may_return_null=1")
    run = subprocess.run(
        [program, f"-max_total_time={seconds}", f"-timeout={HANG}", "-rss_limit_mb=1500", "-max_len=20000",
         "-print_final_stats=1", f"-artifact_prefix={crashes}/", corpus],
        env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
    (home / "crashes" / f"{kind}.log").write_text(run.stdout[-20000:])
    count = re.search(r"number_of_executed_units: *(\d+)", run.stdout)
    edges = re.findall(r"cov: (\d+)", run.stdout)
    return int(count[1]) if count else 0, edges[-1] if edges else "?", run.returncode == 0


def main():
    program, seconds = pathlib.Path(sys.argv[1]).resolve(), int(sys.argv[2])
    seeds = subprocess.run([program, "seeds", program.parent / "corpus"], check=True, stdout=subprocess.PIPE, text=True)
    kinds = sys.argv[3:] or seeds.stdout.splitlines()
    harm = []
    for kind in kinds:
        count, edges, good = fuzz(program, kind, seconds)
        print(f"{kind}: {count} files, {edges} edges{'' if good else ', HARM: see crashes/' + kind}", flush=True)
        if not good or count == 0:
            harm.append(kind)
    sys.exit(bool(harm))


main()

"""Runs by several processes give the bytes of one; a rank that dies ends all, and they can go on.

ranks_test.py SEEDED_RUN MPIEXEC
"""
import os
import pathlib
import subprocess
import sys
import tempfile

PROGRAM, MPIEXEC = sys.argv[1:]
# Processes of this machine only, more of them than cores, and by root in containers.
ENVIRONMENT = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
               "OMPI_MCA_btl": "self,vader", "OMPI_MCA_rmaps_base_oversubscribe": "1",
               "OMPI_MCA_mpi_yield_when_idle": "1", "OMPI_MCA_hwloc_base_binding_policy": "none"}
# Open MPI keeps what it allocates and unloads the modules that did, so that no suppression finds their
# names. Leaks of ours show in the runs by one process.
RANK = {"ASAN_OPTIONS": "detect_leaks=0"}


def run(ranks, *arguments):
    """Done by one process without mpirun if ranks is 0."""
    start = [MPIEXEC, "-n", str(ranks), "--oversubscribe"] if ranks else []
    return subprocess.run([*start, PROGRAM, *map(str, arguments)], text=True,
                          env={**ENVIRONMENT, **(RANK if ranks else {})},
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE)


def fake_mpi():
    """A library with an MPI_Init that is none, as Ipopt's MUMPS brings along."""
    return next(pathlib.Path("/usr/lib/x86_64-linux-gnu").glob("libmpiseq_seq-*.so"), None)


def sound(done):
    assert done.returncode == 0, f"{done.args}: {done.returncode}\n{done.stderr}"
    return done.stdout.strip()


with tempfile.TemporaryDirectory() as name:
    work = pathlib.Path(name)
    alone, out, folder = work / "alone", work / "out", work / "run"

    # Plain: a chain a rank. Tempered: 4 groups x 3 rungs on 5 ranks, so that groups are split.
    for method, temperatures, draws, ranks in (("nuts", 1, 1000, 4), ("stretch", 1, 100, 3),
                                               ("adaptive-metropolis", 3, 200, 5)):
        times = [sound(run(0, method, temperatures, draws, alone)),
                 sound(run(ranks, method, temperatures, draws, out))]
        assert out.read_bytes() == alone.read_bytes(), f"{method}: {ranks} ranks draw differently"
        print(f"{method}: {times[0]} alone, {times[1]} by {ranks} ranks")

    # Rank 2 kills itself: the run ends, its checkpoint stays, and 2 ranks go on from it.
    sound(run(0, "nuts", 1, 20000, alone))
    out.unlink()
    died = run(4, "nuts", 1, 20000, out, folder, 2)
    assert died.returncode != 0 and not out.exists(), "a rank died and nobody minded"
    assert (folder / "state.bin").exists(), "nothing was kept"
    sound(run(2, "nuts", 1, 20000, out, folder))
    assert out.read_bytes() == alone.read_bytes(), "draws differ after a rank died"

    # A checkpoint of another run is refused by all of them, with what differs.
    refused = run(3, "nuts", 2, 20000, out, folder)
    assert refused.returncode != 0
    assert "temperatures (was 1, is 2)" in refused.stderr, refused.stderr
    # An MPI_Init that comes before that of libmpi is noticed, not called.
    if fake_mpi():
        ENVIRONMENT["LD_PRELOAD"] = str(fake_mpi())
        fooled = subprocess.run([PROGRAM, "nuts", "1", "10", out], text=True,
                                env={**ENVIRONMENT, "OMPI_COMM_WORLD_SIZE": "1"},
                                stderr=subprocess.PIPE)
        assert fooled.returncode != 0 and "must come from libmpi" in fooled.stderr, fooled.stderr
    print("a rank that died, and a checkpoint of another run: as wanted")

"""How soon a hand is posed, 60 times a second, while a comparison and chains run as jobs of the same server.

Usage: jobs_latency.py THENAR [SECONDS]    SECONDS: how long hands are posed, 10 unless given
"""
import pathlib
import sys
import time

sys.path[:0] = [str(pathlib.Path(__file__).resolve().parents[1] / folder) for folder in ("tests/server", "clients/python")]
from live_client import Server  # noqa: E402
from thenar_remote import Remote  # noqa: E402

POSES_A_SECOND = 60
COMPARE = {"hands": ["barrett", "parallel_jaw"], "objects": ["sphere_70", "cube_50"], "approaches": 400}
CHAINS = {"experiments": ["synek2019_H01"], "subject": "synek2019_middle", "chains": 2, "warm_up": 300, "draws": 20000,
          "output": "chains.nc"}

seconds = float(sys.argv[2]) if len(sys.argv) > 2 else 10.0
with Server(sys.argv[1], "serve", "jaw_box", "--port", "0") as server, \
        Remote("127.0.0.1", server.port) as worker, Remote("127.0.0.1", server.port) as poser:
    joint = poser.hand.get()["joints"][0]
    jobs = [worker.job.start(question="compare", request=COMPARE)["job"],
            worker.job.start(question="posterior", request=CHAINS)["job"]]
    times = []
    for i in range(int(seconds * POSES_A_SECOND)):
        begin = time.monotonic()
        share = 0.3 + 0.2 * (i % 10) / 10
        poser.hand.set_joints(joints={joint["field"]: joint["lower"] + share * (joint["upper"] - joint["lower"])})
        times.append(time.monotonic() - begin)
        time.sleep(max(0.0, 1 / POSES_A_SECOND - times[-1]))
    states = [worker.job.state(job=job)["state"] for job in jobs]
    times.sort()
    print(f"{len(times)} poses: median {1e3 * times[len(times) // 2]:.2f} ms, 99 in 100 within "
          f"{1e3 * times[int(0.99 * len(times))]:.2f} ms, longest {1e3 * times[-1]:.2f} ms; jobs {', '.join(states)}")

"""Questions over the socket: they equal the command's JSON; a comparison and chains run as jobs while a client poses a
hand; a log with jobs is repeated.

Usage: jobs_test.py THENAR
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

from live_client import HANG, Server
from thenar_remote import Remote, RemoteError

THENAR = str(pathlib.Path(sys.argv.pop(1)).resolve())
POSES = 100  # that are answered while both jobs run; bench/jobs_latency.py says how soon
PAUSE = 0.02  # between questions whether a job has ended [s]
COMPARE = {"hands": ["barrett", "parallel_jaw"], "objects": ["sphere_70", "cube_50"], "approaches": 40}
CHAINS = {"experiments": ["synek2019_H01"], "subject": "synek2019_middle", "chains": 2, "warm_up": 300, "draws": 2000,
          "output": "chains.nc"}


def wait_for(thenar, job):
    """The state of a job that has ended."""
    for _ in range(int(HANG / PAUSE)):
        state = thenar.job.state(job=job)
        if state["state"] not in ("waiting", "running"):
            return state
        time.sleep(PAUSE)
    raise AssertionError(f"job {job} goes on")


class Jobs(unittest.TestCase):
    def test_questions_at_once_are_those_of_the_command(self):
        with tempfile.TemporaryDirectory() as folder, Remote.start("jaw_box", program=THENAR) as thenar:
            request = {"subject": "synek2019_middle", "posture_deg": {"MCP3_FE": 40, "PIP3": 55}, "tension_N": {"FDP": 10}}
            told = thenar.ask.tip_force(**request)
            printed = json.loads(subprocess.run(
                [THENAR, "tip-force", "synek2019_middle", "--posture", "MCP3_FE=40", "PIP3=55", "--tension", "FDP=10", "--json"],
                capture_output=True, text=True, check=True, cwd=folder).stdout)
            self.assertEqual(told["force_N"], printed["force_N"])
            for joint, angle in told["posture_rad"].items():
                self.assertAlmostEqual(angle * 180 / 3.141592653589793, printed["posture_deg"][joint], delta=1e-13)
            job = thenar.job.start(question="tip_force", request=request)["job"]
            self.assertEqual(wait_for(thenar, job)["state"], "done")
            self.assertEqual(thenar.job.result(job=job)["answer"], told)

    def test_what_a_client_may_not_set_is_refused(self):
        with Remote.start("jaw_box", program=THENAR) as thenar:
            for request in ({"subject": "synek2019_middle", "data": "/etc"}, {"subjekt": "x"}):
                with self.assertRaises(RemoteError):
                    thenar.job.start(question="moment_arms", request=request)
            with self.assertRaises(RemoteError):
                thenar.job.start(question="posterior", request={**CHAINS, "output": "../../away.nc"})
            self.assertEqual(thenar.job.list()["jobs"], [])

    def test_hands_are_posed_while_jobs_run(self):
        with Server(THENAR, "serve", "jaw_box", "--port", "0") as server, \
                Remote("127.0.0.1", server.port) as worker, Remote("127.0.0.1", server.port) as poser:
            joint = poser.hand.get()["joints"][0]
            jobs = [worker.job.start(question="compare", request=COMPARE)["job"],
                    worker.job.start(question="posterior", request=CHAINS)["job"]]
            for i in range(POSES):
                share = 0.3 + 0.2 * (i % 10) / 10
                poser.hand.set_joints(joints={joint["field"]: joint["lower"] + share * (joint["upper"] - joint["lower"])})
            self.assertEqual([worker.job.state(job=job)["state"] for job in jobs], ["running", "running"])
            for job in jobs:
                worker.job.stop(job=job)
                self.assertIn(wait_for(worker, job)["state"], ("stopped", "done"))

    def test_a_log_with_jobs_is_repeated(self):
        with tempfile.TemporaryDirectory() as folder:
            with Server(THENAR, "serve", "jaw_box", "--port", "0", "--log", "log.jsonl", folder=folder) as server:
                with Remote("127.0.0.1", server.port) as thenar:
                    for request in ({"hands": ["parallel_jaw"], "objects": ["sphere_70"], "approaches": 2}, {**COMPARE, "threads": 1}):
                        job = thenar.job.start(question="compare", request=request)["job"]
                        thenar.hand.get()
                    wait_for(thenar, 1)
                    thenar.job.stop(job=job)
                    wait_for(thenar, job)
                    thenar.hand.get()
                server.stop()
            lines = [json.loads(line) for line in (pathlib.Path(folder) / "log.jsonl").read_text().splitlines()]
            self.assertEqual([line["request"]["method"] for line in lines].count("job.end"), 2)
            done = subprocess.run([THENAR, "serve", "--replay", "log.jsonl"], cwd=folder, capture_output=True, text=True,
                                  timeout=HANG, check=False)
            self.assertEqual(done.returncode, 0, done.stderr + done.stdout)


if __name__ == "__main__":
    unittest.main()

"""Whole sessions on worlds: what programs do is seen by pages, repeats from its log, and travels in small frames.

Usage: live_session_test.py THENAR
"""
import json
import os
import pathlib
import random
import struct
import subprocess
import sys
import tempfile
import unittest

from live_client import HANG, Lines, Server, WebSocket, http, until

THENAR = str(pathlib.Path(sys.argv.pop(1)).resolve())


def revision(frame):
    return struct.unpack_from("<I", frame, 4)[0]


def first_frame(thenar_words):
    with Server(THENAR, "view", *thenar_words, "--no-open") as server:
        frame = WebSocket(server.port).frame()
        assert server.stop()[0] == 0
        return frame


class Sessions(unittest.TestCase):
    def test_frames_are_small(self):
        for name in ("jaw_box", "human:tendons"):
            frame = first_frame([name])
            self.assertGreater(struct.unpack_from("<H", frame, 24)[0], 0)  # bodies
            self.assertLess(len(frame), 4096)

    def test_meshes_of_a_scene_are_there(self):
        with Server(THENAR, "view", "jaw_box", "--no-open") as server:
            scene = WebSocket(server.port).notification("scene")
            meshes = {body["mesh"] for body in scene["bodies"] if body["mesh"]}
            self.assertTrue(meshes)
            for mesh in meshes:
                status, _, data = http(server.port, "/mesh/" + mesh)
                vertices, triangles = struct.unpack_from("<II", data)
                self.assertLess(vertices, 65536)
                self.assertEqual((status, len(data)), (200, 8 + 12 * vertices + 6 * triangles))
                corners = struct.unpack_from(f"<{3 * triangles}H", data, 8 + 12 * vertices)
                self.assertLess(max(corners), vertices)
            self.assertEqual(server.stop()[0], 0)

    def test_a_page_sees_what_a_program_does(self):
        with Server(THENAR, "view", "jaw_box", "--no-open", "--remote", "0") as server:
            remote = Lines(int(server.process.stdout.readline().rsplit(":", 1)[1]))
            page = WebSocket(server.port)
            scene = page.notification("scene")
            page.frame()
            index, joint = next((i, j) for i, j in enumerate(scene["joints"]) if not j["led_by"])
            start = 52 + 28 * len(scene["bodies"]) + 4 * index
            value = 0.5 * (joint["lower"] + joint["upper"])
            reply = remote.ask("hand.set_joints", joints={joint["name"]: value})
            self.assertIn("result", reply, reply)

            def shown():
                frame = page.frame()
                return revision(frame) == scene["revision"] and abs(struct.unpack_from("<f", frame, start)[0] - value) < 1e-6

            until(shown, "the page shows the joint")
            self.assertIsNotNone(page.notification("state"))
            self.assertEqual(server.stop()[0], 0)

    def test_random_sessions_repeat_from_their_logs(self):
        rng = random.Random(5)
        with tempfile.TemporaryDirectory() as folder:
            log = os.path.join(folder, "session.jsonl")
            with Server(THENAR, "serve", "jaw_box", "--port", "0", "--log", log, folder=folder) as server:
                client = Lines(server.port)
                joints = client.ask("hand.get")["result"]["joints"]
                for _ in range(60):
                    joint = rng.choice(joints)
                    method, params = rng.choice([
                        ("hand.set_joints", {"joints": {joint["name"]: rng.uniform(joint["lower"], joint["upper"])}}),
                        ("session.undo", {}), ("session.redo", {}), ("world.get", {}), ("grasp.contacts", {}),
                        ("hand.open", {}), ("hand.close", {}), ("grasp.quality", {}), ("picture.instant", {}),
                        ("world.text", {}), ("hand.set_joints", {"joints": {"no such": 1}})])
                    client.ask(method, **params)
                self.assertEqual(server.stop()[0], 0)
            done = subprocess.run([THENAR, "serve", "--replay", log], capture_output=True, text=True, timeout=HANG,
                                  cwd=folder)
            self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)
            self.assertIn("all replies are as they were", done.stdout)
            self.assertEqual(len(pathlib.Path(log).read_text().splitlines()), 62)


if __name__ == "__main__":
    with Server(THENAR, "serve", "--port", "0") as probe:
        offered = {method["name"] for method in Lines(probe.port).ask("session.methods")["result"]}
    if "world.load" not in offered:
        print("skipped: this thenar has no worlds to show")
        sys.exit(77)
    unittest.main(verbosity=2, warnings="ignore")

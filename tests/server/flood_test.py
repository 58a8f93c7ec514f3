"""Clients that send more than is answered, take no replies, or say nothing: the others are served, and memory stays
bounded. Solids that coincide, and steps that take long, hear session.stop.

Usage: flood_test.py THENAR    THENAR_FLOOD=N makes the floods N times as large
"""
import base64
import json
import os
import pathlib
import re
import socket
import sys
import threading
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from live_client import Lines, Server, WebSocket, connect, http, until  # noqa: E402

THENAR = sys.argv.pop(1)
TOKEN = "0123456789abcdef"
TIMES = int(os.environ.get("THENAR_FLOOD", "1"))
MOST = 1000 * 1000  # memory at any time [kB]


def line(method, number=1, **params):
    return json.dumps({"jsonrpc": "2.0", "id": number, "method": method, "params": params}) + "\n"


def peak(server):
    """Largest resident memory so far [kB]."""
    return int(re.search(r"VmHWM:\s+(\d+)", pathlib.Path(f"/proc/{server.process.pid}/status").read_text())[1])


def guest(server):
    client = Lines(server.port)
    client.send(line("session.hello", token=TOKEN))
    assert "result" in client.receive()
    return client


def serve(*words):
    return Server(THENAR, "serve", "--port", "0", "--token", TOKEN, *words)


def tetrahedra(count):
    """OBJ of so many tetrahedra in one place."""
    corners = "".join(f"v {x} {y} {z}\n" for x, y, z in ((0, 0, 0), (.03, 0, 0), (0, .03, 0), (0, 0, .03)))
    faces = ((1, 3, 2), (1, 2, 4), (1, 4, 3), (2, 3, 4))
    return corners * count + "".join("f %d %d %d\n" % tuple(4 * i + k for k in face) for i in range(count) for face in faces)


class Busy:
    """A request that takes as long as it is let: a minute of steps."""

    def __init__(self, server):
        self.client = guest(server)
        assert "result" in self.client.ask("motion.open", scene="pinch")
        self.client.send(line("motion.step", 99, steps=1_000_000))
        self.other = guest(server)
        until(lambda: self.status()["runs"] == "motion.step", "it runs")

    def status(self):
        return self.other.ask("session.status")["result"]


class Flood(unittest.TestCase):
    def sent(self, client, piece, count):
        """How many pieces a client gets rid of before nothing moves for a while."""
        client.connection.settimeout(0.5)
        try:
            for number in range(count):
                client.connection.sendall(piece)
            return count
        except (socket.timeout, ConnectionError):
            return number

    def test_requests_without_replies_are_read_no_further(self):
        piece = line("session.mode", mode="x" * 900_000).encode()
        with serve() as server:
            busy = Busy(server)
            crowd = [guest(server) for _ in range(40)]
            taken = []
            threads = [threading.Thread(target=lambda c=c: taken.append(self.sent(c, piece, 256 * TIMES))) for c in crowd]
            for thread in threads:
                thread.start()
            for _ in range(50):  # meanwhile others are told what runs
                self.assertIn("runs", busy.status())
            for thread in threads:
                thread.join()
            # Each gets rid of what the system holds for it, and of a few megabytes.
            self.assertLess(max(taken), 30)
            self.assertLess(peak(server), MOST)
            self.assertLess(server.memory(), 400_000)
            self.assertTrue(busy.other.ask("session.stop")["result"]["asked"] in (True, False))
            for client in crowd:
                client.close()
            self.assertIn("result", busy.other.ask("session.hello"))
            self.assertEqual(server.stop()[0], 0)

    def test_pages_send_long_messages_one_after_the_other(self):
        with Server(THENAR, "view", "--no-open", "--token", TOKEN) as server:
            crowd = [WebSocket(server.port, target="/ws?token=" + TOKEN) for _ in range(24)]
            piece = b"a" * (1 << 20)

            def send(client):
                client.connection.settimeout(1)
                try:
                    client.send(b'"' + piece, final=False)
                    for _ in range(40 * TIMES):
                        client.send(piece, opcode=0, final=False)
                except OSError:
                    pass

            threads = [threading.Thread(target=send, args=[client]) for client in crowd]
            for thread in threads:
                thread.start()
            for thread in threads:
                thread.join()
            self.assertLess(peak(server), MOST)
            last = WebSocket(server.port, target="/ws?token=" + TOKEN)
            self.assertIn("result", last.ask("session.hello"))
            for client in crowd:
                client.close()
            # The next long message has its turn when the others are gone.
            last.send(json.dumps({"jsonrpc": "2.0", "id": 5, "method": "session.mode", "params": {"mode": "y" * (3 << 20)}}))
            self.assertEqual(last.reply_to(5)["error"]["code"], -32602)
            self.assertEqual(server.stop()[0], 0)

    def test_replies_that_nobody_takes_are_bounded(self):
        batch = json.dumps([{"jsonrpc": "2.0", "id": 1, "method": "session.methods"}] * 20) + "\n"
        with serve() as server:
            crowd = [guest(server) for _ in range(4 * TIMES)]
            for client in crowd:
                self.sent(client, batch.encode(), 12)
            self.assertLess(peak(server), MOST)
            other = guest(server)
            self.assertIn("result", other.ask("session.hello"))
            self.assertEqual(server.stop()[0], 0)

    def test_who_says_nothing_locks_nobody_out(self):
        with serve() as server:
            crowd = [connect(server.port) for _ in range(400)]
            self.assertIn("result", guest(server).ask("session.status"))
            long = connect(server.port)  # a stranger that sends without end, and no line
            with self.assertRaises(OSError):
                for _ in range(1000):
                    long.sendall(b" " * 65536)
                raise OSError if long.recv(1000) == b"" else AssertionError
            self.assertLess(peak(server), 300_000)
            self.assertEqual(len(crowd), 400)
            self.assertEqual(server.stop()[0], 0)
        with Server(THENAR, "view", "--no-open", "--token", TOKEN) as server:
            crowd = [connect(server.port) for _ in range(400)]
            self.assertEqual(http(server.port, "/?token=" + TOKEN)[0], 200)
            self.assertIn("result", WebSocket(server.port, target="/ws?token=" + TOKEN).ask("session.hello"))
            self.assertEqual(server.stop()[0], 0)

    def test_solids_that_coincide_are_one(self):
        with serve() as server:
            client = guest(server)
            for count in (24, 300):
                files = [{"name": "same.obj", "data": base64.b64encode(tetrahedra(count).encode()).decode()}]
                reply = client.ask("world.import", files=files, **{"as": "object"})
                self.assertIn("result", reply, reply)
            self.assertEqual(server.stop()[0], 0)

    def test_a_long_step_hears_stop(self):
        with serve() as server:
            busy = Busy(server)
            self.assertEqual(busy.status()["runs"], "motion.step")
            busy.other.ask("session.stop")
            reply = busy.client.receive()
            self.assertEqual(reply["id"], 99)
            self.assertIn("result", reply)
            self.assertIsNone(busy.status()["runs"])
            self.assertEqual(server.stop()[0], 0)


if __name__ == "__main__":
    unittest.main(warnings="ignore")  # connections that are left open are what is tested

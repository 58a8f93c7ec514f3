"""Programs that control thenar: lines of TCP, standard input, tokens, logs, broken connections.

Usage: remote_test.py THENAR
"""
import json
import os
import pathlib
import random
import select
import signal
import socket
import struct
import subprocess
import sys
import tempfile
import threading
import time
import unittest

from live_client import HANG, Lines, Server, WebSocket, connect, http, until
from thenar_remote import Remote, RemoteError, stored_token

THENAR = str(pathlib.Path(sys.argv.pop(1)).resolve())
HELLO = {"jsonrpc": "2.0", "id": 7, "method": "session.hello", "params": {}}


def run(*words, text="", code=0, folder=None):
    done = subprocess.run([THENAR, *words], input=text, capture_output=True, text=True, timeout=HANG, cwd=folder)
    if done.returncode != code:
        raise AssertionError(f"{words}: exit code {done.returncode}, {done.stderr}")
    return done.stdout, done.stderr


def line(**message):
    return json.dumps({"jsonrpc": "2.0", **message}) + "\n"


# How TLS, SSH, mail, databases and floods begin: bytes after which a server of something else hangs up.
OTHER_PROTOCOLS = [b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03", b"\x16", b"SSH-2.0-OpenSSH_9.2\r\n", b"EHLO mail.example\r\n",
                   b"\x00\x00\x00\x00", b"\xff\xfe{", b"\xef\xbb\xbf{}", b"*1\r\n$4\r\nPING\r\n", b"A" * 100000, b"\"x\"\n", b"1\n"]


def hangs_up(port, begin):
    """Whether a server ends a connection that begins so, while an older one that says nothing is still open."""
    with connect(port) as silent, connect(port) as connection:
        try:
            connection.sendall(begin)
            ended = connection.recv(100) == b""
        except (ConnectionResetError, BrokenPipeError):
            ended = True
        return ended and not select.select([silent], [], [], 0)[0]


def mutated(rng, text):
    """A valid message, damaged in one of many ways."""
    data = bytearray(text.encode())
    kind = rng.randrange(8)
    if kind == 0:  # bits
        for _ in range(rng.randint(1, 8)):
            data[rng.randrange(len(data))] ^= 1 << rng.randrange(8)
    elif kind == 1:  # cut off
        del data[rng.randrange(len(data)):]
    elif kind == 2:  # bytes that are no UTF-8
        at = rng.randrange(len(data))
        data[at:at] = bytes(rng.choice([[0xFF], [0xC0, 0x80], [0xED, 0xA0, 0x80], [0xF5, 0x80]]))
    elif kind == 3:  # deep
        depth = rng.choice([31, 32, 33, 1000, 50000])
        data[:] = (rng.choice(["[", '{"a":']) * depth).encode()
    elif kind == 4:  # numbers that are too large
        data = data.replace(b"7", rng.choice([b"1e999", b"-1e400", b"9" * 400, b"1e-999", b"0x7", b"NaN", b"Infinity"]))
    elif kind == 5:  # members of a wrong type
        message = json.loads(text)
        member = rng.choice(["jsonrpc", "id", "method", "params"])
        message[member] = rng.choice([None, True, -1, 3.5, "x", [], [1], {}, {"a": {"b": []}}, "\u0000", "\ud7ff" * 100])
        data = bytearray(json.dumps(message).encode())
    elif kind == 6:  # pieces twice, or elsewhere
        a, b = sorted(rng.randrange(len(data)) for _ in range(2))
        at = rng.randrange(len(data))
        data[at:at] = data[a:b]
    else:  # a batch of much
        data = bytearray(("[" + ",".join([rng.choice([text, "1", "null", "{}"])] * rng.choice([1, 3, 40])) + "]").encode())
    return bytes(data).replace(b"\n", b" ").replace(b"\r", b" ")


class Protocol(unittest.TestCase):
    """Errors by their numbers, ids, batches and notifications, as the specification of JSON-RPC 2.0 has them."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()  # examples save worlds
        cls.server = Server(THENAR, "serve", "--port", "0", folder=cls.folder.name)

    @classmethod
    def tearDownClass(cls):
        code, _, _ = cls.server.stop()
        cls.folder.cleanup()
        assert code == 0, code

    def reply(self, text):
        client = Lines(self.server.port)
        client.send(text + "\n")
        found = client.receive()
        client.close()
        return found

    def test_errors_have_their_codes(self):
        cases = [("{", -32700, None), ('{"jsonrpc": "2.0", "method": "x", "id": 1e999}', -32700, None),
                 (b"\xff".decode("latin1"), -32700, None), ("1", -32600, None), ("[]", -32600, None),
                 ('{"jsonrpc": "1.0", "method": "session.hello", "id": 3}', -32600, 3),
                 ('{"jsonrpc": "2.0", "method": 1, "id": 3}', -32600, 3),
                 ('{"jsonrpc": "2.0", "method": "session.hello", "params": [1], "id": 3}', -32600, 3),
                 ('{"jsonrpc": "2.0", "method": "session.hello", "id": {}}', -32600, None),
                 ('{"jsonrpc": "2.0", "method": "session.hullo", "id": "a"}', -32601, "a"),
                 ('{"jsonrpc": "2.0", "method": "session.mode", "params": {"mode": 3}, "id": 3}', -32602, 3),
                 ('{"jsonrpc": "2.0", "method": "session.mode", "params": {"mod": "fit"}, "id": 3}', -32602, 3),
                 ('{"jsonrpc": "2.0", "method": "session.mode", "params": {"mode": "fit"}, "id": 3}', -32000, 3),
                 ("[" * 33 + "]" * 33, -32002, None)]
        for text, code, number in cases:
            reply = self.reply(text)
            self.assertEqual((reply["error"]["code"], reply["id"]), (code, number), text)
            self.assertTrue(reply["error"]["message"])
        self.assertIn("did you mean 'session.hello'?", self.reply(cases[9][0])["error"]["message"])
        self.assertIn("did you mean 'mode'?", self.reply(cases[11][0])["error"]["message"])

    def test_parts_of_a_subject_want_their_kind(self):
        reply = self.reply(line(id=1, method="catalogue.list", params={"of": "human_hand"}).strip())
        self.assertIn("'what' is missing", reply["error"]["message"])

    def test_ids_come_back_as_they_were(self):
        for number in (0, -5, 2**53 + 1, 0.5, "", "\u00e9\u2603", None):
            reply = self.reply(line(id=number, method="session.hello").strip())
            self.assertEqual(reply["id"], number)
            self.assertEqual(reply["result"]["protocol"], 1)

    def test_batches_are_answered_in_order_without_notifications(self):
        batch = [HELLO, {"jsonrpc": "2.0", "method": "session.hello"}, 1, {**HELLO, "id": 8}]
        replies = self.reply(json.dumps(batch))
        self.assertEqual([reply["id"] for reply in replies], [7, None, 8])
        self.assertEqual(replies[1]["error"]["code"], -32600)

    def test_notifications_are_not_answered(self):
        client = Lines(self.server.port)
        client.send(line(method="session.hello") + line(method="no.such") + json.dumps([{**HELLO, "id": 1}]) + "\n")
        self.assertEqual([reply["id"] for reply in client.receive()], [1])
        client.close()

    def test_lines_that_are_too_long_are_told(self):
        client = Lines(self.server.port)
        client.send('"' + "a" * (3 << 20) + '"\n' + line(**HELLO))
        self.assertEqual(client.receive()["error"]["code"], -32002)
        self.assertEqual(client.receive()["id"], 7)
        client.send("[" + "1," * 400000 + "1]\n" + line(**HELLO))
        self.assertEqual(client.receive()["error"]["code"], -32002)  # a batch of too many
        self.assertEqual(client.receive()["id"], 7)
        client.close()

    def test_who_ends_its_half_still_gets_replies(self):
        with connect(self.server.port) as connection:
            hello = line(**{**HELLO, "params": {"token": stored_token(self.server.port)}})
            connection.sendall((hello * 3).encode()[:-1])  # the last line has no end
            connection.shutdown(socket.SHUT_WR)
            with connection.makefile("rb") as file:
                self.assertEqual(len(file.read().splitlines()), 3)

    def test_other_protocols_are_hung_up_on(self):
        for begin in OTHER_PROTOCOLS + [b"GET / HTTP/1.1\r\nHost: x\r\n\r\n", b" \r\n\tGET / HTTP/1.1\r\n",
                                        b"POST / HTTP/1.1\r\nContent-Length: 9\r\n\r\n" + line(**HELLO).encode()]:
            self.assertTrue(hangs_up(self.server.port, begin), begin)
        self.assertIn("result", Lines(self.server.port).ask("session.hello"))

    def test_examples_of_all_methods_are_what_they_take(self):
        client = Lines(self.server.port)
        methods = client.ask("session.methods")["result"]
        self.assertGreater(len(methods), 8)
        for method in methods:
            reply = client.ask(method["name"], **method["example"])
            self.assertNotIn(reply.get("error", {}).get("code"), (-32602, -32601, -32603), (method["name"], reply))
        client.close()

    def test_several_clients_get_their_own_replies(self):
        wrong = []

        def talk(number):
            client = Lines(self.server.port)
            for i in range(200):
                client.send(line(id=f"{number}/{i}", method="session.hello"))
            for i in range(200):
                if client.receive()["id"] != f"{number}/{i}":
                    wrong.append((number, i))
            client.close()

        threads = [threading.Thread(target=talk, args=[i]) for i in range(16)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(wrong, [])


class Hostile(unittest.TestCase):
    """What is broken, or ends in the middle."""

    def test_damaged_lines_do_not_end_it(self):
        rng = random.Random(1)
        valid = [json.dumps(HELLO), json.dumps({**HELLO, "method": "session.mode", "params": {"mode": "world"}}),
                 json.dumps({**HELLO, "method": "catalogue.list", "params": {"what": "worlds", "of": "7"}})]
        with Server(THENAR, "serve", "--port", "0") as server:
            sizes = []
            for turn in range(4):
                client = Lines(server.port)
                for _ in range(50):
                    client.send(b"\n".join(mutated(rng, rng.choice(valid)) for _ in range(50)) + b"\n")
                    client.send(line(id="end", method="session.hello"))
                    while True:
                        reply = client.receive()
                        if isinstance(reply, dict) and reply.get("id") == "end":
                            break
                client.close()
                sizes.append(server.memory())
            print(f"10,000 damaged lines: {sizes} kB")
            self.assertLess(sizes[-1] - sizes[0], 20000)
            self.assertEqual(server.stop()[0], 0)

    def test_damaged_messages_of_websockets_do_not_end_it(self):
        rng = random.Random(2)
        valid = [json.dumps(HELLO), json.dumps({**HELLO, "method": "session.mode", "params": {"mode": "world"}})]
        with Server(THENAR, "view", "--no-open") as server:
            sizes = []
            for turn in range(4):
                client = None
                for i in range(2500):
                    client = client or WebSocket(server.port)
                    data = mutated(rng, rng.choice(valid))
                    try:
                        # As text what is no UTF-8 ends a connection; as bytes it is told.
                        client.send(data, rng.choice([WebSocket.TEXT, WebSocket.BINARY]), rng.random() > 0.01)
                        if i % 10 == 0:
                            client.ask("session.hello")
                            client.kept.clear()
                    except (ConnectionError, KeyError):
                        client.close()
                        client = None
                if client:
                    client.close()
                sizes.append(server.memory())
            print(f"10,000 damaged messages: {sizes} kB")
            self.assertLess(sizes[-1] - sizes[0], 20000)
            probe = WebSocket(server.port)
            self.assertIn("result", probe.ask("session.hello"))
            self.assertEqual(server.stop()[0], 0)

    def test_damaged_requests_of_http_do_not_end_it(self):
        rng = random.Random(4)
        with Server(THENAR, "view", "--no-open") as server:
            valid = f"GET /ws?token={stored_token(server.port)} HTTP/1.1\r\nHost: 127.0.0.1:{server.port}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n" \
                    "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\nCookie: a=b; c\r\n\r\n"
            first = None
            for i in range(1000):
                data = bytearray(valid.encode() * rng.choice([1, 1, 2]))
                for _ in range(rng.randint(0, 6)):
                    data[rng.randrange(len(data))] = rng.randrange(256)
                at = rng.randrange(len(data))
                data[at:at] = rng.choice([b"", b"\x00", b"a" * 20000, b"\r\n", b"%" * 100, b"Content-Length: 99999999\r\n"])
                with connect(server.port) as connection:
                    connection.sendall(data)
                    if rng.random() < 0.3:
                        connection.settimeout(0.02)
                        try:
                            connection.recv(1000)
                        except OSError:
                            pass
                if i == 200:
                    first = server.memory()
            self.assertLess(server.memory() - first, 20000)
            self.assertEqual(http(server.port)[0], 200)
            self.assertEqual(server.stop()[0], 0)

    def test_who_says_nothing_takes_no_place_of_others_for_long(self):
        with Server(THENAR, "view", "--no-open") as server:
            watcher = WebSocket(server.port)
            idle = [connect(server.port) for _ in range(300)]  # 64 are held
            self.assertIn("result", watcher.ask("session.hello"))
            self.assertEqual(http(server.port)[0], 200)
            self.assertIn("result", WebSocket(server.port).ask("session.hello"))
            for connection in idle:
                connection.close()
            self.assertEqual(server.stop()[0], 0)

    def test_messages_that_are_too_long_are_told(self):
        with Server(THENAR, "view", "--no-open") as server:
            client = WebSocket(server.port)
            client.send(b'"' + b"a" * (65 << 20) + b'"')
            client.ask("session.hello")
            self.assertEqual([m["error"]["code"] for m in client.kept if isinstance(m, dict) and "error" in m], [-32002])
            client.send(b'"' + b"a" * (20 << 20) + b'"', final=False)
            with self.assertRaises(ConnectionError):  # more than is read at all
                for _ in range(20):
                    client.send(b"a" * (20 << 20), opcode=0, final=False)
                client.ask("session.hello")
            self.assertIn("result", WebSocket(server.port).ask("session.hello"))
            self.assertEqual(server.stop()[0], 0)

    def test_sudden_ends_do_not_end_it(self):
        rng = random.Random(3)
        with Server(THENAR, "view", "--no-open", "--remote", "0") as server:
            remote = int(server.process.stdout.readline().rsplit(":", 1)[1])
            first = None
            for i in range(100):
                if i % 2:
                    client = Lines(remote)
                    client.send((line(**HELLO) * 50)[:rng.randint(1, 3000)])
                else:
                    client = WebSocket(server.port)
                    client.send(json.dumps(HELLO))
                    client.connection.sendall(b"\x81\xfe\x10\x00abcd" + b"x" * rng.randint(0, 4000))  # of 4096 bytes
                if rng.random() < 0.5:  # RST in place of FIN
                    client.connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
                if isinstance(client, Lines):
                    client.file.close()
                client.close()
                first = first or server.memory()
            client = Lines(remote)
            self.assertEqual(client.ask("session.hello")["result"]["program"], "thenar")
            watcher = WebSocket(server.port)
            until(lambda: watcher.notification("state")["clients"] == 2, "the others are forgotten")
            self.assertLess(server.memory() - first, 20000)
            self.assertEqual(server.stop()[0], 0)

    def test_no_more_than_64_clients_come_in(self):
        with Server(THENAR, "serve", "--port", "0", "--no-token") as server:
            clients = [Lines(server.port) for _ in range(64)]
            for client in clients:
                client.ask("session.hello")
            last = Lines(server.port)
            last.send(line(**HELLO))
            self.assertIn("64 clients", last.receive()["error"]["message"])
            clients[0].file.close()
            clients[0].close()

            def comes_in():
                client = Lines(server.port)
                client.send(line(**HELLO))
                found = client.receive()
                client.file.close()
                client.close()
                return "result" in found

            until(comes_in, "there is room again")
            self.assertEqual(server.stop()[0], 0)

    def test_who_shows_no_token_takes_no_place_of_others(self):
        token = "0123456789abcdef"
        with Server(THENAR, "serve", "--port", "0", "--token", token) as server:
            silent = [connect(server.port) for _ in range(60)]  # fewer than are held
            with Remote(port=server.port, token=token) as good:
                self.assertEqual(good.session.hello()["program"], "thenar")
                # Silent ones are hung up on after a while; who has shown the token stays.
                self.assertEqual(select.select(silent, [], [], 0)[0], [])
                for connection in silent:
                    self.assertEqual(connection.recv(1), b"")
                    connection.close()
                self.assertEqual(good.session.hello()["program"], "thenar")
            crowd = [connect(server.port) for _ in range(300)]  # 64 are held; the oldest make room
            self.assertEqual(crowd[0].recv(1), b"")
            with Remote(port=server.port, token=token) as good:
                self.assertEqual(good.session.hello()["program"], "thenar")
            for connection in crowd:
                connection.close()
            self.assertEqual(server.stop()[0], 0)

    def test_who_reads_nothing_is_read_no_further(self):
        with Server(THENAR, "serve", "--port", "0") as server:
            client = Lines(server.port)
            other = Lines(server.port)
            batch = json.dumps([{**HELLO, "method": "session.methods"}] * 100) + "\n"  # answered by 400 kB and more
            client.connection.settimeout(1)
            with self.assertRaises(TimeoutError):
                for _ in range(20000):
                    client.send(batch)
            self.assertIn("result", other.ask("session.hello"))
            self.assertLess(server.memory(), 400000)
            self.assertEqual(server.stop()[0], 0)


class Access(unittest.TestCase):
    """Access: other names, other pages, tokens."""

    def test_other_names_and_pages_are_refused(self):
        with Server(THENAR, "view", "--no-open") as server:
            port = server.port
            self.assertEqual(http(port)[0], 200)
            for host in ("evil.example", f"evil.example:{port}", f"127.0.0.1.evil.example:{port}", f"192.0.2.7:{port}", ""):
                self.assertEqual(http(port, host=host)[0], 403, host)
                self.assertEqual(WebSocket(port, host=host).status, 403, host)
            for origin in ("http://evil.example", "null", f"http://127.0.0.1:{port + 1}", f"https://127.0.0.1:{port}"):
                self.assertEqual(WebSocket(port, origin=origin).status, 403, origin)
            self.assertEqual(WebSocket(port, origin=f"http://127.0.0.1:{port}").status, 101)
            self.assertEqual(WebSocket(port, host=f"localhost:{port}", origin=f"http://localhost:{port}").status, 101)
            self.assertEqual(WebSocket(port, host="localhost:9", origin="http://localhost:9").status, 101)  # forwarded
            self.assertEqual(WebSocket(port, host="evil.example", origin="http://evil.example").status, 403)  # rebound
            self.assertEqual(http(port, method="POST")[0], 405)
            self.assertEqual(http(port, "/../../etc/passwd")[0], 404)
            self.assertEqual(http(port, "/mesh/" + "0" * 32)[0], 404)
            _, headers, _ = http(port)
            self.assertIn("default-src 'self'", headers["content-security-policy"])
            self.assertEqual(server.stop()[0], 0)

    def test_tokens_are_wanted_from_everybody(self):
        token = "0123456789abcdef"
        with Server(THENAR, "view", "--no-open", "--token", token, "--remote", "0") as server:
            port, remote = server.port, int(server.process.stdout.readline().rsplit(":", 1)[1])
            self.assertIn("?token=" + token, server.lines[0])
            for target in ("/", "/?token=0123456789abcdeF", "/?token=", "/live.js", "/mesh/1?token=" + token[:-1]):
                self.assertEqual(http(port, target, token=None)[0], 401, target)
            status, headers, _ = http(port, "/?token=" + token, token=None)
            self.assertEqual(status, 200)
            cookie = headers["set-cookie"].split(";")[0]
            self.assertIn("HttpOnly", headers["set-cookie"])
            self.assertEqual(http(port, "/live.js", headers=["Cookie: " + cookie], token=None)[0], 200)
            self.assertEqual(WebSocket(port, token=None).status, 401)
            self.assertEqual(WebSocket(port, cookie=cookie[:-1] + "0", token=None).status, 401)
            self.assertEqual(WebSocket(port, cookie=cookie, token=None).status, 101)
            self.assertEqual(WebSocket(port, target="/ws?token=" + token, token=None).status, 101)
            for first in (line(id=1, method="session.methods"), line(id=1, method="session.hello", params={"token": "x" * 16}),
                          line(id=1, method="session.hello", params={"token": 3}), "[]\n"):
                client = Lines(remote, token=None)
                client.send(first + line(id=2, method="session.methods"))
                self.assertIn("token", client.receive()["error"]["message"])
                with self.assertRaises(ConnectionError):
                    client.receive()
            with self.assertRaises(RemoteError):
                Remote(port=remote, token="x" * 16)
            with Remote(port=remote, token=token) as good:
                self.assertEqual(good.session.hello()["program"], "thenar")
                self.assertNotIn(token, good.session.log()["log"])
            self.assertEqual(server.stop()[0], 0)

    def test_users_of_this_machine_need_the_token_too(self):
        with Server(THENAR, "view", "--no-open", "--remote", "0") as server:
            remote = int(server.process.stdout.readline().rsplit(":", 1)[1])
            token = server.lines[0].strip().partition("?token=")[2]
            self.assertEqual(len(token), 32)
            for port in (server.port, remote):
                file = pathlib.Path(os.environ["XDG_RUNTIME_DIR"], "thenar", f"{port}.token")
                self.assertEqual(file.read_text(), token + "\n")
                self.assertEqual((file.stat().st_mode & 0o777, file.parent.stat().st_mode & 0o777), (0o600, 0o700))
            self.assertEqual([http(server.port, token=None)[0], WebSocket(server.port, token=None).status], [401, 401])
            with self.assertRaises(RemoteError):
                Remote(port=remote, token="")
            for host in ("127.0.0.1", "localhost"):
                with Remote(host, remote) as good:
                    self.assertEqual(good.hello["program"], "thenar")
            self.assertEqual(server.stop()[0], 0)
            self.assertEqual(list(file.parent.iterdir()), [])
        with Server(THENAR, "serve", "--port", "0", "--no-token") as server:
            self.assertEqual(list(file.parent.iterdir()), [])
            with Remote(port=server.port, token="") as anybody:
                self.assertEqual(anybody.hello["program"], "thenar")
            out = server.stop()[1]
            self.assertNotIn("token", out)

    def test_a_file_that_was_left_behind_or_planted_gives_way(self):
        folder = pathlib.Path(os.environ["XDG_RUNTIME_DIR"], "thenar")
        with Server(THENAR, "serve", "--port", "0") as server:
            port = server.port
            folder.chmod(0o755)  # others may have looked in
            self.assertEqual(server.stop(signal.SIGKILL)[0], -signal.SIGKILL)
        self.assertTrue((folder / f"{port}.token").exists())
        with tempfile.TemporaryDirectory() as elsewhere:
            victim = pathlib.Path(elsewhere, "victim")
            victim.write_text("own words")
            (folder / f"{port}.token").unlink()
            (folder / f"{port}.token").symlink_to(victim)
            with Server(THENAR, "serve", "--port", str(port)) as server:
                self.assertEqual(server.port, port)
                self.assertEqual((folder.stat().st_mode & 0o777, (folder / f"{port}.token").is_symlink()), (0o700, False))
                self.assertIn("result", Lines(port).ask("session.hello"))
                self.assertEqual(server.stop()[0], 0)
            self.assertEqual(victim.read_text(), "own words")

    def test_a_server_runs_without_a_place_for_its_token(self):
        places = {name: os.environ.get(name) for name in ("XDG_RUNTIME_DIR", "XDG_CACHE_HOME", "HOME")}
        try:
            for name in places:
                os.environ[name] = "/proc/nowhere"
            with Server(THENAR, "serve", "--port", "0") as server:
                token = server.process.stdout.readline().split()[1]
                with Remote(port=server.port, token=token) as good:
                    self.assertEqual(good.hello["program"], "thenar")
                self.assertIn("the token is kept in no file", server.stop()[2])
        finally:
            for name, value in places.items():
                os.environ.pop(name)
                if value is not None:
                    os.environ[name] = value

    def test_the_page_hangs_up_on_other_protocols(self):
        with Server(THENAR, "view", "--no-open") as server:
            for begin in OTHER_PROTOCOLS + [b"{}", b"get / HTTP/1.1\r\n", b"GETS / HTTP/1.1\r\n\r\n", b"\r\nGET / HTTP/1.1\r\n\r\n"]:
                self.assertTrue(hangs_up(server.port, begin), begin)
            with connect(server.port) as slow:  # byte by byte it is still HTTP
                for byte in f"GET /?token={stored_token(server.port)} HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n".encode():
                    slow.sendall(bytes([byte]))
                self.assertTrue(slow.recv(100).startswith(b"HTTP/1.1 200"))
            self.assertEqual(server.stop()[0], 0)

    def test_the_browser_is_sent_to_an_address_without_the_token(self):
        with tempfile.TemporaryDirectory() as folder:
            told = pathlib.Path(folder, "told")
            opener = pathlib.Path(folder, "xdg-open")
            opener.write_text(f"#!/bin/sh\necho \"$1\" > {told}.new\nmv {told}.new {told}\n")
            opener.chmod(0o755)
            before = os.environ["PATH"], os.environ.get("DISPLAY")
            os.environ.update(PATH=folder + os.pathsep + before[0], DISPLAY=":0")
            try:
                with Server(THENAR, "view") as server:
                    until(told.exists, "the browser is opened")
                    target = told.read_text().strip().partition(f":{server.port}")[2]
                    token = stored_token(server.port)
                    self.assertNotIn(token, target)
                    status, headers, _ = http(server.port, target, token=None)
                    self.assertEqual(status, 200)
                    self.assertIn(token, headers["set-cookie"])
                    self.assertEqual(http(server.port, target, token=None)[0], 401)  # it counts once
                    self.assertEqual(server.stop()[0], 0)
            finally:
                os.environ["PATH"] = before[0]
                os.environ.pop("DISPLAY")
                if before[1] is not None:
                    os.environ["DISPLAY"] = before[1]

    def test_a_token_is_of_no_use_to_standard_input(self):
        _, error = run("serve", "--stdio", "--token", "0123456789abcdef", code=1)
        self.assertIn("wanted no --token", error)

    def test_help_says_how_many_files_there_may_be(self):
        self.assertIn("thenar view [OPTIONS] [file...]\n", run("view", "--help")[0])
        self.assertIn("thenar serve [OPTIONS] [file]\n", run("serve", "--help")[0])

    def test_other_machines_come_in_with_a_token_alone(self):
        for more in ([], ["--no-token"]):
            _, error = run("view", "--bind", "0.0.0.0", "--no-open", *more, code=1)
            self.assertIn("--token", error)
        _, error = run("serve", "--port", "0", "--token", "short", code=1)
        self.assertIn("at least 16 characters", error)
        with Server(THENAR, "view", "--bind", "0.0.0.0", "--token", "auto", "--no-open") as server:
            token = server.lines[0].strip().rsplit("=", 1)[1]
            self.assertEqual(len(token), 32)
            self.assertEqual(http(server.port, host=f"192.0.2.7:{server.port}", token=token)[0], 200)
            self.assertEqual(http(server.port, host=f"evil.example:{server.port}", token=token)[0], 403)
            self.assertEqual(server.stop()[0], 0)


class Command(unittest.TestCase):
    """The commands themselves: what they refuse, logs, signals, standard input."""

    def test_mistakes_are_named(self):
        self.assertIn("--port N, --stdio", run("serve", code=1)[1])
        self.assertIn("no file 'nosuch'", run("view", "nosuch", "--no-open", code=1)[1])
        self.assertIn("wanted a world", run("serve", str(pathlib.Path(__file__).resolve()), "--stdio", code=1)[1])
        with Server(THENAR, "serve", "--port", "0") as server:
            _, error = run("serve", "--port", str(server.port), code=1)
            self.assertIn("Address already in use", error)
            self.assertEqual(server.stop(signal.SIGTERM)[0], 0)

    def test_standard_input_is_answered_to_its_end(self):
        out, _ = run("serve", "--stdio", text=line(**HELLO) + "nonsense\n" + line(method="session.hello") + line(**HELLO)[:-1])
        replies = [json.loads(text) for text in out.splitlines()]
        self.assertEqual([reply["id"] for reply in replies], [7, None, 7])
        with tempfile.NamedTemporaryFile("w+") as file:  # a file in place of a pipe
            file.write(line(**HELLO) * 500)
            file.flush()
            file.seek(0)
            done = subprocess.run([THENAR, "serve", "--stdio"], stdin=file, capture_output=True, text=True, timeout=HANG)
            self.assertEqual(len(done.stdout.splitlines()), 500)

    def test_who_reads_nothing_does_not_keep_it_from_its_end(self):
        process = subprocess.Popen([THENAR, "serve", "--stdio"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        process.stdin.write((line(**{**HELLO, "method": "session.methods"}) * 50).encode())
        process.stdin.flush()
        time.sleep(0.5)
        process.send_signal(signal.SIGINT)
        process.wait(timeout=HANG)
        self.assertEqual(process.returncode, 0)
        process.communicate()

    def test_logs_are_repeated(self):
        with tempfile.TemporaryDirectory() as folder:
            log = os.path.join(folder, "session.jsonl")
            with Server(THENAR, "serve", "--port", "0", "--log", log, folder=folder) as server:
                client = Lines(server.port)
                client.ask("catalogue.list", what="worlds")
                client.ask("session.mode", mode="fit")  # refused
                client.ask("session.methods")
                inside = client.ask("session.log")["result"]["log"]
                self.assertEqual(server.stop()[0], 0)
            text = pathlib.Path(log).read_text()
            self.assertEqual(text, inside)
            methods = [json.loads(text)["request"]["method"] for text in text.splitlines()]
            self.assertEqual(methods[-3:], ["catalogue.list", "session.mode", "session.methods"])
            again = os.path.join(folder, "again.jsonl")
            self.assertIn("all replies are as they were", run("serve", "--replay", log, "--log", again, folder=folder)[0])
            self.assertEqual(pathlib.Path(again).read_text(), text)
            # A reply that was another one is found where it stands.
            lines = text.splitlines()
            last = json.loads(lines[-1])
            last["reply"] = "0" * 64
            pathlib.Path(log).write_text("\n".join([*lines[:-1], json.dumps(last)]) + "\n")
            self.assertIn(f"the last reply differs: {log}:{len(lines)}\n", run("serve", "--replay", log, code=1, folder=folder)[0])
            # Nothing behind it is repeated.
            pathlib.Path(log).write_text("\n".join([json.dumps(last), *lines[1:]]) + "\n")
            self.assertIn(f"1 requests repeated, the last reply differs: {log}:1\n", run("serve", "--replay", log, code=1, folder=folder)[0])
            pathlib.Path(log).write_text(lines[0] + "\n{}\n")
            self.assertIn(f"{log}:2:", run("serve", "--replay", log, code=1, folder=folder)[1])

    def test_a_log_writes_nothing_unless_told_to(self):
        with tempfile.TemporaryDirectory() as folder, tempfile.TemporaryDirectory() as other:
            log = os.path.join(other, "session.jsonl")
            with Server(THENAR, "serve", "--port", "0", "--log", log, folder=folder) as server:
                client = Lines(server.port)
                client.ask("world.save", file="saved.toml")
                client.ask("world.save", file="../escaped.toml")  # refused
                client.ask("world.get")
                self.assertEqual(server.stop()[0], 0)
            pathlib.Path(folder, "saved.toml").unlink()
            out, _ = run("serve", "--replay", log, folder=folder)
            self.assertIn("all replies are as they were; 2 that write files were skipped", out)
            self.assertEqual(os.listdir(folder), [])
            chosen = pathlib.Path(other, "chosen")
            chosen.mkdir()
            out, _ = run("serve", "--replay", log, "--replay-writes", str(chosen), folder=folder)
            self.assertIn("all replies are as they were\n", out)
            self.assertEqual((os.listdir(folder), os.listdir(chosen)), ([], ["saved.toml"]))

    def test_what_watches_is_told_the_end(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            with Server(THENAR, "view", "--no-open") as server:
                client = WebSocket(server.port)
                client.ask("session.hello")
                code, _, _ = server.stop(number)
                self.assertEqual(code, 0)
                self.assertIn("stopped", client.notification("ended")["reason"])


class Client(unittest.TestCase):
    """clients/python/thenar_remote.py."""

    def test_methods_errors_and_batches(self):
        with Remote.start(program=THENAR) as remote:
            self.assertEqual(remote.hello["protocol"], 1)
            self.assertEqual(remote.session.hello()["program"], "thenar")
            with self.assertRaises(RemoteError) as told:
                remote.session.mode(mode="no such")
            self.assertEqual(told.exception.code, -32602)
            with remote.batch() as batch:
                batch.session.hello()
                batch.session.mode(mode="no such")
            self.assertEqual(batch.results[0]["program"], "thenar")
            self.assertEqual(batch.results[1].code, -32602)
            with self.assertRaises(ValueError):
                remote.session.mode(mode=float("nan"))
            process = remote._process
        self.assertEqual(process.returncode, 0)

    def test_ends_are_told(self):
        with self.assertRaises(RemoteError):
            Remote.start(program="/no/such/thenar")
        with self.assertRaises(RemoteError):
            Remote.start("no such world", program=THENAR)
        with Server(THENAR, "serve", "--port", "0") as server:
            remote = Remote(port=server.port)
            server.stop()
            with self.assertRaises(RemoteError):
                remote.session.hello()
            with self.assertRaises(RemoteError):
                Remote(port=server.port)


if __name__ == "__main__":
    unittest.main(verbosity=2, warnings="ignore")

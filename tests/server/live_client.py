"""Clients of a live server from the standard library alone: raw HTTP, WebSocket (RFC 6455), lines of TCP; and the server
as a process that ends with the test."""
import base64
import json
import os
import pathlib
import re
import signal
import socket
import struct
import subprocess
import sys
import tempfile
import time

sys.path[:0] = [str(pathlib.Path(__file__).resolve().parents[i] / folder) for i, folder in ((1, "apps"), (2, "clients/python"))]
from patience import HANG  # noqa: E402
from thenar_remote import stored_token  # noqa: E402

# Tokens of these tests are kept among no others.
RUNTIME = tempfile.TemporaryDirectory()
os.environ["XDG_RUNTIME_DIR"] = RUNTIME.name


class Server:
    """`thenar view` or `thenar serve` on free ports, in an empty folder that what it saves goes to."""

    def __init__(self, thenar, *words, folder=None):
        self.folder = None if folder else tempfile.TemporaryDirectory()
        self.process = subprocess.Popen([pathlib.Path(thenar).resolve(), *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                        text=True, cwd=folder or self.folder.name)
        self.lines = [self.process.stdout.readline()]
        found = re.search(r":(\d+)", self.lines[0])
        if found is None:
            raise AssertionError(f"no address: {self.lines} {self.process.stderr.read()}")
        self.port = int(found[1])

    def memory(self):
        """Resident memory [kB]."""
        status = pathlib.Path(f"/proc/{self.process.pid}/status").read_text()
        return int(re.search(r"VmRSS:\s+(\d+)", status)[1])

    def stop(self, number=signal.SIGINT):
        """Ends it by a signal. Returns exit code, the rest of its output, and its errors."""
        self.process.send_signal(number)
        out, err = self.process.communicate(timeout=HANG)
        if self.folder:
            self.folder.cleanup()
        return self.process.returncode, out, err

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.kill()
            self.process.communicate()


def connect(port):
    found = socket.create_connection(("127.0.0.1", port), timeout=HANG)
    found.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    return found


def with_token(target, token):
    """A target with the token that is wanted there. None leaves it as it is."""
    return target if token is None else target + ("&" if "?" in target else "?") + "token=" + token


KEPT = object()  # the token that the server keeps in a file, as its clients take it


def token_of(port, token):
    return stored_token(port) if token is KEPT else token


def http(port, target="/", host=None, method="GET", headers=(), token=KEPT):
    """(status, headers, body) of one request on a connection of its own."""
    host = f"127.0.0.1:{port}" if host is None else host
    target = with_token(target, token_of(port, token))
    with connect(port) as connection:
        lines = [f"{method} {target} HTTP/1.1", f"Host: {host}", "Connection: close", *headers, "", ""]
        connection.sendall("\r\n".join(lines).encode())
        answer = b""
        while more := connection.recv(65536):
            answer += more
    head, _, body = answer.partition(b"\r\n\r\n")
    first, *rest = head.decode().split("\r\n")
    return int(first.split()[1]), {k.lower(): v for k, _, v in (line.partition(": ") for line in rest)}, body


class WebSocket:
    """A WebSocket at /ws. Frames are (opcode, payload); texts and binary messages come whole."""

    TEXT, BINARY, CLOSE, PING, PONG = 1, 2, 8, 9, 10

    def __init__(self, port, host=None, origin=None, target="/ws", cookie=None, token=KEPT):
        self.connection = connect(port)
        target = with_token(target, token_of(port, token))
        self.bytes = b""
        self.last_id, self.kept = 0, []
        host = f"127.0.0.1:{port}" if host is None else host
        lines = [f"GET {target} HTTP/1.1", f"Host: {host}", "Upgrade: websocket", "Connection: Upgrade",
                 "Sec-WebSocket-Version: 13", "Sec-WebSocket-Key: " + base64.b64encode(os.urandom(16)).decode()]
        lines += [f"Origin: {origin}"] if origin else []
        lines += [f"Cookie: {cookie}"] if cookie else []
        self.connection.sendall("\r\n".join(lines + ["", ""]).encode())
        while b"\r\n\r\n" not in self.bytes:
            more = self.connection.recv(65536)
            if not more:
                raise ConnectionError("closed before it was a WebSocket")
            self.bytes += more
        head, _, self.bytes = self.bytes.partition(b"\r\n\r\n")
        self.status = int(head.split()[1])

    def send(self, payload, opcode=TEXT, final=True):
        payload = payload.encode() if isinstance(payload, str) else payload
        mask = b"\x37\xfa\x21\x3d"
        head = bytes([(0x80 if final else 0) | opcode])
        size = len(payload)
        head += bytes([0x80 | size]) if size < 126 else (
            bytes([0xFE]) + struct.pack(">H", size) if size < 65536 else bytes([0xFF]) + struct.pack(">Q", size))
        key = int.from_bytes((mask * (size // 4 + 1))[:size], "big") if size else 0
        masked = (int.from_bytes(payload, "big") ^ key).to_bytes(size, "big") if size else b""
        self.connection.sendall(head + mask + masked)

    def _take(self, count):
        while len(self.bytes) < count:
            more = self.connection.recv(1 << 20)
            if not more:
                raise ConnectionError("closed")
            self.bytes += more
        found, self.bytes = self.bytes[:count], self.bytes[count:]
        return found

    def receive(self):
        """The next (opcode, payload), put together from its pieces; pings are answered."""
        kind, whole = None, b""
        while True:
            first, second = self._take(2)
            size = second & 127
            if size > 125:
                size = int.from_bytes(self._take(2 if size == 126 else 8), "big")
            payload = self._take(size)
            if first & 15 == self.PING:
                self.send(payload, self.PONG)
                continue
            if first & 8:
                return first & 15, payload
            kind, whole = kind or first & 15, whole + payload
            if first & 0x80:
                return kind, whole

    def ask(self, method, **params):
        """The reply to a request; what else comes is kept in order in `kept`."""
        self.last_id += 1
        self.send(json.dumps({"jsonrpc": "2.0", "id": self.last_id, "method": method, "params": params}))
        return self.reply_to(self.last_id)

    def reply_to(self, number):
        while True:
            opcode, payload = self.receive()
            if opcode == self.CLOSE:
                raise ConnectionError(f"closed: {payload!r}")
            message = json.loads(payload) if opcode == self.TEXT else payload
            if isinstance(message, dict) and "method" not in message and message["id"] == number:
                return message
            self.kept.append(message)

    def notification(self, method):
        """The params of the next notification of a method, kept or yet to come."""
        while True:
            for i, message in enumerate(self.kept):
                if isinstance(message, dict) and message.get("method") == method:
                    return self.kept.pop(i)["params"]
            opcode, payload = self.receive()
            self.kept.append(json.loads(payload) if opcode == self.TEXT else payload)

    def frame(self):
        """The next frame, kept or yet to come."""
        while True:
            for i, message in enumerate(self.kept):
                if isinstance(message, bytes):
                    return self.kept.pop(i)
            opcode, payload = self.receive()
            self.kept.append(json.loads(payload) if opcode == self.TEXT else payload)

    def close(self):
        self.connection.close()


class Lines:
    """JSON-RPC as lines of TCP. Shows the token of the server at once, where it keeps one."""

    def __init__(self, port, token=KEPT):
        self.connection = connect(port)
        self.file = self.connection.makefile("rb")
        self.last_id = 0
        token = token_of(port, token)
        if token is not None:
            assert "result" in self.ask("session.hello", token=token)

    def send(self, text):
        self.connection.sendall(text if isinstance(text, bytes) else text.encode())

    def receive(self):
        line = self.file.readline()
        if not line:
            raise ConnectionError("closed")
        return json.loads(line)

    def ask(self, method, **params):
        self.last_id += 1
        self.send(json.dumps({"jsonrpc": "2.0", "id": self.last_id, "method": method, "params": params}) + "\n")
        return self.receive()

    def close(self):
        self.connection.close()


def until(true, what):
    """Waits until true() says so."""
    end = time.monotonic() + HANG
    while not true():
        if time.monotonic() > end:
            raise AssertionError("waited too long until " + what)
        time.sleep(0.01)

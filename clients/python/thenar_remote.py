"""Remote control of thenar from Python, with the standard library alone.

    from thenar_remote import Remote

    with Remote.start("jaw_box") as thenar:              # runs `thenar serve jaw_box --stdio`
        thenar.hand.close()
        print(thenar.grasp.quality()["epsilon"])

    with Remote("127.0.0.1", 8081) as thenar:            # `thenar view jaw_box --remote 8081`: watch it in the browser
        thenar.hand.set_joints(joints={"opening": 0.01})

Every method of docs/remote.md is called by its name, with its parameters by name, and returns its result as Python has
JSON: dicts, lists, numbers. SI units and radians; positions [x, y, z], rotations [w, x, y, z].
"""
import ipaddress
import itertools
import json
import os
import queue
import socket
import subprocess
import threading


class RemoteError(Exception):
    """What thenar refused, or that it cannot be reached. `code` is that of JSON-RPC: -32602 for parameters, -32000 for
    what thenar itself says no to, -32001 for what was stopped; None if there was no reply at all."""

    def __init__(self, message, code=None):
        super().__init__(message)
        self.code = code


def stored_token(port):
    """The token that a server of this user at a port of this machine keeps in a file; None if there is none."""
    found = []
    for variable, below in (("XDG_RUNTIME_DIR", "thenar"), ("XDG_CACHE_HOME", "thenar"), ("HOME", ".cache/thenar")):
        if not os.environ.get(variable):
            continue
        try:
            with open(os.path.join(os.environ[variable], below, f"{port}.token"), encoding="ascii") as file:
                about = os.fstat(file.fileno())
                # What others may have written is no token of ours.
                if about.st_uid == os.getuid() and about.st_mode & 0o077 == 0:
                    found.append((about.st_mtime_ns, file.read().strip()))
        except (OSError, ValueError):
            pass
    return max(found)[1] if found else None


def _is_this_machine(host):
    try:
        return host == "localhost" or ipaddress.ip_address(host).is_loopback
    except ValueError:
        return False


class _Group:
    """The methods of a group: remote.hand.close(...) calls "hand.close"."""

    def __init__(self, remote, name):
        self._remote, self._name = remote, name

    def __getattr__(self, method):
        if method.startswith("_"):
            raise AttributeError(method)

        def call(**params):
            return self._remote.call(f"{self._name}.{method}", **params)

        call.__name__ = method
        return call


class Batch:
    """Requests that travel together and are answered in one go.

        with remote.batch() as batch:
            batch.hand.open()
            batch.hand.close()
        batch.results                                    # of all, in order; RemoteError where one was refused
    """

    def __init__(self, remote):
        self._remote, self._requests, self.results = remote, [], None

    def call(self, method, **params):
        self._requests.append((method, params))

    def __getattr__(self, group):
        if group.startswith("_"):
            raise AttributeError(group)
        return _Group(self, group)

    def __enter__(self):
        return self

    def __exit__(self, kind, *_):
        if kind is None:
            self.results = self._remote.call_all(self._requests)


class Remote:
    """A connection to a thenar that runs. Not for several threads at once, but for stop()."""

    def __init__(self, host="127.0.0.1", port=8081, token=None, timeout=60.0):
        """Connects to `thenar serve --port` or `thenar view --remote`.

        token: as the server printed it; None: as it keeps it for programs of this user on this machine.
        timeout: for a reply [s]; None waits for ever.
        Raises RemoteError if nobody listens, or the token is another one.
        """
        if token is None and _is_this_machine(host):
            token = stored_token(port)
        try:
            connection = socket.create_connection((host, port), timeout=timeout)
        except OSError as error:
            raise RemoteError(f"cannot reach thenar at {host}:{port}: {error}") from error
        connection.settimeout(None)
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self._begin(connection.makefile("rb"), connection.makefile("wb", buffering=0), timeout)
        self._connection = connection
        self.hello = self.call("session.hello", **({"token": token} if token else {}))

    @classmethod
    def start(cls, world=None, program="thenar", options=(), timeout=60.0):
        """Runs `thenar serve [world] --stdio` and talks to it; it ends with this connection.

        options: more words for its command line, as ["--log", "session.jsonl"].
        Raises RemoteError if it does not start, with what it said.
        """
        words = [program, "serve", *([world] if world else []), "--stdio", *options]
        try:
            process = subprocess.Popen(words, stdin=subprocess.PIPE, stdout=subprocess.PIPE, bufsize=0)
        except OSError as error:
            raise RemoteError(f"cannot start {program}: {error}") from error
        remote = cls.__new__(cls)
        remote._begin(process.stdout, process.stdin, timeout)
        remote._process = process
        remote.hello = remote.call("session.hello")
        return remote

    def _begin(self, reader, writer, timeout):
        self._connection = self._process = None
        self._reader, self._writer, self.timeout = reader, writer, timeout
        self._ids, self._replies, self._writing = itertools.count(1), queue.Queue(), threading.Lock()
        threading.Thread(target=self._read, daemon=True).start()

    def _read(self):
        """Hands over replies line by line, and None at the end of the connection."""
        try:
            for line in self._reader:
                self._replies.put(line)
        except (OSError, ValueError):
            pass
        self._replies.put(None)

    def _send(self, message):
        data = memoryview(json.dumps(message, allow_nan=False).encode() + b"\n")
        try:
            with self._writing:
                while data:
                    data = data[self._writer.write(data):]
        except (OSError, ValueError) as error:
            raise RemoteError(f"the connection to thenar is lost: {error}") from error

    def _receive(self, wanted):
        """The reply to a request. Replies to those that were given up on are dropped."""
        while True:
            try:
                line = self._replies.get(timeout=self.timeout)
            except queue.Empty:
                raise RemoteError(f"no reply within {self.timeout} s") from None
            if line is None:
                self._replies.put(None)
                raise RemoteError("thenar has ended, or closed the connection")
            reply = json.loads(line)
            first = reply[0] if isinstance(reply, list) else reply
            if first.get("id") == wanted:
                return reply
            if first.get("id") is None and "error" in first:
                raise RemoteError(first["error"]["message"], first["error"]["code"])

    def call(self, method, **params):
        """The result of a method by its whole name: call("hand.close", hand="barrett")."""
        number = next(self._ids)
        self._send({"jsonrpc": "2.0", "id": number, "method": method, "params": params})
        reply = self._receive(number)
        if "error" in reply:
            raise RemoteError(reply["error"]["message"], reply["error"]["code"])
        return reply["result"]

    def call_all(self, requests):
        """Results of [(method, params), ..], in order; what was refused is a RemoteError among them."""
        if not requests:
            return []
        numbered = [(next(self._ids), method, params) for method, params in requests]
        self._send([{"jsonrpc": "2.0", "id": number, "method": method, "params": params}
                    for number, method, params in numbered])
        replies = {reply["id"]: reply for reply in self._receive(numbered[0][0])}
        return [RemoteError(replies[number]["error"]["message"], replies[number]["error"]["code"])
                if "error" in replies[number] else replies[number]["result"] for number, _, _ in numbered]

    def batch(self):
        return Batch(self)

    def stop(self):
        """Asks the request that runs to stop and keep what it has. For another thread than the one that waits for it."""
        self._send({"jsonrpc": "2.0", "method": "session.stop"})

    def __getattr__(self, group):
        if group.startswith("_"):
            raise AttributeError(group)
        return _Group(self, group)

    def close(self):
        """Ends the connection, and the program that start() ran."""
        if self._connection is not None:
            try:
                self._connection.shutdown(socket.SHUT_RDWR)
            except OSError:
                pass
        try:
            self._writer.close()
        except OSError:
            pass
        if self._process is not None:
            try:
                self._process.wait(timeout=10)
            except subprocess.TimeoutExpired:
                self._process.kill()
                self._process.wait()
        if self._connection is not None:
            self._connection.close()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

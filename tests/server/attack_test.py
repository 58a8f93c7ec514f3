"""Four attackers: one without the token, one with it, one with a log, one with files. Nothing is written outside of the working
folder but the cache and the token, nothing is executed, and no request ends the server.

Usage: attack_test.py THENAR [ROUNDS]    ROUNDS: how many random names and messages of each kind, default 60
"""
import base64
import itertools
import json
import os
import pathlib
import random
import socket
import subprocess
import sys
import tempfile
import unittest

from live_client import HANG, Lines, Server, WebSocket, connect, http, stored_token

THENAR = str(pathlib.Path(sys.argv.pop(1)).resolve())
ROUNDS = int(sys.argv.pop(1)) if len(sys.argv) > 1 and sys.argv[1].isdigit() else 60
RUNS = "touch \"$HOME/executed\""  # a marker that nobody but a shell makes
WORLD = f"name = '''$({RUNS}) `{RUNS}`'''\nsource = 'Mine'\ndescription = '''\n{RUNS}\n'''\n[sources]\nMine = 'x'\n"
CUBE = ("v 0 0 0\nv .02 0 0\nv 0 .02 0\nv 0 0 .02\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n")


class Machine:
    """A home, a cache, a place for run time files and a working folder full of traps."""

    def __init__(self):
        self.whole = tempfile.TemporaryDirectory()
        self.root = pathlib.Path(self.whole.name)
        for name in ("home/.config", "cache", "run", "tmp", "work/deep", "elsewhere"):
            (self.root / name).mkdir(parents=True, mode=0o700)
        (self.root / "home/.bashrc").write_text("# own words\n")
        (self.root / "home/secret.obj").write_text(CUBE)
        (self.root / "elsewhere/own.toml").write_text("# own words\n")
        work = self.root / "work"
        (work / "dangling.toml").symlink_to(self.root / "home/.profile")
        (work / "leads_out.toml").symlink_to(self.root / "elsewhere/own.toml")
        (work / "outside").symlink_to(self.root / "elsewhere")
        (work / "gone").symlink_to(self.root / "home/new_folder")
        (work / "circle.toml").symlink_to("circle.toml")
        (work / "saved_files").symlink_to(self.root / "elsewhere")
        os.mkfifo(work / "pipe.toml")
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.bind(str(work / "socket.toml"))
        self.before = self.seen()
        os.environ.update(HOME=str(self.root / "home"), XDG_CACHE_HOME=str(self.root / "cache"),
                          XDG_RUNTIME_DIR=str(self.root / "run"), TMPDIR=str(self.root / "tmp"))

    def seen(self):
        """Everything outside of the working folder, the cache and the token: names, kinds, modes, contents."""
        found = {}
        for folder, folders, files in os.walk(self.root):
            at = pathlib.Path(folder)
            if at == self.root:
                folders[:] = [f for f in folders if f not in ("work", "cache", "run")]
            for name in [*folders, *files]:
                path = at / name
                about = path.lstat()
                content = path.read_bytes() if path.is_file() and not path.is_symlink() else b""
                found[str(path.relative_to(self.root))] = (about.st_mode, content)
        return found

    def close(self):
        self.socket.close()
        self.whole.cleanup()


def hostile_names(rng, root, ending=".toml"):
    """Names that lead out, hide, or end otherwise than they seem to: of none of them a file may be written."""
    home = f"{root}/home"
    up = "../" * rng.randint(1, 12)
    return [f"../home/.bashrc", f"{home}/.bashrc", f".bashrc\0{ending}", f"x{ending}\0", f"../home/.bashrc\0{ending}", f"deep/../../home/x{ending}",
             f"outside/x{ending}", f"gone/x{ending}", f"dangling{ending}", f"leads_out{ending}", f"circle{ending}", f"pipe{ending}",
             f"socket{ending}", f".hidden{ending}", f"deep/.hidden/x{ending}", f"{home}/x{ending}", f"//x{ending}", f"~/x{ending}x", f"x\n{ending}",
             f"\x1b[2J{ending}", f"x{ending}/", f"deep{ending}/..", "..", ".", "", "/", f"{up}tmp/x{ending}", f"./{up}x{ending}", f"deep/{up}x{ending}",
             "a" * 300 + ending, "a/" * 1900 + "x" + ending, f"..\\x{ending}", f"C:\\x{ending}", f"\u0085{ending}", f"outside/../x{ending}",
             "/dev/zero", "/dev/stdin", "/dev/random", "/proc/self/mem", "/proc/self/fd/0", "/proc/self/environ", "/dev/tcp/127.0.0.1/1",
             f"|{RUNS}", f"$({RUNS}){ending}x", f"`{RUNS}`", f"; {RUNS};"]


def mixed_names(rng, ending=".toml"):
    """Names of parts as they come; a few of them are good ones."""
    parts = ["..", ".", "outside", "deep", "gone", "home", ".bashrc", "x", "\0", "\n", "/", "work", "~", "", "..\0"]
    return ["/".join(rng.choice(parts) for _ in range(rng.randint(1, 7))) + rng.choice([ending, "", "\0" + ending]) for _ in range(ROUNDS)]


class Attack(unittest.TestCase):
    def setUp(self):
        self.machine = Machine()
        self.addCleanup(self.machine.close)
        self.work = self.machine.root / "work"

    def assert_untouched(self):
        self.assertEqual(self.machine.seen(), self.machine.before)

    def assert_alive(self, server):
        self.assertIn("result", Lines(server.port).ask("session.hello"))

    def run_thenar(self, *words):
        """A command in the working folder. Returns its exit code and what it said."""
        done = subprocess.run([THENAR, *words], capture_output=True, text=True, timeout=HANG, cwd=self.work, errors="replace",
                              stdin=subprocess.DEVNULL)
        self.assertGreaterEqual(done.returncode, 0, done.stderr)  # no signal ended it
        return done.returncode, done.stdout + done.stderr

    def test_without_the_token(self):
        rng = random.Random(11)
        log = self.machine.root / "work/log.jsonl"
        with Server(THENAR, "view", "jaw_box", "--no-open", "--remote", "0", "--log", str(log), folder=self.work) as server:
            opened = log.read_text()
            page, remote = server.port, int(server.process.stdout.readline().rsplit(":", 1)[1])
            token = stored_token(remote)
            save = {"jsonrpc": "2.0", "id": 1, "method": "world.save", "params": {"file": "planted.toml"}}
            guesses = [None, "", token[:-1], token + "0", token.upper() + "G", token[:-1] + "\0", "\0" * 32, "0" * 32, 0, True, [token], {"token": token}, "x" * 400]
            for guess in guesses:
                hello = {"jsonrpc": "2.0", "id": 1, "method": "session.hello", "params": {"token": guess}}
                for first in (hello, [hello], {**hello, "method": "session.stop"}, save, [save], {**save, "params": {"token": guess}}):
                    client = Lines(remote, token=None)
                    client.send(json.dumps(first) + "\n" + json.dumps(save) + "\n")
                    try:
                        self.assertIn("token", client.receive()["error"]["message"])
                        client.receive()
                        self.fail(f"a stranger was answered: {first}")
                    except ConnectionError:
                        pass
                    client.file.close()
                    client.close()
                if isinstance(guess, str) and "\0" not in guess:
                    for target in ("/", "/live.js", "/mesh/" + "0" * 32, "/?once=" + guess):
                        self.assertEqual(http(page, target, token=guess)[0], 401)
                    self.assertEqual(WebSocket(page, token=guess).status, 401)
                    self.assertEqual(WebSocket(page, cookie=f"thenar_{page}={guess}; thenar_={token}", token=None).status, 401)
            # Bytes that are nothing, at both ports.
            for _ in range(ROUNDS):
                for port in (page, remote):
                    with connect(port) as connection:
                        try:
                            connection.sendall(rng.randbytes(rng.randint(1, 3000)))
                            connection.shutdown(socket.SHUT_WR)
                            while more := connection.recv(65536):
                                self.assertNotIn(token.encode(), more)
                        except OSError:
                            pass  # it was hung up on
            self.assertEqual(log.read_text(), opened)  # none of it was executed
            self.assertIn("result", Lines(remote).ask("session.hello"))
            self.assertEqual(server.stop()[0], 0)
        self.assertFalse((self.work / "planted.toml").exists())
        self.assertEqual(list((self.machine.root / "run/thenar").iterdir()), [])
        self.assert_untouched()

    def test_with_the_token(self):
        rng = random.Random(12)
        with Server(THENAR, "serve", "--port", "0", folder=self.work) as server:
            client = Lines(server.port)
            methods = client.ask("session.methods")["result"]
            self.assertIn("result", client.ask("world.load", text=WORLD, name="x"))
            # Saves: hostile names are refused, with and without permission to replace.
            for name in hostile_names(rng, self.machine.root):
                for overwrite in (False, True):
                    reply = client.ask("world.save", file=name, overwrite=overwrite)
                    self.assertIn("error", reply, name)
            for name in mixed_names(rng):
                client.ask("world.save", file=name, overwrite=True)
            # Drops: their names, then a save beside a link in the place of its folder.
            for name in hostile_names(rng, self.machine.root, ".obj") + mixed_names(rng, ".obj"):
                data = base64.b64encode(CUBE.encode()).decode()
                client.ask("world.import", files=[{"name": name, "data": data}], **{"as": "object"})
            # Every text of every method is a hostile one.
            texts = [(method["name"], member) for method in methods for member, schema in method["params"].get("properties", {}).items()
                     if schema.get("type") == "string" and "enum" not in schema]
            self.assertGreater(len(texts), 15)
            for (name, member), text in itertools.product(texts, hostile_names(rng, self.machine.root)):
                example = next(method["example"] for method in methods if method["name"] == name)
                reply = client.ask(name, **{**example, member: text})
                self.assertNotIn(reply.get("error", {}).get("code"), (-32603,), (name, member, text, reply))
            self.assertIn("result", client.ask("world.load", text=WORLD, name="x"))
            self.assertIn("result", client.ask("world.save", file="good/inside.toml"))
            self.assertIn("error", client.ask("world.load", text=WORLD, name="../x"))
            code, out, err = server.stop()
        self.assertEqual(code, 0, err)
        self.assertTrue((self.work / "good/inside.toml").is_file())
        self.assert_untouched()

    def test_with_a_log(self):
        rng = random.Random(13)
        requests = [("world.load", {"text": WORLD, "name": "x"})]
        requests += [("world.save", {"file": name, "overwrite": True}) for name in ["planted.toml", *hostile_names(rng, self.machine.root)]]
        requests += [("motion.record", {"file": name}) for name in hostile_names(rng, self.machine.root) if name[:5] not in ("/dev/", "/proc")]
        requests += [("session.hello", {}), ("no.such", {}), ("world.save", {}), ("world.save", [])]
        # Replies as they would be: the attacker has run them on a machine of the same kind.
        mine = self.machine.root / "work/own.jsonl"
        with Server(THENAR, "serve", "--port", "0", "--log", str(mine), folder=self.work) as server:
            client = Lines(server.port)
            for method, params in requests:
                client.send(json.dumps({"jsonrpc": "2.0", "id": 1, "method": method, "params": params}) + "\n")
                client.receive()
            server.stop()
        (self.work / "planted.toml").unlink()
        here = sorted(path.name for path in self.work.iterdir())
        code, said = self.run_thenar("serve", "--replay", "own.jsonl")
        self.assertEqual(code, 0, said)
        self.assertIn("that write files were skipped", said)
        self.assertEqual(sorted(path.name for path in self.work.iterdir()), here)
        # Told to, it writes into the folder that was named, and nowhere else.
        code, said = self.run_thenar("serve", "--replay", "own.jsonl", "--replay-writes", "deep")
        self.assertTrue((self.work / "deep/planted.toml").is_file(), said)
        self.assertEqual(sorted(path.name for path in self.work.iterdir()), here)
        # A log that was made up ends at its first reply.
        made_up = [json.dumps({"client": 1, "request": {"method": m, "params": p}, "reply": "0" * 64}) for m, p in requests]
        (self.work / "made_up.jsonl").write_text("\n".join(made_up) + "\n")
        code, said = self.run_thenar("serve", "--replay", "made_up.jsonl", "--replay-writes", "deep")
        self.assertEqual(code, 1)
        self.assertIn("1 requests repeated, the last reply differs", said)
        for log in ("circle.toml", "pipe.toml", "socket.toml", "deep", "/dev/zero", "nowhere"):
            self.assertEqual(self.run_thenar("serve", "--replay", log)[0], 1)
        self.assertNotEqual(self.run_thenar("serve", "--stdio", "--log", "dangling.toml")[0], 0)
        self.assert_untouched()

    def test_with_files(self):
        home = str(self.machine.root / "home")
        up = "../" * 12
        outside = [f"{home}/secret.obj", up + home[1:] + "/secret.obj", "file://" + home + "/secret.obj", f"package://home/secret.obj",
                   f"package://x/{up}{home[1:]}/secret.obj", "/dev/zero", "/dev/stdin", str(self.work / "pipe.toml"), f"|{RUNS}", f"$({RUNS})"]
        links = "".join(f"<link name='l{i}'><collision><geometry><mesh filename='{name}'/></geometry></collision></link>"
                        f"<joint name='j{i}' type='fixed'><parent link='base'/><child link='l{i}'/></joint>" for i, name in enumerate(outside))
        files = {
            "robot.urdf": f"<robot name='{RUNS.replace(chr(34), '')}'><link name='base'/>{links}</robot>",
            "model.xml": "<mujoco><asset>" + "".join(f"<mesh name='m{i}' file='{n}'/>" for i, n in enumerate(outside)) + "</asset><worldbody><body>"
                         + "".join(f"<geom type='mesh' mesh='m{i}'/>" for i in range(len(outside))) + "</body></worldbody></mujoco>",
            "include.xml": f"<mujoco><include file='{up}{home[1:]}/x.xml'/></mujoco>",
            "body.xml": f"<root><geometryFile>{outside[1]}</geometryFile></root>",
            "object.toml": f"name = 'x'\nsource = 'Mine'\n[sources]\nMine = 'x'\n[[shape]]\nkind = 'mesh'\nfile = '{outside[1]}'\n",
            "nul.toml": "name = 'x'\nsource = 'Mine'\n[sources]\nMine = 'x'\n[[shape]]\nkind = 'mesh'\nfile = \"x.obj\\u0000.stl\"\n",
            "world.toml": f"name = 'x'\nsource = 'Mine'\n[sources]\nMine = 'x'\n[[hand]]\nname = 'h'\nfile = \"{outside[0]}\\u0000.urdf\"\n",
            "scene.gltf": json.dumps({"asset": {"version": "2.0"}, "buffers": [{"uri": n, "byteLength": 8} for n in outside]}),
            "scene.wrl": f"#VRML V2.0 utf8\nInline {{ url \"{outside[0]}\" }}\n",
            "scene.dae": f"<!DOCTYPE x [<!ENTITY y SYSTEM 'file://{home}/secret.obj'>]><COLLADA>&y;</COLLADA>",
        }
        with Server(THENAR, "serve", "--port", "0", folder=self.work) as server:
            client = Lines(server.port)
            for (name, text), kind in itertools.product(files.items(), ("hand", "object", "obstacle")):
                data = base64.b64encode(text.encode()).decode()
                reply = client.ask("world.import", files=[{"name": name, "data": data}], **{"as": kind})
                self.assertNotIn(reply.get("error", {}).get("code"), (-32603,), (name, reply))
                # Nothing is said of files that are elsewhere, not even that they are there.
                self.assertNotIn("did you mean 'secret.obj'", json.dumps(reply))
            # A hand from a drop goes beside the world, but not through a link there.
            urdf = ("<robot name='r'><link name='a'><collision><geometry><box size='.02 .02 .02'/></geometry></collision></link><link name='b'>"
                    "<collision><geometry><box size='.02 .02 .02'/></geometry></collision></link><joint name='j' type='prismatic'><parent link='a'/>"
                    "<child link='b'/><axis xyz='1 0 0'/><limit lower='0' upper='.03' effort='9' velocity='1'/></joint></robot>")
            client.ask("world.new")
            reply = client.ask("world.import", files=[{"name": "r.urdf", "data": base64.b64encode(urdf.encode()).decode()}], **{"as": "hand"})
            self.assertIn("result", reply, reply)
            self.assertIn("is a link", client.ask("world.save", file="saved.toml")["error"]["message"])
            self.assertIn("result", client.ask("world.save", file="other.toml"))
            self.assert_alive(server)
            self.assertEqual(server.stop()[0], 0)
        self.assertEqual(len(list(self.work.glob("other_files/*/r.urdf"))), 1)
        self.assert_untouched()
        # The same files on the command line, and as what opens a session.
        for name, text in files.items():
            (self.work / name).write_text(text)
            for words in (["validate", name], ["explain", name], ["import", name]):
                self.run_thenar(*words)
        for name in ("nul.toml", "world.toml", "scene.wrl"):
            self.assertEqual(self.run_thenar("serve", name, "--stdio")[0], 1)
        self.assert_untouched()


if __name__ == "__main__":
    unittest.main(verbosity=2, warnings="ignore")

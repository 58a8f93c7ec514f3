"""clients/matlab/ThenarRemote.m in GNU Octave, against a server that runs.

Usage: octave_test.py THENAR    Exit code 77: skipped, there is no Octave.
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile

from live_client import HANG, Server

CLIENT = pathlib.Path(__file__).resolve().parents[2] / "clients" / "matlab"
TOKEN = "0123456789abcdef"
SCRIPT = r"""
addpath('CLIENT');
delete(ThenarRemote('127.0.0.1', PORT, 'TOKEN'));
thenar = ThenarRemote('127.0.0.1', PORT);   % which finds the token by itself
assert(thenar.hello.protocol, 1);
assert(thenar.call('session.hello').program, 'thenar');
found = thenar.call('catalogue.list', struct('what', 'worlds'));
assert(any(strcmp({found.entries.name}, 'jaw_box')));
for wrong = {'session.mode', 'session.mod'}
  failed = '';
  try
    thenar.call(wrong{1}, struct('mode', 'no such mode'));
  catch told
    failed = [told.identifier, ' ', told.message];
  end
  assert(! isempty(strfind(failed, 'thenar:refused -3260')));
end
% Long replies come in pieces, short ones together.
methods_of_all = thenar.call('session.methods');
assert(numel(methods_of_all) > 8);
times = zeros(1, 200);
for i = 1:200
  begin = tic();
  thenar.call('session.hello');
  times(i) = toc(begin);
end
printf('round trip in Octave: median %.3f ms\n', 1e3 * median(times));
thenar.stop();
delete(thenar);
failed = false;
try
  ThenarRemote('127.0.0.1', PORT, 'another token of 16');
catch
  failed = true;
end
assert(failed);
printf('all holds\n');
"""

octave = shutil.which("octave-cli") or shutil.which("octave")
if octave is None:
    print("skipped: there is no octave; cmake/packages.txt names its package")
    sys.exit(77)
with Server(sys.argv[1], "serve", "--port", "0", "--token", TOKEN) as server, tempfile.TemporaryDirectory() as folder:
    script = pathlib.Path(folder) / "remote.m"
    script.write_text(SCRIPT.replace("CLIENT", str(CLIENT)).replace("PORT", str(server.port)).replace("TOKEN", TOKEN))
    done = subprocess.run([octave, "-q", str(script)], capture_output=True, text=True, timeout=HANG)
    print(done.stdout)
    if done.returncode != 0 or "all holds" not in done.stdout:
        sys.exit(done.stderr)
    assert server.stop()[0] == 0

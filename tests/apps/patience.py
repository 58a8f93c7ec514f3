"""How tests wait: never so long that a slow machine decides, and never for a number of seconds that a claim hangs on."""
import subprocess
import time

HANG = 240  # that anything is waited for [s]: guards against hangs alone, and decides nothing else


def stopped(command, number, has_begun=lambda *_: True, pause=0.5, **how):
    """Exit code, output and complaints of a command that is stopped by a signal once it has done something.

    Whether it had is seen afterwards, by has_begun(exit code, output): as long as it had not, it runs again for twice
    as long; the first time for `pause` [s]. A command that ends before it is stopped is a failure."""
    while True:
        with subprocess.Popen([*map(str, command)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                              **how) as work:
            time.sleep(pause)
            if work.poll() is not None:
                raise AssertionError(f"it ended before it was stopped: {work.communicate()}")
            work.send_signal(number)
            out, said = work.communicate(timeout=HANG)
        if has_begun(work.returncode, out) or pause > HANG:
            return work.returncode, out, said
        pause *= 2

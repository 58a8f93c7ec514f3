"""A controller in Python holds a pinched cube for ten seconds, in closed loop.

    thenar serve --port 8081 &
    python3 clients/python/examples/pd_pinch.py 8081

Two fingertips on slides press on a cube of 100 g that nothing else carries. Every 2 ms the controller reads where they
are, and answers with their forces: a squeeze of 3 N each way, and a spring and damper that keep their middle where it
was. While it runs, the motion can be watched: start `thenar view --remote 8081` instead of `thenar serve`. Prints how
many steps a second the loop made, and how far the cube slipped; exits with 1 if it slipped by more than 0.1 mm.
"""
import pathlib
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent))
from thenar_remote import Remote  # noqa: E402

STEP = 0.002        # [s]
SECONDS = 10.0      # [s]
SQUEEZE = 3.0       # of each finger [N]
STIFFNESS = 400.0   # that holds the middle of the fingers [N/m]
DAMPING = 8.0       # the same [N s/m]


def efforts(joints):
    """Forces of both fingers. joints: name -> [value in m, rate in m/s, effort in N]"""
    middle = 0.5 * (joints["left"][0] + joints["right"][0])
    rate = 0.5 * (joints["left"][1] + joints["right"][1])
    hold = -STIFFNESS * middle - DAMPING * rate
    return {"left": SQUEEZE + hold, "right": -SQUEEZE + hold}


def main(port, host="127.0.0.1"):
    with Remote(host, port) as thenar:
        thenar.motion.open(scene="pinch", step=STEP)
        start = thenar.motion.state(want=["joints", "bodies"])
        state, unsolved = start, 0
        steps = round(SECONDS / STEP)
        begin = time.perf_counter()
        for _ in range(steps):
            state = thenar.motion.step(efforts=efforts(state["joints"]), want=["joints"])
            unsolved += state["unsolved"]
        took = time.perf_counter() - begin
        end = thenar.motion.state(want=["bodies"])
    # Fingers move along x alone: what the cube moved along z, it slipped.
    slip = abs(end["bodies"]["cube"]["position"][2] - start["bodies"]["cube"]["position"][2])
    print(f"{steps} steps in {took:.2f} s: {steps / took:.0f} a second; {end['t']:.3f} s simulated, "
          f"{unsolved} contact problems unsolved")
    print(f"slip of the cube: {1e3 * slip:.6f} mm")
    return 0 if slip < 1e-4 and unsolved == 0 else 1


if __name__ == "__main__":
    sys.exit(main(int(sys.argv[1]), *sys.argv[2:]))

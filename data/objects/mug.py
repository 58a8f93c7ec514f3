"""Makes mug.obj [mm], a watertight mug with an open cavity and a handle: python3 mug.py > mug.obj

The wall is a profile turned about z. The handle is a tube of rings between two patches that are left
out of the outer wall; the sizes below are those of mug.toml.
"""
import math

RADIUS, INNER, HEIGHT, FLOOR = 41, 37, 95, 5  # of the wall, the cavity and its floor [mm]
TURNS, LEVELS, RINGS = 64, 24, 24             # steps about z, of the outer wall, along the handle
UPPER, LOWER, SIDE = 17, 4, 2                 # first levels of the patches; they span 3 x 2 SIDE
REACH, HALF_WIDTH, HALF_DEPTH = 34, 7, 5      # of the handle [mm]

rim = [((RADIUS + INNER) / 2 + (RADIUS - INNER) / 2 * math.cos(a),
        HEIGHT - 2 + (RADIUS - INNER) / 2 * math.sin(a)) for a in
       (k * math.pi / 4 for k in range(1, 4))]
wall = [(RADIUS, (HEIGHT - 2) * i / LEVELS) for i in range(LEVELS + 1)]
cavity = [(INNER, HEIGHT - 2 - (HEIGHT - 2 - FLOOR) * i / 12) for i in range(13)]
rings = [(RADIUS * i / 3, 0) for i in (1, 2)] + wall + rim + cavity
rings += [(INNER * i / 3, FLOOR) for i in (2, 1)]
vertices = [(r * math.cos(2 * math.pi * t / TURNS), r * math.sin(2 * math.pi * t / TURNS), z)
            for r, z in rings for t in range(TURNS)]
faces = []


def at(ring, turn):
    return ring * TURNS + turn % TURNS


def patch(first):
    """Corners around a patch, counterclockwise seen from outside, from its lower right."""
    low, high = first + 2, first + 5  # two rings of the bottom come first
    return ([at(low, t) for t in range(-SIDE, SIDE)] + [at(r, SIDE) for r in range(low, high)] +
            [at(high, -t) for t in range(-SIDE, SIDE)] + [at(r, -SIDE) for r in range(high, low, -1)])


def in_patch(ring, turn):
    inside = any(first + 2 <= ring < first + 5 for first in (UPPER, LOWER))
    return inside and (turn + SIDE) % TURNS < 2 * SIDE


def quad(a, b, c, d):
    faces.extend([(a, b, c), (a, c, d)])


for ring in range(len(rings) - 1):
    for turn in range(TURNS):
        if not in_patch(ring, turn):
            quad(at(ring, turn), at(ring, turn + 1), at(ring + 1, turn + 1), at(ring + 1, turn))
for ring, z in ((0, 0), (len(rings) - 1, FLOOR)):
    vertices.append((0, 0, z))
    for turn in range(TURNS):
        a, b = at(ring, turn), at(ring, turn + 1)
        faces.append((len(vertices) - 1, b, a) if ring == 0 else (len(vertices) - 1, a, b))

# The lower patch mirrored in z, so that corners of both follow each other along the handle.
start, end = patch(UPPER), patch(LOWER)
mirrored = {(round(vertices[i][1], 6), round(vertices[i][2], 6)): i for i in end}
z_up, z_low = ((HEIGHT - 2) * (first + 1.5) / LEVELS for first in (UPPER, LOWER))
end = [mirrored[round(vertices[i][1], 6), round(z_low - (vertices[i][2] - z_up), 6)] for i in start]
middle, half = (z_up + z_low) / 2, (z_up - z_low) / 2
loops = [start]
for k in range(1, RINGS):
    s = math.pi * k / RINGS
    loops.append([])
    for i in start:
        angle = math.atan2((vertices[i][2] - z_up) / HALF_DEPTH, vertices[i][1] / HALF_WIDTH)
        across, out = HALF_WIDTH * math.cos(angle), HALF_DEPTH * math.sin(angle)
        loops[-1].append(len(vertices))
        vertices.append((RADIUS + (REACH - HALF_DEPTH + out) * math.sin(s), across,
                         middle + (half + out) * math.cos(s)))
loops.append(end)
for a, b in zip(loops, loops[1:]):
    for i in range(len(a)):
        j = (i + 1) % len(a)
        quad(a[i], a[j], b[j], b[i])

print("# Made by mug.py [mm]")
for v in vertices:
    print("v {:.4f} {:.4f} {:.4f}".format(*v))
for f in faces:
    print("f {} {} {}".format(*(i + 1 for i in f)))

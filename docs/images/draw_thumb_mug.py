"""Draws the thumb on the mug: `bench/thumb_mug RESULT.json`, `python3 docs/images/draw_thumb_mug.py RESULT.json`, and of
RESULT.svg a screenshot of 980 x 660 pixels, docs/images/thumb_mug.png.

Looks along the distal phalanx from its tip, its pad down at the start. Nothing but the standard library is used.
"""
import json
import math
import pathlib
import sys

from draw_figures import Figure

MUG_RADIUS, MUG_HALF, SCALE = 0.04, 0.05, 2600  # [m], [m], pixels a metre
COLORS = {"DP1": (236, 188, 160), "PP1": (222, 168, 140), "MC1": (205, 150, 124), "mug": (120, 150, 190)}
SERIES = {"pins": "#333", "as assumed": "#b03030", "capsules 0.5 times as stiff": "#e08a3c", "2 times": "#1f5fa8",
          "4 times": "#4c9a6a", "10 times": "#8866aa"}
NAMES = {"pins": "pins", "as assumed": "joints that give", "capsules 0.5 times as stiff": "half as stiff",
         "2 times": "twice as stiff", "4 times": "4 times", "10 times": "10 times"}


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    size = math.sqrt(dot(a, a))
    return tuple(x / size for x in a)


def turned(pose, p):
    return tuple(dot(row, p) for row in pose["R"])


def moved(pose, p):
    return tuple(a + b for a, b in zip(turned(pose, p), pose["p"]))


def mug_mesh(sides=48, rings=10):
    """Corners and triangles of the mug's side and ends, axis z."""
    corners = [(MUG_RADIUS * math.cos(2 * math.pi * i / sides), MUG_RADIUS * math.sin(2 * math.pi * i / sides),
                MUG_HALF * (2 * k / rings - 1)) for k in range(rings + 1) for i in range(sides)]
    triangles = []
    for k in range(rings):
        for i in range(sides):
            a, b = k * sides + i, k * sides + (i + 1) % sides
            triangles += [(a, b, b + sides), (a, b + sides, a + sides)]
    corners += [(0, 0, -MUG_HALF), (0, 0, MUG_HALF)]
    last = rings * sides
    for i in range(sides):
        triangles += [((i + 1) % sides, i, len(corners) - 2), (last + i, last + (i + 1) % sides, len(corners) - 1)]
    return corners, triangles


class View:
    """What is seen along `ahead`, with `up` up, about a centre."""

    def __init__(self, ahead, up, centre, x, y):
        self.ahead, self.up = unit(ahead), unit(up)
        self.right = cross(self.ahead, self.up)
        self.centre, self.x, self.y = centre, x, y

    def __call__(self, p):
        arm = [a - b for a, b in zip(p, self.centre)]
        return self.x + SCALE * dot(arm, self.right), self.y - SCALE * dot(arm, self.up)

    def facets(self, corners, triangles, color, opacity=1):
        """Triangles that face the eye: (depth, outline, color, opacity)."""
        for triangle in triangles:
            a, b, c = (corners[i] for i in triangle)
            normal = unit(cross([q - p for p, q in zip(a, b)], [q - p for p, q in zip(a, c)]))
            facing = -dot(normal, self.ahead)
            if facing <= 0:
                continue
            light = 0.55 + 0.45 * max(0, dot(normal, unit([u - 0.8 * f for u, f in zip(self.up, self.ahead)])))
            shade = "#" + "".join(f"{min(255, int(light * part)):02x}" for part in color)
            depth = dot([sum(q) / 3 for q in zip(a, b, c)], self.ahead)
            yield depth, [self(p) for p in (a, b, c)], shade, opacity


def draw_state(figure, picture, at, x, y, words):
    """The thumb and the mug at one sample."""
    start = picture["bodies"][0]["poses"][0]
    bone, pad = turned(start, picture["bone"]), turned(start, picture["pad"])
    distal = picture["bodies"][0]["poses"][at]
    corners = picture["bodies"][0]["vertices"]
    middle = [sum(q) / len(corners) for q in zip(*corners)]
    view = View([-b for b in bone], [-p for p in pad], moved(start, middle), x, y)
    facets = []
    for body in picture["bodies"]:
        pose = body["poses"][at]
        facets += view.facets([moved(pose, p) for p in body["vertices"]], body["triangles"], COLORS[body["name"]])
    mug, triangles = mug_mesh()
    facets += view.facets([moved(picture["mug"][at], p) for p in mug], triangles, COLORS["mug"], 0.75)
    figure.parts.append(f'<svg x="{x-112}" y="{y-112}" width="224" height="224" viewBox="{x-112} {y-112} 224 224">')
    for _, outline, shade, opacity in sorted(facets, key=lambda facet: -facet[0]):
        points = " ".join(f"{px:.1f},{py:.1f}" for px, py in outline)
        seam = f'stroke="{shade}" stroke-width=".4"' if opacity == 1 else f'fill-opacity="{opacity}"'
        figure.parts.append(f'<polygon points="{points}" fill="{shade}" {seam}/>')
    # The pad's normal from the middle of the phalanx.
    a = moved(distal, middle)
    b = [p + 0.024 * q for p, q in zip(a, turned(distal, picture["pad"]))]
    figure.arrow(view(a), view(b), stroke="#b03030", width=3)
    figure.parts.append("</svg>")
    for k, line in enumerate(words):
        figure.text(x, y + 132 + 17 * k, line)


def draw_chart(figure, runs, x, y, width, height):
    """Pad angle over force."""
    def place(force, angle):
        return x + width * force / 30, y + height * (75 - angle) / 30

    for angle in range(45, 76, 5):
        figure.line([place(0, angle), place(30, angle)], stroke="#ddd", width=1)
        figure.text(x - 8, place(0, angle)[1] + 4, str(angle), anchor="end", size=12)
    for force in range(0, 31, 5):
        figure.text(place(force, 45)[0], y + height + 18, str(force), size=12)
    figure.text(x + width / 2, y + height + 38, "force of the mug on the thumb [N]")
    figure.text(x - 30, y - 14, "pad's normal from the direction to the mug [deg]", anchor="start")
    ends = []
    for name, color in SERIES.items():
        states = [s for s in runs[name]["states"] if s["force_N"] > 0.5 and s["pad_angle_deg"] is not None]
        figure.line([place(s["force_N"], s["pad_angle_deg"]) for s in states], stroke=color, width=2.2)
        ends.append((place(30, states[-1]["pad_angle_deg"])[1], NAMES[name], color))
    low = -100
    for height_at, words, color in sorted(ends):
        low = max(height_at, low + 15)
        figure.text(x + width + 10, low + 4, words, anchor="start", fill=color)


def main():
    runs = {run["name"]: run for run in json.loads(pathlib.Path(sys.argv[1]).read_text())["runs"]}
    figure = Figure(pathlib.Path(sys.argv[1]).resolve().with_suffix(""), "A thumb on a mug: on pins it stays on its side, where joints give it rolls to its pad", 980, 660)
    for column, (name, force) in enumerate([("pins", 30), ("as assumed", 1.5), ("as assumed", 10.5), ("as assumed", 30)]):
        states = runs[name]["states"]
        at = min(range(len(states)), key=lambda i: abs(states[i]["force_N"] - force))
        state = states[at]
        words = [f"{NAMES[name]}, {state['force_N']:.1f} N", f"{state['pad_angle_deg']:.0f} deg to the pad"]
        draw_state(figure, runs[name]["picture"], at, 130 + 240 * column, 130, words)
    draw_chart(figure, runs, 90, 350, 700, 240)
    figure.save()


main()

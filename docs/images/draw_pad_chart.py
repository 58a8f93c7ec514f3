"""draw_pad_chart.py PRINTED PICTURE.svg: what bench/pad_chart printed for one Poisson's ratio, as a picture."""

import math
import re
import sys

WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 860, 470, 70, 630, 20, 415
X_RANGE, Y_RANGE = (0.005, 100), (0.02, 100)  # [s], [%]
COLOURS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#000000", "#56b4e9"]


def share(value, limits):
    """Where a value lies on a logarithmic axis."""
    low, high = limits
    return math.log(min(max(value, low), high) / low) / math.log(high / low)


def place(seconds, percent):
    return (LEFT + share(seconds, X_RANGE) * (RIGHT - LEFT),
            BOTTOM - share(percent, Y_RANGE) * (BOTTOM - TOP))


def read(file):
    """Curves as {name: [(seconds, percent), ...]} and how well the force is known [%]."""
    curves, known = {}, 0.0
    for line in open(file):
        if head := re.match(r"nu = .*known to ([\d.]+) %", line):
            known = float(head[1])
        row = re.match(r"(.{26}).{14} *\d+ +\d+ +[\d.]+ +([\d.]+) +([\d.e+-]+)$", line.rstrip())
        if row:
            curves.setdefault(row[1].strip(), []).append((float(row[3]), float(row[2])))
    return curves, known


def draw(curves, known):
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}" '
           'font-family="sans-serif" font-size="13">', "<title>Error of a pad's force over processor time</title>",
           f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#fff"/>']
    # Axes, and the band in which errors mean nothing.
    x0, y_known = place(X_RANGE[0], known)
    out.append(f'<rect x="{x0}" y="{y_known:.0f}" width="{RIGHT - LEFT}" height="{BOTTOM - y_known:.0f}" fill="#f2f2f2"/>')
    for seconds in (0.01, 0.1, 1, 10, 100):
        x, _ = place(seconds, 1)
        out.append(f'<path d="M{x:.0f} {TOP}V{BOTTOM}" stroke="#ddd"/><text x="{x:.0f}" y="{BOTTOM + 18}" '
                   f'text-anchor="middle" fill="#444">{seconds:g} s</text>')
    for percent in (0.1, 1, 2, 10, 100):
        _, y = place(1, percent)
        out.append(f'<path d="M{LEFT} {y:.0f}H{RIGHT}" stroke="{"#888" if percent == 2 else "#ddd"}"/>'
                   f'<text x="{LEFT - 8}" y="{y + 4:.0f}" text-anchor="end" fill="#444">{percent:g} %</text>')
    out.append(f'<text x="{(LEFT + RIGHT) / 2}" y="{BOTTOM + 42}" text-anchor="middle">processor time</text>')
    # Curves, and their names beside them.
    for k, (name, points) in enumerate(curves.items()):
        colour, at = COLOURS[k % len(COLOURS)], [place(*point) for point in points]
        out.append(f'<path d="M{"L".join(f"{x:.1f} {y:.1f}" for x, y in at)}" fill="none" stroke="{colour}" '
                   f'stroke-width="{3 if k == 0 else 1.5}"/>')
        out += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3.5" fill="{colour}"/>' for x, y in at]
        y = TOP + 20 + 24 * k
        out.append(f'<path d="M{RIGHT + 14} {y}h22" stroke="{colour}" stroke-width="3"/>'
                   f'<text x="{RIGHT + 42}" y="{y + 4}">{name}</text>')
    return "\n".join(out + ["</svg>", ""])


if __name__ == "__main__":
    with open(sys.argv[2], "w") as picture:
        picture.write(draw(*read(sys.argv[1])))

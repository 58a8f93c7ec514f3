"""Draws the figures of the glossary and of the theory pages as SVG: `python3 docs/images/draw_figures.py`.

Coordinates are those of the picture, in pixels, y downwards. Nothing but the standard library is used.
"""
import math
import pathlib

FOLDER = pathlib.Path(__file__).parent
BONE, TENDON, FORCE, LINE, SOFT = "#e8e0d0", "#b03030", "#1f5fa8", "#333", "#9ec3a0"


class Figure:
    """An SVG that grows by one call a shape."""

    def __init__(self, name, title, width, height):
        self.name, self.size = name, (width, height)
        self.parts = [f"<title>{title}</title>", f'<rect width="{width}" height="{height}" fill="#fff"/>',
                      '<defs><marker id="a" viewBox="0 0 10 10" refX="9" refY="5" markerWidth="7" markerHeight="7" '
                      'orient="auto-start-reverse"><path d="M0 0L10 5L0 10z" fill="context-stroke"/></marker></defs>']

    def path(self, d, stroke=LINE, fill="none", width=1.5, extra=""):
        self.parts.append(f'<path d="{d}" stroke="{stroke}" fill="{fill}" stroke-width="{width}" '
                          f'stroke-linejoin="round" stroke-linecap="round" {extra}/>')

    def line(self, points, **how):
        self.path("M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in points), **how)

    def arrow(self, a, b, stroke=FORCE, width=2, both=False):
        start = 'marker-start="url(#a)" ' if both else ""
        self.line([a, b], stroke=stroke, width=width, extra=start + 'marker-end="url(#a)"')

    def dot(self, x, y, r=3.5, fill=LINE, stroke="none"):
        self.parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{r}" fill="{fill}" stroke="{stroke}" stroke-width="1.5"/>')

    def ellipse(self, x, y, rx, ry, fill="none", stroke=LINE, extra=""):
        self.parts.append(f'<ellipse cx="{x}" cy="{y}" rx="{rx}" ry="{ry}" fill="{fill}" stroke="{stroke}" stroke-width="1.5" {extra}/>')

    def text(self, x, y, words, anchor="middle", fill="#222", size=13):
        self.parts.append(f'<text x="{x}" y="{y}" text-anchor="{anchor}" fill="{fill}" font-size="{size}">{words}</text>')

    def bone(self, a, b, half=11):
        """A phalanx from joint a to joint b."""
        angle = math.atan2(b[1] - a[1], b[0] - a[0])
        n = (-math.sin(angle) * half, math.cos(angle) * half)
        m = (n[0] * 0.6, n[1] * 0.6)
        mid = ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2)
        self.path(f"M{a[0]+n[0]:.1f} {a[1]+n[1]:.1f}Q{mid[0]+m[0]:.1f} {mid[1]+m[1]:.1f} {b[0]+n[0]:.1f} {b[1]+n[1]:.1f}"
                  f"L{b[0]-n[0]:.1f} {b[1]-n[1]:.1f}Q{mid[0]-m[0]:.1f} {mid[1]-m[1]:.1f} {a[0]-n[0]:.1f} {a[1]-n[1]:.1f}Z",
                  fill=BONE, stroke="#998")

    def save(self):
        width, height = self.size
        head = (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" '
                f'height="{height}" font-family="sans-serif" font-size="13">')
        (FOLDER / f"{self.name}.svg").write_text("\n".join([head, *self.parts, "</svg>"]) + "\n")


def chain(start, lengths, turns):
    """Joints of a planar finger; turns from the horizontal, clockwise in the picture [deg]."""
    points, angle = [start], 0
    for length, turn in zip(lengths, turns):
        angle += math.radians(turn)
        x, y = points[-1]
        points.append((x + length * math.cos(angle), y + length * math.sin(angle)))
    return points


def tip_axes():
    f = Figure("tip_axes", "A flexed finger: joints, tip axes, tip force", 520, 330)
    joints = chain((130, 60), [140, 95, 66], [20, 45, 35])
    f.bone((40, 60), (130, 60), 13)
    for a, b in zip(joints, joints[1:]):
        f.bone(a, b)
    for (x, y), name, dx, dy in zip(joints, ["MCP", "PIP", "DIP"], [0, 16, 34], [-20, -16, -8]):
        f.dot(x, y, 5, "#fff", LINE)
        f.text(x + dx, y + dy, name)
    (ax, ay), (x, y) = joints[-2:]
    length = math.hypot(x - ax, y - ay)
    p = ((ax - x) / length, (ay - y) / length)
    d = (-p[1], p[0])
    f.dot(x, y, 4, TENDON)
    f.arrow((x, y), (x + 66 * p[0], y + 66 * p[1]), TENDON)
    f.arrow((x, y), (x + 66 * d[0], y + 66 * d[1]), TENDON)
    f.text(x + 66 * p[0] - 42, y + 66 * p[1] + 20, "proximal")
    f.text(x + 66 * d[0] + 30, y + 66 * d[1] + 4, "dorsal")
    f.ellipse(x, y, 9, 9, stroke=TENDON)
    f.text(x + 14, y + 44, "radial: out of the picture", "start", "#666", 12)
    f.arrow((x - 2, y + 2), (x - 66 * d[0] + 10 * p[0], y - 66 * d[1] + 10 * p[1]), FORCE, 3)
    f.text(x - 66 * d[0] - 6, y - 66 * d[1] + 26, "tip force on the world", fill=FORCE)
    f.path("M215 60A85 85 0 0 1 210 89", stroke="#666", extra='marker-end="url(#a)"')
    f.line([(150, 60), (225, 60)], stroke="#bbb", width=1, extra='stroke-dasharray="3 3"')
    f.text(232, 56, "q &gt; 0: flexion", "start", "#666")
    f.save()


def moment_arm():
    f = Figure("moment_arm", "Moment arm of a tendon about a joint", 460, 250)
    f.bone((20, 110), (220, 110), 16)
    end = (220 + 190 * math.cos(0.45), 110 + 190 * math.sin(0.45))
    f.bone((220, 110), end, 15)
    f.dot(220, 110, 6, "#fff", LINE)
    f.text(220, 86, "joint axis")
    a, b = (40, 160), (300, 188)
    f.arrow(b, a, TENDON, 2.5)
    f.dot(*b, 4, TENDON)
    f.text(330, 222, "insertion")
    f.text(66, 182, "t [N]", fill=TENDON)
    ux, uy = (b[0] - a[0], b[1] - a[1])
    s = ((220 - a[0]) * ux + (110 - a[1]) * uy) / (ux * ux + uy * uy)
    foot = (a[0] + s * ux, a[1] + s * uy)
    f.arrow((220, 110), foot, FORCE, 2, both=True)
    f.text(210, 148, "R [m]", "end", FORCE)
    f.text(230, 242, "torque = R t,   R = - d(length) / dq", size=14)
    f.save()


def friction_cone():
    f = Figure("friction_cone", "Friction cone of a contact, and its torsion", 570, 290)
    f.path("M20 235Q140 190 260 235V280H20Z", fill=SOFT, stroke="#7a9")
    f.text(140, 268, "object")
    x, y, h, r = 140, 212, 150, 75
    f.path(f"M{x} {y}L{x-r} {y-h}M{x} {y}L{x+r} {y-h}", stroke=FORCE)
    f.ellipse(x, y - h, r, 18, fill="#dce8f5", stroke=FORCE, extra='fill-opacity="0.7"')
    f.arrow((x, y - h), (x, y), LINE, 2)
    f.text(x - 12, y - 96, "n", size=15)
    f.arrow((x, y - h), (x + r, y - h), FORCE, 1.5)
    f.text(x + r + 6, y - h + 5, "mu f_n", "start", FORCE)
    f.dot(x, y, 4)
    f.text(x, 24, "hard point: |f_t| &lt;= mu f_n")
    x = 420
    f.path("M300 235Q420 190 540 235V280H300Z", fill=SOFT, stroke="#7a9")
    f.path(f"M{x-r} {y-h}L{x-24} {y}M{x+r} {y-h}L{x+24} {y}", stroke=FORCE)
    f.ellipse(x, y - h, r, 18, fill="#dce8f5", stroke=FORCE, extra='fill-opacity="0.7"')
    f.ellipse(x, y, 24, 8, fill="#f2d9b0", stroke="#a70")
    f.text(x + 30, y + 30, "patch of semi-axes a, b", "middle", "#740", 12)
    f.arrow((x, y - h), (x, y), LINE, 2)
    f.path(f"M{x-30} {y-62}A30 10 0 1 0 {x+30} {y-62}", stroke=TENDON, width=2, extra='marker-end="url(#a)"')
    f.text(x + 82, y - 44, "torsion m_n", fill=TENDON)
    f.text(x, 24, "soft finger: a moment about n as well")
    f.save()


def wrench_set():
    f = Figure("wrench_set", "Wrench set and the ball of radius epsilon", 560, 300)
    ox, oy, s = 160, 150, 95
    corners = [(1.2, -0.25), (0.75, 0.85), (-0.7, 0.95), (-1.15, 0.1), (-0.5, -0.9), (0.55, -0.95)]
    best = None
    for (ax, ay), (bx, by) in zip(corners, corners[1:] + corners[:1]):
        length = math.hypot(bx - ax, by - ay)
        distance = abs(ax * by - ay * bx) / length
        if best is None or distance < best[0]:
            t = -(ax * (bx - ax) + ay * (by - ay)) / length**2
            best = (distance, (ax + t * (bx - ax), ay + t * (by - ay)))
    f.line([(ox + s * x, oy - s * y) for x, y in corners + corners[:1]], fill="#dce8f5", stroke=FORCE, width=2)
    f.ellipse(ox, oy, s * best[0], s * best[0], fill="#f2d9b0", stroke="#a70", extra='fill-opacity="0.8"')
    foot = (ox + s * best[1][0], oy - s * best[1][1])
    f.arrow((ox, oy), foot, TENDON, 2)
    f.dot(ox, oy)
    f.text(ox - 14, oy - 6, "0")
    f.text((ox + foot[0]) / 2 + 4, (oy + foot[1]) / 2 - 8, "epsilon", fill=TENDON)
    f.text(160, 22, "force closure: 0 inside W, epsilon &gt; 0")
    f.text(250, 70, "W", fill=FORCE, size=16)
    ox = 400
    tri = [(ox + 20, 190), (ox + 120, 95), (ox + 110, 235), (ox + 20, 190)]
    f.line(tri, fill="#dce8f5", stroke=FORCE, width=2)
    f.dot(ox - 10, 120)
    f.text(ox - 24, 116, "0")
    ax, ay, bx, by = ox + 20, 190, ox + 120, 95
    t = ((ox - 10 - ax) * (bx - ax) + (120 - ay) * (by - ay)) / ((bx - ax) ** 2 + (by - ay) ** 2)
    foot = (ax + t * (bx - ax), ay + t * (by - ay))
    f.arrow((ox - 10, 120), foot, TENDON, 2)
    f.text(ox + 6, 168, "- epsilon", "end", TENDON)
    f.text(430, 22, "no closure: minus the distance")
    f.text(280, 288, "axes: force / N and torque / (N s); six dimensions, two drawn", fill="#666", size=12)
    f.save()


def extensor_hood():
    f = Figure("extensor_hood", "Extensor hood seen from the back of a finger", 640, 300)
    y = 150
    for a, b, half, name in [(20, 180, 26, "MC"), (190, 350, 24, "proximal phalanx"), (360, 470, 20, "middle phalanx"), (480, 560, 16, "distal")]:
        f.bone((a, y), (b, y), half)
        f.text((a + b) / 2, y + 56, name, fill="#777", size=12)

    def band(points, width=3):
        f.line(points, stroke=TENDON, width=width)

    extensor, centre, junction = (225, y), (300, y), (455, y)
    for side in (-1, 1):
        wing, lateral = (235, y + side * 40), (345, y + side * 34)
        beyond = (410, y + side * 20)
        band([extensor, lateral])
        band([wing, lateral])
        band([wing, centre], 2)
        band([extensor, wing], 2)
        band([lateral, beyond])
        band([beyond, junction])
        band([(90, y + side * 78), wing], 4)
        for p in (wing, lateral, beyond):
            f.dot(*p, 4.5, "#fff", TENDON)
    f.line([(410, y - 20), (410, y + 20)], stroke=TENDON, width=1.5, extra='stroke-dasharray="3 3"')
    band([(20, y), extensor], 4)
    band([extensor, centre])
    band([centre, (368, y)], 4)
    band([junction, (500, y)], 4)
    for p in (extensor, centre, junction):
        f.dot(*p, 4.5, "#fff", TENDON)
    f.dot(368, y, 4.5, LINE)
    f.dot(500, y, 4.5, LINE)
    for x, yy, words, tx, ty in [(40, y, "EDC", 40, 138), (90, 72, "radial interosseous, lumbrical", 110, 62),
                                 (90, 228, "ulnar interosseous", 80, 250)]:
        f.text(tx, ty, words, fill=TENDON)
    for (x, yy), (tx, ty), words in [((335, y), (318, 22), "central slip"), ((390, y - 24), (430, 60), "radial slip (lateral band)"),
                                     ((390, y + 24), (430, 262), "ulnar slip"), ((478, y), (560, 100), "terminal slip"),
                                     ((410, y + 8), (540, 240), "triangular ligament"), ((235, y + 40), (230, 282), "node: a knot that floats"),
                                     ((368, y), (345, 262), "insertion")]:
        f.line([(x, yy), (tx, ty + (6 if ty < y else -14))], stroke="#aaa", width=1)
        f.text(tx, ty, words, size=12)
    f.save()


def pregrasp():
    f = Figure("pregrasp", "Pregrasp, approach, closing, contacts", 640, 230)
    for k, (title, gap, bend) in enumerate([("1 pregrasp: pose, preshape", 70, 12), ("2 approach along the palm", 14, 12),
                                            ("3 close until contacts stop", 14, 58)]):
        x = 30 + 210 * k
        f.path(f"M{x} 75h26v80h-26z", fill=BONE, stroke="#998")
        f.ellipse(x + 26 + gap + 34, 115, 34, 34, fill=SOFT, stroke="#7a9")
        for side in (-1, 1):
            points = chain((x + 26, 115 + side * 36), [46, 34], [side * 14 * (bend < 20) , -side * bend])
            f.line(points, stroke="#998", width=9)
            f.line(points, stroke=BONE, width=6)
        if k == 0:
            f.arrow((x + 30, 115), (x + 30 + gap - 10, 115), FORCE)
            f.text(x + 62, 106, "d", fill=FORCE, size=14)
        if k == 2:
            f.dot(x + 40, 115, 4, TENDON)
            for side in (-1, 1):
                f.dot(x + 88, 115 + side * 30, 4, TENDON)
        f.text(x + 80, 205, title)
    f.text(320, 28, "d: direction of the palm's approach; red: contacts; fingers stop where they touch", fill="#666", size=12)
    f.save()


def wrapped_string():
    f = Figure("wrapped_string", "A string over a cylinder", 480, 250)
    cx, cy, r = 240, 160, 80
    f.ellipse(cx, cy, r, r, fill=BONE, stroke="#998")
    points = []
    for x, y, side in [(50, 190, -1), (430, 180, 1)]:
        rho = math.hypot(x - cx, y - cy)
        angle = math.atan2(y - cy, x - cx)
        turn = math.acos(r / rho)
        angle += turn if side < 0 else -turn
        points.append(((x, y), (cx + r * math.cos(angle), cy + r * math.sin(angle))))
    (a, ta), (b, tb) = points
    f.path(f"M{a[0]} {a[1]}L{ta[0]:.1f} {ta[1]:.1f}A{r} {r} 0 0 1 {tb[0]:.1f} {tb[1]:.1f}L{b[0]} {b[1]}", stroke=TENDON, width=3)
    for p in (a, b, ta, tb):
        f.dot(*p, 4, TENDON)
    f.line([(cx, cy), ta], stroke="#888", width=1)
    f.line([(cx, cy), tb], stroke="#888", width=1)
    f.line([(cx, cy), a], stroke="#888", width=1, extra='stroke-dasharray="4 3"')
    f.text(208, 132, "r", fill="#555")
    f.text(140, 196, "rho_a", fill="#555")
    f.text(92, 118, "f_a: free run", fill=TENDON)
    f.text(388, 118, "f_b", fill=TENDON)
    f.text(cx, 66, "arc on the surface: r (theta - alpha_a - alpha_b)", fill=TENDON)
    f.text(60, 212, "end a")
    f.text(430, 202, "end b")
    f.dot(cx, cy, 3)
    f.save()


def capstan():
    f = Figure("net_friction", "A node that rubs on bone", 480, 220)
    f.path("M20 200Q240 40 460 200Z", fill=BONE, stroke="#998")
    x, y = 240, 118
    f.line([(70, 150), (x, y), (420, 152)], stroke=TENDON, width=3)
    f.arrow((x, y), (120, 141), TENDON, 2.5)
    f.arrow((x, y), (385, 146), TENDON, 2.5)
    f.arrow((x, y), (x, 50), FORCE, 2.5)
    f.arrow((x, y), (172, 112), LINE, 2.5)
    f.dot(x, y, 5, "#fff", TENDON)
    f.text(112, 128, "T1", fill=TENDON)
    f.text(398, 132, "T2 &gt; T1", fill=TENDON)
    f.text(x + 12, 56, "N, of the bone", "start", FORCE)
    f.text(178, 98, "friction &lt;= mu N")
    f.text(x, 190, "the node slips to the right if T2 - T1 exceeds what friction can make", fill="#555", size=12)
    f.save()


def muscle_unit():
    f = Figure("muscle_unit", "Muscle and tendon in line", 560, 200)
    f.line([(30, 60), (210, 60)], stroke="#888", width=3)
    f.path("M210 60L330 120M60 60L180 120", stroke=TENDON, width=0)
    for k in range(6):
        f.line([(40 + 30 * k, 60), (150 + 30 * k, 120)], stroke=TENDON, width=3)
    f.line([(150, 120), (310, 120)], stroke="#888", width=3)
    f.line([(310, 120), (520, 120)], stroke="#c9a227", width=5)
    f.line([(40, 60), (40, 150)], stroke="#aaa", width=1)
    f.line([(150, 120), (150, 150)], stroke="#aaa", width=1)
    f.arrow((40, 145), (150, 145), FORCE, 1.5, both=True)
    f.text(95, 164, "projected fibre x", fill=FORCE)
    f.arrow((310, 145), (520, 145), FORCE, 1.5, both=True)
    f.text(415, 164, "tendon: slack length and stretch", fill=FORCE)
    f.arrow((284, 61), (284, 118), FORCE, 1.5, both=True)
    f.line([(210, 60), (290, 60)], stroke="#aaa", width=1)
    f.text(294, 84, "h: height, kept", "start", FORCE)
    f.arrow((520, 120), (552, 120), TENDON, 2.5)
    f.text(540, 106, "t", fill=TENDON)
    f.text(110, 44, "fibres at the pennation angle", fill=TENDON)
    f.text(290, 190, "musculotendon length = x + tendon length", size=13)
    f.save()


def feasible_set():
    f = Figure("feasible_set", "Feasible tip forces and the largest force in a cone", 540, 320)
    ox, oy = 170, 120
    generators = [(70, 18), (24, 60), (-48, 52), (-36, -20)]
    corners = [(0.0, 0.0)]
    steps = sorted([g if g[1] > 0 or (g[1] == 0 and g[0] > 0) else (-g[0], -g[1]) for g in generators], key=lambda g: math.atan2(g[1], g[0]))
    start = (sum(min(g[0], 0) if g[1] > 0 else g[0] for g in generators if g[1] <= 0), sum(min(g[1], 0) for g in generators))
    corners = [start]
    for g in steps + [(-a, -b) for a, b in steps]:
        corners.append((corners[-1][0] + g[0], corners[-1][1] + g[1]))
    f.line([(ox + x, oy + y) for x, y in corners], fill="#dce8f5", stroke=FORCE, width=2)
    for g in generators:
        f.arrow((ox, oy), (ox + g[0], oy + g[1]), TENDON, 1.5)
    f.dot(ox, oy, 4)
    f.text(ox + 2, oy - 10, "0")
    f.path(f"M{ox} {oy}L{ox+98} {oy+190}M{ox} {oy}L{ox-4} {oy+190}", stroke="#a70", extra='stroke-dasharray="5 4"')
    f.arrow((ox, oy), (ox + 27, oy + 110), LINE, 3)
    f.text(ox + 88, oy + 150, "cone about d", "start", "#a70")
    f.text(300, 90, "all tensions between 0 and F0", "start", FORCE)
    f.text(300, 110, "that balance at every joint", "start", FORCE)
    f.text(300, 40, "red: force of one muscle at F0", "start", TENDON)
    f.save()


def evidence():
    f = Figure("band_evidence", "Evidence for a band and the three verdicts", 520, 190)
    y = 100
    f.arrow((30, y), (500, y), LINE, 1.5)
    for a, b, fill, words in [(30, 170, "#f4d4d4", "the band is absent"), (170, 360, "#eee", "undecided"), (360, 490, "#d4ecd6", "the band exists")]:
        f.path(f"M{a} {y-26}H{b}V{y}H{a}Z", fill=fill, stroke="none")
        f.text((a + b) / 2, y - 9, words)
    for x, words in [(170, "-6"), (265, "0"), (360, "6")]:
        f.line([(x, y - 28), (x, y + 5)], width=1)
        f.text(x, y + 22, words)
    f.text(265, 152, "evidence = (least chi^2 without the band - least chi^2 with it) / inflation^2")
    f.text(265, 40, "beyond 6 in size a verdict is wrong with a chance of at most Phi(-sqrt 6) = 0.7 %", fill="#555", size=12)
    f.save()


def fit_flow():
    f = Figure("fit_flow", "What a fit compares", 640, 210)
    for x, y, w, words, fill in [(10, 60, 120, ["parameters", "value = mean + u"], "#f2d9b0"), (170, 60, 120, ["digit at posture", "L, R"], BONE),
                                 (330, 60, 130, ["predicted force", "L c = R' t"], "#dce8f5"), (500, 60, 130, ["residual", "(f - measured) / sd"], "#f4d4d4"),
                                 (330, 140, 130, ["measured force", "load cell"], "#d4ecd6"), (10, 140, 120, ["prior", "z ~ N(0, 1)"], "#eee")]:
        f.path(f"M{x} {y}h{w}v46h-{w}z", fill=fill, stroke="#888")
        for k, line in enumerate(words):
            f.text(x + w / 2, y + 19 + 17 * k, line, size=12.5)
    for a, b in [((130, 83), (168, 83)), ((290, 83), (328, 83)), ((460, 83), (498, 83)), ((70, 140), (70, 108)), ((460, 163), (555, 108))]:
        f.arrow(a, b, LINE, 1.5)
    f.path("M565 60C540 12 120 12 75 58", stroke=TENDON, width=2, extra='marker-end="url(#a)"')
    f.text(320, 18, "the solver moves z until residuals and prior balance", fill=TENDON)
    f.save()


def tempering():
    f = Figure("tempering", "Tempered densities and swaps of neighbours", 520, 260)
    for k, beta in enumerate([1.0, 0.4, 0.1]):
        base = 90 + 75 * k
        points = []
        for x in range(40, 401, 4):
            u = (x - 220) / 60
            value = (math.exp(-(u - 1.5) ** 2 * 4) + 0.6 * math.exp(-(u + 1.5) ** 2 * 4) + 1e-4) ** beta
            points.append((x, base - 52 * value))
        f.line([(40, base), *points, (400, base)], fill="#dce8f5", stroke=FORCE)
        f.text(412, base - 10, f"beta = {beta:g}", "start")
        if k:
            f.arrow((440, base - 28), (440, base - 58), TENDON, 2, both=True)
    f.text(452, 124, "swap", "start", TENDON)
    f.text(260, 22, "likelihood^beta: hot chains cross between modes, the chain at beta = 1 is kept", fill="#555", size=11.5)
    f.save()


for draw in (tip_axes, moment_arm, friction_cone, wrench_set, extensor_hood, pregrasp, wrapped_string, capstan,
             muscle_unit, feasible_set, evidence, fit_flow, tempering):
    draw()

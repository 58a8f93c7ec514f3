"""Robots whose links are meshes of thousands of triangles, for tests of time: each link a bumpy rounded bar."""
import math
import pathlib
import struct


def bar(radius, length, rings, sides, phase=0.0):
    """Triangles of a closed surface of revolution about z from 0 to `length`, with bumps. [m]"""
    def corner(i, j):
        s = (i + 0.5) / rings
        rho = radius * (4 * s * (1 - s)) ** 0.3 * (1 + 0.05 * math.sin(7 * s + phase))
        u = 2 * math.pi * (j % sides) / sides
        return (rho * math.cos(u), rho * math.sin(u), length * s)
    bottom, top = (0.0, 0.0, 0.0), (0.0, 0.0, length)
    triangles = []
    for j in range(sides):
        triangles.append((bottom, corner(0, j + 1), corner(0, j)))
        triangles.append((top, corner(rings - 1, j), corner(rings - 1, j + 1)))
        for i in range(rings - 1):
            a, b, c, d = corner(i, j), corner(i, j + 1), corner(i + 1, j + 1), corner(i + 1, j)
            triangles += [(a, b, c), (a, c, d)]
    return triangles


def write_stl(path, triangles):
    data = bytearray(80) + struct.pack("<I", len(triangles))
    for a, b, c in triangles:
        data += struct.pack("<12fH", 0, 0, 0, *a, *b, *c, 0)
    pathlib.Path(path).write_bytes(data)


def link(name, mesh):
    return (f'<link name="{name}"><inertial><mass value="0.05"/><inertia ixx="1e-5" iyy="1e-5" izz="1e-5" '
            f'ixy="0" ixz="0" iyz="0"/></inertial><collision><geometry><mesh filename="{mesh}"/></geometry>'
            "</collision></link>\n")


def joint(name, parent, child, xyz, axis, rpy="0 0 0", lower=0, upper=1.6, kind="revolute"):
    return (f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>'
            f'<origin xyz="{xyz}" rpy="{rpy}"/><axis xyz="{axis}"/>'
            f'<limit lower="{lower}" upper="{upper}" effort="1" velocity="1"/></joint>\n')


def hand(folder, rings=63, sides=63):
    """A palm and four digits of four links: 17 meshes of 2 rings sides triangles. Returns the URDF's path."""
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    text = '<robot name="mesh_hand">\n' + link("palm", "palm.stl")
    write_stl(folder / "palm.stl", bar(0.04, 0.09, rings, sides))
    for d, (name, x) in enumerate([("index", 0.03), ("middle", 0.0), ("ring", -0.03), ("thumb", 0.045)]):
        parent, place = "palm", f"{x} 0 0.09"
        rpy = "0 0 0"
        if name == "thumb":
            place, rpy = "0.045 0.02 0.02", "-1.2 0 0"
        for k in range(4):
            here = f"{name}_{k}"
            write_stl(folder / f"{here}.stl", bar(0.011 - 0.001 * k, 0.035, rings, sides, d + 0.3 * k))
            text += link(here, f"{here}.stl")
            text += joint(f"{here}_joint", parent, here, place, "1 0 0" if name != "thumb" else "-1 0 0", rpy)
            parent, place, rpy = here, "0 0 0.034", "0 0 0"
    path = folder / "mesh_hand.urdf"
    path.write_text(text + "</robot>\n")
    return str(path)


def gripper(folder, rings=50, sides=50):
    """Two fingers of nine links each on a base and a palm plate: 20 meshes, two of the joints move."""
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    text = '<robot name="mesh_gripper">\n' + link("base", "base.stl") + link("plate", "plate.stl")
    write_stl(folder / "base.stl", bar(0.04, 0.06, rings, sides))
    write_stl(folder / "plate.stl", bar(0.045, 0.02, rings, sides, 1))
    text += joint("plate_joint", "base", "plate", "0 0 0.05", "0 0 1", kind="fixed")
    for f, side in enumerate([1, -1]):
        parent = "plate"
        for k in range(9):
            here = f"finger{f}_{k}"
            write_stl(folder / f"{here}.stl", bar(0.009, 0.014, rings, sides, f + 0.2 * k))
            text += link(here, f"{here}.stl")
            if k == 0:
                text += joint(f"{here}_joint", parent, here, f"{0.07 * side} 0 0.02", f"{-side} 0 0", upper=0.06,
                              kind="prismatic")
            else:
                text += joint(f"{here}_joint", parent, here, "0 0 0.012", "0 0 1", kind="fixed")
            parent = here
    path = folder / "mesh_gripper.urdf"
    path.write_text(text + "</robot>\n")
    return str(path)


def object_of(folder, triangles=100000):
    """A vase of about so many triangles, 60 mm across."""
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    n = round(math.sqrt(triangles / 2))
    write_stl(folder / "vase.stl", bar(0.03, 0.1, n, n))
    return str(folder / "vase.stl")

"""
A body from an STL file
=======================
Any closed surface can be the outside of an object: here a pebble, made of a few lines of NumPy.
"""

import os
import tempfile
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import instobj

QUICK = os.environ.get("INSTOBJ_GALLERY") == "quick"
COUNT = 32  # triangles along the equator
FOLDER = Path(tempfile.mkdtemp())

# %%
# The surface
# -----------
# A sphere that is stretched and dented a little. An STL file lists triangles, in mm; a vertex per
# corner, counter-clockwise seen from outside.


def pebble(count):
    """Corners of triangles (triangle, corner, xyz) of a closed, smooth body."""
    around, up = np.meshgrid(np.arange(count + 1), np.arange(count // 2 + 1), indexing="ij")
    a, b = 2 * np.pi * (around % count) / count, np.pi * up / (count // 2)
    ball = np.stack([np.sin(b) * np.cos(a), np.sin(b) * np.sin(a), -np.cos(b)], axis=-1)
    ball[:, [0, -1], :2] = 0.0
    points = ball * [31.0, 27.0, 24.0] * (1 + 0.05 * ball[..., :1] * ball[..., 1:2])[..., [0, 0, 0]]
    lower, upper = points[:, :-1], points[:, 1:]
    one = np.stack([lower[:-1], lower[1:], upper[1:]], axis=-2)[:, 1:]
    two = np.stack([lower[:-1], upper[1:], upper[:-1]], axis=-2)[:, :-1]
    return np.concatenate([one.reshape(-1, 3, 3), two.reshape(-1, 3, 3)])


def write_stl(path, triangles):
    """Write triangles as text STL."""
    with path.open("w") as file:
        file.write("solid body\n")
        for corners in triangles:
            file.write("facet normal 0 0 0\nouter loop\n")
            file.writelines("vertex {:.6g} {:.6g} {:.6g}\n".format(*corner) for corner in corners)
            file.write("endloop\nendfacet\n")
        file.write("endsolid body\n")


write_stl(FOLDER / "pebble.stl", pebble(COUNT))

# %%
# The specification
# -----------------
# The file stands beside the specification. The core lies one shell thickness inside the surface
# everywhere; magnets and sensors are given on patches of it, as on the faces of a cube.

(FOLDER / "pebble.toml").write_text("""
name = "pebble"

[body]
kind = "imported"
file = "pebble.stl"
sensed_faces = [2, 3, 4, 5]

[magnets]
positions_mm = [[0, 0], [10, 0], [-10, 0]]

[sensors]
radius_mm = 7.0

[core]
recess_inner_radius_mm = 3.8
recess_outer_radius_mm = 10.2

[contact_grid]
count = [3, 3]
pitch_mm = 3.0
""")
stone = instobj.load_spec(FOLDER / "pebble.toml")
found = instobj.check(stone)
print(f"{found.magnets} magnets, {found.sensors} sensors, ", end="")
print(f"at most {found.largest_field_at_rest_mt:.1f} of {found.range_mt:g} mT at rest")

# %%
# The parts
# ---------
# Core, shell and the mould that casts it, as STL files to print. This takes half a minute.


def read_stl(path):
    """Triangles (triangle, corner, xyz) of a binary STL file."""
    record = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("rest", "<u2")])
    return np.fromfile(path, record, offset=84)["corners"]


shown = {"body": pebble(COUNT)}
if not QUICK:
    manifest = instobj.build_parts(stone, FOLDER / "cad_out")
    for part in manifest.parts:
        print(f"{part.name}: {part.volume_mm3 / 1000:.1f} cm³, {part.stl_triangles} triangles")
    shown["core"] = read_stl(FOLDER / "cad_out" / stone.name / "core.stl")

figure = plt.figure(figsize=(9, 4))
for k, (name, triangles) in enumerate(shown.items()):
    panel = figure.add_subplot(1, len(shown), k + 1, projection="3d")
    x, y, z = triangles.reshape(-1, 3).T
    index = np.arange(len(x)).reshape(-1, 3)
    panel.plot_trisurf(x, y, z, triangles=index, color=("wheat", "lightsteelblue")[k])
    panel.set_aspect("equal")
    panel.set(title=name, xlabel="x (mm)", ylabel="y (mm)", zlabel="z (mm)")
plt.show()

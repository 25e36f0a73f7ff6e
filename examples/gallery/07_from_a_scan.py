"""
From a scan to parts, a map and a price
=======================================

A pear's surface becomes an object: ``instobj new`` places magnets and sensors in it, the parts are files to
print, and the map says where a touch is located well. All of it takes some minutes; the quick form takes the
small cube in place of the pear.
"""

import csv
import os
import subprocess
import tempfile
from pathlib import Path

import matplotlib.pyplot as plt

import instobj

specification = "small_cube.toml"
if os.environ.get("INSTOBJ_GALLERY") != "quick":
    subprocess.run(["instobj", "new", "my_pear", "--from", "../bodies/pear.stl"], check=True)
    specification = "my_pear.toml"
run = instobj.Run(instobj.load_spec(specification))
parts = instobj.build_parts(run.spec, Path(tempfile.mkdtemp())).parts
with (run.require("sheet").folder / "orders.csv").open() as file:
    price_eur = sum(float(line["high_eur"]) for line in csv.DictReader(file))
bound = run.scores.position_bound_mm  # face, place
figure, panels = plt.subplots(
    1, len(bound.face), figsize=(11, 3), sharey=True, squeeze=False, layout="constrained"
)
for panel, face in zip(panels[0], bound.transpose("face", ...), strict=True):
    points = panel.scatter(face.x_mm, face.y_mm, c=face, vmin=0, vmax=5, cmap="viridis_r")
    panel.set(title=f"face {int(face.face)}", xlabel="x (mm)", aspect="equal")
figure.colorbar(points, label="position bound (mm)", extend="max")
figure.suptitle(f"{run.spec.name}: {len(parts)} parts to print, at most {price_eur:.0f} EUR to buy")
plt.show()

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
figure, axes = plt.subplots(figsize=(11, 7), layout="constrained")
axes.imshow(plt.imread(run.require("scores").folder / "maps" / "position_bound_overview.png"))
axes.set_title(f"{run.spec.name}: {len(parts)} parts to print, at most {price_eur:.0f} EUR to buy")
axes.axis("off")
plt.show()

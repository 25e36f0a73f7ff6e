"""
A first object
==============
A specification is loaded, checked, simulated and scored; the map shows how well a contact can be
located at best.
"""

import os

import matplotlib.pyplot as plt
import numpy as np

import instobj

# %%
# The specification
# -----------------
# A specification is a TOML file; what it leaves out has a default. ``instobj new NAME`` writes a
# file with every key. ``load_spec`` refuses unknown keys, ``check`` also what does not fit.

FULL = os.environ.get("INSTOBJ_GALLERY") == "full"
SPEC = "../paper_cube.toml" if FULL else "small_cube.toml"
cube = instobj.load_spec(SPEC)
instobj.check(cube)

# %%
# Simulate and score
# ------------------
# A ``Run`` computes each result when it is asked for, and keeps it in the same store as the
# commands: the second time it takes a second. ``position_bound_mm`` is the Cramér–Rao bound of the
# contact location, per face and contact location, for a press of ``score.force_n``.

run = instobj.Run(cube)
bound_mm = np.asarray(run.scores.position_bound_mm)
print(f"{cube.name}: median {np.median(bound_mm):.2f} mm, worst {bound_mm.max():.2f} mm")

# %%
# The map of face 1
# -----------------
# Contact locations lie on a grid; index X runs along the face's x, Y along its y. Crosses are
# magnets, squares are sensors.

nx, ny = (len(np.unique(run.scores[axis])) for axis in ("x_mm", "y_mm"))
half_x, half_y = (n * cube.contact_grid.pitch_mm / 2 for n in (nx, ny))
figure, axes = plt.subplots(figsize=(5.5, 4.5))
image = axes.imshow(
    bound_mm.reshape(-1, nx, ny)[0].T,
    origin="lower",
    extent=(-half_x, half_x, -half_y, half_y),
    cmap="viridis_r",
)
axes.plot(*np.transpose(cube.magnets.positions_mm), "kx", label="magnets")
axes.plot(*np.transpose(cube.sensors.places[0])[:2], "ws", mec="k", label="sensors")
axes.set(xlabel="x (mm)", ylabel="y (mm)", title=f"Face 1, press of {cube.score.force_n:g} N")
axes.legend(loc="upper right")
figure.colorbar(image, label="position bound (mm)")
plt.show()

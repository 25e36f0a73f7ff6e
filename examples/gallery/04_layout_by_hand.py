"""
A layout scored by hand
=======================
The Cramér–Rao bound in twenty lines of NumPy: derivatives of the signals, Fisher information, and
its inverse, beside what ``Run.scores`` says.
"""

import os

import matplotlib.pyplot as plt
import numpy as np

import instobj

FULL = os.environ.get("INSTOBJ_GALLERY") == "full"
SPEC = "../paper_cube.toml" if FULL else "small_cube.toml"
cube = instobj.load_spec(SPEC, ["contact_grid.pitch_mm=3"])
run = instobj.Run(cube)

# %%
# Signals at one force
# --------------------
# Signals come at steps of indentation depth. A polynomial through rest and all steps gives them,
# and their slope, at the force of the score.

nx, ny = (len(np.unique(run.scores[axis])) for axis in ("x_mm", "y_mm"))
signals = run.signals
own = np.asarray(signals.sensor_face) == 1
force_n = np.asarray(signals.force_n)[0]  # place, step
counts = np.asarray(signals.delta_counts)[0][:, :, own]  # place, step, sensor, axis
score_n = cube.score.force_n

at_force, per_newton = [], []
for force, rows in zip(force_n, counts.reshape(nx * ny, len(force_n[0]), -1), strict=True):
    rows, force = np.vstack([0 * rows[:1], rows]), np.append(0.0, force)
    powers = np.polynomial.polynomial.polyfit(force, rows, 4)
    at_force.append(score_n ** np.arange(5) @ powers)
    per_newton.append(np.arange(1, 5) * score_n ** np.arange(4) @ powers[1:])

# %%
# Fisher information
# ------------------
# J holds the derivatives by x, y and force, in units of the noise: white noise of one reading, and
# the error of the baseline. The bound of the location is the root of the variances of x and y.

grid = np.reshape(at_force, (nx, ny, -1))
pitch_mm = cube.contact_grid.pitch_mm
along_x, along_y = (np.gradient(grid, pitch_mm, axis=k, edge_order=2) for k in (0, 1))
noise = np.hypot(cube.sensors.noise_counts, cube.sensors.zeroing_counts)
sigma = np.tile(noise, own.sum())
jacobian = np.stack([along_x, along_y, np.reshape(per_newton, grid.shape)], axis=-1)
jacobian = jacobian / sigma[:, None]
information = np.swapaxes(jacobian, -1, -2) @ jacobian
covariance = np.linalg.inv(information)
by_hand_mm = np.sqrt(covariance[..., 0, 0] + covariance[..., 1, 1])

# %%
# Beside the library
# ------------------
# The library takes derivatives on a lattice twice as fine, with half a pitch of margin: the two differ
# most at the border of the grid.

library_mm = np.asarray(run.scores.position_bound_mm)[0].reshape(nx, ny)
ratio = by_hand_mm / library_mm
print(f"by hand over library: {np.median(ratio):.2f} in the median, {ratio.max():.2f} at most")

figure, axes = plt.subplots(1, 2, figsize=(9, 4), layout="constrained")
largest = max(by_hand_mm.max(), library_mm.max())
for panel, bound_mm, title in zip(
    axes, (by_hand_mm, library_mm), ("by hand", "Run.scores"), strict=True
):
    image = panel.imshow(bound_mm.T, origin="lower", vmin=0, vmax=largest, cmap="viridis_r")
    panel.set(xlabel="X", ylabel="Y", title=title, xticks=range(nx), yticks=range(ny))
figure.colorbar(image, ax=axes, label="position bound (mm)")
plt.show()

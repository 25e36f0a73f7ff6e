"""
A press looked at
=================
One tip goes down at one contact location: force, motion of the magnets, and what the sensors read.
"""

import os

import matplotlib.pyplot as plt
import numpy as np

import instobj

FULL = os.environ.get("INSTOBJ_GALLERY") == "full"
SPEC = "../paper_cube.toml" if FULL else "small_cube.toml"
cube = instobj.load_spec(SPEC)
run = instobj.Run(cube)

# %%
# Presses and signals are tables over face, contact location and step of indentation depth. Contact
# location X, Y is number X · ny + Y: here one beside the middle of face 1.

nx, ny = (len(np.unique(run.scores[axis])) for axis in ("x_mm", "y_mm"))
place = (nx // 2 - 1) * ny + ny // 2
signals = run.signals
depth_mm = np.asarray(signals.depth_mm)
force_n = np.asarray(signals.force_n)[0, place]
change_counts = np.asarray(signals.delta_counts)[0, place]  # step, sensor, axis

# %%
# Force grows faster than depth, because the contact area grows. Signals are changes of the reading
# against the baseline; each sensor gives three, along its X, Y and Z.

figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4))
left.plot(depth_mm, force_n, "o-")
left.set(xlabel="indentation depth (mm)", ylabel="force (N)", title="Force")
own = change_counts[:, : cube.sensors.count_per_face]
for sensor, colour in enumerate(plt.cm.tab10.colors[: own.shape[1]]):
    for axis, line in enumerate(("-", "--", ":")):
        label = f"sensor {sensor + 1}, {'XYZ'[axis]}"
        right.plot(depth_mm, own[:, sensor, axis], line, color=colour, label=label)
right.set(xlabel="indentation depth (mm)", ylabel="change (counts)", title="Signals of face 1")
right.legend(fontsize="small", ncols=2)
figure.tight_layout()
plt.show()

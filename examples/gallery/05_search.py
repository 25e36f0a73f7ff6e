"""
A search
========
Where should the sensors sit on the core? Layouts are drawn at random, scored, and the best is kept.

This is the simplest search there is. ``instobj optimize`` also moves magnets, takes gradients, and
confirms the best layouts by the whole chain.
"""

import os

import matplotlib.pyplot as plt
import numpy as np

import instobj

FORM = os.environ.get("INSTOBJ_GALLERY", "")
SPEC = "../paper_cube.toml" if FORM == "full" else "small_cube.toml"
TRIALS = {"quick": 2, "full": 30}.get(FORM, 8)

# %%
# A trial
# -------
# Two numbers describe a layout: the azimuth of the first sensor of the ring, and the radius of the
# ring. What does not fit raises ``InputError``, which says why. Sensors do not touch the silicone:
# stored mechanics is reused, and a trial costs seconds.


def worst_bound_mm(azimuth_deg, radius_mm):
    """Largest position bound over all contact locations; infinite where sensors do not fit."""
    try:
        cube = instobj.load_spec(
            SPEC,
            [f"sensors.first_azimuth_deg=[{azimuth_deg}]", f"sensors.radius_mm={radius_mm}"],
        )
    except instobj.InputError as error:
        print(f"left out: {str(error).splitlines()[-1]}")
        return np.inf
    return float(np.max(instobj.Run(cube).scores.position_bound_mm))


start = instobj.load_spec(SPEC)
start_mm = float(np.max(instobj.Run(start).scores.position_bound_mm))
draw = np.random.default_rng(1)
layouts = np.column_stack([draw.uniform(0, 120, TRIALS), draw.uniform(8.0, 9.0, TRIALS)])
found_mm = np.array([worst_bound_mm(round(a, 1), round(r, 2)) for a, r in layouts])

# %%
# The best so far
# ---------------
# Each point is one trial; the line is the best result up to it.

best = int(np.argmin(found_mm))
print(f"as specified: {start_mm:.2f} mm at the weakest contact location")
print(f"best trial: {found_mm[best]:.2f} mm, azimuth {layouts[best, 0]:.1f}°")

figure, axes = plt.subplots(figsize=(6, 4))
trial = np.arange(TRIALS + 1)
values_mm = np.append(start_mm, found_mm)
axes.plot(trial, values_mm, "o", label="trial (0: as specified)")
axes.step(trial, np.minimum.accumulate(values_mm), where="post", label="best so far")
axes.set(xlabel="trial", ylabel="worst position bound (mm)")
axes.set_ylim(0, 1.3 * values_mm[np.isfinite(values_mm)].max())
axes.legend()
plt.show()

"""
Two designs compared
====================
Three sensors per face, or four? Both designs have the same silicone and magnets, so that mechanics
is computed once.
"""

import os

import matplotlib.pyplot as plt
import numpy as np

import instobj

FULL = os.environ.get("INSTOBJ_GALLERY") == "full"
SPEC = "../paper_cube.toml" if FULL else "small_cube.toml"

# %%
# A design is the file with some keys overridden, written as for ``--set``.

designs = {
    f"{count} sensors": instobj.load_spec(
        SPEC, [f"sensors.count_per_face={count}", f'name="cube_with_{count}_sensors"']
    )
    for count in (3, 4)
}
bounds_mm = {
    name: np.asarray(instobj.Run(design).scores.position_bound_mm).ravel()
    for name, design in designs.items()
}

# %%
# Contact locations are sorted by their bound: a curve further down is a better design. The end of
# the curve is the weakest contact location.

figure, axes = plt.subplots(figsize=(6, 4))
for name, bound_mm in bounds_mm.items():
    share = 100 * (np.arange(len(bound_mm)) + 1) / len(bound_mm)
    axes.step(share, np.sort(bound_mm), where="mid", label=name)
    print(f"{name}: median {np.median(bound_mm):.2f} mm, worst {bound_mm.max():.2f} mm")
axes.set(xlabel="share of the contact locations (%)", ylabel="position bound (mm)")
axes.set_ylim(bottom=0)
axes.legend()
plt.show()

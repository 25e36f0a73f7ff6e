"""
Picked up and turned
====================

An object is zeroed, picked up and turned: Earth's field now comes from another side, and every chip
shows it. One reader takes the object for one that stands still. The other knows that it is turned.
"""

import os

import matplotlib.pyplot as plt
import numpy as np

import instobj

FULL = os.environ.get("INSTOBJ_GALLERY") == "full"
SPEC = "../paper_cube.toml" if FULL else "small_cube.toml"
turned = instobj.load_spec(SPEC)
still = turned.changed(limits={"use": "bench"})

# %%
# One grasp, felt by a simulated object
# -------------------------------------
# The zero is the mean of the first frames, at rest. Then the object turns by a quarter. While it
# turns on, a finger presses its top by 5 N and lets go.
EARTH_UT = (20.0, 0.0, -45.0)  # north and down, as in Europe
FRAMES, RESTING, PRESSED = 120, 20, slice(60, 100)
angle = np.interp(np.arange(FRAMES), [RESTING, FRAMES - 20], [0.0, np.pi / 2])
true_n = np.zeros(FRAMES)
true_n[PRESSED] = 5.0
finger_mm = np.array([[4.0, -3.0, turned.body.size_mm[2] / 2]])
contacts_file = instobj.Run(turned).require("inversion").folder / "contacts.nc"
hall = instobj.sim.HallObject(contacts_file, ambient_ut=EARTH_UT, seed=3)


def about_y(turn):
    """Return the object's axes in the world, as columns."""
    cos, sin = np.cos(turn), np.sin(turn)
    return np.array([[cos, 0.0, sin], [0.0, 1.0, 0.0], [-sin, 0.0, cos]])


counts = np.array(
    [
        hall.read(finger_mm, np.array([force]), about_y(turn)).ravel()
        for force, turn in zip(true_n, angle, strict=True)
    ]
)
change = counts - counts[:RESTING].mean(axis=0)

# %%
# The same frames, read twice
# ---------------------------
# ``limits.use`` says how the object is used. In every use but ``"bench"`` the reader takes a turned
# field and warm magnets as unknowns, and says how far the field has turned.
read_n, explained = {}, {}
for name, spec in (("stands still", still), ("is turned", turned)):
    sets, _ = instobj.Run(spec).inversion.read(change)
    read_n[name] = np.nansum(sets.force_n, axis=1)
    explained[name] = sets.explained
field_ut, sigma_ut = sets.since_zero[:, :3], sets.since_zero_sigma[:, :3]
true_ut = np.array([EARTH_UT @ about_y(turn) for turn in angle]) - EARTH_UT

figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.5), layout="constrained")
for name, force_n in read_n.items():
    left.plot(force_n, ".", label=f"reader: it {name}")
left.plot(true_n, "k", lw=1, label="true")
left.set(xlabel="frame", ylabel="force, N", title="Force")
left.legend()
for axis, label in enumerate("xyz"):
    (line,) = right.plot(true_ut[:, axis], lw=1)
    right.errorbar(
        np.arange(FRAMES)[::6],
        field_ut[::6, axis],
        1.645 * sigma_ut[::6, axis],
        fmt=".",
        color=line.get_color(),
        label=label,
    )
right.set(xlabel="frame", ylabel="change of the field, µT", title="Field, with 90 % intervals")
right.legend()
plt.show()

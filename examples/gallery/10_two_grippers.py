"""
Which gripper is gentler?
=========================

Two simulated grippers take the same object twelve times each. What its sensors felt ranks them, with an
interval. With recordings and all faces, ``instobj assess`` does this in one command.
"""

# %%
# What the object feels at each force
# -----------------------------------
import matplotlib.pyplot as plt
import numpy as np

import instobj

run = instobj.Run(instobj.load_spec("small_cube.toml"))
signals = run.signals
middle = int(np.argmin(np.hypot(signals.x_mm.values, signals.y_mm.values)))
press = signals.isel(face=0, place=middle)
force_n = np.append(0.0, press.force_n.values)
felt = np.append(0.0, np.linalg.norm(press.delta_counts.values, axis=(1, 2)))

# %%
# Twelve grasps of each
# ---------------------
# A grasp closes to its force, a little other each time, and overshoots where the pad is hard. Frames carry
# the sensors' noise. The peak is read from the frames, not taken from the gripper.
NOISE = np.mean(run.spec.sensors.noise_counts)
GRIPPERS = {"soft pad": (4.0, 0.05), "hard pad": (4.0, 0.35)}  # N, overshoot
SHAPE = np.array([0.3, 0.7, 1.0, 1.0, 1.0, 1.0, 0.5])


def read_peak_n(level_n, overshoot, rng):
    course = level_n * rng.normal(1.0, 0.06) * SHAPE
    course[2] *= 1.0 + overshoot
    seen = np.interp(course, force_n, felt) + rng.normal(0.0, NOISE, len(course))
    return np.interp(seen, felt, force_n).max()


rng = np.random.default_rng(1)
peaks_n = {
    name: np.array([read_peak_n(*how, rng) for _ in range(12)]) for name, how in GRIPPERS.items()
}

# %%
# The answer in a sentence
# ------------------------
# The median difference, and its 95 % interval by drawing grasps again.
soft, hard = (rng.choice(peaks_n[name], (2000, 12)) for name in GRIPPERS)
low, high = np.percentile(np.median(hard, axis=1) - np.median(soft, axis=1), [2.5, 97.5])
gentler = "the soft pad is gentler" if low > 0 else "they cannot be ranked yet"
plt.boxplot(list(peaks_n.values()), tick_labels=list(peaks_n))
plt.ylabel("peak force, N")
plt.title(f"{gentler}: {low:.2f} to {high:.2f} N less")
plt.show()

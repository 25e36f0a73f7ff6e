"""
Which gripper is gentler?
=========================

Two simulated grippers take one object twelve times each, and its sensors' noise is on every frame. What the
object felt ranks them, with an interval. ``instobj assess`` does this with recordings and all faces.
"""

import matplotlib.pyplot as plt
import numpy as np

import instobj

run = instobj.Run(instobj.load_spec("small_cube.toml"))
press = run.signals.isel(face=0, place=5)  # of 4 × 4, next to the middle
force_n = np.append(0.0, press.force_n.values)
felt = np.append(0.0, np.linalg.norm(press.delta_counts.values, axis=(1, 2)))
noise, rng = np.mean(run.spec.sensors.noise_counts), np.random.default_rng(1)
GRIPPERS, peaks_n = {"soft pad": (4.0, 0.05), "hard pad": (4.0, 0.35)}, {}  # N, overshoot
for name, (force, overshoot) in GRIPPERS.items():
    level_n = force * rng.normal(1.0, 0.06, (12, 1)) * [0.3, 0.7, 1.0 + overshoot, 1.0, 1.0, 0.5]
    seen = np.interp(level_n, force_n, felt) + rng.normal(0.0, noise, level_n.shape)
    peaks_n[name] = np.interp(seen, felt, force_n).max(axis=1)
soft, hard = (np.median(rng.choice(peaks_n[name], (2000, 12)), axis=1) for name in peaks_n)
low, high = np.percentile(hard - soft, [2.5, 97.5])
gentler = "the soft pad is gentler" if low > 0 else "they cannot be ranked yet"
plt.boxplot(list(peaks_n.values()), tick_labels=list(peaks_n))
plt.title(f"{gentler}: {low:.2f} to {high:.2f} N less peak force")
plt.show()

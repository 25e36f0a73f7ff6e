"""
Squeeze less
============

A jaw presses the object until its sensors say that the grip is strong enough, then stops. Two
policies lift the same object: one squeezes with a fixed force, the other by what the object felt.
"""

# %%
# The object's presses, simulated
# -------------------------------
import matplotlib.pyplot as plt
import numpy as np

import instobj

run = instobj.Run(instobj.load_spec("small_cube.toml"))
signals = run.signals
middle = int(np.argmin(np.hypot(signals.x_mm.values, signals.y_mm.values)))
press = signals.isel(face=0, place=middle)
force_n = np.append(0.0, press.force_n.values)
depth_mm = np.append(0.0, press.depth_mm.values)
felt = np.append(0.0, np.linalg.norm(press.delta_counts.values, axis=(1, 2)))

# %%
# A loop with the object's own compliance
# ---------------------------------------
# The jaw closes by small steps and reads 16 frames at each. The policy sees counts with noise
# alone. It stops at the force that friction needs, with a margin.
NOISE = np.mean(run.spec.sensors.noise_counts) / 4  # of the mean of 16 frames
WEIGHTS_N, FRICTION, STEP_MM = np.linspace(0.4, 2.0, 9), 0.5, 0.02


def grip(stop_n, rng):
    for travel_mm in np.arange(0.0, depth_mm[-1], STEP_MM):
        true_n = np.interp(travel_mm, depth_mm, force_n)
        seen = np.interp(true_n, force_n, felt) + rng.normal(0.0, NOISE)
        if np.interp(seen, felt, force_n) >= stop_n:
            return true_n
    return force_n[-1]


# %%
# Tuned and judged by what the object felt
# ----------------------------------------
# The smallest margin that never drops the object in the tuning grasps is judged on new ones.
def forces_of(margin, seed):
    rng = np.random.default_rng(seed)
    return np.array([grip(margin * w / (2 * FRICTION), rng) for w in WEIGHTS_N])


needed_n = WEIGHTS_N / (2 * FRICTION)
margins = np.arange(1.0, 3.0, 0.05)
safe = [m for m in margins if all((forces_of(m, s) >= needed_n).all() for s in range(5))]
judged_n = np.mean([forces_of(safe[0], seed) for seed in range(100, 110)], axis=0)
fixed_n = np.full(len(WEIGHTS_N), 1.2 * needed_n.max())
plt.plot(WEIGHTS_N, np.transpose([judged_n, fixed_n, needed_n]), label=["felt", "fixed", "needed"])
plt.gca().set(xlabel="weight, N", ylabel="squeeze, N")
plt.legend()
plt.show()

"""
Squeeze less
============

A jaw presses an object until the object's own sensors say that the grip is strong enough. Two
policies lift the same weights: one squeezes with a fixed force, the other by what the object felt.
"""

# %%
# The object in a simulator, and its reader
# -----------------------------------------
# ``HallObject`` turns contacts into counts, with noise and drift. The reader turns counts into
# contacts. Both come from one file, ``contacts.nc``; for your own object take that of its twin.
import subprocess
import sys
import tempfile
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import instobj

spec = instobj.load_spec("small_cube.toml").changed(limits={"use": "bench"})  # it stands still
run = instobj.Run(spec)
contacts_file = run.require("inversion").folder / "contacts.nc"
hall, reader = instobj.sim.HallObject(contacts_file, seed=1), run.inversion
top = np.array([[0.0, 0.0, spec.body.size_mm[2] / 2]])
squeeze_n = np.append(np.zeros(4), np.arange(0.15, 8.0, 0.15))  # begins with rest, for the zero
HELD = 4  # frames that each squeeze is held for


def close():
    """Return the counts (squeeze, frame, channel) of a closing jaw, and the force read at each squeeze."""
    hall.reset()
    force_n = squeeze_n.repeat(HELD)
    frames = np.array([hall.read(top, np.array([force])).ravel() for force in force_n])
    counts = frames.reshape(len(squeeze_n), HELD, -1)
    held, zero = counts.mean(axis=1), counts[:4].mean(axis=(0, 1))
    sets, _ = reader.read(held - zero, averaged=np.full(len(held), HELD))
    return counts, np.nansum(sets.force_n, axis=1)


# %%
# Tuned and judged by what the object felt
# ----------------------------------------
# The policy stops at the force that friction needs, with a margin. The smallest margin that drops
# nothing in four closings is judged on four new ones.
needed_n = np.linspace(1.5, 6.0, 9)  # weight / (2 × friction)


def stops(margin, read_n):
    twice_n = np.minimum(read_n[1:], read_n[:-1])  # a single reading may err
    return np.array([squeeze_n[1 + np.argmax(twice_n >= margin * n)] for n in needed_n])


felt_n = [close()[1] for _ in range(8)]
margins = np.arange(1.0, 2.4, 0.05)
safe = [m for m in margins if all((stops(m, read_n) >= needed_n).all() for read_n in felt_n[:4])]
judged_n = np.array([stops(safe[0], read_n) for read_n in felt_n[4:]])
fixed_n = np.full(len(needed_n), 1.2 * needed_n.max())

# %%
# The same reader on the bench
# ----------------------------
# A closing as a recording, in the format of a board's. The command that reads a board
# (``instobj predict contacts.nc --port PORT``) replays it with the same file.
counts, read_n = close()
recording = Path(tempfile.mkdtemp()) / "closing.csv"
names = ["time_s", *(f"F1-{axis}{chip}" for chip in (1, 2, 3) for axis in "XYZ")]
frames = counts.reshape(-1, counts.shape[2])
time_s = np.arange(len(frames)) / spec.sensors.frame_rate_hz
table = np.column_stack([time_s, frames])
np.savetxt(recording, table, fmt="%.6g", delimiter=",", header=",".join(names), comments="")
command = [sys.executable, "-m", "instobj", "predict", "--zero", "first:16"]
command += ["--out", recording.parent, contacts_file, recording]
subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
read = recording.parent / "runs" / "closing" / "contacts.csv"
rows = np.genfromtxt(read, delimiter=",", names=True)
bench_n = np.bincount(rows["frame"].astype(int), np.nan_to_num(rows["force_n"]), len(frames))

figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.5), layout="constrained")
mean_n = [judged_n.mean(axis=0), fixed_n, needed_n]
left.plot(needed_n, np.transpose(mean_n), label=["by what is felt", "fixed", "needed"])
forces_n = [bench_n, read_n.repeat(HELD), squeeze_n.repeat(HELD)]
right.plot(time_s, np.transpose(forces_n), label=["instobj predict", "read in the loop", "true"])
left.set(xlabel="force that friction needs, N", ylabel="squeeze, N")
right.set(xlabel="time of a closing, s", ylabel="force, N")
left.legend()
right.legend()
plt.show()

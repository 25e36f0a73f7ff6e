"""
A recording read, an estimator trained
======================================
A recording is a CSV file: one line per frame with raw counts, and the force and location of the
load cell. Give the path of your own as an argument; without one, a recording is made up first.
"""

import os
import sys
import tempfile
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import instobj

FULL = os.environ.get("INSTOBJ_GALLERY") == "full"
SPEC = "../paper_cube.toml" if FULL else "small_cube.toml"
FACE = 1
cube = instobj.load_spec(SPEC)

# %%
# A recording
# -----------
# Made up from simulated signals: at each contact location the tip goes down and up six times, with
# rest before. Readings are baseline, change and noise, in whole counts.


def make_recording(path, presses=6, rest=12, pressed=24):
    """Write a recording of face 1 of the simulated cube, in the generic format."""
    signals, draw = instobj.Run(cube).signals, np.random.default_rng(1)
    own = np.asarray(signals.sensor_face) == FACE
    steps = np.append(0.0, signals.depth_mm)
    force_n = np.asarray(signals.force_n)[0]
    counts = np.asarray(signals.delta_counts)[0][:, :, own].reshape(*force_n.shape, -1)
    baseline = np.asarray(signals.baseline_counts)[own].ravel()
    noise = np.tile(cube.sensors.noise_counts, own.sum())
    rows = []
    for _ in range(presses):
        for k in range(len(force_n)):
            peak_mm = draw.uniform(0.6, 1.0) * steps[-1]
            depth_mm = np.append(np.zeros(rest), peak_mm * np.sin(np.linspace(0, np.pi, pressed)))
            force = np.interp(depth_mm, steps, np.append(0.0, force_n[k]))
            change = [np.interp(depth_mm, steps, np.append(0.0, one)) for one in counts[k].T]
            reading = np.rint(
                np.transpose(change) + baseline + draw.normal(0, noise, (len(force), len(noise)))
            )
            place = np.tile([FACE, float(signals.x_mm[k]), float(signals.y_mm[k])], (len(force), 1))
            rows.append(np.column_stack([force, place, reading]))
    rows = np.vstack(rows)
    time_s = np.arange(len(rows)) / cube.sensors.frame_rate_hz
    channels = [f"F{FACE}-{axis}{n + 1}" for n in range(own.sum()) for axis in "XYZ"]
    names = ["time_s", "cell1_force_n", "cell1_face", "cell1_x1_mm", "cell1_y1_mm", *channels]
    table = np.column_stack([time_s, rows])
    np.savetxt(path, table, fmt="%.6g", delimiter=",", header=",".join(names), comments="")


given = [name for name in sys.argv[1:] if name.endswith((".csv", ".nc"))]
path = Path(given[0]) if given else Path(tempfile.mkdtemp()) / "made_up.csv"
if not given:
    make_recording(path)

# %%
# Reading
# -------
# ``read_recording`` finds and corrects faults: dead channels, lag of the load cell, wrong labels.
# The baseline of each press is taken from the rest before it.

recording = instobj.read_recording(path)
frames = recording.frames
print(f"{len(frames)} frames, {len(np.unique(frames.press_id))} presses and rests")

# %%
# Training
# --------
# Whole presses are held out: frames of one press resemble each other too much to be split.
# ``evaluate`` judges on presses that took no part in the training.

model = instobj.fit_estimator(recording, face=FACE, training=cube.training)
metrics = instobj.evaluate(model, recording)
print(f"force error {metrics.total_force_error_percent:.1f} % of the range")
print(f"localisation error {metrics.location_error_px:.2f} pixels of the contact grid")

# %%
# Reading force from signals
# --------------------------
# The estimator answers every frame, with a half-width that holds in 90 % of the frames of new
# presses. Here is the first part of the recording.

reading = instobj.predict(model, recording)
shown = slice(0, 200)
figure, axes = plt.subplots(figsize=(8, 3.5), layout="constrained")
frame = np.arange(len(frames))[shown]
low, high = (reading.force_n + sign * reading.force_halfwidth_n for sign in (-1, 1))
axes.fill_between(frame, low[shown], high[shown], alpha=0.3, label="90 % interval")
axes.plot(frame, reading.force_n[shown], label="estimated")
truth_n = np.nansum(np.where(frames.contact_face == FACE, frames.force_n[:, :, 2], 0), axis=1)
axes.plot(frame, truth_n[shown], "k:", label="load cell")
axes.set(xlabel="frame", ylabel="force (N)", title=f"Face {FACE}")
axes.legend()
plt.show()

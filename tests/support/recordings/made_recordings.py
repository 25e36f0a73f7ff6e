"""Recordings made for tests, in the two public formats, with faults planted on demand."""

import csv
from pathlib import Path

import numpy as np

FILE_FACES = (5, 3, 1, 2, 4)
HEAD = ["Time", "Left", "Right-blue"]
CHANNELS = [f"F{f}-{a}{s}" for f in FILE_FACES for s in (1, 2, 3) for a in "XYZ"]
REST, RISE, HOLD = 20, 25, 40
PRESS = REST + 2 * RISE + HOLD + REST


def force_profile(peak_n):
    """Rest, ramp, slowly creeping hold, ramp down, rest: not symmetric in time."""
    return np.concatenate(
        [
            np.zeros(REST),
            peak_n * np.linspace(0, 1, RISE) ** 2,
            peak_n * np.linspace(1, 0.96, HOLD),
            0.96 * peak_n * np.linspace(1, 0, RISE) ** 1.5,
            np.zeros(REST),
        ]
    )


def gripper_arrays(cases=((54, 57), (23, 28)), presses=3, lag=8, noise=20.0, seed=0):
    """Time (whole s), forces (N), counts (frame, face, 9), case index of each frame.

    `cases` are single labels on faces 3 and 5. The load cells report `lag` frames late.
    """
    rng = np.random.default_rng(seed)
    gain = rng.choice([-1, 1], (len(cases), 5, 9)) * rng.uniform(15, 40, (len(cases), 5, 9))
    gain[:, [0, 1, 3]] *= 0.05
    true, counts, time, case = [], [], [], []
    clock = 1_700_000_000.3
    for number in range(len(cases) * presses):
        kind = number // presses
        force = np.stack([force_profile(17 + kind), force_profile(18.5 - kind)], axis=1)
        strength = np.zeros((PRESS, 5))
        strength[:, 2], strength[:, 4] = force.T
        true.append(np.concatenate([np.zeros((lag, 2)), force])[:PRESS] if lag else force)
        counts.append(gain[kind] * (strength / (1 + 0.01 * strength))[:, :, None])
        time.append(clock + np.arange(PRESS) / 10.5)
        case.append(np.full(PRESS, kind))
        clock = time[-1][-1] + 14.2
    base = rng.integers(-1500, 1500, (5, 9))
    counts = np.concatenate(counts) + base
    counts = np.round(counts + rng.normal(0, noise, counts.shape))
    force = np.concatenate(true) + rng.normal(0, 0.002, (len(counts), 2))
    return np.floor(np.concatenate(time)), force, counts, np.concatenate(case)


def write_gripper(path: Path, arrays, cases=((54, 57), (23, 28)), faces=None) -> Path:
    """Write arrays of `gripper_arrays`; `cases[k]` holds one label (or tuple) a face."""
    time, force, counts, case = arrays
    cases = [tuple(np.atleast_1d(side) for side in pair) for pair in cases]
    tips = len(cases[0][0])
    header = [*HEAD, *CHANNELS]
    second = ["Probe_Pos_2"] if tips == 1 else [f"Probe_Pos_{k + 1}" for k in range(tips)]
    header += ["Probe_Face_1", *(f"Probe_Pos_{k + 1}" for k in range(tips))]
    header += ["Probe_Face_2", *second]
    faces = np.tile([3, 5], (len(time), 1)) if faces is None else faces
    with path.open("w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(header)
        signals = counts[:, np.array(FILE_FACES) - 1].reshape(len(time), -1).tolist()
        for row, signal in enumerate(signals):
            cells = ["" if value != value else f"{value:.0f}" for value in signal]
            label = cases[case[row]]
            grams = [f"{value / 9.8e-3:.2f}" for value in force[row]]
            writer.writerow(
                [
                    f"{time[row]:.0f}",
                    *grams,
                    *cells,
                    faces[row, 0],
                    *label[0],
                    faces[row, 1],
                    *label[1],
                ]
            )
    return path


def write_training(path: Path, labels, presses=4, face=2, seed=0, sign=-1.0, offset=5.0) -> Path:
    """A CNC file without header: `labels` maps case number to a tuple of tip labels."""
    rng = np.random.default_rng(seed)
    tips = {len(places) for places in labels.values()}
    columns = tips.pop()
    with path.open("w", newline="") as file:
        writer = csv.writer(file)
        for case, places in labels.items():
            gain = rng.uniform(20, 40, 9) * rng.choice([-1, 1], 9)
            touching = case not in (0, 101)
            force = np.tile(force_profile(12.0) * touching, presses)
            counts = 300 + force[:, None] * gain + rng.normal(0, 15, (len(force), 9))
            shown = sign * force + offset + rng.choice([-0.06, 0, 0.06], len(force))
            extra = [] if columns == 1 else list(places)
            for value, signal in zip(shown, counts, strict=True):
                writer.writerow([face, case, f"{value:.3f}", *np.round(signal).astype(int), *extra])
    return path

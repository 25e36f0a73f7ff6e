"""Recordings whose presses are numbered, made up of the few arrays that a check looks at."""

import numpy as np

from estimator.recordings.checks.judged import Judged
from estimator.recordings.checks.repeats import repeated_readings
from estimator.recordings.presses import LagReport
from estimator.recordings.table import RawTable


def raw_table(frames, kind="generic", cells=1, **given):
    """Silent chips and no labels, but for what is given."""
    plain = {
        "time_s": np.arange(frames) / 10,
        "force_n": np.zeros((frames, cells)),
        "counts": np.zeros((frames, 5, 2, 3)),
        "face": np.zeros((frames, cells), int),
        "tip_xy_mm": np.full((frames, cells, 1, 2), np.nan),
        "case": np.zeros(frames, int),
        "declared_rest": np.zeros(frames, bool),
        "grid_x_mm": np.arange(3.0),
        "grid_y_mm": np.arange(3.0),
        "duplicate_columns": (),
        "digest": "x",
    }
    return RawTable(kind=kind, **(plain | given))


def judged(press, force_n, kind="generic", counts=None, face=None, **given):
    """Presses of so many frames with the forces (frame, cell) of their load cells."""
    press, force_n = np.asarray(press), np.asarray(force_n, float)
    frames, cells = force_n.shape
    of_table = {"counts": counts, "face": face}
    table = raw_table(frames, kind, cells, **{k: v for k, v in of_table.items() if v is not None})
    plain = {
        "time_s": np.arange(frames) / 10,
        "rate_hz": 10.0,
        "aligned_n": force_n,
        "shear_n": np.zeros((frames, cells, 2)),
        "stretch": np.zeros(frames, int),
        "block": np.zeros(frames, int),
        "responses": np.zeros((press.max() + 1, 5)),
        "no_contact": np.zeros(frames, bool),
        "rest": np.zeros(frames, bool),
        "repeats": repeated_readings(table.counts),
        "lag": LagReport(0, (), 0.0, 1.0, 1.0, False),
        "noise_counts": np.full(table.counts.shape[1:], 10.0),
    }
    return Judged(table=table, press=press, force_n=force_n, **(plain | given))

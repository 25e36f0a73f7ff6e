"""Any recording written as a generic CSV, for tests that read it back, and what they change in it."""

import csv
from dataclasses import replace

import numpy as np

from estimator.recordings.formats.generic import cell_text, generic_columns
from estimator.recordings.table import channel_name

SHEAR_SHARE = np.array([[0.3, -0.2], [-0.1, 0.25]])
SHEAR_REST_N = np.array([[1.5, 0.0], [0.0, -0.7]])


def with_shear(table, late_frames=0):
    """Cells of three axes that are pulled in proportion, each with a resting level of its own."""
    force = np.roll(table.force_n, late_frames, axis=0)[..., None]
    return replace(table, shear_n=force * SHEAR_SHARE + SHEAR_REST_N)


def write_generic_csv(table, path):
    """Write any recording as a generic CSV; silent channels that no frame has are left out."""
    cells, tips = table.tip_xy_mm.shape[1:3]
    channels = [
        (channel_name(*index), table.counts[(slice(None), *index)])
        for index in np.ndindex(*table.counts.shape[1:])
    ]
    channels = [(name, values) for name, values in channels if np.isfinite(values).any()]
    names, sheared = [name for name, _ in channels], table.shear_n is not None
    header = generic_columns(names, cells, tips, sheared)
    time_s = table.time_s if len(table.time_s) else np.arange(len(table.force_n)) / 10.0
    face = np.where(np.isfinite(table.tip_xy_mm).any(axis=(2, 3)), table.face, np.nan)
    labels = [
        values
        for cell in range(cells)
        for values in (
            table.force_n[:, cell],
            face[:, cell],
            *table.tip_xy_mm[:, cell].reshape(len(face), -1).T,
        )
    ]
    if table.shear_n is not None:
        labels += list(table.shear_n.reshape(len(face), -1).T)
    columns = [time_s, table.case, table.declared_rest, *(v for _, v in channels), *labels]
    with path.open("w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(header)
        for row in zip(*columns, strict=True):
            writer.writerow([cell_text(float(value)) for value in row])


def edited(tmp_path, text, old, new, count=1):
    """A file of the text with one thing changed."""
    assert old in text
    path = tmp_path / "edited.csv"
    path.write_text(text.replace(old, new, count))
    return path

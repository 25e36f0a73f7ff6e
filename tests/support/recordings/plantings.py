"""Faults planted in gripper recordings, and what a report must say of each."""

import csv
import re
from dataclasses import dataclass, field

import numpy as np

from design.errors import RecordingError
from estimator.recordings.reading import read_recording

FIRST, CHANNELS = 3, 45
SLACK = 6
"""Rows by which a span may differ: chance repeats, and the rows beside a run."""


@dataclass
class Sheet:
    """Header and numbers of a gripper CSV; columns 1 and 2 are load cells, 3 to 47 channels."""

    header: list[str]
    cells: np.ndarray

    @classmethod
    def read(cls, path):
        with open(path, newline="") as file:
            header, *rows = csv.reader(file)
        return cls(header, np.array([[float(c or "nan") for c in row] for row in rows if row]))

    def copy(self):
        return Sheet(self.header, self.cells.copy())

    def write(self, path):
        with open(path, "w", newline="") as file:
            writer = csv.writer(file)
            writer.writerow(self.header)
            writer.writerows(
                ["" if v != v else f"{v:.10g}" for v in row] for row in self.cells.tolist()
            )
        return path

    def sound_chips(self):
        """First columns of chips that read all the time and lose no bits."""
        starts = range(FIRST, FIRST + CHANNELS, 3)
        return [k for k in starts if self.header[k] not in ("F4-X3", "F2-X1")]


@dataclass
class Planted:
    """What was planted: kinds that name it, its rows, and words that the sentence must hold."""

    kinds: tuple[str, ...]
    rows: tuple[int, int] | None
    words: tuple[str, ...] = ()
    errors: tuple[str, ...] = field(default=())


def _block(rng, frames, least, most):
    length = int(rng.integers(least, most))
    first = int(rng.integers(0, frames - length))
    return first, first + length


def all_constant(sheet, rng):
    first, last = _block(rng, len(sheet.cells), 5, 300)
    value = rng.choice([0, -1, rng.integers(-3000, 3000)])
    live = np.isfinite(sheet.cells[0, FIRST : FIRST + CHANNELS])
    sheet.cells[first:last, FIRST : FIRST + CHANNELS][:, live] = value
    return Planted(("no answer",), (first, last - 1), ("all",))


def all_standing(sheet, rng):
    first, last = _block(rng, len(sheet.cells), 12, 300)
    sheet.cells[first:last, FIRST : FIRST + CHANNELS] = sheet.cells[first, FIRST : FIRST + CHANNELS]
    return Planted(("standing still",), (first, last - 1), ())


def chip_constant(sheet, rng):
    first, last = _block(rng, len(sheet.cells), 8, int(0.3 * len(sheet.cells)))
    column = rng.choice(sheet.sound_chips())
    kept = sheet.cells[first, column : column + 3]
    sheet.cells[first:last, column : column + 3] = [0, -1, kept][rng.integers(3)]
    name = sheet.header[column].replace("-X", "-S")
    return Planted(("no answer", "standing still"), (first, last - 1), (name,))


def chip_silent_at_times(sheet, rng):
    rows = np.flatnonzero(rng.random(len(sheet.cells)) < rng.uniform(0.03, 0.3))
    column = rng.choice(sheet.sound_chips())
    sheet.cells[rows, column : column + 3] = 0
    name = sheet.header[column].replace("-X", "-S")
    return Planted(("no answer",), (rows[0], rows[-1]), (name, "0"))


def channel_frozen(sheet, rng):
    first, last = _block(rng, len(sheet.cells), 15, 1500)
    column = rng.choice(sheet.sound_chips()) + rng.integers(3)
    sheet.cells[first:last, column] = sheet.cells[first, column]
    return Planted(("standing still",), (first, last - 1), (sheet.header[column],))


def axes_at_zero(sheet, rng):
    rows = np.flatnonzero(rng.random(len(sheet.cells)) < rng.uniform(0.02, 0.1))
    column = rng.choice(sheet.sound_chips()) + rng.integers(3)
    sheet.cells[rows, column] = 0
    return Planted(("drop-outs",), (rows[0], rows[-1]), (sheet.header[column], "drop to 0"))


def channel_clipped(sheet, rng):
    column = rng.choice(sheet.sound_chips()) + rng.integers(3)
    values = sheet.cells[:, column]
    share = rng.uniform(0.05, 0.3)
    if rng.random() < 0.5:
        limit = np.floor(np.quantile(values, 1 - share))
        rows = np.flatnonzero(values >= limit)
        sheet.cells[:, column] = np.minimum(values, limit)
    else:
        limit = np.ceil(np.quantile(values, share))
        rows = np.flatnonzero(values <= limit)
        sheet.cells[:, column] = np.maximum(values, limit)
    words = (sheet.header[column], f"{limit:g}")
    return Planted(("clipped",), (rows[0], rows[-1]), words)


def wrong_force(sheet, rng):
    number = int(rng.choice([1, 3, 0.01 * len(sheet.cells), 0.05 * len(sheet.cells)]))
    rows = np.sort(rng.choice(len(sheet.cells), number, replace=False))
    cell = int(rng.integers(2))
    grams = rng.choice([2.0**13, 2.0**14, 2.0**18, 2.0**23]) - 1
    sheet.cells[rows, 1 + cell] = grams * rng.choice([1, -1])
    return Planted(("wrong force readings",), (rows[0], rows[-1]), (f"cell {cell + 1}",))


def file_twice(sheet, rng):
    again = sheet.cells.copy()
    again[:, 0] += np.ptp(sheet.cells[:, 0]) + rng.integers(1, 5000)
    frames = len(again)
    sheet.cells = np.concatenate([sheet.cells, again])
    return Planted(("copied rows",), (frames, 2 * frames - 1), ("rows 0–",))


def block_twice(sheet, rng):
    first, last = _block(rng, len(sheet.cells), 20, 800)
    again = sheet.cells[first:last].copy()
    again[:, 0] += sheet.cells[-1, 0] - again[0, 0] + rng.integers(1, 100)
    frames = len(sheet.cells)
    sheet.cells = np.concatenate([sheet.cells, again])
    return Planted(("copied rows",), (frames, frames + last - first - 1), (f"rows {first}–",))


def time_divided(sheet, rng):
    sheet.cells[:, 0] = (sheet.cells[:, 0] - sheet.cells[0, 0]) / 10.0 ** rng.integers(3, 7)
    return Planted((), None, errors=("frames a second",))


def counts_divided(sheet, rng):
    factor = float(rng.choice([1e2, 1e3, 1e4, 0.1, 1e-2, 1e-3]))
    part = slice(FIRST, FIRST + CHANNELS)
    if rng.random() < 0.3:
        part = FIRST + int(rng.integers(CHANNELS))
        while sheet.header[part] in ("F4-X3", "F4-Y3", "F4-Z3", "F2-X1", "F2-Y1", "F2-Z1"):
            part += 1
    sheet.cells[:, part] /= factor
    rows = (0, len(sheet.cells) - 1)
    return Planted(("counts of another unit",), rows, errors=("raw counts",))


def cell_in_grams(sheet, rng):
    factor = float(rng.choice([9.8, 1 / 9.8, 101.97, 1 / 101.97, 1e3, 1e-3]))
    cell = 1 + int(rng.integers(2))
    sheet.cells[:, cell] *= factor
    larger = cell if factor > 1 else 3 - cell
    return Planted(
        ("forces of another unit",), None, (f"cell {larger} shows",), ("not in g", "holds no press")
    )


KINDS = (
    all_constant,
    all_standing,
    chip_constant,
    chip_silent_at_times,
    channel_frozen,
    axes_at_zero,
    channel_clipped,
    wrong_force,
    file_twice,
    block_twice,
    time_divided,
    counts_divided,
    cell_in_grams,
)


def named(path, planted):
    """Whether the report of a file (or the error that refuses it) names what was planted, and the
    recording, or the text of the error."""
    try:
        recording = read_recording(path)
    except RecordingError as error:
        return any(text in str(error) for text in planted.errors), str(error)
    return any(_names(fault, planted) for fault in recording.report.faults), recording


def _names(fault, planted):
    if fault.kind not in planted.kinds:
        return False
    if not all(word in f"{fault.where} {fault.detail}" for word in planted.words):
        return False
    if planted.rows is None:
        return True
    first, last = map(int, re.search(r"rows (\d+)–(\d+)", fault.where).groups())
    return abs(first - planted.rows[0]) <= SLACK and abs(last - planted.rows[1]) <= SLACK

"""Readings and places that cannot be: counts beyond the chip's range or wrapped, places off the body."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Bool, Float

from design.errors import RecordingError
from estimator.recordings.boards.lines import END_COUNTS, WRAP_COUNTS
from estimator.recordings.checks.faults import Fault, rows_text
from estimator.recordings.table import RawTable, channel_name

_CONVERTER_COUNTS = 32768.0
"""Magnitude that no converter of 16 bits with a sign exceeds."""
_FEW_READINGS = 0.05
"""Share of a channel's readings that may be out of range; more, and the recording is refused."""
_FAR_FACTOR = 3.0
"""Farthest place over the grid's reach, where no specification says it."""


@dataclass(frozen=True)
class Limits:
    """Limits of what an object can show: largest count of its chips, farthest place (mm) on any of its
    faces."""

    largest_count: float
    farthest_mm: float


def usual_limits(table: RawTable) -> Limits:
    """Limits where no specification gives them: a chip of 16 bits, three times the grid's reach."""
    reach_mm = max(np.abs(table.grid_x_mm).max(), np.abs(table.grid_y_mm).max())
    return Limits(_CONVERTER_COUNTS, _FAR_FACTOR * float(reach_mm))


def limit_to_range(table: RawTable, limits: Limits) -> tuple[RawTable, list[Fault]]:
    """The table without readings beyond the chip's range (NaN), and what was found.

    Raises
    ------
    RecordingError
        A channel has more than 5 % of its readings there: another chip, or another unit.
    """
    with np.errstate(invalid="ignore"):
        beyond = np.abs(table.counts) > limits.largest_count
    faults = []
    for index in np.argwhere(beyond.any(axis=0)).tolist():
        column = (slice(None), *index)
        rows = np.flatnonzero(beyond[column])
        largest = np.abs(table.counts[column][rows]).max()
        reading_count = int(np.isfinite(table.counts[column]).sum())
        name = channel_name(*index)
        if len(rows) > max(1, _FEW_READINGS * reading_count):
            raise RecordingError(
                f"{name} reaches {largest:.0f} counts, beyond ±{limits.largest_count:.0f}, in "
                f"{len(rows)} of {reading_count} readings. Give raw counts of a chip of at most 16 bits "
                "(signed), and with --spec the specification of the object that was recorded"
            )
        detail = f"{len(rows)} readings up to {largest:.0f}, beyond ±{limits.largest_count:.0f}"
        where = f"{name}, {rows_text(rows)}"
        faults.append(Fault("count beyond the chip's range", where, detail, "readings set to NaN"))
    return replace(table, counts=np.where(beyond, np.nan, table.counts)), faults


def without_wrapped(table: RawTable) -> tuple[RawTable, list[Fault]]:
    """The table without readings that left their range by one end and came in by the other (NaN), until
    they went back; and what was found."""
    counts, faults = table.counts.copy(), []
    for index in np.ndindex(counts.shape[1:]):
        column = counts[:, *index]
        live = np.flatnonzero(np.isfinite(column))
        readings = column[live]
        step = np.diff(readings, prepend=readings[:1])
        # Chips of more bits have no end there.
        sixteen = np.abs(readings).max(initial=0) <= END_COUNTS
        turns = np.cumsum(sixteen * ((step < -WRAP_COUNTS) * 1 - (step > WRAP_COUNTS)))
        # Most readings are within the range, also where the first is not.
        rows = live[turns != np.median(turns)] if len(turns) else live
        if len(rows):
            column[rows] = np.nan
            where = f"{channel_name(*index)}, {rows_text(rows)}"
            detail = f"{len(rows)} readings beyond the chip's range; choose a wider range"
            faults.append(Fault("counts wrapped round", where, detail, "readings set to NaN"))
    return replace(table, counts=counts), faults


def places_off_the_body(
    tip_xy_mm: Float[np.ndarray, "frame cell tip 2"], limits: Limits
) -> tuple[Bool[np.ndarray, "frame"], list[Fault]]:
    """Frames labelled with a place that lies on no face, one fault per place."""
    with np.errstate(invalid="ignore"):
        far = np.asarray((np.abs(tip_xy_mm) > limits.farthest_mm).any(axis=3))
    faults = []
    for x, y in np.unique(tip_xy_mm[far], axis=0):
        rows = np.flatnonzero((tip_xy_mm == [x, y]).all(axis=3).any(axis=(1, 2)))
        detail = f"({x:g}, {y:g}) mm lies beyond ±{limits.farthest_mm:g} mm"
        faults.append(
            Fault(
                "place off the body",
                rows_text(rows),
                detail,
                "frames not used (with --spec the object's size counts, else three times the grid's reach)",
            )
        )
    return np.asarray(far.any(axis=(1, 2))), faults

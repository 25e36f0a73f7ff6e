"""Readings and places that cannot be: counts beyond the chip's range or wrapped, places off the body."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Bool, Float

from design.errors import RecordingError
from estimator.recordings.boards.lines import (
    END_COUNTS,
    TURN_COUNTS,
    WRAP_COUNTS,
    may_undo,
)
from estimator.recordings.checks.faults import Fault, rows_text
from estimator.recordings.presses import runs
from estimator.recordings.table import RawTable, channel_name

_CONVERTER_COUNTS = 32768.0
"""Magnitude that no converter of 16 bits with a sign exceeds."""
_WHOLE_SCALE = 0.9
"""Share of 16 bits from which a chip's scale ends where its counts wrap round."""
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
    if limits.largest_count > _WHOLE_SCALE * _CONVERTER_COUNTS:
        beyond &= ~_continued(table.counts, beyond)
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


def _continued(
    counts: Float[np.ndarray, "frame face sensor 3"],
    beyond: Bool[np.ndarray, "frame face sensor 3"],
) -> Bool[np.ndarray, "frame face sensor 3"]:
    """Return which readings beyond the scale were reached in small steps: wraps that a reader undid."""
    continued = np.zeros_like(beyond)
    for index in np.argwhere(beyond.any(axis=0)).tolist():
        column = (slice(None), *index)
        live = np.flatnonzero(np.isfinite(counts[column]))
        step = np.abs(np.diff(counts[column][live], prepend=counts[column][live[:1]]))
        for first, end in runs(beyond[column][live].astype(int)):
            if beyond[column][live[first]] and (
                step[first : end + 1].max() <= TURN_COUNTS - WRAP_COUNTS and end - first < len(live)
            ):
                continued[(live[first:end], *index)] = True
    return continued


def without_wrapped(table: RawTable, frame_s: float) -> tuple[RawTable, list[Fault]]:
    """Undo turns of readings that left their range by one end and came in by the other, and leave those
    out (NaN) that may have turned otherwise, until they go back; say what was found. `frame_s` is the time
    from row to row."""
    counts, faults = table.counts.copy(), []
    others_step = _median_steps(table.counts)
    for index in np.ndindex(counts.shape[1:]):
        column = counts[:, *index]
        live = np.flatnonzero(np.isfinite(column))
        readings = column[live]
        step = np.diff(readings, prepend=readings[:1])
        # Chips of more bits have no end there.
        sixteen = np.abs(readings).max(initial=0) <= END_COUNTS
        turn = sixteen * ((step < -WRAP_COUNTS) * 1 - (step > WRAP_COUNTS))
        if not turn.any():
            continue
        turns = np.cumsum(turn)
        # Most readings are within the range, also where the first is not.
        turns = turns - int(np.median(turns))
        elapsed_s = frame_s * np.diff(live, prepend=live[:1])
        doubts = [
            k
            for k in np.flatnonzero(turn)
            if not may_undo(float(step[k]), float(elapsed_s[k]), float(others_step[live[k]]))
        ]
        # An excursion lasts from leaving the range until coming back; one doubt spoils all of it.
        excursion = np.cumsum(np.diff((turns != 0).astype(int), prepend=0) != 0)
        doubted = np.isin(excursion, excursion[doubts]) | np.isin(excursion, excursion[doubts] - 1)
        lost, undone = live[(turns != 0) & doubted], (turns != 0) & ~doubted
        column[live[undone]] += TURN_COUNTS * turns[undone]
        column[lost] = np.nan
        for rows, what in ((live[undone], "undone"), (lost, "readings set to NaN")):
            if len(rows):
                where = f"{channel_name(*index)}, {rows_text(rows)}"
                detail = f"{len(rows)} readings beyond the chip's range; choose a wider range"
                faults.append(Fault("counts wrapped round", where, detail, what))
    return replace(table, counts=counts), faults


def _median_steps(counts: Float[np.ndarray, "frame face sensor 3"]) -> Float[np.ndarray, "frame"]:
    """Median change from row to row of the channels that do not jump; 0 in the first row."""
    flat = counts.reshape(len(counts), -1)
    flat = flat[:, np.isfinite(flat).any(axis=0)]
    steps = np.abs(np.diff(flat, axis=0, prepend=flat[:1]))
    steps = np.where(steps <= WRAP_COUNTS, steps, np.nan)
    known = np.isfinite(steps).any(axis=1)
    medians = np.full(len(flat), np.inf)
    medians[known] = np.nanmedian(steps[known], axis=1)
    return medians


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

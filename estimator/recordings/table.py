"""Content of a recording's file in this package's order, before any fault is fixed."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float, Int

from design.errors import RecordingError

LEAST_FACES, MOST_FACES = 5, 6
"""Faces along the axis of counts: the paper's, and face 6 where a channel or a label names it."""
LARGEST_COUNT = 2.0**24
"""Largest count that may be meant: more than any converter gives."""
LARGEST_FORCE_N = 1000.0
"""Largest force that may be meant."""
LARGEST_PLACE_MM = 300.0
"""Farthest place that may be meant."""
_LEAST_FALLS = 3
"""Steps back on end, without a step forward between them, that no clock that was started again makes."""
_SLOWEST_FRAME_S = 5.0
"""Median time between frames from which stamps are taken for another unit."""


@dataclass(frozen=True)
class RawTable:
    """A file's content in face order: 1 to 5, or to 6.

    Attributes
    ----------
    kind : "gripper", "training" or "generic"
    time_s : (frame,) stamps as written; empty where the format has none
    force_n : (frame, cell) one column per load cell, all NaN where travel is the label
    counts : (frame, face, sensor, axis) raw counts, NaN where the file has none
    face : (frame, cell) face that the load cell is said to press, `NO_FACE` where none is said
    tip_xy_mm : (frame, cell, tip, 2) where its tips are said to be, NaN where none is said
    case : (frame,) the training format's case, a generic file's session, 0 in gripper files
    declared_rest : (frame,) frames in which, the file says, nothing touches the object
    grid_x_mm, grid_y_mm : contact grid on which heatmaps will be drawn, mm
    duplicate_columns : header names that occur twice
    digest : SHA-256 of the file, of a generic one that of its content
    shear_n : (frame, cell, 2) tangential force along the x and y of the face that is pressed, N;
        None where the file has none
    travel_mm : (frame,) how far a machine has its tip below the height of first touch, NaN where that
        is not known; None where the file has none
    motion : (frame, 6) acceleration (m/s², specific force) and angular rate (rad/s) of an IMU along the
        object's x, y, z; NaN where it was silent, None where the file has none
    """

    kind: str
    time_s: Float[np.ndarray, "stamp"]
    force_n: Float[np.ndarray, "frame cell"]
    counts: Float[np.ndarray, "frame face sensor 3"]
    face: Int[np.ndarray, "frame cell"]
    tip_xy_mm: Float[np.ndarray, "frame cell tip 2"]
    case: Int[np.ndarray, "frame"]
    declared_rest: Bool[np.ndarray, "frame"]
    grid_x_mm: Float[np.ndarray, "nx"]
    grid_y_mm: Float[np.ndarray, "ny"]
    duplicate_columns: tuple[str, ...]
    digest: str
    shear_n: Float[np.ndarray, "frame cell 2"] | None = None
    travel_mm: Float[np.ndarray, "frame"] | None = None
    motion: Float[np.ndarray, "frame 6"] | None = None

    @property
    def labelled_by_travel(self) -> bool:
        """Return whether travel is the label, for want of a load cell."""
        return self.travel_mm is not None and bool(np.isnan(self.force_n).all())


def faces_of(counts: Float[np.ndarray, "*frame face sensor 3"]) -> Int[np.ndarray, "face"]:
    """Numbers of the faces along the axis of counts."""
    return np.arange(1, counts.shape[-3] + 1)


def with_pressed_faces(
    counts: Float[np.ndarray, "frame face sensor 3"], pressed: Int[np.ndarray, "frame cell"]
) -> Float[np.ndarray, "frame side sensor 3"]:
    """Counts with empty rows for faces that labels name beyond those of the channels."""
    absent = max(0, int(pressed.max(initial=0)) - counts.shape[1])
    return np.pad(counts, ((0, 0), (0, absent), (0, 0), (0, 0)), constant_values=np.nan)


def channel_name(face: int, sensor: int, axis: int) -> str:
    """Name as in the recordings' header, for example F2-Y1 (indices counted from 0)."""
    return f"F{face + 1}-{'XYZ'[axis]}{sensor + 1}"


def channels_text(channels: list[tuple[int, ...]], live: Bool[np.ndarray, "face sensor 3"]) -> str:
    """Several channels in a few words: all, whole chips (F2-S1), or names, four at most."""
    if len(channels) >= live.sum():
        return f"all {len(channels)} channels"
    chips = {channel[:2] for channel in channels}
    whole = [chip for chip in sorted(chips) if all((*chip, axis) in channels for axis in range(3))]
    names = [f"F{face + 1}-S{sensor + 1}" for face, sensor in whole]
    names += [channel_name(*index) for index in sorted(channels) if index[:2] not in whole]
    others = f" and {len(names) - 4} others" if len(names) > 4 else ""
    return ", ".join(names[:4]) + others


def check_plausible(table: RawTable) -> None:
    """Refuse values that can only come from another unit or from damage.

    Raises
    ------
    RecordingError
        Counts beyond 24 bits, forces beyond 1 kN, places beyond 300 mm (or all of a load cell within 0.1 mm
        of the middle but not in it), or stamps that fall in most steps, fall on end without a rise between
        (rows in reverse order) or between two steps of twice the usual (two rows exchanged), or are 5 s
        or more apart.
    """
    check_signals(table.time_s, table.counts)
    check_forces(table.force_n)
    if table.shear_n is not None:
        _check_below("shear forces (N)", table.shear_n, LARGEST_FORCE_N, "forces in N")
    _check_below("places (mm)", table.tip_xy_mm, LARGEST_PLACE_MM, "places in mm")
    for cell in range(table.tip_xy_mm.shape[1]):
        largest_mm = float(np.max(np.abs(np.nan_to_num(table.tip_xy_mm[:, cell])), initial=0.0))
        if 0 < largest_mm < 0.1:
            raise RecordingError(
                f"every place of load cell {cell + 1} lies within {largest_mm:g} mm of its face's middle. "
                "Give places in mm, not in m"
            )


def check_signals(
    time_s: Float[np.ndarray, "stamp"], counts: Float[np.ndarray, "frame face sensor 3"]
) -> None:
    """Refuse counts and stamps as `check_plausible` does.

    Raises
    ------
    RecordingError
        As there.
    """
    _check_below("counts", counts, LARGEST_COUNT, "raw counts of the sensors")
    if len(time_s) and np.abs(time_s).max() > 1e11:
        raise RecordingError(
            f"time stamps reach {np.abs(time_s).max():.3g} s. Give seconds, not ms"
        )
    _check_order(time_s)
    step_s = float(np.median(np.diff(time_s))) if len(time_s) > 2 else 0.0
    if step_s >= _SLOWEST_FRAME_S:
        raise RecordingError(
            f"frames are {step_s:g} s apart (median). Give time stamps in s, not in ms"
        )


def _check_order(time_s: Float[np.ndarray, "stamp"]) -> None:
    """A clock that starts again falls once and rises again; rows in reverse order fall on end, in whole
    seconds with equal stamps between the falls."""
    step = np.diff(time_s)
    falling = int(np.sum(step < 0))
    if 2 * falling > len(time_s):
        raise RecordingError(
            f"time runs backwards from row to row in {falling} of {len(step)} steps. Sort the rows by time"
        )
    changed = np.flatnonzero(step)
    edges = np.flatnonzero(np.diff(step[changed] < 0, prepend=False, append=False))
    for first, end in edges.reshape(-1, 2):
        if end - first >= _LEAST_FALLS:
            raise RecordingError(
                f"time runs backwards from data row {changed[first] + 1} to {changed[end - 1] + 2}, in "
                f"{end - first} steps on end: these rows are in reverse order. Sort the rows by time"
            )
    exchanged = _exchanged(step)
    if len(exchanged):
        first = exchanged[0] + 1
        raise RecordingError(
            f"{len(exchanged)} pair{'s' * (len(exchanged) > 1)} of rows exchanged places by their time "
            f"stamps, first data rows {first} and {first + 1}. Sort the rows by time"
        )


def _exchanged(step: Float[np.ndarray, "step"]) -> Int[np.ndarray, "pair"]:
    """The first of two neighbouring rows that exchanged places: time falls between two steps of twice
    the usual, to no less than the row before has. A clock that is set back makes no such steps."""
    if len(step) < 2:
        return np.zeros(0, int)
    step_before, step_after = np.r_[np.inf, step[:-1]], np.r_[step[1:], np.inf]
    long = np.minimum(step_before, step_after) > 1.5 * max(0.0, float(np.median(step)))
    return np.flatnonzero((step < 0) & long & (step_before + step >= 0) & (step + step_after >= 0))


def check_forces(force_n: Float[np.ndarray, "frame cell"]) -> None:
    """Refuse forces that many readings put beyond 1 kN; single ones are `checks.cells.wrong_forces`.

    Raises
    ------
    RecordingError
        More than a tenth of a load cell's readings.
    """
    if np.isinf(force_n).any():
        raise RecordingError("forces (N) are infinite in some rows. Give forces in N there")
    # an empty file has no quantile
    often = np.quantile(np.abs(force_n), 0.9, axis=0, method="lower") if len(force_n) else force_n
    _check_below("forces (N)", often, LARGEST_FORCE_N, "forces in N, not in g or mN")


def _check_below(what: str, values: np.ndarray, limit: float, right: str) -> None:
    largest = np.max(np.abs(values), where=~np.isnan(values), initial=0.0)
    if largest > limit:
        raise RecordingError(
            f"{what} reach {largest:.4g}, more than {limit:g}. Give {right}, and fix damaged cells"
        )

"""Load cells and clocks that cannot be right: single wrong readings, and rates."""

from __future__ import annotations

import numpy as np
from jaxtyping import Bool, Float

from design.errors import RecordingError
from estimator.recordings.checks.faults import Fault, rows_text

_BESIDE = 3
"""Rows on each side that a reading is held against; one wrong one among them counts for nothing."""
_STEEP = 2.0
"""Times the range of its neighbours beyond which a reading leaves them."""
_LEAST_JUMP_N = 0.5
"""Jump that counts, at least."""
_JUMP_SHARE = 0.05
"""Share of the usual range of a cell: readings of the public recordings leave their neighbours by 0.1 % at
most."""
_JUMP_SIGMAS = 10.0
"""Jump that counts, over the noise."""
_ROUNDS = 4
"""Rounds in which jumps are sought, at most."""
_WHOLE_CELL = 0.3
"""Share of wrong readings above which they are no fault of single rows."""
LARGEST_RATE_HZ = 2000.0
"""Frames a second: a bus of Hall sensors gives some 500 at most."""


def wrong_forces(
    force_n: Float[np.ndarray, "frame cell"],
) -> tuple[Bool[np.ndarray, "frame cell"], list[Fault]]:
    """Readings of one or two rows that leave their neighbours by what no press does, and come back.

    Converters of load cells give them when a bit is lost: 2^k − 1, full scale, 0 (HX711: 1 to 5 % on some
    boards).
    """
    wrong, faults = np.zeros(force_n.shape, bool), []
    for cell in range(force_n.shape[1]):
        for _ in range(_ROUNDS):
            kept = np.where(wrong[:, cell], np.nan, force_n[:, cell])
            low, high = _usual_range(kept)
            apart = np.maximum(low - force_n[:, cell], force_n[:, cell] - high)
            # a quick tap is as high as it is steep; a lost bit is not
            limit = np.maximum(_least_jump_n(kept), _STEEP * (high - low))
            now = wrong[:, cell] | (apart > limit)
            if np.array_equal(now, wrong[:, cell]):
                break
            wrong[:, cell] = now
        rows = np.flatnonzero(wrong[:, cell])
        # a cell that jumps all the time is not read wrongly now and then: other checks judge it
        if not 0 < len(rows) <= _WHOLE_CELL * len(force_n):
            wrong[:, cell] = False
            continue
        values = force_n[rows, cell]
        detail = (
            f"cell {cell + 1} jumps for single rows to {_range_text(values)} N and back, {len(rows)} times "
            "in all: lost bits of its converter, not presses"
        )
        faults.append(Fault("wrong force readings", rows_text(rows), detail, "no labels there"))
    return wrong, faults


def _range_text(values: Float[np.ndarray, "n"]) -> str:
    low, high = values.min(), values.max()
    return f"{low:.4g}" if low == high else f"{low:.4g} … {high:.4g}"


def _usual_range(
    force_n: Float[np.ndarray, "frame"],
) -> tuple[Float[np.ndarray, "frame"], Float[np.ndarray, "frame"]]:
    """Lowest and highest of the rows around each, itself and the extremes of them left out."""
    padded = np.pad(force_n, _BESIDE, constant_values=np.nan)
    around = np.lib.stride_tricks.sliding_window_view(padded, 2 * _BESIDE + 1)
    beside = np.sort(np.delete(around, _BESIDE, axis=1), axis=1)  # NaN last
    number = np.isfinite(beside).sum(axis=1)
    rows, cut = np.arange(len(beside)), (number > 3).astype(int)
    low, high = beside[rows, cut], beside[rows, np.maximum(number - 1 - cut, 0)]
    return np.where(number > 0, low, -np.inf), np.where(number > 0, high, np.inf)


def _least_jump_n(kept_n: Float[np.ndarray, "frame"]) -> float:
    """Return the largest jump (N) beyond its neighbours' range that noise alone makes."""
    finite_n = kept_n[np.isfinite(kept_n)]
    if len(finite_n) < 2:
        return np.inf
    span_n = float(np.ptp(np.percentile(finite_n, [2, 98])))
    # 0.954: the median of |a - b| of two normal numbers to their standard deviation
    noise_n = float(np.median(np.abs(np.diff(finite_n)))) / 0.954
    return max(_LEAST_JUMP_N, _JUMP_SHARE * span_n, _JUMP_SIGMAS * noise_n)


def repaired_forces(
    force_n: Float[np.ndarray, "frame cell"], wrong: Bool[np.ndarray, "frame cell"]
) -> Float[np.ndarray, "frame cell"]:
    """Forces with wrong readings on the line between their neighbours: presses show, labels do not."""
    repaired, rows = force_n.copy(), np.arange(len(force_n))
    for cell in np.flatnonzero(wrong.any(axis=0)):
        bad = wrong[:, cell]
        repaired[bad, cell] = np.interp(rows[bad], rows[~bad], force_n[~bad, cell])
    return repaired


def check_rate(rate_hz: float) -> None:
    """Refuse stamps that tell more frames a second than sensors give.

    Raises
    ------
    RecordingError
        Above 2000 frames a second.
    """
    if rate_hz > LARGEST_RATE_HZ:
        raise RecordingError(
            f"its stamps tell {rate_hz:.0f} frames a second in all rows, sensors give "
            f"{LARGEST_RATE_HZ:g} at most: the time was divided, perhaps by 1000. Give time in s"
        )

"""Readings logged faster than the sensors convert: whole chips repeat their last reading exactly.

By chance a chip repeats all its axes now and then, the more the less noise it has, and a still one
without noise does so through whole rests. A clock shows otherwise: the number of repeats in windows of
equal length is then nearly the same, where chance makes it vary as a binomial number does, and rests
between presses more than that.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float

from estimator.recordings.checks.faults import Fault
from estimator.recordings.table import channel_name

_LEAST_SHARE = 0.1
"""Share of repeated readings, at least."""
_LEAST_WINDOWS = 10
"""Windows over which their variance is taken, at least."""
_WINDOW_ROWS = 20
"""Rows of a window, at least."""
_CLOCKED = 0.3
"""Variance over that of a binomial number below which repeats are no chance: windows of 20 rows of a
clock that is 10 % slower have 0.14, ten windows of chance stay below 0.3 once in forty sensors."""


@dataclass(frozen=True)
class Repeats:
    """Readings that are no new ones.

    Attributes
    ----------
    stale : (frame, face, sensor) the sensor is slower than the logger and repeats its last reading
    share : (face, sensor) of readings that do, 0 where the sensor is not slower, NaN where it gives none
    rows : (frame,) rows without any new reading, where all sensors convert together
    """

    stale: Bool[np.ndarray, "frame face sensor"]
    share: Float[np.ndarray, "face sensor"]
    rows: Bool[np.ndarray, "frame"]


def repeated_readings(counts: Float[np.ndarray, "frame face sensor 3"]) -> Repeats:
    """Return which readings repeat the one before because their sensor had not converted yet.

    Sensors that convert together show it in whole rows, however quiet they are; others one by one.
    """
    is_finite = np.isfinite(counts)
    alike = (counts[1:] == counts[:-1]) | ~(is_finite[1:] | is_finite[:-1])
    has_reading = np.asarray(is_finite.any(axis=3))
    repeated = np.zeros(has_reading.shape, dtype=bool)
    repeated[1:] = np.all(alike, axis=3) & has_reading[1:]
    moving = np.any((counts[1:] != counts[:-1]) & is_finite[1:] & is_finite[:-1], axis=(0, 3))
    rows = np.all(repeated | ~moving | ~has_reading, axis=(1, 2)) & np.any(
        repeated & moving, axis=(1, 2)
    )
    share = np.where(moving, 0.0, np.nan)
    if _clocked(rows):
        share[moving] = rows.mean()
        return Repeats(rows[:, None, None] & moving, share, rows)
    for face, sensor in np.argwhere(moving).tolist():
        sensor_repeats = repeated[has_reading[:, face, sensor], face, sensor]
        share[face, sensor] = sensor_repeats.mean() if _clocked(sensor_repeats) else 0.0
    return Repeats(repeated & (share > 0), share, np.zeros(len(counts), dtype=bool))


def _clocked(repeated: Bool[np.ndarray, "reading"]) -> bool:
    """Return whether a sensor's readings repeat by a slower clock."""
    share = float(np.mean(repeated)) if len(repeated) else 0.0
    if not _LEAST_SHARE <= share < 1:
        return False
    width = max(_WINDOW_ROWS, int(5 / (1 - share)))
    windows = len(repeated) // width
    if windows < _LEAST_WINDOWS:
        return False
    in_each = repeated[: windows * width].reshape(windows, width).sum(axis=1)
    return bool(np.var(in_each, ddof=1) < _CLOCKED * width * share * (1 - share))


def repeat_faults(repeats: Repeats, rate_hz: float) -> list[Fault]:
    """Sensors slower than the logger, together, with their true rate and what it means."""
    share = repeats.share[repeats.share > 0]
    if not len(share):
        return []
    sensor_count = int(np.sum(np.isfinite(repeats.share)))
    names = ", ".join(
        channel_name(face, sensor, 0).replace("-X", "-S")
        for face, sensor in np.argwhere(repeats.share > 0).tolist()
    )
    where = f"all {sensor_count} sensors" if len(share) == sensor_count else names
    new = 1 - float(np.median(share))
    detail = (
        f"{100 * (1 - new):.0f} % of their readings repeat the one before exactly: they convert "
        f"{new * rate_hz:.3g} times a second, logged {rate_hz:.3g} times"
    )
    action = (
        f"noise told from new readings alone (from all rows {new**-0.5:.2g} times too small); a mean of n "
        f"rows averages n/{1 / new:.2g} readings; repeated rows "
    )
    used = "not used" if repeats.rows.any() else "kept, for the sensors convert at different times"
    return [Fault("slow sensors", where, detail, action + used)]

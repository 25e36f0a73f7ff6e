"""False alarms and misses of contact, at a threshold on the largest pixel.

The threshold of Knopke et al. (RA-L 2024), 0.9 times the data set's smallest contact force, says
nothing about how noisy an estimator is at rest; one fixed on validation frames does.
"""

from __future__ import annotations

from dataclasses import asdict, dataclass

import numpy as np
from jaxtyping import Bool, Float

from design.errors import InputError

WANTED_RATE = 0.01


@dataclass(frozen=True)
class FalseAlarms:
    """Alarms at a threshold: share of rest frames above it, share of contact frames below it, and
    the weakest total force (N) of which 95 % of the frames are noticed (NaN where none is)."""

    threshold_n: float
    false_alarm_rate: float
    miss_rate: float
    noticed_from_n: float

    def summary(self) -> dict[str, float | None]:
        """Ready for JSON, None where undefined."""
        return {name: None if value != value else value for name, value in asdict(self).items()}


def fixed_threshold_n(
    predicted_n: Float[np.ndarray, "frame nx ny"],
    rest: Bool[np.ndarray, "frame"],
    rate: float = WANTED_RATE,
) -> float:
    """Threshold above which at most `rate` of the (validation) rest frames have their largest pixel.

    Raises
    ------
    InputError
        Fewer rest frames than one alarm at that rate needs.
    """
    largest = np.sort(predicted_n[rest].max(axis=(1, 2)))
    allowed = int(rate * len(largest))
    if allowed < 1:
        raise InputError(
            f"a false-alarm rate of {rate:g} needs at least {int(np.ceil(1 / rate))} rest frames for "
            f"its threshold; got {len(largest)}. Give more validation frames without contact"
        )
    return float(largest[-1 - allowed])


def false_alarms(
    predicted_n: Float[np.ndarray, "frame nx ny"],
    true_n: Float[np.ndarray, "frame nx ny"],
    rest: Bool[np.ndarray, "frame"],
    threshold_n: float,
) -> FalseAlarms:
    """Alarms in (test) frames; frames neither at rest nor with contact count for neither rate."""
    alarm = predicted_n.max(axis=(1, 2)) > threshold_n
    contact = true_n.max(axis=(1, 2)) > 0
    return FalseAlarms(
        threshold_n,
        _mean(alarm[rest & ~contact]),
        _mean(~alarm[contact]),
        noticed_from(true_n.sum(axis=(1, 2))[contact], alarm[contact]),
    )


def noticed_from(force_n: np.ndarray, alarm: np.ndarray, share: float = 0.95) -> float:
    """Smallest force such that of all frames at least as strong `share` raise the alarm."""
    order = np.argsort(-force_n)
    running = np.cumsum(alarm[order]) / np.arange(1, len(order) + 1)
    good = np.flatnonzero(running >= share)
    return float(force_n[order[good[-1]]]) if len(good) else float("nan")


def _mean(values: np.ndarray) -> float:
    return float(values.mean()) if len(values) else float("nan")

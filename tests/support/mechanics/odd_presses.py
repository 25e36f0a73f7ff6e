"""A cube off its symmetries, and analytic presses of it."""

from functools import cache

from estimator.signals.presses import Signals, press_signals
from tests.support.mechanics.synthetic_presses import coarse_spec, synthetic_presses

SPEC = coarse_spec(
    seed=4,
    contact_grid={"count": (4, 5), "pitch_mm": 3.0},
    magnets={
        "positions_mm": [[3.0, -6.0], [-7.0, 2.0], [5.0, 5.5]],
        "north": ["outward", "inward", "outward"],
        "tilt_deg": [[0.0, 0.0], [6.0, -4.0], [0.0, 8.0]],
    },
    sensors={
        "positions_mm": [[4.5, 3.5], [-6.0, 1.0], [2.0, -5.5]],
        "noise_counts": [20.0, 25.0, 12.0],
    },
    score={"force_n": 8.0},
)


@cache
def presses():
    """Forces and motions."""
    return synthetic_presses(SPEC)


@cache
def signals() -> Signals:
    """Signals of the presses."""
    return press_signals(SPEC, *presses())

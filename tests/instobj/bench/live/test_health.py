"""Health of channels: each fault is seen where it is planted, and nowhere else."""

import numpy as np
import pytest

from design.spec.object import ObjectSpec
from estimator.inversion.condition import FINE, object_condition
from instobj.bench.live.health import (
    ABSENT,
    DEAD,
    DRIFTING,
    GOOD,
    NOISY,
    SATURATED,
    SILENT,
    HealthLimits,
    channel_condition,
    channel_health,
    health_limits,
    whole_condition,
)

LIMITS = HealthLimits(np.array([22.0, 22.0, 11.0] * 3), 32_000.0, 67.0)
LIVE = np.ones(9, bool)
HERE = 4


def readings(seed, frames=400, press=0.0):
    """White noise about resting levels, and a press on all channels: up, held, down."""
    rng = np.random.default_rng(seed)
    shape = np.clip(np.minimum(np.arange(frames) - 60, 260 - np.arange(frames)) / 100, 0, 1)
    level = rng.uniform(-3000, 3000, 9)
    return np.round(
        level + press * shape[:, None] + LIMITS.noise_counts * rng.normal(size=(frames, 9))
    )


def spoiled(raw, fault):
    """One channel with a fault, and what is known of its drift."""
    raw, drift = raw.copy(), np.zeros(9)
    if fault == SILENT:
        raw[-30:, HERE] = np.nan
    elif fault == SATURATED:
        raw[-5:, HERE] = 31_990
    elif fault == DEAD:
        raw[-60:, HERE] = raw[-60, HERE]
    elif fault == NOISY:
        raw[:, HERE] += 100 * np.random.default_rng(9).normal(size=len(raw))
    elif fault == DRIFTING:
        drift[HERE] = -90.0
    return raw, drift


@pytest.mark.parametrize("fault", [SILENT, SATURATED, DEAD, NOISY, DRIFTING])
@pytest.mark.parametrize("press", [0.0, 8000.0])
def test_a_planted_fault_is_named_and_its_neighbours_are_good(fault, press):
    for seed in range(5):
        raw, drift = spoiled(readings(seed, press=press), fault)
        expected = [GOOD] * 9
        expected[HERE] = fault
        assert channel_health(raw, LIVE, drift, LIMITS) == expected


def test_sound_channels_stay_good_from_the_first_frame_on():
    for seed in range(30):
        raw = readings(seed, press=5000.0)
        for frames in (1, 5, 49, 50, 51, 137, 400):
            assert channel_health(raw[:frames], LIVE, np.zeros(9), LIMITS) == [GOOD] * 9


def test_a_channel_that_the_board_has_not_is_absent_and_not_silent():
    raw = readings(1)
    raw[:, HERE] = np.nan
    live = LIVE.copy()
    live[HERE] = False
    assert channel_health(raw, live, None, LIMITS)[HERE] == ABSENT


def test_quiet_chips_may_stand_still():
    quiet = HealthLimits(np.full(9, 0.2), 32_000.0, 67.0)
    assert channel_health(np.full((400, 9), 5.0), LIVE, None, quiet) == [GOOD] * 9


def test_limits_are_those_of_the_chips():
    spec = ObjectSpec(name="cube")
    limits = health_limits(spec)
    assert limits.noise_counts.tolist() == [22.0, 22.0, 11.0] * 15
    assert limits.full_scale_counts == 40.0 * 820.0
    assert limits.drift_counts == pytest.approx((30**2 + 60**2) ** 0.5)


def test_the_whole_asks_for_what_most_work_is():
    """One dead chip is left out, two are replaced; what is read counts where it asks for more."""
    names = ["F1-X1", "F1-Y1", "F1-X2"]
    slipped = object_condition(0.0, slip_mm=0.1)
    assert whole_condition(FINE, [GOOD, ABSENT, GOOD], names) == FINE
    assert whole_condition(FINE, [DEAD, DEAD, GOOD], names).name == "fine"
    assert whole_condition(FINE, [GOOD, DRIFTING, GOOD], names).name == "zero again"
    assert whole_condition(slipped, [GOOD, DRIFTING, GOOD], names) == slipped
    two = whole_condition(slipped, [GOOD, SATURATED, DEAD], names)
    assert two.name == "recast"
    assert "F1-1 and F1-2" in two.why
    assert [channel_condition(state) for state in (GOOD, DRIFTING, DEAD)] == [
        "fine",
        "zero again",
        "recast",
    ]

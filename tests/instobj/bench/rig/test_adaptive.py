"""Errors of one press as the adaptive order assumes them, against sessions drawn at random."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.spec.object import ObjectSpec
from estimator.calibration.twin.pressed_places import drift_rate
from estimator.recordings.drift import levels_under_presses
from instobj.bench.rig.adaptive import errors_of
from instobj.bench.rig.plan import PressSettings, settings_of_few, stops_of

SPEC, PRESSES, SENSORS = ObjectSpec(name="cube"), 5, 30


def force_on(settings, rate_hz):
    """Whether the tip touches, frame by frame, over some presses."""
    stroke_s = settings.loaded_s / settings.strokes
    pause_s = settings.pause_s + settings.lift_mm / settings.stroke_speed_mm_s
    between_s = settings.clear_s - (settings.strokes - 1) * pause_s
    one = [(between_s, False)]
    for stroke in range(settings.strokes):
        one += [(pause_s, False)] * (stroke > 0) + [(stroke_s, True)]
    ways = [*one * PRESSES, (between_s, False)]
    ends = np.cumsum([seconds for seconds, _ in ways])
    frames = np.arange(0, ends[-1] - 1e-9, 1 / rate_hz)
    return frames, np.array([touched for _, touched in ways])[
        np.searchsorted(ends, frames, "right")
    ]


@pytest.mark.parametrize("few", [False, True])
def test_levels_under_presses_are_as_uncertain_as_in_a_simulated_session(few):
    settings = PressSettings(**settings_of_few(SPEC)) if few else PressSettings(stops_of(SPEC))
    time_s, loaded = force_on(settings, SPEC.sensors.frame_rate_hz)
    rng = np.random.default_rng(3)
    shape = (len(time_s), 5, SENSORS, 3)
    noise = np.array(SPEC.sensors.noise_counts)
    steps = np.sqrt(drift_rate(SPEC) / SPEC.sensors.frame_rate_hz) * rng.standard_normal(shape)
    drift = np.cumsum(steps, axis=0)
    levels = levels_under_presses(
        drift + noise * rng.standard_normal(shape), time_s, np.zeros(len(time_s), int), loaded,
        ~loaded, np.tile(noise, (5, SENSORS, 1)),
    )  # fmt: skip
    start = np.diff(loaded.astype(int), prepend=0) > 0
    press = (np.cumsum(start) - 1) // settings.strokes
    wrong = levels.counts - drift
    means = [wrong[loaded & (press == k)].mean(axis=0) for k in range(PRESSES)]
    assert_allclose(errors_of(SPEC, settings).zero_counts2, np.mean(np.square(means)), rtol=0.35)


def test_frames_under_load_are_those_of_the_plan():
    settings = PressSettings(**settings_of_few(SPEC))
    assert_allclose(settings.loaded_s + settings.clear_s, settings.seconds)
    loaded = force_on(settings, SPEC.sensors.frame_rate_hz)[1]
    assert_allclose(2 * errors_of(SPEC, settings).frames, loaded.sum() / PRESSES, rtol=0.02)
    assert_allclose(settings.loaded_s, 3.0 + 8 * 1.5 + 9 * 0.8)
    once = PressSettings((1.0, 2.0))
    assert_allclose(once.loaded_s, 2 * 2.0 + 2 * 0.5)
    assert_allclose(once.clear_s, 2.0 + 1.5 + 2 * 1.0)

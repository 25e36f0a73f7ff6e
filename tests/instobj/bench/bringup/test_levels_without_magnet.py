"""Means of recordings, and levels without a magnet between two still ones, by hand."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.spec.object import ObjectSpec
from estimator.signals.hall import full_scale_counts
from instobj.bench.bringup import verdict
from instobj.bench.bringup.asking.asked import STILL, STILL_AGAIN, Recording

SPEC = ObjectSpec(name="cube")


def recording(name, level, at_ms, frames=4):
    """Frames 2 ms apart about a time, whose counts spread by ±1 about a level."""
    aside = np.arange(frames) - (frames - 1) / 2
    counts = level + np.resize([1.0, -1.0], frames)[:, None, None] + np.zeros((frames, 15, 3))
    return Recording(name, counts, np.arange(frames), (at_ms + 2 * aside).astype(int))


def levels(holds, again=True):
    recordings = {STILL: recording(STILL, 100.0, 1000, frames=8)}
    if again:
        recordings[STILL_AGAIN] = recording(STILL_AGAIN, 180.0, 9000, frames=16)
    given = [recording(f"hold {k}", 0.0, at) for k, at in enumerate(holds)]
    return verdict.levels_without_magnet(SPEC, recordings, given)


def test_between_two_still_recordings_levels_are_linear_in_time():
    found, drift, noise = levels([3000, 7000])
    assert_allclose(found[0], 120)
    assert_allclose(found[1], 160)
    assert drift == pytest.approx(0.3 * SPEC.sensors.zeroing_counts)
    assert_allclose(noise, [1 / 4 + 0.75**2 / 8 + 0.25**2 / 16, 1 / 4 + 0.25**2 / 8 + 0.75**2 / 16])


@pytest.mark.parametrize(
    ("holds", "again"),
    [([3000, 7000], False), ([500, 7000], True), ([3000, 9500], True), ([1000, 7000], True)],
)
def test_without_a_still_recording_on_both_sides_the_first_one_s_levels_stand(holds, again):
    found, drift, noise = levels(holds, again)
    assert_allclose(found, 100)
    assert drift == SPEC.sensors.zeroing_counts
    assert_allclose(noise, 1 / 4 + 1 / 8)


def test_a_mean_needs_nine_frames_in_ten_and_none_at_full_scale():
    made = recording("a", 50.0, 100, frames=20)
    made.counts[:1, 0, 0] = np.nan
    made.counts[:2, 1, 0] = np.nan
    made.counts[7, 2, 0] = full_scale_counts(SPEC.sensors)
    made.counts[7, 3, 0] = -full_scale_counts(SPEC.sensors)
    made.counts[7, 4, 0] = full_scale_counts(SPEC.sensors) - 1
    assert_allclose(made.mean[0, 0], 50 - 1 / 19)
    assert np.isnan(made.mean[1, 0])
    whole = made.unsaturated(SPEC)
    assert np.isnan(whole[[1, 2, 3], 0]).all()
    assert np.isfinite(whole[4, 0])
    assert_allclose(whole[5], 50)


def test_channels_that_are_mute_or_stuck_are_silent():
    made = recording(STILL, 50.0, 100)
    made.counts[:, 0, 1] = np.nan
    made.counts[:, 1, 2] = 7.0
    silent = verdict.silent_findings({STILL: made})
    assert np.argwhere(silent).tolist() == [[0, 1], [1, 2]]

"""Drift of simulated cases and grids of places, by hand."""

import numpy as np
import pytest

from design.spec.object import ObjectSpec
from estimator.frames.collection_recipe import drift_rms_counts
from estimator.frames.same_object import same_grid


def test_a_case_s_drift_is_the_rms_of_a_walk_from_its_zeroing():
    """A walk of 30 counts in 900 s, its mean square over 90 s taken frame by frame."""
    spec = ObjectSpec(
        name="cube",
        sensors={"drift_counts": 30.0, "frame_rate_hz": 10.0},
        collection={"frames_per_case": 900},
    )
    variance = 30.0**2 * np.arange(0.05, 90.0, 0.1) / 900.0
    assert drift_rms_counts(spec) == pytest.approx(np.sqrt(variance.mean()))


@pytest.mark.parametrize(
    ("y_mm", "same"),
    [
        ([0.0, 3.0], True),
        ([0.0009, 3.0], True),
        ([0.0, 3.1], False),
        ([0.0011, 3.0], False),
        ([0.0, 3.0, 6.0], False),
    ],
)
def test_grids_are_the_same_to_a_micrometre_along_both_axes(y_mm, same):
    x_mm, y_mm = np.array([-3.0, 0.0]), np.array(y_mm)
    ours = x_mm, np.array([0.0, 3.0])
    assert same_grid((x_mm, y_mm), ours) is same
    assert same_grid((y_mm, x_mm), ours[::-1]) is same

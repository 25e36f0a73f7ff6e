"""The error envelope of small strain: grows with depth, scales with the shell, ends where unmeasured."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from fem.large_strain.linearity import depth_of_force_error_mm, linear_error
from fem.large_strain.results import first_crossing


def test_measured_figures_of_the_paper_cube():
    at_two = linear_error(2.0, 8.0)
    assert at_two is not None
    assert_allclose([at_two.force, at_two.motion], [0.055, 0.205], rtol=1e-12)


@pytest.mark.parametrize(("depth", "deeper"), [(0.2, 0.5), (1.0, 1.5), (3.0, 3.9)])
def test_error_grows_with_depth(depth, deeper):
    near, far = linear_error(depth, 8.0), linear_error(deeper, 8.0)
    assert near is not None
    assert far is not None
    assert near.force < far.force
    assert near.motion < far.motion


def test_a_thicker_shell_is_strained_less():
    assert linear_error(3.0, 12.0) == linear_error(2.0, 8.0)


def test_nothing_is_claimed_beyond_what_was_measured():
    assert linear_error(4.01, 8.0) is None
    assert linear_error(4.0, 8.0) is not None


@pytest.mark.parametrize(
    ("share", "depth"),
    [(0.0, 0.0), (0.025, 0.5), (0.0285, 0.75), (0.055, 2.0), (0.165, 4.0), (0.5, 4.0)],
)
def test_the_depth_of_an_error_is_read_off_the_envelope_and_scales_with_the_shell(share, depth):
    assert_allclose(depth_of_force_error_mm(share, 8.0), depth, atol=1e-12)
    assert_allclose(depth_of_force_error_mm(share, 12.0), 1.5 * depth, atol=1e-12)


def test_errors_between_measured_depths_are_straight():
    found = linear_error(0.25, 8.0)
    assert_allclose([found.force, found.motion], [0.0125, 0.045])
    thicker = linear_error(0.375, 12.0)
    assert_allclose([thicker.force, thicker.motion], [0.0125, 0.045])


@pytest.mark.parametrize(
    ("off", "share", "crossing"),
    [
        ([0, 0.02, 0.08, 0.04], 0.05, 1.5),
        ([0, 0.05, 0.08, 0.2], 0.05, 1.0),
        ([0, 0.02, 0.03, 0.04], 0.05, None),
        ([0, 0.1, 0.2, 0.3], 0.2, 2.0),
        ([0, 0.1, 0.1, 0.4], 0.05, 0.5),
    ],
)
def test_limits_are_the_first_crossing_of_the_straight_line(off, share, crossing):
    found = first_crossing(np.arange(4.0), np.array(off), share)
    assert found == (None if crossing is None else pytest.approx(crossing))

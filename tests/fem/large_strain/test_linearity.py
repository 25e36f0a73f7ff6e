"""The error envelope of small strain: grows with depth, scales with the shell, ends where unmeasured."""

import pytest
from numpy.testing import assert_allclose

from fem.large_strain.linearity import linear_error


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

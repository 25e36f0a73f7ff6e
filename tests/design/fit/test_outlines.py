"""Outlines of what stands on a face."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.fit.parts import rectangle


@pytest.mark.parametrize("azimuth", [0.0, 0.5, 2.2])
def test_a_rectangle_keeps_its_edges_however_it_is_turned(azimuth):
    centre = np.array([3.0, -1.0])
    first, second, third, fourth = rectangle((3.0, -1.0), (2.0, 0.5), azimuth) - centre
    assert_allclose((first + fourth) / 2, [2 * np.cos(azimuth), 2 * np.sin(azimuth)])
    assert_allclose((first + second) / 2, [-np.sin(azimuth) / 2, np.cos(azimuth) / 2])
    assert_allclose(first + third, second + fourth, atol=1e-12)

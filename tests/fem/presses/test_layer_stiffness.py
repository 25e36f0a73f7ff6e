"""Sphere on a bonded layer: limits in closed form, and the paper's own incompressible series."""

import numpy as np
import pytest

from fem.presses.layer_stiffness import sphere_on_layer_n


@pytest.mark.parametrize("ratio", [0.3, 0.45, 0.5])
def test_a_thick_layer_has_the_force_of_hertz(ratio):
    hertz = 4 / 3 * 0.4 / (1 - ratio**2) * np.sqrt(5.0) * 0.5**1.5
    assert sphere_on_layer_n(0.4, ratio, 5.0, 1e4, 0.5) == pytest.approx(hertz, rel=1e-3)


def test_an_incompressible_layer_has_the_series_of_the_paper():
    # equation 9: 16/9 E √R d^1.5 (1 + 1.133 χ + 1.283 χ² + 0.769 χ³ + 0.0975 χ⁴)
    chi = np.sqrt(5.0 * 1.0) / 8.0
    series = 1 + 1.133 * chi + 1.283 * chi**2 + 0.769 * chi**3 + 0.0975 * chi**4
    expected = 16 / 9 * 0.414 * np.sqrt(5.0) * series
    assert sphere_on_layer_n(0.414, 0.5, 5.0, 8.0, 1.0) == pytest.approx(expected, rel=2e-3)

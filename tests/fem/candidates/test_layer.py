"""A pressed layer on a rigid base: against Hertz's half-space and a bonded layer's compliance."""

import numpy as np
import pytest

from fem.candidates.layer import Layer
from tests.support.mechanics.layer_cases import sphere_on_layer_n

YOUNG_MPA, RADIUS_MM, DEPTHS_MM = 0.4, 5.0, np.array([2.0, 4.0, 6.0])
THICK, SHELL = (Layer(h, YOUNG_MPA, RADIUS_MM) for h in (2000.0, 8.0))


@pytest.mark.parametrize("force_n", [0.2, 1.0, 3.0])
def test_a_thick_layer_gives_way_as_hertz_says(force_n):
    """F = 4/3 E* √R d^1.5 with E* = E / (1 − ν²), ν = ½; the contact's radius is √(R d)."""
    stiff = YOUNG_MPA / 0.75
    depth = (0.75 * force_n / (stiff * RADIUS_MM**0.5)) ** (2 / 3)
    radius, deep = THICK.contact(force_n)
    np.testing.assert_allclose([radius, deep], [np.sqrt(RADIUS_MM * depth), depth], rtol=0.015)
    np.testing.assert_allclose(THICK.force_at(depth), force_n, rtol=0.03)


@pytest.mark.parametrize("thickness_mm", [8.0, 16.0])
@pytest.mark.parametrize(("depth_mm", "error"), [(0.5, 0.02), (1.0, 0.04), (2.0, 0.11)])
def test_forces_are_too_large_by_as_much_as_stated(thickness_mm, depth_mm, error):
    """Beside the integral equation of the contact: Hertz's pressures are not those of a thin layer."""
    exact_n = sphere_on_layer_n(depth_mm, RADIUS_MM, thickness_mm, YOUNG_MPA, 0.5)
    force_n = Layer(thickness_mm, YOUNG_MPA, RADIUS_MM).force_at(depth_mm)
    assert 0 < force_n / exact_n - 1 < error


def test_waves_of_pressure_move_the_surface_as_a_bonded_layer_s():
    """L(kh) of Dimitriadis et al. (2002) with κ = 1, over a half-space's 2 (1 − ν²) / (E k)."""
    k = np.array([0.05, 0.2, 0.5, 1.0, 3.0])
    alpha = 8.0 * k
    share = (2 * np.sinh(2 * alpha) - 4 * alpha) / (2 * np.cosh(2 * alpha) + 2 + 4 * alpha**2)
    down, _ = SHELL.modes(k, np.zeros(1))
    np.testing.assert_allclose(down[:, 0], share * 1.5 / (YOUNG_MPA * k), rtol=1e-9)


def test_the_base_holds_the_layer_and_its_volume_is_kept():
    k, step = np.array([0.1, 0.4, 1.5]), 1e-4
    down, along = SHELL.modes(k, np.array([8.0]))
    np.testing.assert_allclose([down, along], 0, atol=1e-12)
    low, high = (SHELL.modes(k, DEPTHS_MM + sign * step)[0] for sign in (-1, 1))
    _, along = SHELL.modes(k, DEPTHS_MM)
    np.testing.assert_allclose(along * k[:, None], -(high - low) / (2 * step), rtol=1e-6)


def test_disks_turn_with_the_plane_that_they_lie_in():
    """A thin disk (share 1) by the slope of the displacement down; beside a press its outer rim rises."""
    away, step = np.array([[4.0, 0.0]]), 1e-3
    moved = SHELL.motions(away, DEPTHS_MM, 5.0, turns=1.0)[0, :, 3]
    near, far = (
        SHELL.motions(away + np.array([[sign * step, 0.0]]), DEPTHS_MM, 5.0)[0, :, 3, 2]
        for sign in (-1, 1)
    )
    np.testing.assert_allclose(moved[:, 4], -(far - near) / (2 * step), rtol=1e-3)
    assert (moved[:, 4] < 0).all()
    assert (moved[:, 2] < 0).all()


def test_derivatives_are_those_of_moved_and_stronger_presses():
    away, step = np.array([[3.0, -2.0]]), 0.01
    motions = SHELL.motions(away, DEPTHS_MM, 5.0)[0]
    for column, along in enumerate(np.eye(2)):
        before, after = (
            SHELL.motions(away - sign * step * along, DEPTHS_MM, 5.0)[0, :, 3] for sign in (-1, 1)
        )
        np.testing.assert_allclose(motions[:, column], (after - before) / (2 * step), atol=1e-4)
    weak, strong = (SHELL.motions(away, DEPTHS_MM, force)[0, :, 3] for force in (4.9, 5.1))
    np.testing.assert_allclose(motions[:, 2], (strong - weak) / 0.2, atol=1e-4)


def test_nothing_moves_far_away():
    assert abs(SHELL.motions(np.array([[45.0, 0.0]]), DEPTHS_MM, 5.0)).max() < 1e-15

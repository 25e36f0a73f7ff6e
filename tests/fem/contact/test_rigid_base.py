"""What a rigid body close under a face takes back of a half-space's compliance."""

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.integrate import quad
from scipy.special import j0

from design.layout.body import face_frame
from design.layout.places.positions import shell_covers_mm
from design.spec.object import ObjectSpec
from fem.contact.half_space import HAT_OWN, Patches, normal_compliance
from fem.contact.rigid_base import rigid_bases, widening_mm2
from fem.linear.response import FaceSurface

SPEC = ObjectSpec.model_validate({"name": "one", "magnets": {"positions_mm": [[0.0, 0.0]]}})
CORNERS_MM = 20 * np.array([[-1.0, -1.0], [1.0, -1.0], [0.0, 1.0]])
SURFACE = FaceSurface(1, CORNERS_MM, np.array([[0, 1, 2]]))
EDGE_MM = 1.7
CORNERS_3D_MM = np.column_stack([CORNERS_MM, np.zeros(3)])
HATS = Patches(np.ones(3), CORNERS_3D_MM, np.full(3, EDGE_MM**2 / 8), 1.0)
"""Of an equilateral triangulation, by their variance."""

(BASE,) = rigid_bases(SPEC, face_frame(SPEC, 1), SURFACE, HATS)
E_MPA, NU = BASE.elastic


def layer_share(alpha, nu):
    """Surface compliance of a bonded layer over the half-space's, at α = wavenumber × depth."""
    k = 3 - 4 * nu
    damped = np.exp(-2 * alpha)
    top = k * (1 - damped**2) - 4 * alpha * damped
    return top / (k * (1 + damped**2) + (k * k + 1 + 4 * alpha**2) * damped)


def on_a_layer(distance_mm, variance_mm2, depth_mm):
    """Mutual compliance of two Gaussian patches on a bonded layer: Hankel's integral."""

    def integrand(k):
        return layer_share(k * depth_mm, NU) * j0(k * distance_mm) * np.exp(-(k**2) * variance_mm2)

    return (1 - NU**2) / (np.pi * E_MPA) * quad(integrand, 0, 12, limit=200)[0]


@pytest.mark.parametrize("nu", [0.0, 0.3, 0.4999])
@pytest.mark.parametrize("depth_mm", [0.5, 2.0, 4.0])
def test_the_share_taken_back_is_exact_for_waves_of_two_edges(depth_mm, nu):
    k = np.pi / EDGE_MM
    share = np.exp(-widening_mm2(depth_mm, EDGE_MM, nu) * k**2)
    assert_allclose(share, 1 - layer_share(k * depth_mm, nu), rtol=1e-6)


@pytest.mark.parametrize("depth_mm", [1.0, 2.0, 4.0])
def test_what_is_left_is_a_bonded_layer_within_a_share_of_the_half_space(depth_mm):
    """Longer waves, which finite elements answer, are not exact: 4 % of the half-space's own is left."""
    at = np.array([[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [4.0, 0.0]])
    patches = Patches(np.ones(4), at, np.full(4, 0.1), 1.0)
    half_space = normal_compliance(patches, patches, E_MPA, NU)
    left = half_space - BASE.taken_back(patches, depth_mm)
    exact = [on_a_layer(x, 0.1, depth_mm) for x in at[:, 0]]
    assert_allclose(left[0], exact, atol=half_space[0, 0] / 25)
    assert (np.linalg.eigvalsh(left) > 0).all()


def test_far_below_nothing_is_taken_back_and_at_the_surface_all():
    patches = Patches(np.ones(2), np.array([[0.0, 0.0], [0.5, 0.0]]), np.full(2, 0.1), 1.0)
    half_space = normal_compliance(patches, patches, E_MPA, NU)
    assert_allclose(BASE.taken_back(patches, 1e-3), half_space, rtol=1e-4)
    assert (BASE.taken_back(patches, 1e4) < 1e-2 * half_space).all()


def test_a_magnet_counts_over_it_and_not_far_beside():
    cover = shell_covers_mm(SPEC)[0][0]
    over, depth = BASE.weights(np.zeros((1, 3)))
    assert_allclose([over[0], depth], [1.0, cover], atol=0.02)
    away = np.array([[BASE.outline.radius_mm + share * cover, 0, 0] for share in (0, 0.8, 1.5, 4)])
    weight, _ = BASE.weights(away)
    assert_allclose(weight[1], 0.5, atol=1e-6)
    assert (np.diff(weight) < 0).all()
    assert weight[-1] < 1e-4


def test_the_factor_of_hats_is_that_of_waves_of_five_edges():
    """Sums over the reciprocal lattice: a hat's transform is A Π sinc(k·d/2) over the three edges d."""
    edges = np.array([[1.0, 0.0], [0.5, np.sqrt(3) / 2], [-0.5, np.sqrt(3) / 2]])
    area, variance = np.sqrt(3) / 2, 1 / 8
    lattice = np.stack(np.meshgrid(*[np.arange(-40, 41)] * 2), axis=-1).reshape(-1, 2)
    k = 2 * np.pi * lattice @ np.linalg.inv(edges[:2]).T + [2 * np.pi / 5, 0.0]
    hats = area**2 * np.prod(np.sinc(k @ edges.T / (2 * np.pi)) ** 2, axis=1)
    wave = np.linalg.norm(k, axis=1)
    gaussians = area**2 * np.exp(-variance * wave**2)
    # per hat, over what a Gaussian does to itself; both times the half-space's 2π/k
    own = area**2 * np.sqrt(np.pi / 2 / (2 * variance))
    assert_allclose(
        1 + np.sum((hats - gaussians) * 2 * np.pi / wave) / area / own, HAT_OWN, atol=5e-4
    )

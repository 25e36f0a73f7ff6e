"""Jaws, pads, cylinders and fingertips: limits, closed forms, and an independent code's forces."""

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.integrate import quad
from scipy.special import j0

from design.layout.tips import tip_heights_mm, tip_shape
from design.spec.object import IndenterSpec
from fem.contact.indenter import Border, tip_cells
from fem.contact.pad import pad_compliance
from fem.contact.rigid_base import log_taken_share
from fem.presses.joint import Tip, press_tips
from tests.support.mechanics.block_cases import block_response, spec_of

FACE = Border(np.array([-10.0, -8.0]), np.array([10.0, 8.0]))


def layer_share(alpha, ratio):
    return -np.expm1(log_taken_share(alpha, ratio))


def jaw(**more):
    return IndenterSpec(**{"kind": "cuboid", "size_mm": (30.0, 30.0), **more})


def test_an_ellipsoid_s_height_is_the_root_of_its_equation():
    """Lowest point at the place; all points lie on the turned surface; curvature is a²/c along x."""
    finger = IndenterSpec(kind="ellipsoid", size_mm=(12.0, 20.0), radius_mm=4.0)
    small = tip_heights_mm(tip_shape(finger), np.array([[0.1, 0.0], [0.0, 0.1], [6.01, 0.0]]))
    assert_allclose(small[:2], [0.005 * 4 / 36, 0.005 * 4 / 100], rtol=1e-3)
    assert np.isinf(small[2])
    turned = finger.changed(turn_deg=(30.0, 20.0, -15.0))
    shape = tip_shape(turned)
    places = np.random.default_rng(1).uniform(-3, 3, (50, 2))
    heights = tip_heights_mm(shape, places)
    assert (heights > 0).all()
    assert tip_heights_mm(shape, np.zeros(2)) == pytest.approx(0, abs=1e-12)
    inverse = np.linalg.inv(shape.ellipsoid)
    lowest = -inverse[:, 2] / np.sqrt(inverse[2, 2])
    points = np.column_stack([places, heights]) + lowest
    assert_allclose(np.einsum("pi,ij,pj->p", points, shape.ellipsoid, points), 1, rtol=1e-9)
    lengths = 1 / np.sqrt(np.linalg.eigvalsh(shape.ellipsoid))
    assert_allclose(np.sort(lengths), [4, 6, 10], rtol=1e-9)
    middle = shape.corners_mm.mean(axis=0)
    for share, covered in ((0.999, True), (1.001, False)):
        outline = middle + share * (shape.corners_mm - middle)
        assert (np.isfinite(tip_heights_mm(shape, outline)) == covered).all()


def test_a_sphere_is_the_ellipsoid_of_equal_axes():
    ball = tip_shape(IndenterSpec(kind="ellipsoid", size_mm=(10.0, 10.0), radius_mm=5.0))
    places = np.random.default_rng(2).uniform(-4, 4, (40, 2))
    away = np.sum(places**2, axis=1)
    expected = np.where(away <= 25, 5 - np.sqrt(np.clip(25 - away, 0, None)), np.inf)
    assert_allclose(tip_heights_mm(ball, places), expected, rtol=0, atol=1e-12)
    assert ball.radius_mm == pytest.approx(5.0)


def test_depth_counts_from_what_touches_the_face_first():
    """A jaw of 30 mm tilted by 2° hangs over by 5 mm: it touches at the border, and rises from there."""
    cells = tip_cells(jaw(turn_deg=(0.0, 0.0, 2.0)), FACE)
    rise = np.tan(np.deg2rad(2)) * (10 - cells.patches.centre_mm[:, 0])
    assert_allclose(cells.height_mm, rise, rtol=0, atol=1e-3)
    assert_allclose(cells.patches.area_mm2.sum(), 320, rtol=1e-9)


@pytest.mark.parametrize("ratio", [0.0, 0.3, 0.5])
def test_the_layer_s_compliance_has_the_limits_of_a_thin_and_a_thick_one(ratio):
    """Thick: a half-space. Thin: confined, t (1 + ν)(1 − 2ν)/((1 − ν) E), times k E/2(1 − ν²)."""
    assert_allclose(layer_share(np.array([12.0, 400.0]), ratio), 1, rtol=1e-7)
    thin = 1e-3
    confined = (1 + ratio) * (1 - 2 * ratio) / (1 - ratio) / (2 * (1 - ratio**2))
    assert_allclose(layer_share(np.array([thin]), ratio), confined * thin, rtol=2e-3, atol=1e-8)


def test_a_pad_s_compliance_is_its_hankel_integral():
    """Two small patches d apart: ∫ L(kt) J₀(kd) dk (1 − ν²)/(π E), Gaussians as the half-space has them."""
    spec = jaw(size_mm=(4.0, 4.0), pad=(2.0, 0.7, 0.3))
    patches = tip_cells(spec).patches
    found = pad_compliance(patches, spec)
    for a, b in ((0, 1), (0, 40), (3, 100)):
        d = np.linalg.norm(patches.centre_mm[a] - patches.centre_mm[b])
        s = patches.variance_mm2[a] + patches.variance_mm2[b]
        exact, _ = quad(
            lambda k, d=d, s=s: float(layer_share(np.array([2 * k]), 0.3)[0])
            * np.exp(-(k**2) * s / 2) * j0(k * d), 0, 40, limit=400,
        )  # fmt: skip
        areas = patches.area_mm2[a] * patches.area_mm2[b]
        assert_allclose(found[a, b], areas * exact * (1 - 0.09) / (np.pi * 0.7), rtol=1e-4)


@pytest.fixture(scope="module")
def layer():
    """Bonded layer of 8 mm, 40 mm wide, foam of ν = 0.3."""
    return block_response(0.3, 20.0, 8.0, layers=5)


def force_n(response, indenter, depth_mm, ratio=0.3):
    spec = spec_of(ratio).changed(indenter=indenter)
    return press_tips(spec, response, [Tip(1, 0.0, 0.0)], np.array([depth_mm]))


def test_pads_are_rigid_when_stiff_and_press_evenly_when_soft(layer):
    wide = jaw(size_mm=(60.0, 60.0))
    rigid = force_n(layer, wide, 0.5).force_n[0]
    stiff = force_n(layer, wide.changed(pad=(2.0, 1e5, 0.45)), 0.5)
    assert_allclose(stiff.force_n[0], rigid, rtol=1e-4)
    soft = wide.changed(pad=(2.0, 1e-3, 0.3))
    pressed = force_n(layer, soft, 0.5)
    confined_mpa = 1e-3 * 0.7 / (1.3 * 0.4)
    assert_allclose(pressed.force_n[0], 1600 * confined_mpa * 0.5 / 2.0, rtol=0.02)
    assert_allclose(pressed.contact_area_mm2[0], 1600, rtol=1e-9)

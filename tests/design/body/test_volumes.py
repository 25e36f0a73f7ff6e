"""Volumes of the kinds by formula against their triangles, open, bored, closed, and less a layer."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.body.kinds.registry import KINDS
from design.body.meshes import manifold_of
from tests.support.objects.shell_volume import cast_volume_mm3

CASES = [
    ("box", (40.0, 50.0, 60.0), ()),
    ("box", (40.0, 50.0, 60.0), (6,)),
    ("box", (40.0, 50.0, 60.0), (3, 6)),
    ("cylinder", (40.0, 40.0, 50.0), ()),
    ("cylinder", (40.0, 40.0, 50.0), (6,)),
    ("cylinder", (40.0, 40.0, 50.0), (1, 6)),
    ("sphere", (44.0, 44.0, 44.0), ()),
    ("sphere", (44.0, 44.0, 44.0), (6,)),
    ("capsule", (40.0, 40.0, 64.0), ()),
    ("capsule", (40.0, 40.0, 64.0), (6,)),
    ("pad", (40.0, 30.0, 12.0), ()),
    ("dome", (40.0, 40.0, 24.0), ()),
]


def made(kind, size, opened, thickness=8.0):
    return KINDS[kind](size, thickness, 0.02, opened, 12.0 if opened else 0.0)


def between(outer, inner):
    """Volume of the first without the second, by manifold3d."""
    return (manifold_of(outer) - manifold_of(inner)).volume() if inner else outer.volume


@pytest.mark.parametrize(("kind", "size", "opened"), CASES)
def test_the_silicone_s_volume_is_that_between_its_surfaces(kind, size, opened):
    body = made(kind, size, opened)
    measured = between(body.outer_surface(), body.cavity_surface())
    assert_allclose(body.volume_mm3(), measured, rtol=2e-3)
    layer, sensed = 2.0, tuple(face for face in body.faces if face not in opened)
    cast = between(body.cast_surface(layer, sensed), body.cavity_surface())
    assert_allclose(cast_volume_mm3(body, layer, sensed), cast, rtol=3e-3)
    assert cast_volume_mm3(body, layer, sensed) < body.volume_mm3()


@pytest.mark.parametrize(("kind", "size", "opened"), CASES)
def test_surfaces_lie_where_their_distances_say(kind, size, opened):
    """The outside is as far from the core as the shell is thick, or farther at a box's corners."""
    body = made(kind, size, opened)
    core = body.core_surface()
    if core is not None and kind != "dome":  # whose core goes on below its base
        assert abs(body.core_distance_mm(np.asarray(core.vertices))).max() < 0.03
        middle = core.triangles_center
        assert abs(body.core_distance_mm(middle)).max() < 0.03
    outside = np.asarray(body.outer_surface().vertices)
    low, high = body.corners_mm
    assert_allclose(outside.min(axis=0), low, atol=0.03)
    assert_allclose(outside.max(axis=0), high, atol=0.03)
    if kind in ("sphere", "capsule"):
        assert_allclose(body.core_distance_mm(outside), 8.0, atol=0.03)


@pytest.mark.parametrize("size", [(60.0, 50.0, 44.0), (40.0, 80.0, 60.0)])
def test_an_ellipsoid_s_triangles_lie_on_it_and_hold_its_volume(size):
    body = made("ellipsoid", size, ())
    surface = body.outer_surface()
    assert_allclose(surface.volume, np.pi / 6 * np.prod(size), rtol=1e-9)
    share = np.linalg.norm(np.asarray(surface.vertices) / body.half_mm, axis=1)
    assert_allclose(share, share[0])
    assert 1 < share[0] < 1.002
    flat = np.linalg.norm(surface.triangles_center / body.half_mm, axis=1)
    assert (1 - flat.min()) * body.half_mm.max() < 0.1


def test_the_pad_s_plate_begins_one_thickness_below_its_top():
    body = made("pad", (40.0, 30.0, 12.0), ())
    points = np.array([[1.0, 2.0, 6.0], [-9.0, 4.0, -2.0], [0.0, 0.0, -5.0]])
    assert_allclose(body.core_distance_mm(points), [8.0, 0.0, -3.0])
    assert body.core_surface() is None
    assert body.volume_mm3() == pytest.approx(40 * 30 * 8)


@pytest.mark.parametrize(
    ("sensed", "measures"),
    [
        ((1,), (20.0, -25.0, 24.5)),
        ((6,), (20.0, -24.5, 25.0)),
        ((2,), (19.5, -25.0, 25.0)),
        ((4,), (19.5, -25.0, 25.0)),
        ((1, 5, 6), (19.5, -24.5, 24.5)),
    ],
)
def test_a_cylinder_s_layer_lies_where_it_is_sensed(sensed, measures):
    cylinder = made("cylinder", (40.0, 40.0, 50.0), ())
    assert cylinder.cast_measures_mm(0.5, sensed) == pytest.approx(measures)


@pytest.mark.parametrize("size", [(120.0, 60.0, 60.0), (40.2, 126.1, 31.9), (60.0, 48.0, 48.0)])
@pytest.mark.parametrize("envelope", [0.05, 0.1, 0.3])
def test_an_ellipsoid_keeps_its_envelope_by_as_many_triangles_as_a_ball(size, envelope):
    """A pointed one had 16 times as many: 82 000, with which parts took minutes to check and build."""

    def surface_of(size):
        return KINDS["ellipsoid"](size, 8.0, envelope, (), 0.0).outer_surface()

    surface, half = surface_of(size), np.array(size) / 2
    points = np.vstack([surface.vertices, surface.triangles_center])
    # first-order distance from the ellipsoid: its implicit function over that function's slope
    level = np.linalg.norm(points / half, axis=1)
    slope = np.linalg.norm(points / half**2, axis=1) / level
    assert (abs(level - 1) / slope).max() < envelope / 2
    assert len(surface.faces) == len(surface_of((max(size),) * 3).faces)

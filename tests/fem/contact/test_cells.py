"""Cells of indenters: areas, centroids and second moments add up to those of the whole tip."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.spec.object import IndenterSpec
from fem.contact.half_space import HAT_OWN, SQUARE_OWN, Patches, joined
from fem.contact.indenter import hemisphere_profile_mm, moved, tip_cells


def whole(cells):
    """Area, centroid and mean second moment per axis about it."""
    patches = cells.patches
    area = patches.area_mm2.sum()
    centre = patches.area_mm2 @ patches.centre_mm / area
    away = np.sum((patches.centre_mm - centre) ** 2, axis=1) / 2
    return area, centre, patches.area_mm2 @ (away + patches.variance_mm2) / area


@pytest.mark.parametrize(("x", "y"), [(6.0, 4.0), (3.0, 9.0)])
def test_a_cuboid_s_cells_have_its_area_and_moment_exactly(x, y):
    cells = tip_cells(IndenterSpec(kind="cuboid", size_mm=(x, y)))
    area, centre, moment = whole(cells)
    assert_allclose(area, x * y, rtol=1e-12)
    assert_allclose(centre, 0, atol=1e-12)
    assert_allclose(moment, (x**2 + y**2) / 24, rtol=1e-12)
    assert_allclose(cells.height_mm, 0, atol=1e-12)
    assert 140 < len(cells.height_mm) < 300


def test_a_hemisphere_s_cells_have_its_disk_and_mean_height():
    """∫ (R − √(R² − r²)) over the disk is πR³ − 2πR³/3; where it is flat cells are halved."""
    cells = tip_cells(IndenterSpec(kind="hemisphere", radius_mm=5.0))
    area, centre, moment = whole(cells)
    assert_allclose(area, np.pi * 25, rtol=0.01)
    assert_allclose(centre, 0, atol=1e-9)
    assert_allclose(moment, 25 / 4, rtol=0.01)
    assert_allclose(cells.patches.area_mm2 @ cells.height_mm, np.pi * 125 / 3, rtol=0.02)
    size = cells.patches.area_mm2.max()
    low = cells.height_mm < 0.2
    assert_allclose(cells.patches.area_mm2[low], size / 4, rtol=1e-9)
    assert_allclose(cells.patches.variance_mm2[low], size / 4 / 12, rtol=1e-9)
    assert size <= 1.2**2


def test_large_tips_have_cells_of_1_7_mm_at_most_and_every_tip_its_own():
    large = tip_cells(IndenterSpec(kind="cuboid", size_mm=(30.0, 30.0)))
    assert_allclose(large.patches.area_mm2, (30 / 18) ** 2, rtol=1e-9)
    pair = tip_cells(IndenterSpec(kind="flat", radius_mm=2.0, tip_count=2))
    cells = tip_cells(IndenterSpec(kind="flat", radius_mm=2.0))
    count = len(cells.height_mm)
    assert list(pair.tip) == [0] * count + [1] * count
    assert_allclose(pair.patches.area_mm2, np.tile(cells.patches.area_mm2, 2), rtol=1e-12)
    away = pair.patches.centre_mm[count:] - pair.patches.centre_mm[:count]
    assert_allclose(np.linalg.norm(away, axis=1), 15.0, rtol=1e-12)
    middle = (pair.patches.centre_mm[count:] + pair.patches.centre_mm[:count]) / 2
    assert_allclose(middle, cells.patches.centre_mm, atol=1e-12)
    assert_allclose(
        moved(cells.patches, np.array([1.0, -2.0])).centre_mm,
        cells.patches.centre_mm + np.array([1.0, -2.0]),
    )


def test_the_hemisphere_s_profile_ends_at_its_equator():
    distance = np.array([0.0, 3.0, 4.0, 5.0, 7.0])
    assert_allclose(hemisphere_profile_mm(distance, 5.0), [0, 1, 2, 5, 5], atol=1e-12)


def test_joined_patches_stay_in_order_with_the_factor_of_their_shape():
    rng = np.random.default_rng(0)
    groups = [
        Patches(rng.random(n), rng.random((n, 2)), rng.random(n), own)
        for n, own in ((2, HAT_OWN), (3, SQUARE_OWN))
    ]
    found = joined(groups)
    assert found.own_factor == HAT_OWN
    for name in ("area_mm2", "centre_mm", "variance_mm2"):
        assert_allclose(getattr(found, name)[2:], getattr(groups[1], name))
        assert_allclose(getattr(found, name)[:2], getattr(groups[0], name))
    assert Patches(np.ones(1), np.ones((1, 2)), np.ones(1)).own_factor == SQUARE_OWN

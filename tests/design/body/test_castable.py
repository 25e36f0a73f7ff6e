"""Castable bodies of scans: judged by their own triangles and by shapes whose answer is known."""

from functools import partial
from pathlib import Path

import numpy as np
import pytest
import trimesh

from design.body.castable import castable_body, even_directions, noise_mm, without_noise
from design.body.imported import read_surface
from design.body.meshes import boolean_of, distance_mm


def turned_askew(surface):
    surface.apply_transform(trimesh.transformations.euler_matrix(0.4, -0.7, 1.1))
    surface.apply_translation([12.0, -3.0, 40.0])
    return surface


def recessed_can():
    """A can 60 × 60 × 90 mm whose lids lie 5 mm deep, as tins have them."""
    can = trimesh.creation.cylinder(30, 90, sections=96)
    lids = [trimesh.creation.cylinder(27, 10, sections=96) for _ in range(2)]
    for lid, height in zip(lids, (-45, 45), strict=True):
        lid.apply_translation([0, 0, height])
    return turned_askew(boolean_of("difference", [can, *lids]))


def lump(seed):
    """A convex lump that no plane mirrors."""
    rng = np.random.default_rng(seed)
    hull = trimesh.convex.convex_hull(rng.normal(size=(60, 3)) * [14.0, 18.0, 25.0])
    return turned_askew(hull)


def test_a_can_with_deep_lids_gets_flat_ones():
    body = castable_body(recessed_can())
    assert body.surface.extents == pytest.approx([60, 60, 90], abs=0.1)
    assert body.off_mm[0] == pytest.approx(5, abs=0.1)
    assert body.off_mm[1] < 0.05
    assert body.evened_mm < 0.1
    assert body.surface.volume == pytest.approx(np.pi * 30**2 * 90, rel=5e-3)


@pytest.mark.parametrize("scan", [recessed_can, *(partial(lump, seed) for seed in range(4))])
def test_halves_part_at_the_seam_without_hooking(scan):
    """Facets of a half face away from the seam or along it; the convex hull alone of a lump does not."""
    surface = castable_body(scan()).surface
    assert surface.is_watertight
    assert surface.is_convex
    side, lean = surface.triangles_center[:, 1], surface.face_normals[:, 1]
    across = abs(surface.triangles[:, :, 1]).max(axis=1) > 1e-6
    assert (lean * np.sign(side))[across & (abs(side) > 1e-6)].min() > -1e-6
    mirrored = surface.vertices * [1, -1, 1]
    assert abs(trimesh.proximity.signed_distance(surface, mirrored)).max() < 0.02
    assert np.argmax(surface.extents) == 2


@pytest.mark.parametrize("seed", range(4))
def test_an_even_lump_is_as_wide_in_the_mean_and_no_smaller(seed):
    """Theorems of Minkowski's mean: mean widths add up, volumes are larger (Brunn-Minkowski)."""
    scan = lump(seed)
    ways = even_directions(4000)
    body = castable_body(scan).surface
    width, width_before = (np.ptp(mesh.vertices @ ways.T, axis=0).mean() for mesh in (body, scan))
    assert width == pytest.approx(width_before, rel=2e-3)
    assert body.volume > 0.999 * scan.volume


@pytest.mark.parametrize("top_mm", [3.0, 4.0, 4.5])
def test_a_brick_with_a_flat_roof_on_two_sides_is_moved_by_half_of_the_lower_one(top_mm):
    """Its middle plane lies half of the height h outside the brick's. Where the corner, 40 mm from
    the roof's top along z, supports the body, its mirror image differs by h/2 cos(atan(h / 40))."""
    corners = np.array([[x, y, z] for x in (-18, 18) for y in (-20, 20) for z in (-40, 40)])
    roofs = [[18 + top_mm, 0, 0], [0, 25, 0]]
    body = castable_body(trimesh.convex.convex_hull(np.concatenate([corners, roofs])))
    assert sorted(body.surface.extents) == pytest.approx([36 + top_mm, 45, 80])
    assert body.evened_mm == pytest.approx(top_mm / 2 * np.cos(np.arctan(top_mm / 40)), abs=0.02)


def test_directions_are_even():
    """The mean of w wᵀ over a sphere is a third of the unit matrix."""
    ways = even_directions(500)
    assert np.linalg.norm(ways, axis=1) == pytest.approx(1)
    assert ways.T @ ways / 500 == pytest.approx(np.eye(3) / 3, abs=2e-3)


PEAR = Path(__file__).parents[3] / "examples" / "bodies" / "pear.stl"


def noisy_pear(deviation_mm, finer):
    """The pear, with the true one: 2562 corners 2 mm apart, or four times as many."""
    true = read_surface(str(PEAR))
    true = true.subdivide() if finer else true
    noisy = true.copy()
    noise = np.random.default_rng(3).normal(0, deviation_mm, (len(true.vertices), 1))
    noisy.vertices += true.vertex_normals * noise
    return noisy, true


@pytest.mark.parametrize("finer", [False, True])
@pytest.mark.parametrize("deviation_mm", [0.03, 0.1, 0.2])
def test_noise_is_measured_and_smoothed(deviation_mm, finer):
    """The smoothed scan is nearer to the true pear, but for 0.03 mm that coarse corners lose of its shape."""
    noisy, true = noisy_pear(deviation_mm, finer)
    assert noise_mm(noisy) == pytest.approx(deviation_mm, rel=0.1)
    smooth, moved_mm = without_noise(noisy)
    assert noise_mm(smooth) < 0.1 * deviation_mm
    true.apply_translation(smooth.center_mass - true.center_mass)
    off_mm = distance_mm(true, np.asarray(smooth.vertices))
    assert np.sqrt(np.mean(off_mm**2)) < 0.03 + 0.5 * deviation_mm
    assert smooth.volume == pytest.approx(true.volume, rel=5e-3)
    assert 2 * deviation_mm < moved_mm < 6 * deviation_mm + 0.2


@pytest.mark.parametrize(
    "body",
    [
        lambda: trimesh.creation.box((40, 50, 60)),
        lambda: trimesh.creation.box((40, 50, 60)).subdivide().subdivide().subdivide(),
        lambda: trimesh.creation.cylinder(20, 60),
        lambda: trimesh.creation.icosphere(3, 25),
        lambda: lump(0),
        recessed_can,
        lambda: read_surface(str(PEAR)),
    ],
)
def test_shape_is_no_noise(body):
    scan = body()
    smooth, moved_mm = without_noise(scan)
    assert smooth is scan
    assert moved_mm == 0.0

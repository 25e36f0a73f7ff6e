"""Castable bodies of scans: judged by their own triangles and by shapes whose answer is known."""

from functools import partial
from pathlib import Path

import numpy as np
import pytest
import trimesh

from design.body.castable import castable_body, noise_mm, traits_of_scan, without_noise
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


def arc():
    """A sausage of 16 mm, bent by 115° round a radius of 60 mm."""
    turns = np.linspace(-1.0, 1.0, 25)
    path = 60 * np.column_stack([np.cos(turns), np.sin(turns), np.zeros(25)])
    balls = [trimesh.creation.icosphere(3, 16) for _ in path]
    for ball, place in zip(balls, path, strict=True):
        ball.apply_translation(place)
    return turned_askew(boolean_of("union", balls))


def cup():
    """A cup 60 × 60 × 60 mm with a handle that stands out by 20 mm, walls of 4 mm."""
    outside, inside = (trimesh.creation.cylinder(r, 60, sections=96) for r in (30, 26))
    inside.apply_translation([0, 0, 4])
    handle = trimesh.creation.torus(18, 5, 64, 32)
    handle.apply_transform(trimesh.transformations.rotation_matrix(np.pi / 2, [1, 0, 0]))
    handle.apply_translation([27, 0, 0])
    return turned_askew(boolean_of("difference", [boolean_of("union", [outside, handle]), inside]))


def test_a_can_with_deep_lids_gets_flat_ones():
    body = castable_body(recessed_can())
    assert body.surface.extents == pytest.approx([60, 60, 90], abs=0.3)
    assert body.off_mm.max() == pytest.approx(5, abs=0.2)
    assert np.median(body.off_mm) < 0.05
    assert body.evened_mm < 1, "of its sharp edges"
    assert body.surface.volume == pytest.approx(np.pi * 30**2 * 90, rel=5e-3)


def test_a_bent_body_stays_bent():
    scan = arc()
    body = castable_body(scan)
    assert body.off_mm.max() < 0.5
    assert body.evened_mm < 0.5
    assert body.surface.volume == pytest.approx(scan.volume, rel=0.01)
    # across the arc, and from end to end, as the balls' places give them
    longest = 2 * (60 * np.sin(1.0) + 16)
    assert body.surface.extents[1:] == pytest.approx([32, longest], abs=0.3)


def test_a_cup_is_filled_and_keeps_its_handle():
    """The hollow has π 26² 56 mm³; the seam runs along the handle."""
    scan = cup()
    body = castable_body(scan)
    assert body.changed_mm3 == pytest.approx(np.pi * 26**2 * 56, rel=0.06)
    assert body.surface.volume == pytest.approx(scan.volume + np.pi * 26**2 * 56, rel=0.02)
    assert body.evened_mm < 1.5
    assert not body.surface.is_convex


@pytest.mark.parametrize(
    "scan", [recessed_can, arc, cup, *(partial(lump, seed) for seed in range(2))]
)
def test_halves_part_at_the_seam_without_hooking(scan):
    """Lines along the pull go through the body once; the halves are mirror images."""
    surface = castable_body(scan()).surface
    assert surface.is_watertight
    assert surface.body_count == 1
    x, z = np.random.default_rng(0).uniform(-0.5, 0.5, (2, 400))
    starts = np.column_stack([x, np.full(400, -1.0), z]) * surface.extents
    hits = surface.ray.intersects_location(starts, np.tile([0.0, 1.0, 0.0], (400, 1)))[1]
    assert np.isin(np.bincount(hits, minlength=400), [0, 2]).mean() > 0.99, "few graze a facet"
    mirrored = surface.vertices * [1, -1, 1]
    assert distance_mm(surface, mirrored).max() < 0.1
    assert surface.extents[2] >= surface.extents[0]


def test_a_scan_that_lies_askew_is_known():
    straight = trimesh.creation.cylinder(20, 90, sections=96).subdivide_to_size(4.0)
    assert len(straight.vertices) > 1000
    assert traits_of_scan(straight) == ""
    assert "askew" in traits_of_scan(turned_askew(straight.copy()))
    drawn = turned_askew(trimesh.creation.cylinder(20, 90))
    assert traits_of_scan(drawn) == "", "a drawn one is as meant"


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

"""Polarization of magnets that demagnetise themselves: closed forms, another code, the field."""

import magpylib
import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.special import ellipe, ellipk

from design.layout.places.positions import magnet_layout
from design.spec.magnets import MagnetSpec
from design.spec.object import ObjectSpec
from estimator.field.models import FieldModel
from estimator.field.sources import BlockMagnet, DiskMagnet, magnet_source, self_demagnetised

SOLVED = [
    (DiskMagnet(6.0, 1.0, 1.0), 0.96554, [[8.6154, 6.4616, 9.7517], [0, 0, -12.9698]]),
    (DiskMagnet(5.0, 5.0, 1.0), 0.98465, [[26.2297, 19.6723, 20.1429], [0, 0, -20.281]]),
    (DiskMagnet(8.0, 2.0, 1.0, 4.0), 0.97525, [[8.8372, 6.6279, 10.7734], [0, 0, -14.4809]]),
    (BlockMagnet((8.0, 4.0), 2.0, 1.0), 0.97268, [[5.8769, 5.5097, 6.671], [0, 0, -8.0252]]),
    (BlockMagnet((5.0, 5.0), 5.0, 1.0), 0.98367, [[17.4511, 12.9954, 14.2977], [0, 0, -14.9401]]),
]
"""Mean polarization for a remanence of 1 T and a recoil permeability of 1.05, and B (mT) at twice the
circumscribed radius along `DIRECTIONS`: 210 to 252 cells (blocks 2650 to 2740), each of uniform
polarization, by magpylib-material-response 0.6.0. 16 % fewer to 75 % more cells change the mean by 0.01 %."""
DIRECTIONS = np.array([[0.48, 0.36, 0.8], [0.8, -0.6, 0.0]])
SHAPES = ["flat disk", "tall disk", "ring", "block", "cube"]


def joseph(diameter, height):
    """Mean demagnetising factor of a cylinder by elliptic integrals (Joseph 1966; Nagaoka 1909)."""
    diagonal = np.hypot(diameter, height)
    k, h = diameter / diagonal, height / diagonal
    complete, second = ellipk(k * k), ellipe(k * k)
    return 1 - 4 / (3 * np.pi * h) * ((h / k) ** 2 * (complete - second) + second - k)


@pytest.mark.parametrize("size", [(6.0, 1.0), (5.0, 5.0), (10.0, 0.2), (1.0, 20.0)])
def test_disks_have_the_demagnetising_factor_of_elliptic_integrals(size):
    assert_allclose(DiskMagnet(*size, 1.0).demagnetising_factor, joseph(*size), rtol=1e-8)


def test_a_ring_lies_between_the_disk_without_a_hole_and_a_thin_wall():
    disk = DiskMagnet(8.0, 2.0, 1.0).demagnetising_factor
    factors = [
        DiskMagnet(8.0, 2.0, 1.0, hole).demagnetising_factor for hole in (1e-3, 2.0, 4.0, 6.0, 7.99)
    ]
    assert_allclose(factors[0], disk, rtol=1e-5)
    assert np.all(np.diff(factors) < 0)
    assert 0 < factors[-1] < 0.02


@pytest.mark.parametrize("edges", [(5.0, 5.0, 5.0), (8.0, 4.0, 2.0), (20.0, 5.0, 0.1)])
def test_factors_of_a_block_along_its_three_edges_sum_to_one(edges):
    x, y, z = edges
    turned = [BlockMagnet(xy, z, 1.0) for xy, z in (((x, y), z), ((y, z), x), ((z, x), y))]
    assert_allclose(sum(block.demagnetising_factor for block in turned), 1, rtol=1e-9)


@pytest.mark.parametrize("body", [solved[0] for solved in SOLVED], ids=SHAPES)
def test_the_mean_field_inside_a_uniform_body_is_the_demagnetising_factor(body):
    """Gauss quadrature of magpylib's exact field over the volume."""
    nodes, weights = np.polynomial.legendre.leggauss(24)
    z, wz = nodes * body.height_mm / 2, weights / 2
    if isinstance(body, BlockMagnet):
        x, y = (edge / 2 * nodes for edge in body.size_mm)
        points = np.stack(np.meshgrid(x, y, z, indexing="ij"), -1).reshape(-1, 3)
        weight = np.einsum("i,j,k->ijk", weights / 2, weights / 2, wz).ravel()
        source = magpylib.magnet.Cuboid(
            polarization=(0, 0, 1), dimension=(*body.size_mm, body.height_mm)
        )
    else:
        inner, outer = body.inner_diameter_mm / 2, body.diameter_mm / 2
        r = inner + (outer - inner) * (1 + nodes) / 2
        points = np.stack([*np.meshgrid(r, [0.0], z, indexing="ij")], -1).reshape(-1, 3)
        weight = np.outer(weights * r / (weights @ r), wz).ravel()
        radii = [(outer, 1)] + [(inner, -1)] * (inner > 0)
        source = magpylib.Collection(
            *(
                magpylib.magnet.Cylinder(
                    polarization=(0, 0, sign), dimension=(2 * radius, body.height_mm)
                )
                for radius, sign in radii
            )
        )
    inside = weight @ source.getB(points)[:, 2]
    assert_allclose(1 - inside, body.demagnetising_factor, atol=2e-4)


@pytest.mark.parametrize(("body", "mean", "field_mt"), SOLVED, ids=SHAPES)
def test_polarization_and_field_are_those_of_a_magnet_in_many_cells(body, mean, field_mt):
    working = self_demagnetised(body, 1.0, 1.05)
    assert_allclose(working.polarization_t, mean, rtol=3e-4)
    points = 2 * body.circumscribed_radius_mm * DIRECTIONS
    up, side = np.tile([0.0, 0.0, 1.0], (2, 1)), np.tile([1.0, 0.0, 0.0], (2, 1))
    found = np.array(FieldModel(working, "exact")(tuple(points.T), tuple(up.T), tuple(side.T))).T
    off = np.linalg.norm(1e3 * found - field_mt, axis=1) / np.linalg.norm(field_mt, axis=1)
    assert off.max() < 3e-3
    as_remanence = found / working.polarization_t
    wrong = np.linalg.norm(1e3 * as_remanence - field_mt, axis=1) / np.linalg.norm(field_mt, axis=1)
    assert wrong.min() > 0.01, "a polarization equal to the remanence is told apart"


def test_a_permeability_of_one_leaves_the_remanence():
    assert self_demagnetised(DiskMagnet(6.0, 1.0, 1.0), 1.43, 1.0).polarization_t == 1.43


def test_every_grade_and_part_demagnetises_itself():
    by_part = magnet_source(MagnetSpec.model_validate({"part": "MP 12x5x2 / N38"}))
    assert_allclose(by_part.polarization_t, 1.24 / (1 + 0.05 * 0.62809), rtol=1e-5)


@pytest.mark.parametrize(
    ("pitch_mm", "most"), [(10.0, 4e-4), (7.0, 2e-3)], ids=["paper's cube", "1 mm apart"]
)
def test_other_magnets_change_the_polarization_as_little_as_the_page_says(pitch_mm, most):
    """The change that is left out: (μ_r − 1) B / (1 + N (μ_r − 1)), B that of all others."""
    places = [
        [0, 0],
        *([x * pitch_mm, y * pitch_mm] for x, y in ((1, 0), (-1, 0), (0, 1), (0, -1))),
    ]
    if pitch_mm == 10.0:
        places = [[0, 0], [10, 10], [-10, 10], [-10, -10], [10, -10]]
    spec = ObjectSpec.model_validate({"name": "c", "magnets": {"positions_mm": places}})
    layout, disk = magnet_layout(spec), magnet_source(spec.magnets)
    bodies = [
        magpylib.magnet.Cylinder(polarization=(0, 0, disk.polarization_t), dimension=(6, 1))
        for _ in layout.face
    ]
    for body, centre, axis in zip(bodies, layout.centre_mm, layout.axis, strict=True):
        body.rotate_from_rotvec(turn_to(axis))
        body.position = centre
    of_each = magpylib.getB(bodies, layout.centre_mm)
    of_others = of_each.sum(axis=0) - of_each[np.arange(len(bodies)), np.arange(len(bodies))]
    along = abs(np.sum(of_others * layout.axis, axis=1)).max()
    change = 0.05 * along / (1 + 0.05 * disk.demagnetising_factor) / disk.polarization_t
    assert 0.5 * most < change < most


def turn_to(axis):
    """Rotation vector (degrees) that takes z to `axis`."""
    about = np.cross([0, 0, 1.0], axis)
    sine, cosine = np.linalg.norm(about), axis[2]
    about = about / sine if sine > 1e-12 else np.array([1.0, 0, 0])
    return np.degrees(np.arctan2(sine, cosine)) * about

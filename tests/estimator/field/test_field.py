"""Models of a disk magnet's field against magpylib, Maxwell's equations and rotations."""

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation

from estimator.field.exact import cylinder_field
from estimator.field.models import (
    FieldModel,
    candidate_models,
    field_model,
    model_error,
    multipole_field,
)
from estimator.field.sources import BlockMagnet
from tests.support.mechanics.magnet_poses import (
    DISKS,
    magpylib_field,
    random_poses,
    relative_error,
    total_field,
)


def modelled(model, turn, centre, point):
    offset, axis = (point - centre).T, turn.apply([0, 0, 1]).T
    return np.array(model(tuple(offset), tuple(axis))).T


@pytest.mark.parametrize(("disk", "reach"), [*zip(DISKS, (1.6, 2.6, 1.6), strict=True)])
def test_models_match_magpylib_within_their_stated_error(disk, reach):
    nearest = reach * disk.circumscribed_radius_mm
    poses = random_poses(disk, nearest, np.random.default_rng(1))
    exact = magpylib_field(disk, *poses)
    order = field_model(disk, nearest).order
    series = modelled(lambda o, a: multipole_field(o, a, disk, order), *poses)
    assert relative_error(series, exact).max() <= 1e-3
    if order > 7:
        lower = modelled(lambda o, a: multipole_field(o, a, disk, order - 2), *poses)
        assert relative_error(lower, exact).max() > 5e-4
        assert model_error(FieldModel(disk, "multipole", order - 2), nearest) > 1e-3
    cylinder = modelled(lambda o, a: cylinder_field(o, a, disk), *poses)
    assert relative_error(cylinder, exact).max() <= 1e-9


def test_dipole_is_the_far_field_and_13_percent_wrong_at_10_mm():
    disk = DISKS[0]
    poses = random_poses(disk, 400.0, np.random.default_rng(3), 200)
    far = modelled(lambda o, a: multipole_field(o, a, disk, 1), *poses)
    assert relative_error(far, magpylib_field(disk, *poses)).max() < 1.2e-4
    assert_allclose(model_error(FieldModel(disk, "multipole", 1), 10.0), 0.1333, rtol=0.01)
    assert_allclose(
        np.ravel(multipole_field((0.0, 0.0, 10.0), (0.0, 0.0, 1.0), disk, 1)),
        [0, 0, 1.43 * np.pi * 9 / (2 * np.pi * 1000)],
        rtol=1e-12,
    )


@pytest.mark.parametrize(
    "model", [FieldModel(DISKS[0], "multipole", 9), FieldModel(DISKS[1], "exact")]
)
def test_field_outside_has_no_divergence_and_no_curl(model):
    rng = np.random.default_rng(4)
    _, _, points = random_poses(model.magnet, 7.0, rng, 60)
    centre = rng.uniform(-2, 2, (1, 3))
    axis = np.array([[0.48, -0.6, 0.64]])
    points = points[np.linalg.norm(points - centre, axis=1) > 7.0]
    step = 1e-3
    shifts = step * np.eye(3)
    slope = np.stack(
        [
            (
                total_field(points + shift, centre, axis, model)
                - total_field(points - shift, centre, axis, model)
            )
            / (2 * step)
            for shift in shifts
        ],
        axis=1,
    )
    size = np.linalg.norm(slope, axis=(1, 2))
    divergence = np.trace(slope, axis1=1, axis2=2)
    curl = np.linalg.norm(slope - slope.transpose(0, 2, 1), axis=(1, 2))
    assert_allclose(divergence / size, 0, atol=2e-6)
    assert_allclose(curl / size, 0, atol=2e-6)


@pytest.mark.parametrize(("name", "order"), [("multipole", 1), ("multipole", 9), ("exact", 0)])
def test_field_turns_with_the_magnet_and_the_point(name, order):
    model = FieldModel(DISKS[0], name, order)
    rng = np.random.default_rng(5)
    turn = Rotation.from_rotvec([0.3, -1.1, 0.7])
    points, centres = rng.uniform(8, 15, (40, 3)), rng.uniform(-3, 3, (2, 3))
    axes = Rotation.random(2, rng=rng).apply([0, 0, 1])
    turned = total_field(turn.apply(points), turn.apply(centres), turn.apply(axes), model)
    still = total_field(points, centres, axes, model)
    assert_allclose(turned, turn.apply(still), rtol=1e-10, atol=1e-16)
    assert abs(turned - turn.inv().apply(still)).max() > 0.1 * abs(turned).max()


def test_fields_of_magnets_add_up():
    model = field_model(DISKS[0], 8.0)
    points = np.array([[1.0, 2.0, 12.0], [-3.0, 9.0, 4.0]])
    centres = np.array([[0.0, 0.0, 0.0], [2.0, -4.0, -1.0]])
    axes = np.array([[0.0, 0.0, 1.0], [0.6, 0.0, -0.8]])
    both = total_field(points, centres, axes, model)
    apart = sum(total_field(points, centres[i : i + 1], axes[i : i + 1], model) for i in (0, 1))
    assert_allclose(both, apart, rtol=1e-12)


def test_model_is_chosen_by_the_nearest_distance():
    disk = DISKS[0]
    assert field_model(disk, 12.0) == FieldModel(disk, "multipole", 7)
    assert field_model(disk, 7.0) == FieldModel(disk, "multipole", 9)
    assert field_model(disk, 3.2).name == "exact"


def test_models_are_tried_from_the_cheapest_on():
    """Series of odd orders from 7 to 25; of a block two of them, then 2 to 8 charges along an edge."""
    series = [("multipole", order, 0) for order in range(7, 26, 2)]
    disk = [(one.name, one.order, one.charges) for one in candidate_models(DISKS[0])]
    assert disk == series
    block = [(one.name, one.charges) for one in candidate_models(BlockMagnet((4.0, 3.0), 2.0, 1.2))]
    assert block == [("multipole", 0)] * 2 + [("charges", count) for count in range(2, 9)]


def test_inside_of_a_tilted_disk():
    axis = (0.6, 0.0, 0.8)
    along, across = np.array(axis), np.array([0.8, 0.0, -0.6])
    inside = 0.49 * along + 2.99 * across
    for point, expected in (
        (inside, True),
        (0.51 * along, False),
        (3.01 * across, False),
        (-inside, True),
    ):
        assert bool(DISKS[0].holds(tuple(point), axis)) is expected

"""Rings and blocks: parity with magpylib, Maxwell's equations, choice of model."""

import magpylib
import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation

from estimator.field.models import FieldModel, field_model, model_error
from estimator.field.sources import BlockMagnet, DiskMagnet
from tests.support.mechanics.magnet_poses import relative_error, total_field

RING = DiskMagnet(8.0, 2.0, 1.3, inner_diameter_mm=4.0)
SQUARE = BlockMagnet((5.0, 5.0), 1.0, 1.4)
OBLONG = BlockMagnet((8.0, 4.0), 2.0, -1.2)
CUBE = BlockMagnet((5.0, 5.0), 5.0, 1.1)
SOURCES = [RING, SQUARE, OBLONG, CUBE]
NAMES = ["ring", "square", "oblong", "cube"]
POSES = 1000


def poses_from(source, nearest_mm, seed, count=POSES):
    """Turns, centres and points at `nearest_mm` to three times that from the centres."""
    rng = np.random.default_rng(seed)
    direction = rng.standard_normal((count, 3))
    direction /= np.linalg.norm(direction, axis=1, keepdims=True)
    centre = rng.uniform(-20, 20, (count, 3))
    return (
        Rotation.random(count, rng=rng),
        centre,
        centre + direction * nearest_mm * rng.uniform(1, 3, (count, 1)),
    )


def oracle(source, turn, centre, point):
    """magpylib in the source's own frame."""
    local = turn.inv().apply(point - centre) / 1e3
    polarization, height = (0, 0, source.polarization_t), source.height_mm / 1e3
    if isinstance(source, BlockMagnet):
        size = tuple(edge / 1e3 for edge in (*source.size_mm, source.height_mm))
        body = magpylib.magnet.Cuboid(polarization=polarization, dimension=size)
    else:
        size = (source.inner_diameter_mm / 2e3, source.diameter_mm / 2e3, height, 0, 360)
        body = magpylib.magnet.CylinderSegment(polarization=polarization, dimension=size)
    return turn.apply(body.getB(local))


def modelled(model, turn, centre, point):
    offset = tuple((point - centre).T)
    axis, side = (tuple(turn.apply(e).T) for e in ([0.0, 0.0, 1.0], [1.0, 0.0, 0.0]))
    return np.array(model(offset, axis, side)).T


@pytest.mark.parametrize("source", SOURCES, ids=NAMES)
@pytest.mark.parametrize("reach", [1.3, 2.6])
def test_chosen_models_match_magpylib_within_a_thousandth(source, reach):
    nearest = reach * source.circumscribed_radius_mm
    count = POSES
    poses = poses_from(source, nearest, 1, count)
    exact = oracle(source, *poses)
    model = field_model(source, nearest)
    assert relative_error(modelled(model, *poses), exact).max() <= 1e-3
    full = modelled(FieldModel(source, "exact"), *poses)
    assert relative_error(full, exact).max() <= 1e-7


def test_a_block_turned_about_its_axis_gives_another_field():
    """Planted fault: the side of an oblong block taken for the edge across it."""
    turn, centre, point = poses_from(OBLONG, 8.0, 3, 50)
    offset, axis = tuple((point - centre).T), tuple(turn.apply([0.0, 0.0, 1.0]).T)
    wrong = np.array(field_model(OBLONG, 8.0)(offset, axis, tuple(turn.apply([0.0, 1.0, 0.0]).T)))
    exact = oracle(OBLONG, turn, centre, point)
    assert np.median(relative_error(wrong.T, exact)) > 0.02
    with pytest.raises(ValueError, match="needs the direction of its side"):
        FieldModel(OBLONG, "charges", charges=3)(offset, axis)


@settings(max_examples=40, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(
    st.floats(1, 10), st.floats(0.1, 0.9), st.floats(0.5, 6), st.floats(1.25, 4), st.integers(0, 99)
)
def test_any_ring_and_any_block_keep_the_stated_error(width, share, height, reach, seed):
    for source in (
        DiskMagnet(width, height, 1.2, inner_diameter_mm=share * width),
        BlockMagnet((width, share * width), height, 1.2),
    ):
        nearest = reach * source.circumscribed_radius_mm
        poses = poses_from(source, nearest, seed, 30)
        found = modelled(field_model(source, nearest), *poses)
        assert relative_error(found, oracle(source, *poses)).max() <= 1e-3


def test_the_choice_says_which_model_and_why():
    assert field_model(RING, 12.0).name == "multipole"
    assert field_model(RING, 4.5).name == "exact"
    near, far = field_model(SQUARE, 8.0), field_model(SQUARE, 30.0)
    assert (near.name, far.name) == ("charges", "multipole")
    assert model_error(FieldModel(SQUARE, "multipole", 9), 8.0) > 1e-3 >= model_error(near, 8.0)
    assert model_error(FieldModel(SQUARE, "charges", charges=near.charges - 1), 8.0) > 1e-3


@pytest.mark.parametrize("source", SOURCES, ids=NAMES)
def test_far_field_is_the_dipole_of_moment_polarization_times_volume(source):
    distance = 80 * source.circumscribed_radius_mm
    poses = poses_from(source, distance, 4, 40)
    modelled_field = modelled(FieldModel(source, "multipole", 1), *poses)
    exact = modelled(field_model(source, distance), *poses)
    assert relative_error(modelled_field, exact).max() < 5e-4


@pytest.mark.parametrize(
    "model",
    [
        FieldModel(RING, "multipole", 11),
        FieldModel(OBLONG, "charges", charges=5),
        FieldModel(CUBE, "exact"),
    ],
    ids=["multipole", "charges", "exact"],
)
def test_no_divergence_and_no_curl_outside(model):
    rng = np.random.default_rng(5)
    points = rng.standard_normal((60, 3))
    points *= rng.uniform(8, 14, (60, 1)) / np.linalg.norm(points, axis=1, keepdims=True)
    turn = Rotation.from_rotvec([0.4, -0.9, 0.3])
    given_ = (np.zeros((1, 3)), turn.apply([[0.0, 0.0, 1.0]]), model, turn.apply([[1.0, 0.0, 0.0]]))
    step = 1e-3
    slope = np.stack(
        [
            total_field(points + shift, *given_) - total_field(points - shift, *given_)
            for shift in step * np.eye(3)
        ],
        axis=1,
    ) / (2 * step)
    size = np.linalg.norm(slope, axis=(1, 2))
    assert_allclose(np.trace(slope, axis1=1, axis2=2) / size, 0, atol=3e-6)
    curl = np.linalg.norm(slope - slope.transpose(0, 2, 1), axis=(1, 2))
    assert_allclose(curl / size, 0, atol=3e-6)


def test_inside_means_the_outline_and_a_rings_hole_counts_as_full():
    axis, side = (0.0, 0.6, 0.8), (1.0, 0.0, 0.0)
    across = (0.0, 0.8, -0.6)
    place = lambda a, s, t: tuple(  # noqa: E731
        a * np.array(axis) + s * np.array(side) - t * np.array(across)
    )
    assert OBLONG.holds(place(0.9, 3.9, 1.9), axis, side)
    assert not OBLONG.holds(place(0.9, 1.9, 3.9), axis, side)
    assert not OBLONG.holds(place(1.1, 0.0, 0.0), axis, side)
    up, along = (0.0, 0.0, 1.0), (1.0, 0.0, 0.0)
    assert OBLONG.holds((4.0, 2.0, 1.0), up, along)
    assert OBLONG.holds((-4.0, -2.0, -1.0), up, along)
    assert RING.holds(place(0.0, 0.5, 0.0), axis)
    assert not RING.holds(place(0.0, 4.1, 0.0), axis)

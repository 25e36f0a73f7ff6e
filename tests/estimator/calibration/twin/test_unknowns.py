"""Unknowns of an object as standard normal numbers: which there are, and what each of them moves."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from estimator.calibration.twin.unknowns import (
    FARTHEST,
    Unknowns,
    count_at_limits,
    jacobian_of,
    most_probable,
    normal_equations,
)
from tests.support.mechanics.synthetic_presses import coarse_spec

SPEC = coarse_spec()
FACE = Unknowns(SPEC, 2)


def numbers(**changes):
    """All 0 but for one number of a contribution, by its place among the free ones."""
    values, start = np.zeros(len(FACE)), 0
    for name, mask in FACE.free.items():
        if name in changes:
            place, size = changes[name]
            values[start + place] = size
        start += int(mask.sum())
    return values


def test_a_face_has_the_numbers_of_its_own_parts_and_of_the_whole_object():
    magnets, sensors = SPEC.magnets.count, SPEC.sensors.count_per_face
    own = (2 + 1 + 2 + 1) * magnets + (3 + 3 + 3) * sensors
    assert len(FACE) == own + 3 + 1 + 1 + 5


def test_a_number_moves_its_own_part_by_one_standard_deviation():
    design = FACE.design.scene
    magnet = np.flatnonzero(design.magnets.face == 2)
    moved = (
        FACE.assembly(numbers(magnet_depth=(1, 1.0))).scene.magnets.centre_mm
        - design.magnets.centre_mm
    )
    assert_allclose(np.linalg.norm(moved[magnet[1]]), SPEC.tolerances.magnet_seat_mm)
    assert_allclose(np.delete(moved, magnet[1], axis=0), 0, atol=1e-12)
    stronger = FACE.assembly(numbers(remanence=(0, -2.0))).scene.magnets.strength
    assert_allclose(stronger[magnet[0]], 1 - 2 * SPEC.tolerances.remanence_relative)
    softer = FACE.assembly(numbers(modulus=(0, 1.0))).modulus_ratio
    assert_allclose(softer, np.exp(SPEC.tolerances.modulus_relative))


def test_the_last_five_numbers_are_how_the_silicone_departs_from_small_strain():
    """Standard deviations beforehand of 0.7, 0.7, 0.5, 1 and 0.5."""
    values = np.zeros(len(FACE))
    values[-5:] = 1.0, -2.0, 3.0, 0.5, -1.0
    found = FACE.correction(values)
    told = [part for part in vars(found).values() if isinstance(part, tuple)]
    assert_allclose(np.concatenate(told), [0.7, -1.4, 1.5, 0.5, -0.5])
    assert SPEC.shell.thickness_mm in vars(found).values()


def test_numbers_at_their_limit_are_counted():
    assert count_at_limits(np.array([FARTHEST, -FARTHEST, FARTHEST - 1e-5, 0.0])) == 2


@pytest.mark.parametrize("face", [1, 5])
def test_numbers_of_a_face_leave_the_others_as_they_are(face):
    unknowns = Unknowns(SPEC, face)
    rng = np.random.default_rng(1)
    values = rng.standard_normal(len(unknowns))
    values[-10:] = 0.0  # the whole object's
    scene, design = unknowns.assembly(values).scene, unknowns.design.scene
    other = design.magnets.face != face
    assert_allclose(scene.magnets.centre_mm[other], design.magnets.centre_mm[other])
    assert_allclose(scene.magnets.strength[other], design.magnets.strength[other])
    assert abs(scene.magnets.centre_mm[~other] - design.magnets.centre_mm[~other]).min() > 0
    sensors = design.sensors.face != face
    assert_allclose(scene.sensors.position_mm[sensors], design.sensors.position_mm[sensors])
    assert_allclose(scene.chips.matrix[sensors], design.chips.matrix[sensors])


def linear(matrix, most=np.inf):
    """Signals are a matrix times the numbers, up to where there is no object."""

    def expected(numbers):
        signals = matrix @ numbers
        return signals if numbers.max() <= most else np.full_like(signals, np.nan)

    return expected


def white(residual):
    return residual / 0.04


def test_of_linear_mechanics_the_most_probable_numbers_are_the_posterior_mean():
    rng = np.random.default_rng(3)
    matrix = rng.normal(size=(5, 4, 3))
    counts = matrix @ [0.5, -1.0, 0.2] + 0.2 * rng.normal(size=(5, 4))
    rows = matrix.reshape(20, 3)
    precision = np.eye(3) + rows.T @ rows / 0.04
    mean = np.linalg.solve(precision, rows.T @ counts.ravel() / 0.04)
    found, there, jacobian = most_probable(linear(matrix), white, counts, np.zeros(3))
    assert_allclose(found, mean, rtol=1e-6)
    assert_allclose(there, matrix @ mean)
    assert_allclose(jacobian, matrix, rtol=1e-6)
    told, pull = normal_equations(white, jacobian, counts)
    assert_allclose(told, precision, rtol=1e-6)
    assert_allclose(pull, precision @ mean, rtol=1e-6)


def test_numbers_go_no_farther_than_they_may_and_slopes_are_taken_where_there_is_an_object():
    matrix = np.ones((1, 1, 1))
    far, *_ = most_probable(linear(10 * matrix), white, np.array([[99.0]]), np.zeros(1))
    assert_allclose(far, FARTHEST)
    edge = linear(matrix, most=0.5)
    assert_allclose(jacobian_of(edge, np.array([0.5]), np.array([[0.5]])), 1.0)
    assert_allclose(jacobian_of(linear(matrix), np.array([FARTHEST]), np.array([[FARTHEST]])), 1.0)
    short, *_ = most_probable(edge, white, np.array([[2.0]]), np.zeros(1))
    assert 0.2 < short[0] <= 0.5

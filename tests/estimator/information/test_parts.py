"""Parts of scores worked out by hand: blind directions, nearest forces, areas, thirds, false readings."""

from types import SimpleNamespace

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from estimator.information import cross_face, fisher, identifiability, scores, weak_areas
from estimator.information.fisher import cramer_rao_bounds
from estimator.information.slip_cost import false_reading


def test_bounds_are_those_of_the_inverse_information_and_in_words_what_is_blind():
    rng = np.random.default_rng(0)
    jacobian = rng.normal(size=(3, 6, 5)) * [1.0, 2, 30, 0.1, 5]
    jacobian[1, :, 3] = 0.0
    jacobian[2, :, 1] = 0.5 * jacobian[2, :, 0]
    sigma = rng.uniform(0.5, 2, 6)
    found = cramer_rao_bounds(jacobian, sigma)
    information = (jacobian[0] / sigma[:, None]).T @ (jacobian[0] / sigma[:, None])
    covariance = np.linalg.inv(information)
    assert_allclose(found.position_mm2[0], covariance[:2, :2], rtol=1e-6)
    assert_allclose(found.position_mm[0], np.sqrt(covariance[0, 0] + covariance[1, 1]))
    assert_allclose(found.force_n[0], np.sqrt(covariance[2, 2]))
    assert_allclose(found.tangential_force_n[0], np.sqrt(covariance[3, 3] + covariance[4, 4]))
    values, vectors = np.linalg.eigh(covariance[:2, :2])
    assert abs(found.weakest_direction[0] @ vectors[:, values.argmax()]) == pytest.approx(1.0)
    assert found.rank.tolist() == [5, 4, 4]
    assert np.isnan(found.blind_direction[0]).all()
    assert [found.status(0), found.status(1)] == [
        "ok",
        f"blind to 1 of 5 parameters: along (x force {found.blind_direction[1, 3]:+.2g})",
    ]
    assert abs(found.blind_direction[1, 3]) == pytest.approx(1.0)
    assert np.isfinite([found.position_mm[1], found.force_n[1]]).all()
    assert np.isinf(found.tangential_force_n[1])
    blind = found.blind_direction[2]
    assert_allclose(abs(blind[:2]), np.array([1, 2]) / np.sqrt(5), atol=1e-6)
    assert blind[0] * blind[1] < 0
    assert np.isinf(found.position_mm[2])
    assert np.isfinite(found.force_n[2])
    assert np.isnan(found.position_mm2[2]).all()
    assert_allclose(abs(found.weakest_direction[2]), np.array([1, 2]) / np.sqrt(5), atol=1e-6)


def test_three_channels_and_three_parameters_have_no_tangential_bound():
    found = cramer_rao_bounds(np.eye(3)[None] * [[[1.0, 2, 4]]], np.ones(3))
    assert_allclose(found.position_mm, np.sqrt(1 + 1 / 4))
    assert_allclose(found.force_n, 1 / 4)
    assert np.isnan(found.tangential_force_n).all()
    few = cramer_rao_bounds(np.ones((1, 2, 3)), np.ones(2))
    assert few.rank.tolist() == [1]
    assert few.status(0).startswith("blind to 2 of 3 parameters")


def test_the_nearest_force_is_that_of_the_foot_on_the_nearest_curve():
    """Curves along two channels: the second bends at 2 N; points before, beside and beyond them."""
    curve = np.array([[[0.0, 0], [4, 0], [8, 0]], [[0, 0], [0, 2], [3, 2]]])
    force = np.array([[0.0, 1.0, 5.0], [0.0, 2.0, 8.0]])
    points = np.array([[3.0, -1.0], [6.0, 0.5], [-1.0, -1.0], [99.0, 0.0], [0.1, 1.0], [1.0, 2.5]])
    nearest_force_n = cross_face.nearest_press(points, curve, force)[0]
    assert_allclose(nearest_force_n, [0.75, 3.0, 0.0, 5.0, 1.0, 4.0])


def test_columns_of_information_are_contact_by_contact():
    rng = np.random.default_rng(1)
    whitened = rng.normal(size=(2, 9, 6))
    found = identifiability.set_information(whitened)
    for row in range(2):
        covariance = np.linalg.inv(whitened[row].T @ whitened[row])
        variance = np.diag(covariance).reshape(2, 3)
        assert_allclose(found.position_bound_mm[row], np.sqrt(variance[:, :2].sum(axis=1)))
        assert_allclose(found.force_bound_n[row], np.sqrt(variance[:, 2]))
        singular = np.linalg.svd(whitened[row], compute_uv=False)
        assert found.condition[row] == pytest.approx(singular[0] / singular[-1])
        assert found.resolved[row] == np.sum(singular > 1)
    assert found.rank.tolist() == [6, 6]


def judged(channels, spec, whitened, sets):
    faces = tuple(
        identifiability.FaceJacobians(number, part, part[:, 3 * row : 3 * row + 3])
        for row, (number, part) in enumerate(zip((3, 5), whitened, strict=True))
    )
    return identifiability.judge_sets.__wrapped__(spec, faces, np.arange(2), sets, 1, channels)


def test_a_judgement_tells_ranks_of_sets_that_exist(monkeypatch):
    """One contact at two places of two faces, with three own channels of six."""
    monkeypatch.setattr(
        identifiability, "contact_grid", lambda spec: SimpleNamespace(xy_mm=np.eye(2))
    )
    monkeypatch.setattr(identifiability, "worst_set", lambda *given: "worst")
    monkeypatch.setattr(identifiability, "Identifiability", lambda *given: given)
    spec = SimpleNamespace(limits=SimpleNamespace(position_bound_mm=0.8))
    gains = np.array([[1.0, 2.0], [4.0, 0.0]])
    whitened = np.zeros((2, 2, 6, 3))
    for face in range(2):
        for place in range(2):
            whitened[face, place, 3 * face : 3 * face + 3] = gains[face, place] * np.eye(3)
    found = judged("own", spec, whitened, np.array([[0], [1]]))
    assert found[:8] == (1, 1, "own", 3, 3, 4, 0, 1.5)
    root = np.sqrt(2)
    assert_allclose(found[8], 1.0)  # condition numbers 1, 1, 1 and infinite
    assert_allclose(found[9:12], [root / 4, root / 2, np.inf])
    assert_allclose(found[12], 0.5)
    assert_allclose(found[13], 0.5)
    whole = judged("all", spec, whitened, np.array([[0], [1]]))
    assert whole[4] == 6


def test_values_stand_at_the_places_that_a_face_has():
    places = np.array([[True, False, True], [False, True, False]])
    found = scores.fill_places(places, [np.array([1.0, 2.0]), np.array([3.0])])
    assert_array_equal(found, [[1, np.nan, 2], [np.nan, 3, np.nan]])
    flags = scores.fill_places(places, [np.array([True, False]), np.array([True])])
    assert flags.tolist() == [[True, False, False], [False, True, False]]
    vectors = scores.fill_places(places, [np.ones((2, 4)), np.ones((1, 4))])
    assert vectors.shape == (2, 3, 4)


@pytest.mark.parametrize(
    ("values", "groups"),
    [
        ([1, 2, 3, 4, 5, 6], [[0, 1], [2, 3], [4, 5]]),
        ([5, 5, 1, 5, 9, 5], [[2], [0, 1, 3, 5], [4]]),
        ([1, 2, 2, 2, 2, 3], [[0], [1, 2, 3, 4], [5]]),
        ([1, 1, 1, 2], [[0, 1, 2], [3]]),
        ([4, 3, 2, 1, 1, 1, 1, 1, 1], [[3, 4, 5, 6, 7, 8], [0, 1, 2]]),
        ([1.000001, 1.000002, 2, 3, 4], [[0, 1], [2], [3, 4]]),
    ],
)
def test_thirds_keep_equal_values_together(values, groups):
    found = weak_areas.thirds_of(np.array(values, float))
    assert [np.flatnonzero(some).tolist() for some in found] == groups


def test_a_residual_is_read_as_weighted_least_squares_say():
    rng = np.random.default_rng(2)
    jacobian, sigma = rng.normal(size=(2, 6, 3)) * [1, 2, 9], rng.uniform(0.5, 3, 6)
    residual = rng.normal(size=(2, 6))
    place, force = false_reading(jacobian, residual, sigma)
    for row in range(2):
        white = jacobian[row] / sigma[:, None]
        error = np.linalg.lstsq(white, residual[row] / sigma, rcond=None)[0]
        assert_allclose(place[row], np.hypot(*error[:2]))
        assert_allclose(force[row], abs(error[2]))


def test_a_force_is_detectable_where_the_distance_is_reached_and_never_beyond_the_deepest_press():
    from estimator.signals.interpolation import Traces

    force = np.array([[0.0, 2.0, 4.0], [0.0, 1.0, 2.0]])
    counts = np.stack([3 * force, 4 * force], axis=-1)
    traces = Traces(np.arange(3.0), force, counts, np.zeros((2, 3), bool))
    found = fisher.detectable_force_n(traces, np.ones(2))
    assert_allclose(found, [1.0, 1.0], rtol=1e-6)  # 5 counts a newton, and 5 are asked for
    assert_allclose(fisher.detectable_force_n(traces, np.ones(2), 12.5), [2.5, np.inf], rtol=1e-6)
    at_the_end = [fisher.detectable_force_n(traces, np.ones(2), 5 * n)[0] for n in (3.9, 3.98, 4.0)]
    assert_allclose(at_the_end, [3.9, 3.98, 4.0], rtol=1e-6)

"""A planted convention or assembly is found in resting levels; nothing is found in noise."""

from itertools import permutations

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError
from design.spec.object import ObjectSpec
from studies.recorded import resting_conventions
from studies.recorded.convention_search import TURNS
from studies.recorded.resting_conventions import (
    RestingObject,
    common_fits,
    search_resting,
)

CUBE = ObjectSpec(name="cube")
FACES = 5


@pytest.fixture(scope="module")
def cube():
    return RestingObject(CUBE)


def boards(levels):
    return levels.reshape(FACES, 3, 3)


@pytest.mark.parametrize(
    ("exchange", "order", "turn"),
    [((0, 1, 2, 3, 4), (0, 1, 2), 0), ((2, 1, 0, 3, 4), (1, 2, 0), 7)],
)
def test_a_planted_convention_is_found_beside_noise(cube, exchange, order, turn):
    rng = np.random.default_rng(0)
    predicted = cube.designed_counts
    read = np.empty((FACES, 3, 3))
    read[:, list(order)] = boards(predicted)[list(exchange)] @ TURNS[turn].T
    levels = read.ravel() + 500 * rng.standard_normal(45)
    found = search_resting(predicted, levels, FACES, 49, seed=1)
    assert found.candidates == 120 * 6 * 24
    assert found.found > 0.9
    assert found.p == 1 / 50
    put_right = np.einsum("fca,ab->fcb", read[:, list(order)], TURNS[turn])
    assert_allclose(put_right, boards(predicted)[list(exchange)])
    if not any((*found.best,)):
        assert found.documented == found.found
        assert found.p_documented == 1 / 50
    else:
        assert found.documented < found.found - 0.3


def test_levels_that_are_noise_are_as_good_as_exchanged_ones(cube):
    levels = 1000 * np.random.default_rng(4).standard_normal(45)
    found = search_resting(cube.designed_counts, levels, FACES, 39, seed=1)
    assert found.p > 0.05
    assert found.found == pytest.approx(found.null_median, abs=0.12)


def test_chips_that_do_not_answer_count_nothing(cube):
    predicted = cube.designed_counts
    levels = predicted.copy()
    levels[9:12] = 1e4
    assert search_resting(predicted, levels, FACES, 1, seed=1).documented < 0.6
    levels[10] = np.nan
    found = search_resting(predicted, levels, FACES, 1, seed=1)
    assert found.documented == pytest.approx(1)
    assert found.best == (0, 0, 0)


def test_numbers_common_to_all_faces_are_found_and_hold_on_faces_that_were_not_fitted(cube):
    levels = cube.counts(np.array([np.log(0.7), 0.8, 0, 0, 0, 0, 0, 0]))
    levels[3] = np.nan
    names = "nothing", "strength, depth"
    fits = {fit.name: fit for fit in common_fits(CUBE, levels, FACES, names)}
    assert fits["nothing"].left == fits["nothing"].left_elsewhere > 0.4
    both = fits["strength, depth"]
    assert both.left < 0.02
    assert both.left_elsewhere < 0.03
    assert both.cosine_elsewhere > 0.999
    assert_allclose(both.numbers[:2], [np.log(0.7), 0.8], atol=0.06)
    assert both.numbers[2:] == (0,) * 6


def test_a_pose_of_the_core_is_found(cube):
    true = np.array([0, 0, 0.4, -0.3, 0.5, 1.0, -2.0, 1.5])
    (fit,) = common_fits(CUBE, cube.counts(true), FACES, ("core",))
    assert_allclose(fit.numbers, true, atol=0.15)
    assert fit.left_elsewhere < 0.1


def test_noise_is_explained_by_nothing_on_faces_that_were_not_fitted():
    levels = 1000 * np.random.default_rng(5).standard_normal(45)
    for fit in common_fits(CUBE, levels, FACES, ("depth", "strength, depth")):
        assert fit.left_elsewhere > 0.98, fit.name


def test_what_cannot_be_searched_is_refused():
    with pytest.raises(InputError, match="fewer chips"):
        search_resting(np.ones(6 * 5 * 3), np.ones(6 * 5 * 3), 6, 1, 0)
    shell = CUBE.model_copy(update={"arrangement": "sensors-in-shell"})
    with pytest.raises(InputError, match="in the shell"):
        list(common_fits(shell, np.ones(45), FACES))


def test_the_best_candidate_is_told_by_its_numbers_and_the_documented_one_by_its_own_null():
    """A convention off all symmetries; the null of the documented one without any search, by hand."""
    rng = np.random.default_rng(6)
    predicted, read = rng.normal(0, 900, 27), np.empty((3, 3, 3))
    exchange, order, turn = (2, 0, 1), (1, 2, 0), 7
    read[:, list(order)] = predicted.reshape(3, 3, 3)[list(exchange)] @ TURNS[turn].T
    levels = read.ravel() + 500 * rng.standard_normal(27)
    found = search_resting(predicted, levels, 3, 19, seed=3)
    orders = list(permutations(range(3)))
    assert found.best == (orders.index(exchange), orders.index(order), turn)
    for mixed in (levels, levels + 0.4 * predicted, levels + 0.6 * predicted):
        found = search_resting(predicted, mixed, 3, 19, seed=3)
        draw = np.random.default_rng((3, 12))
        null = np.array([predicted @ mixed[draw.permutation(27)] for _ in range(19)])
        p = (1 + np.sum(null >= predicted @ mixed)) / 20
        assert found.p_documented == pytest.approx(p)


@pytest.mark.parametrize(("apart", "asked"), [(20.0, 20 - 3 - 3 * np.sqrt(3)), (6.0, 1.0)])
def test_the_field_is_right_as_near_as_the_bounds_may_bring_a_magnet(monkeypatch, apart, asked):
    """3 mm inwards, and 3 mm along each axis of a shifted core; 1 mm at least."""
    monkeypatch.setattr(resting_conventions, "min_distance_mm", lambda *given: apart)
    monkeypatch.setattr(resting_conventions, "zero_motion", lambda place: None)
    monkeypatch.setattr(
        resting_conventions, "magnets_model", lambda magnets, nearest_mm: nearest_mm
    )
    assert resting_conventions.near_model.__wrapped__(CUBE, None) == pytest.approx(asked)

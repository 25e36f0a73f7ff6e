"""Errors of the place: the bound of linear signals, closed forms of lobes, and simulated readers."""

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal
from scipy.stats import norm

from estimator.information.fisher import cramer_rao_bounds
from estimator.information.position_error import position_errors_mm
from estimator.information.rival_presses import RivalPresses
from estimator.information.scores import score_places
from estimator.signals.presses import press_signals
from tests.support.maximum_likelihood import FaceReader, simulated_errors_mm
from tests.support.mechanics.synthetic_presses import coarse_spec, synthetic_presses

FORCE_N = np.array([2.0, 4.0, 6.0, 8.0])


def made_rivals(expected, half_mm=(12.0, 12.0), step_mm=1.0):
    """Whitened presses of a made-up face, and the function that gives presses anywhere.

    `expected` gives signals (n, channel) and slopes (n, channel, 3) of contacts (n, 3).
    """
    x, y = (np.arange(-half, half + 0.1, step_mm) for half in half_mm)
    xy = np.stack(np.meshgrid(x, y, indexing="ij"), axis=-1).reshape(-1, 2)
    contact = np.column_stack([np.repeat(xy, len(FORCE_N), axis=0), np.tile(FORCE_N, len(xy))])
    signals, slopes = expected(contact)
    shape = len(xy), len(FORCE_N)
    return RivalPresses(
        xy,
        step_mm,
        FORCE_N,
        np.ones(shape, bool),
        signals.reshape(*shape, -1),
        slopes.reshape(*shape, *slopes.shape[1:]),
    )


def error_and_bound(expected, contact, **face):
    signals, slopes = expected(contact)
    error = position_errors_mm(made_rivals(expected, **face), contact[:, :2], signals, slopes)
    return error, cramer_rao_bounds(slopes, np.ones(signals.shape[1])).position_mm


def linear(sharpness):
    """Signals linear in place and force, sharp along 30° from x and weak across; larger is sharper."""
    c, s = np.cos(np.pi / 6), np.sin(np.pi / 6)
    matrix = np.random.default_rng(3).normal(size=(7, 3)) * [1.2, 0.4, 1.5] * sharpness
    matrix = matrix @ np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]])
    return lambda contact: (contact @ matrix.T, np.broadcast_to(matrix, (len(contact), 7, 3)))


def helix(radius, period_mm, rise):
    """x turns the signals round, period by period, each `rise` farther on; y and force are linear."""

    def expected(contact):
        x, y, force = contact.T
        turn = 2 * np.pi / period_mm
        c, s = radius * np.cos(turn * x), radius * np.sin(turn * x)
        one, none = np.ones_like(x), np.zeros_like(x)
        signals = np.column_stack([c, s, rise / period_mm * x, 2 * y, force])
        slopes = [[-turn * s, none, none], [turn * c, none, none]]
        slopes += [[rise / period_mm * one, none, none], [none, 2 * one, none], [none, none, one]]
        return signals, np.moveaxis(np.array(slopes), 2, 0)

    return expected


def fold(bend, slope):
    """x folds the signals over at 0: a parabola with a weak slope; y and force are linear."""

    def expected(contact):
        x, y, force = contact.T
        one, none = np.ones_like(x), np.zeros_like(x)
        signals = np.column_stack([bend * x**2, slope * x, 2 * y, force])
        slopes = [[2 * bend * x, none, none], [slope * one, none, none]]
        slopes += [[none, 2 * one, none], [none, none, one]]
        return signals, np.moveaxis(np.array(slopes), 2, 0)

    return expected


@pytest.mark.parametrize("sharpness", [0.3, 0.6, 1.0, 2.0, 20.0])
def test_of_linear_signals_the_error_is_the_bound(sharpness):
    contact = np.array([[0.0, 0.0, 5.0], [1.3, -2.4, 3.0], [3.5, 2.0, 7.3]])
    error, bound = error_and_bound(linear(sharpness), contact, half_mm=(16, 16))
    assert_allclose(error, bound, rtol=0.05)


@pytest.mark.parametrize("rise", [2.0, 3.0, 4.0, 5.0])
def test_of_two_lobes_the_error_is_that_of_mistaking_one_for_the_other(rise):
    """Half of the way between them is `rise` / 2 standard deviations: the closed form of two hypotheses."""
    contact = np.array([[-6.0, 0.0, 5.0]])
    error, bound = error_and_bound(helix(30.0, 12.0, rise), contact)
    mistaken = norm.sf(rise / 2)
    assert_allclose(error, np.sqrt(bound**2 + mistaken * 12.0**2), rtol=0.05)
    assert error[0] > 2 * bound[0]


def test_lobes_that_noise_does_not_reach_leave_the_bound():
    contact = np.array([[-6.0, 0.0, 5.0]])
    error, bound = error_and_bound(helix(30.0, 12.0, 20.0), contact)
    assert_allclose(error, bound, rtol=0.02)


def best_x_mm(expected, contact, draws=4000, half_mm=12.0):
    """x that maximum likelihood reads where y and force are linear and free: by trying all."""
    tried = np.arange(-half_mm, half_mm, 0.02)
    places = np.column_stack([tried, np.full((len(tried), 2), contact[1:])])
    free = expected(places)[0][:, :-2]
    noise = np.random.default_rng(5).standard_normal((draws, free.shape[1]))
    frames = expected(contact[None])[0][0, :-2] + noise
    return tried[((free**2).sum(axis=1) - 2 * frames @ free.T).argmin(axis=1)]


@pytest.mark.parametrize(
    ("expected", "x_mm", "times"),
    [
        (fold(0.15, 0.15), 3.0, 2.0),
        (fold(0.1, 0.3), 4.0, 1.3),
        (fold(0.1, 0.3), -4.0, 1.3),
        (helix(4.0, 8.0, 3.0), -4.0, 3.0),
        (helix(4.0, 8.0, 5.0), 0.0, 1.3),
    ],
)
def test_the_error_is_what_a_reader_by_force_does_where_signals_fold(expected, x_mm, times):
    contact = np.array([x_mm, 0.0, 5.0])
    read = best_x_mm(expected, contact)
    in_y = 1 / 2
    simulated = np.sqrt(np.mean((read - x_mm) ** 2) + in_y**2)
    error, bound = error_and_bound(expected, contact[None])
    assert simulated > times * bound[0]
    assert_allclose(error[0], simulated, rtol=0.2)


def test_a_reader_that_knows_where_the_face_ends_errs_by_less_than_the_bound():
    """Where the bound is longer than the face: the reader's places are spread over it."""
    error, bound = error_and_bound(linear(0.02), np.array([[0.0, 0.0, 5.0]]), half_mm=(6.0, 6.0))
    assert bound > 40
    assert 3 < error < np.hypot(6, 6)


@pytest.mark.parametrize("y_mm", [11.0, -11.0])
def test_near_a_corner_the_error_is_that_of_the_normal_density_within_the_face(y_mm):
    """The weak axis runs into one corner and past the other; beyond them no place is read."""
    sharp, weak = 0.5, 1.5
    along = np.array([[1.0, 1.0], [1.0, -1.0]]) / np.sqrt(2) / [[weak], [sharp]]
    matrix = np.block([[along, np.zeros((2, 1))], [np.zeros((1, 2)), np.eye(1)]])

    def expected(contact):
        return contact @ matrix.T, np.broadcast_to(matrix, (len(contact), 3, 3))

    error, bound = error_and_bound(expected, np.array([[11.0, y_mm, 5.0]]))
    drawn = np.random.default_rng(6).standard_normal((100_000, 2)) @ np.linalg.inv(along).T
    within = (abs(drawn + np.array([11.0, y_mm])) <= 12.5).all(axis=1)
    assert_allclose(error, np.sqrt((drawn[within] ** 2).sum(axis=1).mean()), rtol=0.04)
    assert error < 0.95 * bound


def test_where_no_place_can_be_told_the_error_is_infinite():
    def blind(contact):
        signals, slopes = linear(1.0)(contact)
        return np.zeros_like(signals), slopes * [0.0, 0.0, 1.0]

    error, bound = error_and_bound(blind, np.array([[0.0, 0.0, 5.0]]))
    assert np.isinf(error)
    assert np.isinf(bound)


def test_many_presses_are_read_as_each_alone_is():
    x = np.linspace(-10, 10, 900)
    contact = np.column_stack([x, 0.2 * x, np.full(900, 5.0)])
    expected = helix(4.0, 8.0, 3.0)
    together, _ = error_and_bound(expected, contact)
    for press in (0, 440, 899):
        assert_allclose(error_and_bound(expected, contact[[press]])[0], together[press], rtol=1e-9)


@pytest.fixture(scope="module")
def spec():
    score = {"force_n": 4.0, "channels": "own"}
    grid = {"count": (8, 8), "pitch_mm": 3.0}
    return coarse_spec(contact_grid=grid, score=score, limits={"use": "bench"})


@pytest.fixture(scope="module")
def signals(spec):
    return press_signals(spec, *synthetic_presses(spec))


@pytest.mark.parametrize("force_n", [3.0, pytest.param(5.0, marks=pytest.mark.slow)])
def test_errors_of_an_object_are_those_of_a_simulated_reader_and_bounds_are_not(
    spec, signals, force_n
):
    """Twelve places of one face, the weakest of its border among them; 100 fixed draws, which scatter by
    10 %."""
    scores = score_places(spec.changed(score=spec.score.changed(force_n=force_n)), signals)
    error, bound = scores.position_error_mm[2], scores.position_bound_mm[2]
    order = np.argsort(error / bound)
    places = [*order[-6:], *order[:: len(order) // 6][:6]]
    contact = np.column_stack([scores.grid.xy_mm[places], np.full(12, force_n)])
    reader, rng = FaceReader(spec, signals, 3), np.random.default_rng(11)
    read, scatter, _ = simulated_errors_mm(reader, contact, 100, rng)
    assert np.mean(scatter / read) < 0.12
    error_off, bound_off = (np.log(values[places] / read) for values in (error, bound))
    assert np.sqrt(np.mean(error_off**2)) < 0.2
    assert np.sqrt(np.mean(bound_off**2)) > 0.4


def test_scores_say_where_the_bound_is_too_good(spec, signals):
    scores = score_places(spec, signals)
    beyond = scores.position_error_mm > 1.2 * scores.position_bound_mm
    assert_array_equal(scores.misread, beyond)
    assert 10 < beyond.sum() < 100
    row, place = np.unravel_index(
        np.argmax(np.where(beyond, scores.position_error_mm, 0)), beyond.shape
    )
    x, y = scores.grid.xy_mm[place]
    said = scores.exceeds_bound
    assert said.startswith(f"At {beyond.sum()} of 320 contact locations")
    assert f"most on face {scores.faces[row]} at ({x:g}, {y:g}) mm: " in said
    assert f"{scores.position_error_mm[row, place]:.2g} mm, bound " in said
    few = coarse_spec(score={"force_n": 8.0})
    nowhere = score_places(few, press_signals(few, *synthetic_presses(few)))
    assert not nowhere.exceeds_bound
    ratio = nowhere.position_error_mm / nowhere.position_bound_mm
    assert 0.9 < ratio.min() < ratio.max() < 1.03  # lobes narrower than the lattice among them


def test_places_that_are_not_judged_have_no_error(spec, signals):
    harder = spec.changed(score=spec.score.changed(force_n=24.0))
    scores = score_places(harder, signals)
    assert 0 < scores.judged.sum() < scores.judged.size
    assert_array_equal(np.isnan(scores.position_error_mm), ~scores.judged)

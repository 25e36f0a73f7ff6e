"""Presses that would explain what a set of contacts leaves over, against least squares by hand."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from estimator.inversion.model.dictionary import Dictionary, probe_shapes, probe_tips_mm
from estimator.inversion.model.forward import NONE
from estimator.inversion.model.whitening import whitening
from estimator.inversion.priors import Priors

CHANNELS = 12
RNG = np.random.default_rng(5)
PLACES = np.array([[0.0, 0], [5.9, 0], [6.0, 0], [0, 5], [0, 0]])


def book():
    """Five presses of one tip at 2 N, the last on another face, and one of a probe of two."""
    contact = np.zeros((6, 2, 3))
    contact[:5, 0, :2] = PLACES
    contact[5, :, :2] = [[-5.0, 0], [5.0, 0]]
    contact[..., 2] = 2.0
    face, tips = np.array([0, 0, 0, 0, 1, 0]), np.array([1, 1, 1, 1, 1, 2])
    return Dictionary(face, tips, contact, RNG.normal(size=(6, CHANNELS)).astype(np.float32))


class Level:
    """Two problems: one without contacts, one with a contact on each face."""

    frame = np.array([1, 0])
    face = np.array([[NONE, NONE, NONE], [0, 1, NONE]])
    number = np.array([0, 2])
    contact = np.arange(18.0).reshape(2, 3, 3)
    extra = 0.1 * np.random.default_rng(6).normal(size=(2, CHANNELS))

    def __len__(self):
        return 2


class Seen:
    counts = np.random.default_rng(7).normal(size=(2, CHANNELS))
    sigma = np.random.default_rng(8).uniform(0.5, 2.0, (2, CHANNELS))
    columns = np.random.default_rng(10).normal(0, 2.0, (CHANNELS, 3))
    white = whitening(sigma, columns)


class Model:
    channels = CHANNELS
    found = np.random.default_rng(9).normal(size=(2, 2, 4, CHANNELS))

    def singles(self, face, contact):
        values = np.zeros((*face.shape, 4, CHANNELS))
        values[face != NONE] = self.found[: len(face), : face.shape[1]][face != NONE]
        return values


def least(white, columns):
    """Misfit that is left once the columns may explain what they can."""
    if not columns.shape[1]:
        return 0.5 * white @ white
    fitted, *_ = np.linalg.lstsq(columns, white, rcond=None)
    return 0.5 * np.sum((white - columns @ fitted) ** 2)


def test_a_press_gains_what_it_lowers_the_misfit_by_once_own_contacts_may_shift():
    """Its force within 0.3 to 2.5 times the dictionary's."""
    made, level = book(), Level()
    gain, scale = made.gains_of.__wrapped__(made, Model(), Seen(), level)
    for row, frame in enumerate(level.frame):
        own = level.number[row]
        singles = Model().singles(level.face[row : row + 1, :2], None)[0] if own else None
        if own:
            singles = Model.found[row]
        left = Seen.counts[frame] - level.extra[row] - (singles[:, 0].sum(axis=0) if own else 0)
        covariance = np.diag(Seen.sigma[frame] ** 2) + Seen.columns @ Seen.columns.T
        unit = np.linalg.inv(np.linalg.cholesky(covariance))
        white = unit @ left
        columns = np.zeros((CHANNELS, 0))
        if own:
            columns = unit @ singles[:, 1:].reshape(6, CHANNELS).T
        before = least(white, columns)
        for press, counts in enumerate(made.counts):
            shown = unit @ counts
            costs = [least(white - size * shown, columns) for size in np.linspace(0.3, 2.5, 441)]
            assert_allclose(gain[row, press], before - min(costs), atol=2e-3)
            assert_allclose(
                scale[row, press], np.linspace(0.3, 2.5, 441)[np.argmin(costs)], atol=6e-3
            )


def test_presses_are_one_start_within_6_mm_on_their_face_and_of_as_many_tips():
    near = book().near_rows(np.array([0, 4, 5]))
    assert near[0].tolist() == [True, True, False, True, False, False]
    assert near[1].tolist() == [False, False, False, False, True, False]
    assert near[2].tolist() == [False] * 5 + [True]


def test_a_press_is_placed_in_the_first_empty_slots_with_its_force_scaled():
    made, level = book(), Level()
    rows, face, contact = Dictionary.placed_sets.__wrapped__(
        made, level, np.array([0, 1]), np.array([5, 3]), np.array([2.0, 0.5])
    )
    assert rows.tolist() == [0, 1]
    assert face.tolist() == [[0, 0, NONE], [0, 1, 0]]
    assert_allclose(contact[0, :2], [[-5, 0, 4], [5, 0, 4]])
    assert_allclose(contact[1], [*level.contact[1, :2], [0, 5, 1]])
    assert (level.face[0] == NONE).all()


def test_sets_grow_by_the_best_presses_that_stand_apart_and_find_room(monkeypatch):
    made, level = book(), Level()
    gain = np.array([[5.0, 4.0, 3.0, 2.0, 1.0, 6.0], [1.0, 2.0, 4.0, -1.0, 3.0, 9.0]])
    monkeypatch.setattr(Dictionary, "placed_sets", Dictionary.placed_sets.__wrapped__)
    monkeypatch.setattr(Dictionary, "gains_of", lambda *given: (gain.copy(), np.ones_like(gain)))
    rows, faces, contacts = made.added.__wrapped__(made, Model(), Seen(), level, False)
    of = [
        [contacts[k, level.number[r]].tolist()[:2] for k in np.flatnonzero(rows == r)]
        for r in (0, 1)
    ]
    assert of[0] == [[0, 0], [6, 0], [0, 0], [-5, 0]]
    assert [face[0] for face in faces[rows == 0]] == [0, 0, 1, 0]
    assert of[1] == [[6, 0], [0, 0], [0, 0]], (
        "not the probe of two, and nothing that gains less than 0"
    )
    gain[1, 5] = 9.0
    rows, faces, _ = made.added.__wrapped__(made, Model(), Seen(), level, True)
    assert 1 not in rows, "both faces have their probe"


def test_probes_are_turned_by_eighths_of_what_makes_them_alike():
    priors = Priors((0.5, 0.5), 1, 100.0, (0.0, 1.0), spacing_mm=(15.0, 20.0))
    found = probe_shapes(priors)
    assert found[0] == (1, 0.0)
    assert found[1:9] == [(2, pytest.approx(np.pi * k / 8)) for k in range(8)]
    assert found[9:] == [(3, pytest.approx(2 * np.pi / 3 * k / 8)) for k in range(8)]
    assert_allclose(probe_tips_mm(1, 0.3, priors), [[0, 0]])
    two = probe_tips_mm(2, np.pi / 2, priors)
    assert_allclose(two, [[0, -7.5], [0, 7.5]], atol=1e-9)
    three = probe_tips_mm(3, 0.4, priors)
    assert_allclose(np.linalg.norm(three - np.roll(three, 1, axis=0), axis=1), 20)
    assert_allclose(np.arctan2(*three[0][::-1]), np.pi / 2 + 0.4)

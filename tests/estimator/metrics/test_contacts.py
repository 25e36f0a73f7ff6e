"""Found contacts against true ones."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from estimator.frames.windows import chosen_rows
from estimator.inversion.posterior import curvature_at
from estimator.inversion.readings import ContactSets
from estimator.metrics.contacts import contact_rows, matched_contacts, possible_distance_mm
from tests.support.mechanics.inverted import contacts, inverted, labelled_frames


def sets_of(face, xy, force):
    shape = face.shape
    covariance = np.broadcast_to(np.diag([0.04, 0.04, 0.25]), (*shape, 3, 3)).copy()
    pulls, ones = np.full((*shape, 2), np.nan), np.ones(len(face))
    return ContactSets(
        face,
        xy,
        force,
        covariance,
        pulls,
        pulls,
        ones,
        ones,
        np.full(len(ones), -1),
        *[np.zeros((len(ones), 0))] * 2,
        pulls,
        np.full((*pulls.shape, 2), np.nan),
    )


@pytest.fixture(scope="module")
def judged():
    nan = np.nan
    frames = labelled_frames(
        np.array([[3, 3], [3, 5], [3, 0], [0, 0]]),
        np.array([[[0.0, 0], [10, 0]], [[0, 0], [1, 1]], [[5, 5], [nan, nan]], [[nan, nan]] * 2]),
        np.array([[4.0, 5.0], [2.0, 2.5], [6.0, nan], [nan, nan]]),
    )
    found = sets_of(
        np.array([[3, 3], [3, 0], [3, 5], [1, 0]]),
        np.array(
            [[[10.3, 0], [0, 0.4]], [[0, 0], [nan, nan]], [[5, 11.0], [0, 0]], [[0, 0], [nan, nan]]]
        ),
        np.array([[5.5, 4.0], [2.0, nan], [6.0, 1.0], [0.5, nan]]),
    )
    return frames, found, matched_contacts(frames, found)


def test_contacts_are_paired_on_their_own_face_whatever_their_order(judged):
    _, _, matched = judged
    assert_allclose(matched.distance_mm[matched.frame == 0], [0.4, 0.3])
    assert_allclose(matched.force_error_n[matched.frame == 0], [0.0, 0.5])
    assert matched.right.tolist() == [True, False, False, False]
    assert_allclose(matched.total_error_n, [0.5, -2.5, 1.0, 0.5])


def test_a_contact_far_off_is_one_missed_and_a_ghost(judged):
    _, _, matched = judged
    rows = {(row["tips a face"], row["force"]): row for row in contact_rows(matched)}
    one = rows[1, "from 4 N"]  # found 6 mm off, and another on face 5
    assert (one["missed a frame"], one["ghosts a frame"]) == (1.0, 2.0)
    assert rows[2, "from 4 N"]["number right %"] == 100
    assert rows[0, "rest"]["ghosts a frame"] == 1.0
    assert rows[1, "1 to 4 N"]["missed a frame"] == 1.0


def test_regions_hold_what_lies_within_them(judged):
    _, _, matched = judged
    # σ 0.2 mm: a radius of 0.43; σ 0.5 N: half of the interval is 0.82
    assert matched.place_covered.tolist() == [True, True, True, False]
    assert matched.force_covered.all()


def test_the_possible_distance_is_the_mean_of_a_normal_error_of_the_bound():
    estimator = inverted()
    rng = np.random.default_rng(2)
    face, contact = contacts(rng, 6, 2, (3.0, 8.0), slots=2)
    faces = estimator.model.signals.faces
    frames = labelled_frames(faces[face], contact[..., :2], contact[..., 2])
    seen = estimator.disturbances.observed(np.zeros((6, 45)))
    curvature = curvature_at(estimator.model, seen, np.arange(6), face, contact)
    draws = [
        rng.multivariate_normal(np.zeros(6), np.linalg.inv(one), 20_000).reshape(-1, 2, 3)
        for one in curvature
    ]
    mean = [np.linalg.norm(one[..., :2], axis=2).mean() for one in draws]
    assert_allclose(possible_distance_mm(estimator, frames), mean, rtol=0.03)


def test_the_possible_distance_of_one_contact_knows_no_empty_slots():
    estimator = inverted()
    face, contact = contacts(np.random.default_rng(4), 3, 1, (3.0, 8.0), slots=1)
    face, empty = estimator.model.signals.faces[face], np.full((4, 1, 3), np.nan)
    alone = labelled_frames(face, contact[..., :2], contact[..., 2])
    padded = np.concatenate([np.concatenate([contact, empty[:1]]), empty], axis=1)
    beside = labelled_frames(
        np.pad(face, ((0, 1), (0, 1))), padded[..., :2], padded[..., 2]
    )  # the last frame is at rest
    found = possible_distance_mm(estimator, beside)
    assert np.isfinite(found[:3]).all()
    assert_allclose(found, [*possible_distance_mm(estimator, alone), np.nan])


def test_rows_are_chosen_in_order_and_valid(judged):
    frames, _, _ = judged
    frames.valid[1] = False
    assert chosen_rows(frames, 10).tolist() == [0, 2, 3]
    assert len(chosen_rows(frames, 2)) == 2
    frames.valid[1] = True

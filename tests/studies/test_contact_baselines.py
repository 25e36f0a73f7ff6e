"""Plain readers of contacts: pursuit of made-up presses, patches of heatmaps."""

from types import SimpleNamespace

import numpy as np
from numpy.testing import assert_allclose, assert_array_equal

from estimator.frames.dataset import FrameSet
from estimator.networks import face_model
from studies.paper import contact_baselines

NAN = np.nan


def frames(face, xy, force, valid):
    count = len(face)
    force_n = np.full((count, len(face[0]), 3), NAN)
    force_n[..., 2] = force
    return FrameSet(
        np.zeros((count, 2, 1, 3)), np.array(face), np.array(xy, float), force_n, np.array(valid),
        np.zeros(count, int), np.zeros(count, int), np.zeros(count, int), np.arange(count) / 10.0,
        np.array([2, 5]), np.zeros(1), np.zeros(1), np.ones(3), "simulated", "x", 0,
    )  # fmt: skip


def test_sets_of_any_number_have_as_many_slots_as_the_largest():
    found = contact_baselines.contact_sets_of([[], [(3, 1.0, 2.0, 4.0), (5, 0.0, -1.0, 2.0)]])
    assert_array_equal(found.face, [[0, 0], [3, 5]])
    assert_array_equal(found.xy_mm[1], [[1, 2], [0, -1]])
    assert_array_equal(found.force_n, [[NAN, NAN], [4, 2]])
    assert contact_baselines.contact_sets_of([[], []]).face.shape == (2, 1)


class Object(SimpleNamespace):
    """Four presses at 2 N of two faces, six channels of noise 0.1 or 0.2."""

    sigma = np.array([0.1, 0.1, 0.1, 0.2, 0.2, 0.2])
    counts = np.array(
        [[1.0, 0, 0, 0, 0, 0], [0, 2, 0, 0, 0, 0], [0, 0, 1, 1, 0, 0], [0, 0, 0, 0, 3, 1]]
    )


def pursued(seen, most=3):
    contact = np.zeros((4, 1, 3))
    contact[:, 0] = [[1, 2, 2], [3, 4, 2], [5, 6, 2], [7, 8, 2]]
    presses = SimpleNamespace(
        counts=Object.counts.astype(np.float32), face=np.array([0, 0, 1, 1]), contact=contact
    )
    seen = np.atleast_2d(seen)
    observed = SimpleNamespace(counts=seen, sigma=np.tile(Object.sigma, (len(seen), 1)))
    inversion = SimpleNamespace(
        search=SimpleNamespace(dictionary=presses),
        model=SimpleNamespace(signals=SimpleNamespace(faces=np.array([2, 5]))),
        disturbances=SimpleNamespace(observed=lambda counts: observed),
        priors=SimpleNamespace(most=most),
    )
    given = frames(
        [[0]] * len(seen), [[[NAN, NAN]]] * len(seen), [[NAN]] * len(seen), [True] * len(seen)
    )
    return contact_baselines.pursued.__wrapped__(inversion, given)


def test_pursuit_finds_the_presses_that_make_up_a_frame_and_their_forces():
    one, two = 1.5 * Object.counts[1], 0.5 * Object.counts[2] + 2 * Object.counts[3]
    found = pursued(np.stack([one, two, 0 * one]))
    assert_array_equal(np.sort(found.face, axis=1), [[0, 2], [5, 5], [0, 0]])
    assert_allclose(found.xy_mm[0, 0], [3, 4])
    assert_allclose(found.force_n[0, 0], 3.0, rtol=1e-6)
    places = {tuple(xy): n for xy, n in zip(found.xy_mm[1].tolist(), found.force_n[1], strict=True)}
    assert_allclose([places[5.0, 6.0], places[7.0, 8.0]], [1.0, 4.0], rtol=1e-6)


def test_pursuit_ends_where_a_press_gains_less_than_chance_or_all_are_found():
    """A press must lower χ² by 3 ln 6 = 5.4: a change of 2.32 σ of one channel is not enough."""
    assert pursued([0.231, 0, 0, 0, 0, 0]).face.tolist() == [[0]]
    assert pursued([0.233, 0, 0, 0, 0, 0]).face.tolist() == [[2]]
    assert pursued(Object.counts.sum(axis=0), most=2).face.shape == (1, 2)


def test_patches_of_a_heatmap_are_contacts_at_their_centres(monkeypatch):
    maps = np.zeros((3, 4, 5))
    maps[1, 0, 0], maps[1, 0, 1] = 1.0, 3.0
    maps[1, 2, 4], maps[1, 3, 3] = 2.0, 2.0  # touching at a corner: one patch
    maps[2, 1, 1] = 0.89
    monkeypatch.setattr(face_model, "predict_heatmaps", lambda model, given: maps)
    model = SimpleNamespace(
        face=4, grid_x_mm=np.array([-6.0, -2, 2, 6]), grid_y_mm=np.array([-8.0, -4, 0, 4, 8])
    )
    found = contact_baselines.patches.__wrapped__([(model, 1.0)], None, np.array([0, 1, 2]))
    assert_array_equal(found.face, [[0, 0], [4, 4], [0, 0]])
    assert_allclose(found.xy_mm[1], [[-6, -8 + 0.75 * 4], [4, 6]])
    assert_allclose(found.force_n[1], [4, 4])
    both = contact_baselines.patches.__wrapped__([(model, 0.98), (model, 9.0)], None, np.array([2]))
    assert both.force_n.tolist() == [[0.89]]

"""Tables of presses with places left out: continued for splines, never read beyond what was pressed."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError
from design.layout.places.contact_grid import contact_grid
from design.layout.places.contact_places import contact_places, pressed_nodes
from design.spec.object import ObjectSpec
from estimator.frames.press_protocol import REST_PLACE_ID, nominal_peaks, simulate_presses
from estimator.information.cross_face import cross_face_disturbance
from estimator.information.scores import (
    load_scores_csv,
    save_scores_csv,
    score_places,
    weakest_place,
)
from estimator.signals.continuation import continued
from estimator.signals.interpolation import press_traces, signal_gradient
from estimator.signals.presses import press_signals
from tests.support.mechanics.synthetic_presses import synthetic_presses

BOX = ObjectSpec.model_validate(
    {
        "name": "box",
        "body": {"size_mm": (44.0, 36.0, 28.0)},
        "contact_grid": {"count": "fill", "pitch_mm": 4.0},
        "press": {"depths_mm": (0.5, 1.0, 2.0, 3.0)},
        "score": {"force_n": 5.0},
        "protocol": {"presses_per_place": 3, "frames_per_press": (8, 6)},
    }
)


def masked(values, places):
    left = values.copy()
    left[~places] = np.nan
    return left


@pytest.fixture(scope="module")
def whole():
    """Presses everywhere on the lattice, and their signals."""
    presses = synthetic_presses(BOX)
    return *presses, press_signals(BOX, *presses)


@pytest.fixture(scope="module")
def motions(whole):
    """The same with what the faces have not left out."""
    forces, moved, _ = whole
    there = pressed_nodes(BOX)
    forces = replace(forces, force_n=masked(forces.force_n, there))
    return forces, replace(moved, motion=masked(moved.motion, there))


@pytest.fixture(scope="module")
def signals(motions):
    return press_signals(BOX, *motions)


def test_parabolas_go_on_as_parabolas():
    x, y = np.meshgrid(np.arange(9.0), np.arange(7.0), indexing="ij")
    values = np.stack([1 + 2 * x - y + 0.3 * x**2 + x * y, y**2 - 3 * x], axis=-1).reshape(-1, 2)
    pressed = ((x - 4) ** 2 + (y - 3) ** 2 <= 8).ravel()
    found = continued(masked(values, pressed), pressed, (9, 7))
    assert_allclose(found, values, atol=1e-8)


def test_places_far_beyond_the_pressed_ones_keep_bounded_values():
    x, y = np.meshgrid(np.arange(41.0), np.arange(12.0), indexing="ij")
    values = np.cos(x / 5 + y / 4).reshape(-1, 1)
    pressed = ((x < 10) & (y > 2)).ravel()
    found = continued(masked(values, pressed), pressed, (41, 12))
    assert_allclose(found[pressed], values[pressed])
    assert abs(found).max() < 5


def test_signals_of_absent_places_are_missing_and_of_others_unchanged(whole, signals):
    there = pressed_nodes(BOX)
    assert there[0].sum() > there[1].sum()
    assert np.isnan(signals.delta_counts[~there]).all()
    np.testing.assert_array_equal(signals.delta_counts[there], whole[2].delta_counts[there])


def test_between_pressed_places_signals_and_slopes_are_those_of_the_whole_table(whole, signals):
    rng, grid = np.random.default_rng(2), np.argwhere(contact_places(BOX))
    rows = grid[rng.integers(len(grid), size=300)]
    x, y = (contact_grid(BOX).xy_mm[rows[:, 1]] + rng.uniform(-2, 2, (300, 2))).T
    face = signals.faces[rows[:, 0]]
    some, every = (press_traces(one, face, x, y) for one in (signals, whole[2]))
    size = abs(every.counts).max(axis=(0, 1))
    assert (abs(some.counts - every.counts) / size).max() < 0.02
    assert_allclose(some.force_n, every.force_n, rtol=0.01, atol=0.02)
    at_places = contact_grid(BOX).xy_mm[rows[:, 1]].T
    force = np.full(300, 1.0)
    ours, theirs = (
        signal_gradient(one, face, *at_places, force).jacobian for one in (signals, whole[2])
    )
    scale = np.sqrt(np.mean(theirs**2, axis=(0, 1)))
    assert (np.sqrt(np.mean((ours - theirs) ** 2, axis=(0, 1))) / scale).max() < 0.02


def test_presses_beside_the_pressed_places_are_refused(signals):
    on_edge = np.array([6.0])
    assert press_traces(signals, np.array([2]), 0 * on_edge, on_edge).force_n[0, -1] > 0
    with pytest.raises(InputError, match="beside the contact locations that the face"):
        press_traces(signals, np.array([3]), np.array([15.0]), np.array([0.0]))


def test_scores_are_those_of_the_whole_table_and_missing_elsewhere(signals, tmp_path):
    scores = score_places(BOX, signals)
    there = contact_places(BOX)
    np.testing.assert_array_equal(scores.places, there)
    assert scores.judged[there].mean() > 0.9
    for values in (scores.position_bound_mm, scores.delta_raw):
        assert np.isnan(values[~scores.judged]).all()
        assert np.isfinite(values[scores.judged]).all()
    assert np.isnan(scores.stiffness_n_per_mm[~there]).all()
    assert np.isfinite(scores.stiffness_n_per_mm[there]).all()
    assert not scores.reaches_score_force[~there].any()
    weakest = weakest_place(scores)
    assert weakest.position_bound_mm == scores.position_bound_mm[scores.judged].max()
    save_scores_csv(scores, tmp_path / "scores.csv")
    back = load_scores_csv(tmp_path / "scores.csv")
    np.testing.assert_array_equal(back.places, there)
    np.testing.assert_array_equal(back.delta_raw, scores.delta_raw)


def test_a_missing_press_of_a_place_that_a_face_has_is_an_error(signals):
    place = np.flatnonzero(pressed_nodes(BOX)[1])[3]
    force = signals.force_n.copy()
    force[1, place] = np.nan
    with pytest.raises(InputError, match="the force of 4 presses is not finite"):
        score_places(BOX, replace(signals, force_n=force))
    absent = np.flatnonzero(~pressed_nodes(BOX)[1])[3]
    force = signals.force_n.copy()
    force[1, absent] = 1.0
    with pytest.raises(InputError, match="that contact_grid leaves out"):
        score_places(BOX, replace(signals, force_n=force))


def test_presses_on_other_faces_count_where_the_pressed_face_has_places(signals, whole):
    some = cross_face_disturbance(BOX, signals, 4.0)
    np.testing.assert_array_equal(np.isnan(some.size_sigma), ~some.places)
    np.testing.assert_array_equal(some.places, contact_places(BOX)[some.pressed - 1])
    adjacent = [relation == "adjacent" for relation in some.relation]
    sizes = some.size_sigma[adjacent][some.places[adjacent]]
    assert some.summary("adjacent")["median_sigma"] == np.median(sizes)


def test_frames_press_every_place_that_a_face_has_and_no_other(signals):
    frames = simulate_presses(BOX, signals, "made up")
    seen = np.unique(frames.place_id[frames.place_id != REST_PLACE_ID])
    face, place = np.nonzero(contact_places(BOX))
    np.testing.assert_array_equal(seen, np.unique(1000 * (face + 1) + place))
    peaks = nominal_peaks(BOX, signals)
    np.testing.assert_array_equal(np.isnan(peaks.force_n), ~contact_places(BOX))
    assert not peaks.clamped[~contact_places(BOX)].any()

"""Sets of contacts sorted, halved, packed and weighed, and steps of a descent, worked out by hand."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from estimator.inversion import evidence, posterior, readings, search
from estimator.inversion.evidence import bounded_curvature
from estimator.inversion.model.forward import NONE
from estimator.inversion.priors import Priors, fitting_sets, standing_probes
from estimator.inversion.problems import Observations, Problems, empty
from estimator.inversion.readings import ContactSets
from estimator.inversion.search import Hypotheses, Search
from estimator.inversion.tracking import Tracker
from studies.blind_start import summary_of, worst_mm

PRIORS = Priors((0.25, 0.25, 0.25, 0.25), 2, 800.0, (0.5, 10.5))
CHANNELS = 6


def problems(frames, faces, misfit):
    face = np.array(faces)
    count, slots = face.shape
    contact = np.arange(count * slots * 3.0).reshape(count, slots, 3)
    curvature = np.tile(2 * np.eye(3 * slots), (count, 1, 1))
    return Problems(
        np.array(frames), face, contact, np.zeros((count, CHANNELS)), np.array(misfit, float),
        np.zeros((count, 3 * slots)), curvature, np.zeros(count),
    )  # fmt: skip


ONE, TWO = [0, NONE, NONE], [0, 1, NONE]


def test_a_set_reached_twice_counts_once_and_sets_of_other_numbers_or_frames_stay():
    sets = problems([0, 0, 0, 1, 0], [ONE, ONE, TWO, ONE, ONE], np.zeros(5))
    found = Hypotheses(sets, np.array([3.0, 3.04, 3.0, 3.0, 3.2])).distinct()
    assert_array_equal(found.log_evidence, [3.0, 3.0, 3.0, 3.2])
    assert found.problems.frame.tolist() == [0, 0, 1, 0]
    apart = Hypotheses(sets, np.array([3.0, 3.051, 3.0, 3.0, 3.2])).distinct()
    assert len(apart.problems) == 5


def test_odds_are_those_of_numbers_on_faces_and_the_best_set_is_one_of_the_likeliest():
    """Two sets of two contacts have together more evidence than the best of one."""
    faces = [ONE, [0, 1, NONE], TWO, [1, 0, NONE], [NONE, 1, NONE], ONE]
    sets = problems([0, 1, 0, 0, 0, 1], faces, np.zeros(6))
    found = Hypotheses(sets, 1e4 + np.log([4.0, 2, 3, 3, 2, 6]))
    assert_allclose(found.share, [1 / 3, 0.25, 0.25, 0.25, 1 / 6, 0.75], rtol=1e-9)
    assert_allclose(found.odds, [1 / 3, 0.25, 0.5, 0.5, 1 / 6, 0.75], rtol=1e-9)
    best = found.best()
    assert best.tolist() in ([2, 5], [3, 5])
    assert found.second(best).tolist() == [0, 1]
    alone = Hypotheses(problems([0, 1, 1], [ONE] * 3, np.zeros(3)), np.array([0.0, 1.0, 2.0]))
    assert_allclose(alone.odds, 1.0)
    assert alone.best().tolist() == alone.second(alone.best()).tolist() == [0, 2]


def test_regions_hold_where_a_contact_is_in_other_sets_by_their_odds():
    """A second set has it 3 mm and 1 N away beside another contact farther off, a third on another face, a
    fourth is improbable."""
    sets = problems([0] * 4, [[0, 1], [0, 0], [1, NONE], [0, 1]], np.zeros(4))
    sets.contact[:, 0] = [[1.0, 2, 5], [9.0, 9, 5], [1.0, 2, 5], [8.0, 8, 8]]
    sets.contact[:, 1] = [[0.0, 0, 2], [4.0, 2, 4], [0.0, 0, 0], [0.0, 0, 2]]
    sets.curvature[0] *= 2
    found = Hypotheses(sets, np.log([0.5, 0.25, 0.25, 1e-4]))
    one, other = (evidence.covariances(sets.select(np.array([row])), PRIORS)[0] for row in (0, 1))
    away = np.array([3.0, 0, -1])
    wanted = (2 * one[0] + other[1] + np.outer(away, away)) / 3
    # the third set says where the second contact is: 1 mm, 2 mm and 3 N from where the first has it
    third = evidence.covariances(sets.select(np.array([2])), PRIORS)[0, 0]
    also = (2 * one[1] + third + np.outer([1.0, 2, 3], [1.0, 2, 3])) / 3
    spread = readings.among_sets(found, found.best(), PRIORS)
    assert_allclose(spread, [[wanted, also]], rtol=1e-3)


def test_the_sets_of_least_misfit_of_each_number_go_on_equal_ones_once():
    sets = problems(
        [0, 0, 0, 0, 0, 1], [ONE, ONE, ONE, TWO, ONE, ONE], [5.0, 3.0, 3.04, 9.0, 4.0, 7.0]
    )
    assert search.best_of_frame(sets, 2).tolist() == [1, 4, 3, 5]
    assert search.best_of_frame(sets, 1).tolist() == [1, 3, 5]
    assert search.best_of_frame(sets, 9).tolist() == [1, 4, 0, 3, 5]
    near = problems([0, 0], [ONE, ONE], [3.0, 3.06])
    assert search.best_of_frame(near, 2).tolist() == [0, 1]
    assert search.first_of_frame(np.array([1, 0, 1, 0]), np.array([4.0, 2, 3, 5])).tolist() == [
        1,
        2,
    ]


def test_a_contact_is_halved_into_two_a_dozen_millimetres_apart_four_ways():
    level = problems([7, 8], [ONE, [0, 1, 0]], [0, 0])
    frame, face, contact, extra = search.half_contacts(level)
    assert frame.tolist() == [7, 7, 7, 7]
    assert_array_equal(face, np.tile([0, 0, NONE], (4, 1)))
    was = level.contact[0, 0]
    for one, way in zip(contact, ([1, 0], [0, 1], [1, 1], [1, -1]), strict=True):
        step = 6 * np.array(way) / np.linalg.norm(way)
        assert_allclose(one[0], [*(was[:2] + step), was[2] / 2])
        assert_allclose(one[1], [*(was[:2] - step), was[2] / 2])
    assert extra.shape == (4, CHANNELS)
    two = search.half_contacts(problems([3], [TWO], [0]))
    assert len(two[0]) == 8
    assert_array_equal(two[1][0], [0, 1, 0])
    assert_array_equal(two[1][4], [0, 1, 1])


def test_filled_slots_come_first_in_their_order():
    face = np.array([[NONE, 1, 0], [0, NONE, 1]])
    contact = np.arange(18.0).reshape(2, 3, 3)
    packed, moved = search.packed_slots(face, contact)
    assert_array_equal(packed, [[1, 0, NONE], [0, 1, NONE]])
    assert_array_equal(moved[:, :2], [contact[0, 1:], contact[1, [0, 2]]])


def test_sets_go_on_while_more_is_left_than_noise_and_a_contact_could_gain():
    """Of 60 channels: one contact leaves 0.75 · ½ · 57 = 21.375 for noise, two 20.25; 2 more are asked."""
    model = SimpleNamespace(channels=60)
    given = object.__new__(Search)
    given.__dict__.update(model=model, priors=PRIORS)
    level = problems([0, 0, 0, 1], [ONE, ONE, TWO, [0, 1, 0]], [23.4, 23.3, 22.3, 900.0])
    judged = Hypotheses(level, np.array([0.0, 0.0, 0.0, 0.0]))
    assert given.worth_extending(judged, np.array([0.0, 0.0])).tolist() == [
        True,
        False,
        True,
        False,
    ]
    # the second frame's set is full; evidence far below the best cannot be made good
    assert not given.worth_extending(judged, np.array([2.1, 0.0])).any()
    assert given.worth_extending(judged, np.array([2.03, 0.0])).tolist() == [
        False,
        False,
        True,
        False,
    ]


def test_of_two_jaws_with_known_probes_none_looks_for_a_third_face():
    """Free tips may still come to a face that is pressed."""
    level = problems([0, 0], [ONE, TWO], [900.0, 900.0])
    given = object.__new__(Search)
    jaws = replace(PRIORS, paired=True)
    for priors, grow in (
        (replace(jaws, spacing_mm=(15.0, 20.0)), [True, False]),
        (replace(PRIORS, spacing_mm=(15.0, 20.0)), [True, True]),
        (jaws, [True, True]),
    ):
        given.__dict__.update(model=SimpleNamespace(channels=60), priors=priors)
        assert given.may_add_contact(level).tolist() == grow


def test_slots_are_cut_and_widened_with_ones_on_the_diagonal():
    assert posterior.used_slots(np.array([[0, NONE, NONE], [NONE, 1, NONE]])) == 2
    assert posterior.used_slots(np.full((2, 3), NONE)) == 1
    narrow = problems([0], [[0]], [1.0])
    wide = posterior.widened_covariance(narrow, 3)
    assert_array_equal(wide.face, [[0, NONE, NONE]])
    assert_array_equal(wide.contact[0, 0], narrow.contact[0, 0])
    assert not wide.contact[0, 1:].any()
    assert_array_equal(wide.curvature[0], np.diag([2.0] * 3 + [1.0] * 6))
    assert posterior.widened_covariance(narrow, 1) is narrow


def test_contacts_are_held_within_table_and_prior():
    model = SimpleNamespace(
        bounds=(np.array([-5.0, -6.0, 0.0]), np.array([5.0, 6.0, 8.0])),
        select_faces=lambda face, contact: contact,
    )
    contact = np.array([[[-9.0, 9.0, 0.1], [9.0, -9.0, 9.0]]])
    assert_array_equal(_held(model, PRIORS, contact), [[[-5, 6, 0.5], [5, -6, 8.0]]])
    tighter = Priors((0.5, 0.5), 1, 1.0, (0.5, 4.0))
    assert _held(model, tighter, contact)[0, 1, 2] == 4.0


def _held(model, priors, contact):
    hold = object.__new__(posterior.HeldBounds)
    posterior.HeldBounds.__init__.__wrapped__(hold, model, priors, contact)
    return hold(np.array([[0, 1]]), contact)


def test_a_damped_step_is_marquardts():
    curvature = np.array([[[4.0, 1.0, 0], [1.0, 3.0, 0], [0, 0, 2.0]]])
    slope, damping = np.array([[1.0, -2.0, 0.5]]), np.array([0.5])
    wanted = -np.linalg.solve(curvature[0] + 0.5 * np.diag([4.0, 3.0, 2.0]), slope[0])
    assert_allclose(posterior.damped_step(slope, curvature, damping)[0], wanted, rtol=1e-6)


def test_mass_beyond_bounds_of_places_and_forces_does_not_count():
    """Tops of peaks well inside, near a bound, and beyond bounds at which the contact is held,
    against integrals over what is inside."""
    bounds = np.array([-5.0, -5.0, 0.0]), np.array([5.0, 5.0, 20.0])
    sigma = np.array([0.5, 0.4, 0.8])
    given = problems([0, 1, 2], [ONE] * 3, np.zeros(3))
    given.contact[:, 0] = [[0.0, 1.0, 6.0], [0.0, 4.8, 6.0], [5.0, 1.0, 0.5]]
    given.curvature[:, :3, :3] = np.diag(1 / sigma**2 - 12 / np.square([20.0, 20.0, 10.0]))
    given.slope[2, [0, 2]] = [-3.0, 2.0]
    steps = np.linspace(-8.0, 8.0, 64001)
    wanted = []
    for contact, slope in zip(given.contact[:, 0], given.slope[:, :3], strict=True):
        low, high = np.maximum(bounds[0], [-9, -9, 0.5]), np.minimum(bounds[1], [9, 9, 10.5])
        share = 1.0
        for axis in range(3):
            density = np.exp(-slope[axis] * steps - 0.5 * (steps / sigma[axis]) ** 2)
            at = contact[axis] + steps
            there = (at >= low[axis]) & (at <= high[axis])
            share *= density[there].sum() * (steps[1] - steps[0]) / sigma[axis] / np.sqrt(2 * np.pi)
        wanted.append(share)
    found = np.exp(evidence.log_inside(bounds, PRIORS, given))
    assert_allclose(found, wanted, rtol=2e-3)
    assert wanted[2] < 0.2 < wanted[1] < 0.8 < wanted[0]


SEEN = Observations(
    np.array([[1.0, -2, 0, 0, 3, 0]]), np.full((1, 6), 2.0), np.full((1, 6), 0.5), np.ones((1, 6))
)


def test_nothing_explains_what_is_within_the_noise_of_rest():
    found = empty(SEEN, np.zeros(2, int), 2)
    assert_array_equal(found.face, np.full((2, 2), NONE))
    assert_allclose(found.misfit, 0.5 * (1 + 4 + 9) / 0.25)
    assert_allclose(found.log_spread, 6 * np.log(0.25))
    assert_array_equal(found.curvature, np.tile(np.eye(6), (2, 1, 1)))
    assert found.number.tolist() == [0, 0]


def test_no_posterior_is_wider_than_its_even_prior():
    """Even priors of width w have the variance w²/12: 20 mm a side of two faces of 800 mm², 10 N."""
    found = bounded_curvature(problems([0], [ONE], [0]), PRIORS)
    wide = [2 + 12 / 400, 2 + 12 / 400, 2 + 12 / 100]
    assert_allclose(np.diag(found[0]), [*wide, *[2.0] * 6])
    variance = evidence.covariances(problems([0], [ONE], [0]), PRIORS)
    assert_allclose(variance[0, 0], np.diag(1 / np.array(wide)))


def test_tips_of_a_known_probe_are_as_dense_as_their_ring_and_points():
    """Two tips: one on a ring about the other; three: the third at two points; all of them on the face."""
    priors = Priors((1.0,) * 4, 1, 500.0, (0.5, 10.5), spacing_mm=(15.0, 20.0))
    wide = np.sqrt(2 * np.pi) * 0.2
    two = np.log(500 / (2 * np.pi * 15 * wide))
    crossing = np.log(500 * np.sin(np.pi / 3) / (2 * wide**2))
    three = np.log(500 / (2 * np.pi * 20 * wide)) + crossing
    two -= np.log(fitting_sets(2, 15.0, np.sqrt(500)))
    three -= np.log(fitting_sets(3, 20.0, np.sqrt(500)))
    assert_allclose(standing_probes(priors)[:4], [0, 0, two, three])
    assert np.isneginf(standing_probes(priors)[4])


def test_the_worst_contact_is_that_of_the_nearest_pairing():
    found = np.array([[[0.0, 0], [10, 0]], [[1.0, 0], [2.0, 0]]])
    true = np.array([[[10.0, 3], [0, 4]], [[1.0, 0], [2.0, 5.0]]])
    assert_allclose(worst_mm(found, true), [4.0, 5.0])


def test_a_summary_of_blind_starts_tells_ranks_and_their_range():
    spec = SimpleNamespace(seed=3, limits=SimpleNamespace(position_bound_mm=2.0))
    distance = np.concatenate([np.full(60, 1.0), np.full(30, 2.0), np.full(9, 7.0), [np.inf]])
    found = summary_of.__wrapped__(spec, distance, 2, 3, "own")
    assert (found.contacts, found.sensors, found.blind_frames) == (2, 3, 100)
    assert (found.blind_median_mm, found.blind_90_mm) == (1.0, 2.0)
    assert found.blind_share_within_limit == pytest.approx(0.9)
    assert (found.blind_median_low_mm, found.blind_median_high_mm) == (1.0, 1.0)
    wide = np.concatenate([np.full(51, 1.0), np.full(49, 5.0)])
    found_wide = summary_of.__wrapped__(spec, wide, 2, 3, "own")
    assert (found_wide.blind_median_low_mm, found_wide.blind_median_high_mm) == (1.0, 5.0)
    # the share of a hundred draws has a deviation of 0.03: nine tenths lie within ±0.05
    assert found.blind_share_low == pytest.approx(0.85, abs=0.011)
    assert found.blind_share_high == pytest.approx(0.95, abs=0.011)


EXPLAINED = ContactSets(
    np.zeros((1, 1), int), np.zeros((1, 1, 2)), np.zeros((1, 1)), np.zeros((1, 1, 3, 3)),
    np.zeros((1, 1, 2)), np.zeros((1, 1, 2)), np.ones(1), np.ones(1), np.full(1, NONE),
    np.zeros((1, 0)), np.zeros((1, 0)), np.full((1, 1, 2), np.nan),
    np.full((1, 1, 2, 2), np.nan),
)  # fmt: skip


class Watched(Tracker):
    """A tracker whose frames have the p values given, and that notes where it looked anew."""

    def __init__(self, p_values, numbers):
        self.given, self.numbers, self.looked = iter(p_values), iter(numbers), []
        self.window = 0
        disturbances = SimpleNamespace(
            observed=lambda counts, drift_counts: SEEN,
            noise_counts=np.ones(CHANNELS),
            offset_counts=np.ones(CHANNELS),
        )
        inversion = SimpleNamespace(
            jaw_tables=(),
            disturbances=disturbances,
            error_share=lambda: self,
            reading=lambda seen, found, odds, error: EXPLAINED,
        )
        Tracker.__init__.__wrapped__(self, inversion)

    def learn(self, seen, found):
        """Nothing of the model's error."""

    def _same(self, seen):
        self.window += 1
        return problems([0], [ONE], [next(self.given)])

    def faint_contacts(self, same):
        return False

    def _is_magnet(self, plain):
        return False

    def _notice_slip(self, counts, drift_counts, sets):
        """No slip."""

    def has_changed(self, seen, same):
        self.looked.append(self.window)
        return problems([0], [TWO if next(self.numbers) else ONE], [0.0]), np.ones(1)


def fed(tracker):
    Tracker.feed.__wrapped__(tracker, np.zeros(CHANNELS))


def test_a_tracker_waits_twice_as_long_each_time_that_nothing_better_was_found(monkeypatch):
    """p below 0.02 makes it look; it then waits 1, 3, 7 and again 7 frames."""
    monkeypatch.setattr("estimator.inversion.tracking.p_values", lambda seen, found: found.misfit)
    tracker = Watched([0.5] + [0.01] * 30, [False] * 30)
    for _ in range(31):
        fed(tracker)
    assert tracker.looked == [2, 4, 8, 16, 24]
    again = Watched([0.01, 0.01, 0.5, 0.01, 0.01], [False] * 9)
    for _ in range(5):
        fed(again)
    assert again.looked == [1, 4]
    worse = Watched([0.01, 0.0011, 0.01, 0.0009], [False] * 9)
    for _ in range(4):
        fed(worse)
    assert worse.looked == [1, 3, 4]
    found = Watched([0.01, 0.01, 0.02], [True] * 9)
    for _ in range(3):
        fed(found)
    assert found.looked == [1, 2]

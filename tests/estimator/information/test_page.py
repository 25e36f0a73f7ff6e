"""Scores, bounds and false readings of a cube off its symmetries: a page that a person can judge."""

from dataclasses import replace

import numpy as np

from estimator.information.contact_sets import contact_sets, spread_places
from estimator.information.cross_face import cross_face_disturbance
from estimator.information.ellipses import position_covariances_mm2
from estimator.information.fisher import cramer_rao_bounds, disturbance_counts
from estimator.information.identifiability import jacobians_of, set_information
from estimator.information.scores import score_places
from estimator.information.slip_cost import slip_cost
from estimator.information.weak_areas import weak_areas
from estimator.signals.interpolation import signal_gradient
from tests.support.mechanics.odd_presses import SPEC, signals
from tests.support.physics_pages import assert_page, chosen

TIPS = SPEC.changed(indenter=SPEC.indenter.changed(radius_mm=2.5))


def of_scores():
    scores = score_places(SPEC, signals())
    yield "scores of 10¹⁶", scores.delta_raw / 1e16
    yield from chosen(scores, "position_bound_mm", "position_bound_drifted_mm", "force_bound_n")
    yield from chosen(scores, "force_bound_drifted_n", "detectable_force_n", "depth_at_score_mm")
    yield from chosen(scores, "detectable_force_drifted_n", "stiffness_n_per_mm")
    yield "covariances (mm²)", position_covariances_mm2(SPEC, signals(), scores)
    weak = weak_areas(SPEC, scores)
    yield "bound's correlation with border, magnet, path", list(weak.rank_correlation.values())


def of_bounds():
    """Of presses anywhere; contact sets of small tips, so that sets fit."""
    rng = np.random.default_rng(6)
    face = rng.integers(1, 6, 12)
    jacobian = signal_gradient(
        signals(), face, *rng.uniform(-4, 4, (2, 12)), rng.uniform(1, 8, 12)
    ).jacobian
    for kind in ("fresh", "drifted"):
        sigma = disturbance_counts(SPEC.sensors, kind, jacobian.shape[1])
        yield f"{kind}, places (mm)", cramer_rao_bounds(jacobian, sigma).position_mm
    places = np.array([0, 4, 7, 15, 19])
    sets = contact_sets(TIPS, places, 2)
    yield "places, sets", [len(spread_places(TIPS)), len(sets)]
    face = jacobians_of(TIPS, signals(), places)[1]
    resolved = set_information(face.face_channels[sets].swapaxes(1, 2).reshape(len(sets), -1, 6))
    yield from chosen(resolved, "resolved", "condition", "position_bound_mm", "force_bound_n")


def of_false_readings():
    crossed = cross_face_disturbance(SPEC, signals(), 6.0)
    yield from chosen(crossed, "size_sigma", "false_force_n")
    slipped = replace(
        signals(),
        baseline_counts=signals().baseline_counts + np.arange(45).reshape(15, 3),
        delta_counts=1.02 * signals().delta_counts + 3.0,
    )
    cost = slip_cost(SPEC, signals(), slipped)
    yield from chosen(cost, "size_ratio", "false_place_mm", "rezeroed_place_mm", "rezeroed_force_n")


def test_the_page_of_information():
    parts = (of_scores, of_bounds, of_false_readings)
    assert_page("estimator/information", [line for part in parts for line in part()])

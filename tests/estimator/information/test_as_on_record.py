"""Scores, bounds and false readings of an object off its symmetries, on record.

Where this fails after a deliberate change see `tests/support/recorded_facts.py`.
"""

from dataclasses import replace

import numpy as np
import pytest

from estimator.information.contact_sets import contact_sets, spread_places
from estimator.information.cross_face import cross_face_disturbance
from estimator.information.ellipses import position_covariances_mm2
from estimator.information.fisher import cramer_rao_bounds, disturbance_counts
from estimator.information.identifiability import jacobians_of, set_information
from estimator.information.scores import score_places, summarize_areas, weakest_place
from estimator.information.slip_cost import slip_cost
from estimator.information.weak_areas import weak_areas
from estimator.signals.interpolation import signal_gradient
from tests.support.mechanics.odd_presses import SPEC, signals
from tests.support.recorded_facts import assert_on_record, told, told_whole

TIPS = SPEC.changed(indenter=SPEC.indenter.changed(radius_mm=2.5))

DIRECTIONS = ["weakest_direction", "blind_direction"]


def on_record(section, lines):
    assert_on_record("information", section, lines, "estimator")


@pytest.fixture(scope="module")
def scores():
    return score_places(SPEC, signals())


@pytest.fixture(scope="module")
def random_presses():
    rng = np.random.default_rng(6)
    face = rng.integers(1, 6, 12)
    x, y = rng.uniform(-4, 4, (2, 12))
    return face, x, y, rng.uniform(1, 8, 12)


def test_scores_are_as_on_record(scores):
    areas = [
        line
        for number in (None, 3)
        for line in told_whole(f"areas of {number}", summarize_areas(scores, number))
    ]
    lines = [*told_whole("scores", scores), *areas, *told_whole("weakest", weakest_place(scores))]
    on_record("scores", lines)


def test_bounds_are_as_on_record(random_presses):
    jacobian = signal_gradient(signals(), *random_presses).jacobian
    for kind in ("fresh", "drifted"):
        sigma = disturbance_counts(SPEC.sensors, kind, jacobian.shape[1])
        lines = [
            *told_whole("bounds", cramer_rao_bounds(jacobian, sigma), DIRECTIONS),
            told("sigma", sigma),
        ]
        on_record(f"bounds, {kind}", lines)


def test_measures_of_scores_are_as_on_record(scores):
    lines = [
        told("covariances", position_covariances_mm2(SPEC, signals(), scores)),
        *told_whole("weak areas", weak_areas(SPEC, scores)),
    ]
    on_record("measures", lines)


def test_what_sets_of_contacts_tell_is_as_on_record():
    """Small tips, so that sets fit; blind sets too."""
    places = np.array([0, 4, 7, 15, 19])
    sets = contact_sets(TIPS, places, 2)
    lines = [
        told("places", spread_places(TIPS)),
        told("sets", sets),
    ]
    for face in jacobians_of(TIPS, signals(), places)[1:4:2]:
        lines += [told("face, channels", [face.face, *face.own])]
        whitened = face.whitened[sets].swapaxes(1, 2).reshape(len(sets), -1, 6)
        lines += told_whole("information", set_information(whitened[:, face.own]), ["blindest"])
        lines += told_whole(
            "of few channels", set_information(whitened[:, face.own[:4]]), ["blindest"]
        )
    on_record("sets", lines)


def test_false_readings_are_as_on_record():
    crossed = cross_face_disturbance(SPEC, signals(), 6.0)
    slipped = replace(
        signals(),
        baseline_counts=signals().baseline_counts + np.arange(45).reshape(15, 3),
        delta_counts=1.02 * signals().delta_counts + 3.0,
    )
    lines = [
        *told_whole("crossed", crossed),
        *told_whole("slip", slip_cost(SPEC, signals(), slipped)),
    ]
    for relation in ("adjacent", "opposite"):
        lines += told_whole(relation, crossed.summary(relation))
    on_record("false readings", lines)

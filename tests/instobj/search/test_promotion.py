"""Verdicts of a search: better than the start, and why not."""

from dataclasses import replace

import numpy as np
import pytest

from instobj.search.fidelity import TwinRatio
from instobj.search.verdict import LAST, Promoted, excess, merit, objections
from tests.support.objects.fidelity_scores import START
from tests.support.objects.search_cases import made_up_spec

BETTER = replace(START, worst_position_bound_mm=0.6, percentile_95_false_force_n=2.5)
_HERE_AND_THERE = np.where(np.arange(200) % 40 == 7, 1.3, 0.9)
"""Of the start's bounds: worse at 2.5 % of the locations."""
SURE = {"worst_position_bound_mm": TwinRatio(2.5, 1.4, 4.0)}


def objected(best, ratios=SURE, factor=1.0, places_worse=0.02, **search):
    times_start = {"median_false_force_n": factor, "sensitivity_ratio": factor}
    limits = {"times_start": times_start, "places_worse": places_worse}
    spec = made_up_spec(limits=limits, **search)
    layouts = [Promoted("a layout", None, spec, {LAST: score}) for score in (best, START)]
    return objections(spec.search, *layouts, ratios)


def test_a_layout_that_improves_within_all_limits_is_better():
    assert objected(BETTER) == ()
    both = ("worst_position_bound_mm", "worst_force_bound_n")
    assert objected(BETTER, objectives=both) == ()


FAULTS = {
    "mean is not better": replace(START, median_position_bound_mm=0.1),
    "median_false_force_n misses its limit by 50 %": replace(BETTER, median_false_force_n=1.8),
    "sensitivity_ratio misses its limit by 1e+02 %": replace(BETTER, sensitivity_ratio=0.15),
    "1 % of the sensors' range stays free in the deepest press, less than limits.saturation_margin = 0.1": (
        replace(BETTER, saturation_margin=0.01)
    ),
    "leave their range by 3 % in the deepest press of more than 5 % of virtual objects": (
        replace(BETTER, objects_margin=-0.03)
    ),
    "larger than the start's at 2.5 % of contact locations and forces, more than places_worse = 0.02": (
        replace(
            BETTER, position_bounds_mm=tuple(np.multiply(START.position_bounds_mm, _HERE_AND_THERE))
        )
    ),
}


def test_more_worse_locations_are_a_matter_of_what_the_user_allows():
    worse = next(fault for text, fault in FAULTS.items() if text.startswith("larger than"))
    assert objected(worse, places_worse=0.03) == ()
    assert objected(replace(worse, position_bounds_mm=(9.0,) * 200), places_worse=1.0) == ()


@pytest.mark.parametrize("text", FAULTS)
def test_each_objection_is_said_alone(text):
    (said,) = objected(FAULTS[text])
    assert text in said


def test_twins_that_disagree_are_an_objection_of_bounds_alone():
    unsure = {"worst_position_bound_mm": TwinRatio(2.5, 0.9, 4.0)}
    (said,) = objected(BETTER, unsure)
    assert "95 % of pairs" in said
    assert objected(BETTER, unsure, objectives=["percentile_95_false_force_n"]) == ()


def test_merit_is_the_mean_logarithm_and_what_is_exceeded():
    spec = made_up_spec(
        objectives=["worst_position_bound_mm", "percentile_95_false_force_n"],
        limits={"times_start": {"median_false_force_n": 1.1}},
    )
    worse = replace(BETTER, median_false_force_n=1.1 * 1.2 * 1.2)
    start, better, exceeding = (
        Promoted("", None, spec, {LAST: score}) for score in (START, BETTER, worse)
    )
    assert merit(spec.search, start, start, LAST) == 0
    mean = np.mean([np.log(0.6 / 1.5), np.log(2.5 / 3.0)])
    assert merit(spec.search, better, start, LAST) == pytest.approx(mean)
    assert excess(spec.search, exceeding, start, LAST) == pytest.approx(
        {"median_false_force_n": 0.2}
    )
    assert merit(spec.search, exceeding, start, LAST) == pytest.approx(mean + 2.0)


def test_a_layout_that_the_verdict_takes_comes_before_a_better_one_that_it_refuses():
    """3 % of places worse where 2 % are allowed, and four times better, against twice better."""
    spec = made_up_spec(objectives=["worst_position_bound_mm"], limits={"places_worse": 0.02})
    few = np.where(np.arange(200) % 34 == 7, 1.1, 0.9)
    bounds = tuple(np.multiply(START.position_bounds_mm, few).tolist())
    refused = replace(START, worst_position_bound_mm=1.5 / 4, position_bounds_mm=bounds)
    taken = replace(START, worst_position_bound_mm=1.5 / 2)
    start, first, second = (
        Promoted("", None, spec, {LAST: score}) for score in (START, refused, taken)
    )
    assert excess(spec.search, first, start, LAST) == pytest.approx({"places_worse": 0.5})
    assert merit(spec.search, second, start, LAST) < merit(spec.search, first, start, LAST)
    none = made_up_spec(objectives=["worst_position_bound_mm"], limits={"places_worse": 0.0})
    assert excess(none.search, first, start, LAST) == pytest.approx({"places_worse": 6.0})

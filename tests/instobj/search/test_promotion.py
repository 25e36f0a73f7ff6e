"""Verdicts of a search: better than the start, and why not."""

from dataclasses import replace

import numpy as np
import pytest

from design.spec.object import ObjectSpec
from estimator.layouts.fidelity import excess_over_limit
from instobj.search.fidelity import TwinRatio
from instobj.search.verdict import (
    LAST,
    Promoted,
    Promotion,
    best_in_words,
    best_known,
    excess,
    gains_in_words,
    merit,
    objections,
)
from tests.support.objects.fidelity_scores import START
from tests.support.objects.search_cases import made_up_spec

BETTER = replace(START, worst_position_bound_mm=0.6, percentile_95_false_force_n=2.5)
SURE = {"worst_position_bound_mm": TwinRatio(2.5, 1.4, 4.0)}


def objected(best, ratios=SURE, factor=1.0, **search):
    times_start = {"median_false_force_n": factor, "sensitivity_ratio": factor}
    spec = made_up_spec(limits={"times_start": times_start}, **search)
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
    "1 % of the sensors' range stays free in the deepest press, less than 10 %": (
        replace(BETTER, saturation_margin=0.01)
    ),
    "leave their range by 3 % in the deepest press of more than 5 % of virtual objects": (
        replace(BETTER, objects_margin=-0.03)
    ),
    "beyond limits.position_bound_mm = 1.5 outweighs what got better: position_over_limit misses its limit "
    "by 10 %": replace(BETTER, position_over_limit=1.32),
}


@pytest.mark.parametrize(
    ("score", "is_start"),
    [
        (BETTER, False),
        (replace(BETTER, position_over_limit=1.32), True),
        (replace(START, median_position_bound_mm=0.1), True),
    ],
)
def test_the_best_known_layout_is_the_start_where_what_was_found_costs_more_than_it_gains(
    score, is_start
):
    """A box's best.toml kept the limit at fewer locations than the user's own layout did."""
    spec = made_up_spec()
    start, best = (
        Promoted(name, None, spec, {LAST: of})
        for name, of in (("start", START), ("trial 3", score))
    )
    against = objections(spec.search, best, start, SURE)
    promotion = Promotion(start, (best,), (best,), SURE, against, (1, 1))
    assert (best_known(spec.search, promotion) is start) == is_start
    words = best_in_words(spec.search, promotion)
    assert words.startswith("your own layout, unchanged" if is_start else "trial 3, better")
    unsure = replace(promotion, objections=("limits are exceeded",))
    words = best_in_words(spec.search, unsure)
    assert ("trial 3, ahead of your own layout but not confirmed to be better" in words) != is_start


def box_sharp_in_its_middle(blind_mm, middle_mm):
    """Bounds of a box: blind at its ends (71 % of the locations), sharp in the middle, at one force."""
    bounds = np.repeat([blind_mm, middle_mm], [142, 58])
    return replace(
        START,
        worst_position_bound_mm=blind_mm,
        position_over_limit=float(excess_over_limit(ObjectSpec(name="box"), bounds)),
        position_bounds_mm=tuple(bounds.tolist()),
    )


def test_a_start_that_is_sharp_in_its_middle_and_blind_at_its_ends_is_beaten_by_an_even_layout():
    """29 % of the locations get worse: within the limit, or by less than the ends gain."""
    start = box_sharp_in_its_middle(38.0, 0.4)
    for middle_mm, beyond in ((1.4, "0 %"), (2.0, "29 %")):
        spec = made_up_spec()
        even = Promoted("even", None, spec, {LAST: box_sharp_in_its_middle(3.8, middle_mm)})
        before = Promoted("start", None, spec, {LAST: start})
        assert objections(spec.search, even, before, SURE) == ()
        told = gains_in_words(before, even, LAST)
        assert "worst location 3.8 instead of 38 mm" in told
        assert told.endswith(f"29 % got worse, {beyond} beyond that limit")


def test_what_is_lost_beyond_the_limit_must_not_outweigh_what_is_won():
    """The ends gain a third, and the middle is lost; how much of that is allowed is a limit like others."""
    start, lost = box_sharp_in_its_middle(30.0, 0.4), box_sharp_in_its_middle(20.0, 18.0)
    (said,) = objected_to(lost, start)
    assert "outweighs what got better" in said
    assert objected_to(lost, start, {"position_over_limit": 2.0}) == ()


def objected_to(best, start, times_start=None):
    spec = made_up_spec(limits={"times_start": times_start or {}})
    layouts = [Promoted("a layout", None, spec, {LAST: score}) for score in (best, start)]
    return objections(spec.search, *layouts, SURE)


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
    """Beyond a limit by half, and four times better, against twice better."""
    spec = made_up_spec(objectives=["worst_position_bound_mm"])
    refused = replace(START, worst_position_bound_mm=1.5 / 4, position_over_limit=1.8)
    taken = replace(START, worst_position_bound_mm=1.5 / 2)
    start, first, second = (
        Promoted("", None, spec, {LAST: score}) for score in (START, refused, taken)
    )
    assert excess(spec.search, first, start, LAST) == pytest.approx({"position_over_limit": 0.5})
    assert merit(spec.search, second, start, LAST) < merit(spec.search, first, start, LAST)

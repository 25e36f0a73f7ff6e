"""Trials at the lowest fidelity level: each ends in its time, and does not fail for want of it."""

import time
from functools import cache
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.search.space import params_at, search_space, start_params
from design.search.structure import with_structure
from design.spec.search import OVER_LIMIT, SearchSpec
from design.spec_io import load_spec, parse_spec
from estimator.layouts.batch import layouts_of
from estimator.layouts.batch_scores import batch_scores
from estimator.layouts.polish import LowestFidelity
from estimator.layouts.presses.basis import press_basis
from estimator.layouts.scorer import layout_scorer
from estimator.layouts.vectors import layout_space
from instobj.search import lowest_fidelity
from instobj.search.joined import plan_trial
from instobj.search.lowest_fidelity import TimedTrials, counts_over_lowest, score_trials
from instobj.search.time_limit import FIRST_LOOK_S, trial_ends
from tests.support.mechanics.candidate_cases import made_up_motions, made_up_spec

EXAMPLES = Path(__file__).parents[3] / "examples"
FACE, STEPS = 3, 12


@pytest.mark.parametrize(
    ("questions", "at_once", "left_s", "ends"),
    [
        (1, 1, 60.0, [60]),
        (3, 1, 60.0, [20, 40, 60]),
        (3, 2, 60.0, [30, 30, 60]),
        (1, 1, 5000.0, [900]),  # before it is given up
        (2, 1, -30.0, [FIRST_LOOK_S, 2 * FIRST_LOOK_S]),
    ],
)
def test_trials_share_the_time_that_is_left(questions, at_once, left_s, ends):
    now = time.time()
    made = trial_ends(questions, at_once, left_s, 1000.0)
    assert_allclose(np.array(made) - now, ends, atol=1.0)


def spec_of_search(steps):
    vary = {"magnet_reach_mm": 14.0, "magnet_depth_mm": [2.0, 5.0]}
    search = SearchSpec.model_validate({"vary": vary, "polish_steps": steps})
    return made_up_spec().model_copy(update={"search": search})


@cache
def scored_start():
    """The lowest level's scorers, and what the start scores there; polishing changes neither."""
    spec = spec_of_search(0)
    scorers = (layout_scorer(spec, press_basis(spec, made_up_motions(spec), FACE)),)
    scores = batch_scores(scorers, [layouts_of(spec, FACE)], ())
    return scorers, {name: float(one) for name, one in scores.items()}


def made_up_search(steps):
    """The specification of a search, its lowest level, and what its start scores there."""
    spec, (scorers, before) = spec_of_search(steps), scored_start()
    space = search_space(spec)
    tensors = layout_space(space, with_structure(spec, start_params(space)))
    return space, LowestFidelity(tensors, scorers, {OVER_LIMIT: before[OVER_LIMIT]}), before


@pytest.mark.parametrize(
    ("first_s", "left_s", "steps", "seconds"),
    [
        (None, 3.0, 5, 3.0),  # nine tenths of its time, at half a second a generation
        (None, FIRST_LOOK_S, 18, FIRST_LOOK_S),
        (None, 400.0, 300, 400.0),
        (FIRST_LOOK_S, 3.0, 10, FIRST_LOOK_S),  # of ten seconds half, and half for the walk
        (FIRST_LOOK_S, 400.0, 20, 200.0),  # half of the time is of the trials that follow
        (np.inf, 3.0, 3, 3.0),
        (np.inf, 400.0, 300, 400.0),
    ],
)
def test_trials_too_long_for_their_time_are_planned_for_it(first_s, left_s, steps, seconds):
    space, *_ = made_up_search(steps=300)
    planned, given_s = plan_trial(space, 0.5, left_s, first_s)
    assert (planned.spec.search.polish_steps, given_s) == (steps, seconds)


def test_trials_whose_time_went_into_reading_mechanics_have_a_first_look_all_the_same():
    assert TimedTrials([], time.time() - 1.0).left_s == FIRST_LOOK_S
    assert TimedTrials([], time.time() + 60.0).left_s == pytest.approx(60.0, abs=1.0)


@pytest.mark.parametrize("is_start", [True, False])
def test_a_trial_whose_time_is_over_ends_and_is_no_worse_than_it_began(is_start):
    """Without an end there are hundreds of generations, and as many steps of a start's walk."""
    space, lowest, before = made_up_search(steps=300)
    begin = (
        start_params(space) if is_start else params_at(space, np.full(len(space.variables), 0.5))
    )
    (cut,) = score_trials(space, lowest, [begin], seconds=0.0)
    (unmoved,) = score_trials(made_up_search(steps=0)[0], lowest, [begin])
    assert cut.scorings < 10
    assert cut.broken_mm <= unmoved.broken_mm
    assert cut.values[0] <= 1.001 * unmoved.values[0]
    if is_start:
        assert (cut.broken_mm, cut.misfit) == (0.0, "")
        assert cut.values[0] <= 1.001 * before["worst_position_bound_mm"]


def test_a_layout_that_breaks_limits_says_which_most():
    space, lowest, _ = made_up_search(steps=0)
    middle = params_at(space, np.full(len(space.variables), 0.5))
    (crowded,) = score_trials(space, lowest, [middle])  # all magnets in one place
    assert crowded.broken_mm > 0
    assert crowded.misfit == "the limit of pocket gap"


def test_the_start_walks_to_a_layout_that_is_better_and_keeps_its_limits():
    """Generations are too few to find much; other trials walk nowhere."""
    space, lowest, before = made_up_search(STEPS)
    start, other = start_params(space), params_at(space, np.full(len(space.variables), 0.5))
    assert start is not None
    walked, alone = score_trials(space, lowest, [start, other])
    assert (walked.broken_mm, walked.misfit) == (0.0, "")
    assert walked.values[0] < 0.95 * before["worst_position_bound_mm"]
    assert walked.scores[OVER_LIMIT] < 1.001 * before[OVER_LIMIT]
    assert walked.scorings > alone.scorings + STEPS


def test_counts_are_limited_by_what_the_chain_makes_of_the_lowest_levels(
    monkeypatch,
):
    search = {"vary": {"magnet_reach_mm": 14.0}}
    sensors = {"range_mt": 50.0, "counts_per_mt": 100.0}
    content = {"name": "cube", "search": search, "sensors": sensors}
    spec = parse_spec(content, "made up")
    space = search_space(spec)
    monkeypatch.setattr(lowest_fidelity, "scorers", lambda spec, faces: ())
    params = params_at(space, np.full(len(space.variables), 0.5))
    more, twice = (
        lowest_fidelity.structure_fidelity(
            space, params, lowest_fidelity.StartScores({OVER_LIMIT: 3.0}, counts)
        )
        for counts in (1.25, 2.0)
    )
    for one, counts in ((more, 1.25), (twice, 2.0)):
        assert one.at_most == {
            "largest_counts": pytest.approx(0.9 * 5000 / counts),
            "kept_counts": pytest.approx(5000 / counts),
            OVER_LIMIT: 3.0,
        }


@pytest.mark.parametrize("choice", [{"magnet_count": 7}, {"sensor_count": 12}])
def test_more_parts_than_the_start_has_need_no_places_for_their_mechanics(monkeypatch, choice):
    """Places come with the trial; before, seven magnets in the middle of a face did not fit."""
    vary = {"magnet_count": [5, 7], "magnet_reach_mm": 14.0}
    vary |= {"sensor_count": [3, 12], "sensor_reach_mm": 10.0}
    spec = made_up_spec().changed(search=SearchSpec.model_validate({"vary": vary}))
    structured = with_structure(spec, choice)
    made = made_up_motions(structured)
    monkeypatch.setattr(
        lowest_fidelity.Run, "require", lambda run, name: SimpleNamespace(folder=name)
    )
    monkeypatch.setattr(lowest_fidelity, "load_candidates", lambda folder: made)
    found = lowest_fidelity.scorers(structured, {1: (1,), 3: (3,)})
    assert len(found) == 2 * len(structured.scoring_forces_n)


def test_candidates_are_scored_with_the_error_of_the_zero(monkeypatch):
    spec, offset = made_up_spec(), 4.0
    spec = spec.changed(sensors=spec.sensors.changed(zeroing_counts=offset, drift_counts=60.0))
    monkeypatch.setattr(
        lowest_fidelity.Run, "require", lambda run, name: SimpleNamespace(folder=name)
    )
    made = made_up_motions(spec)
    monkeypatch.setattr(lowest_fidelity, "load_candidates", lambda folder: made)
    for one in lowest_fidelity.scorers(spec, {1: (1,)}):
        assert_allclose(one.sigma_counts, np.hypot(spec.sensors.noise_counts, offset), rtol=1e-6)


def test_structures_share_the_presses_of_sizes_that_both_have(monkeypatch):
    vary = {"magnet_sizes": ["D6x1", "D4x1", "D5x1"], "magnet_reach_mm": 12.0}
    spec = made_up_spec().changed(search=SearchSpec.model_validate({"vary": vary}))
    monkeypatch.setattr(
        lowest_fidelity.Run,
        "require",
        lambda run, name: SimpleNamespace(folder=f"{run.spec.magnets.sizes[0]}"),
    )
    made = made_up_motions(spec)
    monkeypatch.setattr(lowest_fidelity, "load_candidates", lambda folder: made)

    def presses(*parts):
        sizes = {f"magnet{k + 1}_size": part for k, part in enumerate(parts)}
        return lowest_fidelity.scorers(with_structure(spec, sizes), {3: (3,)})

    first = presses("D6x1", "D4x1", "D4x1", "D4x1", "D4x1")
    second = presses("D5x1", "D6x1", "D6x1", "D4x1", "D4x1")
    for one, other in zip(first, second, strict=True):
        assert one.presses_of[0] is other.presses_of[1]
        assert one.presses_of[1] is other.presses_of[2]
        assert all(other.presses_of[0] is not its for its in one.presses_of)


@pytest.mark.parametrize(
    ("example", "times"), [("paper_cube", 1.155), ("handle", 1.25), ("reverse_cube", 1.7)]
)
def test_counts_kept_free_are_what_bodies_were_measured_to_have_more_in_the_chain(example, times):
    spec = load_spec(EXAMPLES / f"{example}.toml")
    assert counts_over_lowest(spec) == pytest.approx(times)

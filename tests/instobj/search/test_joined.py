"""Trials that are joined to fewer and longer runs: as many generations, never fewer runs than needed."""

from typing import Any

import pytest

from design.search.space import search_space
from design.spec.search import SearchSpec
from instobj.search.joined import describe_merge, fit_budget, merge_restarts, quick_space
from instobj.search.loop import layouts_at_once
from tests.support.objects.search_cases import OBJECTIVES, made_up_spec


def space_of(**search: Any):
    """Two counts of magnets and two thicknesses unless `vary` says otherwise."""
    settings: dict[str, Any] = {"polish_steps": 300} | search
    return search_space(made_up_spec(**settings))


def runs(space):
    return space.spec.search.trials, space.spec.search.polish_steps


LENGTHS = {"magnet_reach_mm": 14.0}


@pytest.mark.parametrize(
    ("trials", "steps", "became"),
    [
        (24, 300, (12, 600)),
        (3, 30, (1, 90)),
        (60, 100, (10, 600)),
        (7, 100, (1, 600)),
        (1, 300, (1, 300)),
        (5, 301, (5, 301)),
        (4, 900, (4, 900)),
        (50, 0, (50, 0)),
    ],
)
def test_generations_are_spent_in_runs_of_up_to_600(trials, steps, became):
    asked = space_of(trials=trials, polish_steps=steps, vary=LENGTHS)
    space = merge_restarts(asked, 1)
    assert runs(space) == became
    assert trials * steps * 0.5 < became[0] * became[1] <= trials * steps or not steps
    assert space.variables == asked.variables
    assert space.spec.search.vary == asked.spec.search.vary


@pytest.mark.parametrize(
    ("trials", "kept", "became"),
    [
        (36, [480], (2, 240)),  # 12 of 20 are missing
        (24, [480], (1, 20)),  # nothing is
        (24, [200], (2, 280)),  # time had cut the run: the rest comes
        (60, [600, 300], (3, 300)),
        (60, [0, 0, 0], (5, 600)),  # trials that failed had none
        (1, [5], (1, 20)),  # no more trials wanted
    ],
)
def test_a_search_that_goes_on_adds_the_generations_that_are_missing(trials, kept, became):
    asked = space_of(trials=trials, polish_steps=20, vary=LENGTHS)
    assert runs(merge_restarts(asked, 1, kept)) == became


@pytest.mark.parametrize(
    ("search", "at_once", "became"),
    [
        ({"trials": 24}, 1, (12, 600)),
        ({"trials": 7}, 1, (7, 300)),  # four combinations of choices
        ({"trials": 40, "polish_steps": 30}, 1, (4, 300)),
        ({"trials": 3, "vary": LENGTHS}, 2, (3, 300)),
        ({"trials": 4, "vary": LENGTHS}, 2, (2, 600)),
        ({"trials": 24, "vary": LENGTHS, "objectives": list(OBJECTIVES)}, 1, (24, 300)),
    ],
)
def test_choices_processes_and_fronts_keep_their_runs(search, at_once, became):
    assert runs(merge_restarts(space_of(**search), at_once)) == became


@pytest.mark.parametrize(
    ("generation_s", "layouts", "left_s", "steps"),
    [
        (0.1, 1, 1014.0, 600),
        (1.0, 1, 1014.0, 507),
        (0.5, 2, 1014.0, 507),
        (2.0, 1, 32000.0, 600),  # a joined run may take as long as the trials that it stands for
        (0.1, 1, 75.2, 376),  # half of what is left to trials
        (0.1, 1, 40.0, 300),  # as asked for, in more than half of it
        (1.0, 1, 100.0, 90),  # less than asked for: what all of it holds, with a tenth to spare
        (4.0, 5, 100.0, 4),
        (4.0, 1, 1.0, 1),
        (0.1, 1, -3.0, 1),
        (0.0, 1, 20.0, 600),
    ],
)
def test_a_joined_run_is_shorter_where_time_is_short(generation_s, layouts, left_s, steps):
    asked = space_of(trials=4, vary=LENGTHS)
    space = merge_restarts(asked, 1)
    assert runs(space) == (2, 600)
    assert runs(fit_budget(asked, 600, generation_s, layouts, left_s)) == (4, steps)


@pytest.mark.parametrize(
    ("generation_s", "steps"), [(0.1, 100), (0.01, 600), (30.0, 1), (0.0, 600)]
)
def test_the_first_look_has_the_generations_that_its_time_holds(generation_s, steps):
    space = merge_restarts(space_of(trials=4, vary=LENGTHS), 1)
    assert runs(quick_space(space, generation_s, 10.0)) == (2, steps)


def test_what_became_of_the_trials_is_said():
    said = describe_merge(
        SearchSpec(trials=24, polish_steps=300), SearchSpec(trials=12, polish_steps=600)
    )
    assert "instead of 24 trials of 300 generations up to 12 longer ones of up to 600" in said
    assert "the time of this call holds" in said


def test_a_batch_has_a_layout_for_each_process_and_more_where_they_go_on_side_by_side(monkeypatch):
    improved, plain = SearchSpec(), SearchSpec(polish_steps=0)
    monkeypatch.delenv("INSTOBJ_DEVICE", raising=False)
    assert [layouts_at_once(improved, n) for n in (1, 3)] == [1, 3]
    assert [layouts_at_once(plain, n) for n in (1, 40)] == [16, 40]
    monkeypatch.setenv("INSTOBJ_DEVICE", "cuda:1")
    assert layouts_at_once(improved, 2) == 64

"""A search ends in its time: breaking off, fewer leaders, fewer finalists, said in words."""

import signal
import time
from contextlib import nullcontext, suppress
from functools import partial

import numpy as np
import pytest

from design.errors import InputError
from design.search.space import search_space, start_params
from design.spec_io import load_spec, parse_spec
from estimator.layouts.fidelity import SCORE_NAMES, FidelityScore
from instobj.search.levels import LEVELS, Level, Levels
from instobj.search.loop import drawn_start, run_search
from instobj.search.optimize import best_so_far, nothing_better
from instobj.search.outcome.write import write_best
from instobj.search.promotion import Promoter, leaders
from instobj.search.time_limit import TimeLimit, TimeSpent
from instobj.search.trials import KeptTrials, Scored, Trial, failed_trial, open_trials
from instobj.search.verdict import FIRST, LAST, SECOND
from instobj.stages.workers import Here
from tests.support.objects.search_cases import answering, made_up_score, made_up_space, searched


class Clock:
    """Time that passes only where a test says so."""

    def __init__(self, monkeypatch):
        self.now_s = 100.0
        monkeypatch.setattr("instobj.search.time_limit.time.monotonic", lambda: self.now_s)


@pytest.fixture
def clock(monkeypatch):
    return Clock(monkeypatch)


@TimeLimit(0.2).enforced()
def work_that_catches_errors(until):
    while time.monotonic() < until:
        with suppress(Exception):
            time.sleep(5)


def test_work_is_broken_off_whatever_errors_it_catches():
    handler = signal.getsignal(signal.SIGALRM)
    began = time.monotonic()
    with pytest.raises(InputError, match=r"search\.seconds = 0\.2.*--resume"):
        work_that_catches_errors(until=began + 20)
    assert time.monotonic() - began < 4
    assert signal.getsignal(signal.SIGALRM) is handler
    assert signal.getitimer(signal.ITIMER_REAL) == (0.0, 0.0)


def test_work_within_its_time_is_left_alone():
    with TimeLimit(0.2).enforced():
        done = sum(range(1000))
    time.sleep(0.3)
    assert done == 499_500


def test_mechanics_that_the_time_will_not_hold_are_announced():
    """60 s of chain twice, and twice that for all the rest, or 40 % for the lowest level; with 6 % for the
    page."""
    stored = TimeLimit(1).mechanics_plan(0.0, 60.0)
    assert "are stored" in stored
    held = TimeLimit(640).mechanics_plan(180.0, 60.0)
    assert "about 3 min of one free core" in held
    assert "search.seconds" not in held
    few = TimeLimit(638).mechanics_plan(180.0, 60.0)
    assert "likely to hold mechanics, but few trials: give --set search.seconds=700." in few
    assert "few trials" in TimeLimit(320).mechanics_plan(180.0, 60.0)
    none = TimeLimit(319).mechanics_plan(180.0, 60.0)
    assert "not even the mechanics" in none
    assert "--resume" in none
    assert "give --set search.seconds=1300" in TimeLimit(400).mechanics_plan(450.0, 60.0)
    assert "about 50 s of one" in TimeLimit(40).mechanics_plan(50.0, 0.0)


def test_time_that_holds_no_result_were_all_twice_as_quick_is_refused_with_what_is_needed():
    """180 s of mechanics and twice 60 s of the chain, in 94 % of the time."""
    assert "not even the mechanics" in TimeLimit(160).mechanics_plan(180.0, 60.0)
    with pytest.raises(
        InputError, match=r"about 3 min.*2 × 60 s for the chain.* --set search\.seconds=700$"
    ):
        TimeLimit(159).mechanics_plan(180.0, 60.0)


def test_the_best_so_far_is_kept_and_named_when_the_time_is_spent():
    with (
        pytest.raises(InputError, match=r"a result\. It is in best\.toml\. Go on with --resume"),
        TimeLimit(0.01).enforced(lambda: " It is in best.toml."),
    ):
        time.sleep(5)


def test_after_mechanics_were_made_no_more_is_asked_for_than_was_said():
    """A search that was advised to take 900 s asked for 1560 at its end."""
    limit = TimeLimit(0.01)
    assert limit.enough_s(300.0, 60.0) == 900
    with (
        pytest.raises(InputError, match=r"search\.seconds=900, all"),
        limit.enforced(enough_s=lambda: 900),
    ):
        time.sleep(5)
    enough = TimeLimit(0.5)
    with (
        pytest.raises(InputError, match=r"search\.seconds=1, all"),
        enough.enforced(enough_s=lambda: 0.4),
    ):
        time.sleep(5)


def test_once_mechanics_are_measured_the_time_that_will_do_is_named(clock):
    """A search of 500 s, as advised, went on for 330 s after mechanics of 133 s and had no result: layouts at
    the second level took 115 s each, a chain 140 s."""
    limit = TimeLimit(500)
    clock.now_s += 140
    said = limit.measured_plan(133.0)
    assert "mechanics took 133 s" in said
    advised_s = limit.measured_s(133.0)
    assert f"--resume --set search.seconds={advised_s:g}" in said
    assert (1 - 0.4) * 0.94 * advised_s > 2 * 115 + 140
    assert TimeLimit(advised_s).measured_plan(133.0) == ""
    clock.now_s += 200
    assert "--set search.seconds=500" in limit.measured_plan(60.0), (
        "enough, but most of it is spent"
    )


def test_no_time_for_trials_is_planned_that_mechanics_need():
    assert not TimeLimit(780).holds_trials(300.0)
    assert TimeLimit(900).holds_trials(300.0)


def test_time_spent_before_is_counted(clock):
    limit = TimeLimit(1000)
    clock.now_s += 1001
    with pytest.raises(InputError, match="--resume"), limit.enforced():
        signal.pause()


def test_shares_of_the_time(clock):
    limit = TimeLimit(1000)
    clock.now_s += 375
    assert limit.left_of(0.4) == pytest.approx(1)
    clock.now_s += 2
    assert limit.left_of(0.4) == pytest.approx(-1)
    assert limit.left_s == pytest.approx(563)
    assert limit.left == "563 of 940 s left until the page"
    assert "search until 376 s; check the best until 940 s;" in limit.plan
    clock.now_s += 564
    assert limit.left_s < 0
    assert limit.left == "0 of 940 s left until the page"


def test_trials_end_with_the_batch_in_which_their_time_ends(tmp_path, clock):
    space = made_up_space(trials=100)
    limit = TimeLimit(50)

    def slow(trials, seconds):
        clock.now_s += 2 * len(trials)  # a call takes those of one structure
        return made_up_score(trials, seconds)

    kept = open_trials(space.spec, tmp_path / "trials.jsonl")
    run_search(space, kept, answering(slow), lambda line: None, over=lambda: limit.left_s <= 0)
    assert len(kept.trials) == 32
    run_search(space, kept, answering(slow), lambda line: None, over=lambda: limit.left_s <= 0)
    assert len(kept.trials) == 48, "a call does at least one batch"


BROKEN_OFF_S = 400.0
"""Of a step that the end of the time breaks off."""


def bounds_between_twins(design, twin):
    """Of a design and one twin of it, at one force and place."""
    bounds = np.array([[design], [twin]])
    return [{"position_mm": bounds, "force_n": bounds}]


@pytest.fixture
def promoted(tmp_path, clock):
    """Promotes a made-up search with so many seconds per layout at the second and highest level."""
    kept = searched(tmp_path / "trials.jsonl", trials=60)
    space = made_up_space(trials=60, finalists=2)

    def run(
        seconds,
        second_s,
        highest_s,
        unbuildable=(),
        walked=lambda params: None,
        space=space,
        workers=None,
        twins_s=0.0,
    ):
        start, asked = space.spec, iter(range(99))

        def level(name, took_s):
            def score(spec):
                clock.now_s += took_s
                if spec is not start and took_s == BROKEN_OFF_S:
                    clock.now_s += 1e4
                    raise TimeSpent
                worth = 1.0 + 0.01 * len(spec.magnets.positions_mm)
                return FidelityScore(
                    **dict.fromkeys(SCORE_NAMES, worth), position_bounds_mm=(worth,)
                )

            stages = LEVELS[name].stages
            return Level(lambda: nullcontext(score), stages, lambda spec: took_s)

        def twins(spec):
            if spec is start:
                return bounds_between_twins(2.0, 1.1)
            if twins_s == BROKEN_OFF_S:
                raise TimeSpent
            return bounds_between_twins(1.0, 1.0)

        said = []
        took_s = {FIRST: 0, SECOND: second_s, LAST: highest_s}
        table = {name: level(name, took_s[name]) for name in took_s}
        promoter = Promoter(
            space,
            TimeLimit(seconds),
            Levels(tmp_path / "rungs.json", said.append, workers or Here(), table),
            walk=lambda space, params, start, leader, over: walked(params),
            unbuildable=lambda spec, start: (
                "shell, seal: 0.4 mm" if next(asked) in unbuildable else ""
            ),
            twins=twins,
        )
        return promoter.promote(kept), said

    return run


@pytest.mark.parametrize("beside_mm", [0.0, 0.01, 1.0])
def test_the_start_handed_back_is_said_at_once_and_promoted_no_further(tmp_path, beside_mm):
    """One trial, of the start's layout or of one beside it, keeps every limit."""
    search = {"vary": {"magnet_reach_mm": 14.0}, "trials": 1, "polish_steps": 0, "seconds": 900}
    magnets = {"positions_mm": [[8.0, 8.0], [-8.0, -8.0]]}
    spec = parse_spec({"name": "cube", "magnets": magnets, "search": search}, "made up")
    space, kept = search_space(spec), open_trials(spec, tmp_path / "trials.jsonl")
    start = start_params(space)

    def score(trials, seconds):
        layout = start | {"magnet1_x_mm": start["magnet1_x_mm"] - beside_mm}
        scores, of_start = {"worst_position_bound_mm": 1.0}, {"worst_position_bound_mm": 1.5}
        return [Scored(layout, (1.0,), scores, 0.0, "", 1, start_scores=of_start) for _ in trials]

    run_search(space, kept, answering(score), lambda line: None, start)
    assert len(leaders(space, kept, 5)) == (beside_mm == 1.0)
    none = best_so_far(space, KeptTrials(tmp_path / "none"), tmp_path / "none", tmp_path)
    assert "No trial has ended; the mechanics made so far are kept" in none
    said = best_so_far(space, kept, tmp_path / "search", tmp_path)
    path = tmp_path / "search" / "best.toml"
    assert str(path) in said
    assert "Trials (1), finished stages" in said
    assert ("began with" in said) == (beside_mm < 1.0)
    gains = "by the lowest fidelity level alone (worst location 1 instead of 1.5 mm)"
    first_line = path.read_text().splitlines()[0]
    assert (gains in said) == (gains in first_line) == (beside_mm == 1.0)
    assert (f"Judge it: instobj score {path}." in said) == (beside_mm == 1.0)
    assert ("the search began with" in first_line) == (beside_mm < 1.0)
    x_mm = 8.0 if beside_mm < 1.0 else 7.0
    assert load_spec(path).magnets.positions_mm[0] == (x_mm, 8.0)
    if beside_mm < 1.0:
        limit = TimeLimit(spec.search.seconds)
        levels = Levels(tmp_path / "rungs.json", lambda line: None)
        assert Promoter(space, limit, levels).promote(kept) is None
        write = partial(write_best, folder=tmp_path / "search", beside=tmp_path)
        document = nothing_better(spec, kept, limit, write)
        assert load_spec(path).magnets == spec.magnets, "the best so far is the start"
        assert document["verdict"].startswith("Nothing better was found in 0 s of search")
        assert (
            "your own layout (trial 0), which is best.toml, unchanged. Go on with --resume --set "
            "search.seconds=1800 or more" in document["verdict"]
        )
        assert len(document["tables"]) == 1
        assert not document["better"]


def test_without_a_result_the_error_says_why_trials_failed_or_which_limit_is_in_the_way(tmp_path):
    space, limit = made_up_space(trials=60), TimeLimit(900)
    kept = open_trials(space.spec, tmp_path / "trials.jsonl")
    params = dict(drawn_start(space, 1))
    why = "the process that worked on it died (exit code -9)"
    kept.keep([failed_trial(0, dict(drawn_start(space, 0)), "no result after 900 s")])
    kept.keep([failed_trial(1, params, why)])

    def refused():
        with pytest.raises(InputError) as error:
            nothing_better(space.spec, kept, limit, lambda *args: tmp_path)
        return str(error.value)

    assert f"all 2 trials failed. The last reason: {why}" in refused()
    assert "limit" not in refused()
    kept.keep([Trial(params, (2.0,), {}, 3.0, "the limit of pocket gap", 1, 2)])
    several = refused()
    assert "none of 3 trials keeps every limit. 2 of them failed, the last because" in several
    assert "Most in the way of the nearest, trial 2: the limit of pocket gap." in several
    kept.keep([Trial(params, (2.0,), {}, 0.0, "cannot be fabricated: seal", 1, 3)])
    assert "trial 3: cannot be fabricated: seal" in refused()


def test_with_time_enough_everyone_asked_for_is_scored(promoted):
    found, _ = promoted(seconds=1000, second_s=10, highest_s=10)
    assert (len(found.leaders), len(found.finalists), found.shortened) == (6, 2, "")


def test_short_of_time_fewer_leaders_and_finalists_are_scored_and_said(promoted):
    found, said = promoted(seconds=110, second_s=25, highest_s=10)
    assert (len(found.leaders), len(found.finalists)) == (3, 1)
    assert found.shortened.startswith("3 of 6 leaders and 1 of 2 finalists were scored")
    assert sum("falls out: time runs short" in line for line in said) == 3


def test_as_much_time_is_kept_as_the_start_took_on_the_highest_level(promoted):
    """Of 213 s 200 are for the search: 60 go to the start there, and 1.25 times that stays for a finalist.

    That leaves 65 s for the second level. What is stored costs the start nothing, and is kept free all the
    same.
    """
    few, said = promoted(seconds=200 / 0.94, second_s=20, highest_s=60)
    assert (len(few.leaders), len(few.finalists)) == (3, 1)
    assert "does not walk on: time runs short" in " ".join(said)
    again, _ = promoted(seconds=90, second_s=20, highest_s=60)
    assert (len(again.leaders), len(again.finalists)) == (4, 2)


def test_where_the_time_ends_within_the_chain_the_second_level_is_the_result(promoted):
    found, said = promoted(seconds=1000, second_s=10, highest_s=BROKEN_OFF_S, unbuildable=(0,))
    assert (found.finalists, found.level, found.ratios) == ((), "2", {})
    assert f"fidelity level 3 of {found.best.label} is left out: the time is over" in said
    assert f"fabrication checks of {found.best.label}" in said[-3:]
    assert len(found.leaders) == 3
    assert not any("walked" in one.label for one in found.leaders)
    assert "the time ended before the whole chain had scored it" in found.objections[0]


def test_where_the_time_ends_within_virtual_objects_nothing_is_called_better(promoted):
    found, said = promoted(seconds=1000, second_s=10, highest_s=10, twins_s=BROKEN_OFF_S)
    assert found.finalists
    assert not found.ratios
    assert "the time ended before virtual objects within tolerance were scored" in found.objections
    assert "twins are left out: the time is over" in said


def test_one_leader_and_one_finalist_are_always_scored(promoted):
    found, _ = promoted(seconds=100, second_s=90, highest_s=90)
    assert (len(found.leaders), len(found.finalists)) == (1, 1)


def test_what_was_scored_before_costs_no_time_in_the_next_call(promoted):
    promoted(seconds=100, second_s=25, highest_s=10)
    found, _ = promoted(seconds=100, second_s=25, highest_s=10)
    assert len(found.leaders) > 2


def test_a_leader_that_cannot_be_fabricated_makes_room_for_the_next_with_a_message(promoted):
    found, said = promoted(1000, 10, 10, unbuildable=(0, 2))
    assert [one.label for one in found.finalists] == [found.leaders[k].label for k in (1, 3)]
    (first, second) = [line for line in said if "cannot be fabricated: shell, seal: 0.4 mm" in line]
    assert first.startswith(found.leaders[0].label)
    assert second.startswith(found.leaders[2].label)
    with pytest.raises(InputError, match="no leader could be fabricated"):
        promoted(1000, 10, 10, unbuildable=range(99))


def test_leaders_that_walked_on_are_ranked_among_the_others(promoted):
    found, said = promoted(
        1000, 10, 10, walked=lambda params: params | {"magnet1_x_mm": params["magnet1_x_mm"] / 2}
    )
    walked = [one for one in found.leaders if one.corrected]
    assert [one.label.endswith(", walked on") for one in walked] == [True] * 2
    assert (len(found.leaders), found.shortened) == (8, "")
    assert all(one.levels.keys() >= {"1", "2"} for one in walked)
    assert sum("walks on" in line for line in said) == 2
    first = next(one for one in found.leaders if one.trial == walked[0].trial and not one.corrected)
    assert walked[0].spec.magnets.positions_mm != first.spec.magnets.positions_mm
    few, _ = promoted(30, 10, 10, walked=lambda params: params | {"magnet1_y_mm": 0.5})
    assert sum(one.corrected for one in few.leaders) == 1, "time is short"
    none, _ = promoted(22, 10, 10, walked=lambda params: params | {"magnet1_y_mm": 0.4})
    assert sum(one.corrected for one in none.leaders) == 0, "time is short"


def test_what_was_scored_before_counts_whatever_the_new_budget(promoted):
    promoted(1000, 10, 10)
    more = made_up_space(trials=60, finalists=2, seconds=99.0, polish_steps=0)
    _, said = promoted(1000, 10, 10, space=more)
    assert not [line for line in said if line.startswith("fidelity level")]


class TwoWorkers:
    """Notes what it is asked to make; a stage takes a layout's time once for two of them."""

    count = 2

    def __init__(self):
        self.requested = []

    def make(self, tasks, root, say, enough=lambda: False):
        for task in tasks.values():
            if enough():
                break
            self.requested.append((task.stage, task.spec))
        return {}


def test_what_several_layouts_need_is_made_side_by_side(promoted):
    workers = TwoWorkers()
    found, _ = promoted(
        1000,
        10,
        10,
        walked=lambda params: params | {"magnet1_y_mm": params["magnet1_y_mm"] / 2},
        workers=workers,
    )
    of = {
        stage: [spec for one, spec in workers.requested if one == stage]
        for stage, _ in workers.requested
    }
    everyone = [found.start, *found.leaders]
    assert len(everyone) == 9
    assert all(one.spec in of["second_fidelity"] for one in everyone)
    assert all(one.spec in of["signals"] for one in (found.start, *found.finalists))
    assert all(one.spec in of["fabrication"] for one in found.finalists)
    short = TwoWorkers()
    promoted(12, 10, 10, workers=short)
    asked = [spec for stage, spec in short.requested if stage == "second_fidelity"]
    assert len(asked) == 2, "no more than there is time for"

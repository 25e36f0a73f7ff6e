"""The loop of a search: what it draws, what it keeps, and what it survives."""

import json
import os
import signal
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from design.errors import InputError
from design.search.space import structure_of
from design.spec_io import parse_spec
from instobj.search.apart import WorkerTimeout, answers
from instobj.search.loop import drawn_start, run_search
from instobj.search.trials import failed_trial, open_trials, read_trials
from instobj.stages.workers import open_workers
from tests.support.objects.search_cases import (
    answering,
    kept_lines,
    made_up_score,
    made_up_space,
    searched,
)

HERE = Path(__file__).parent
EARLIER_KEY = "5a723d12a6417d1413664331f0fcf1240d5a75a3606691cca907cea0cd68f1ff"
OPTIMUM = {"magnet1_x_mm": 5.0, "magnet1_y_mm": -3.0}


def test_starts_find_a_known_optimum(tmp_path):
    kept = searched(tmp_path / "trials.jsonl", trials=192)
    best = min(kept.finished, key=lambda trial: trial.values[0])
    assert best.params["magnet_count"] == 1
    assert best.params["sensor_chip"] == "outward"
    for name, value in OPTIMUM.items():
        assert abs(best.params[name] - value) < 4.5


def test_a_seed_makes_a_search_repeatable_and_no_two_trials_are_alike(tmp_path):
    tried = [
        [t.params for t in searched(tmp_path / str(k), trials=48, seed=seed).trials]
        for k, seed in enumerate((4, 4, 5))
    ]
    assert tried[0] == tried[1]
    assert tried[0] != tried[2]
    assert len({str(params) for params in tried[0]}) == 48


def test_a_resumed_search_is_the_one_that_was_not_broken_off(tmp_path):
    path = tmp_path / "trials.jsonl"
    searched(path, trials=40)
    again = searched(path, trials=100)
    whole = searched(tmp_path / "whole.jsonl", trials=100)
    assert again.trials == whole.trials
    assert [trial.number for trial in again.trials] == list(range(100))


def test_a_search_is_neither_overwritten_nor_mixed_up(tmp_path):
    path = tmp_path / "trials.jsonl"
    searched(path, trials=32)
    kept = path.read_bytes()
    with pytest.raises(InputError, match="--resume"):
        open_trials(made_up_space().spec, path)
    with pytest.raises(InputError, match="no search of 'other'"):
        open_trials(made_up_space(name="other").spec, path, resume=True)
    with pytest.raises(InputError, match="another specification"):
        open_trials(made_up_space(reach=13.0).spec, path, resume=True)
    with pytest.raises(InputError, match="no search to resume"):
        open_trials(made_up_space().spec, tmp_path / "none.jsonl", resume=True)
    assert path.read_bytes() == kept
    assert len(open_trials(made_up_space(trials=77).spec, path, resume=True).trials) == 32


def test_a_search_broken_off_before_its_first_trial_simply_begins_again(tmp_path):
    """The next call was refused: it held a search already."""
    path = tmp_path / "trials.jsonl"
    open_trials(made_up_space(reach=13.0).spec, path)
    begun = open_trials(made_up_space().spec, path)
    run_search(made_up_space(trials=16), begun, answering(made_up_score), lambda line: None)
    assert len(begun.trials) == 16
    assert open_trials(made_up_space().spec, path, resume=True).trials == begun.trials


def test_a_second_search_begun_before_the_first_trial_leaves_the_first_ones_file(tmp_path):
    """Mechanics take minutes: it emptied the file, and both added trials."""
    path = tmp_path / "trials.jsonl"
    first = open_trials(made_up_space().spec, path)
    head = path.read_bytes()
    second = open_trials(made_up_space().spec, path)
    assert path.read_bytes() == head
    first.keep([failed_trial(0, {}, "a first")])
    with pytest.raises(InputError, match="another process"):
        second.keep([failed_trial(0, {}, "a second")])
    assert read_trials(path) == first.trials


def test_trials_are_not_added_to_a_search_of_another_specification_begun_meanwhile(tmp_path):
    path = tmp_path / "trials.jsonl"
    first = open_trials(made_up_space(reach=13.0).spec, path)
    second = open_trials(made_up_space().spec, path)
    with pytest.raises(InputError, match="another process"):
        first.keep([failed_trial(0, {}, "of another specification")])
    second.keep([failed_trial(0, {}, "of this one")])
    assert read_trials(path) == second.trials


def test_trials_that_an_earlier_lowest_level_scored_are_not_mixed_in(tmp_path):
    """Its bounds were too small, so that its trials won. This is the key that it gave this search."""
    path = tmp_path / "trials.jsonl"
    searched(path, trials=16)
    head, *trials = path.read_text().splitlines(keepends=True)
    now = json.loads(head)["specification"]
    path.write_text("".join([head.replace(now, EARLIER_KEY), *trials]))
    assert now != EARLIER_KEY
    with pytest.raises(InputError, match="or of an earlier version"):
        open_trials(made_up_space().spec, path, resume=True)


@pytest.mark.parametrize(
    "changed",
    [
        {"tolerances": {"magnet_seat_mm": 0.4}},
        {"limits": {"use": "bench"}},
        {"environment": {"earth_ut": 61.0}},
        {"training": {"epochs": 7}},
        {"protocol": {"frames_per_press": (8, 77)}},
        {"printer": {"clearance_mm": 0.3}},
        {"seed": 9},
    ],
    ids=lambda changed: next(iter(changed)),
)
def test_trials_scored_under_another_specification_are_not_mixed_in(changed, tmp_path):
    """Tolerances, use, surroundings and training change what the same layout scores on some level."""
    path = tmp_path / "trials.jsonl"
    searched(path, trials=16)
    spec = made_up_space().spec
    content = spec.model_dump(mode="json")
    for name, part in changed.items():
        content[name] = content[name] | part if isinstance(part, dict) else part
    other = parse_spec(content, "changed")
    assert other != spec
    with pytest.raises(InputError, match="another specification"):
        open_trials(other, path, resume=True)


def test_two_processes_on_one_search_are_one_clear_error_and_mix_nothing(tmp_path):
    path = tmp_path / "trials.jsonl"
    late = open_trials(made_up_space().spec, path)
    searched(path, trials=16)
    before = path.read_bytes()
    with pytest.raises(InputError, match="another process"):
        run_search(made_up_space(), late, answering(made_up_score), lambda line: None)
    assert path.read_bytes() == before


def test_a_line_cut_short_costs_that_trial_alone(tmp_path):
    path = tmp_path / "trials.jsonl"
    searched(path, trials=32)
    whole = path.read_bytes()
    path.write_bytes(whole[:-30])
    assert len(open_trials(made_up_space().spec, path, resume=True).trials) == 31
    searched(path, trials=32)
    assert path.read_bytes() == whole


@pytest.mark.parametrize("line", [b"not a trial", b"[1, 2]", b'{"params": {}}'])
def test_a_damaged_line_is_one_clear_error_and_the_file_is_left_alone(line, tmp_path):
    path = tmp_path / "trials.jsonl"
    searched(path, trials=16)
    head, first, *rest = path.read_bytes().splitlines(keepends=True)
    damaged = b"".join([head, line + b"\n", *rest])
    path.write_bytes(damaged)
    with pytest.raises(InputError, match="Restore the file from a copy"):
        open_trials(made_up_space().spec, path, resume=True)
    notes = tmp_path / "notes.txt"
    notes.write_text('{"groceries": 3}\n')
    with pytest.raises(InputError, match="no file of a search"):
        open_trials(made_up_space().spec, notes, resume=True)
    assert (path.read_bytes(), notes.read_text()) == (damaged, '{"groceries": 3}\n')
    assert first not in damaged


def test_a_full_disk_is_one_clear_error_and_loses_one_batch(tmp_path):
    path = tmp_path / "trials.jsonl"
    code = (
        "import resource, signal, sys; from pathlib import Path\n"
        "from design.errors import InputError\n"
        "from tests.support.objects.search_cases import searched\n"
        "path = Path(sys.argv[1]); searched(path, trials=32)\n"
        "signal.signal(signal.SIGXFSZ, signal.SIG_IGN)\n"
        "room = path.stat().st_size + 3000\n"
        "resource.setrlimit(resource.RLIMIT_FSIZE, (room, room))\n"
        "try:\n    searched(path, trials=400)\n"
        "except InputError as error: print(error)\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", code, str(path), str(HERE)],
        capture_output=True, text=True, check=True, cwd=HERE.parents[2],
    )  # fmt: skip
    assert "--resume" in done.stdout
    assert "Traceback" not in done.stderr
    assert 32 <= len(open_trials(made_up_space().spec, path, resume=True).trials) < 64
    assert len(searched(path, trials=100).trials) == 100


def test_a_killed_search_loses_no_finished_trial(tmp_path):
    path = tmp_path / "trials.jsonl"
    code = (
        "import sys; from pathlib import Path\n"
        "from tests.support.objects.search_cases import searched\n"
        "searched(Path(sys.argv[1]), trials=100000)\n"
    )
    process = subprocess.Popen(
        [sys.executable, "-c", code, str(path), str(HERE)], cwd=HERE.parents[2]
    )
    deadline = time.monotonic() + 120
    while kept_lines(path) < 60 and time.monotonic() < deadline:
        time.sleep(0.05)
    process.send_signal(signal.SIGKILL)
    process.wait()
    trials = open_trials(made_up_space(trials=100000).spec, path, resume=True).trials
    assert len(trials) >= 50
    assert all(trial.feasible for trial in trials)


def _slow_on_chips_inward(trials, seconds):
    if trials[0]["sensor_chip"] == "inward":
        raise WorkerTimeout(f"no result after {seconds:g} s")
    return made_up_score(trials, seconds)


def test_trials_given_up_are_kept_as_failed_and_the_search_goes_on(tmp_path):
    path = tmp_path / "trials.jsonl"
    kept = searched(path, score=_slow_on_chips_inward, trials=64)
    failed = [trial for trial in kept.trials if trial.failure]
    assert {trial.params["sensor_chip"] for trial in failed} == {"inward"}
    assert all("no result" in trial.failure and not trial.feasible for trial in failed)
    assert {trial.params["sensor_chip"] for trial in kept.finished} == {"outward"}
    assert open_trials(made_up_space(trials=64).spec, path, resume=True).trials == kept.trials


@pytest.mark.parametrize("at_once", [1, 2, 3])
def test_structures_of_a_batch_are_scored_side_by_side_each_shared_out(at_once, tmp_path):
    asked = []

    def score(questions, seconds):
        asked.append(questions)
        return answering(made_up_score)(questions, seconds)

    space = made_up_space(trials=8)
    kept = open_trials(space.spec, tmp_path / "trials.jsonl")
    run_search(space, kept, score, lambda line: None, at_once=at_once)
    (questions,) = asked
    of_each = [{structure_of(space, trial) for trial in question} for question in questions]
    assert all(len(structures) == 1 for structures in of_each)
    for structure in set.union(*of_each):
        shares = [len(q) for q, mine in zip(questions, of_each, strict=True) if structure in mine]
        assert len(shares) == min(at_once, sum(shares))
        assert max(shares) - min(shares) <= 1
    assert [t.params for t in kept.trials] == [drawn_start(space, k) for k in range(8)]


def test_the_specification_s_own_layout_is_looked_at_first_and_alone(tmp_path):
    """There is something to look at before a batch of many is done."""
    space, sizes, kept_then = made_up_space(trials=20), [], []
    kept = open_trials(space.spec, tmp_path / "trials.jsonl")
    first = drawn_start(space, 7)

    def score(trials, seconds):
        sizes.append(len(trials))
        return made_up_score(trials, seconds)

    def keep_and_stop():
        kept_then.append(len(kept.trials))
        return False

    run_search(space, kept, answering(score), lambda line: None, first, keep_and_stop)
    assert kept_then == [1, 17, 20]
    assert sizes[0] == 1
    assert kept.trials[0].params == first


def test_a_first_layout_that_failed_is_tried_again_once_in_the_next_call(tmp_path):
    space, path = made_up_space(trials=8), tmp_path / "trials.jsonl"
    first = dict(drawn_start(space, 20))
    kept = open_trials(space.spec, path)
    kept.keep([failed_trial(0, first, "no result after 900 s")])
    kept = open_trials(space.spec, path, resume=True)
    run_search(space, kept, answering(made_up_score), lambda line: None, first)
    assert [trial.params for trial in kept.trials].count(first) == 2
    assert kept.trials[1].params == first
    assert kept.trials[1].feasible
    assert len(kept.trials) == 8


def test_generations_that_the_time_did_not_hold_are_said_once(tmp_path):
    space, said = made_up_space(trials=4, polish_steps=300), []

    def short(trials, seconds):
        made = made_up_score(trials, seconds)
        return [replace(one, generations=57) for one in made]

    path = tmp_path / "trials.jsonl"
    kept = open_trials(space.spec, path)
    run_search(space, kept, answering(short), said.append, drawn_start(space, 0))
    (line,) = [line for line in said if "57 generations, not 300" in line]
    assert said.index(line) == 1, "not of the start's first look"
    lines = path.read_text().replace(', "generations": 57', "")
    path.write_text(lines)
    assert [t.generations for t in open_trials(space.spec, path, True).trials] == [0] * 4


def test_why_trials_have_no_result_is_said(tmp_path):
    space, said = made_up_space(trials=8), []
    kept = open_trials(space.spec, tmp_path / "trials.jsonl")
    run_search(space, kept, answering(_slow_on_chips_inward), said.append)
    reason, standing = said
    assert reason.startswith("no result, kept as failed: no result after")
    assert standing.startswith("8 of 8 trials")


def test_a_search_without_any_result_is_given_up(tmp_path):
    def never(trials, seconds):
        raise WorkerTimeout("no result after 1 s")

    with pytest.raises(InputError, match=r"gave up.*no result after 1 s"):
        searched(tmp_path / "trials.jsonl", score=never, trials=1000)


def test_choices_go_by_turns():
    """Each of two and each of three choices once before one comes again."""
    space = made_up_space(trials=100)
    choices = {v.name: v.choices for v in space.variables if v.choices}
    assert len(choices) > 1
    drawn = [drawn_start(space, number) for number in range(12)]
    for name, values in choices.items():
        for first in range(0, 13 - len(values), len(values)):
            turn = [params[name] for params in drawn[first : first + len(values)]]
            assert sorted(turn, key=str) == sorted(values, key=str)
    free = [v for v in space.variables if not v.choices]
    places = np.array([[params[v.name] for v in free] for params in drawn])
    assert len(np.unique(places[:, 0])) == 12
    assert all(v.low <= x <= v.high for row in places for v, x in zip(free, row, strict=True))


def test_turns_begin_with_the_first_layout_s_choices():
    space = made_up_space(trials=100)
    choices = {v.name: v.choices for v in space.variables if v.choices}
    for pick in (0, -1):
        first = {v.name: v.choices[pick] if v.choices else v.low for v in space.variables}
        drawn = [
            drawn_start(space, number, first) for number in range(max(map(len, choices.values())))
        ]
        assert drawn[0] == first
        for name, values in choices.items():
            assert {params[name] for params in drawn[: len(values)]} == set(values)


def _scored_slowly(argument):
    def score(trials):
        time.sleep(0.2)
        return made_up_score(trials, 0.0)

    return score


@pytest.mark.slow
def test_a_search_on_several_machines_loses_nothing_and_does_nothing_twice(tmp_path):
    """Workers of a Dask scheduler, each killed and replaced while it has a trial at work."""
    path, wanted = tmp_path / "trials.jsonl", 24
    space = made_up_space(trials=wanted, polish_steps=1)
    kept = open_trials(space.spec, path)
    killed = set()
    with open_workers(2) as workers:

        def kill_one(parts):
            pids = set(workers.client.run(os.getpid).values()) - killed
            if len(killed) < 3 and pids:
                victim = pids.pop()
                killed.add(victim)
                os.kill(victim, signal.SIGKILL)

        with answers(_scored_slowly, "", workers) as ask:

            def score(questions, seconds):
                kill_one(len(questions))
                return ask(questions, seconds)

            run_search(space, kept, score, lambda line: None, at_once=workers.count)
    assert len(killed) == 3
    assert [trial.params for trial in kept.trials] == [drawn_start(space, k) for k in range(wanted)]
    assert all(trial.feasible for trial in kept.trials)
    assert open_trials(space.spec, path, resume=True).trials == kept.trials

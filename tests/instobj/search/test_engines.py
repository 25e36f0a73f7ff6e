"""A search finds a known optimum, repeatably; what a search keeps and what it survives."""

import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import numpy as np
import pytest

from design.errors import InputError
from design.search.space import structure_of
from design.spec_io import parse_spec
from instobj.search.apart import Apart, GivenUp
from instobj.search.engines import ask, sampling
from instobj.search.loop import run_search
from instobj.search.study import open_study, repair_journal
from tests.support.objects.search_cases import (
    answering,
    journal_records,
    made_up_score,
    made_up_space,
    searched,
)

OPTIMUM = {"magnet1_x_mm": 5.0, "magnet1_y_mm": -3.0}


def best_of(kept):
    return min(kept.finished(), key=lambda trial: trial.values[0])


def test_a_search_comes_near_a_known_optimum(tmp_path):
    best = best_of(searched(tmp_path / "journal.log", trials=192))
    assert best.params["magnet_count"] == 1
    assert best.params["shell_thickness_mm"] == 9.0
    for name, value in OPTIMUM.items():
        assert abs(best.params[name] - value) < 4.5


def test_a_seed_makes_a_search_repeatable(tmp_path):
    tried = [
        [t.params for t in searched(tmp_path / str(k), trials=48, seed=seed).trials()]
        for k, seed in enumerate((4, 4, 5))
    ]
    assert tried[0] == tried[1]
    assert tried[0] != tried[2]


def test_a_resumed_search_goes_on_from_what_was_kept(tmp_path):
    path = tmp_path / "journal.log"
    first = searched(path, trials=40).trials()
    whole = searched(path, trials=100).trials()
    assert [t.params for t in whole[:40]] == [t.params for t in first]
    assert len(whole) == 100
    assert not any(t.params in [f.params for f in first] for t in whole[40:])


def test_a_study_is_neither_overwritten_nor_mixed_up(tmp_path):
    path = tmp_path / "journal.log"
    searched(path, trials=32)
    kept = path.read_bytes()
    with pytest.raises(InputError, match="--resume"):
        open_study(made_up_space().spec, path)
    with pytest.raises(InputError, match="no search of 'other'"):
        open_study(made_up_space(name="other").spec, path, resume=True)
    with pytest.raises(InputError, match="another specification"):
        open_study(made_up_space(reach=13.0).spec, path, resume=True)
    assert path.read_bytes() == kept
    before = tmp_path / "before.log"
    before.write_bytes(kept.replace(b'"scorings"', b'"layouts"'))
    with pytest.raises(InputError, match="an earlier version"):
        open_study(made_up_space().spec, before, resume=True)
    assert len(open_study(made_up_space(trials=77).spec, path, resume=True).trials()) == 32


@pytest.mark.parametrize(
    "changed",
    [
        {"tolerances": {"magnet_seat_mm": 0.4}},
        {"environment": {"earth_field_ut": 61.0}},
        {"training": {"epochs": 7}},
        {"protocol": {"frames_per_press": 77}},
        {"printer": {"clearance_mm": 0.3}},
        {"seed": 9},
    ],
    ids=lambda changed: next(iter(changed)),
)
def test_trials_scored_under_another_specification_are_not_mixed_in(changed, tmp_path):
    """Tolerances, surroundings and training change what the same layout scores on some level."""
    path = tmp_path / "journal.log"
    searched(path, trials=16)
    spec = made_up_space().spec
    content = spec.model_dump(mode="json")
    for name, part in changed.items():
        content[name] = content[name] | part if isinstance(part, dict) else part
    other = parse_spec(content, "changed")
    assert other != spec
    with pytest.raises(InputError, match="another specification"):
        open_study(other, path, resume=True)


@pytest.mark.parametrize("target", ["runs/x/search/journal.log", "/nowhere/journal.log"])
def test_the_lock_of_a_killed_search_does_not_hold_up_the_next(target, tmp_path):
    """A relative link, or one to a journal that has gone, made Optuna wait for ever."""
    path = tmp_path / "journal.log"
    searched(path, trials=16)
    lock = Path(f"{path}.lock")
    lock.symlink_to(target)
    os.utime(lock, (0, 0), follow_symlinks=False)
    ended = []
    going_on = threading.Thread(
        target=lambda: ended.append(len(searched(path, trials=32).trials())), daemon=True
    )
    going_on.start()
    going_on.join(60)
    assert ended == [32]


def test_locks_hold_from_any_folder(tmp_path, monkeypatch):
    """`--out .` gives a relative journal; the link that locks it must not dangle."""
    monkeypatch.chdir(tmp_path)
    seen, symlink = [], os.symlink

    def watched(target, link, *rest, **more):
        symlink(target, link, *rest, **more)
        seen.append(Path(link).exists())

    searched(Path("journal.log"), trials=8)
    monkeypatch.setattr(os, "symlink", watched)
    searched(Path("journal.log"), trials=16)
    assert seen
    assert all(seen)


def test_a_line_cut_short_costs_that_trial_alone(tmp_path):
    path = tmp_path / "journal.log"
    searched(path, trials=32)
    whole = path.read_bytes()
    path.write_bytes(whole[:-30])
    kept = open_study(made_up_space().spec, path, resume=True)
    assert len(kept.trials()) == 31
    assert len(searched(path, trials=40).trials()) == 40


def test_what_is_no_journal_is_left_alone(tmp_path):
    path = tmp_path / "notes.txt"
    path.write_text("not a journal\nat all")
    with pytest.raises(InputError, match="no journal"):
        repair_journal(path)
    assert path.read_text() == "not a journal\nat all"


def test_a_full_disk_is_one_clear_error_and_loses_one_batch(tmp_path):
    path = tmp_path / "journal.log"
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
    here = Path(__file__).parent
    done = subprocess.run(
        [sys.executable, "-c", code, str(path), str(here)],
        capture_output=True, text=True, check=True, cwd=here.parents[2],
    )  # fmt: skip
    assert "--resume" in done.stdout
    assert "Traceback" not in done.stderr
    kept = open_study(made_up_space().spec, path, resume=True)
    assert 32 <= len(kept.trials()) < 64
    assert len(searched(path, trials=100).trials()) == 100


def test_a_killed_search_loses_no_finished_trial(tmp_path):
    path = tmp_path / "journal.log"
    code = (
        "import sys; from pathlib import Path\n"
        "from tests.support.objects.search_cases import searched\n"
        "searched(Path(sys.argv[1]), trials=100000)\n"
    )
    here = Path(__file__).parent
    process = subprocess.Popen(
        [sys.executable, "-c", code, str(path), str(here)], cwd=here.parents[2]
    )
    deadline = time.monotonic() + 120
    while journal_records(path) < 60 and time.monotonic() < deadline:
        time.sleep(0.05)
    process.send_signal(signal.SIGKILL)
    process.wait()
    trials = open_study(made_up_space(trials=100000).spec, path, resume=True).trials()
    assert len(trials) >= 50
    assert {t.state.name for t in trials} == {"COMPLETE"}


def _sleepy(argument):
    def answer(question):
        if question == "die":
            os.kill(os.getpid(), signal.SIGKILL)
        if question == "fail":
            raise ZeroDivisionError("by nothing")
        if question == "refuse":
            raise InputError("not that")
        time.sleep(question)
        return argument

    return answer


def test_work_apart_is_given_up_and_starts_again():
    apart = Apart(_sleepy, "done")
    assert apart.ask(0, 60) == "done"
    with pytest.raises(GivenUp, match=r"no result after 0\.2 s"):
        apart.ask(60, 0.2)
    with pytest.raises(GivenUp, match="died"):
        apart.ask("die", 60)
    with pytest.raises(GivenUp, match="ZeroDivisionError"):
        apart.ask("fail", 60)
    with pytest.raises(InputError, match="not that"):
        apart.ask("refuse", 60)
    assert apart.ask(0, 60) == "done"
    apart.close()


def _slow_on_thin_shells(trials, seconds):
    if trials[0]["shell_thickness_mm"] == 8.0:
        raise GivenUp(f"no result after {seconds:g} s")
    return made_up_score(trials, seconds)


def test_trials_given_up_are_kept_as_failed_and_the_search_goes_on(tmp_path):
    kept = searched(tmp_path / "journal.log", score=_slow_on_thin_shells, trials=64)
    failed = [t for t in kept.trials() if t.state.name == "FAIL"]
    assert failed
    assert {t.params["shell_thickness_mm"] for t in failed} == {8.0}
    assert all("no result" in t.user_attrs["failure"] for t in failed)
    assert {t.params["shell_thickness_mm"] for t in kept.finished()} == {9.0}


@pytest.mark.parametrize(("processes", "lengths"), [(1, [2] * 4), (2, [1] * 8)])
def test_structures_of_a_batch_are_scored_side_by_side_each_shared_out(
    processes, lengths, tmp_path
):
    asked = []

    def score(questions, seconds):
        asked.append(questions)
        return answering(made_up_score)(questions, seconds)

    space = made_up_space(trials=8)
    kept = open_study(space.spec, tmp_path / "journal.log")
    run_search(space, kept, score, lambda line: None, processes=processes)
    (questions,) = asked
    of_each = [{structure_of(space, trial) for trial in question} for question in questions]
    assert all(len(structures) == 1 for structures in of_each)
    assert sorted(map(len, questions)) == sorted(lengths)
    assert {tuple(sorted(t.params.items())) for t in kept.finished()} == {
        tuple(sorted(trial.items())) for question in questions for trial in question
    }


def test_why_trials_have_no_result_is_said(tmp_path):
    space, said = made_up_space(trials=8), []
    kept = open_study(space.spec, tmp_path / "journal.log")
    run_search(space, kept, answering(_slow_on_thin_shells), said.append)
    assert any(t.state.name == "FAIL" for t in kept.trials())
    reason, standing = said
    assert reason.startswith("no result, kept as failed: no result after")
    assert standing.startswith("8 of 8 trials")


def test_a_search_without_any_result_is_given_up(tmp_path):
    def never(trials, seconds):
        raise GivenUp("no result after 1 s")

    with pytest.raises(InputError, match=r"gave up.*no result after 1 s"):
        searched(tmp_path / "journal.log", score=never, trials=1000)


def test_choices_of_random_layouts_go_by_turns(tmp_path):
    """Each of two and each of three choices once before one comes again, after past trials too."""
    space = made_up_space(trials=100)
    choices = {v.name: v.choices for v in space.variables if v.choices}
    assert len(choices) > 1
    engine = sampling(space.variables, 1, 7)
    asked = ask(engine, 12)
    for name, values in choices.items():
        drawn = [trial.params[name] for trial in asked]
        for first in range(0, 12, len(values)):
            if first + len(values) <= 12:
                assert sorted(drawn[first : first + len(values)], key=str) == sorted(
                    values, key=str
                )
    places = np.array([[t.params[v.name] for v in space.variables if not v.choices] for t in asked])
    assert len(np.unique(places[:, 0])) == 12
    done = list(searched(tmp_path / "journal.log", trials=5).finished())
    more = sampling(space.variables, 1, 7, done)
    again = ask(more, 1)[0]
    late = {name: asked[len(done)].params[name] for name in choices}
    assert {name: again.params[name] for name in choices} == late


def test_turns_begin_with_the_first_layout_s_choices():
    space = made_up_space(trials=100)
    choices = {v.name: v.choices for v in space.variables if v.choices}
    for pick in (0, -1):
        first = {v.name: v.choices[pick] if v.choices else v.low for v in space.variables}
        engine = sampling(space.variables, 1, 7, first=first)
        start, *others = ask(engine, max(map(len, choices.values())))
        assert start.params == first
        for name, values in choices.items():
            drawn = [trial.params[name] for trial in (start, *others)][: len(values)]
            assert set(drawn) == set(values)

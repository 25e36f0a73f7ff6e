"""Faults are planted in forks of one process, judged by the tests nearest to them, and kept for later."""

import argparse
import json
import subprocess
from dataclasses import asdict
from pathlib import Path

import pytest

from tests.planted_faults import __main__ as command
from tests.planted_faults.copies import sources
from tests.planted_faults.notes import Said
from tests.planted_faults.server import Server
from tests.planted_faults.sites import faults_in

CODE = """LIMIT, END = 3, 5

def larger(a, b):
    return a if a > b else b

def unasked(a):
    return 2 * a

def ends(a):
    while a > 0:
        a -= 1
    return a
"""
TESTS = """import os
from code_under_test import LIMIT, END, ends, larger

LAST = "abcd"[LIMIT]

def test_needs_what_others_made():
    assert "made" in os.environ

def test_larger():
    assert larger(2, 1) == 2

def test_rest():
    assert END == 5
    assert ends(3) == 0
"""
HERE = "tests/test_larger.py"


@pytest.fixture
def checkout(tmp_path):
    root = tmp_path / "checkout"
    (root / "tests").mkdir(parents=True)
    (root / "code_under_test.py").write_text(CODE)
    (root / HERE).write_text(TESTS)
    (root / "pytest.ini").touch()
    (root / "tests" / "__pycache__").mkdir()
    (root / "tests" / "__pycache__" / "a.pyc").touch()
    return root


def test_each_fault_is_noticed_by_the_test_that_fails_with_it_alone(
    checkout, tmp_path, monkeypatch
):
    monkeypatch.setattr(command, "ROOT", checkout)
    monkeypatch.setenv("PYTEST_DISABLE_PLUGIN_AUTOLOAD", "1")
    monkeypatch.setenv("PYTHONPATH", str(Path(__file__).parents[2]))
    faults = faults_in(checkout, "code_under_test.py")
    (tmp_path / "faults.jsonl").write_text("".join(f"{json.dumps(asdict(f))}\n" for f in faults))
    (endless,) = [asdict(fault) for fault in faults if fault.text == "+="]
    endless |= {"outcome": "hangs", "by": "earlier", "of": 1, "seconds": 120.0}
    (tmp_path / "outcomes.jsonl").write_text(json.dumps(endless) + '\n{"path": "cut of\n')
    command.plant(tmp_path, argparse.Namespace(copies=1, seconds=60.0, minutes=None))
    outcomes = command.lines(tmp_path / "outcomes.jsonl")
    by_rest = ("noticed", f"{HERE}::test_rest")
    assert {(one["line"], one["text"]): (one["outcome"], one["by"]) for one in outcomes} == {
        (1, "4"): ("noticed", HERE),  # of the module, imported anew: as tests are collected
        (1, "6"): by_rest,
        (4, "<="): ("noticed", f"{HERE}::test_larger"),
        (4, ">="): ("not noticed", ""),
        (7, "3"): ("not reached", ""),
        (7, "/"): ("not reached", ""),
        (10, ">="): by_rest,
        (10, "<="): by_rest,
        (10, "1"): by_rest,
        (11, "+="): ("hangs", "earlier"),
        (11, "2"): by_rest,
    }
    assert (tmp_path / "copy_0" / "code_under_test.py").read_text() == CODE
    told = command.summary(outcomes)
    assert "all              9        8  88.9 %" in told
    assert "return a if a ⟦> → >=⟧ b else b" in told


def test_faults_of_other_code_are_refused(checkout, tmp_path, monkeypatch):
    monkeypatch.setattr(command, "ROOT", checkout)
    file = tmp_path / "faults.jsonl"
    fault = faults_in(checkout, "code_under_test.py")[0]
    file.write_text(json.dumps(asdict(fault)) + "\n")
    assert command.kept(file) == [fault]
    (checkout / "code_under_test.py").write_text("\n" + CODE)
    with pytest.raises(SystemExit, match="has changed since"):
        command.kept(file)


def test_a_copy_holds_the_same_files_with_git_and_without(checkout):
    (checkout / "planted").mkdir()
    without = sources(checkout)
    (checkout / "planted" / "faults.jsonl").touch()
    (checkout / "planted" / "copy").touch()
    assert (
        sorted(sources(checkout)) == sorted(without) == ["code_under_test.py", "pytest.ini", HERE]
    )
    subprocess.run(["git", "init", "-q"], cwd=checkout, check=True)
    subprocess.run(["git", "add", "*.py", "*.ini"], cwd=checkout, check=True)
    assert sorted(sources(checkout)) == sorted(without)


def test_what_tests_call_is_learnt_once_and_of_new_tests_later(tmp_path, monkeypatch):
    """Of two new tests of a package one fails by itself, and is not asked again for what it calls."""
    file = tmp_path / "learnt.jsonl"
    file.write_text('{"test": "tests/fem/t.py::1", "seconds": 0.5, "calls": [["fem.a", "f"]]}\n')
    asked = []

    def fork(self, fault, tests, **_):
        asked.append(tests)
        events = [("begins", tests[0], 1.0), ("passes", tests[0], 3.0), ("fails", tests[1], 4.0)]
        return Said([*events, ("ends", tests[1], 4.0)], calls={tests[0]: {("fem.a", "g")}})

    monkeypatch.setattr(Server, "in_fork", fork)
    tests = [
        f"tests/{name}" for name in ("fem/t.py::1", "fem/t.py::2", "fem/t.py::3", "chain/t.py::4")
    ]
    for _ in range(2):
        server = Server(tmp_path, [], print, learnt=file)
        server.items = dict.fromkeys(tests)
        server.learn({"fem"})
        assert asked == [tests[1:3]]
        assert server.seconds == {tests[0]: 0.5, tests[1]: 2.0, tests[2]: 6.0}
        assert server.calls == {tests[0]: {("fem.a", "f")}, tests[1]: {("fem.a", "g")}}


def test_what_a_fork_said_names_the_test_in_which_it_failed_or_died():
    events = [("begins", "a", 1.0), ("passes", "a", 3.0), ("begins", "b", 3.0)]
    assert Said(events, "hangs").failed == "b"
    assert Said([*events, ("fails", "b", 4.0), ("ends", "b", 4.0)]).failed == "b"
    assert Said([*events, ("ends", "b", 4.0)]).failed is None
    assert Said([], "dies").failed == ""
    assert Said(events).seconds() == {"a": 2.0}


def test_the_files_of_this_checkout_are_found_without_git():
    root = Path(__file__).parents[2]
    assert {"pyproject.toml", "tests/conftest.py", "fem/__init__.py"} <= set(sources(root))

"""Faults are planted in copies, judged by the tests nearest to them, and kept for the next call."""

import json
import subprocess
import time
from dataclasses import asdict
from pathlib import Path

import pytest

from tests.planted_faults import __main__ as command
from tests.planted_faults.copies import Clock, Copy, OutOfTime, batches, failed, sources
from tests.planted_faults.reach import Reach, Reached, _content, _from_content, _reached
from tests.planted_faults.sites import faults_in

CODE = "def larger(a, b):\n    return a if a > b else b\n\n\ndef unasked(a):\n    return 2 * a\n"
TESTS = """import os
from code_under_test import larger

def test_larger():
    assert larger(2, 1) == 2

def test_needs_what_others_made():
    assert "made" in os.environ
"""
HERE = "tests/test_larger.py"


@pytest.fixture
def checkout(tmp_path, monkeypatch):
    monkeypatch.setenv("PYTEST_DISABLE_PLUGIN_AUTOLOAD", "1")
    root = tmp_path / "checkout"
    (root / "tests").mkdir(parents=True)
    (root / "code_under_test.py").write_text(CODE)
    (root / HERE).write_text(TESTS)
    (root / "tests" / "__pycache__").mkdir()
    (root / "tests" / "__pycache__" / "a.pyc").touch()
    return root


def fault_at(root, text):
    (found,) = [one for one in faults_in(root, "code_under_test.py") if one.text == text]
    return found


def test_a_fault_is_noticed_by_the_test_that_fails_with_it_alone(checkout, tmp_path):
    copy = Copy.made(checkout, tmp_path / "copy", Clock(60.0))
    tests = [f"{HERE}::{name}" for name in ("test_needs_what_others_made", "test_larger")]
    seconds = dict.fromkeys(tests, 0.1)
    turned = copy.judged(fault_at(checkout, "<="), tests, seconds)
    assert (turned["outcome"], turned["by"]) == ("noticed", tests[1])
    same = copy.judged(fault_at(checkout, ">="), tests, seconds)
    assert (same["outcome"], same["of"]) == ("not noticed", 1)
    assert (copy.root / "code_under_test.py").read_text() == CODE


def test_tests_that_hang_notice_and_a_clock_that_ends_tells_nothing(
    checkout, tmp_path, monkeypatch
):
    monkeypatch.setattr("tests.planted_faults.copies.LEAST_S", 1.0)
    (checkout / HERE).write_text("import time\ndef test_larger():\n    time.sleep(60)\n")
    tests = [f"{HERE}::test_larger"]
    hangs = Copy.made(checkout, tmp_path / "copy", Clock(60.0))
    assert hangs.judged(fault_at(checkout, "<="), tests, {})["outcome"] == "hangs"
    late = Copy.made(checkout, tmp_path / "copy", Clock(60.0, end=time.monotonic() + 0.2))
    with pytest.raises(OutOfTime):
        late.judged(fault_at(checkout, "<="), tests, {})


def test_a_second_call_judges_what_the_first_left(checkout, tmp_path, monkeypatch):
    monkeypatch.setattr(command, "ROOT", checkout)
    tests = frozenset({f"{HERE}::test_larger"})
    found = Reach({"code_under_test.py": {2: Reached(run=tests)}}, dict.fromkeys(tests, 0.1))
    faults = command.drawn(found, (".",), 100, seed=1)
    assert {fault.text for fault in faults} == {">=", "<="}  # nothing reaches line 6
    known = asdict(faults[0]) | {"outcome": "noticed", "by": "earlier", "of": 1, "seconds": 1.0}
    (tmp_path / "outcomes.jsonl").write_text(json.dumps(known) + '\n{"path": "cut of')
    over = Clock(60.0, end=time.monotonic())
    assert command.plant(faults, found, tmp_path, 1, over) == [known]
    first, second = command.plant(faults, found, tmp_path, 1, Clock(60.0))
    assert first == known
    assert second["outcome"] == ("noticed" if faults[1].text == "<=" else "not noticed")
    assert "50.0 %" in command.summary([first, second | {"outcome": "not noticed"}])


def test_faults_of_other_code_are_refused(checkout, tmp_path, monkeypatch):
    monkeypatch.setattr(command, "ROOT", checkout)
    file = tmp_path / "faults.jsonl"
    file.write_text(json.dumps(asdict(fault_at(checkout, "<="))) + "\n")
    assert command.kept(file) == [fault_at(checkout, "<=")]
    (checkout / "code_under_test.py").write_text("\n" + CODE)
    with pytest.raises(SystemExit, match="has changed since"):
        command.kept(file)


def test_a_copy_holds_the_same_files_with_git_and_without(checkout):
    (checkout / "planted").mkdir()
    without = sources(checkout)
    (checkout / "planted" / "reach.json").touch()
    (checkout / "planted" / "copy").touch()
    assert sorted(sources(checkout)) == sorted(without) == ["code_under_test.py", HERE]
    subprocess.run(["git", "init", "-q"], cwd=checkout, check=True)
    subprocess.run(["git", "add", "code_under_test.py", "tests/*.py"], cwd=checkout, check=True)
    assert sorted(sources(checkout)) == sorted(without)


def test_the_likeliest_tests_go_first_by_themselves():
    seconds = {"a": 5.0, "b": 20.0, "c": 40.0, "too long": 90.0, "d": 40.0}
    assert batches(list(seconds), seconds, 120.0) == [["a"], ["b"], ["c", "d"]]
    assert batches(["too long"], seconds, 60.0) == [["too long"]]
    assert batches([], seconds, 60.0) == []


def test_the_test_that_failed_is_told_from_others_that_begin_alike():
    tests = ["t.py::test_a", "t.py::test_a[x - y]"]
    assert failed("FAILED t.py::test_a[x - y] - assert 1 - 2 == 0\n", tests) == tests[1]
    assert failed("FAILED t.py::test_a - assert 0\n", tests) == tests[0]
    assert failed("ERROR t.py\n", tests) == tests[0]


def test_the_test_of_the_same_name_is_asked_first_then_the_room_then_the_quick():
    own, other = "tests/fem/linear/test_a.py", "tests/fem/mesh/test_c.py"
    far = "tests/instobj/test_b.py::test_{}"
    lines = {
        "fem/linear/a.py": {
            1: Reached(frozenset({far.format("slow"), far.format("quick"), f"{own}::test_a"})),
            2: Reached(frozenset({f"{other}::test_c", "tests/instobj/test_d.py::test_d"})),
            3: Reached(setup=frozenset({f"{other}::test_c"})),
            4: Reached(),
        }
    }
    slow, quick = far.format("slow"), far.format("quick")
    seconds = {slow: 3.0, quick: 2.0, f"{own}::test_a": 9.0, f"{own}::test_e": 1.0}
    seconds |= {f"{other}::test_c": 1.0, f"{other}::test_f": 2.0, "tests/instobj/test_d.py::x": 1.0}
    found = Reach(lines, seconds, failing=(f"{other}::test_f",))
    assert found.tests_of("fem/linear/a.py", 1) == [
        *(f"{own}::test_a", quick, slow),  # that run the line
        *(f"{own}::test_e", f"{other}::test_c"),  # that share fixtures
    ]
    by_fixture = Reach(lines, seconds).tests_of("fem/linear/a.py", 3)
    assert by_fixture[:2] == [f"{other}::test_c", f"{other}::test_f"]
    assert set(found.tests_of("fem/linear/a.py", 4)) == {
        *seconds,
        "tests/instobj/test_d.py::test_d",
    } - {
        f"{other}::test_f",
        "tests/instobj/test_d.py::x",
    }


def test_what_tests_reach_is_the_same_after_it_is_kept():
    reached = _reached(["t.py::a[x|y]|run", "t.py::b|setup", "t.py::b|teardown"])
    assert reached == Reached(frozenset({"t.py::a[x|y]", "t.py::b"}), frozenset({"t.py::b"}))
    found = Reach({"a.py": {1: reached, 2: Reached()}}, {"t.py::a[x|y]": 1.0, "t.py::b": 2.0})
    assert _from_content(json.loads(json.dumps(_content(found)))) == found


def test_the_files_of_this_checkout_are_found_without_git():
    root = Path(__file__).parents[2]
    assert {"pyproject.toml", "tests/conftest.py", "fem/__init__.py"} <= set(sources(root))

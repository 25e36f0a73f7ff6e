"""Modules that are loaded when they are asked for, and not before."""

import importlib
import sys

import pytest

from design.imports import deferred


@pytest.fixture
def idle(tmp_path, monkeypatch):
    """Name of a module that nobody has loaded yet."""
    (tmp_path / "idle_module.py").write_text(
        "import builtins\nbuiltins.idle_loads += 1\nanswer = 42\n"
    )
    monkeypatch.setattr("builtins.idle_loads", 0, raising=False)
    monkeypatch.syspath_prepend(tmp_path)
    yield "idle_module"
    sys.modules.pop("idle_module", None)


def loads():
    import builtins

    return builtins.idle_loads


def test_a_module_comes_at_the_first_question_and_once(idle):
    with deferred(idle):
        held = importlib.import_module(idle)
        assert loads() == 0
    assert idle not in sys.modules
    assert held.answer == 42
    assert importlib.import_module(idle).answer == held.answer
    assert loads() == 1
    with pytest.raises(AttributeError, match="idle_module"):
        _ = held.question


def test_a_question_while_others_are_imported_is_answered(idle):
    with deferred(idle):
        from idle_module import answer
    assert answer == 42
    assert sys.modules[idle].answer == 42
    assert loads() == 1


def test_modules_that_are_there_stay(idle):
    there = importlib.import_module(idle)
    with deferred(idle):
        assert sys.modules[idle] is there
    assert sys.modules[idle] is there

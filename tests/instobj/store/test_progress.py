"""Progress in a log: a line stays a line, however long it is, and silence is broken."""

import io
import threading
import time

import pytest
from rich.console import Console

from instobj.store import progress as module
from instobj.store.progress import ProgressLine


@pytest.fixture(autouse=True)
def chatty_log(monkeypatch):
    """Logs that show every step."""
    monkeypatch.setattr(module, "LOG_EVERY_S", 0.0)


def test_a_log_shows_a_step_a_minute_at_most_and_every_result(monkeypatch):
    monkeypatch.setattr(module, "LOG_EVERY_S", 60.0)
    written = io.StringIO()
    progress = ProgressLine(Console(file=written, width=40, highlight=False))
    with progress.stage("mesh"):
        for number in range(100):
            progress.step(f"trial {number}")
    progress.say("mesh: made in 12.3 s, which is a line that is longer than the console is wide")
    assert written.getvalue().splitlines() == [
        "mesh: made in 12.3 s, which is a line that is longer than the console is wide"
    ]


def test_a_long_step_is_one_line_in_a_log():
    written = io.StringIO()
    progress = ProgressLine(Console(file=written, width=80, highlight=False))
    with progress.stage("mechanics: response on a coarser mesh"):
        progress.step("assembling, factoring and condensing the matrix of all loads")
    (line,) = written.getvalue().splitlines()
    assert line.endswith("all loads (0 s)")


def test_steps_of_a_stage_within_another_are_its_own_and_the_live_line_stays_one():
    for terminal in (False, True):
        written = io.StringIO()
        console = Console(file=written, width=80, highlight=False, force_terminal=terminal)
        progress = ProgressLine(console)
        with progress.stage("promotion"):
            with progress.stage("mesh"):
                progress.step("tetrahedra")
            progress.step("twins")
            assert (progress.bar is not None) == terminal
            if progress.bar is not None:
                assert progress.bar.tasks[0].description == "promotion: twins"
        assert progress.bar is None
        progress.step("kept")
        lines = written.getvalue().splitlines()
        assert lines[-1].endswith("… kept"), "no stage, no time"
        if not terminal:
            assert [line.split(": ")[0] for line in lines[:2]] == ["  … mesh", "  … promotion"]


def test_the_last_step_is_told_again_where_a_stage_is_silent_and_only_then(monkeypatch):
    monkeypatch.setattr(module, "MOST_SILENT_S", 0.02)
    written, told = io.StringIO(), []
    progress = ProgressLine(Console(file=written, width=80))
    step = progress.step
    monkeypatch.setattr(progress, "step", lambda text: (told.append(text), step(text)))
    with progress.stage("presses"), progress.stage("response"):
        progress.step("factoring")
        until = time.monotonic() + 10
        while told.count("factoring") < 4 and time.monotonic() < until:
            time.sleep(0.005)
        said = told[told.index("factoring") :]  # before, on a busy machine, the stage's name alone
        assert said == ["factoring"] * len(said)
        assert len(said) >= 4
        reminders = [one for one in threading.enumerate() if one.name == "reminder"]
        assert len(reminders) == 1
        assert written.getvalue().splitlines()[-1].startswith("  … response: factoring (")
    assert not reminders[0].is_alive()
    told.clear()
    monkeypatch.setattr(module, "MOST_SILENT_S", 60.0)
    with progress.stage("response"):
        progress.step("factoring")
        time.sleep(0.05)
    assert told == ["factoring"]


def test_a_stage_that_has_not_said_anything_is_named(monkeypatch):
    monkeypatch.setattr(module, "MOST_SILENT_S", 0.02)
    written = io.StringIO()
    progress = ProgressLine(Console(file=written, width=80))
    with progress.stage("report"):
        until = time.monotonic() + 10
        while not written.getvalue() and time.monotonic() < until:
            time.sleep(0.005)
    assert written.getvalue().splitlines()[0] == "  … report (0 s)"


def test_a_log_names_slow_stages_alone_and_stays_short(monkeypatch):
    """Stages of 40 times the first wait: each is named early, then ever more rarely; short ones never."""
    monkeypatch.setattr(module, "LOG_EVERY_S", 60.0)
    monkeypatch.setattr(module, "MOST_SILENT_S", 0.01)
    written = io.StringIO()
    progress = ProgressLine(Console(file=written, width=80))

    def work(title, seconds):
        with progress.stage(title):
            until = time.monotonic() + seconds
            while time.monotonic() < until:
                progress.step("at work")
                time.sleep(0.001)

    work("slow", 0.4)
    lines = written.getvalue().splitlines()
    assert lines[0].startswith("  … slow")
    assert 2 <= len(lines) <= 6
    for number in range(20):
        work(f"stage {number}", 0.1)
    assert 6 <= len(written.getvalue().splitlines()) <= 30
    before = written.getvalue()
    monkeypatch.setattr(module, "MOST_SILENT_S", 5.0)
    work("short", 0.01)
    assert written.getvalue() == before

"""Progress in a log: a line stays a line, however long it is."""

import io

from rich.console import Console

from instobj.store.progress import ProgressLine


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
            live = progress._status
            assert (live is not None) == terminal
            if live is not None:
                assert str(live.status).startswith("promotion: twins")
        assert progress._status is None
        progress.step("kept")
        lines = written.getvalue().splitlines()
        assert lines[-1].endswith("… kept"), "no stage, no time"
        if not terminal:
            assert [line.split(": ")[0] for line in lines[:2]] == ["  … mesh", "  … promotion"]

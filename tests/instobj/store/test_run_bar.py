"""Bar of a whole run: what it expects, what it shows on a terminal, and nothing in a log."""

import io
import json
import os
import pty
import re
import subprocess
import sys

import pytest
from rich.console import Console

from instobj.stages.table import STAGES
from instobj.store.progress import ProgressLine
from instobj.store.run_bar import SHORT_S, TYPICAL_S, expected_seconds, time_left
from tests.support.cli import run

DUE = [("mesh", 10.0), ("response", 80.0), ("report", 10.0)]


def test_a_stage_is_expected_to_take_the_median_of_its_records_else_its_typical_time(tmp_path):
    assert expected_seconds(tmp_path, "mesh") == TYPICAL_S["mesh"]
    assert expected_seconds(tmp_path, "signals") == SHORT_S
    records = [*(json.dumps({"seconds": taken}) for taken in (3.0, 5.0, 90.0)), "{damaged", "{}"]
    for number, text in enumerate(records):
        folder = tmp_path / "mesh" / str(number)
        folder.mkdir(parents=True)
        (folder / "stage.json").write_text(text)
    assert expected_seconds(tmp_path, "mesh") == 5.0


def test_typical_times_are_of_stages_that_there_are():
    assert set(TYPICAL_S) <= set(STAGES)


@pytest.mark.parametrize(
    ("elapsed_s", "text"),
    [(0, "about 0:01:30 left"), (25, "about 0:01:05 left"), (400, "over 0:01:00 left")],
)
def test_time_left_is_the_rest_of_the_stage_and_the_later_ones(elapsed_s, text):
    assert time_left(30.0, elapsed_s, [20.0, 40.0]) == text


@pytest.mark.parametrize("terminal", [False, True])
def test_a_terminal_shows_stage_of_stages_and_time_left_and_a_log_nothing(terminal):
    written = io.StringIO()
    console = Console(file=written, width=120, force_terminal=terminal, color_system=None)
    progress = ProgressLine(console)
    with progress.whole_run(DUE):
        for title, _ in DUE[:2]:
            with progress.stage(title):
                progress.step("at work")
                if progress.bar is not None:
                    progress.bar.refresh()
    shown = written.getvalue()
    if not terminal:
        assert shown == ""
        return
    assert re.search(r"stage 1 of 3  mesh: at work .*0:00:00 about 0:01:40 left", shown)
    assert re.search(r"stage 2 of 3  response: at work .*0:00:00 about 0:01:30 left", shown)


def test_work_that_is_not_due_is_named_but_not_counted():
    progress = ProgressLine(Console(file=io.StringIO(), width=120, force_terminal=True))
    with progress.whole_run(DUE):
        with progress.stage("mesh"):
            pass
        with progress.stage("comparison"):
            assert progress.bar is not None
            assert progress.bar.tasks[0].description == "stage 1 of 3  comparison"
    assert progress.bar is None


def test_a_run_on_a_terminal_counts_its_stages_to_the_last_and_a_pipe_shows_no_bar(
    tmp_path, monkeypatch
):
    coarse = "mesh = {edge_mm = 8.0, surface_edge_mm = 3.0, envelope_mm = 0.1}"
    (tmp_path / "cube.toml").write_text(f'name = "cube"\nbody = {{sensed_faces = [1]}}\n{coarse}\n')
    monkeypatch.setenv("INSTOBJ_STORE", str(tmp_path / "store"))
    words = ("run", "cube.toml", "--to", "mesh")
    piped = run(*words, cwd=tmp_path)
    assert piped.returncode == 0, piped.stderr
    assert " left" not in piped.stderr
    reader, writer = pty.openpty()
    process = subprocess.Popen(
        [sys.executable, "-m", "instobj", *words],
        cwd=tmp_path,
        env=os.environ | {"COLUMNS": "120", "TERM": "xterm"},
        stdout=subprocess.DEVNULL,
        stderr=writer,
    )
    os.close(writer)
    shown = _read_to_end(reader)
    assert process.wait() == 0, shown
    count = re.findall(r"stage \d+ of (\d+)", shown)[-1]
    assert f"stage {count} of {count}" in shown
    assert re.search(r"(about|over) 0:\d\d:\d\d left", shown)


def _read_to_end(reader):
    shown = b""
    try:
        while part := os.read(reader, 65536):
            shown += part
    except OSError:  # Linux says so where the other end is closed
        pass
    os.close(reader)
    return shown.decode()

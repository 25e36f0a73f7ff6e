"""Misspelt names of a run and its results are told with those that there are; a library is silent."""

import subprocess
import sys
import traceback

import pytest

import instobj
from instobj.stages.named import Results

SILENT = """
import sys
from pathlib import Path
from instobj.store.progress import ProgressLine, show_progress
quiet = ProgressLine()
quiet.say("a"), quiet.step("b")
show_progress()
ProgressLine().say("told")
"""


def scores():
    return Results(
        {"position_bound_mm": ("place", [1.0]), "position_bound_drifted_mm": ("place", [2.0])}
    )


def test_a_name_that_a_run_has_not_is_told_with_those_it_has():
    run = instobj.Run(instobj.ObjectSpec(name="cube"))
    with pytest.raises(AttributeError, match=r"no 'nosuch'\. It has .*presses.* scores"):
        run.nosuch  # noqa: B018


def test_a_misspelt_quantity_proposes_no_other_one():
    """Python proposed the bound after 15 minutes for the fresh one, by its spelling."""
    with pytest.raises(AttributeError) as error:
        scores().position_bound_fresh_mm  # noqa: B018
    told = "".join(traceback.format_exception(error.value))
    assert "there are position_bound_mm, position_bound_drifted_mm" in told
    assert "Did you mean" not in told


def test_results_are_datasets_in_every_other_way():
    whole = scores()
    assert float(whole.position_bound_mm[0]) == 1
    assert isinstance(whole.isel(place=0), Results)
    assert not hasattr(whole, "depth")


def test_a_library_tells_no_progress_unasked():
    done = subprocess.run(
        [sys.executable, "-c", SILENT], capture_output=True, text=True, check=True
    )
    assert (done.stdout, done.stderr) == ("", "told\n")

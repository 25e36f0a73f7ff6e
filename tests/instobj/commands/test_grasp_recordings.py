"""Recordings of one and two tips per jaw train, a recording of three tips judges."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from design.errors import InputError
from estimator.calibration.twin import unknowns
from estimator.frames.dataset import load_frames, save_frames
from instobj.commands import inversion as command
from instobj.commands.contacts import contacts_in_file
from instobj.commands.readings import FOLLOW_REST
from instobj.commands.run import run_estimator
from instobj.stages.makers import inversion as makers
from instobj.stages.makers.twin import TwinOfData, require_same_object
from tests.support.mechanics.inverted import SPEC, presses
from tests.support.recordings.made_grasps import both, built_object, grasps

INVERSION = "training.model=inversion"


@pytest.fixture(scope="module")
def recordings(tmp_path_factory):
    """Two tips and fewer, and three."""
    folder, built = tmp_path_factory.mktemp("recordings"), built_object()
    save_frames(both(grasps(built, 1, cases=3), grasps(built, 2, cases=2)), folder / "two.nc")
    save_frames(grasps(built, 3, cases=2), folder / "three.nc")
    return folder


@pytest.fixture
def simulated(monkeypatch, tmp_path):
    """Presses that need no mesh, few frames, one step of the calibration."""
    monkeypatch.setenv("INSTOBJ_STORE", str(tmp_path / "store"))
    monkeypatch.setattr(unknowns, "ITERATIONS", 1)
    monkeypatch.setattr(makers, "MOST_FRAMES", 10)
    twin = TwinOfData(SPEC, presses()[:2], "made", 0)
    monkeypatch.setattr(command, "simulated_twin", lambda *_: twin)
    return tmp_path


def trained(recordings: Path, out: Path, overrides):
    stages, twin = ("networks", "metrics"), Path("object.toml")
    run_estimator([recordings / "two.nc"], stages, out, overrides, twin=twin)
    return out / "runs" / "two"


def test_three_tips_are_judged_by_an_inversion_of_two(recordings, simulated):
    run = trained(recordings, simulated, [INVERSION])
    content = json.loads((run / "contact_metrics.json").read_text())
    assert "whole presses held out" in content["judged"]
    (row,) = json.loads((run / "calibration.json").read_text())["faces"]
    assert (row["faces together"], row["cases"], row["contacts a case"]) == ("3, 5", 5, 4)
    assert row["signals left %, cases left out"] < row["signals left %, design"]
    three = recordings / "three.nc"
    tables = contacts_in_file(run / "contacts.nc", three, simulated, FOLLOW_REST)["tables"]
    (judged,) = (rows for title, rows in tables.items() if "against the labels" in title)
    (hard,) = (row for row in judged if row["force"] == "from 4 N")
    assert hard["tips a face"] == 3
    assert hard["distance mm"] < 3


def test_another_object_is_refused(recordings, simulated):
    two = load_frames(recordings / "two.nc")
    other = replace(two, grid_x_mm=np.arange(3.0))
    with pytest.raises(InputError, match="Give the specification of the object"):
        require_same_object(SPEC, other)

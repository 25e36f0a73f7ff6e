"""Recordings of one and two tips per jaw train, a recording of three tips judges (`--on`)."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from design.errors import InputError
from estimator.calibration.twin import unknowns
from estimator.frames.dataset import load_frames, save_frames
from instobj.commands import inversion as command
from instobj.commands.run import run_estimator
from instobj.stages.makers import inversion as makers
from instobj.stages.makers.twin import TwinOfData
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
    """Presses that need no mesh, few frames, one step of the calibration, no networks."""
    monkeypatch.setenv("INSTOBJ_STORE", str(tmp_path / "store"))
    monkeypatch.setattr(unknowns, "ITERATIONS", 1)
    monkeypatch.setattr(makers, "MOST_FRAMES", 10)
    twin = TwinOfData(SPEC, presses()[:2], "made", 0)
    monkeypatch.setattr(command, "simulated_twin", lambda *_: twin)
    monkeypatch.setattr(command, "trained_networks", lambda *_: {})
    return tmp_path


def evaluated(recordings: Path, out: Path, on: str, overrides):
    stages, twin = ("networks", "metrics"), Path("object.toml")
    run_estimator([recordings / "two.nc"], stages, out, overrides, twin=twin, on=recordings / on)


def test_three_tips_are_judged_beside_simple_readings(recordings, simulated):
    evaluated(recordings, simulated, "three.nc", [INVERSION])
    run = simulated / "runs" / "two"
    content = json.loads((run / "contact_metrics.json").read_text())
    assert "three.nc, of which nothing was trained" in content["judged"]
    (hard,) = (row for row in content["contacts"] if row["force"] == "from 4 N")
    assert hard["tips a face"] == 3
    simple = {row["model"]: row for row in content["baselines"] if row["force"] == hard["force"]}
    assert set(simple) == {"networks' patches", "matching pursuit", "mean of the training labels"}
    assert hard["distance mm"] < simple["mean of the training labels"]["distance mm"]
    assert hard["total force N"] < simple["mean of the training labels"]["total force N"]
    assert simple["networks' patches"]["missed a frame"] == 6
    (row,) = json.loads((run / "calibration.json").read_text())["faces"]
    assert (row["faces together"], row["cases"], row["contacts a case"]) == ("3, 5", 5, 4)
    assert row["signals left %, cases left out"] < row["signals left %, design"]


def test_another_object_is_refused(recordings, simulated):
    three = load_frames(recordings / "three.nc")
    save_frames(replace(three, grid_x_mm=np.arange(3.0)), recordings / "other.nc")
    with pytest.raises(InputError, match="Give the specification of the object"):
        evaluated(recordings, simulated, "other.nc", [INVERSION])


def test_networks_are_not_judged_on_another_recording(recordings, simulated):
    with pytest.raises(InputError, match=r"training\.model=inversion and --twin SPEC"):
        evaluated(recordings, simulated, "three.nc", [])

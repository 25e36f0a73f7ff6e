"""Experiments of grasps, slip and force vectors in their quick form, on a synthetic object."""

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[1] / "estimator"))

import numpy as np
from half_space_response import half_space_response
from synthetic_presses import synthetic_presses

from design.layouts import contact_grid
from design.spec import ObjectSpec
from estimator.contact_traces import JointMechanics
from estimator.shear import ShearSignals
from estimator.twin import drawn_assembly, twin_signals
from instobj.experiments import force_vectors, grasps, paper_object, slipped
from instobj.experiments.layouts import changed
from instobj.experiments.paper_object import SimulatedObject
from instobj.experiments.registry import studies

SHORTER = {
    "training.twins": 3,
    "training.epochs": 6,
    "protocol.presses_per_place": 3,
    "protocol.frames_per_press": 12,
    "protocol.rest_frames_per_press": 4,
}
NAMES = ("two-face-grasp", "core-slip", "3d-force")


def made_shear(spec):
    """Counts per newton, the same at every depth, and different along x and y."""
    grid, depth = contact_grid(spec), np.asarray(spec.press.depths_mm)
    slope = np.random.default_rng(1).normal(0, 60, (2, 15, 3))
    turned = 1 + 0.02 * grid.xy_mm[:, 0]
    per_n = turned[:, None, None, None, None] * np.ones((len(depth), 1, 1, 1)) * slope
    return ShearSignals(np.arange(1, 6), grid, depth, np.tile(per_n, (5, 1, 1, 1, 1, 1)))


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    spec = changed(ObjectSpec(name="synthetic"), paper_object._QUICK | SHORTER)
    presses = synthetic_presses(spec)
    assembly = drawn_assembly(spec, 7)
    mechanics = JointMechanics(half_space_response(spec, 13), None, assembly)
    signals = twin_signals(spec, assembly, *presses)
    made = SimulatedObject(spec, signals, mechanics, spec, presses, "synthetic")
    folder = tmp_path_factory.mktemp("experiments")
    found = {}
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("INSTOBJ_STORE", str(folder / "store"))
        for module in (grasps, slipped, force_vectors):
            patch.setattr(module, "simulated_object", lambda spec, quick: made)
        patch.setattr(slipped, "_presses", lambda recorded: presses)
        patch.setattr(force_vectors, "_shear", lambda recorded: made_shear(spec))
        for name in NAMES:
            (folder / name).mkdir()
            found[name] = studies()[name].run(spec, folder / name, True), folder / name
    return found


@pytest.mark.parametrize("name", NAMES)
def test_every_study_writes_a_table_and_a_figure(results, name):
    found, folder = results[name]
    assert all(row.keys() == found["rows"][0].keys() for row in found["rows"])
    assert "hidden twin" in found["texts"][0]
    assert (folder / f"{name}.png").stat().st_size > 5000


def test_grasps_stand_beside_the_papers(results):
    found = results["two-face-grasp"][0]
    assert [row["face"] for row in found["rows"]] == [3, 3, 5, 5]
    assert found["rows"][0]["paper E_f %"] == 38.7
    assert len(found["sweep"]["face 3, all sensors"]["E_f %"]) == 8


def test_a_new_zero_undoes_most_of_a_slip(results):
    rows = results["core-slip"][0]["rows"]
    error = {(row["estimator"], row["object"]): row["total force %"] for row in rows}
    assert error["calibrated", "slipped, old zero"] > 3 * error["calibrated", "before the slip"]
    assert error["calibrated", "slipped, new zero"] < 0.5 * error["calibrated", "slipped, old zero"]


def test_tangential_forces_are_read(results):
    rows = {row["axis"]: row for row in results["3d-force"][0]["rows"]}
    assert rows["Fz"]["correlation"] > 0.5
    assert rows["Fx"]["rms force N"] < 0.4 * rows["Fz"]["rms force N"]

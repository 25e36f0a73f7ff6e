"""Experiments of grasps, slip and force vectors in their quick form, on a synthetic object."""

from functools import cache

import numpy as np
import pytest

from design.layout.places.contact_grid import contact_grid
from design.spec.object import ObjectSpec
from estimator.frames import contact_cases
from estimator.frames.contact_traces import JointMechanics
from estimator.information.shear import ShearSignals
from estimator.inversion.inversion import inversion
from estimator.tolerances.virtual_object import drawn_assembly, twin_signals
from instobj.store.keys import content_key
from studies.layouts import changed
from studies.paper import force_vectors, grasp_contacts, grasps, slipped
from studies.paper import object as paper_object
from studies.paper.object import SimulatedObject
from studies.registry import studies
from tests.support.mechanics.half_space_response import half_space_response
from tests.support.mechanics.synthetic_presses import synthetic_presses

SHORTER = {
    "training.epochs": 6,
    "protocol.presses_per_place": 3,
    "protocol.frames_per_press": (4, 12),
}
LONG = [pytest.param(name, marks=pytest.mark.slow) for name in ("two-face-grasp", "grasp-contacts")]
NAMES = (*LONG, "core-slip", "3d-force")
FEWER_GRASPS = (((0.0, 0.0, 0.0), (7.5, -7.5, 0.0)), ((0.0, -9.0, 0.0),))


def made_shear(spec):
    """Counts per newton, the same at every depth, and different along x and y."""
    grid, depth = contact_grid(spec), np.asarray(spec.press.depths_mm)
    slope = np.random.default_rng(1).normal(0, 60, (2, 15, 3))
    turned = 1 + 0.02 * grid.xy_mm[:, 0]
    per_n = turned[:, None, None, None, None] * np.ones((len(depth), 1, 1, 1)) * slope
    return ShearSignals(np.arange(1, 6), grid, depth, np.tile(per_n, (5, 1, 1, 1, 1, 1)))


def made_object(spec):
    """Of any arrangement: synthetic presses of whatever moves with the shell."""
    presses, assembly = synthetic_presses(spec), drawn_assembly(spec, 7)
    mechanics = JointMechanics(half_space_response(spec, 13), None, assembly)
    signals = twin_signals(spec, assembly, *presses)
    return SimulatedObject(
        spec, signals, mechanics, spec, presses, content_key(spec.model_dump(mode="json"))
    )


def of_the_object_itself(recorded):
    """The estimator that a perfect calibration would give: calibrating takes half a minute here."""
    return inversion(recorded.design, *recorded.design_presses, recorded.signals, 0.02, 0.01)


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    """Function name → (what the study returned, its folder)."""
    spec = changed(ObjectSpec(name="synthetic"), paper_object.QUICK | SHORTER)
    folder = tmp_path_factory.mktemp("experiments")

    def run(name):
        (folder / name).mkdir()
        return studies()[name].run(spec, folder / name, True), folder / name

    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("INSTOBJ_STORE", str(folder / "store"))
        patch.setattr(contact_cases, "GRASP_POSES", FEWER_GRASPS)
        made = cache(lambda content: made_object(ObjectSpec.model_validate_json(content)))
        for module in (grasps, grasp_contacts, slipped, force_vectors):
            patch.setattr(
                module, "simulated_object", lambda spec, quick: made(spec.model_dump_json())
            )
        patch.setattr(grasp_contacts, "calibrated_inversion", of_the_object_itself)
        patch.setattr(slipped, "design_presses_of", lambda recorded: recorded.design_presses)
        patch.setattr(force_vectors, "shear_of", lambda recorded: made_shear(spec))
        yield run


@pytest.fixture(scope="module")
def results(run):
    """The same, run when it is first asked for."""
    return cache(run)


@pytest.mark.parametrize("name", NAMES)
def test_every_study_writes_a_table_and_a_figure(results, name):
    found, folder = results(name)
    assert all(row.keys() == found.rows[0].keys() for row in found.rows)
    assert "hidden twin" in found.texts[0]
    assert (folder / f"{name}.png").stat().st_size > 5000


@pytest.mark.slow
def test_grasps_stand_beside_the_papers(results):
    found = results("two-face-grasp")[0]
    assert [row["face"] for row in found.rows] == [3, 3, 5, 5]
    assert found.rows[0]["paper E_f %"] == 38.7
    assert len(found.data["sweep"]["face 3, all sensors"]["E_f %"]) == 8
    assert "56 of the collection's 56 contact cases" in " ".join(found.texts)
    for row in found.rows:
        assert 0 < row["best total force %"] < row["total force %"]
        assert 0 < row["best E_f %"] < row["E_f %"]
    own, every = found.rows[:2]
    assert every["best total force %"] < own["best total force %"]


@pytest.mark.slow
def test_swapping_magnets_and_sensors_judges_every_arrangement(run):
    found, folder = run("swap-magnets-and-sensors")
    assert (folder / "swap-magnets-and-sensors.png").stat().st_size > 5000
    rows = found.rows
    assert len(rows) == 3 * 2 * 2
    swapped = [row for row in rows if "sensors in the shell" in row["arrangement"]]
    assert {(row["face"], row["reads"]) for row in swapped} == {
        (face, reads) for face in (3, 5) for reads in grasps.MODELS.values()
    }
    errors = {tuple(row[name] for name in ("E_f %", "total force %")) for row in rows}
    assert len(errors) == len(rows)  # no arrangement, face or model stands twice
    assert all(0 < row["total force %"] < 60 for row in rows)


def test_a_new_zero_undoes_most_of_a_slip(results):
    rows = results("core-slip")[0].rows
    error = {(row["estimator"], row["object"]): row["total force %"] for row in rows}
    assert error["calibrated", "slipped, old zero"] > 3 * error["calibrated", "before the slip"]
    assert error["calibrated", "slipped, new zero"] < 0.5 * error["calibrated", "slipped, old zero"]


def test_a_calibration_is_carried_over_to_the_slip_found(results):
    rows = results("core-slip")[0].rows
    (carried,) = [row for row in rows if row["estimator"] == slipped.CARRIED]
    assert carried["object"] == slipped.NEW_ZERO
    after = {row["estimator"]: row for row in rows if row["object"] == slipped.NEW_ZERO}
    assert carried["total force %"] < 1.2 * after["calibrated"]["total force %"]
    assert carried["total force %"] != after["calibrated"]["total force %"]


def test_tangential_forces_are_read(results):
    rows = {row["axis"]: row for row in results("3d-force")[0].rows}
    assert rows["Fz"]["correlation"] > 0.5
    assert rows["Fx"]["rms force N"] < 0.4 * rows["Fz"]["rms force N"]


@pytest.mark.slow
def test_contacts_of_grasps_are_judged_by_number_of_tips_for_every_model(results):
    rows = results("grasp-contacts")[0].rows
    judged = {}
    for row in rows:
        judged.setdefault((row["model"], row["frames read"]), []).append(
            (row["tips a face"], row["force"], row["frames"])
        )
    twin = "calibrated twin"
    inverted = ["design", twin, f"{twin}, probes known", f"{twin}, jaws too"]
    baselines = ["matching pursuit, calibrated twin", "whole-object networks"]
    one, hold = "one", "mean of 10 frames"
    assert list(judged) == [
        *((name, read) for name in inverted for read in (one, hold)),
        *((name, one) for name in baselines),
    ]
    for read in (one, hold):
        assert len({tuple(told) for key, told in judged.items() if key[1] == read}) == 1
    pressed = [row for row in rows if row["tips a face"]]
    assert all(row["bound mm"] > 0 for row in pressed)
    share = [a / b for a, b in zip(possible(rows, hold), possible(rows, one), strict=True)]
    assert max(share) < 0.95  # the mean of a hold holds less noise


def possible(rows, read):
    return [
        row["bound mm"]
        for row in rows
        if (row["model"], row["frames read"]) == ("design", read) and row["tips a face"]
    ]

"""Contacts in grasps of two faces, one by one in mm, read by inversion of the forward model."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from design.spec.object import LARGEST_SEED
from studies.layouts import changed
from studies.paper.contact_baselines import patches, pursued
from studies.paper.figures import draw_bars, headline
from studies.paper.grasps import (
    fitted_to_single_faces,
    grasp_force_n,
    one_face_at_a_time,
)
from studies.paper.object import SIMULATED, SimulatedObject, simulated_object
from studies.registry import Study, StudyResult

if TYPE_CHECKING:
    from design.spec.object import ObjectSpec
    from estimator.frames.dataset import FrameSet
    from estimator.inversion.inversion import Inversion
    from estimator.inversion.readings import ContactSets

_UNCERTAINTIES = ("place in 90 % region %", "force in 90 % interval %", "not explained %")
"""Columns that readings without uncertainty have not."""
_HOLD_FRAMES = 10
_GRASPS, _QUICK_GRASPS = 40, 2
"""Of each number of tips, each held once."""
_SLOW_FRAMES = 1000
"""A press takes so many: a hold of ten changes its force by 3 % of the peak at most."""
_TEST_SEED = 100
_EVERY_PLACE = 4
"""Of the contact locations one in so many is labelled."""
_CALIBRATION_SEED = 200
_ONE, _HOLD = "one", f"mean of {_HOLD_FRAMES} frames"


def run_grasp_contacts(spec: ObjectSpec, folder: Path, quick: bool) -> StudyResult:
    """Number, places and forces of the contacts of both jaws, beside the Cramér–Rao bound."""
    recorded = simulated_object(spec, quick)
    frames = _holds(recorded, _QUICK_GRASPS if quick else _GRASPS)
    readers = _readers(recorded)
    rows = [row for name, reader in readers.items() for row in _judged(name, reader, frames)]
    rows += _baselines(recorded, readers["calibrated twin"], frames)
    shown = [row for row in rows if row["force"] == "from 4 N"]
    _draw(
        shown,
        headline("contacts in grasps, from 4 N per face", quick),
        folder / "grasp-contacts.png",
    )
    holds = len(frames) // _HOLD_FRAMES
    texts = [
        SIMULATED,
        f"{holds} holds of {_HOLD_FRAMES} frames: grasps of one, two and three tips per jaw at random "
        "places, turned at random, at random forces, zeroed before each, and rest. Read frame by "
        f"frame, and as means of {_HOLD_FRAMES}. The calibrated twin has seen labelled single presses "
        f"at one contact location in {_EVERY_PLACE} of both faces and no grasp; the design nothing "
        "of the object.",
        "possible: mean distance that the Cramér–Rao bound leaves an unbiased estimator that knows the "
        "number of contacts and nothing of their places. Known faces, borders and probes can do "
        "better. probes known: tips of a face are one of the paper's probes and bear alike within 30 %; "
        "jaws too: two press two faces alike (within 30 %), with as many tips each.",
        "Baselines: matching pursuit adds signals of presses 3 mm apart from the calibrated twin's table; "
        "the networks were fitted to the paper's collection of both faces of the object itself, probes "
        "of two and three tips included.",
        "Not covered: tangential forces, drift of minutes, a core that slipped, tips of another shape.",
    ]
    return StudyResult(rows, texts)


def _holds(recorded: SimulatedObject, grasps: int) -> FrameSet:
    """Grasps anywhere on both faces, each held once at some force."""
    slow = changed(recorded.spec, {"protocol.frames_per_press": [8, _SLOW_FRAMES]})
    return replace(recorded, spec=slow).collect(
        seed=_TEST_SEED,
        kind="grasp",
        grasp_force_n=grasp_force_n(recorded),
        random_grasps=grasps,
        non_contact_cases=grasps,
        frames_per_case=_HOLD_FRAMES,
    )


def _readers(recorded: SimulatedObject) -> dict[str, Inversion]:
    from estimator.inversion.inversion import KNOWN_FORCE_SPREAD, inversion, probe_spacing_mm
    from estimator.inversion.model.noise import design_error
    from estimator.signals.presses import press_signals

    design, presses = recorded.design, recorded.design_presses
    signals = press_signals(design, *presses)
    error, modulus = design_error(design, *presses, signals), design.tolerances.modulus_relative
    calibrated = calibrated_inversion(recorded)
    known = replace(
        calibrated.priors,
        force_spread=KNOWN_FORCE_SPREAD,
        spacing_mm=probe_spacing_mm(design.indenter.radius_mm),
    )
    return {
        "design": inversion(design, *presses, signals, error, modulus),
        "calibrated twin": calibrated,
        "calibrated twin, probes known": replace(calibrated, priors=known),
        "calibrated twin, jaws too": replace(calibrated, priors=replace(known, paired=True)),
    }


def calibrated_inversion(recorded: SimulatedObject) -> Inversion:
    """The twin that labelled single presses of both faces show."""
    from estimator.frames.press_protocol import simulate_presses
    from instobj.stages.makers.twin import TwinOfData

    again = recorded.spec.changed(seed=(recorded.spec.seed + _CALIBRATION_SEED) % LARGEST_SEED)
    frames = simulate_presses(again, recorded.signals, recorded.key)
    pressed = [
        np.unique(frames.place_id[(frames.contact_face == face).any(axis=1)])[::_EVERY_PLACE]
        for face in recorded.spec.collection.grasp_faces
    ]
    labelled = frames.select(np.isin(frames.place_id, np.concatenate(pressed)))
    twin = TwinOfData(recorded.design, recorded.design_presses, recorded.key, draws=0)
    return twin.inverted(labelled, lambda _: None)


def _judged(name: str, inversion: Inversion, frames: FrameSet) -> list[dict[str, Any]]:
    """Read frame by frame and hold by hold."""
    from estimator.frames.windows import all_counts
    from estimator.metrics.contacts import rows_beside_bound

    counts, rows = all_counts(frames), []
    for read, window in ((_ONE, 1), (_HOLD, _HOLD_FRAMES)):
        means = counts.reshape(-1, window, counts.shape[1]).mean(axis=1)
        # of a hold the last frame stands for all
        chosen = np.arange(window - 1, len(counts), window)
        valid = frames.valid[chosen]
        averaged = np.full(valid.sum(), window)
        found, _ = inversion.read(means[valid], averaged)
        judged = rows_beside_bound(inversion, frames.select(chosen[valid]), found, averaged)
        rows += [{"model": name, "frames read": read} | row for row in judged]
    return rows


def _baselines(
    recorded: SimulatedObject, twin: Inversion, frames: FrameSet
) -> list[dict[str, Any]]:
    from estimator.metrics.contacts import rows_beside_bound

    frames = frames.select(frames.valid)
    found = {
        "matching pursuit, calibrated twin": pursued(twin, frames),
        "whole-object networks": of_networks(recorded, frames),
    }
    return [
        {"model": name, "frames read": _ONE} | row | dict.fromkeys(_UNCERTAINTIES)
        for name, sets in found.items()
        for row in rows_beside_bound(twin, frames, sets)
    ]


def of_networks(recorded: SimulatedObject, frames: FrameSet) -> ContactSets:
    """Patches in the heatmaps of whole-object networks of both faces, fitted to the paper's collection of
    the object itself, single faces pressed."""
    single = one_face_at_a_time(recorded)
    fitted = [
        fitted_to_single_faces(recorded, single, face, "whole-object")
        for face in recorded.spec.collection.grasp_faces
    ]
    models = [(model, reference.smallest_contact_n) for model, reference in fitted]
    return patches(models, frames, np.arange(len(frames)))


def _draw(rows: list[dict[str, Any]], title: str, path: Path) -> None:
    """Bars by number of tips, one colour for each model."""
    distance, number = "distance to the true contact (mm)", "frames with every number right (%)"
    groups: dict[str, dict[str, Any]] = {}
    for row in rows:
        tips, read = row["tips a face"], row["frames read"]
        label = f"{tips} tip{'s' * (tips > 1)} per face, {'one frame' if read == _ONE else read}"
        group = groups.setdefault(label, {"": label})
        group[f"{row['model']}, mm"] = row["distance mm"]
        group[f"{row['model']}, %"] = row["number right %"]
        group["possible, mm"] = row["bound mm"]
    models = list(dict.fromkeys(row["model"] for row in rows))
    panels = {
        distance: {f"{name}, mm": name for name in models} | {"possible, mm": "Cramér–Rao bound"},
        number: {f"{name}, %": name for name in models},
    }
    draw_bars(list(groups.values()), "", panels, title, path)


STUDIES = (
    Study(
        "grasp-contacts",
        "Contacts of grasps one by one in mm, by inversion of design and calibrated twin.",
        run_grasp_contacts,
    ),
)

"""Contacts in grasps of two faces, one by one in mm, read by inversion of the forward model."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from instobj.experiments.paper.contact_baselines import of_networks, pursued
from instobj.experiments.paper.figures import draw_bars, headline
from instobj.experiments.paper.grasps import grasps_of
from instobj.experiments.paper.object import SIMULATED, SimulatedObject, simulated_object
from instobj.experiments.registry import Study, StudyResult

if TYPE_CHECKING:
    from design.spec.object import ObjectSpec
    from estimator.frames.dataset import FrameSet
    from estimator.inversion.inversion import Inversion
    from estimator.inversion.readings import ContactSets

_MOST_FRAMES, _QUICK_FRAMES = 800, 30
_EVERY_PLACE = 4
"""Of the contact locations one in so many is labelled."""
_CALIBRATION_SEED = 200
_REGIONS = ("place in 90 % region %", "force in 90 % interval %")
"""Columns that readings without uncertainty have not."""


def run_grasp_contacts(spec: ObjectSpec, folder: Path, quick: bool) -> StudyResult:
    """Number, places and forces of the contacts of both jaws, beside the Cramér–Rao bound."""
    from estimator.inversion.matching import all_counts, chosen_frames

    recorded = simulated_object(spec, quick)
    frames = chosen_frames(grasps_of(recorded), _QUICK_FRAMES if quick else _MOST_FRAMES)
    rows = []
    readers = _readers(recorded)
    for name, inversion in readers.items():
        rows += _judged(name, inversion, inversion.read(all_counts(frames))[0], frames)
    twin = readers["calibrated twin"]
    for name, found in (
        ("matching pursuit, calibrated twin", pursued(twin, frames)),
        ("whole-object networks", of_networks(recorded, frames)),
    ):
        rows += [row | dict.fromkeys(_REGIONS) for row in _judged(name, twin, found, frames)]
    shown = [row for row in rows if row["force"] == "from 4 N"]
    _draw(
        shown, headline("contacts in grasps, from 4 N a face", quick), folder / "grasp-contacts.png"
    )
    texts = [
        SIMULATED,
        f"{len(frames)} frames of grasps with one, two and three tips a jaw, each read by itself; all "
        "contacts anywhere are possible. The calibrated twin has seen labelled single presses at one "
        f"contact location in {_EVERY_PLACE} of both faces and no grasp; the design nothing of the "
        "object.",
        "possible: mean distance that the Cramér–Rao bound leaves an unbiased estimator that knows the "
        "number of contacts and nothing of their places. Known faces, borders and probes can do "
        "better. probes known: tips of a face are one of the paper's probes and bear alike within 30 %.",
        "Baselines: matching pursuit adds signals of presses 3 mm apart from the calibrated twin's table; "
        "the networks were fitted to the paper's collection of both faces of the object itself, probes "
        "of two and three tips included.",
        "Not covered: tangential forces, drift, a core that slipped, tips of another shape.",
    ]
    return StudyResult(rows, texts)


def _readers(recorded: SimulatedObject) -> dict[str, Inversion]:
    from estimator.inversion.inversion import KNOWN_FORCE_SPREAD, inversion, probe_spacing_mm
    from estimator.inversion.noise import design_error
    from estimator.signals.presses import press_signals

    design, presses = recorded.design, recorded.design_presses
    signals = press_signals(design, *presses)
    error, modulus = design_error(design, *presses, signals), design.tolerances.modulus_relative
    calibrated = _calibrated(recorded)
    known = replace(
        calibrated.priors,
        force_spread=KNOWN_FORCE_SPREAD,
        spacing_mm=probe_spacing_mm(design.indenter.radius_mm),
    )
    return {
        "design": inversion(design, *presses, signals, error, modulus),
        "calibrated twin": calibrated,
        "calibrated twin, probes known": replace(calibrated, priors=known),
    }


def _calibrated(recorded: SimulatedObject) -> Inversion:
    """The twin that labelled single presses of both faces show."""
    from estimator.frames.press_protocol import simulate_presses
    from instobj.stages.makers.twin import TwinOfData

    again = recorded.spec.changed(seed=recorded.spec.seed + _CALIBRATION_SEED)
    frames = simulate_presses(again, recorded.signals, recorded.key)
    pressed = [
        np.unique(frames.place_id[(frames.contact_face == face).any(axis=1)])[::_EVERY_PLACE]
        for face in recorded.spec.collection.grasp_faces
    ]
    labelled = frames.select(np.isin(frames.place_id, np.concatenate(pressed)))
    twin = TwinOfData(recorded.design, recorded.design_presses, recorded.key, draws=0)
    return twin.inverted(labelled, lambda _: None)


def _judged(
    name: str, inversion: Inversion, found: ContactSets, frames: FrameSet
) -> list[dict[str, Any]]:
    from estimator.inversion.matching import rows_beside_bound

    return [{"model": name} | row for row in rows_beside_bound(inversion, frames, found)]


def _draw(rows: list[dict[str, Any]], title: str, path: Path) -> None:
    """Bars by number of tips, one colour for each model."""
    distance, number = "distance to the true contact (mm)", "frames with every number right (%)"
    groups: dict[int, dict[str, Any]] = {}
    for row in rows:
        group = groups.setdefault(row["tips a face"], {"": f"{row['tips a face']} a face"})
        group[f"{row['model']}, mm"] = row["distance mm"]
        group[f"{row['model']}, %"] = row["number right %"]
        group["possible, mm"] = row["possible mm"]
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

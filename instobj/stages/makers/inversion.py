"""Estimators that invert the forward model, and how well they read contacts."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from design.layout.body import face_frames
from design.layout.tips import tip_shape
from design.spec.object import LARGEST_SEED
from instobj.stages.makers.collection import stored_shear
from instobj.store.readers import (
    CONTACT_METRICS,
    CONTACT_PICTURE,
    CORRECTION,
    INVERSION,
    PRESSES,
    RESPONSE,
    SIGNALS,
)
from instobj.store.stage import StageContext, Step, write_json

if TYPE_CHECKING:
    from design.spec.object import ObjectSpec
    from estimator.frames.dataset import FrameSet
    from estimator.inversion.inversion import Inversion

MOST_FRAMES = 400
"""Judged at most, drawn at random: a frame takes some tens of milliseconds."""
_OBJECT_SEED = 1000
"""Added to the seed, so that the object drawn is none of the training's."""
_PRESSES = 24
"""Presses that are inverted, for each number of contacts."""
_FRAMES_A_PRESS = 8
"""Frames of each."""
_FLAT_FINGERS = (
    "Flat fingers on curved faces may be read as too weak or as two tips, and explained: for these train "
    'with the finger itself, --set indenter.kind=cuboid --set "indenter.size_mm=[WIDTH,LENGTH]"'
)
"""Measured of a rigid finger of 14 mm on three bodies by `benchmarks/jaw_readings.py`."""


def tangential_mechanics(spec: ObjectSpec) -> dict[str, tuple[str, ObjectSpec]]:
    """The stage of tangential forces, where contacts may pull sideways."""
    return {"shear": ("shear", spec)} if spec.inversion.tangential_share else {}


def make_inversion(context: StageContext, folder: Path) -> None:
    """The estimator of the design, as wrong as `[tolerances]` make it."""
    from estimator.inversion.inversion import inversion
    from estimator.inversion.model.noise import design_error
    from estimator.inversion.storage import save_inversion
    from fem.presses.jaws import coverable_faces, jaw_faces

    forces, motions = context.read(PRESSES)
    signals = context.read(SIGNALS)
    context.step("error of the design within its tolerances")
    error = design_error(context.spec, forces, motions, signals)
    modulus = context.spec.tolerances.modulus_relative
    shear = stored_shear(context)
    context.step("tables of presses")
    tips = inversion(context.spec, forces, motions, signals, error, modulus, shear)
    context.step("faces for jaws")
    flat = coverable_faces(context.spec)
    jaws = jaw_faces(context.spec, context.read(RESPONSE), flat) if flat else ()
    save_inversion(replace(tips, jaw_tables=jaws), INVERSION.path(folder))


def make_contact_metrics(context: StageContext, folder: Path) -> None:
    """Measure readings of one to three contacts anywhere on an object that the inversion has not seen, used
    as `limits.use` says; single ones pull sideways where it expects that. Where such contacts cannot be
    simulated the result says why."""
    from estimator.frames.collection import joined
    from estimator.frames.contact_traces import JointMechanics
    from estimator.frames.press_protocol import with_nuisances
    from estimator.signals.nuisances import nuisance_columns
    from estimator.tolerances.virtual_object import drawn_assembly, twin_signals

    spec = context.spec
    if reason := _why_not_judged(spec):
        content = {"judged": f"nothing, as {reason}", "frames": 0, "contacts": []}
        write_json(content, CONTACT_METRICS.path(folder))
        return
    assembly = drawn_assembly(spec, spec.seed + _OBJECT_SEED)
    signals = twin_signals(spec, assembly, *context.read(PRESSES))
    mechanics = JointMechanics(context.read(RESPONSE), context.read(CORRECTION), assembly)
    parts = _presses_anywhere(spec, signals, mechanics, context)
    frames, most = joined(parts), ("one contact", "one or two contacts", "one to three contacts")
    judged = f"{most[len(parts) - 1]} anywhere on a virtual object within the tolerances"
    if (columns := nuisance_columns(spec)).size:
        shape = (*frames.signal_counts.shape[1:], columns.shape[1])
        frames = with_nuisances(frames, columns.reshape(shape), spec.seed)
        judged += ", turned and warmed since its zero"
    if tip_shape(spec.indenter).ellipsoid is not None and not all(
        f.flat for f in face_frames(spec)
    ):
        judged += f", pressed by the {spec.indenter.kind}. {_FLAT_FINGERS}"
    write_contact_metrics(context.read(INVERSION), frames, judged, folder, context.step)


def _why_not_judged(spec: ObjectSpec) -> str:
    """Return why contacts anywhere cannot be simulated jointly; "" where they can."""
    if spec.mechanics.slip.slipped:
        return "contacts at once cannot be simulated on a core that has slipped"
    if spec.indenter.tip_count > 1:
        return f"the indenter presses with {spec.indenter.tip_count} tips at once"
    return ""


def _presses_anywhere(
    spec: ObjectSpec, signals: Any, mechanics: Any, context: StageContext
) -> list[FrameSet]:
    """Return frames of presses by one, two and three tips; small faces have room for fewer."""
    from estimator.frames.collection import simulate_collection
    from estimator.frames.contact_cases import NoRoom

    shear, parts = stored_shear(context), []
    for contacts in (1, 2, 3):
        context.step(f"presses of {contacts} tips at once")
        collection = spec.collection.changed(
            kind="continuous", presses=_PRESSES, contacts=contacts, faces=spec.body.sensed,
            tangential_share=spec.inversion.tangential_share if contacts == 1 else 0.0,
        )  # fmt: skip
        protocol = spec.protocol.changed(frames_per_press=(2, _FRAMES_A_PRESS))
        wanted = spec.changed(
            collection=collection,
            protocol=protocol,
            seed=(spec.seed + _OBJECT_SEED + contacts) % LARGEST_SEED,
        )
        try:
            parts.append(simulate_collection(wanted, signals, context.key, mechanics, shear=shear))
        except NoRoom:
            if contacts == 1:
                raise
            break
    return parts


def write_contact_metrics(
    inversion: Inversion,
    frames: FrameSet,
    judged: str,
    folder: Path,
    step: Step,
) -> None:
    """`CONTACT_METRICS` and its picture: contacts found in at most 400 of the frames, compared with
    the Cramér–Rao bound of the places."""
    from estimator.frames.windows import all_counts, chosen_rows
    from estimator.metrics.contacts import contact_rows, matched_contacts, possible_distance_mm
    from instobj.figures.contacts import draw_contacts

    chosen = frames.select(chosen_rows(frames, MOST_FRAMES))
    best, second = inversion.read(
        all_counts(chosen), progress=lambda done: step(f"frame {done} of {len(chosen)}")
    )
    matched = matched_contacts(chosen, best)
    table = contact_rows(matched, possible_distance_mm(inversion, chosen))
    content = {
        "judged": judged,
        "frames": len(chosen),
        "unexplained frames %": round(100 * float(np.mean(~best.explained)), 2),
        "frames with a second answer above 10 %": int((second.odds > 0.1).sum()),
        "contacts": table,
    }
    write_json(content, CONTACT_METRICS.path(folder))
    draw_contacts(chosen, best, matched, CONTACT_PICTURE.path(folder))

"""Maker of the stage that simulates recordings. Heavy imports stay inside."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from instobj.store.readers import (
    COLLECTION_SUMMARY,
    CORRECTION,
    PRESSES,
    RESPONSE,
    SHEAR,
    SIGNALS,
    collection_path,
)
from instobj.store.stage import StageContext, write_json

if TYPE_CHECKING:
    from estimator.frames.dataset import FrameSet
    from estimator.information.shear import ShearSignals


def make_collection(context: StageContext, folder: Path) -> None:
    """`frames_<kind>.nc` and what is in it."""
    from estimator.frames.collection import simulate_collection
    from estimator.frames.contact_traces import JointMechanics
    from estimator.frames.dataset import save_frames

    spec, inputs = context.spec, context.inputs
    signals = SIGNALS.read(inputs["signals"])
    shear = stored_shear(context) if spec.collection.tangential_share else None
    mechanics = JointMechanics(
        RESPONSE.read(inputs["response"]), CORRECTION.read(inputs["large_strain"])
    )
    frames = simulate_collection(spec, signals, context.key, mechanics, context.step, shear)
    write_json(collection_summary(frames), COLLECTION_SUMMARY.path(folder))
    context.step("writing the frames")
    save_frames(frames, collection_path(folder, spec.collection.kind))


def stored_shear(context: StageContext) -> ShearSignals | None:
    """Signals of tangential forces, where the stage was given their mechanics."""
    from estimator.information.shear import shear_signals

    if "shear" not in context.inputs:
        return None
    _, motions = context.read(PRESSES)
    return shear_signals(context.spec, motions, context.read(SHEAR))


def collection_summary(frames: FrameSet) -> dict[str, Any]:
    """Numbers of frames, cases and presses, and the range of force (N)."""
    import numpy as np

    from estimator.frames.dataset import NO_FACE
    from estimator.frames.press_protocol import REST_PLACE_ID

    pressed = (frames.contact_face != NO_FACE).any(axis=1)
    force = frames.force_n[frames.valid & pressed][..., 2]
    return {
        "frames": len(frames),
        "contact_frames": int(pressed.sum()),
        "contact_cases": len(np.setdiff1d(frames.place_id, [REST_PLACE_ID])),
        "presses": len(np.unique(frames.press_id)),
        "most_contacts": int((frames.contact_face != NO_FACE).sum(axis=1).max()),
        "smallest_force_n": float(np.nanmin(force)),
        "largest_force_n": float(np.nanmax(force)),
    }

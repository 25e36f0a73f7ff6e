"""Forces in three directions, read as heatmaps of Fx, Fy and Fz."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from instobj.figures.saving import save_figure
from instobj.store.readers import PRESSES, SHEAR
from studies.layouts import changed
from studies.paper.figures import headline
from studies.paper.object import (
    SIMULATED,
    SimulatedObject,
    fitted_to_split,
    simulated_object,
)
from studies.registry import Study, StudyResult

if TYPE_CHECKING:
    from design.spec.object import ObjectSpec
    from estimator.information.shear import ShearSignals

SHARE = 0.3
"""Largest tangential force over the normal force."""
_AXES = ("Fx", "Fy", "Fz")


def run_3d_force(spec: ObjectSpec, folder: Path, quick: bool) -> StudyResult:
    """Presses anywhere, pulled sideways; the paper names this as open."""
    from estimator.frames.collection import simulate_collection
    from estimator.frames.face_data import face_data
    from estimator.frames.splits import split_presses
    from estimator.networks.face_model import predict

    recorded = simulated_object(spec, quick)
    face = recorded.spec.collection.faces[0]
    wanted: dict[str, Any] = {"kind": "continuous", "faces": [face], "tangential_share": SHARE}
    asked = changed(recorded.spec, {f"collection.{name}": value for name, value in wanted.items()})
    frames = simulate_collection(
        asked, recorded.signals, recorded.key, recorded.mechanics, shear=shear_of(recorded)
    )
    model, _, test = fitted_to_split(recorded, frames, split_presses, face, wanted, axes=3)
    data = face_data(test, face)
    data = data.select(data.contact)
    true, found = (
        maps.sum(axis=(2, 3)) for maps in (data.force_maps_n, predict(model, data.frames).heatmap_n)
    )
    rows = [_row(axis, true[:, k], found[:, k]) for k, axis in enumerate(_AXES)]
    title = headline(f"presses anywhere on face {face} that pull sideways, held out", quick)
    _draw(true, found, title, folder / "3d-force.png")
    texts = [
        SIMULATED,
        f"Face {face}, presses anywhere, tangential force up to {SHARE:g} of the normal force, whole "
        "presses held out; what a tangential force adds is that of the design. The paper reads the "
        "normal force alone. Relative error: over that of a constant-mean predictor.",
    ]
    return StudyResult(rows, texts)


def shear_of(recorded: SimulatedObject) -> ShearSignals:
    from estimator.information.shear import shear_signals
    from instobj.stages.run import Run

    run = Run(recorded.spec)
    shear = run.read(SHEAR)
    _, motions = run.read(PRESSES)
    return shear_signals(recorded.spec, motions, shear)


def _row(axis: str, true: np.ndarray, found: np.ndarray) -> dict[str, Any]:
    missed = np.abs(found - true)
    guessed = np.abs(true - true.mean()).mean()
    return {
        "axis": axis,
        "frames": len(true),
        "rms force N": round(float(np.sqrt(np.mean(true**2))), 3),
        "mean error N": round(float(missed.mean()), 4),
        "error % of range": round(float(100 * missed.mean() / np.ptp(true)), 2),
        "error relative to a constant-mean predictor": round(float(missed.mean() / guessed), 3),
        "correlation": round(float(np.corrcoef(true, found)[0, 1]), 4),
    }


def _draw(true: np.ndarray, found: np.ndarray, title: str, path: Path) -> None:
    from matplotlib.figure import Figure

    figure = Figure(figsize=(10, 3.5), layout="constrained")
    for k, axes in enumerate(figure.subplots(1, 3)):
        chosen = slice(None, None, max(1, len(true) // 3000))
        axes.plot(true[chosen, k], found[chosen, k], ".", ms=2, alpha=0.5)
        ends = [true[:, k].min(), true[:, k].max()]
        axes.plot(ends, ends, color="0.3", lw=1)
        axes.set(xlabel=f"true {_AXES[k]} (N)", ylabel=f"estimated {_AXES[k]} (N)")
        axes.grid(alpha=0.3)
    figure.suptitle(title, fontsize=10)
    save_figure(figure, path)


STUDIES = (Study("3d-force", "Heatmaps of Fx, Fy and Fz of presses that also pull.", run_3d_force),)

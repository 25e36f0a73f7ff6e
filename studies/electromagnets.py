"""Electromagnets in the magnets' place, switched on face by face, as Knopke et al. (RA-L 2024) propose.

Outside, a coil has the field of a body polarized along its axis by μ0 N I / L: here a magnet of the
coil's outline whose polarization gives the moment of the winding. Of a thick winding it is
7 % too small at 8 mm, where the paper's sensors are, and 5 % at 10 mm (tests/studies).
"""

from __future__ import annotations

from dataclasses import replace
from math import pi
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from design.spec.object import ObjectSpec
from instobj.search.fidelity import score_row
from instobj.store.readers import PRESSES
from studies.layouts import QUICK_MESH, changed
from studies.registry import Study, StudyResult
from studies.variant_figure import draw_variants

if TYPE_CHECKING:
    from estimator.signals.presses import Signals
    from fem.presses.results import MagnetMotions, PressForces

MU0_T_MM_PER_A = 4e-4 * pi
"""Permeability of vacuum, T·mm/A."""
TURNS, CURRENT_A, HOLE_MM = 80, 0.3, 2.0
"""Wire of 0.1 mm in an outline of Ø6 × 1 mm, and a current that it carries for a while."""


def coil_polarization_t(spec: ObjectSpec) -> float:
    """Polarization of the whole outline that has a winding's moment, T."""
    size, hole = spec.magnets.sizes[0], HOLE_MM / 2
    outer = size.half_mm[0]
    # turns fill the outline from hole to outer radius: the mean of r² over them, over the outline's
    filling = (outer**2 + outer * hole + hole**2) / (3 * outer**2)
    return MU0_T_MM_PER_A * TURNS * CURRENT_A / size.height_mm * filling


def coil_remanence_t(spec: ObjectSpec) -> float:
    """Remanence of a magnet that, demagnetised by itself, has the polarization of a winding, T."""
    from estimator.field.sources import magnet_source

    at_work = magnet_source(spec.magnets).polarization_t
    return coil_polarization_t(spec) * spec.magnets.remanences_t[0] / at_work


def face_by_face(spec: ObjectSpec, forces: PressForces, motions: MagnetMotions) -> Signals:
    """Signals of presses, each face's sensors read while its own magnets alone are on."""
    from estimator.tolerances.assembly import designed
    from estimator.tolerances.virtual_object import twin_signals

    whole = designed(spec)
    magnets, sensor_face = whole.scene.magnets, whole.scene.sensors.face
    found = twin_signals(spec, whole, forces, motions)
    delta, baseline = found.delta_counts.copy(), found.baseline_counts.copy()
    for face in np.unique(sensor_face):
        on = replace(magnets, strength=np.where(magnets.face == face, magnets.strength, 0.0))
        lit = replace(whole, scene=replace(whole.scene, magnets=on))
        signals, own = twin_signals(spec, lit, forces, motions), sensor_face == face
        delta[..., own, :] = signals.delta_counts[..., own, :]
        baseline[own] = signals.baseline_counts[own]
    return replace(found, delta_counts=delta, baseline_counts=baseline)


def run_electromagnets(spec: ObjectSpec, folder: Path, quick: bool) -> StudyResult:
    """Permanent magnets against electromagnets that are all on, or on face by face."""
    from estimator.layouts.fidelity import score_signals
    from estimator.signals.presses import press_signals
    from instobj.stages.run import Run

    spec = changed(spec, QUICK_MESH) if quick else spec
    coils: dict[str, Any] = {
        "magnets.grade": None,
        "magnets.remanence_t": coil_remanence_t(spec),
    }
    wound = changed(spec, coils)
    presses = Run(spec).read(PRESSES)
    variants = {
        "permanent magnets": (spec, press_signals(spec, *presses)),
        "electromagnets, all on": (wound, press_signals(wound, *presses)),
        "electromagnets, face by face": (wound, face_by_face(wound, *presses)),
    }
    rows = [
        {"variant": name} | score_row(score_signals(one, signals, *presses))
        for name, (one, signals) in variants.items()
    ]
    draw_variants(rows, spec.score.force_n, folder / "scores.png")
    text = (
        f"{TURNS} turns at {CURRENT_A:g} A in the magnets' outline are worth "
        f"{1e3 * coil_polarization_t(spec):.3g} mT of polarization, a magnet "
        f"{1e3 * spec.magnets.remanences_t[0]:.4g} mT."
    )
    return StudyResult(rows, [text])


STUDIES = (
    Study(
        "electromagnets",
        "Electromagnets, switched on face by face, against the cross-talk between faces.",
        run_electromagnets,
    ),
)

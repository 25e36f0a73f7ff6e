"""Forces of all tips and signals of contact cases that are pressed ever deeper.

Single tips come from the table of presses; several together from contact solved jointly
(`fem.presses.joint`), at the table's depths.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from design.errors import InputError
from design.spec.object import ObjectSpec
from estimator.frames.contact_cases import ContactCase
from estimator.signals.interpolation import press_traces
from estimator.signals.monotone import monotone_cubic
from estimator.signals.presses import Progress, Signals
from estimator.tolerances.assembly import Assembly, designed
from estimator.tolerances.virtual_object import twin_changes
from fem.large_strain.correction import StrainCorrection, corrected_joint
from fem.linear.response import ResponseOperator
from fem.presses.joint import JointPress, Tip, press_path, refined_faces
from fem.presses.to_force import squeeze_path


@dataclass(frozen=True)
class JointMechanics:
    """Mechanics that contact between several tips is solved on; `assembly` where the object is a twin."""

    response: ResponseOperator
    correction: StrainCorrection | None = None
    assembly: Assembly | None = None


@dataclass(frozen=True)
class ContactTraces:
    """Cases by growing travel; node 0 is rest.

    `travel_mm` (case, node): of the indenter, or the sum of both jaws'. `tip_force_n` (case, node,
    tip), 0 for tips that a case has not; `force_n` (case, node) their sum. `counts` (case, node,
    channel) are changes against rest.
    """

    travel_mm: Float[np.ndarray, "case node"]
    force_n: Float[np.ndarray, "case node"]
    tip_force_n: Float[np.ndarray, "case node tip"]
    counts: Float[np.ndarray, "case node channel"]

    @property
    def reach_n(self) -> Float[np.ndarray, "case"]:
        """Total force at the deepest press."""
        return self.force_n[:, -1]


def contact_traces(
    spec: ObjectSpec,
    signals: Signals,
    cases: Sequence[ContactCase],
    mechanics: JointMechanics | None = None,
    progress: Progress | None = None,
) -> ContactTraces:
    """Traces of all cases, in order.

    Raises
    ------
    InputError
        Cases of several tips without mechanics, on a slipped shell or with a probe of several
        tips for an indenter; a place outside the lattice or over a face's border.
    """
    several = [index for index, case in enumerate(cases) if len(case.face) > 1]
    single = np.setdiff1d(np.arange(len(cases)), several)
    shape = (len(cases), len(signals.depth_mm) + 1)
    travel, force = np.zeros(shape), np.zeros(shape)
    tip_force = np.zeros((*shape, max(len(case.face) for case in cases)))
    counts = np.zeros((*shape, signals.baseline_counts.size))
    if len(single):
        face = np.array([cases[index].face[0] for index in single])
        x, y = np.array([cases[index].xy_mm[0] for index in single]).T
        traces = press_traces(signals, face, x, y)
        travel[single], force[single] = traces.depth_mm, traces.force_n
        tip_force[single, :, 0], counts[single] = traces.force_n, traces.counts
    if several:
        joint = _joint_presses(
            spec, signals, [cases[index] for index in several], mechanics, progress
        )
        for index, (moved, forces, changes) in zip(several, joint, strict=True):
            travel[index, 1:], force[index, 1:] = moved, forces.sum(axis=1)
            tip_force[index, 1:, : forces.shape[1]], counts[index, 1:] = forces, changes
    return ContactTraces(travel, force, tip_force, counts)


def force_at_travel(
    traces: ContactTraces, travel_mm: Float[np.ndarray, "case frame"]
) -> Float[np.ndarray, "case frame"]:
    """Total force (N); that of the deepest press beyond it."""
    held = np.clip(travel_mm, 0.0, traces.travel_mm[:, -1:])
    return monotone_cubic(traces.travel_mm**1.5, traces.force_n[..., None], held**1.5)[..., 0]


def travel_at_force(
    traces: ContactTraces, force_n: Float[np.ndarray, "case frame"]
) -> Float[np.ndarray, "case frame"]:
    """Travel (mm) to a total force; the deepest where that is less."""
    held = np.minimum(force_n, traces.force_n[:, -1:])
    return monotone_cubic(traces.force_n, traces.travel_mm[..., None] ** 1.5, held)[..., 0] ** (
        2 / 3
    )


def _joint_presses(
    spec: ObjectSpec,
    signals: Signals,
    cases: Sequence[ContactCase],
    mechanics: JointMechanics | None,
    progress: Progress | None,
) -> list[tuple[np.ndarray, np.ndarray, np.ndarray]]:
    """Travel (step,), forces (step, tip) and changes of counts (step, channel) of every case."""
    if mechanics is None or spec.mechanics.slip.slipped or spec.indenter.tip_count > 1:
        raise InputError(
            "several simultaneous tips need the response operator, a shell that has not slipped and "
            "indenter.tip_count = 1. Simulate single contacts, or set mechanics.slip and tip_count so"
        )
    faces, pressed = refined_faces(spec, mechanics.response), []
    assembly = mechanics.assembly or designed(spec)
    for number, case in enumerate(cases, start=1):
        tips = [
            Tip(int(f), float(x), float(y)) for f, (x, y) in zip(case.face, case.xy_mm, strict=True)
        ]
        if case.squeezed:
            jaws = [
                [tip for tip, cell in zip(tips, case.cell, strict=True) if cell == c]
                for c in (0, 1)
            ]
            steps = spec.collection.grasp_force_n * (signals.depth_mm / signals.depth_mm[-1]) ** 1.5
            path = squeeze_path(spec, mechanics.response, (jaws[0], jaws[1]), steps.tolist(), faces)
        else:
            path = press_path(
                spec, mechanics.response, tips, signals.depth_mm[:, None] * case.share, faces
            )
        travel, force, motion = corrected_traces(spec, case, path, mechanics.correction)
        pressed.append((travel, force * assembly.modulus_ratio, motion))
        if progress is not None and number % 10 == 0:
            progress(f"several simultaneous tips: {number} of {len(cases)} cases")
    motions = np.concatenate([motion for _, _, motion in pressed])
    parts = twin_changes(spec, assembly, motions).reshape(len(cases), len(signals.depth_mm), -1)
    return [(t, f, changes) for (t, f, _), changes in zip(pressed, parts, strict=True)]


def corrected_traces(
    spec: ObjectSpec,
    case: ContactCase,
    path: Sequence[JointPress],
    correction: StrainCorrection | None,
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    depth = np.stack([press.depth_mm for press in path])
    force = np.stack([press.force_n for press in path])
    motion = np.stack([press.motion for press in path])
    if correction is not None:
        force, motion = corrected_joint(spec, case.face, depth, force, motion, correction)
    travel = depth.max(axis=1)
    if case.squeezed:
        travel = depth[:, case.cell == 0].max(axis=1) + depth[:, case.cell == 1].max(axis=1)
    return travel, force, motion

"""The estimator that inverts calibrated twins: of faces with single presses, or of a whole object."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Protocol, runtime_checkable

import numpy as np
from jaxtyping import Float

from design.layout.places.positions import sensor_layout
from design.spec.object import ObjectSpec
from estimator.calibration.twin.grasp_twin import GraspTwin, sensor_errors
from estimator.calibration.twin.pressed_cases import PressedCases
from estimator.frames.dataset import NO_FACE
from estimator.information.shear import ShearSignals
from estimator.inversion.inversion import Inversion, inversion
from estimator.inversion.model.forward import NONE
from estimator.inversion.model.noise import MESH_ERROR, design_error
from estimator.inversion.problems import BLIND
from estimator.signals.presses import Signals, press_signals
from fem.presses.results import MagnetMotions, PressForces


@runtime_checkable
class FaceTwin(Protocol):
    """Knowledge of one face, as `estimator.calibration.twin.digital_twin.CalibratedTwin` has it."""

    @property
    def modulus_error(self) -> float: ...

    def signals(self) -> Signals: ...


def inverted_twin(
    spec: ObjectSpec,
    forces: PressForces,
    motions: MagnetMotions,
    twins: Mapping[int, FaceTwin],
    left_share: Mapping[int, float],
    shear: ShearSignals | None = None,
    noise_counts: Float[np.ndarray, "3"] | None = None,
) -> Inversion:
    """An estimator of the object that labelled presses show, and of the design on other faces.

    `left` is the share of the signals that each face's twin leaves at places that it has not seen.
    What a press shows on other faces' sensors is the design's, with the twin's core and modulus;
    `shear`, what tangential forces add, is the design's. `noise_counts` is the white noise of the axes as
    recorded, the specification's if left out.

    Raises
    ------
    InputError
        Labelled presses that fit no object of the specification, or tangential forces without
        `shear`.
    """
    design = press_signals(spec, forces, motions)
    signals = design
    for face, twin in twins.items():
        signals = _with_face(signals, twin.signals(), face)
    errors = _errors(spec, design_error(spec, forces, motions, design), left_share)
    estimator = inversion(spec, forces, motions, signals, errors, _force_error(spec, twins), shear)
    return estimator if noise_counts is None else _with_noise(estimator, noise_counts)


def inverted_grasps(
    spec: ObjectSpec,
    presses: tuple[PressForces, MagnetMotions],
    twin: GraspTwin,
    pressed: PressedCases,
    shear: ShearSignals | None = None,
) -> Inversion:
    """An estimator of the object that presses of several contacts together show.

    It is as wrong at each sensor as it was in cases left out, and at all of them so much more as makes
    its regions hold the labelled contacts: errors of sensors that go together (a label off its
    place, a core off its seat) move contacts further than independent ones would. Channels with gaps in
    the labelled presses are not read.

    Raises
    ------
    InputError
        Labelled presses that fit no object of the specification.
    """
    sensors = len(sensor_layout(spec).face)
    errors = np.maximum(sensor_errors(pressed, twin.residual, sensors), MESH_ERROR)
    estimator = inversion(spec, *presses, twin.signals(*presses), errors, twin.modulus_error, shear)
    estimator = _with_noise(estimator, pressed.noise_counts)
    wider = max(1.0, region_excess(estimator, twin, pressed))
    disturbances = estimator.disturbances
    blind = np.full(len(disturbances.noise_counts), BLIND)
    blind[pressed.channels] = disturbances.noise_counts[pressed.channels]
    disturbances = replace(
        disturbances, noise_counts=blind, model_error=disturbances.model_error * wider
    )
    return replace(estimator, disturbances=disturbances)


def _with_noise(inversion: Inversion, noise_counts: Float[np.ndarray, "3"]) -> Inversion:
    """White noise as the labelled presses show it, in all channels that are read."""
    disturbances = inversion.disturbances
    noise = np.tile(noise_counts, len(disturbances.noise_counts) // 3)
    noise = np.where(disturbances.noise_counts < BLIND, noise, disturbances.noise_counts)
    return replace(inversion, disturbances=replace(disturbances, noise_counts=noise))


def region_excess(inversion: Inversion, twin: GraspTwin, pressed: PressedCases) -> float:
    """Return how many times further than the regions say cases left out move the labelled contacts: rms over
    all of them, in standard deviations (Gauss–Newton step of the labelled contacts)."""
    model = inversion.model
    index = {int(face): row for row, face in enumerate(model.signals.faces)} | {NO_FACE: NONE}
    cases, levels, contacts = pressed.force_n.shape
    face = np.vectorize(index.__getitem__, otypes=[int])(pressed.face).repeat(levels, axis=0)
    xy = pressed.xy_mm.repeat(levels, axis=0)
    contact = np.concatenate([xy, pressed.force_n.reshape(-1, contacts, 1)], axis=2)
    counts, residual = np.full((2, cases * levels, model.channels), np.nan)
    counts[:, pressed.channels] = pressed.counts.reshape(cases * levels, -1)
    residual[:, pressed.channels] = twin.residual.reshape(cases * levels, -1)
    white = inversion.disturbances.observed(counts).white
    slopes = white(model.singles(face, contact)[:, :, 1:].reshape(len(face), -1, model.channels))
    # Jᵀr of what is left over: r row (case and level), p parameter, c channel. Then pullᵀ (JᵀJ)⁻¹ pull is
    # the squared shift of the parameters in standard deviations.
    pull = np.einsum("rpc,rc->rp", slopes, white(np.nan_to_num(residual)[:, None])[:, 0])
    inverse = np.linalg.pinv(slopes @ slopes.transpose(0, 2, 1), rcond=1e-9, hermitian=True)
    square = np.einsum("rp,rpq,rq->r", pull, inverse, pull)
    return float(np.sqrt(np.mean(square / (3 * np.sum(face != NONE, axis=1)))))


def _with_face(whole: Signals, replacement: Signals, face: int) -> Signals:
    row = int(np.flatnonzero(whole.faces == face)[0])
    force, delta = whole.force_n.copy(), whole.delta_counts.copy()
    force[row], delta[row] = replacement.force_n[0], replacement.delta_counts[0]
    return replace(whole, force_n=force, delta_counts=delta)


def _errors(
    spec: ObjectSpec, design_motion: float, left_share: Mapping[int, float]
) -> Float[np.ndarray, "sensor 1"]:
    of_face = [left_share.get(face, design_motion) for face in sensor_layout(spec).face.tolist()]
    return np.array(of_face)[:, None]


def _force_error(spec: ObjectSpec, twins: Mapping[int, FaceTwin]) -> float:
    """That of the modulus: of the worst face's labels, or of the design where a face has none."""
    if set(twins) != set(spec.body.sensed):
        return spec.tolerances.modulus_relative
    return max(twin.modulus_error for twin in twins.values())

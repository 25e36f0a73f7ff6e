"""The estimator that inverts calibrated twins of faces."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Protocol, runtime_checkable

import numpy as np
from jaxtyping import Float

from design.layout.places.positions import sensor_layout
from design.spec.object import ObjectSpec
from estimator.information.shear import ShearSignals
from estimator.inversion.inversion import Inversion, inversion
from estimator.inversion.model.noise import design_error
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


def _with_noise(inversion: Inversion, noise_counts: Float[np.ndarray, "3"]) -> Inversion:
    """White noise as the labelled presses show it, in all channels that are read."""
    disturbances = inversion.disturbances
    noise = np.tile(noise_counts, len(disturbances.noise_counts) // 3)
    noise = np.where(disturbances.noise_counts < BLIND, noise, disturbances.noise_counts)
    return replace(inversion, disturbances=replace(disturbances, noise_counts=noise))


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

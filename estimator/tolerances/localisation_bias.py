"""Localisation bias of an estimator calibrated on the design, in presses of another object.

Weighted least squares about the design's own signals, each object zeroed as it is: what
`estimator.layouts.robustness` estimates for many layouts at once. Mechanics is that of the design.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from jaxtyping import Float

from design.spec.object import ObjectSpec
from estimator.tolerances.assembly import Assembly, assembled, draw
from estimator.tolerances.budget import Setting, calibrated_estimator, outcome_of, setting_of
from fem.presses.results import MagnetMotions, PressForces

OBJECTS = 12
_SPREAD_MM = 0.5
"""Of a shift that is then set to any length; within what a specification may say."""


def false_places_mm(
    spec: ObjectSpec, forces: PressForces, motions: MagnetMotions, slip_mm: float
) -> dict[str, Float[np.ndarray, "press"]]:
    """Place errors (rms), presses face by face at the forces of `estimator.tolerances.budget`.

    `slip`: where the core has slipped by `slip_mm` along ±x, ±y and ±z of the object, presses as
    they were. `tolerance`: over objects within the specification's tolerances, all of them.
    """
    setting = setting_of(spec, forces, motions)
    rng = np.random.default_rng((spec.seed, 8))
    objects = {
        "slip": [_slipped(setting, slip_mm * way) for way in np.vstack([np.eye(3), -np.eye(3)])],
        "tolerance": [draw(spec, setting.design, rng) for _ in range(OBJECTS)],
    }
    return {name: _false_places(setting, some) for name, some in objects.items()}


def _slipped(setting: Setting, shift_mm: Float[np.ndarray, "3"]) -> Assembly:
    spec = setting.spec
    loose = spec.changed(tolerances=spec.tolerances.changed(core_shift_mm=_SPREAD_MM))
    return assembled(loose, setting.design, {"core_shift": shift_mm / _SPREAD_MM})


def _false_places(setting: Setting, objects: Iterable[Assembly]) -> Float[np.ndarray, "press"]:
    nominal = outcome_of(setting, setting.design)
    estimators = [
        calibrated_estimator(setting.spec, jacobian, live)
        for jacobian, live in zip(nominal.jacobian, setting.live, strict=True)
    ]
    squares = []
    for one in objects:
        found = outcome_of(setting, one).delta
        errors = [
            np.einsum("pkc,pc->pk", estimator, after - before)[:, :2]
            for estimator, before, after in zip(estimators, nominal.delta, found, strict=True)
        ]
        squares.append(np.sum(np.concatenate(errors) ** 2, axis=1))
    return np.sqrt(np.mean(squares, axis=0))

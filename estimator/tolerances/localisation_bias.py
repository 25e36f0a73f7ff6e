"""Localisation bias of an estimator calibrated on the design, in presses of another object.

Weighted least squares about the design's own signals, each object zeroed as it is: what
`estimator.layouts.robustness` estimates for many layouts at once. Mechanics is that of the design.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np
from jaxtyping import Float

from design.spec.object import ObjectSpec
from estimator.tolerances.assembly import Assembly, assembled, draw
from estimator.tolerances.budget import Setting, calibrated_estimator, outcome_of, setting_of
from fem.presses.results import MagnetMotions, PressForces

OBJECTS = 8
"""Drawn, within the tolerances but for the core's shift and Earth's field."""
_SPREAD_MM = 0.5
"""Of a shift that is then set to any length; within what a specification may say."""


def false_places_mm(
    spec: ObjectSpec, forces: PressForces, motions: MagnetMotions, slip_mm: float
) -> dict[str, Float[np.ndarray, "press"]]:
    """Place errors (rms), presses face by face at the forces of `estimator.tolerances.budget`.

    `slip`: where the core has slipped by `slip_mm` along ±x, ±y and ±z of the object, presses as
    they were. `tolerance`: of objects within the specification's tolerances, all of them. Errors add up
    by their squares: those by the core's shift and by Earth's field, which make up most of it, direction
    by direction, the others over drawn objects. Medians of one layout scatter by 3 % with the draw (four
    draws).
    """
    setting = setting_of(spec, forces, motions)
    ways = np.eye(3)
    slipped = [_slipped(setting, slip_mm * way) for way in np.vstack([ways, -ways])]
    objects = {
        "slip": [(1 / 6, one) for one in slipped],
        "tolerance": [*_drawn(setting), *_of_each_way(setting)],
    }
    return {name: _false_places(setting, some) for name, some in objects.items()}


_Weighted = tuple[float, Assembly]
"""How much of the mean square an object is."""


def _drawn(setting: Setting) -> Iterator[_Weighted]:
    spec, rng = setting.spec, np.random.default_rng((setting.spec.seed, 8))
    held = {"core_shift_mm": 0.0, "earth_field_ut": 0.0}
    calm = spec.changed(tolerances=spec.tolerances.changed(**held))
    for _ in range(OBJECTS):
        yield 1 / OBJECTS, draw(calm, setting.design, rng)


def _of_each_way(setting: Setting) -> Iterator[_Weighted]:
    """Shifted by one sigma; in an Earth's field that has changed by one."""
    for way in np.eye(3):
        yield 1.0, assembled(setting.spec, setting.design, {"core_shift": way})
        turned = np.sqrt(2) * np.concatenate([0 * way, way])
        yield 1.0, assembled(setting.spec, setting.design, {"earth_field": turned})


def _slipped(setting: Setting, shift_mm: Float[np.ndarray, "3"]) -> Assembly:
    spec = setting.spec
    loose = spec.changed(tolerances=spec.tolerances.changed(core_shift_mm=_SPREAD_MM))
    return assembled(loose, setting.design, {"core_shift": shift_mm / _SPREAD_MM})


def _false_places(setting: Setting, objects: Iterable[_Weighted]) -> Float[np.ndarray, "press"]:
    nominal = outcome_of(setting, setting.design)
    estimators = [
        calibrated_estimator(setting.spec, jacobian, live)
        for jacobian, live in zip(nominal.jacobian, setting.live, strict=True)
    ]
    square = 0.0
    for weight, one in objects:
        found = outcome_of(setting, one).delta
        errors = [
            np.einsum("pkc,pc->pk", estimator, after - before)[:, :2]
            for estimator, before, after in zip(estimators, nominal.delta, found, strict=True)
        ]
        square = square + weight * np.sum(np.concatenate(errors) ** 2, axis=1)
    return np.sqrt(square)

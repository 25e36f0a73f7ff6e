"""Order of presses at which the twin of a specification knows least, for presses as they are done."""

from __future__ import annotations

import numpy as np
from jaxtyping import Int

from design.spec.object import ObjectSpec
from estimator.calibration.twin.least_known import (
    SHARES,
    PressErrors,
    press_order,
    prior_variance,
)
from estimator.calibration.twin.pressed_places import drift_rate
from fem.presses.results import MagnetMotions, PressForces
from instobj.bench.rig.plan import PressSettings, face_places, middle_place, places_among


def errors_of(spec: ObjectSpec, settings: PressSettings) -> PressErrors:
    """Noise of the frames at rest that a press has, drift from rest to rest (a random walk that is known at
    both ends), and frames under load in equal parts."""
    rate_hz = spec.sensors.frame_rate_hz
    white = float(np.mean(np.square(spec.sensors.noise_counts)))
    stroke_s = settings.loaded_s / settings.strokes
    zero = white / max(settings.clear_s * rate_hz, 1.0)
    zero += drift_rate(spec) * stroke_s / (12 * settings.strokes)
    return PressErrors(max(round(settings.loaded_s * rate_hz / len(SHARES)), 1), zero)


def adaptive_order(
    spec: ObjectSpec,
    forces: PressForces,
    motions: MagnetMotions,
    face: int,
    settings: PressSettings,
    presses: int,
    reference_every: int,
) -> Int[np.ndarray, "press"]:
    """Return places of a face for a number of presses, returns to the middle included.

    Each next one lies where a press says most after all before.
    """
    doubt = prior_variance(spec, forces, motions, face, settings.full_n, errors_of(spec, settings))
    returns = [middle_place(face_places(spec, face))] if reference_every else []
    return press_order(doubt, places_among(presses, reference_every), returns)[0]

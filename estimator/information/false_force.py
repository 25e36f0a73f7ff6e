"""False forces: the press that a jaw's field, and its pull on the magnets, are taken for.

A reader that knows nothing of the jaw reads the press whose signals come nearest to what the jaw adds
to the channels, each weighed by its noise. The jaw is a half-space: what finite ones do less stands in
`estimator.field.environment`. Magnets that steel pulls move in the silicone by the response operator;
as they come nearer the pull grows, which is left out: 2 % on the paper's cube (tests), more in softer
silicone.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from design.layout.body import face_frames
from design.spec.object import ObjectSpec
from estimator.field.forces import resting_loads
from estimator.information.cross_face import nearest_press
from estimator.information.sensitivity import channel_noise, read_channels
from estimator.signals.field_setup import scene, zero_motion
from estimator.signals.presses import Signals, rest_counts
from estimator.signals.surroundings import longest, moved_counts, pull, with_jaw
from fem.linear.response import ResponseOperator
from fem.presses.body_loads import motions_under_loads

JAWS = (("steel", 0.0), ("steel", 10.0), ("aluminium", 0.0), ("plastic", 0.0))
"""Material of a jaw, and its gap to the face (mm)."""


@dataclass(frozen=True)
class JawEffect:
    """Effect of one kind of jaw, worst over the faces that it comes to.

    Attributes
    ----------
    counts : largest change of a channel of that face, with the pull
    pull_n : largest force on a magnet of any face
    moved_mm : largest displacement of a magnet by it
    false_force_n : force of the press that it is taken for
    """

    material: str
    gap_mm: float
    counts: float
    pull_n: float
    moved_mm: float
    false_force_n: float


@dataclass(frozen=True)
class RestingShift:
    """Effect of the magnets' forces on each other: largest one (N), displacement (mm), counts."""

    force_n: float
    moved_mm: float
    counts: float


def jaw_effects(
    spec: ObjectSpec, response: ResponseOperator, signals: Signals
) -> tuple[JawEffect, ...]:
    """Return the effects of `JAWS` at rest."""
    return tuple(_worst(spec, response, signals, material, gap) for material, gap in JAWS)


def resting_shift(spec: ObjectSpec, response: ResponseOperator) -> RestingShift | None:
    """Return how the magnets' forces on each other shift the zero; None where they lie in the core."""
    if spec.arrangement == "sensors-in-shell":
        return None
    loads = resting_loads(spec)
    motion = motions_under_loads(response, loads)
    change = moved_counts(spec, motion) - rest_counts(spec)
    return RestingShift(longest(loads), longest(motion), float(abs(change).max()))


def false_force_n(
    spec: ObjectSpec, signals: Signals, change: Float[np.ndarray, "sensor 3"]
) -> float:
    """Return the force of the press whose signals come nearest to a change of channels, in noise."""
    noise, best = channel_noise(spec.sensors, change.size), (np.inf, 0.0)
    for index, face in enumerate(signals.faces.tolist()):
        read = read_channels(spec, signals, face)
        pressed = signals.pressed[index]
        force = signals.force_n[index, pressed]
        delta = signals.delta_counts[index, pressed].reshape(*force.shape, -1)
        delta, wanted = (given[..., read] / noise[read] for given in (delta, change.ravel()))
        # from rest on
        curve, forces = (np.insert(given, 0, 0.0, axis=1) for given in (delta, force))
        (nearest,), (squared,) = nearest_press(wanted[None], curve, forces)
        best = min(best, (float(squared), float(nearest)))
    return best[1]


def _worst(
    spec: ObjectSpec, response: ResponseOperator, signals: Signals, material: str, gap_mm: float
) -> JawEffect:
    place, rest, rows = scene(spec), rest_counts(spec), []
    for index, frame in enumerate(face_frames(spec)):
        jaw = with_jaw(spec, frame, gap_mm, material)
        loads, motion = pull(jaw), zero_motion(place)[0]
        if not place.sensors_move:
            motion = motions_under_loads(response, loads, (index, gap_mm))
        change = moved_counts(jaw, motion) - rest
        face_change = change[place.sensors.face == frame.number]
        force = false_force_n(spec, signals, change)
        rows.append((float(abs(face_change).max()), longest(loads), longest(motion), force))
    return JawEffect(material, gap_mm, *np.max(rows, axis=0).tolist())

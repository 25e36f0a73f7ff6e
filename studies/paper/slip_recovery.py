"""Recovery from a slip of the core: found at rest, calibration frames carried over to it.

A new zero takes the changed rest away, but sensors that sit elsewhere among the magnets also see
presses otherwise: 1 mm nearer or farther is 20 % of the force. The change at rest tells where they
sit: three numbers per sensor against six unknowns. What it cannot tell apart from the slip is how far
magnets and sensors were off the design before it.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Float

from design.layout.places.positions import slipped
from design.spec.mechanics import SlipSpec
from design.spec.object import ObjectSpec
from estimator.calibration.most_probable import Unknown, Values, most_probable
from estimator.field.models import magnets_model
from estimator.frames.dataset import NO_FACE, FrameSet
from estimator.signals.field_setup import min_distance_mm
from estimator.signals.interpolation import counts_at_force, press_traces
from estimator.signals.presses import Signals
from estimator.tolerances.assembly import Assembly, counts_of, designed

_MODEL_ERROR = 0.1
"""Error of the predicted change over its rms: magnets and sensors are off the design."""
_CHUNK_FRAMES = 4000
_LARGEST_SHIFT_MM = 3.0
"""Largest shift of each coordinate in a fit; sensors come nearer to magnets by about this at most."""
_POSE = {
    "shift_mm": Unknown(1.0, (3,), bound=_LARGEST_SHIFT_MM),
    "rotation_deg": Unknown(3.0, (3,), bound=10.0),
}
"""Pose of the core in the shell: its shift, and its rotation vector."""


@dataclass(frozen=True)
class FoundSlip:
    """Slip of the core, and the share of the resting signals' change (rms) that it leaves."""

    shift_mm: tuple[float, float, float]
    rotation_deg: tuple[float, float, float]
    left: float

    def applied(self, assembly: Assembly) -> Assembly:
        """The object with its core slipped so."""
        slip = SlipSpec(shift_mm=self.shift_mm, rotation_deg=self.rotation_deg)
        return with_core_moved(assembly, slip)


def with_core_moved(assembly: Assembly, slip: SlipSpec) -> Assembly:
    """The object with what sits in its core moved."""
    place = assembly.scene
    if place.sensors_move:
        return replace(assembly, scene=replace(place, magnets=slipped(place.magnets, slip)))
    return replace(assembly, scene=replace(place, sensors=slipped(place.sensors, slip)))


def slip_of(values: Values) -> SlipSpec:
    """The slip that unknowns of `_POSE` say."""
    (x, y, z), (a, b, c) = (values[name].tolist() for name in _POSE)
    return SlipSpec(shift_mm=(x, y, z), rotation_deg=(a, b, c))


def slip_from_rest(
    spec: ObjectSpec,
    change_counts: Float[np.ndarray, "sensor 3"],
    noise_counts: float,
) -> FoundSlip:
    """Slip from resting signals after it less those before (counts), NaN where one is unknown.

    `noise_counts` is how uncertain each change is, drift since the first zero included. On twins of
    the paper's cube a slip of 1 mm is found within 0.1 mm and 0.5°.
    """
    design, known = designed(spec), np.isfinite(change_counts)
    rest = np.zeros((1, design.scene.bodies, 6))
    nearest = min_distance_mm(design.scene, rest) - _LARGEST_SHIFT_MM
    model = magnets_model(spec.magnets, nearest)
    before = counts_of(spec, design.scene, rest, model)[0]
    rms = float(np.sqrt(np.mean(change_counts[known] ** 2)))
    sigma = np.hypot(noise_counts, _MODEL_ERROR * rms)

    def missing(values: Values) -> Float[np.ndarray, "known"]:
        moved = with_core_moved(design, slip_of(values)).scene
        found = counts_of(spec, moved, rest, model)[0] - before
        return (change_counts - found)[known]

    values = most_probable(lambda v: missing(v) / sigma, _POSE, diff_step=1e-4).values
    left = float(np.sqrt(np.mean(missing(values) ** 2))) / rms
    slip = slip_of(values)
    return FoundSlip(slip.shift_mm, slip.rotation_deg, left)


def carried_over(frames: FrameSet, before: Signals, after: Signals) -> FrameSet:
    """Calibration frames as they would be after a slip, zeroed anew.

    To each frame is added what the slip changes, by simulation (`before` and `after` are expected
    signals of the design, core in place and slipped), in the signals of each of its labelled
    contacts. Forces beyond the deepest simulated press count as that.
    """
    counts = frames.signal_counts.copy()
    for slot in range(frames.contact_face.shape[1]):
        force_n = frames.force_n[:, slot, 2]
        (rows,) = np.nonzero((frames.contact_face[:, slot] != NO_FACE) & (force_n > 0))
        for part in np.array_split(rows, max(1, int(np.ceil(len(rows) / _CHUNK_FRAMES)))):
            where = (frames.contact_face[part, slot], *frames.contact_xy_mm[part, slot].T)
            seen = [
                counts_at_force(press_traces(signals, *where), force_n[part, None], "clamp").counts[
                    :, 0
                ]
                for signals in (before, after)
            ]
            counts[part] += (seen[1] - seen[0]).reshape(len(part), *counts.shape[1:])
    return replace(frames, signal_counts=counts)

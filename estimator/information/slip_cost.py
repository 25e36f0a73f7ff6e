"""Cost of a slip of the core: changed baseline and patterns, and false readings.

The estimator is one that was calibrated before the slip: the maximum of the likelihood of
(x, y, F), linearised about the true contact, from the pressed face's own channels with a fresh
zero's disturbances,
    (δx, δy, δF) = I⁻¹ Jᵀ Σ⁻¹ r,  I = Jᵀ Σ⁻¹ J,
J = ∂S/∂(x, y, F) and the residual r = S(slipped) − S(calibrated). Without a new zero r holds the
changed baseline, and errors beyond a few millimetres say no more than that the reading is lost;
after re-zeroing only the changed pattern is left.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float, Int

from design.layout.places.contact_grid import contact_grid
from design.layout.places.contact_places import contact_places, face_rows
from design.spec.object import ObjectSpec
from estimator.information.fisher import disturbance_counts
from estimator.information.scores import fill_places
from estimator.information.sensitivity import channel_noise, own_channels
from estimator.signals.interpolation import counts_at_force, press_traces
from estimator.signals.live import live_jacobian
from estimator.signals.presses import Signals

_RANK_TOLERANCE = 1e-7
"""Share of the largest singular value below which a direction counts as not seen."""


@dataclass(frozen=True)
class SlipCost:
    """Figures of one slip against the object as calibrated.

    Attributes
    ----------
    force_n : (face, place) force of the contacts, N
    baseline_counts : (sensor, axis) change of the resting counts
    baseline_sigma : (sensor,) the same in units of the sensor's white noise, root of the sum of
        squares over its axes
    cosine, size_ratio : (face, place) between the slipped and the calibrated change of signal, each
        channel in units of its white noise, and the ratio of their lengths
    false_place_mm, false_force_n : (face, place) before re-zeroing
    rezeroed_place_mm, rezeroed_force_n : (face, place) after it

    NaN at places that a face has not.
    """

    faces: Int[np.ndarray, "face"]
    force_n: Float[np.ndarray, "face place"]
    baseline_counts: Float[np.ndarray, "sensor 3"]
    baseline_sigma: Float[np.ndarray, "sensor"]
    cosine: Float[np.ndarray, "face place"]
    size_ratio: Float[np.ndarray, "face place"]
    false_place_mm: Float[np.ndarray, "face place"]
    false_force_n: Float[np.ndarray, "face place"]
    rezeroed_place_mm: Float[np.ndarray, "face place"]
    rezeroed_force_n: Float[np.ndarray, "face place"]

    @property
    def places(self) -> Bool[np.ndarray, "face place"]:
        """Return which places of the grid each face has."""
        return ~np.isnan(self.force_n)


def slip_cost(spec: ObjectSpec, calibrated: Signals, slipped: Signals) -> SlipCost:
    """Compare at every contact location at `score.force_n`, or what both presses reach.

    `calibrated` and `slipped` are of one object, press lattice and set of depths.
    """
    baseline = slipped.baseline_counts - calibrated.baseline_counts
    noise = np.asarray(spec.sensors.noise_counts, float)
    rows = [_face_cost(spec, calibrated, slipped, int(face)) for face in calibrated.faces]
    places = contact_places(spec)[face_rows(spec, calibrated.faces)]
    columns = {name: fill_places(places, [row[name] for row in rows]) for name in rows[0]}
    sigma = np.linalg.norm(baseline / noise, axis=1)
    return SlipCost(calibrated.faces, columns.pop("force_n"), baseline, sigma, **columns)


def _face_cost(
    spec: ObjectSpec, calibrated: Signals, slipped: Signals, face: int
) -> dict[str, np.ndarray]:
    xy = contact_grid(spec).xy_mm[contact_places(spec)[spec.body.sensed.index(face)]]
    face_channels = own_channels(calibrated, spec.sensors, face)
    where = (np.full(len(xy), face), xy[:, 0], xy[:, 1])
    calibrated_signals, after = (
        press_traces(signals, *where).select_channels(face_channels)
        for signals in (calibrated, slipped)
    )
    force = np.minimum(calibrated_signals.force_n[:, -1], after.force_n[:, -1])
    force = np.minimum(force, spec.score.force_n)
    old, new = (
        counts_at_force(trace, force[:, None]).counts[:, 0] for trace in (calibrated_signals, after)
    )
    jacobian = live_jacobian(spec, calibrated, *where, force)[:, face_channels]
    sigma = disturbance_counts(spec.sensors, "fresh", len(face_channels))
    offset = (slipped.baseline_counts - calibrated.baseline_counts).ravel()[face_channels]
    place, wrong_force = false_reading(jacobian, new - old + offset, sigma)
    rezeroed_place, rezeroed_force = false_reading(jacobian, new - old, sigma)
    white = channel_noise(spec.sensors, len(face_channels))
    old_size, new_size = (np.linalg.norm(counts / white, axis=1) for counts in (old, new))
    return {
        "force_n": force,
        "cosine": np.sum(old * new / white**2, axis=1) / (old_size * new_size),
        "size_ratio": new_size / old_size,
        "false_place_mm": place,
        "false_force_n": wrong_force,
        "rezeroed_place_mm": rezeroed_place,
        "rezeroed_force_n": rezeroed_force,
    }


def false_reading(
    jacobian: Float[np.ndarray, "press channel 3"],
    residual_counts: Float[np.ndarray, "press channel"],
    sigma_counts: Float[np.ndarray, "channel"],
) -> tuple[Float[np.ndarray, "press"], Float[np.ndarray, "press"]]:
    """Distance (mm) and size of the force (N) by which residuals mislead the linearised estimator.

    Directions in (x, y, F) that the signals cannot tell are left at the true contact.
    """
    whitened = jacobian / sigma_counts[:, None]
    size = np.linalg.norm(whitened, axis=1)
    scale = np.where(size > 0, size, 1.0)[:, None, :]
    inverse = np.linalg.pinv(whitened / scale, rcond=_RANK_TOLERANCE)
    # Least-squares estimate J⁺ r: p press, c channel, k of (x, y, F)
    error = np.einsum("pkc,pc->pk", inverse, residual_counts / sigma_counts) / scale[:, 0]
    return np.hypot(error[:, 0], error[:, 1]), abs(error[:, 2])

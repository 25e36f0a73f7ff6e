"""Offsets and gains of every chip from Earth's field alone, the object laid down in six ways.

A uniform field u in the object's frame gives chip c the counts y = diag(e^g) T_c A_c u + o + s t,
with T_c the way round found before, A_c the designed axes, gains g, offsets o and slopes s of a
drift over the time t; the first way is repeated at the end to see s. The fields are u_k = R_k δ_k b:
Earth's field b in the room, the way asked for R_k, and how far the user was off δ_k.

What the readings tell, and what they do not: only the product of |b| and all gains together shows,
so gains are relative to their common mean (prior: within tolerance of 1), and |b| is as uncertain as
that mean. A common turn of all chips cannot be told from a turn of the object in all poses; offsets
can be told from fields because u and its opposite both occur.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float, Int
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation

from design.layout.places.positions import sensor_layout
from design.spec.object import ObjectSpec
from instobj.bench.bringup.asking.asked import POSES
from instobj.bench.bringup.diagnosis.findings import HALF_95, ChipFound

EARTH_UT = (25.0, 65.0)
"""At the surface (IGRF): from South America to the magnetic poles."""
_LAID_RAD = np.deg2rad(8.0)
"""Standard deviation of how an object is laid against what was asked for."""
_OPEN_GAIN, _OPEN_TURN = 0.3, np.deg2rad(5.0)
"""Standard deviations of a chip's gain (its logarithm) and turn (rad): wide, so that data decide."""
_DRIFT_S = 900.0
"""Time in which offsets drift by `sensors.drift_counts`: 15 minutes."""
_SETTLED = 1e-6
"""Relative change of the unknowns at which the fit ends."""


@dataclass(frozen=True)
class EarthFound:
    """Estimates with half of their 95 % intervals; gains are relative to their common mean.

    Attributes
    ----------
    field_ut, field_interval_ut : |b|
    offset, offset_interval : counts of every channel without Earth's field
    gain, gain_interval : of every channel; NaN where it is dead
    misfit : mean square of the whitened readings about the fit; 0.3 to 0.6 where all is well
    """

    field_ut: float
    field_interval_ut: float
    offset: Float[np.ndarray, "chip 3"]
    offset_interval: Float[np.ndarray, "chip 3"]
    gain: Float[np.ndarray, "chip 3"]
    gain_interval: Float[np.ndarray, "chip 3"]
    misfit: float


def in_object(pose: int) -> Float[np.ndarray, "3 3"]:
    """Room (ahead, left, up) to object, for the way of that number asked for."""
    up, ahead = (_axis(name) for name in POSES[pose])
    return np.column_stack([ahead, np.cross(up, ahead), up])


def _axis(name: str) -> Float[np.ndarray, "3"]:
    return (1.0 if name[0] == "+" else -1.0) * np.eye(3)["xyz".index(name[1])]


def from_earth(
    spec: ObjectSpec,
    chips: Sequence[ChipFound],
    means: Float[np.ndarray, "pose chip 3"],
    times_s: Float[np.ndarray, "pose"],
    frames: int,
) -> EarthFound:
    """Offsets and gains; `means` are the readings in the six ways and in the first once more."""
    axes = (
        np.stack([chip.turn for chip in chips]) @ sensor_layout(spec).axes[[c.site for c in chips]]
    )
    poses, count = np.stack([in_object(k % len(POSES)) for k in range(len(means))]), len(chips)
    noise = np.asarray(spec.sensors.noise_counts) / np.sqrt(frames)
    known = np.isfinite(means)
    first = np.where(known, means, 0).sum(axis=0) / np.maximum(known.sum(axis=0), 1)
    scale = 1e-3 * spec.sensors.counts_per_mt
    tolerance = float(np.hypot(spec.tolerances.sensor_gain_relative, spec.sensors.gain_tolerance))
    sizes = np.cumsum([3, 3 * len(means), *[3 * count] * 4])[:-1]
    times = (times_s - times_s.mean())[:, None, None]
    slope_sd = max(spec.sensors.drift_counts, 1.0) / _DRIFT_S

    def residuals(unknown: Float[np.ndarray, "unknown"]) -> Float[np.ndarray, "residual"]:
        b, laid, gain, turn, offset, slope = np.split(unknown, sizes)
        laid = laid.reshape(-1, 3)
        gain, turn, offset, slope = (part.reshape(-1, 3) for part in (gain, turn, offset, slope))
        # The room's field b in the object's frame, in each pose k as it was laid; then c chip, a channel
        field = np.einsum("kab,kb->ka", poses, Rotation.from_rotvec(laid).apply(b))
        seen = np.einsum("cab,kb->kca", axes, field)
        seen = seen + np.cross(turn, seen)
        off = (means - scale * np.exp(gain) * seen - offset - slope * times) / noise
        mean_gain = gain.mean() * np.sqrt(gain.size) / max(tolerance, 1e-3)
        priors = [laid / _LAID_RAD, gain / _OPEN_GAIN, turn / _OPEN_TURN, slope / slope_sd]
        priors += [(offset - first) / 300.0, b / 60.0, mean_gain]
        return np.concatenate([off[known], *(np.ravel(prior) for prior in priors)])

    field = first_field(means - first, axes, poses, scale)
    start = np.concatenate([field, np.zeros(sizes[-1] - 3 + 3 * count)])
    start[sizes[3] : sizes[4]] = first.ravel()
    found = least_squares(residuals, start, xtol=_SETTLED)
    covariance = np.linalg.inv(found.jac.T @ found.jac)
    misfit = float(np.mean(found.fun[: known.sum()] ** 2))
    return results_of_fit(found.x, covariance, sizes, known, misfit)


def first_field(
    change: Float[np.ndarray, "pose chip 3"],
    axes: Float[np.ndarray, "chip 3 3"],
    poses: Float[np.ndarray, "pose 3 3"],
    scale: float,
) -> Float[np.ndarray, "3"]:
    """The room's field by least squares, gains 1 and ways exactly as asked for."""
    # Linear in the field: k pose, c chip, a channel, b object coordinate, d coordinate of the room.
    # Poses less their mean, as the changes are: offsets then drop out.
    slope = np.einsum("cab,kbd->kcad", axes, poses - poses.mean(axis=0))
    known = np.isfinite(change)
    return np.linalg.lstsq(scale * slope[known], change[known], rcond=None)[0]


def results_of_fit(
    found: Float[np.ndarray, "unknown"],
    covariance: Float[np.ndarray, "unknown unknown"],
    sizes: Int[np.ndarray, "split"],
    known: Bool[np.ndarray, "pose chip 3"],
    misfit: float,
) -> EarthFound:
    b, _, gain, _, offset, _ = np.split(found, sizes)
    _, _, gain_sd, _, offset_sd, _ = np.split(np.sqrt(np.diag(covariance)), sizes)
    size = float(np.linalg.norm(b))
    direction = b / size
    dead = np.where(known.any(axis=0), 1.0, np.nan)
    gain, gain_sd, offset, offset_sd = (
        dead * part.reshape(-1, 3) for part in (gain, gain_sd, offset, offset_sd)
    )
    return EarthFound(
        size,
        float(HALF_95 * np.sqrt(direction @ covariance[:3, :3] @ direction)),
        offset,
        HALF_95 * offset_sd,
        np.exp(gain),
        HALF_95 * gain_sd * np.exp(gain),
        misfit,
    )

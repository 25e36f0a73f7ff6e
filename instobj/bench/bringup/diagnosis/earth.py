"""Offsets and gains of every chip from Earth's field alone, the object laid down in six ways.

A uniform field u in the object's frame gives chip c the counts y = diag(e^g) T_c A_c u + o + s t,
with T_c the way round found before, A_c the designed axes, gains g, offsets o and slopes s of a
drift over the time t; the first way is repeated at the end to see s. The fields are u_k = R_k δ_k b:
Earth's field b in the room, the way asked for R_k, and how far the user was off δ_k.

What the readings tell, and what they do not: only the product of |b| and all gains together shows,
so gains are relative to their common mean (prior: within tolerance of 1), and |b| is as uncertain as
that mean. A common turn of all chips looks like a turn of the object in all poses; offsets
are separated from fields because u and its opposite both occur.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float
from scipy.spatial.transform import Rotation

from design.layout.places.positions import sensor_layout
from design.spec.object import ObjectSpec
from estimator.calibration.most_probable import MostProbable, Unknown, Values, most_probable
from instobj.bench.bringup.asking.asked import POSES
from instobj.bench.bringup.diagnosis.findings import HALF_95, ChipFound

EARTH_UT = (25.0, 65.0)
"""At the surface (IGRF): from South America to the magnetic poles."""
_LAID_RAD = np.deg2rad(8.0)
"""Standard deviation of how an object is laid against what was asked for."""
_OPEN_GAIN, _OPEN_TURN, _OPEN_OFFSET_COUNTS, _OPEN_FIELD_UT = 0.3, np.deg2rad(5.0), 300.0, 60.0
"""Standard deviations of a chip's gain (its logarithm), turn (rad) and offset, and of the room's field:
wide, so that data decide."""
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


def turn_to_object(pose: int) -> Float[np.ndarray, "3 3"]:
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
    poses, count = np.stack([turn_to_object(k % len(POSES)) for k in range(len(means))]), len(chips)
    noise = np.asarray(spec.sensors.noise_counts) / np.sqrt(frames)
    has_reading = np.isfinite(means)
    first = np.where(has_reading, means, 0).sum(axis=0) / np.maximum(has_reading.sum(axis=0), 1)
    scale = 1e-3 * spec.sensors.counts_per_mt
    tolerance = float(np.hypot(spec.tolerances.sensor_gain_relative, spec.sensors.chip_spread[0]))
    times = (times_s - times_s.mean())[:, None, None]
    unknowns = {
        "field_ut": Unknown(_OPEN_FIELD_UT, (3,)),
        "laid_rad": Unknown(_LAID_RAD, (len(means), 3)),
        "ln_gain": Unknown(_OPEN_GAIN, (count, 3)),
        "turn_rad": Unknown(_OPEN_TURN, (count, 3)),
        "offset": Unknown(_OPEN_OFFSET_COUNTS, (count, 3), first),
        "slope": Unknown(max(spec.sensors.drift_counts, 1.0) / _DRIFT_S, (count, 3)),
    }

    def off_readings(values: Values) -> Float[np.ndarray, "reading"]:
        # The room's field in the object's frame, in each pose k as it was laid; then c chip, a channel
        laid = Rotation.from_rotvec(values["laid_rad"]).apply(values["field_ut"])
        field = np.einsum("kab,kb->ka", poses, laid)
        expected = np.einsum("cab,kb->kca", axes, field)
        expected = (
            scale * np.exp(values["ln_gain"]) * (expected + np.cross(values["turn_rad"], expected))
        )
        return ((means - expected - values["offset"] - values["slope"] * times) / noise)[
            has_reading
        ]

    def misfit(values: Values) -> Float[np.ndarray, "residual"]:
        # The mean of all gains is within tolerance, whatever single ones are.
        gain = values["ln_gain"]
        mean_gain = gain.mean() * np.sqrt(gain.size) / max(tolerance, 1e-3)
        return np.append(off_readings(values), mean_gain)

    start = {"field_ut": first_field(means - first, axes, poses, scale)}
    fit = most_probable(misfit, unknowns, start, xtol=_SETTLED)
    alive = np.where(has_reading.any(axis=0), 1.0, np.nan)
    return stated_intervals(fit, alive, float(np.mean(off_readings(fit.values) ** 2)))


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
    has_reading = np.isfinite(change)
    return np.linalg.lstsq(scale * slope[has_reading], change[has_reading], rcond=None)[0]


def stated_intervals(
    fit: MostProbable, alive: Float[np.ndarray, "chip 3"], misfit: float
) -> EarthFound:
    """Values with half of their 95 % intervals; `alive` is 1, NaN for a dead channel."""
    field, gain = fit.values["field_ut"], np.exp(fit.values["ln_gain"])
    size = float(np.linalg.norm(field))
    direction = field / size
    return EarthFound(
        size,
        float(HALF_95 * np.sqrt(direction @ fit.covariance("field_ut") @ direction)),
        alive * fit.values["offset"],
        alive * HALF_95 * fit.sd("offset"),
        alive * gain,
        alive * HALF_95 * fit.sd("ln_gain") * gain,
        misfit,
    )

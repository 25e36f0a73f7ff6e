"""Identity of the channels: chips, their order and the way round they sit, from a hand-held magnet.

Poses of the magnet and the chips' places and axes are found together. Given poses, every chip is
scored at every place in each of the 48 signed permutations of its axes and the best one-to-one
assignment is taken (Hungarian method); given chips, each pose is fitted to all of them, robustly, so
that the few that are wrong do not pull it. Both repeat until nothing changes, from two starts: chips
as specified, and each chip where it responds most. Poses are first fitted to the size of the fields
alone, which no rotation of a chip changes.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import permutations, product
from operator import attrgetter

import numpy as np
from jaxtyping import Bool, Float, Int
from scipy.optimize import linear_sum_assignment

from design.spec.object import ObjectSpec
from instobj.bench.bringup.asking.held_magnet import HeldMagnet, held_magnet, stated_pose
from instobj.bench.bringup.diagnosis.levenberg_marquardt import many_most_probable

OTHER_PLACE, OTHER_TURN, MIRRORED, TURNED_OVER = 7.0, 7.0, 9.0, 5.0
"""Costs of hypotheses, −ln of their prior odds: another place, turned, mirrored axes, and a magnet
held the wrong way round. Estimates."""
_ROBUST = 4.0
"""Misfit, in standard deviations, beyond which it grows as a logarithm: outliers do not rule."""
_ROUNDS = 6
"""Rounds of assigning chips and fitting poses, at most."""
_TREMOR_COUNTS = 0.01
"""Relative error of a prediction that a hand's tremor adds."""


def signed_permutations() -> Float[np.ndarray, "48 3 3"]:
    """Return all 48, the identity first, then rotations, then mirrored ones."""
    matrices = [
        np.eye(3)[list(order)] * np.array(signs)[:, None]
        for order in permutations(range(3))
        for signs in product((1.0, -1.0), repeat=3)
    ]
    return np.stack(sorted(matrices, key=lambda m: (-np.linalg.det(m), -np.trace(m))))


@dataclass(frozen=True)
class HeldReadings:
    """Changes against the still reading while the magnet is held over one chip after the other.

    Attributes
    ----------
    counts : (hold, chip, axis), NaN where a channel is silent, dead or at full scale
    noise_counts : standard deviation of each change
    relative : error of the model over a chip's field: gain, turn, cross-axis, tremor
    seat_mm : standard deviation of a chip's place
    """

    counts: Float[np.ndarray, "hold chip 3"]
    noise_counts: Float[np.ndarray, "hold chip 3"]
    relative: float
    seat_mm: float


@dataclass(frozen=True)
class Arrangement:
    """Places of the chips, turns of their axes, and poses of the magnet.

    Attributes
    ----------
    site : place of each chip, by its number among all sensors
    turn : chip signals = turn · field in the axes designed for the place
    model, pose : the magnet in every hold
    cost : −ln of the posterior, up to a constant
    """

    site: Int[np.ndarray, "chip"]
    turn: Float[np.ndarray, "chip 3 3"]
    model: HeldMagnet
    pose: Float[np.ndarray, "hold 8"]
    cost: float


def held_readings(
    spec: ObjectSpec,
    counts: Float[np.ndarray, "hold chip 3"],
    share: Float[np.ndarray, "hold"] | float,
    drift_counts: float,
) -> HeldReadings:
    """Readings with the errors that tolerances, noise and drift leave.

    `share` is the variance of a change over that of one frame's noise.
    """
    tolerances, sensors = spec.tolerances, spec.sensors
    holds, chips, _ = counts.shape
    share = np.sqrt(np.broadcast_to(share, holds))
    noise = share[:, None, None] * np.asarray(sensors.noise_counts)
    relative = np.sqrt(
        tolerances.sensor_gain_relative**2
        + sensors.chip_spread[0] ** 2
        + 2 * sensors.chip_spread[1] ** 2
        + 2 * np.deg2rad(tolerances.sensor_rotation_deg) ** 2
        + tolerances.remanence_relative**2
        + _TREMOR_COUNTS**2
    )
    channel = np.hypot(noise, drift_counts) * np.ones((1, chips, 1))
    return HeldReadings(counts, channel, float(relative), tolerances.sensor_seat_mm)


def find_chips(spec: ObjectSpec, readings: HeldReadings, holds: Sequence[int]) -> Arrangement:
    """The most probable arrangement of all chips; `holds` are the numbers of its hold places."""
    model, named = held_magnet(spec, list(holds)), np.arange(readings.counts.shape[1])
    first = _settled(readings, model, named)
    if np.array_equal(first.site, named) and np.all(first.turn == np.eye(3)):
        return first
    second = _settled(readings, model, sites_by_response(readings, holds))
    return min((first, second), key=lambda arrangement: arrangement.cost)


def sites_by_response(readings: HeldReadings, holds: Sequence[int]) -> Int[np.ndarray, "chip"]:
    """Each chip at the place over which the magnet moves it most; unheld places keep theirs."""
    size = np.sqrt(np.nansum(readings.counts**2, axis=2)) + 1.0
    gain = np.zeros((size.shape[1], size.shape[1])) - 1e-3
    gain[np.arange(len(gain)), np.arange(len(gain))] = 0.0
    gain[:, list(holds)] += np.log(size.T)
    return linear_sum_assignment(gain, maximize=True)[1]


def _settled(
    readings: HeldReadings, model: HeldMagnet, site: Int[np.ndarray, "chip"]
) -> Arrangement:
    arrangement = assigned_sites(readings, model, _poses_by_size(readings, model, site))
    for _ in range(_ROUNDS):
        previous = replace(arrangement, model=with_polarities(readings, arrangement))
        pose = _poses_by_vectors(readings, previous)
        arrangement = assigned_sites(readings, previous.model, pose)
        same_site = np.array_equal(previous.site, arrangement.site)
        if same_site and np.array_equal(previous.turn, arrangement.turn):
            break
    return min((arrangement, _mirrored(readings, arrangement)), key=attrgetter("cost"))


def _mirrored(readings: HeldReadings, arrangement: Arrangement) -> Arrangement:
    """All holds the other way round: the same likelihood with all axes of all chips reversed."""
    pose = arrangement.pose.copy()
    pose[:, 5:] *= -1
    model = replace(arrangement.model, polarity=-arrangement.model.polarity)
    return assigned_sites(readings, model, pose)


def _poses_by_size(
    readings: HeldReadings, model: HeldMagnet, site: Int[np.ndarray, "chip"]
) -> Float[np.ndarray, "hold 8"]:
    """Poses from |B| alone, which neither turns of chips nor the magnet's polarity change."""
    size = np.linalg.norm(readings.counts, axis=2)  # NaN where an axis is missing
    floor = np.hypot(np.linalg.norm(readings.noise_counts, axis=2), 40.0)

    def residuals(pose: Float[np.ndarray, "hold 8"]) -> Float[np.ndarray, "hold residual"]:
        predicted = np.linalg.norm(model.counts(pose), axis=2)[:, site]
        error = np.hypot(floor, 2 * readings.relative * predicted)
        return np.concatenate(
            [capped_misfit((size - predicted) / error), model.off_prior(pose)], axis=1
        )

    return many_most_probable(residuals, stated_pose(len(size)))[0]


def with_polarities(readings: HeldReadings, arrangement: Arrangement) -> HeldMagnet:
    """The way round under which each hold fits the chips better."""
    costs = []
    for sign in (1.0, -1.0):
        turned = replace(arrangement.model, polarity=np.full(len(arrangement.pose), sign))
        off = _misfit_of_fields(readings, arrangement, turned.counts(arrangement.pose))
        costs.append(0.5 * np.sum(off**2, axis=(1, 2)))
    over = costs[1] + TURNED_OVER < costs[0]
    return replace(arrangement.model, polarity=np.where(over, -1.0, 1.0))


def _poses_by_vectors(
    readings: HeldReadings, arrangement: Arrangement
) -> Float[np.ndarray, "hold 8"]:
    def residuals(pose: Float[np.ndarray, "hold 8"]) -> Float[np.ndarray, "hold residual"]:
        off = _misfit_of_fields(readings, arrangement, arrangement.model.counts(pose))
        prior = arrangement.model.off_prior(pose)
        return np.concatenate([off.reshape(len(off), -1), prior], axis=1)

    return many_most_probable(residuals, arrangement.pose)[0]


def _misfit_of_fields(
    readings: HeldReadings, arrangement: Arrangement, counts: Float[np.ndarray, "hold sensor 3"]
) -> Float[np.ndarray, "hold chip 3"]:
    """Capped misfit of readings to fields as designed sensors read them, in the arrangement's errors."""
    error = model_error(readings, arrangement.model, arrangement.pose)[:, arrangement.site, None]
    # h hold, c chip, b designed axis of its site, a its axis as it is turned
    predicted = np.einsum("cab,hcb->hca", arrangement.turn, counts[:, arrangement.site])
    return capped_misfit((readings.counts - predicted) / np.hypot(error, readings.noise_counts))


def model_error(
    readings: HeldReadings, model: HeldMagnet, pose: Float[np.ndarray, "hold 8"]
) -> Float[np.ndarray, "hold sensor"]:
    """Standard deviation (counts) of each field component that tolerances leave: B ∝ r⁻³ nearby."""
    size = np.linalg.norm(model.counts(pose), axis=2)
    seat = 3 * readings.seat_mm / model.distance_mm(pose)
    return size * np.hypot(readings.relative, seat)


def capped_misfit(off: Float[np.ndarray, "*any"]) -> Float[np.ndarray, "*any"]:
    """Whitened residuals whose half square grows as a logarithm beyond 4; 0 where nothing is known.

    Cauchy's function; missing readings do not count.
    """
    misfit = np.where(np.isnan(off), 0.0, off)
    return np.sign(misfit) * _ROBUST * np.sqrt(np.log1p((misfit / _ROBUST) ** 2))


def misfit_of(
    readings: HeldReadings,
    model: HeldMagnet,
    pose: Float[np.ndarray, "hold 8"],
    turns: Float[np.ndarray, "turn 3 3"],
) -> Float[np.ndarray, "hold chip site turn"]:
    """−ln likelihood of each chip at each place in each way round, hold by hold."""
    # Every chip may sit at any site s in any way round t: h hold, b designed axis, a turned axis
    predicted = np.einsum("tab,hsb->hsta", turns, model.counts(pose))
    error = model_error(readings, model, pose)
    parts = []
    for axis in range(3):
        counts, noise = readings.counts[:, :, axis], readings.noise_counts[:, :, axis]
        sigma = np.hypot(error[:, None, :, None], noise[:, :, None, None])
        off = (counts[:, :, None, None] - predicted[:, None, :, :, axis]) / sigma
        missing: Bool[np.ndarray, "hold chip 1 1"] = np.isnan(counts)[:, :, None, None]
        parts.append(np.where(missing, 0.0, 0.5 * capped_misfit(off) ** 2 + np.log(sigma)))
    return np.sum(parts, axis=0)


def assigned_sites(
    readings: HeldReadings, model: HeldMagnet, pose: Float[np.ndarray, "hold 8"]
) -> Arrangement:
    """The best one-to-one assignment of chips to places, and each one's way round."""
    turns = signed_permutations()
    misfit = np.zeros((*[readings.counts.shape[1]] * 2, len(turns)))
    for hold in range(len(pose)):
        misfit += misfit_of(*_one(readings, model, pose, hold), turns)[0]
    misfit += np.select(
        [np.arange(48) == 0, np.linalg.det(turns) > 0], [0.0, OTHER_TURN], OTHER_TURN + MIRRORED
    )
    cost = misfit.min(axis=2) + OTHER_PLACE * ~np.eye(len(misfit), dtype=bool)
    chip, site = linear_sum_assignment(cost)
    turn = turns[misfit[chip, site].argmin(axis=1)]
    prior = 0.5 * np.sum(model.off_prior(pose) ** 2) + TURNED_OVER * np.sum(model.polarity < 0)
    return Arrangement(site, turn, model, pose, float(cost[chip, site].sum() + prior))


def _one(
    readings: HeldReadings, model: HeldMagnet, pose: Float[np.ndarray, "hold 8"], hold: int
) -> tuple[HeldReadings, HeldMagnet, Float[np.ndarray, "1 8"]]:
    """A single hold, so that the tables of all hypotheses stay small."""
    rows = slice(hold, hold + 1)
    narrowed = replace(
        model,
        stated_mm=model.stated_mm[rows],
        face_axes=model.face_axes[rows],
        polarity=model.polarity[rows],
    )
    noise = readings.noise_counts[rows]
    return replace(readings, counts=readings.counts[rows], noise_counts=noise), narrowed, pose[rows]

"""Gains, turns and dead axes of every chip, from all holds of the magnet together.

Around a found arrangement everything is fitted at once: poses, and of each chip a matrix and its
place, so that signals are (1 + G) T B(p), T the way round found before. The magnet's strength and
all gains together cannot be separated: gains are relative to the median channel.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from jaxtyping import Bool, Float

from estimator.calibration.most_probable import MostProbable, Unknown, Values, most_probable
from instobj.bench.bringup.diagnosis.channels import Arrangement, HeldReadings, model_error
from instobj.bench.bringup.diagnosis.findings import HALF_95, ChipFound

_OPEN = 0.3
"""Prior of the entries of G: far beyond any tolerance."""
_DEAD_SHARE = 0.3
"""An axis that answers with less than this share of what its field would give says nothing."""
_TREMOR_SHARE = 0.004
"""Error of a mean field by the hand's tremor, over the field."""
_LEAST_SEAT_MM = 1e-3
"""Standard deviation of a chip's seat, at least: with none the fit could not take steps of it."""
_SETTLED = 1e-6
"""Relative change of the unknowns at which the fit ends."""


def chips_found(readings: HeldReadings, arrangement: Arrangement) -> list[ChipFound]:
    """Chips by name: turned by any angle, with dead axes, gains and their intervals."""
    turns, dead = linear_chips(readings, arrangement)
    alive = replace(readings, counts=np.where(dead, np.nan, readings.counts))
    fit = joint_fit(alive, replace(arrangement, turn=turns))
    matrix = np.eye(3) + fit.values["gain_error"]
    is_read = np.asarray(np.isfinite(alive.counts).any(axis=0))
    gain, interval = relative_gains(matrix, fit.covariance("gain_error"), is_read)
    turned = [
        orthogonal_part(rows, dead[chip], arrangement.turn[chip])
        for chip, rows in enumerate(matrix @ turns)
    ]
    return [
        ChipFound(
            int(site),
            turned[c],
            gain[c, :3],
            interval[c, :3],
            float(gain[c, 3]),
            float(interval[c, 3]),
            (bool(dead[c, 0]), bool(dead[c, 1]), bool(dead[c, 2])),
        )
        for c, site in enumerate(arrangement.site)
    ]


def linear_chips(
    readings: HeldReadings, arrangement: Arrangement
) -> tuple[Float[np.ndarray, "chip 3 3"], Bool[np.ndarray, "chip 3"]]:
    """Turn of every chip by weighted least squares, poses as they are; and dead axes.

    The turn is the nearest orthogonal matrix; a dead axis is completed from the other two. Chips
    with fewer than two living axes keep the permutation.
    """
    fields = arrangement.model.counts(arrangement.pose)[:, arrangement.site]
    error = model_error(readings, arrangement.model, arrangement.pose)[:, arrangement.site]
    turns, dead = arrangement.turn.copy(), np.zeros(arrangement.turn.shape[:2], bool)
    for chip, permutation in enumerate(arrangement.turn):
        rows = np.zeros((3, 3))
        for axis in range(3):
            has_reading = np.isfinite(readings.counts[:, chip, axis])
            weight = 1 / np.hypot(error[:, chip], readings.noise_counts[:, chip, axis])[has_reading]
            if has_reading.sum() >= 3:
                slope = weight[:, None] * fields[has_reading, chip]
                values = weight * readings.counts[has_reading, chip, axis]
                rows[axis] = np.linalg.lstsq(slope, values, rcond=None)[0]
        dead[chip] = np.linalg.norm(rows, axis=1) < _DEAD_SHARE
        turns[chip] = orthogonal_part(rows, dead[chip], permutation)
    return turns, dead


def orthogonal_part(
    rows: Float[np.ndarray, "3 3"],
    dead: Bool[np.ndarray, "3"],
    otherwise: Float[np.ndarray, "3 3"],
) -> Float[np.ndarray, "3 3"]:
    """Nearest orthogonal matrix to the living rows; a dead axis shows no handedness: right-handed."""
    if dead.sum() > 1:
        return otherwise
    unit = rows / np.maximum(np.linalg.norm(rows, axis=1, keepdims=True), 1e-9)
    if dead.any():
        (k,) = np.flatnonzero(dead)
        across = np.cross(unit[(k + 1) % 3], unit[(k + 2) % 3])
        unit[k] = across / np.linalg.norm(across)
    left, _, right = np.linalg.svd(unit)
    return left @ right


def joint_fit(readings: HeldReadings, arrangement: Arrangement) -> MostProbable:
    """Poses (`pose`, in the standard deviations of their priors), and of every chip G (`gain_error`) and its
    seat (`seat_mm`), fitted together from the arrangement on."""
    model, site = arrangement.model, arrangement.site
    field_size = np.linalg.norm(model.counts(arrangement.pose), axis=2)[:, site, None]
    error = np.hypot(_TREMOR_SHARE * field_size, readings.noise_counts)
    unknowns = {
        "pose": Unknown(1.0, arrangement.pose.shape),
        "gain_error": Unknown(_OPEN, (len(site), 3, 3)),
        "seat_mm": Unknown(max(readings.seat_mm, _LEAST_SEAT_MM), (len(site), 3)),
    }

    def misfit(values: Values) -> Float[np.ndarray, "hold chip 3"]:
        moved = np.zeros_like(values["seat_mm"])
        moved[site] = values["seat_mm"]
        fields = model.counts(values["pose"] * model.pose_sd, moved)[:, site]
        # h hold, c chip, b designed axis of its site, a channel
        matrices = (np.eye(3) + values["gain_error"]) @ arrangement.turn
        expected = np.einsum("cab,hcb->hca", matrices, fields)
        return np.nan_to_num((readings.counts - expected) / error)

    start = {"pose": model.off_prior(arrangement.pose)}
    return most_probable(misfit, unknowns, start, xtol=_SETTLED)


def relative_gains(
    matrix: Float[np.ndarray, "chip 3 3"],
    covariance: Float[np.ndarray, "entry entry"],
    is_read: Bool[np.ndarray, "chip 3"],
) -> tuple[Float[np.ndarray, "chip 4"], Float[np.ndarray, "chip 4"]]:
    """Gains over their median and half of their 95 % intervals: of every axis, then of the chip.

    The intervals are those of gains less the mean of all.
    """
    gain = np.linalg.norm(matrix, axis=2)
    diagonal = np.flatnonzero(np.tile(np.eye(3, dtype=bool).ravel(), len(matrix)))
    covariance = covariance[np.ix_(diagonal, diagonal)]
    alive = is_read.ravel() / max(is_read.sum(), 1)
    shares = is_read / np.maximum(is_read.sum(axis=1, keepdims=True), 1)
    of_chip = (np.eye(len(gain))[:, :, None] * shares).reshape(len(gain), -1)
    value, interval = [], []
    for rows, has_value in ((np.eye(gain.size), is_read.ravel()), (of_chip, is_read.any(axis=1))):
        less_mean = rows - alive
        # Error propagation: √(row C rowᵀ) of each row i; j and k channels
        spread = np.sqrt(np.einsum("ij,jk,ik->i", less_mean, covariance, less_mean))
        value.append(np.where(has_value, rows @ np.where(is_read, gain, 0).ravel(), np.nan))
        interval.append(np.where(has_value, HALF_95 * spread, np.nan))
    middle = np.median(gain[is_read])
    return tuple(  # pyright: ignore[reportReturnType]
        np.column_stack([axes.reshape(-1, 3), chip]) / middle for axes, chip in (value, interval)
    )

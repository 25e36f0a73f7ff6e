"""Gains, turns and dead axes of every chip, from all holds of the magnet together.

Around a found arrangement everything is fitted at once: poses, and of each chip a matrix and its
place, so that signals are (1 + G) T B(p), T the way round found before. The magnet's strength and
all gains together cannot be separated: gains are relative to the median channel.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from jaxtyping import Bool, Float
from scipy.optimize import least_squares

from instobj.bench.bringup.diagnosis.channels import Arrangement, HeldReadings, model_error
from instobj.bench.bringup.diagnosis.findings import HALF_95, ChipFound

_OPEN = 0.3
"""Prior of the entries of G: far beyond any tolerance."""
_DEAD_SHARE = 0.3
"""An axis that answers with less than this share of what its field would give says nothing."""
_TREMOR_SHARE = 0.004
"""Error of a mean field by the hand's tremor, over the field."""
_STEP, _SETTLED = 1e-4, 1e-6
"""Step of the difference quotients, and relative change of the unknowns at which the fit ends."""


def chips_found(readings: HeldReadings, arrangement: Arrangement) -> list[ChipFound]:
    """Chips by name: turned by any angle, with dead axes, gains and their intervals."""
    turns, dead = linear_chips(readings, arrangement)
    alive = replace(readings, counts=np.where(dead, np.nan, readings.counts))
    problem = JointFit.start_from(alive, replace(arrangement, turn=turns))
    slopes: Any = problem.slopes  # SciPy's own default makes checkers believe that it is a text
    fit = least_squares(problem.residuals, problem.start, slopes, xtol=_SETTLED)
    matrix, covariance = problem.matrices(fit.x), np.linalg.inv(fit.jac.T @ fit.jac)
    gain, interval = relative_gains(
        matrix, covariance[problem.gains, problem.gains], problem.is_read
    )
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


@dataclass(frozen=True)
class JointFit:
    """The fit of everything at once.

    Unknowns: poses (hold, 8), then of every chip G (3, 3) row by row, then its seat (3).

    Attributes
    ----------
    error : standard deviation of each reading
    is_read : channels that say something
    """

    readings: HeldReadings
    arrangement: Arrangement
    error: Float[np.ndarray, "hold chip 3"]
    is_read: Bool[np.ndarray, "chip 3"]

    @staticmethod
    def start_from(readings: HeldReadings, arrangement: Arrangement) -> JointFit:
        size = np.linalg.norm(arrangement.model.counts(arrangement.pose), axis=2)[
            :, arrangement.site, None
        ]
        error = np.hypot(_TREMOR_SHARE * size, readings.noise_counts)
        is_read = np.asarray(np.isfinite(readings.counts).any(axis=0))
        return JointFit(readings, arrangement, error, is_read)

    @property
    def chips(self) -> int:
        return len(self.arrangement.site)

    @property
    def poses(self) -> int:
        return self.arrangement.pose.size

    @property
    def start(self) -> Float[np.ndarray, "unknown"]:
        return np.concatenate([self.arrangement.pose.ravel(), np.zeros(12 * self.chips)])

    @property
    def gains(self) -> slice:
        """Return where G stands among the unknowns."""
        return slice(self.poses, self.poses + 9 * self.chips)

    def matrices(self, unknown: Float[np.ndarray, "unknown"]) -> Float[np.ndarray, "chip 3 3"]:
        """1 + G of every chip."""
        return np.eye(3) + unknown[self.gains].reshape(-1, 3, 3)

    def residuals(self, unknown: Float[np.ndarray, "unknown"]) -> Float[np.ndarray, "residual"]:
        """Whitened readings (0 where there is none), then priors."""
        pose, seat = self._split(unknown)
        # h hold, c chip, b field along a chip axis, a channel
        expected = np.einsum("cab,hcb->hca", self.matrices(unknown), self._turned(pose, seat))
        off = (self.readings.counts - expected) / self.error
        seats = seat / self._seat_mm
        priors = (self.arrangement.model.off_prior(pose), unknown[self.gains] / _OPEN, seats)
        return np.concatenate([np.nan_to_num(off).ravel(), *(prior.ravel() for prior in priors)])

    def slopes(
        self, unknown: Float[np.ndarray, "unknown"]
    ) -> Float[np.ndarray, "residual unknown"]:
        """Each pose moves its own hold alone and each chip's numbers its own channels."""
        pose, seat = self._split(unknown)
        field, matrix = self._turned(pose, seat), self.matrices(unknown)
        holds, chips = len(pose), self.chips
        h, c = np.arange(holds), np.arange(chips)
        of_pose = np.zeros((holds, chips, 3, holds, 8))
        of_gain = np.zeros((holds, chips, 3, chips, 3, 3))
        of_seat = np.zeros((holds, chips, 3, chips, 3))
        for k in range(8):
            change = (self._turned(pose + _STEP * np.eye(8)[k], seat) - field) / _STEP
            # Pose k of hold h changes the readings of this hold alone; a seat or a gain, those of its chip.
            of_pose[h, :, :, h, k] = np.einsum("cab,hcb->hca", matrix, change)
        for k in range(3):
            change = (self._turned(pose, seat + _STEP * np.eye(3)[k]) - field) / _STEP
            of_seat[:, c, :, c, k] = np.einsum("cab,hcb->cha", matrix, change)
            of_gain[:, c, k, c, k, :] = field
        weight = np.where(np.isnan(self.readings.counts), 0.0, -1 / self.error)[..., None]
        parts = [part.reshape(holds, chips, 3, -1) for part in (of_pose, of_gain, of_seat)]
        slope = (weight * np.concatenate(parts, axis=-1)).reshape(-1, len(unknown))
        return np.concatenate([slope, np.diag(self._prior_weights)])

    @property
    def _prior_weights(self) -> Float[np.ndarray, "unknown"]:
        pose = self.arrangement.model.off_prior(np.ones_like(self.arrangement.pose)).ravel()
        gains, seats = (
            np.full(9 * self.chips, 1 / _OPEN),
            np.full(3 * self.chips, 1 / self._seat_mm),
        )
        return np.concatenate([pose, gains, seats])

    @property
    def _seat_mm(self) -> float:
        return max(self.readings.seat_mm, 1e-3)

    def _split(
        self, unknown: Float[np.ndarray, "unknown"]
    ) -> tuple[Float[np.ndarray, "hold 8"], Float[np.ndarray, "chip 3"]]:
        return unknown[: self.poses].reshape(-1, 8), unknown[self.gains.stop :].reshape(-1, 3)

    def _turned(
        self, pose: Float[np.ndarray, "hold 8"], seat: Float[np.ndarray, "chip 3"]
    ) -> Float[np.ndarray, "hold chip 3"]:
        """Field counts of every chip along its own axes, as turned, with gains of 1."""
        moved = np.zeros_like(seat)
        moved[self.arrangement.site] = seat
        fields = self.arrangement.model.counts(pose, moved)[:, self.arrangement.site]
        # From designed chip axes b to those of the chip as it is turned, a
        return np.einsum("cab,hcb->hca", self.arrangement.turn, fields)


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

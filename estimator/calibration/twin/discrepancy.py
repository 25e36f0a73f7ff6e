"""Discrepancy of a calibrated model: a Gaussian process of location and force per channel.

u·g₁(x, y) + u²·g₂(x, y) with u = F / 10 N: nothing without force, errors of the small-strain part and
of large deformation apart. g₁ and g₂ are independent with one Matérn-5/2 kernel, of a size that is a
share of each channel's rms signal (Rasmussen & Williams, Gaussian Processes for Machine Learning,
2006, chapters 2 and 4).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from jaxtyping import Float
from scipy.linalg import block_diag, cho_factor, cho_solve

from design.spec.object import ObjectSpec
from estimator.calibration.twin.pressed_places import PressedPlaces

_FORCE_SCALE_N = 10.0
"""Force at which the discrepancy has the prior's size; it grows with the force."""
_FLOOR_COUNTS = 1.0
"""White noise, at least."""
_JITTER = 1e-8
"""Added to diagonals, so that a Cholesky factor exists in spite of rounding."""


@dataclass(frozen=True)
class Prior:
    """Before anything is known of what is left over.

    Attributes
    ----------
    size : standard deviation of either part at 10 N, as a share of a channel's rms signal
    length_mm : over which it changes
    """

    size: float
    length_mm: float


class Discrepancy:
    """Covariances of all means of some places, and what they tell of others."""

    def __init__(self, spec: ObjectSpec, prior: Prior, pressed: PressedPlaces) -> None:
        self.prior, self.pressed = prior, pressed
        self.scale = np.sqrt(np.mean(pressed.counts**2, axis=(0, 1)))
        white = pressed.white_counts2(spec) + _FLOOR_COUNTS**2
        self.white_of = white.reshape(-1, len(pressed.channels))
        kernel, zeros = (
            self.kernel_of(pressed.xy_mm, pressed.force_n),
            block_diag(*pressed.zero_counts2),
        )
        self._factors = [
            cho_factor((prior.size * scale) ** 2 * kernel + zeros + np.diag(variance), lower=True)
            for scale, variance in zip(self.scale, self.white_of.T, strict=True)
        ]

    def kernel_of(
        self, xy_mm: Float[np.ndarray, "place 2"], force_n: Float[np.ndarray, "place step"]
    ) -> Float[np.ndarray, "point row"]:
        """Between all steps of some places and all means, for size and scale 1."""
        means = self.pressed
        steps, levels = force_n.shape[1], means.force_n.shape[1]
        near = np.repeat(np.repeat(self.matern(xy_mm, means.xy_mm), steps, 0), levels, 1)
        product = np.outer(force_n.ravel(), means.force_n.ravel()) / _FORCE_SCALE_N**2
        return near * (product + product**2)

    def matern(
        self, a_mm: Float[np.ndarray, "a 2"], b_mm: Float[np.ndarray, "b 2"]
    ) -> Float[np.ndarray, "a b"]:
        away = np.linalg.norm(a_mm[:, None] - b_mm, axis=-1) * np.sqrt(5) / self.prior.length_mm
        return (1 + away + away**2 / 3) * np.exp(-away)

    def weighed(
        self, residual: Float[np.ndarray, "row channel *any"]
    ) -> Float[np.ndarray, "row channel *any"]:
        """Inverse covariance times values of all means, channel by channel."""
        parts = [
            cho_solve(factor, residual[:, channel]) for channel, factor in enumerate(self._factors)
        ]
        return np.stack(parts, axis=1)

    @cached_property
    def log_determinant(self) -> float:
        """Return the log determinant of all channels' covariances."""
        return float(sum(2 * np.log(np.diag(factor)).sum() for factor, _ in self._factors))

    def mean(
        self,
        residual: Float[np.ndarray, "row channel"],
        xy_mm: Float[np.ndarray, "place 2"],
        force_n: Float[np.ndarray, "place step"],
    ) -> Float[np.ndarray, "place step channel"]:
        """Expected rest at other places and forces, from that of all means."""
        kernel_values = self.kernel_of(xy_mm, force_n) @ self.weighed(residual)
        return (kernel_values * (self.prior.size * self.scale) ** 2).reshape(*force_n.shape, -1)

    def covariance(
        self, xy_mm: Float[np.ndarray, "place 2"], force_n: Float[np.ndarray, "place step"]
    ) -> Float[np.ndarray, "channel point point"]:
        """Before anything was pressed, of all steps of some places."""
        near = np.kron(self.matern(xy_mm, xy_mm), np.ones((force_n.shape[1],) * 2))
        product = np.outer(force_n, force_n) / _FORCE_SCALE_N**2
        size2 = (self.prior.size * self.scale) ** 2
        return size2[:, None, None] * near * (product + product**2)

    def doubt(
        self,
        xy_mm: Float[np.ndarray, "place 2"],
        force_n: Float[np.ndarray, "place step"],
        rng: np.random.Generator,
    ) -> Float[np.ndarray, "place step channel"]:
        """A draw of what the means leave open (Matheron's rule: a draw of the prior less what its own
        means, with noise, would tell)."""
        means = self.pressed
        both = np.concatenate([xy_mm, means.xy_mm])
        prior = self.matern(both, both) + _JITTER * np.eye(len(both))
        fields = np.linalg.cholesky(prior) @ rng.standard_normal((2, len(both), len(self.scale)))
        fields = fields * self.prior.size * self.scale
        here = scaled_by_force(fields[:, : len(xy_mm)], force_n)
        draw = scaled_by_force(fields[:, len(xy_mm) :], means.force_n)
        roots = np.linalg.cholesky(means.zero_counts2 + _JITTER * np.eye(draw.shape[1]))
        draw = draw + roots @ rng.standard_normal(draw.shape)
        draw = draw.reshape(-1, len(self.scale))
        draw = draw + np.sqrt(self.white_of) * rng.standard_normal(draw.shape)
        return here - self.mean(draw, xy_mm, force_n)


def scaled_by_force(
    fields: Float[np.ndarray, "2 place channel"], force_n: Float[np.ndarray, "place step"]
) -> Float[np.ndarray, "place step channel"]:
    share = (force_n / _FORCE_SCALE_N)[..., None]
    return share * fields[0][:, None] + share**2 * fields[1][:, None]

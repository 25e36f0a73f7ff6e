"""Cramér–Rao bounds of contact location and force, and the smallest force that can be detected.

Signals S(x, y, F), or S(x, y, F, Fx, Fy) with tangential forces, with Gaussian disturbances of
covariance Σ carry the Fisher information I = Jᵀ Σ⁻¹ J, J the derivatives of S by the parameters; no
unbiased estimator has a covariance below I⁻¹
(Kay, Fundamentals of Statistical Signal Processing, 1993, section 3). Force is a nuisance of the
position bound, and position of the force bound.

Σ = diag(σ²) + A Aᵀ: independent disturbances, and nuisances with unit normal priors that add the
columns of A to all channels (`estimator.signals.nuisances`). A channel whose row of J is 0 stands
still and drops out: it says nothing of the nuisances either.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import numpy as np
from jaxtyping import Bool, Float, Int

from design.spec.object import SensorSpec
from estimator.signals.interpolation import Traces, counts_at_force

NoiseState = Literal["fresh", "drifted"]
SUFFIXES: dict[NoiseState, str] = {"fresh": "", "drifted": "_drifted"}
"""In names of scores: `position_bound_mm` is of a fresh zero, `position_bound_drifted_mm` is not."""
DETECTION_DISTANCE = 5.0
"""A force is detectable where the signal's Mahalanobis distance from rest reaches this."""

_PARAMETERS = ("x", "y", "force", "x force", "y force")
_RANK_TOLERANCE = 1e-7
"""Singular value of columns of unit length below which a direction is not seen."""
_SMALLEST_FORCE_N = 1e-4
"""Smallest force at which detection is tried."""
_CLEARLY_SEEN = 1e-4
"""Volume that a press's three columns of unit length span: far from `_RANK_TOLERANCE`."""


@dataclass(frozen=True)
class Bounds:
    """Cramér–Rao bounds of presses; infinite where the signals cannot tell.

    Attributes
    ----------
    position_mm : √(σx² + σy²)
    position_mm2 : covariance of x and y, mm²; NaN where the signals cannot tell them
    force_n : σF of the normal force
    tangential_force_n : √(σFx² + σFy²); NaN where tangential forces are not asked
    weakest_direction : unit vector in the face's plane along which the place is least certain
    rank : 3 (5 with tangential forces) where all parameters are resolved
    blind_direction : unit vector in the parameters (mm and N) that leaves the signals unchanged;
        NaN where all are resolved
    """

    position_mm: Float[np.ndarray, "press"]
    position_mm2: Float[np.ndarray, "press 2 2"]
    force_n: Float[np.ndarray, "press"]
    tangential_force_n: Float[np.ndarray, "press"]
    weakest_direction: Float[np.ndarray, "press 2"]
    rank: Int[np.ndarray, "press"]
    blind_direction: Float[np.ndarray, "press parameter"]

    def status(self, press: int) -> str:
        """In words: "ok", or which change of contact leaves the signals as they are."""
        count = self.blind_direction.shape[1]
        if self.rank[press] == count:
            return "ok"
        direction = zip(_PARAMETERS, self.blind_direction[press], strict=False)
        mix = ", ".join(f"{name} {value:+.2g}" for name, value in direction if abs(value) > 1e-3)
        return f"blind to {count - self.rank[press]} of {count} parameters: along ({mix})"


def disturbance_counts(
    sensors: SensorSpec, state: NoiseState, channels: int
) -> Float[np.ndarray, "channel"]:
    """Standard deviation (counts) of each flat channel (sensor · 3 + axis).

    "fresh": white noise and `zeroing_counts` in quadrature, as just after zeroing. "drifted":
    white noise and `drift_counts`, unknown offsets with that rms, as after 15 minutes.
    """
    offset = {"fresh": sensors.zeroing_counts, "drifted": sensors.drift_counts}[state]
    return np.tile(np.hypot(np.asarray(sensors.noise_counts, float), offset), channels // 3)


def cramer_rao_bounds(
    jacobian: Float[np.ndarray, "press channel parameter"],
    sigma_counts: Float[np.ndarray, "channel"],
    nuisances: Float[np.ndarray, "channel k"] | None = None,
) -> Bounds:
    """Bounds from ∂S/∂(x, y, F) or ∂S/∂(x, y, F, Fx, Fy) (counts per mm and N), independent
    disturbances and nuisances (counts per standard deviation)."""
    white = squared_rows(whitened_slopes(jacobian, sigma_counts, nuisances))
    size = np.linalg.norm(white, axis=1)
    scale = np.where(size > 0, size, 1.0)
    _, singular, right = np.linalg.svd(white / scale[:, None], full_matrices=False)
    resolved = np.greater(singular, _RANK_TOLERANCE)
    inverse = np.where(resolved, singular, np.inf) ** -2.0
    # Σ_k v_k v_kᵀ/σ_k² = (JᵀJ)⁻¹: p press, k singular value, i and j parameters. Values that count as 0
    # are left out (1/∞); parameters that they touch become infinite below.
    covariance = np.einsum("pk,pki,pkj->pij", inverse, right, right)
    covariance = covariance / (scale[:, :, None] * scale[:, None, :])
    variance = np.diagonal(covariance, axis1=1, axis2=2).copy()
    blind = _touched_by_blindness(right, resolved)
    variance[blind] = np.inf
    has_position = np.asarray(~blind[:, :2].any(axis=1))[:, None, None]
    return Bounds(
        np.sqrt(variance[:, 0] + variance[:, 1]),
        np.where(has_position, covariance[:, :2, :2], np.nan),
        np.sqrt(variance[:, 2]),
        _tangential_bound(variance),
        _weakest_direction(covariance, right / scale[:, None], resolved),
        resolved.sum(axis=1),
        _blind_direction(right / scale[:, None], resolved),
    )


def whitened_slopes(
    jacobian: Float[np.ndarray, "press channel parameter"],
    sigma_counts: Float[np.ndarray, "channel"],
    nuisances: Float[np.ndarray, "channel k"] | None = None,
) -> Float[np.ndarray, "press channel parameter"]:
    """Return W J with WᵀW = Σ⁻¹ of the channels that do not stand still in a press."""
    if nuisances is None or not nuisances.shape[1]:
        return jacobian / sigma_counts[:, None]
    rows, moves = jacobian.swapaxes(1, 2), jacobian.any(axis=2)
    # The usual case: no chip is clipped. To sort presses by which are takes as long as to whiten them.
    if moves.all():
        return whitened(rows, sigma_counts, nuisances).swapaxes(1, 2)
    white = np.empty_like(jacobian)
    patterns, which = np.unique(moves, axis=0, return_inverse=True)
    for number, moving in enumerate(patterns):
        some = which.ravel() == number
        shared = nuisances * moving[:, None]
        white[some] = whitened(rows[some], sigma_counts, shared).swapaxes(1, 2)
    return white


def whitened(
    counts: Float[np.ndarray, "*any channel"],
    sigma_counts: Float[np.ndarray, "channel"],
    nuisances: Float[np.ndarray, "channel k"] | None = None,
) -> Float[np.ndarray, "*any channel"]:
    """Return rows of counts times W, with WᵀW = Σ⁻¹.

    With A/σ = U s Vᵀ, Σ = D (1 + U s² Uᵀ) D for D = diag(σ), so W = (1 − U (1 − 1/√(1 + s²)) Uᵀ) D⁻¹.
    """
    white = counts / sigma_counts
    if nuisances is None or not nuisances.shape[1]:
        return white
    basis, size, _ = np.linalg.svd(nuisances / sigma_counts[:, None], full_matrices=False)
    return white - ((white @ basis) * (1 - 1 / np.hypot(1, size))) @ basis.T


def position_and_force_bounds(
    jacobian: Float[np.ndarray, "press channel 3"],
    sigma_counts: Float[np.ndarray, "channel"],
    nuisances: Float[np.ndarray, "channel k"] | None = None,
) -> tuple[Float[np.ndarray, "press"], Float[np.ndarray, "press"]]:
    """`position_mm` and `force_n` of `cramer_rao_bounds`, to rounding, in a fifth of the time.

    By Gram and Schmidt's method on all presses at once, without squares of the matrix; presses that are
    nearly blind go the long way.
    """
    white = whitened_slopes(jacobian, sigma_counts, nuisances)
    size = np.linalg.norm(white, axis=1)
    columns = np.moveaxis(white / np.where(size > 0, size, 1.0)[:, None], 2, 0)
    x, y, force = columns.copy()
    on_x = _dot(x, x)
    xy = _dot(x, y) / np.where(on_x > 0, on_x, 1.0)
    y = y - xy[:, None] * x
    on_y = _dot(y, y)
    xf = _dot(x, force) / np.where(on_x > 0, on_x, 1.0)
    force = force - xf[:, None] * x
    yf = _dot(y, force) / np.where(on_y > 0, on_y, 1.0)
    force = force - yf[:, None] * y
    on_force = _dot(force, force)
    clear = on_x * on_y * on_force > _CLEARLY_SEEN**2
    on_x, on_y, on_force = (np.where(clear, on, 1.0) for on in (on_x, on_y, on_force))
    of_force = 1 / on_force
    of_y = 1 / on_y + yf**2 * of_force
    of_x = 1 / on_x + xy**2 / on_y + (xf - xy * yf) ** 2 * of_force
    size = np.where(clear[:, None], size, 1.0)
    position = np.sqrt(of_x / size[:, 0] ** 2 + of_y / size[:, 1] ** 2)
    newton = np.sqrt(of_force) / size[:, 2]
    if not clear.all():
        rest = cramer_rao_bounds(jacobian[~clear], sigma_counts, nuisances)
        position[~clear], newton[~clear] = rest.position_mm, rest.force_n
    return position, newton


def _dot(
    a: Float[np.ndarray, "press channel"], b: Float[np.ndarray, "press channel"]
) -> Float[np.ndarray, "press"]:
    return np.einsum("pc,pc->p", a, b)


def squared_rows(
    whitened: Float[np.ndarray, "press channel parameter"],
) -> Float[np.ndarray, "press row parameter"]:
    """Return the rows, with rows of zeros up to the number of parameters."""
    presses, channels, parameters = whitened.shape
    missing = np.zeros((presses, max(0, parameters - channels), parameters))
    return np.concatenate([whitened, missing], axis=1)


def _tangential_bound(
    variance: Float[np.ndarray, "press parameter"],
) -> Float[np.ndarray, "press"]:
    if variance.shape[1] == 3:
        return np.full(len(variance), np.nan)
    return np.sqrt(variance[:, 3:].sum(axis=1))


def _touched_by_blindness(
    right: Float[np.ndarray, "press k parameter"], resolved: Bool[np.ndarray, "press k"]
) -> Bool[np.ndarray, "press parameter"]:
    """Parameters with a share in a direction that is not seen: they have no finite bound."""
    share = np.where(resolved[:, :, None], 0.0, right**2).sum(axis=1)
    return np.asarray(share > 1e-10)


def _blind_direction(
    right: Float[np.ndarray, "press k parameter"], resolved: Bool[np.ndarray, "press k"]
) -> Float[np.ndarray, "press parameter"]:
    last = right[:, -1] / np.linalg.norm(right[:, -1], axis=1, keepdims=True)
    return np.where(resolved.all(axis=1, keepdims=True), np.nan, last)


def _weakest_direction(
    covariance: Float[np.ndarray, "press k parameter"],
    right: Float[np.ndarray, "press k parameter"],
    resolved: Bool[np.ndarray, "press k"],
) -> Float[np.ndarray, "press 2"]:
    weakest = np.linalg.eigh(covariance[:, :2, :2])[1][:, :, -1]
    blind = right[:, -1, :2]
    length = np.linalg.norm(blind, axis=1)
    use = np.logical_not(resolved[:, -1]) & (length > 1e-6 * np.linalg.norm(right[:, -1], axis=1))
    weakest[use] = blind[use] / length[use, None]
    return weakest


def detectable_force_n(
    traces: Traces,
    sigma_counts: Float[np.ndarray, "channel"],
    distance: float = DETECTION_DISTANCE,
    read: Callable[[Float[np.ndarray, "press frame channel"]], np.ndarray] = lambda change: change,
    nuisances: Float[np.ndarray, "channel k"] | None = None,
) -> Float[np.ndarray, "press"]:
    """Smallest force (N) at which √(ΔSᵀ Σ⁻¹ ΔS), the Mahalanobis distance from rest, is reached.

    `read` makes of expected changes what chips tell of them (`estimator.signals.live.read_change`).
    `nuisances` as of `cramer_rao_bounds`; channels that never change drop out.

    Found between forces 3 % apart by linear interpolation; infinite where the deepest press does
    not reach the distance.
    """
    largest = traces.force_n[:, -1:]
    steps = int(np.ceil(np.log(largest.max() / _SMALLEST_FORCE_N) / np.log(1.03)))
    force = largest * np.geomspace(_SMALLEST_FORCE_N / largest.max(), 1.0, steps)
    force = np.concatenate([np.zeros_like(largest), force], axis=1)
    counts = read(counts_at_force(traces, force, beyond="clamp").counts)
    if nuisances is not None:
        nuisances = nuisances * np.asarray(counts.any(axis=(0, 1)))[:, None]
    reached = np.linalg.norm(whitened(counts, sigma_counts, nuisances), axis=2)
    above = np.argmax(reached >= distance, axis=1)
    row, below = np.arange(len(force)), np.maximum(above - 1, 0)
    rise = reached[row, above] - reached[row, below]
    share = (distance - reached[row, below]) / np.where(rise > 0, rise, 1.0)
    detected = force[row, below] + share * (force[row, above] - force[row, below])
    return np.where(above > 0, detected, np.inf)

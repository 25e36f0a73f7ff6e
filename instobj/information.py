"""Information in signals, as pure functions: bounds of a contact, forces that are felt, sensitivity."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from design.errors import InputError

if TYPE_CHECKING:
    import xarray as xr
    from numpy.typing import ArrayLike

__all__ = ["contact_bounds", "detectable_force", "hull_sensitivity"]


def contact_bounds(jacobian: ArrayLike, sigma_counts: ArrayLike) -> xr.Dataset:
    """Cramér–Rao bounds of contact location and force, from the slopes of the signals.

    The bound is √ of the inverse Fisher information Jᵀ Σ⁻¹ J (Kay, Statistical Signal Processing,
    1993, section 3). Where the signals cannot tell a parameter its bound is infinite.

    Parameters
    ----------
    jacobian : array_like (press, channel, parameter)
        Slopes of the signals by x, y (counts/mm) and force (counts/N), and by the tangential forces
        along x and y (counts/N) where there are five parameters.
    sigma_counts : array_like (channel,)
        Standard deviation of each channel's independent noise, counts.

    Returns
    -------
    Dataset (press)
        `position_bound_mm` = √(σx² + σy²) (mm), `force_bound_n` (N), `rank`: number of parameters
        that the signals tell.

    Raises
    ------
    InputError
        Shapes that do not fit, or a standard deviation that is not positive.

    Examples
    --------
    Three channels that each see one parameter:

    >>> import numpy as np
    >>> import instobj
    >>> slopes = np.diag([20.0, 20.0, 40.0])[None]
    >>> bounds = instobj.information.contact_bounds(slopes, [20.0, 20.0, 20.0])
    >>> bounds.position_bound_mm.values.round(3), bounds.force_bound_n.values
    (array([1.414]), array([0.5]))
    >>> bounds
    Results: press 1
      position_bound_mm  (press)  mm  1.414
      force_bound_n      (press)  N   0.5
      rank               (press)  1   3
    """
    from estimator.information.fisher import cramer_rao_bounds
    from instobj.stages.named import Results

    slopes, sigma = np.asarray(jacobian, float), np.asarray(sigma_counts, float)
    if slopes.ndim != 3 or slopes.shape[2] not in (3, 5) or not np.isfinite(slopes).all():
        raise InputError(
            "jacobian must be finite numbers of shape (press, channel, 3 or 5); got "
            f"shape {slopes.shape}"
        )
    _require_sigma(sigma, slopes.shape[1])
    bounds = cramer_rao_bounds(slopes, sigma)
    return Results(
        {
            "position_bound_mm": ("press", bounds.position_mm, {"units": "mm"}),
            "force_bound_n": ("press", bounds.force_n, {"units": "N"}),
            "rank": ("press", bounds.rank, {"units": "1"}),
        }
    )


def detectable_force(
    force_n: ArrayLike, delta_counts: ArrayLike, sigma_counts: ArrayLike, distance: float = 5.0
) -> xr.DataArray:
    """Smallest force whose change of the signals stands out of the noise.

    It is the force at which the Mahalanobis distance √(ΔSᵀ Σ⁻¹ ΔS) from rest reaches `distance`.

    Parameters
    ----------
    force_n : array_like (press, step)
        Forces of each press, rising, N.
    delta_counts : array_like (press, step, channel)
        Change of every channel against rest at these forces, counts.
    sigma_counts : array_like (channel,)
        Standard deviation of each channel's independent noise, counts.
    distance : float
        In standard deviations.

    Returns
    -------
    DataArray (press)
        Force, N; infinite where the largest force does not reach the distance.

    Raises
    ------
    InputError
        Shapes that do not fit, forces that do not rise from above 0, or a standard deviation that is
        not positive.

    Examples
    --------
    A channel of 50 counts/N against 10 counts of noise:

    >>> import instobj
    >>> felt = instobj.information.detectable_force([[1.0, 2.0]], [[[50.0], [100.0]]], [10.0])
    >>> felt.values.round(2), felt.attrs["units"]
    (array([1.]), 'N')
    """
    import xarray as xr

    from estimator.information.fisher import detectable_force_n
    from estimator.signals.interpolation import Traces

    force, counts = np.asarray(force_n, float), np.asarray(delta_counts, float)
    if force.ndim != 2 or counts.shape[:2] != force.shape or counts.ndim != 3:
        raise InputError(
            "force_n must have the shape (press, step) and delta_counts (press, step, channel); got "
            f"{force.shape} and {counts.shape}"
        )
    # rest is the first node of a trace: no force, no change
    force = np.concatenate([np.zeros((len(force), 1)), force], axis=1)
    counts = np.concatenate([np.zeros((len(counts), 1, counts.shape[2])), counts], axis=1)
    if not (np.isfinite(counts).all() and (np.diff(force, axis=1) > 0).all()):
        raise InputError("force_n must rise from above 0, and delta_counts be finite")
    sigma = np.asarray(sigma_counts, float)
    _require_sigma(sigma, counts.shape[2])
    steps = np.arange(force.shape[1], dtype=float)
    traces = Traces(steps, force, counts, np.zeros(force.shape, bool))
    force_n = detectable_force_n(traces, sigma, distance)
    return xr.DataArray(force_n, dims="press", attrs={"units": "N"}, name="detectable_force_n")


def hull_sensitivity(
    press_counts: ArrayLike,
    force_range_n: ArrayLike,
    noise_counts: ArrayLike,
    frames: int = 1000,
) -> xr.DataArray:
    """Sensitivity δ of Knopke et al.: volume of the signals' convex hull over the range of force.

    Computed from the covariance, which is exact for normal signals.

    Parameters
    ----------
    press_counts : array_like (place, sample, channel)
        Noise-free counts over whole periods of a press.
    force_range_n : array_like (place,)
        Range of force of each press, N.
    noise_counts : array_like (channel,)
        White noise of each channel, counts rms.
    frames : int
        Number N of frames for which the hull is taken.

    Returns
    -------
    DataArray (place)
        δ, counts^d/N with d channels.

    Raises
    ------
    InputError
        Shapes that do not fit, or a noise that is not positive: without it there is no volume.

    Examples
    --------
    Half the range of force, twice the sensitivity:

    >>> import numpy as np
    >>> import instobj
    >>> phase = np.linspace(0, 2 * np.pi, 40, endpoint=False)
    >>> wave = np.stack([np.cos(phase), np.sin(phase)], axis=1)[None] * 100
    >>> ten, five = (instobj.information.hull_sensitivity(wave, [f], [5.0, 5.0]) for f in (10, 5))
    >>> (five / ten).values.round(9)
    array([2.])
    """
    import xarray as xr

    from estimator.information.sensitivity import covariance_sensitivity

    counts, noise = np.asarray(press_counts, float), np.asarray(noise_counts, float)
    span = np.asarray(force_range_n, float)
    if counts.ndim != 3 or span.shape != counts.shape[:1] or not np.isfinite(counts).all():
        raise InputError(
            "press_counts must be finite numbers of shape (place, sample, channel) and force_range_n of "
            f"shape (place,); got {counts.shape} and {span.shape}"
        )
    if not (span > 0).all():
        raise InputError("force_range_n must be positive")
    _require_sigma(noise, counts.shape[2])
    if frames <= counts.shape[2] + 1:
        raise InputError(f"frames must be more than {counts.shape[2] + 1}; got {frames}")
    sensitivity = covariance_sensitivity(counts, span, noise, frames)
    unit = f"count^{counts.shape[2]}/N"
    return xr.DataArray(sensitivity.delta, dims="place", attrs={"units": unit}, name="delta")


def _require_sigma(sigma: np.ndarray, channels: int) -> None:
    if sigma.shape != (channels,) or not (np.isfinite(sigma).all() and (sigma > 0).all()):
        raise InputError(
            f"standard deviations must be {channels} positive counts, one for each channel; got "
            f"{sigma.tolist()}"
        )

"""Convex-hull sensitivity δ of contact places (Knopke et al., RA-L 2024).

δ = ConvexHullVolume(S ∈ R^(N×d)) / range(F), with S the signals of the face's own d channels in N
frames of one place. The volume exists only because of noise: a noise-free press traces a curve.
It also grows with N, 60-fold from 50 to 600 frames, so a δ is given with its N and its noise.
Two forms: the exact hull (up to 100 frames; minutes and gigabytes beyond), and the covariance
equivalent δ_N = c(N, d) √det cov(S) / range(F), where c is the mean hull volume of N standard
normal points. Presses are not normal: sizes agree within 45 % place by place (median ratio 0.92 to
1.05 at N = 30 to 100), ranks within what one noisy hull repeats. Rank correlations: ≥ 0.95 with
mean hulls of a synthetic object, N = 30 and 100 (tested); for the simulated cube 0.97 with the
mean of six hulls at N = 40 and 0.92 with single hulls at N = 100.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from jaxtyping import Float, Int

from design.errors import InputError
from design.spec import SensorSpec
from estimator.interpolation import Traces, counts_at_force
from estimator.signals import Signals

LARGEST_EXACT_FRAMES = 100


@dataclass(frozen=True)
class Sensitivity:
    """δ of places and all that it depends on.

    `delta` (place,): counts^d/N, or 1/N where the signals were scaled. `frames` is N;
    `noise_counts` (channel,) the white noise included.
    """

    delta: Float[np.ndarray, "place"]
    frames: int
    noise_counts: Float[np.ndarray, "channel"]
    form: Literal["covariance equivalent", "exact hull"]


def own_channels(signals: Signals, sensors: SensorSpec, face: int) -> Int[np.ndarray, "channel"]:
    """Flat channel indices (sensor · 3 + axis) of a face's own sensors."""
    count = 3 * sensors.count_per_face
    return (int(face) - 1) * count + np.arange(count)


def channel_noise(sensors: SensorSpec, channels: int) -> Float[np.ndarray, "channel"]:
    """White noise (counts) of each flat channel."""
    return np.tile(np.asarray(sensors.noise_counts, float), channels // 3)


def periodic_press(
    traces: Traces, peak_force_n: Float[np.ndarray, "place"], frames: int
) -> Float[np.ndarray, "place frame channel"]:
    """Noise-free counts over one period of a raised-cosine force from 0 to each peak."""
    phase = 2 * np.pi * (np.arange(frames) + 0.5) / frames
    force = peak_force_n[:, None] * (1 - np.cos(phase)) / 2
    return counts_at_force(traces, force).counts


def covariance_sensitivity(
    press_counts: Float[np.ndarray, "place sample channel"],
    force_range_n: Float[np.ndarray, "place"],
    noise_counts: Float[np.ndarray, "channel"],
    frames: int,
) -> Sensitivity:
    """δ from the covariance of noise-free presses, with white noise added analytically.

    Parameters
    ----------
    press_counts : noise-free counts over whole periods (any number of samples)
    frames : N for which c(N, d) is taken

    Raises
    ------
    InputError
        N does not exceed the number of channels, or signals without noise span no volume.
    """
    if not noise_counts.all():
        raise InputError(_no_volume(int(np.sum(noise_counts > 0)), len(noise_counts)))
    about = press_counts - press_counts.mean(axis=1, keepdims=True)
    covariance = np.einsum("psc,psd->pcd", about, about) / about.shape[1]
    covariance = covariance + np.diag(noise_counts**2)
    log_volume = ln_hull_factor(frames, len(noise_counts)) + np.linalg.slogdet(covariance)[1] / 2
    delta = np.exp(log_volume) / force_range_n
    return Sensitivity(delta, frames, noise_counts, "covariance equivalent")


def hull_sensitivity(
    press_counts: Float[np.ndarray, "place frame channel"],
    force_range_n: Float[np.ndarray, "place"],
    noise_counts: Float[np.ndarray, "channel"],
    rng: np.random.Generator,
) -> Sensitivity:
    """δ from the exact hull of one noisy realization of each press; N = number of frames."""
    noisy = press_counts + rng.standard_normal(press_counts.shape) * noise_counts
    volume = np.array([hull_volume(samples) for samples in noisy])
    return Sensitivity(volume / force_range_n, noisy.shape[1], noise_counts, "exact hull")


def hull_volume(samples: Float[np.ndarray, "frame channel"]) -> float:
    """Volume of the convex hull of frames, exact (Qhull): 0.3 s for 50 frames in nine channels.

    Raises
    ------
    InputError
        Too few frames, too many (above 100), or frames that lie in a subspace.
    """
    from scipy.spatial import ConvexHull

    frames, channels = samples.shape
    _check_frames(frames, channels)
    if frames > LARGEST_EXACT_FRAMES:
        raise InputError(
            f"the exact hull is limited to {LARGEST_EXACT_FRAMES} frames; got {frames}. Use the "
            "covariance equivalent, or a subset of the frames"
        )
    about = samples - samples.mean(axis=0)
    sizes = np.maximum(np.linalg.norm(about, axis=0), 1e-300)
    rank = int(np.linalg.matrix_rank(about / sizes, tol=1e-9 * np.sqrt(channels)))
    if rank < channels:
        raise InputError(_no_volume(rank, channels))
    # equal scales keep Qhull's round-off tests fair; the volume scales back by their product
    return float(ConvexHull(about / sizes).volume * np.prod(sizes))


def ln_hull_factor(frames: int, channels: int) -> float:
    """ln c(N, d): mean hull volume of N standard normal points in d dimensions (exact).

    E V = κ_d (2π)^(−d/2) C(N, d+1) (d+1)/√π ∫ exp(−(d+1)x²) Φ(√2 x)^(N−d−1) dx: a Gaussian
    polytope is a projection of the regular simplex (Affentranger, 1991; Baryshnikov and Vitale,
    1994). It refers to the true covariance; with a sample's own one c is larger by
    `ln_sample_covariance_factor`.
    """
    from scipy.special import gammaln, log_ndtr, logsumexp

    _check_frames(frames, channels)
    d = channels
    x = np.linspace(-8, 12, 20001)
    exponent = -(d + 1) * x**2 + (frames - d - 1) * log_ndtr(np.sqrt(2) * x)
    ln_sum: Any = logsumexp(exponent)
    ln_integral = ln_sum + np.log(x[1] - x[0])
    ln_ball = d / 2 * np.log(np.pi) - gammaln(d / 2 + 1)
    ln_simplices = gammaln(frames + 1) - gammaln(d + 2) - gammaln(frames - d)
    constants = np.log(d + 1) - np.log(np.pi) / 2 - d / 2 * np.log(2 * np.pi)
    return float(ln_ball + ln_simplices + constants + ln_integral)


def ln_sample_covariance_factor(frames: int, channels: int) -> float:
    """Mean of −ln √det of the sample covariance of N standard normal points (Bartlett)."""
    from scipy.special import digamma

    freedom = frames - 1 - np.arange(channels)
    return float(-0.5 * np.sum(digamma(freedom / 2) + np.log(2 / (frames - 1))))


def _check_frames(frames: int, channels: int) -> None:
    if frames <= channels + 1:
        raise InputError(
            f"a volume in {channels} channels wants more than {channels + 1} frames; got {frames}. "
            "Raise score.hull_frames"
        )


def _no_volume(rank: int, channels: int) -> str:
    return (
        f"the signals span {rank} of {channels} dimensions, so their convex hull has no volume: a "
        "noise-free press traces a curve. Include the sensors' noise (sensors.noise_counts > 0)"
    )

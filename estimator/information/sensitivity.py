"""Convex-hull sensitivity δ of contact locations (Knopke et al., RA-L 2024).

δ = ConvexHullVolume(S ∈ R^(N×d)) / range(F), with S the signals of the face's own d channels in N
frames of one place. The volume exists only because of noise: a noise-free press traces a curve.
It also grows with N, 60-fold from 50 to 600 frames, so a δ is given with its N and its noise.
Here δ_N = c(N, d) √det cov(S) / range(F), where c is the mean hull volume of N standard normal points.
Presses are not normal: compared with exact hulls of noisy presses sizes agree within 45 % place by place
(median ratio 0.92 to 1.05 at N = 30 to 100), ranks within what one noisy hull repeats. Rank
correlations: ≥ 0.95 with mean hulls of a synthetic object, N = 30 and 100 (tested); for the simulated
cube 0.97 with the mean of six hulls at N = 40 and 0.92 with single hulls at N = 100.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from jaxtyping import Float, Int

from design.errors import InputError
from design.layout.places.positions import live_channels
from design.spec.object import ObjectSpec, SensorSpec
from estimator.signals.interpolation import Traces, counts_at_force
from estimator.signals.presses import Signals

HULL_FRAMES = 1000
"""N of δ, the frames of a contact case of Knopke et al."""


@dataclass(frozen=True)
class Sensitivity:
    """δ of places and all that it depends on.

    `delta` (place,): counts^d/N, or 1/N where the signals were scaled. `frames` is N; `noise_counts`
    (channel,) the white noise included.
    """

    delta: Float[np.ndarray, "place"]
    frames: int
    noise_counts: Float[np.ndarray, "channel"]

    def scaled(self, span_counts: Float[np.ndarray, "channel"]) -> Sensitivity:
        """δ with every channel divided by its span: a volume divides by their product (exact)."""
        by = float(np.prod(span_counts))
        return Sensitivity(self.delta / by, self.frames, self.noise_counts / span_counts)


def own_channels(signals: Signals, sensors: SensorSpec, face: int) -> Int[np.ndarray, "channel"]:
    """Flat channel indices (sensor · 3 + axis) of a face's own sensors, which run as the faces do."""
    count = 3 * sensors.count_per_face
    return int(np.flatnonzero(signals.faces == face)[0]) * count + np.arange(count)


def read_channels(spec: ObjectSpec, signals: Signals, face: int) -> Int[np.ndarray, "channel"]:
    """Return the flat channels that bounds read in presses on a face: live ones, by `score.channels`."""
    live = live_channels(spec).ravel()
    channels = np.arange(live.size)
    if spec.score.channels == "own":
        channels = own_channels(signals, spec.sensors, face)
    return channels[live[channels]]


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
    frames: int = HULL_FRAMES,
) -> Sensitivity:
    """δ from the covariance of noise-free presses, with white noise added analytically.

    Parameters
    ----------
    press_counts : noise-free counts over whole periods (any number of samples)
    frames : N for which c(N, d) is taken, more than d + 1

    Raises
    ------
    InputError
        Signals without noise, which span no volume.
    """
    if not noise_counts.all():
        raise InputError(
            f"the signals span {np.sum(noise_counts > 0)} of {len(noise_counts)} dimensions, so their convex "
            "hull has no volume: a noise-free press traces a curve. Include the sensors' noise "
            "(sensors.noise_counts > 0)"
        )
    about = press_counts - press_counts.mean(axis=1, keepdims=True)
    # p press, s sample along it, c and d dimensions
    covariance = np.einsum("psc,psd->pcd", about, about) / about.shape[1]
    covariance = covariance + np.diag(noise_counts**2)
    log_volume = ln_hull_factor(frames, len(noise_counts)) + np.linalg.slogdet(covariance)[1] / 2
    return Sensitivity(np.exp(log_volume) / force_range_n, frames, noise_counts)


def ln_hull_factor(frames: int, channels: int) -> float:
    """ln c(N, d): mean hull volume of N standard normal points in d dimensions (exact).

    E V = κ_d (2π)^(−d/2) C(N, d+1) (d+1)/√π ∫ exp(−(d+1)x²) Φ(√2 x)^(N−d−1) dx: a Gaussian
    polytope is a projection of the regular simplex (Affentranger, 1991; Baryshnikov and Vitale,
    1994). It refers to the true covariance; with a sample's own one c is larger by the mean of
    1/√det of that (Bartlett).
    """
    from scipy.special import gammaln, log_ndtr, logsumexp

    d = channels
    x = np.linspace(-8, 12, 20001)
    exponent = -(d + 1) * x**2 + (frames - d - 1) * log_ndtr(np.sqrt(2) * x)
    ln_sum: Any = logsumexp(exponent)
    ln_integral = ln_sum + np.log(x[1] - x[0])
    ln_simplices = gammaln(frames + 1) - gammaln(d + 2) - gammaln(frames - d)
    constants = np.log(d + 1) - np.log(np.pi) / 2 - d / 2 * np.log(2 * np.pi)
    return float(ln_ball_volume(d) + ln_simplices + constants + ln_integral)


def ln_ball_volume(dimensions: int) -> float:
    """ln κ_d, the volume of the unit ball."""
    from scipy.special import gammaln

    return float(dimensions / 2 * np.log(np.pi) - gammaln(dimensions / 2 + 1))

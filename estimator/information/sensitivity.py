"""Convex-hull sensitivity δ of contact locations (Knopke et al., RA-L 2024).

δ = ConvexHullVolume(S ∈ R^(N×d)) / range(F), with S the signals of the face's own d channels in N
frames of one place. The volume exists only because of noise: a noise-free press traces a curve.
It also grows with N, 60-fold from 50 to 600 frames, so a δ is given with its N and its noise.
Three forms: the exact hull of one noisy press (up to 100 frames; minutes and gigabytes beyond), its
volume by Monte Carlo at any N (with a standard error), and the covariance equivalent
δ_N = c(N, d) √det cov(S) / range(F), where c is the mean hull volume of N standard normal points.
Presses are not normal: sizes agree within 45 % place by place (median ratio 0.92 to 1.05 at N = 30
to 100), ranks within what one noisy hull repeats. Rank correlations: ≥ 0.95 with mean hulls of a
synthetic object, N = 30 and 100 (tested); for the simulated cube 0.97 with the mean of six hulls at
N = 40 and 0.92 with single hulls at N = 100.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float, Int

from design.errors import InputError
from design.spec.learning import HullForm
from design.spec.object import SensorSpec
from estimator.information.hull import (
    exact_hull_volume,
    ln_hull_factor,
    monte_carlo_hull_volume,
    no_volume_message,
)
from estimator.signals.interpolation import Traces, counts_at_force
from estimator.signals.presses import Signals


@dataclass(frozen=True)
class Sensitivity:
    """δ of places and all that it depends on.

    `delta` (place,): counts^d/N, or 1/N where the signals were scaled. `standard_error` (place,) in
    the same unit is that of the Monte Carlo; 0 for the other forms, which draw no directions.
    `frames` is N; `noise_counts` (channel,) the white noise included.
    """

    delta: Float[np.ndarray, "place"]
    standard_error: Float[np.ndarray, "place"]
    frames: int
    noise_counts: Float[np.ndarray, "channel"]
    form: HullForm

    def scaled(self, span_counts: Float[np.ndarray, "channel"]) -> Sensitivity:
        """δ with every channel divided by its span: a volume divides by their product (exact)."""
        by = float(np.prod(span_counts))
        return Sensitivity(
            self.delta / by,
            self.standard_error / by,
            self.frames,
            self.noise_counts / span_counts,
            self.form,
        )


def own_channels(signals: Signals, sensors: SensorSpec, face: int) -> Int[np.ndarray, "channel"]:
    """Flat channel indices (sensor · 3 + axis) of a face's own sensors, which run as the faces do."""
    count = 3 * sensors.count_per_face
    return int(np.flatnonzero(signals.faces == face)[0]) * count + np.arange(count)


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
        raise InputError(no_volume_message(int(np.sum(noise_counts > 0)), len(noise_counts)))
    about = press_counts - press_counts.mean(axis=1, keepdims=True)
    covariance = np.einsum("psc,psd->pcd", about, about) / about.shape[1]
    covariance = covariance + np.diag(noise_counts**2)
    log_volume = ln_hull_factor(frames, len(noise_counts)) + np.linalg.slogdet(covariance)[1] / 2
    delta = np.exp(log_volume) / force_range_n
    return Sensitivity(delta, 0 * delta, frames, noise_counts, "covariance")


def hull_sensitivity(
    press_counts: Float[np.ndarray, "place frame channel"],
    force_range_n: Float[np.ndarray, "place"],
    noise_counts: Float[np.ndarray, "channel"],
    rng: np.random.Generator,
    form: HullForm = "exact",
) -> Sensitivity:
    """δ from the hull of one noisy realization of each press, exact or by Monte Carlo.

    N is the number of frames given. Raises as `exact_hull_volume` and `monte_carlo_hull_volume` do.
    """
    noisy = press_counts + rng.standard_normal(press_counts.shape) * noise_counts
    if form == "exact":
        found = [exact_hull_volume(samples) for samples in noisy]
    else:
        found = [monte_carlo_hull_volume(samples, rng) for samples in noisy]
    return Sensitivity(
        np.array([hull.volume for hull in found]) / force_range_n,
        np.array([hull.standard_error for hull in found]) / force_range_n,
        noisy.shape[1],
        noise_counts,
        form,
    )

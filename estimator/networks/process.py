"""Gaussian process that supports the networks, as tensors, so that it is saved and exported alike.

Rasmussen & Williams, Gaussian Processes for Machine Learning (2006), chapter 2: squared-exponential
kernel and noise of the greatest likelihood, found by scikit-learn. Between contact locations that
were pressed its answer is drawn smoothly, and far from them it goes back to the mean of what was
learned: on recordings of a few places nothing errs less at a new one, and a linear trend with it,
which follows strong signals to any force, errs far more.
"""

from __future__ import annotations

import warnings
from typing import Any, NamedTuple

import numpy as np
import torch
from jaxtyping import Float
from torch import Tensor, nn

from estimator.frames.face_data import Channel, FaceData, channel_counts

MOST_FRAMES = 1000
FRAMES_OF_KERNEL = 300
"""Frames that the kernel is chosen on; the time for it grows with their cube."""
_NOISES = 1e-4, 1e1
"""Variance of the noise over that of the target. With less the answer follows single frames."""


class ProcessShape(NamedTuple):
    """Learned frames of the force, and of the place."""

    force_frames: int
    place_frames: int


class ProcessRegression(nn.Module):
    """Exact regression to targets that share one kernel; double precision, as squares cancel."""

    mean_counts: Tensor
    scale_counts: Tensor
    known: Tensor
    weights: Tensor
    length: Tensor
    mean: Tensor

    def __init__(self, frames: int, channels: int, targets: int) -> None:
        super().__init__()
        shapes = {
            "mean_counts": (channels,),
            "scale_counts": (channels,),
            "known": (frames, channels),
            "weights": (frames, targets),
            "length": (),
            "mean": (targets,),
        }
        for name, shape in shapes.items():
            self.register_buffer(name, torch.ones(shape, dtype=torch.float64))

    def forward(self, counts: Float[Tensor, "frame channel"]) -> Float[Tensor, "frame target"]:
        standardised = (counts.double() - self.mean_counts) / self.scale_counts
        apart = (
            (standardised**2).sum(1, keepdim=True)
            + (self.known**2).sum(1)
            - 2 * standardised @ self.known.T
        )
        alike = torch.exp(-apart.clamp(min=0.0) / (2 * self.length**2))
        return alike @ self.weights + self.mean

    def fit(
        self, counts: Float[np.ndarray, "frame channel"], target: Float[np.ndarray, "frame target"]
    ) -> None:
        """Standardise, choose the kernel, and solve with its matrix over all given frames."""
        mean, scale = counts.mean(axis=0), counts.std(axis=0)
        scale = np.where(scale > 0, scale, 1.0)
        standardised, middle = (counts - mean) / scale, target.mean(axis=0)
        spread = float(np.sqrt(target.var(axis=0).mean())) or 1.0
        aim = (target - middle) / spread
        variance, length, noise = chosen_kernel(standardised, aim)
        square = (standardised**2).sum(axis=1)
        apart = np.maximum(square[:, None] + square - 2 * standardised @ standardised.T, 0.0)
        matrix = variance * np.exp(-apart / (2 * length**2)) + noise * np.eye(len(standardised))
        columns = {
            "mean_counts": mean,
            "scale_counts": scale,
            "known": standardised,
            "weights": spread * variance * np.linalg.solve(matrix, aim),
            "length": length,
            "mean": middle,
        }
        for name, value in columns.items():
            getattr(self, name).copy_(torch.as_tensor(value))


class Process(nn.Module):
    """Force (N) from all frames, place (mm) from those with contact; the place within the grid."""

    low_mm: Tensor
    high_mm: Tensor

    def __init__(self, shape: ProcessShape, channels: int) -> None:
        super().__init__()
        self.shape = shape
        self.force = ProcessRegression(shape.force_frames, channels, 1)
        self.place = ProcessRegression(shape.place_frames, channels, 2)
        for name in ("low_mm", "high_mm"):
            self.register_buffer(name, torch.zeros(2))

    def forward(
        self, counts: Float[Tensor, "frame channel"]
    ) -> tuple[Float[Tensor, "frame"], Float[Tensor, "frame 2"]]:
        """Total force (N) and its centre (mm)."""
        force_n = self.force(counts)[:, 0].clamp(min=0.0).float()
        xy_mm = self.place(counts).float()
        return force_n, torch.minimum(torch.maximum(xy_mm, self.low_mm), self.high_mm)


def fit_process(data: FaceData, channels: tuple[Channel, ...], seed: int) -> Process:
    """At most `MOST_FRAMES` frames each are learned, drawn by the seed."""
    counts, touched = channel_counts(data.frames, channels), np.flatnonzero(data.contact)
    rng = np.random.default_rng(seed)
    drawn, drawn_touched = (
        rng.permutation(rows)[:MOST_FRAMES] for rows in (np.arange(len(data)), touched)
    )
    process = Process(ProcessShape(len(drawn), len(drawn_touched)), len(channels))
    process.force.fit(counts[drawn], data.heatmap_n.sum(axis=(1, 2))[drawn, None])
    process.place.fit(counts[drawn_touched], data.centre_mm[drawn_touched])
    grids = data.frames.grid_x_mm, data.frames.grid_y_mm
    process.low_mm.copy_(torch.tensor([grid.min() for grid in grids]))
    process.high_mm.copy_(torch.tensor([grid.max() for grid in grids]))
    return process


def chosen_kernel(
    standardised: Float[np.ndarray, "frame channel"], aim: Float[np.ndarray, "frame target"]
) -> tuple[float, float, float]:
    """Variance and length of the kernel, variance of the noise.

    Targets that are all the same tell nothing: the kernel stays as it starts.
    """
    from sklearn.exceptions import ConvergenceWarning
    from sklearn.gaussian_process import GaussianProcessRegressor
    from sklearn.gaussian_process.kernels import RBF, ConstantKernel, WhiteKernel

    kernel: Any = ConstantKernel(1.0, (1e-2, 1e4)) * RBF(
        np.sqrt(standardised.shape[1]), (1e-1, 1e3)
    ) + WhiteKernel(1e-2, _NOISES)
    if np.ptp(aim, axis=0).max() > 0:
        few = slice(FRAMES_OF_KERNEL)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", ConvergenceWarning)  # noise at its bound is an answer
            kernel = GaussianProcessRegressor(kernel).fit(standardised[few], aim[few]).kernel_
    variance, length, noise = np.exp(kernel.theta).tolist()
    return variance, length, noise

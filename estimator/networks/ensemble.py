"""Networks as a specification names them: architecture, scales and fresh weights."""

from __future__ import annotations

import numpy as np
import torch
from jaxtyping import Float
from torch import nn

from design.spec.object import TrainingSpec
from estimator.frames.face_data import HISTORY, Channel, FaceData, channel_counts
from estimator.networks.face_model import Architecture
from estimator.networks.network import HeadsNetwork, HeatmapNetwork

PAPER_HIDDEN_UNITS = (600, 2000, 2000, 2000)
RIDGE = 1e-3


def sigma_counts(data: FaceData, channels: tuple[Channel, ...]) -> Float[np.ndarray, "channel"]:
    """White noise (rms); a change is the difference of two readings."""
    return np.array(
        [
            data.frames.noise_counts[axis] * (1.0 if face < HISTORY else 2**0.5)
            for face, _, axis in channels
        ]
    )


def new_member(
    data: FaceData, channels: tuple[Channel, ...], training: TrainingSpec, seed: int
) -> nn.Module:
    """A network with fresh weights, scaled to the training frames."""
    built, grids = architecture_of(training), (data.frames.grid_x_mm, data.frames.grid_y_mm)
    scale = float(data.heatmap_n.sum(axis=(1, 2)).max())
    sigma = sigma_counts(data, channels)
    with torch.random.fork_rng(devices=[]):
        torch.manual_seed(seed)
        if built.kind == "heads":
            return HeadsNetwork(
                sigma, *grids, built.hidden_units, scale, built.axes, built.continuous
            )
        counts = channel_counts(data.frames, channels)
        low, span = counts.min(axis=0), np.ptp(counts, axis=0)
        if training.model == "linear":
            low, span = 0 * sigma, sigma
        else:
            scale = float(data.force_maps_n.max())
        smallest = float(data.heatmap_n[data.heatmap_n > 0].min())
        span = np.where(span > 0, span, 1.0)
        return HeatmapNetwork(low, span, *grids, built.hidden_units, scale, smallest, built.axes)


def fit_ridge(
    member: HeatmapNetwork, counts: Float[np.ndarray, "frame channel"], maps: np.ndarray
) -> None:
    """Ridge regression in closed form, as the weights of a network without hidden layer."""
    scaled = counts.astype(float) / member.span_counts.cpu().numpy()
    basis = np.column_stack([scaled, np.ones(len(scaled))])
    normal = basis.T @ basis
    penalty = RIDGE * np.trace(normal) / len(normal) * np.eye(len(normal))
    weights = np.linalg.solve(normal + penalty, basis.T @ maps)
    with torch.no_grad():
        member.heads.weight.copy_(torch.as_tensor(weights[:-1].T, dtype=torch.float32))
        member.heads.bias.copy_(torch.as_tensor(weights[-1], dtype=torch.float32))


def architecture_of(training: TrainingSpec) -> Architecture:
    """Architecture of `training.model`."""
    axes, members = training.heatmap_axes, training.ensemble or 1
    if training.model == "paper":
        return Architecture("heatmap", PAPER_HIDDEN_UNITS, axes, members=members)
    if training.model == "linear":
        return Architecture("heatmap", (), axes, members=members)
    continuous = training.output == "position"
    return Architecture("heads", training.hidden_units, axes, continuous, members)

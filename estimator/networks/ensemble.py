"""Networks with fresh weights, scaled to what they are trained on."""

from __future__ import annotations

import numpy as np
import torch
from jaxtyping import Float

from estimator.frames.face_data import HISTORY, Channel, FaceData
from estimator.networks.face_model import Architecture
from estimator.networks.network import HeadsNetwork


def sigma_counts(data: FaceData, channels: tuple[Channel, ...]) -> Float[np.ndarray, "channel"]:
    """White noise (rms); a change is the difference of two readings."""
    return np.array(
        [
            data.frames.noise_counts[axis] * (1.0 if face < HISTORY else 2**0.5)
            for face, _, axis in channels
        ]
    )


def new_member(
    data: FaceData, channels: tuple[Channel, ...], built: Architecture, seed: int
) -> HeadsNetwork:
    """A network with fresh weights, scaled to the training frames."""
    grids = data.frames.grid_x_mm, data.frames.grid_y_mm
    scale = float(data.heatmap_n.sum(axis=(1, 2)).max())
    with torch.random.fork_rng(devices=[]):
        torch.manual_seed(seed)
        return HeadsNetwork(
            sigma_counts(data, channels),
            *grids,
            built.hidden_units,
            scale,
            built.axes,
            built.continuous,
        )

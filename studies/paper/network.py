"""The network and the recipe of Knopke et al. (RA-L 2024), for comparison with ours.

Pixels of the heatmap directly, from min–max scaled inputs; the sum of squares over the pixels, Adam
at a constant rate. `benchmarks/estimators.py` trains it beside ours for the same time.
"""

from __future__ import annotations

import copy
import time
from itertools import pairwise

import numpy as np
import torch
from jaxtyping import Float
from torch import Tensor, nn

from estimator.field.device import one_thread
from estimator.frames.dataset import FrameSet
from estimator.frames.face_data import FaceData, channel_counts
from estimator.networks.defaults import INTERVAL_COVER
from estimator.networks.face_model import Architecture, FaceModel
from estimator.networks.intervals.held_out import Fold, assembled
from estimator.networks.network import Reading
from estimator.networks.training.data import Batch, batch_of, joined
from estimator.networks.training.face import FitSettings, common_channels, prepared
from estimator.networks.training.fitting import Progress

HIDDEN_UNITS = (600, 2000, 2000, 2000)
BATCH_FRAMES, LEARNING_RATE, WEIGHT_DECAY = 2000, 1e-3, 1e-4


class PaperNetwork(nn.Module):
    """Pixels from scaled inputs: (ΔS − offset) / span in, force over the scale out.

    `contact` is the largest pixel over the smallest contact force seen in training, at most 1; widths of
    its intervals are the same in every frame.
    """

    offset_counts: Tensor
    span_counts: Tensor
    grid_mm: Tensor
    force_scale_n: Tensor

    def __init__(self, data: FaceData, counts: Float[np.ndarray, "frame channel"]) -> None:
        super().__init__()
        frames, span = data.frames, np.ptp(counts, axis=0)
        grids = np.meshgrid(frames.grid_x_mm, frames.grid_y_mm, indexing="ij")
        self.shape = (len(frames.grid_x_mm), len(frames.grid_y_mm))
        self.smallest_contact_n = float(data.heatmap_n[data.heatmap_n > 0].min())
        for name, value in (
            ("offset_counts", counts.min(axis=0)),
            ("span_counts", np.where(span > 0, span, 1.0)),
            ("grid_mm", np.stack(grids, axis=-1).reshape(-1, 2)),
            ("force_scale_n", np.array(data.force_maps_n.max())),
        ):
            self.register_buffer(name, torch.as_tensor(value.astype(np.float32)))
        widths = (counts.shape[1], *HIDDEN_UNITS)
        hidden = [
            layer
            for wide, narrow in pairwise(widths)
            for layer in (nn.Linear(wide, narrow), nn.ReLU())
        ]
        self.layers = nn.Sequential(*hidden, nn.Linear(widths[-1], data.heatmap_n[0].size))

    def pixels_of(self, counts: Float[Tensor, "frame channel"]) -> Float[Tensor, "frame pixel"]:
        """Training's view: force at each pixel, over the scale."""
        return self.layers((counts - self.offset_counts) / self.span_counts)

    def forward(self, counts: Float[Tensor, "frame channel"]) -> Reading:
        normal = self.force_scale_n * self.pixels_of(counts)
        largest = normal.amax(dim=1)
        # the centre of what exceeds half the largest pixel: what is below is mostly noise
        weight = torch.relu(normal - 0.5 * torch.relu(largest)[:, None]) + 1e-9
        xy = (weight @ self.grid_mm) / weight.sum(dim=1, keepdim=True)
        contact = (largest / self.smallest_contact_n).clamp(0.0, 1.0)
        even = torch.ones_like(largest)
        maps = normal.unflatten(1, self.shape)[:, None]
        return Reading(maps, normal.sum(dim=1), xy, contact, even, even, 0 * even)


def pixel_loss(network: PaperNetwork, batch: Batch) -> Tensor:
    """Sum of squares over the pixels, mean over frames."""
    return ((network.pixels_of(batch.counts) - batch.maps) ** 2).sum(dim=1).mean()


@one_thread()
def fit_paper(
    train_frames: FrameSet,
    validation_frames: FrameSet,
    settings: FitSettings,
    progress: Progress | None = None,
) -> FaceModel:
    """Train the paper's network for `settings.budget_s` or `settings.training.epochs`; the weights of the
    best validation loss remain."""
    train, held_out = (
        prepared(frames, name, settings)
        for frames, name in ((train_frames, "training"), (validation_frames, "validation"))
    )
    channels = common_channels([train, held_out], settings.training)
    torch.manual_seed(settings.seed)
    member = PaperNetwork(train, channel_counts(train.frames, channels))
    scale = float(member.get_buffer("force_scale_n"))
    batches = [batch_of(part, channels, scale, 1) for part in (train, held_out)]
    _fit(member, batches[0], batches[1], settings, progress)
    folds = [Fold(member, None, None, train, held_out)]
    everything = joined(train, held_out)
    network, presses = assembled(
        folds, everything, None, None, channels, INTERVAL_COVER, settings.seed
    )
    grids = train_frames.grid_x_mm, train_frames.grid_y_mm
    built = Architecture(HIDDEN_UNITS)
    return FaceModel(
        "paper", settings.face, channels, *grids, built, 0, INTERVAL_COVER, presses, network
    )


def _fit(
    member: PaperNetwork,
    train: Batch,
    validation: Batch,
    settings: FitSettings,
    progress: Progress | None,
) -> None:
    optimizer = torch.optim.Adam(member.parameters(), LEARNING_RATE, weight_decay=WEIGHT_DECAY)
    best, least, started = copy.deepcopy(member.state_dict()), float("inf"), time.monotonic()
    for epoch in range(1, settings.training.epochs + 1):
        for rows in torch.randperm(len(train)).split(BATCH_FRAMES):
            if settings.budget_s is not None and time.monotonic() - started > settings.budget_s:
                break
            optimizer.zero_grad()
            pixel_loss(member, train.rows(rows)).backward()
            optimizer.step()
        with torch.no_grad():
            loss = float(pixel_loss(member, validation))
        if loss < least:
            best, least = copy.deepcopy(member.state_dict()), loss
        if progress is not None:
            progress(epoch, settings.training.epochs, loss)
        if settings.budget_s is not None and time.monotonic() - started > settings.budget_s:
            break
    member.load_state_dict(best)

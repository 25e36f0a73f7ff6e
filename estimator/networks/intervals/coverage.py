"""Novelty of signals: how far from signals that training covers, and how much wider intervals get there.

Novelty of a frame is the distance of arcsinh(ΔS / 3σ) to the nearest of some training frames, over
the distance below which 95 % of the frames of held-out presses lie: above 1 the frame is novel.
Intervals grow by slope · growth there. A Gaussian process answers where a frame is novel
(`gp_weight`, from 0 to 1), and this is also the growth; without one it is √(novelty − 1). The slopes
cover the errors at places left out, of the process or, without one, of trees, fitted
to the other places: whole contact cases are left out in turn, so that errors of what was never
pressed set the widths, not those of new presses of known places.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import torch
from jaxtyping import Float, Int
from torch import Tensor, nn

from estimator.frames.face_data import Channel, FaceData, channel_counts
from estimator.networks.forest import fit_forest
from estimator.networks.intervals.conformal import conformal_quantile, student_bound
from estimator.networks.process import fit_process

REFERENCE_FRAMES = 600
"""Frames of the training set that novelty is measured from."""
KNOWN_SHARE = 0.95
"""Share of held-out frames that count as known."""
SIGMA_SPAN = 3.0
"""Signal, in standard deviations, up to which it counts in proportion (beyond: its logarithm)."""
PLACE_GROUPS = 6
"""Groups of places that are left out in turn."""
PLACE_TREES = 30
"""Trees of the forest by which these places are answered."""
_PLACE_FRAMES = 2000
"""Frames of that forest, at most."""
_LEAST_GROWTH = 1e-3
"""Growth of errors with the distance, at least."""
WHOLLY_NEW_FROM = 2.0
"""Above this novelty the process alone answers. On made inner splits of a public recording held-out
presses stay below 1.5, and places left out lie between 1.7 and 3.6."""


@dataclass(frozen=True)
class Slopes:
    """Growth of intervals with `gp_weight` or √(novelty − 1): N and mm."""

    force_n: float
    place_mm: float


class Coverage(nn.Module):
    """Reference frames of the training, and the scale of their distances."""

    sigma_counts: Tensor
    reference: Tensor
    scale: Tensor
    force_slope_n: Tensor
    place_slope_mm: Tensor

    def __init__(self, channels: int, references: int) -> None:
        super().__init__()
        self.register_buffer("sigma_counts", torch.ones(channels))
        self.register_buffer("reference", torch.zeros(references, channels))
        for name in ("scale", "force_slope_n", "place_slope_mm"):
            self.register_buffer(name, torch.tensor(1.0))

    def distance(self, counts: Float[Tensor, "frame channel"]) -> Float[Tensor, "frame"]:
        """Distance to the nearest reference; in double precision, as squares cancel."""
        scaled = torch.asinh(counts / self.sigma_counts / SIGMA_SPAN).double()
        references = self.reference.double()
        square = (
            (scaled**2).sum(1, keepdim=True) + (references**2).sum(1) - 2 * scaled @ references.T
        )
        return square.amin(dim=1).clamp(min=0.0).sqrt().float()

    def forward(self, counts: Float[Tensor, "frame channel"]) -> Float[Tensor, "frame"]:
        """Novelty; above 1 is novel."""
        return self.distance(counts) / self.scale


def growth(novelty: Float[Tensor, "frame"]) -> Float[Tensor, "frame"]:
    """√(novelty − 1), 0 where nothing is novel."""
    return torch.relu(novelty - 1.0).sqrt()


def gp_weight(novelty: Float[Tensor, "frame"]) -> Float[Tensor, "frame"]:
    """Share of the process in the answer: 0 up to novelty 1, 1 from `WHOLLY_NEW_FROM` on, smooth."""
    share = ((novelty - 1.0) / (WHOLLY_NEW_FROM - 1.0)).clamp(0.0, 1.0)
    return share**2 * (3 - 2 * share)


def reference_of(
    data: FaceData,
    channels: tuple[Channel, ...],
    sigma_counts: Float[np.ndarray, "channel"],
    seed: int,
) -> Coverage:
    """Coverage by the given frames, with distances and slopes of 1."""
    chosen = np.random.default_rng(seed).permutation(len(data))[:REFERENCE_FRAMES]
    counts = channel_counts(data.select(np.sort(chosen)).frames, channels)
    coverage = Coverage(len(channels), len(chosen))
    coverage.sigma_counts.copy_(torch.as_tensor(sigma_counts))
    coverage.reference.copy_(torch.as_tensor(np.arcsinh(counts / sigma_counts / SIGMA_SPAN)))
    return coverage


def known_distance(
    distance: Float[np.ndarray, "frame"], press_id: Int[np.ndarray, "frame"]
) -> float:
    """Distance below which `KNOWN_SHARE` of the frames of held-out presses lie, presses alike."""
    return conformal_quantile(distance, press_id, KNOWN_SHARE, pooled_folds=True)


def slopes_at_places_left_out(
    data: FaceData,
    channels: tuple[Channel, ...],
    sigma_counts: Float[np.ndarray, "channel"],
    scale: float,
    cover: float,
    seed: int,
    of_process: bool = False,
) -> Slopes:
    """Slopes that cover the errors of trees, or of a process, at contact cases that they did not
    learn.

    A process errs at a new place by much the same in all frames, so that its errors are those of
    cases. With fewer of them than the level needs (nine at 90 %) even the largest error, which
    `conformal_quantile` then takes, covers too little of a case to come: the force's slope is no less
    than `student_bound`, but no more by this than the largest force, and as the place may be
    anywhere on the grid, its slope is no less than the radius about what was answered that holds so
    much of the grid. With a single contact case none can be left out: a place may then be anywhere,
    and a force anything up to the largest.
    """
    rng = np.random.default_rng(seed)
    if len(data) > _PLACE_FRAMES:
        data = data.select(np.sort(rng.permutation(len(data))[:_PLACE_FRAMES]))
    cases = rng.permutation(np.unique(data.frames.place_id[data.contact]))
    largest_n = float(data.heatmap_n.sum(axis=(1, 2)).max())
    if len(cases) < 2:
        return Slopes(largest_n, radius_of_grid(data, data.centre_mm[data.contact], cover))
    parts = []
    for some in np.array_split(cases, min(PLACE_GROUPS, len(cases))):
        left_out = np.isin(data.frames.place_id, some) & data.contact
        learned, novel = data.select(~left_out), data.select(left_out)
        parts.append(_missed(learned, novel, channels, sigma_counts, scale, seed, of_process))
    case, missed, away, said_mm = (np.concatenate(column) for column in zip(*parts, strict=True))
    force, place = (
        conformal_quantile(score, case, cover, pooled_folds=not of_process)
        for score in (missed, away)
    )
    if not of_process or cover * (len(cases) + 1) <= len(cases):
        return Slopes(force, place)
    force = max(force, min(student_bound(missed, case, cover), largest_n))
    return Slopes(force, max(place, radius_of_grid(data, said_mm, cover)))


def _missed(
    learned: FaceData,
    novel: FaceData,
    channels: tuple[Channel, ...],
    sigma_counts: Float[np.ndarray, "channel"],
    scale: float,
    seed: int,
    of_process: bool,
) -> tuple[np.ndarray, ...]:
    """For frames at cases that were not learned, return the case, errors of force (N) and place (mm) over the
    growth there, and the place that was answered."""
    counts = torch.as_tensor(channel_counts(novel.frames, channels).astype(np.float32))
    with torch.inference_mode():
        if of_process:
            grown = np.ones(len(novel))
            answer = fit_process(learned, channels, seed)(counts)
        else:
            distance = reference_of(learned, channels, sigma_counts, 0).distance(counts)
            grown = growth(distance.double() / scale).clamp(min=_LEAST_GROWTH).numpy()
            answer = fit_forest(learned, channels, PLACE_TREES, seed=0)(counts)
    force_n, xy_mm = (column.double().numpy() for column in answer)
    missed_n = np.abs(force_n - novel.heatmap_n.sum(axis=(1, 2)))
    away_mm = np.linalg.norm(xy_mm - novel.centre_mm, axis=1)
    return novel.frames.place_id, missed_n / grown, away_mm / grown, xy_mm


def radius_of_grid(data: FaceData, said_mm: Float[np.ndarray, "frame 2"], cover: float) -> float:
    """Radius about the answers that holds the given share of the contact grid, mm."""
    grids = np.meshgrid(data.frames.grid_x_mm, data.frames.grid_y_mm, indexing="ij")
    away_mm = np.hypot(*(grid.ravel() - said_mm[:, [k]] for k, grid in enumerate(grids)))
    return float(np.quantile(away_mm, cover))

"""Folds put together into one estimator: weights of trees, widths and novelty, from held-out presses."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import product

import numpy as np
import torch
from jaxtyping import Float
from torch import nn

from estimator.frames.face_data import Channel, FaceData, channel_counts
from estimator.metrics.heatmaps import face_metrics, force_reference
from estimator.networks.ensemble import sigma_counts
from estimator.networks.face_model import read_counts
from estimator.networks.forest import Forest
from estimator.networks.intervals.conformal import conformal_quantile
from estimator.networks.intervals.coverage import (
    gp_weight,
    growth,
    known_distance,
    reference_of,
    slopes_at_places_left_out,
)
from estimator.networks.network import (
    DOUBT_POWER,
    ContactEstimator,
    HeadsNetwork,
    heatmap_centre_mm,
)
from estimator.networks.prediction import Prediction
from estimator.networks.process import Process

SHARPNESS = (1.0, 2.0, 4.0, 8.0, 16.0)
"""Powers of the shares of force that are compared."""
FAINT = (0.05, 0.2, 0.4)
"""Shares below which force is left out, that are compared."""
STEPS_OF_SHARES = 4
"""Shares are multiples of one over this."""

LEAST_RADIUS_PITCHES = 0.1
"""Least median radius, in pitches of the grid. Where training knows few places, most answers are
one of them to a micrometre, and the quantile of errors is next to nothing."""
_LEAST_SPREAD = 1e-9
"""Spread that stands for 0 where it divides."""


@dataclass(frozen=True)
class Fold:
    """A network, its trees and process, what they were fitted to, and presses that they never saw."""

    member: nn.Module
    forest: Forest | None
    process: Process | None
    fitted: FaceData
    held_out: FaceData


@dataclass(frozen=True)
class HeldOutFrames:
    """Answers in held-out contact frames, forces in N and places in mm; NaN of trees and process where there
    are none."""

    press_id: np.ndarray
    true_n: np.ndarray
    true_mm: np.ndarray
    network_n: np.ndarray
    network_mm: np.ndarray
    heatmap_mm: np.ndarray
    trees_n: np.ndarray
    trees_mm: np.ndarray
    process_n: np.ndarray
    process_mm: np.ndarray
    spread_n: np.ndarray
    spread_mm: np.ndarray
    distance: np.ndarray


def assembled(
    folds: list[Fold],
    everything: FaceData,
    forest: Forest | None,
    process: Process | None,
    channels: tuple[Channel, ...],
    cover: float,
    seed: int,
) -> tuple[ContactEstimator, int]:
    """The estimator of all folds, and how many presses calibrated it.

    `everything` is all that was shown: the novelty of a frame is judged from it, and `forest` and
    `process` were fitted to it.
    """
    sigma = sigma_counts(everything, channels)
    fold_answers = [held_out_answers(fold, channels, sigma, seed) for fold in folds]
    held_out = HeldOutFrames(
        **{
            name: np.concatenate([getattr(answers, name) for answers in fold_answers])
            for name in HeldOutFrames.__dataclass_fields__
        }
    )
    coverage = reference_of(everything, channels, sigma, seed)
    scale = known_distance(held_out.distance, held_out.press_id)
    slopes = slopes_at_places_left_out(
        everything, channels, sigma, scale, cover, seed, process is not None
    )
    coverage.scale.fill_(scale)
    coverage.force_slope_n.fill_(slopes.force_n)
    coverage.place_slope_mm.fill_(slopes.place_mm)
    network = ContactEstimator([fold.member for fold in folds], coverage, forest, process)
    novelty = torch.as_tensor(held_out.distance / scale)
    new = np.zeros(len(novelty)) if process is None else gp_weight(novelty).numpy()
    grown = growth(novelty).numpy() if process is None else new
    errors = blended_errors(network, held_out, new)
    widths = slopes.force_n * grown, slopes.place_mm * grown
    spreads = held_out.spread_n, held_out.spread_mm
    quantiles = network.force_quantile, network.position_quantile
    for quantile, error, width, spread in zip(quantiles, errors, widths, spreads, strict=True):
        score = np.maximum(error - width, 0.0) / np.maximum((1 - new) * spread, _LEAST_SPREAD)
        quantile.fill_(conformal_quantile(score, held_out.press_id, cover, len(folds) > 1))
    least_mm = LEAST_RADIUS_PITCHES * pitch_mm(everything)
    network.position_quantile.clamp_(min=least_mm / float(np.median(held_out.spread_mm)))
    return network, len(np.unique(held_out.press_id))


def sharpened(
    member: HeadsNetwork, held_out: FaceData, channels: tuple[Channel, ...]
) -> HeadsNetwork:
    """The member with the sharpness and the limit of faint shares that do best on held-out contacts:
    dissimilarity plus relative error of force."""
    if member.continuous:
        return member
    data = held_out.select(held_out.contact)
    reference = force_reference(data.heatmap_n)
    counts, scale = channel_counts(data.frames, channels), float(member.force_scale_n)
    costs = {}
    for sharpness, faint in product(SHARPNESS, FAINT):
        member.sharpness.fill_(sharpness)
        member.faint.fill_(faint)
        maps = read_counts(member, counts).heatmap_n[:, -1]
        result = face_metrics(data.face, maps, data.heatmap_n, reference)
        costs[sharpness, faint] = 1 - result.similarity + result.force_error_n / scale
    sharpness, faint = min(costs, key=lambda choice: costs[choice])
    member.sharpness.fill_(sharpness)
    member.faint.fill_(faint)
    return member


def held_out_answers(
    fold: Fold, channels: tuple[Channel, ...], sigma: Float[np.ndarray, "channel"], seed: int
) -> HeldOutFrames:
    data = fold.held_out.select(fold.held_out.contact)
    counts = channel_counts(data.frames, channels)
    network = read_counts(fold.member, counts)
    count_tensor = torch.as_tensor(counts.astype(np.float32))
    nothing = np.full(len(data), np.nan), np.full((len(data), 2), np.nan)
    (trees_n, trees_mm), (process_n, process_mm) = nothing, nothing
    with torch.inference_mode():
        distance = reference_of(fold.fitted, channels, sigma, seed).distance(count_tensor)
        if fold.forest is not None:
            trees_n, trees_mm = (column.double().numpy() for column in fold.forest(count_tensor))
        if fold.process is not None:
            process_n, process_mm = (
                column.double().numpy() for column in fold.process(count_tensor)
            )
    return HeldOutFrames(
        press_id=data.frames.press_id,
        true_n=data.heatmap_n.sum(axis=(1, 2)),
        true_mm=data.centre_mm,
        network_n=network.force_n,
        network_mm=network.xy_mm,
        heatmap_mm=_centre_mm(network, data),
        trees_n=trees_n * network.contact**DOUBT_POWER,
        trees_mm=trees_mm,
        process_n=process_n,
        process_mm=process_mm,
        spread_n=network.force_halfwidth_n,
        spread_mm=network.position_radius_mm,
        distance=distance.double().numpy(),
    )


def pitch_mm(data: FaceData) -> float:
    steps = np.concatenate([np.diff(data.frames.grid_x_mm), np.diff(data.frames.grid_y_mm)])
    return float(steps.min()) if len(steps) else 1.0


def _centre_mm(prediction: Prediction, data: FaceData) -> Float[np.ndarray, "frame 2"]:
    grids = np.meshgrid(data.frames.grid_x_mm, data.frames.grid_y_mm, indexing="ij")
    grid_mm = torch.as_tensor(np.stack(grids, axis=-1).reshape(-1, 2))
    return heatmap_centre_mm(torch.as_tensor(prediction.heatmap_n[:, -1]), grid_mm).numpy()


def blended_errors(
    network: ContactEstimator, held_out: HeldOutFrames, new: Float[np.ndarray, "frame"]
) -> tuple[Float[np.ndarray, "frame"], Float[np.ndarray, "frame"]]:
    """Errors (N, mm) with the shares that err least, which the network gets.

    `new` is the share of the process.
    """
    forces_n, places_mm = [held_out.network_n], [held_out.network_mm, held_out.heatmap_mm]
    if network.forest is not None:
        forces_n.append(held_out.trees_n)
        places_mm.append(held_out.trees_mm)
    there_n = np.where(new > 0, new * held_out.process_n, 0.0)
    there_mm = np.where(new[:, None] > 0, new[:, None] * held_out.process_mm, 0.0)
    shares, missed_n = least_cost(
        forces_n, lambda blended: np.abs((1 - new) * blended + there_n - held_out.true_n)
    )
    network.force_share.fill_(shares[1] if len(shares) > 1 else 0.0)
    shares, away_mm = least_cost(
        places_mm,
        lambda blended: np.linalg.norm(
            (1 - new)[:, None] * blended + there_mm - held_out.true_mm, axis=1
        ),
    )
    network.place_shares[: len(shares)] = torch.tensor(shares)
    return missed_n, away_mm


def least_cost(
    answers: list[np.ndarray], error_of: Callable[[np.ndarray], np.ndarray]
) -> tuple[tuple[float, ...], np.ndarray]:
    """Shares, adding up to 1, with the least mean error, and its errors."""
    steps = product(range(STEPS_OF_SHARES + 1), repeat=len(answers))
    best: tuple[tuple[float, ...], np.ndarray] | None = None
    for parts in steps:
        if sum(parts) != STEPS_OF_SHARES:
            continue
        shares = tuple(part / STEPS_OF_SHARES for part in parts)
        blended = [share * answer for share, answer in zip(shares, answers, strict=True)]
        error = error_of(np.sum(blended, axis=0))
        if best is None or error.mean() < best[1].mean():
            best = shares, error
    assert best is not None
    return best

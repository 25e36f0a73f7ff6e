"""Training of a face's contact estimator on whole presses, stopped by presses that it never saw.

The loss adds the cross-entropy of the shares of force, the absolute error of the total force
(zero without contact) and the cross-entropy of contact. Training frames get fresh noise and
zeroing offsets in every epoch, so that the network leans neither on the noise nor on the rest
level of a press.
"""

from __future__ import annotations

import copy
import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import torch
from jaxtyping import Float
from torch import Tensor

from design.errors import InputError
from design.spec import TrainingSpec
from estimator.dataset import FrameSet
from estimator.face_data import FaceData, face_data, live_channels
from estimator.metrics import face_metrics, force_reference
from estimator.network import (
    ContactNetwork,
    Estimate,
    FaceModel,
    channel_counts,
    predict_heatmaps,
    save_model,
    scaled_signals,
)
from estimator.splits import Split, split_presses

Progress = Callable[[int, int, float], None]
"""Called after each epoch with its number, the number of epochs and the validation loss."""
NEGATIVES_PER_CONTACT = 0.3
"""At most so many rest frames, and as many with other faces pressed, per contact frame."""
SHARPNESS = (1.0, 1.5, 2.0, 3.0, 5.0, 8.0)
_FORCE_WEIGHT = 8.0
_WEIGHT_DECAY = 1e-3
_WARM_UP_EPOCHS = 2.0
_LEAST_STEPS = 20
_LEAST_BATCH_FRAMES = 16


@dataclass(frozen=True)
class Augmentation:
    """Disturbances added to each training frame: offset of a press's zero (counts, one draw a
    channel) and white noise (in units of the channel's own σ)."""

    offset_counts: float
    noise_sigmas: float = 1.0


AUGMENTATION = {"simulated": Augmentation(10.0), "recorded": Augmentation(25.0)}
"""By source of the data: real silicone creeps back late, so its rest level is less certain."""


@dataclass(frozen=True)
class _Tensors:
    counts: Float[Tensor, "frame channel"]
    share: Float[Tensor, "frame pixel"]
    force: Float[Tensor, "frame"]
    contact: Float[Tensor, "frame"]

    def rows(self, index: Tensor) -> _Tensors:
        return _Tensors(
            self.counts[index], self.share[index], self.force[index], self.contact[index]
        )


def train_face(
    frames: FrameSet,
    face: int,
    training: TrainingSpec,
    seed: int,
    progress: Progress | None = None,
    checkpoint: Path | str | None = None,
    split: Split | None = None,
    augmentation: Augmentation | None = None,
    device: str = "cpu",
) -> FaceModel:
    """Train one face's estimator.

    Parameters
    ----------
    frames : data set with presses on the face
    seed : of the split, the initial weights, the batches and the disturbances
    progress : called after each epoch
    checkpoint : where the finished model is saved, if given
    split : by default `split_presses(frames, seed)`; only training and validation are used
    augmentation : by default that of the data's source, `AUGMENTATION`

    Raises
    ------
    InputError
        No contact on the face in the training or validation part, or no live channel.
    """
    split = split or split_presses(frames, seed)
    train, validation = (
        _thinned(_with_contacts(face_data(frames.select(part), face), name), seed)
        for part, name in ((split.train, "training"), (split.validation, "validation"))
    )
    model = _untrained(frames, face, training, train, validation, seed)
    network = model.network.to(device)
    sigma = torch.as_tensor(model.sigma_counts, dtype=torch.float32, device=device)
    tensors = [_tensors(model, data, device) for data in (train, validation)]
    _fit(
        network,
        sigma,
        tensors[0],
        tensors[1],
        training,
        augmentation or AUGMENTATION[frames.source],
        seed,
        progress,
    )
    model = _sharpened(model, validation)
    if checkpoint is not None:
        save_model(model, checkpoint)
    return model


def _with_contacts(data: FaceData, part: str) -> FaceData:
    if not data.contact.any():
        raise InputError(
            f"face {data.face} has no contact in the {part} part. Press it in more presses, or "
            "train only the faces that are pressed"
        )
    return data


def _thinned(data: FaceData, seed: int) -> FaceData:
    """All contact frames, with rest frames and other faces' presses limited in number."""
    rng = np.random.default_rng(seed)
    contact = data.contact
    limit = math.ceil(NEGATIVES_PER_CONTACT * contact.sum())
    kept = [np.flatnonzero(contact)]
    for negatives in (np.flatnonzero(data.rest & ~contact), np.flatnonzero(~data.rest & ~contact)):
        kept.append(rng.permutation(negatives)[:limit])
    index = np.sort(np.concatenate(kept))
    return FaceData(data.face, data.signal_counts[index], data.heatmap_n[index], data.rest[index])


def _untrained(
    frames: FrameSet,
    face: int,
    training: TrainingSpec,
    train: FaceData,
    validation: FaceData,
    seed: int,
) -> FaceModel:
    alive = set(live_channels(validation))
    channels = tuple(channel for channel in live_channels(train) if channel in alive)
    if not channels:
        raise InputError(
            f"no channel of face {face} has readings in all frames. Leave that recording out"
        )
    pixels = len(frames.grid_x_mm) * len(frames.grid_y_mm)
    with torch.random.fork_rng(devices=[]):
        torch.manual_seed(seed)
        network = ContactNetwork(len(channels), training.hidden_units, pixels)
    return FaceModel(
        face=face,
        channels=channels,
        sigma_counts=np.array([frames.noise_counts[axis] for _, axis in channels]),
        grid_x_mm=frames.grid_x_mm,
        grid_y_mm=frames.grid_y_mm,
        hidden_units=training.hidden_units,
        force_scale_n=float(train.heatmap_n.sum(axis=(1, 2)).max()),
        sharpness=1.0,
        network=network,
    )


def _tensors(model: FaceModel, data: FaceData, device: str) -> _Tensors:
    heatmap = data.heatmap_n.reshape(len(data), -1)
    total = heatmap.sum(axis=1)
    arrays = (
        channel_counts(data.signal_counts, model.channels),
        heatmap / np.where(total > 0, total, 1.0)[:, None],
        total / model.force_scale_n,
        data.contact,
    )
    tensors = [torch.as_tensor(a.astype(np.float32), device=device) for a in arrays]
    return _Tensors(*tensors)


def _fit(
    network: ContactNetwork,
    sigma: Tensor,
    train: _Tensors,
    validation: _Tensors,
    training: TrainingSpec,
    augmentation: Augmentation,
    seed: int,
    progress: Progress | None,
) -> None:
    """Train in place; the weights of the best validation loss remain."""
    generator = torch.Generator().manual_seed(seed)
    optimizer = torch.optim.AdamW(
        network.parameters(), lr=training.learning_rate, weight_decay=_WEIGHT_DECAY
    )
    size = _batch_frames(len(train.force), training.batch_size)
    steps = math.ceil(len(train.force) / size)
    schedule = torch.optim.lr_scheduler.LambdaLR(
        optimizer, lambda step: _rate_factor(step / steps, training.epochs)
    )
    held_out = scaled_signals(validation.counts, sigma)
    best, best_epoch, best_weights = math.inf, 0, copy.deepcopy(network.state_dict())
    for epoch in range(1, training.epochs + 1):
        network.train()
        disturbed = scaled_signals(_disturbed(train.counts, sigma, augmentation, generator), sigma)
        order = torch.randperm(len(train.force), generator=generator)
        for batch in order.split(size):
            optimizer.zero_grad(set_to_none=True)
            _loss(network(disturbed[batch]), train.rows(batch)).backward()
            optimizer.step()
            schedule.step()
        network.eval()
        with torch.no_grad():
            score = float(_loss(network(held_out), validation))
        if score < best:
            best, best_epoch, best_weights = score, epoch, copy.deepcopy(network.state_dict())
        if progress is not None:
            progress(epoch, training.epochs, score)
        if epoch - best_epoch >= training.patience_epochs:
            break
    network.load_state_dict(best_weights)


def _batch_frames(frames: int, wanted: int) -> int:
    """Smaller batches for small data sets, which otherwise get too few steps an epoch."""
    return max(1, min(wanted, max(_LEAST_BATCH_FRAMES, frames // _LEAST_STEPS)))


def _rate_factor(epoch: float, epochs: int) -> float:
    """Linear warm-up, then half a cosine down to 1 %."""
    warm = min(_WARM_UP_EPOCHS, epochs / 2)
    if epoch < warm:
        return max(epoch / warm, 0.02)
    return 0.01 + 0.99 * 0.5 * (1 + math.cos(math.pi * (epoch - warm) / (epochs - warm)))


def _disturbed(
    counts: Tensor, sigma: Tensor, augmentation: Augmentation, generator: torch.Generator
) -> Tensor:
    noise = torch.randn(counts.shape, generator=generator).to(counts.device)
    offset = torch.randn(counts.shape, generator=generator).to(counts.device)
    return counts + augmentation.noise_sigmas * sigma * noise + augmentation.offset_counts * offset


def _loss(estimate: Estimate, target: _Tensors) -> Tensor:
    """Place is weighted by √force: a faint press says little about where it is."""
    log_share = torch.log_softmax(estimate.share_logits, dim=1)
    weight = torch.sqrt(target.force)
    place = -(weight * (target.share * log_share).sum(dim=1)).mean()
    contact = target.contact
    force = (estimate.force - target.force).abs().mean()
    touch = torch.nn.functional.binary_cross_entropy_with_logits(estimate.contact_logit, contact)
    return place + _FORCE_WEIGHT * force + touch


def _sharpened(model: FaceModel, validation: FaceData) -> FaceModel:
    """The model with the sharpness that does best on validation contacts: dissimilarity plus
    relative error of force."""
    contact = validation.contact
    true_n = validation.heatmap_n[contact]
    reference = force_reference(true_n)
    scores = []
    for sharpness in SHARPNESS:
        candidate = replace(model, sharpness=sharpness)
        predicted = predict_heatmaps(candidate, validation.signal_counts[contact])
        result = face_metrics(model.face, predicted, true_n, reference)
        scores.append(1 - result.similarity + result.force_error_n / model.force_scale_n)
    return replace(model, sharpness=SHARPNESS[int(np.argmin(scores))])

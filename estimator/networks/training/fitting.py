"""Fitting of one network: early stopping, resumption from a file, a limit of time.

What an epoch draws is fixed by seed and epoch, so that a fit resumed from its file ends with the
weights of one that was never interrupted.
"""

from __future__ import annotations

import copy
import math
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import torch
from torch import Tensor

from design.errors import InputError
from estimator.networks.network import HeadsNetwork
from estimator.networks.tensor_file import load_tensors, save_tensors
from estimator.networks.training.data import Augmentation, Batch, Disturbances, disturbed
from estimator.networks.training.losses import heads_loss

Progress = Callable[[int, int, float], None]
"""Called after each epoch with its number, the number of epochs and the validation loss."""
_WARM_UP_EPOCHS = 2.0
"""Epochs in which the learning rate rises, at most half of all."""
_LEAST_STEPS = 20
"""Steps of an epoch that batches leave; small data sets get smaller batches for it."""
_LEAST_BATCH_FRAMES = 16
"""Frames of a batch, at least."""
SAVE_EVERY_S = 5.0
"""Time between two checkpoints, at least."""


@dataclass(frozen=True)
class Schedule:
    """Settings by which a network is fitted.

    Attributes
    ----------
    patience_epochs : it stops after this number of epochs without a better validation loss
    augmentation : None leaves frames as they are
    budget_s : it stops after so long, with the decay fitted to it; results then depend on the
        machine
    """

    epochs: int
    batch_frames: int
    learning_rate: float
    weight_decay: float
    patience_epochs: int
    augmentation: Augmentation | None
    seed: int
    budget_s: float | None = None


@dataclass
class _State:
    """State of a fit after `epoch` epochs."""

    epoch: int = 0
    best_epoch: int = 0
    best_loss: float = math.inf
    best: dict[str, Tensor] = field(default_factory=dict)


def fit(
    network: HeadsNetwork,
    train: Batch,
    validation: Batch,
    disturbances: Disturbances,
    schedule: Schedule,
    progress: Progress | None = None,
    checkpoint: Path | None = None,
    fingerprint: str = "",
) -> None:
    """Fit in place; the weights of the best validation loss remain.

    `checkpoint` is resumed from where it exists and kept up to date meanwhile.

    Raises
    ------
    InputError
        The checkpoint belongs to another training (its `fingerprint` differs).
    """
    optimizer = torch.optim.AdamW(
        network.parameters(), lr=schedule.learning_rate, weight_decay=schedule.weight_decay
    )
    state = _State(best=copy.deepcopy(network.state_dict()))
    if checkpoint is not None and checkpoint.is_file():
        state = _resume(checkpoint, network, optimizer, fingerprint)
    started, saved = time.monotonic(), time.monotonic()
    while state.epoch < schedule.epochs and not is_stopped(state, schedule, started):
        state.epoch += 1
        one_epoch(network, optimizer, train, disturbances, schedule, state, started)
        score = _loss_on(network, validation)
        if score < state.best_loss:
            state.best_loss, state.best_epoch = score, state.epoch
            state.best = copy.deepcopy(network.state_dict())
        if progress is not None:
            progress(state.epoch, schedule.epochs, score)
        if checkpoint is not None and time.monotonic() - saved > SAVE_EVERY_S:
            _save(checkpoint, network, optimizer, state, fingerprint)
            saved = time.monotonic()
    if checkpoint is not None:
        _save(checkpoint, network, optimizer, state, fingerprint)
    network.load_state_dict(state.best)


def is_stopped(state: _State, schedule: Schedule, started: float) -> bool:
    late = schedule.budget_s is not None and time.monotonic() - started >= schedule.budget_s
    return late or state.epoch - state.best_epoch >= schedule.patience_epochs


def one_epoch(
    network: HeadsNetwork,
    optimizer: torch.optim.Optimizer,
    train: Batch,
    disturbances: Disturbances,
    schedule: Schedule,
    state: _State,
    started: float,
) -> None:
    generator = torch.Generator().manual_seed(1_000_003 * schedule.seed + state.epoch)
    counts = train.counts
    if schedule.augmentation is not None:
        counts = disturbed(counts, disturbances, schedule.augmentation, generator)
    size = frames_of_batch(len(train), schedule.batch_frames)
    batches = torch.randperm(len(train), generator=generator).to(counts.device).split(size)
    network.train()
    for number, batch in enumerate(batches):
        done = state.epoch - 1 + number / len(batches)
        if schedule.budget_s is not None:
            if time.monotonic() - started >= schedule.budget_s:
                break
            spent = (time.monotonic() - started) / schedule.budget_s
            done = max(done, spent * schedule.epochs)
        for group in optimizer.param_groups:
            group["lr"] = schedule.learning_rate * rate_factor(done, schedule)
        optimizer.zero_grad(set_to_none=True)
        heads_loss(network, counts[batch], train.rows(batch)).backward()
        optimizer.step()


def _loss_on(network: HeadsNetwork, validation: Batch) -> float:
    network.eval()
    with torch.no_grad():
        return float(heads_loss(network, validation.counts, validation))


def frames_of_batch(frames: int, wanted: int) -> int:
    """Smaller batches for small data sets, which otherwise get too few steps an epoch."""
    return max(1, min(wanted, max(_LEAST_BATCH_FRAMES, frames // _LEAST_STEPS)))


def rate_factor(epoch: float, schedule: Schedule) -> float:
    """Linear warm-up, then half a cosine down to 1 %."""
    warm = min(_WARM_UP_EPOCHS, schedule.epochs / 2)
    if epoch < warm:
        return max(epoch / warm, 0.02)
    return 0.01 + 0.99 * 0.5 * (1 + math.cos(math.pi * (epoch - warm) / (schedule.epochs - warm)))


def _save(
    path: Path, network: HeadsNetwork, optimizer: torch.optim.Optimizer, state: _State, mark: str
) -> None:
    tensors = {f"now.{name}": value for name, value in network.state_dict().items()}
    tensors |= {f"best.{name}": value for name, value in state.best.items()}
    for index, moments in optimizer.state_dict()["state"].items():
        tensors |= {f"adam.{index}.{name}": value for name, value in moments.items()}
    info = {
        "fingerprint": mark,
        "epoch": state.epoch,
        "best_epoch": state.best_epoch,
        "best_loss": state.best_loss,
    }
    save_tensors(tensors, info, path)


def _resume(
    path: Path, network: HeadsNetwork, optimizer: torch.optim.Optimizer, mark: str
) -> _State:
    info, tensors = load_tensors(path, "Delete it: it belongs to an interrupted training")
    if info.get("fingerprint") != mark:
        raise InputError(
            f"{path} belongs to a training on other data or settings. Delete it, or resume with "
            "those of the interrupted run"
        )
    network.load_state_dict(_below("now.", tensors))
    moments: dict[int, dict[str, Any]] = {}
    for name, value in _below("adam.", tensors).items():
        index, _, key = name.partition(".")
        moments.setdefault(int(index), {})[key] = value
    optimizer.load_state_dict(
        {"state": moments, "param_groups": optimizer.state_dict()["param_groups"]}
    )
    best = _below("best.", tensors)
    return _State(info["epoch"], info["best_epoch"], info["best_loss"], best)


def _below(prefix: str, tensors: dict[str, Tensor]) -> dict[str, Tensor]:
    return {
        name.removeprefix(prefix): value
        for name, value in tensors.items()
        if name.startswith(prefix)
    }

"""Training of a face's contact estimator, stopped and calibrated by presses that it never saw.

Training frames get fresh noise and zeroing offsets in every epoch, so that the network leans
neither on the noise nor on the rest level of a press. With several members, training and
validation presses are pooled into as many folds; each member is stopped by its own fold and
calibrated there, and the estimator is their mean.
"""

from __future__ import annotations

import hashlib
from dataclasses import asdict, dataclass, field, replace
from functools import partial
from pathlib import Path

import numpy as np
import torch
from jaxtyping import Float

from design.errors import InputError
from design.spec.object import TrainingSpec
from estimator.field.device import compute_device, one_thread
from estimator.frames.dataset import FrameSet
from estimator.frames.face_data import (
    HISTORY,
    Channel,
    FaceData,
    face_data,
    live_channels,
    with_history,
)
from estimator.frames.press_protocol import with_nuisances
from estimator.networks.defaults import (
    BATCH_FRAMES,
    INTERVAL_COVER,
    LEARNING_RATE,
    PATIENCE_EPOCHS,
    filled_for,
)
from estimator.networks.ensemble import new_member, sigma_counts
from estimator.networks.face_model import Architecture, FaceModel
from estimator.networks.forest import fit_forest
from estimator.networks.intervals.held_out import Fold, assembled, sharpened
from estimator.networks.network import ContactEstimator, HeadsNetwork
from estimator.networks.process import fit_process
from estimator.networks.training.data import (
    AUGMENTATION,
    Augmentation,
    Disturbances,
    batch_of,
    elsewhere_counts,
    joined,
    nuisance_rows,
    press_folds,
    thinned,
    with_contacts,
)
from estimator.networks.training.fitting import Progress, Schedule, fit

_WEIGHT_DECAY = 1e-3
"""Weight decay of AdamW (Loshchilov and Hutter, 2019)."""
_OTHER_FACES = 0.5
"""Share of frames to which presses of other faces are added."""
_NEXT_SEED = 7919
"""Difference of the seeds of an ensemble's members."""


@dataclass(frozen=True)
class FitSettings:
    """Settings of what is fitted, and how.

    Attributes
    ----------
    seed : of the initial weights, the batches, the disturbances and the folds
    augmentation : by default that of the data's source, `AUGMENTATION`, with presses of other
        faces superposed for the whole-object model
    device : where the network is trained; by default what `INSTOBJ_DEVICE` names
    budget_s : limit of time over all members, s
    continuous : the output is the position of one contact, also where training has no presses; otherwise
        a heatmap of any number of contacts
    axes : of the heatmap: 1 for the normal force, 3 for Fx, Fy, Fz
    patience_epochs : a member stops after this number of epochs without a better validation loss
    checkpoint : folder that keeps an unfinished training; it is resumed from there
    nuisances : what a standard deviation of each change since the zero adds (counts), on the faces of
        the data; drawn in training, and in the presses that stop and calibrate it. None: an object
        that stands still
    """

    face: int
    training: TrainingSpec = field(default_factory=TrainingSpec)
    seed: int = 1
    augmentation: Augmentation | None = None
    device: str = field(default_factory=lambda: str(compute_device()))
    budget_s: float | None = None
    checkpoint: Path | None = None
    continuous: bool = False
    axes: int = 1
    patience_epochs: int = PATIENCE_EPOCHS
    nuisances: Float[np.ndarray, "face sensor 3 k"] | None = None

    @property
    def architecture(self) -> Architecture:
        """Architecture of a fresh estimator."""
        members = self.training.ensemble or 1
        return Architecture(self.training.hidden_units, self.axes, self.continuous, members)


@one_thread()
def fit_estimator(
    train_frames: FrameSet,
    validation_frames: FrameSet,
    settings: FitSettings,
    progress: Progress | None = None,
) -> FaceModel:
    """Train one face's estimator.

    Parameters
    ----------
    train_frames, validation_frames : whole presses, with ids unique over both
    progress : called after each epoch; those of an ensemble's members count on

    Raises
    ------
    InputError
        No contact on the face in either part, or no live channel.
    """
    shown = train_frames, validation_frames
    settings = replace(settings, training=filled_for(settings.training, shown, settings.face))
    training, seed = settings.training, settings.seed
    parts = [
        prepared(frames, name, settings)
        for frames, name in ((train_frames, "training"), (validation_frames, "validation"))
    ]
    channels = common_channels(parts, training)
    folds, all_folds = [], folds_of(parts, settings)
    for number, (fitted, held_out) in enumerate(all_folds):
        if settings.nuisances is not None:
            turned = with_nuisances(held_out.frames, settings.nuisances, seed)
            held_out = replace(held_out, frames=turned)
        counted = None if progress is None else partial(_counted, progress, number, len(all_folds))
        member = new_member(fitted, channels, settings.architecture, seed + _NEXT_SEED * number)
        _fit_member(member, number, fitted, held_out, channels, settings, counted)
        trees = training.trees or 0
        forest = fit_forest(fitted, channels, trees, seed + number) if trees else None
        process = fit_process(fitted, channels, seed) if training.process else None
        folds.append(Fold(sharpened(member, held_out, channels), forest, process, fitted, held_out))
    everything, trees = joined(*parts), training.trees or 0
    network, presses = assembled(
        [replace(fold, member=fold.member.cpu()) for fold in folds],
        everything,
        fit_forest(everything, channels, len(folds) * trees, seed) if trees else None,
        fit_process(everything, channels, seed) if training.process else None,
        channels,
        INTERVAL_COVER,
        seed,
    )
    return _described(network, presses, channels, settings, train_frames)


def _counted(
    progress: Progress, member: int, members: int, epoch: int, epochs: int, loss: float
) -> None:
    progress(member * epochs + epoch, members * epochs, loss)


def _described(
    network: ContactEstimator,
    presses: int,
    channels: tuple[Channel, ...],
    settings: FitSettings,
    frames: FrameSet,
) -> FaceModel:
    """The network with all that is needed to use it."""
    training = settings.training
    architecture = replace(
        settings.architecture,
        forest=None if network.forest is None else network.forest.shape,
        process=None if network.process is None else network.process.shape,
        references=len(network.coverage.reference),
    )
    return FaceModel(
        name="whole-object" if training.model == "whole-object" else "compact",
        face=settings.face,
        channels=channels,
        grid_x_mm=frames.grid_x_mm,
        grid_y_mm=frames.grid_y_mm,
        architecture=architecture,
        history_frames=training.history_frames or 0,
        interval_cover=INTERVAL_COVER,
        interval_presses=presses,
        network=network.to(settings.device),
    )


def prepared(frames: FrameSet, part: str, settings: FitSettings) -> FaceData:
    """Frames of one part that can be learned from, with changes over time where those are asked for."""
    whole = with_history(frames, settings.training.history_frames or 0)
    return thinned(with_contacts(face_data(whole, settings.face), part), settings.seed)


def folds_of(parts: list[FaceData], settings: FitSettings) -> list[tuple[FaceData, FaceData]]:
    """Return what each member is fitted to, and what stops and calibrates it."""
    members = settings.training.ensemble or 1
    if members == 1:
        return [(parts[0], parts[1])]
    pooled = joined(*parts)
    fold = press_folds(pooled, members, settings.seed)
    return [(pooled.select(fold != k), pooled.select(fold == k)) for k in range(members)]


def common_channels(parts: list[FaceData], training: TrainingSpec) -> tuple[Channel, ...]:
    """Channels that are live in all parts."""
    all_faces = training.model == "whole-object"
    alive = set(live_channels(parts[1], all_faces))
    channels = tuple(channel for channel in live_channels(parts[0], all_faces) if channel in alive)
    if not channels:
        raise InputError(
            f"no channel of face {parts[0].face} has readings in all frames. Leave that "
            "recording out"
        )
    return channels


def _fit_member(
    member: HeadsNetwork,
    number: int,
    data: FaceData,
    held_out: FaceData,
    channels: tuple[Channel, ...],
    settings: FitSettings,
    progress: Progress | None,
) -> None:
    device = settings.device
    member.to(device)
    scale = float(member.get_buffer("force_scale_n"))
    train, validation = (
        batch_of(part, channels, scale, settings.axes, device) for part in (data, held_out)
    )
    schedule = schedule_of(settings, number, data.frames.source)
    sigma = torch.as_tensor(sigma_counts(data, channels), dtype=torch.float32, device=device)
    elsewhere = elsewhere_counts(data, channels).to(device)
    zeroed = torch.tensor([float(face < HISTORY) for face, _, _ in channels], device=device)
    folder = settings.checkpoint
    path = None if folder is None else folder / f"member_{number}.safetensors"
    mark = data_fingerprint(schedule, train.counts, train.maps, asdict(settings.architecture))
    columns = settings.nuisances
    rows = None if columns is None else nuisance_rows(data, channels, columns).to(device)
    disturbances = Disturbances(sigma, zeroed, elsewhere, rows)
    fit(member, train, validation, disturbances, schedule, progress, path, mark)


def schedule_of(settings: FitSettings, number: int, source: str) -> Schedule:
    training, seed = settings.training, settings.seed + _NEXT_SEED * number
    budget = None if settings.budget_s is None else settings.budget_s / (training.ensemble or 1)
    augmentation = settings.augmentation or AUGMENTATION[source]
    if settings.augmentation is None and training.model == "whole-object":
        augmentation = replace(augmentation, other_faces=_OTHER_FACES)
    return Schedule(
        epochs=training.epochs,
        batch_frames=BATCH_FRAMES,
        learning_rate=LEARNING_RATE,
        weight_decay=_WEIGHT_DECAY,
        patience_epochs=settings.patience_epochs,
        augmentation=augmentation,
        seed=seed,
        budget_s=budget,
    )


def data_fingerprint(
    schedule: Schedule, counts: torch.Tensor, maps: torch.Tensor, built: dict
) -> str:
    digest = hashlib.sha256(repr((schedule, built)).encode())
    for tensor in (counts, maps):
        digest.update(tensor.cpu().numpy().tobytes())
    return digest.hexdigest()

"""Ridge regression alone: a baseline, without an estimator's intervals."""

from __future__ import annotations

from design.spec.object import TrainingSpec
from estimator.frames.dataset import FrameSet
from estimator.frames.face_data import Channel
from estimator.networks.defaults import filled
from estimator.networks.ensemble import fit_ridge, new_member
from estimator.networks.network import HeatmapNetwork
from estimator.networks.training.data import batch_of
from estimator.networks.training.face import FitSettings, common_channels, prepared


def fit_linear(
    train_frames: FrameSet, validation_frames: FrameSet, face: int
) -> tuple[HeatmapNetwork, tuple[Channel, ...]]:
    """Ridge regression of a face's heatmaps and the channels that it reads, without intervals.

    Raises
    ------
    InputError
        No contact on the face in either part, or no live channel.
    """
    settings = FitSettings(face, filled(TrainingSpec(model="linear")), device="cpu")
    train, validation = (
        prepared(frames, name, settings)
        for frames, name in ((train_frames, "training"), (validation_frames, "validation"))
    )
    channels = common_channels([train, validation], settings.training)
    member = new_member(train, channels, settings.training, settings.seed)
    batch = batch_of(train, channels, float(member.get_buffer("force_scale_n")), 1, settings.device)
    assert isinstance(member, HeatmapNetwork)
    fit_ridge(member, batch.counts.numpy(), batch.maps.numpy())
    return member, channels

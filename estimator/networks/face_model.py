"""A trained estimator of one face: what it reads, its network, its file, and its use on frames."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np
import torch
from jaxtyping import Float
from torch import Tensor, nn

from design.errors import DAMAGED_CONTENT, InputError, StoreError
from estimator.field.device import one_thread
from estimator.frames.dataset import FrameSet
from estimator.frames.face_data import (
    HISTORY,
    Channel,
    channel_counts,
    frames_with_readings,
    with_history,
)
from estimator.networks.forest import Forest, ForestShape
from estimator.networks.intervals.coverage import Coverage
from estimator.networks.network import ContactEstimator, HeadsNetwork
from estimator.networks.prediction import Prediction
from estimator.networks.process import Process, ProcessShape
from estimator.networks.tensor_file import load_tensors, save_tensors

MODEL_FORMAT = 6
"""Version of the file; others are refused."""
_BATCH_FRAMES = 8192
"""Frames computed at once: it bounds the memory."""
_LONGEST_HISTORY = 100
"""Frames, as specifications allow."""


@dataclass(frozen=True)
class Architecture:
    """Architecture of an estimator, besides the numbers among its weights.

    `forest` and `process` are the shapes of what supports the networks, `references` how many
    training frames novelty is measured from.
    """

    hidden_units: tuple[int, ...]
    axes: int = 1
    continuous: bool = False
    members: int = 1
    forest: ForestShape | None = None
    process: ProcessShape | None = None
    references: int = 0


@dataclass(frozen=True)
class FaceModel:
    """A trained network with all that is needed to use it.

    Attributes
    ----------
    name : of the model, `training.model`
    channels : inputs, in order; dead channels were left out
    history_frames : over how many frames the channels that are changes reach back
    grid_x_mm, grid_y_mm : pixel centres of the heatmap, mm
    interval_cover : share of held-out presses' frames that the intervals are made to cover
    interval_presses : how many presses with contact calibrated them
    """

    name: str
    face: int
    channels: tuple[Channel, ...]
    grid_x_mm: Float[np.ndarray, "nx"]
    grid_y_mm: Float[np.ndarray, "ny"]
    architecture: Architecture
    history_frames: int
    interval_cover: float
    interval_presses: int
    network: ContactEstimator

    def __repr__(self) -> str:
        history = f", changes over {self.history_frames} frames" if self.history_frames else ""
        return (
            f"FaceModel {self.name} of face {self.face}: reads {len(self.channels)} channels{history}; "
            f"heatmap {len(self.grid_x_mm)} × {len(self.grid_y_mm)} pixels, N; "
            f"{100 * self.interval_cover:g} % intervals from {self.interval_presses} presses"
        )


def predict(model: FaceModel, frames: FrameSet) -> Prediction:
    """Read every frame; presses must be complete if the model reads changes over time.

    Raises
    ------
    InputError
        A channel that the model uses is missing.
    """
    if frames.faces.max() < HISTORY:
        frames = with_history(frames, model.history_frames)
    return read_counts(model.network, channel_counts(frames, model.channels))


def predict_with_gaps(model: FaceModel, frames: FrameSet) -> Prediction:
    """Predict as `predict` does, with NaN in frames that lack a reading (or the one that a change starts
    from).

    Raises
    ------
    InputError
        No frame has the readings of all channels that the model uses.
    """
    has_readings, chosen = frames_with_readings(frames, model.channels, model.history_frames)
    return predict(model, chosen).spread(has_readings)


def predict_heatmaps(model: FaceModel, frames: FrameSet) -> Float[np.ndarray, "frame nx ny"]:
    """Heatmaps of normal force (N); raises as `predict`."""
    return predict(model, frames).heatmap_n[:, -1]


@one_thread()
def read_counts(network: nn.Module, counts: Float[np.ndarray, "frame channel"]) -> Prediction:
    """Readings of an estimator, or of a member of it, in batches on its own device."""
    device = next(network.parameters()).device
    network.eval()
    with torch.inference_mode():
        parts = [
            network(part.to(device))
            for part in torch.as_tensor(counts, dtype=torch.float32).split(_BATCH_FRAMES)
        ]
    columns = (torch.cat(column).cpu().double().numpy() for column in zip(*parts, strict=True))
    return Prediction(*columns)


def empty_network(
    architecture: Architecture,
    channels: int,
    grid_x_mm: Float[np.ndarray, "nx"],
    grid_y_mm: Float[np.ndarray, "ny"],
) -> ContactEstimator:
    """A network of the right shapes whose weights and scales are yet to be loaded."""
    ones = np.ones(channels)
    grids = (grid_x_mm, grid_y_mm)
    units, axes = architecture.hidden_units, architecture.axes

    def member() -> nn.Module:
        return HeadsNetwork(ones, *grids, units, 1.0, axes, architecture.continuous)

    forest = None if architecture.forest is None else Forest(architecture.forest)
    coverage = Coverage(channels, architecture.references)
    shape = architecture.process
    process = None if shape is None else Process(shape, channels)
    return ContactEstimator(
        [member() for _ in range(architecture.members)], coverage, forest, process
    )


def description(model: FaceModel) -> dict[str, Any]:
    """Return what is written with the weights."""
    return {
        "format": MODEL_FORMAT,
        "name": model.name,
        "face": model.face,
        "channels": model.channels,
        "grid_x_mm": model.grid_x_mm.tolist(),
        "grid_y_mm": model.grid_y_mm.tolist(),
        "architecture": asdict(model.architecture),
        "history_frames": model.history_frames,
        "interval_cover": model.interval_cover,
        "interval_presses": model.interval_presses,
    }


def save_model(model: FaceModel, path: Path | str) -> None:
    """Write weights and description as one safetensors file."""
    save_tensors(model.network.state_dict(), description(model), path)


def load_model(path: Path | str) -> FaceModel:
    """Read a model written by `save_model`; no code is run from the file.

    Raises
    ------
    InputError
        No such file.
    StoreError
        Damaged, not a model of instobj, or weights that do not fit the description.
    """
    path = Path(path)
    if not path.is_file():
        raise InputError(f"no model at {path}. `instobj train SPEC` makes one")
    described, weights = _described(path)
    try:
        return _assembled(described, weights)
    except DAMAGED_CONTENT as error:
        raise StoreError(
            f"{path}: weights and description do not belong together ({error}). Train the "
            "model anew"
        ) from None


def _described(path: Path) -> tuple[dict[str, Any], dict[str, Tensor]]:
    described, weights = load_tensors(path, "Give a trained model")
    found_format = described.get("format") if isinstance(described, dict) else None
    if found_format != MODEL_FORMAT:
        raise StoreError(
            f"{path} has model format {found_format}, this version reads "
            f"{MODEL_FORMAT}. Train the model anew"
        )
    return described, weights


def _assembled(described: dict[str, Any], weights: dict[str, Tensor]) -> FaceModel:
    channels = tuple((int(f), int(s), int(a)) for f, s, a in described["channels"])
    grid_x, grid_y = (np.array(described[f"grid_{axis}_mm"], dtype=float) for axis in "xy")
    built = dict(described["architecture"])
    built["hidden_units"] = _whole_numbers(built["hidden_units"])
    for name, shape in (("forest", ForestShape), ("process", ProcessShape)):
        if built[name] is not None:
            built[name] = shape(*_whole_numbers(built[name]))
    architecture = Architecture(**built)
    history_frames = int(described["history_frames"])
    if not 0 <= history_frames <= _LONGEST_HISTORY or architecture.members > len(weights):
        raise ValueError(f"{history_frames} frames of history, {architecture.members} members")
    network = empty_network(architecture, len(channels), grid_x, grid_y)
    network.load_state_dict(weights)
    return FaceModel(
        name=str(described["name"]),
        face=int(described["face"]),
        channels=channels,
        grid_x_mm=grid_x,
        grid_y_mm=grid_y,
        architecture=architecture,
        history_frames=history_frames,
        interval_cover=float(described["interval_cover"]),
        interval_presses=int(described["interval_presses"]),
        network=network,
    )


def _whole_numbers(values: Sequence[Any]) -> tuple[int, ...]:
    return tuple(int(value) for value in values)

"""Contact estimator of one face: nine Hall changes in, heatmap of normal force out.

A fully connected trunk on arcsinh(ΔS / 3σ), σ the white noise of each channel, with three heads:
the share of force at each pixel (softmax), the total force (softplus) and whether there is contact
at all. The heatmap is force × P(contact)² × share. Scaling by the noise keeps weak and
strong presses alike in range, which mattered more than width in comparisons.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import torch
from jaxtyping import Float
from torch import Tensor, nn

from design.errors import InputError
from design.files import atomic_path

SIGMA_SPAN = 3.0
DOUBT_POWER = 2
"""Forces are multiplied by P(contact)², so that doubtful contacts stay visible but faint."""
MODEL_FORMAT = 1
_BATCH_FRAMES = 8192


@dataclass(frozen=True)
class Estimate:
    """Outputs of the heads: logits of the shares, force in units of the scale, contact logit."""

    share_logits: Float[Tensor, "frame pixel"]
    force: Float[Tensor, "frame"]
    contact_logit: Float[Tensor, "frame"]


class ContactNetwork(nn.Module):
    """Trunk and heads; inputs are scaled signals (frame, channel)."""

    def __init__(self, channels: int, hidden_units: Sequence[int], pixels: int) -> None:
        super().__init__()
        widths = [channels, *hidden_units]
        layers: list[nn.Module] = []
        for wide, narrow in pairwise(widths):
            layers += [nn.Linear(wide, narrow), nn.SiLU()]
        self.trunk = nn.Sequential(*layers)
        self.heads = nn.Linear(widths[-1], pixels + 2)

    def forward(self, scaled: Tensor) -> Estimate:
        output = self.heads(self.trunk(scaled))
        force = nn.functional.softplus(output[:, -2])
        return Estimate(output[:, :-2], force, output[:, -1])


@dataclass(frozen=True)
class FaceModel:
    """A trained network with all that is needed to use it.

    Attributes
    ----------
    channels : (sensor, axis) of each input, counted from 0; dead channels were left out
    sigma_counts : (channel,) white noise that scales each input, counts
    grid_x_mm, grid_y_mm : pixel centres of the heatmap, mm
    force_scale_n : N per unit of the force head
    sharpness : factor on the share logits, chosen on validation presses
    """

    face: int
    channels: tuple[tuple[int, int], ...]
    sigma_counts: Float[np.ndarray, "channel"]
    grid_x_mm: Float[np.ndarray, "nx"]
    grid_y_mm: Float[np.ndarray, "ny"]
    hidden_units: tuple[int, ...]
    force_scale_n: float
    sharpness: float
    network: ContactNetwork


def scaled_signals(
    counts: Float[Tensor, "frame channel"], sigma_counts: Float[Tensor, "channel"]
) -> Float[Tensor, "frame channel"]:
    """Linear below 3σ, logarithmic far above: arcsinh(ΔS / 3σ)."""
    return torch.asinh(counts / (SIGMA_SPAN * sigma_counts))


def channel_counts(
    signal_counts: Float[np.ndarray, "frame sensor axis"], channels: tuple[tuple[int, int], ...]
) -> Float[np.ndarray, "frame channel"]:
    """Signals of the given channels, in order.

    Raises
    ------
    InputError
        A channel does not exist or misses a reading.
    """
    sensor, axis = np.array(channels).T
    if sensor.max() >= signal_counts.shape[1]:
        raise InputError(
            f"the model needs sensor {sensor.max() + 1} of a face; the signals have "
            f"{signal_counts.shape[1]} sensors. Use the model of the object that was recorded"
        )
    chosen = signal_counts[:, sensor, axis]
    missing = np.isnan(chosen).any(axis=0)
    if missing.any():
        names = ", ".join(f"{'XYZ'[axis[k]]}{sensor[k] + 1}" for k in np.flatnonzero(missing))
        raise InputError(
            f"channels {names}, which the model uses, miss readings. Train anew without them or "
            "leave those frames out"
        )
    return chosen


def predict_heatmaps(
    model: FaceModel, signal_counts: Float[np.ndarray, "frame sensor axis"]
) -> Float[np.ndarray, "frame nx ny"]:
    """Heatmaps (N) of the face from the changes of its own sensors against rest (counts).

    Raises
    ------
    InputError
        A channel that the model uses is missing.
    """
    counts = torch.as_tensor(channel_counts(signal_counts, model.channels), dtype=torch.float32)
    sigma = torch.as_tensor(model.sigma_counts, dtype=torch.float32)
    device = next(model.network.parameters()).device
    model.network.eval()
    with torch.inference_mode():
        parts = [
            _heatmaps(model, scaled_signals(part, sigma).to(device)).cpu()
            for part in counts.split(_BATCH_FRAMES)
        ]
    shape = (len(counts), len(model.grid_x_mm), len(model.grid_y_mm))
    return torch.cat(parts).reshape(shape).numpy().astype(np.float64)


def _heatmaps(model: FaceModel, scaled: Tensor) -> Tensor:
    estimate = model.network(scaled)
    share = torch.softmax(model.sharpness * estimate.share_logits, dim=1)
    certain = torch.sigmoid(estimate.contact_logit) ** DOUBT_POWER
    force_n = model.force_scale_n * estimate.force * certain
    return force_n[:, None] * share


def save_model(model: FaceModel, path: Path | str) -> None:
    """Write weights and description as one safetensors file."""
    from safetensors.torch import save_file

    description = {
        "format": MODEL_FORMAT,
        "face": model.face,
        "channels": model.channels,
        "sigma_counts": model.sigma_counts.tolist(),
        "grid_x_mm": model.grid_x_mm.tolist(),
        "grid_y_mm": model.grid_y_mm.tolist(),
        "hidden_units": model.hidden_units,
        "force_scale_n": model.force_scale_n,
        "sharpness": model.sharpness,
        "input": f"arcsinh(counts / ({SIGMA_SPAN:g} sigma))",
        "output": "N per pixel, axes x then y",
    }
    weights = {name: value.cpu().contiguous() for name, value in model.network.state_dict().items()}
    with atomic_path(path) as temporary:
        save_file(weights, temporary, metadata={"instobj": json.dumps(description)})


def load_model(path: Path | str) -> FaceModel:
    """Read a model written by `save_model`; no code is run from the file.

    Raises
    ------
    InputError
        No such file, not a model of instobj, or weights that do not fit the description.
    """
    path = Path(path)
    if not path.is_file():
        raise InputError(f"no model at {path}. `instobj train SPEC` makes one")
    description, weights = _read_safetensors(path)
    try:
        return _assembled(description, weights)
    except (KeyError, TypeError, ValueError, RuntimeError) as error:
        raise InputError(
            f"{path}: weights and description do not belong together ({error}). Train the "
            "model anew"
        ) from None


def _read_safetensors(path: Path) -> tuple[dict[str, Any], dict[str, Tensor]]:
    from safetensors import SafetensorError, safe_open

    try:
        with safe_open(path, framework="pt") as file:
            metadata = file.metadata() or {}
            weights = {name: file.get_tensor(name) for name in file.keys()}  # noqa: SIM118
    except (SafetensorError, OSError) as error:
        raise InputError(
            f"{path} is not a safetensors file ({error}). Give a trained model"
        ) from None
    try:
        description = json.loads(metadata["instobj"])
    except (KeyError, json.JSONDecodeError):
        raise InputError(f"{path} is not a model of instobj. Give a trained model") from None
    if description.get("format") != MODEL_FORMAT:
        raise InputError(
            f"{path} has model format {description.get('format')}, this version reads "
            f"{MODEL_FORMAT}. Train the model anew"
        )
    return description, weights


def _assembled(description: dict[str, Any], weights: dict[str, Tensor]) -> FaceModel:
    channels = tuple((int(sensor), int(axis)) for sensor, axis in description["channels"])
    grid_x, grid_y = (np.array(description[f"grid_{axis}_mm"], dtype=float) for axis in "xy")
    hidden = tuple(int(units) for units in description["hidden_units"])
    network = ContactNetwork(len(channels), hidden, len(grid_x) * len(grid_y))
    network.load_state_dict(weights)
    return FaceModel(
        face=int(description["face"]),
        channels=channels,
        sigma_counts=np.array(description["sigma_counts"], dtype=float),
        grid_x_mm=grid_x,
        grid_y_mm=grid_y,
        hidden_units=hidden,
        force_scale_n=float(description["force_scale_n"]),
        sharpness=float(description["sharpness"]),
        network=network,
    )

"""Frames of one face as tensors for training, and the disturbances added to them."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
import torch
from jaxtyping import Float, Int
from torch import Tensor

from design.errors import InputError
from estimator.frames.dataset import PER_FRAME_FIELDS
from estimator.frames.face_data import HISTORY, Channel, FaceData, channel_counts

NEGATIVES_PER_CONTACT = 0.3
"""Most rest frames, and most frames with other faces pressed, per contact frame."""


@dataclass(frozen=True)
class Augmentation:
    """Disturbances added to each training frame, drawn again in every epoch.

    Attributes
    ----------
    offset_counts : rms offset of a press's zero, one draw per channel, counts
    noise_sigmas : white noise in units of the channel's own σ
    other_faces : share of frames onto which a press of other faces is superposed (their signals
        add up: within 2 % of the signals' rms on the paper's cube)
    """

    offset_counts: float
    noise_sigmas: float = 1.0
    other_faces: float = 0.0


AUGMENTATION = {"simulated": Augmentation(10.0), "recorded": Augmentation(25.0)}
"""Augmentation by source of the data: real silicone creeps back late, so its rest level is less certain."""


@dataclass(frozen=True)
class Batch:
    """Inputs (counts) and targets: share of the normal force at each pixel, forces over the scale
    (normal last), contact or none (1, 0), centre of force in mm (0 without contact)."""

    counts: Float[Tensor, "frame channel"]
    maps: Float[Tensor, "frame cell"]
    share: Float[Tensor, "frame pixel"]
    force: Float[Tensor, "frame axis"]
    contact: Float[Tensor, "frame"]
    centre_mm: Float[Tensor, "frame 2"]

    def __len__(self) -> int:
        return len(self.counts)

    def rows(self, index: Tensor) -> Batch:
        """The given frames."""
        return Batch(*(getattr(self, name)[index] for name in self.__dataclass_fields__))


def batch_of(
    data: FaceData,
    channels: tuple[Channel, ...],
    force_scale_n: float,
    axes: int,
    device: str = "cpu",
) -> Batch:
    """Tensors of a face's frames; `maps` are those of all axes, over the scale."""
    maps = data.force_maps_n[:, -axes:].reshape(len(data), axes, -1)
    total = maps.sum(axis=2)
    normal = total[:, -1:]
    arrays = (
        channel_counts(data.frames, channels),
        maps.reshape(len(data), -1) / force_scale_n,
        maps[:, -1] / np.where(normal > 0, normal, 1.0),
        total / force_scale_n,
        data.contact,
        np.nan_to_num(data.centre_mm),
    )
    return Batch(*(torch.as_tensor(a.astype(np.float32), device=device) for a in arrays))


@dataclass(frozen=True)
class Disturbances:
    """Parts of disturbances: white noise of each channel (counts), whether it is zeroed
    before a press (1) or a change over time (0), signals with only other faces pressed, and what a
    standard deviation of each nuisance since the zero adds (`estimator.signals.nuisances`)."""

    sigma_counts: Float[Tensor, "channel"]
    zeroed: Float[Tensor, "channel"]
    elsewhere: Float[Tensor, "frame channel"]
    nuisances: Float[Tensor, "k channel"] | None = None


def disturbed(
    counts: Tensor,
    sources: Disturbances,
    augmentation: Augmentation,
    generator: torch.Generator,
) -> Tensor:
    """Counts with fresh offsets, noise and nuisances, and presses of other faces out of `elsewhere`."""
    noise, offset = (
        torch.randn(counts.shape, generator=generator).to(counts.device) for _ in range(2)
    )
    counts = counts + augmentation.noise_sigmas * sources.sigma_counts * noise
    counts = counts + augmentation.offset_counts * sources.zeroed * offset
    if sources.nuisances is not None:
        unknowns = torch.randn(len(counts), len(sources.nuisances), generator=generator)
        counts = counts + unknowns.to(counts.device) @ sources.nuisances
    pool = sources.elsewhere
    if augmentation.other_faces and len(pool):
        chosen = torch.randint(len(pool), (len(counts),), generator=generator)
        added = torch.rand(len(counts), generator=generator) < augmentation.other_faces
        counts = counts + added.to(counts.device)[:, None] * pool[chosen.to(pool.device)]
    return counts


def nuisance_rows(
    data: FaceData,
    channels: tuple[Channel, ...],
    columns: Float[np.ndarray, "face sensor 3 k"],
) -> Float[Tensor, "k channel"]:
    """Return what each nuisance adds to the given channels; nothing to changes over time."""
    row = {int(number): index for index, number in enumerate(data.frames.faces)}
    none = np.zeros(columns.shape[3])
    rows = [
        none if face >= HISTORY else columns[row[face], sensor, axis]
        for face, sensor, axis in channels
    ]
    return torch.as_tensor(np.array(rows, np.float32).T.copy())


def elsewhere_counts(
    data: FaceData, channels: tuple[Channel, ...]
) -> Float[Tensor, "frame channel"]:
    """Signals of the frames in which only other faces are pressed."""
    chosen = data.select(~data.rest & ~data.contact)
    return torch.as_tensor(channel_counts(chosen.frames, channels).astype(np.float32))


def with_contacts(data: FaceData, part: str) -> FaceData:
    """The same data, if it holds a contact.

    Raises
    ------
    InputError
        It holds none.
    """
    if not data.contact.any():
        raise InputError(
            f"face {data.face} has no contact in the {part} part. Press it in more presses, or "
            "train only the faces that are pressed"
        )
    return data


def thinned(data: FaceData, seed: int) -> FaceData:
    """All contact frames, with rest frames and other faces' presses limited in number."""
    rng = np.random.default_rng(seed)
    contact = data.contact
    limit = math.ceil(NEGATIVES_PER_CONTACT * contact.sum())
    kept = [np.flatnonzero(contact)]
    for negatives in (np.flatnonzero(data.rest & ~contact), np.flatnonzero(~data.rest & ~contact)):
        kept.append(rng.permutation(negatives)[:limit])
    return data.select(np.sort(np.concatenate(kept)))


def joined(first: FaceData, second: FaceData) -> FaceData:
    """The frames of both."""
    parts = (first.frames, second.frames)
    columns = {
        name: np.concatenate([getattr(part, name) for part in parts]) for name in PER_FRAME_FIELDS
    }
    return FaceData(
        first.face,
        replace(first.frames, **columns, true_force_n=None, zero_error=None, travel_mm=None),
        np.concatenate([first.force_maps_n, second.force_maps_n]),
        np.concatenate([first.rest, second.rest]),
    )


def press_folds(data: FaceData, folds: int, seed: int) -> Int[np.ndarray, "frame"]:
    """Fold of each frame: whole presses, those of each contact case spread over the folds.

    Raises
    ------
    InputError
        Fewer presses with contact on the face than folds.
    """
    rng = np.random.default_rng(seed)
    presses = np.unique(data.frames.press_id)
    touched = np.unique(data.frames.press_id[data.contact])
    if len(touched) < folds:
        raise InputError(
            f"training.ensemble = {folds} needs as many presses on face {data.face}; got "
            f"{len(touched)}. Record more presses, or train a smaller ensemble"
        )
    case = np.empty(len(presses), int)
    for index, press in enumerate(presses):
        places = data.frames.place_id[(data.frames.press_id == press) & data.contact]
        case[index] = (
            np.bincount(places - places.min()).argmax() + places.min() if len(places) else -1
        )
    order = np.lexsort((rng.permutation(len(presses)), case))
    fold = np.empty(len(presses), dtype=int)
    fold[order] = np.arange(len(presses)) % folds
    return fold[np.searchsorted(presses, data.frames.press_id)]

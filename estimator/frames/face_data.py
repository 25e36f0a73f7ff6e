"""The part of a data set that concerns one face: its frames and true heatmaps."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Bool, Float, Int

from design.errors import InputError
from estimator.frames.dataset import NO_FACE, FrameSet
from estimator.frames.heatmap import force_heatmaps

Channel = tuple[int, int, int]
"""Face number, sensor and axis counted from 0; changes over time have `HISTORY` added to the face."""
HISTORY = 100
"""Added to the face's number for channels that are changes over time."""


@dataclass(frozen=True)
class FaceData:
    """Valid frames of one face.

    Attributes
    ----------
    frames : the frames themselves, with the signals of all faces
    force_maps_n : (frame, 3, nx, ny), N along the face's x, y and inward normal at each pixel
    rest : (frame,) no face is pressed; a zero heatmap that is not rest has other faces pressed
    """

    face: int
    frames: FrameSet
    force_maps_n: Float[np.ndarray, "frame 3 nx ny"]
    rest: Bool[np.ndarray, "frame"]

    def __len__(self) -> int:
        return len(self.rest)

    @property
    def heatmap_n(self) -> Float[np.ndarray, "frame nx ny"]:
        """Normal force at each pixel, N."""
        return self.force_maps_n[:, 2]

    @property
    def contact(self) -> Bool[np.ndarray, "frame"]:
        """Frames in which this face is pressed."""
        return self.heatmap_n.max(axis=(1, 2)) > 0

    @property
    def centre_mm(self) -> Float[np.ndarray, "frame 2"]:
        """Centre of normal force of the face's contacts; NaN where there is none."""
        mine = (self.frames.contact_face == self.face)[..., None]
        weight = np.where(mine, self.frames.force_n[..., 2:], 0.0)
        moment = np.sum(np.where(mine, weight * self.frames.contact_xy_mm, 0.0), axis=1)
        total = weight.sum(axis=1)
        return np.where(total > 0, moment / np.where(total > 0, total, 1.0), np.nan)

    def select(self, index: Bool[np.ndarray, "frame"] | Int[np.ndarray, "n"]) -> FaceData:
        """The given frames, in order."""
        maps, rest = self.force_maps_n[index], self.rest[index]
        return FaceData(self.face, self.frames.select(index), maps, rest)


def face_data(frames: FrameSet, face: int) -> FaceData:
    """Valid frames with readings of the face; contacts labelled with no force are left out.

    Raises
    ------
    InputError
        The data set does not know the face, or holds no usable frame of it.
    """
    index = np.flatnonzero(frames.faces == face)
    if not len(index):
        known_faces = frames.faces[frames.faces < HISTORY].tolist()
        raise InputError(
            f"face {face} is not in the data set; it has {known_faces}. Choose one of these"
        )
    recorded = np.any(np.isfinite(frames.signal_counts[:, index[0]]), axis=(1, 2))
    faint = np.any((frames.contact_face == face) & ~(frames.force_n[..., 2] > 0), axis=1)
    used = frames.valid & recorded & ~faint
    if not used.any():
        raise InputError(
            f"the data set holds no valid frame with readings of face {face}. Choose another face "
            "or add recordings"
        )
    chosen = frames.select(used)
    rest = np.all(chosen.contact_face == NO_FACE, axis=1)
    return FaceData(face, chosen, force_heatmaps(chosen, face), rest)


def live_channels(data: FaceData, every_face: bool = False) -> tuple[Channel, ...]:
    """Channels of the face (or of every face) without a missing reading.

    Raises
    ------
    InputError
        Every channel misses readings.
    """
    live = np.all(np.isfinite(data.frames.signal_counts), axis=0)
    faces = data.frames.faces
    if not every_face:
        live &= (faces % HISTORY == data.face)[:, None, None]
    if not live.any():
        whose = "the object" if every_face else f"face {data.face}"
        raise InputError(
            f"every channel of {whose} misses readings in some frame. Mark those frames "
            "invalid or leave that recording out"
        )
    return tuple(
        (int(faces[face]), int(sensor), int(axis)) for face, sensor, axis in np.argwhere(live)
    )


def channel_counts(
    frames: FrameSet, channels: tuple[Channel, ...]
) -> Float[np.ndarray, "frame channel"]:
    """Signals of the given channels, in order.

    Raises
    ------
    InputError
        A channel does not exist or misses a reading.
    """
    chosen = _select_channels(frames, channels)
    missing = np.isnan(chosen).any(axis=0)
    if missing.any():
        names = ", ".join(channel_label(channels[k]) for k in np.flatnonzero(missing))
        raise InputError(
            f"channels {names}, which the model uses, miss readings. Train anew without them or "
            "leave those frames out"
        )
    return chosen


def has_readings(frames: FrameSet, channels: tuple[Channel, ...]) -> Bool[np.ndarray, "frame"]:
    """Return which frames have a reading of each of the channels.

    Raises
    ------
    InputError
        A channel does not exist.
    """
    return np.all(np.isfinite(_select_channels(frames, channels)), axis=1)


def frames_with_readings(
    frames: FrameSet, channels: tuple[Channel, ...], history_frames: int
) -> tuple[Bool[np.ndarray, "frame"], FrameSet]:
    """Return which frames have readings of all channels (and the one that a change starts from), and
    these, with changes; all of them where none has, for `channel_counts` to say which channel is missing.

    Raises
    ------
    InputError
        A channel does not exist.
    """
    wide = with_history(frames, history_frames)
    is_complete = has_readings(wide, channels)
    return is_complete, wide.select(is_complete) if is_complete.any() else wide


def _select_channels(
    frames: FrameSet, channels: tuple[Channel, ...]
) -> Float[np.ndarray, "frame channel"]:
    face, sensor, axis = np.array(channels).T
    row = {int(number): index for index, number in enumerate(frames.faces)}
    absent = sorted(set(face.tolist()) - set(row))
    if absent or sensor.max() >= frames.signal_counts.shape[2]:
        raise InputError(
            f"the model needs sensor {sensor.max() + 1} of faces {sorted(set(face.tolist()))}; the "
            f"signals have {frames.signal_counts.shape[2]} sensors on faces {sorted(row)}. Use the "
            "model of the object that was recorded"
        )
    return frames.signal_counts[:, [row[int(number)] for number in face], sensor, axis]


def channel_label(channel: Channel) -> str:
    """F3-Y1: axis Y of the first sensor of face 3; dF3-Y1: its change over `history_frames`."""
    face, sensor, axis = channel
    name = f"F{face % HISTORY}-{'XYZ'[axis]}{sensor + 1}"
    return name if face < HISTORY else f"d{name}"


def with_history(frames: FrameSet, history_frames: int) -> FrameSet:
    """The frames with further faces, numbered from `HISTORY` on, that hold the change of each
    channel over `history_frames`, or since the press began where that is later.

    Frames of a press must be complete and in order. A frame whose change begins at a lost reading is
    not valid, so that the channel keeps its change.
    """
    if not history_frames:
        return frames
    row = np.arange(len(frames))
    _, first, press = np.unique(frames.press_id, return_index=True, return_inverse=True)
    start_row = np.maximum(row - history_frames, first[press])
    change = frames.signal_counts - frames.signal_counts[start_row]
    lost = np.any(np.isnan(change) & np.isfinite(frames.signal_counts), axis=(1, 2, 3))
    return replace(
        frames,
        valid=frames.valid & ~lost,
        signal_counts=np.concatenate([frames.signal_counts, change], axis=1),
        faces=np.concatenate([frames.faces, frames.faces + HISTORY]),
    )

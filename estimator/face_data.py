"""The part of a data set that concerns one face: its signals and true heatmaps."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float

from design.errors import InputError
from estimator.dataset import NO_FACE, FrameSet
from estimator.heatmap import contact_heatmaps


@dataclass(frozen=True)
class FaceData:
    """Valid frames of one face.

    Attributes
    ----------
    signal_counts : (frame, sensor, axis), counts
    heatmap_n : (frame, nx, ny), N
    rest : (frame,) no face is pressed; a zero heatmap that is not rest has other faces pressed
    """

    face: int
    signal_counts: Float[np.ndarray, "frame sensor axis"]
    heatmap_n: Float[np.ndarray, "frame nx ny"]
    rest: Bool[np.ndarray, "frame"]

    def __len__(self) -> int:
        return len(self.rest)

    @property
    def contact(self) -> Bool[np.ndarray, "frame"]:
        """Frames in which this face is pressed."""
        return self.heatmap_n.max(axis=(1, 2)) > 0


def face_data(frames: FrameSet, face: int) -> FaceData:
    """Valid frames with readings of the face; contacts labelled with no force are left out.

    Raises
    ------
    InputError
        The data set does not know the face, or holds no usable frame of it.
    """
    index = np.flatnonzero(frames.faces == face)
    if not len(index):
        raise InputError(f"face {face} is not in the data set; it has {frames.faces.tolist()}")
    signal = frames.signal_counts[:, index[0]]
    recorded = np.any(np.isfinite(signal), axis=(1, 2))
    faint = np.any((frames.contact_face == face) & ~(frames.force_n[..., 2] > 0), axis=1)
    used = frames.valid & recorded & ~faint
    if not used.any():
        raise InputError(
            f"the data set holds no valid frame with readings of face {face}. Choose another face "
            "or add recordings"
        )
    chosen = frames.select(used)
    rest = np.all(chosen.contact_face == NO_FACE, axis=1)
    return FaceData(face, signal[used], contact_heatmaps(chosen, face), rest)


def live_channels(data: FaceData) -> tuple[tuple[int, int], ...]:
    """(sensor, axis) of the channels without a missing reading, counted from 0.

    Raises
    ------
    InputError
        Every channel misses readings.
    """
    live = np.all(np.isfinite(data.signal_counts), axis=0)
    if not live.any():
        raise InputError(
            f"every channel of face {data.face} misses readings in some frame. Mark those frames "
            "invalid or leave that recording out"
        )
    return tuple((int(sensor), int(axis)) for sensor, axis in np.argwhere(live))

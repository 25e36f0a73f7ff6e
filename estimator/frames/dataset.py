"""Labelled frames, the same for simulated and recorded presses, in NetCDF.

A frame holds the signals of all sensors at one instant and the contacts that caused them.
Signals are changes against rest, in counts; a channel that was dead is NaN.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Literal

import numpy as np
from jaxtyping import Bool, Float, Int

from design.netcdf import FileKind, read_netcdf, write_netcdf

NO_FACE = 0
"""`contact_face` of an empty contact slot."""


@dataclass(frozen=True, repr=False)
class FrameSet:
    """Frames of one object.

    Attributes
    ----------
    signal_counts : (frame, face, sensor, axis), counts
        Change against rest; NaN where a channel is dead.
    contact_face : (frame, contact)
        Face number of each contact, `NO_FACE` where the slot is empty.
    contact_xy_mm : (frame, contact, 2), mm in the face's frame; NaN where empty.
        On curved faces lengths along the surface (docs/faces.md), as all places of contacts.
    force_n : (frame, contact, 3), N along the face's x, y and inward normal; NaN where empty.
        The label: what a load cell shows, shared equally among the tips of its probe.
    valid : (frame,)
        False for frames that must not be used (glitches, force between contact and rest, …).
    press_id : (frame,)
        Frames of one press, or one stretch of rest before it, share an id; never split one.
    place_id : (frame,)
        Contact case (the same places pressed), -1 for rest.
    session_id : (frame,)
    time_s : (frame,), s
    faces : (face,) face numbers along the face axis
    grid_x_mm, grid_y_mm : contact grid, so that heatmaps know their pixels, mm
    noise_counts : (axis,) white noise of a reading, counts
    true_force_n : as `force_n`, what each tip really bears; None where nobody knows (recorded)
    zero_error : (frame, 2), or None where nobody knows
        Of the zero that was taken off: its variance, counts² (mean over channels), and its memory: errors
        of two frames of a session have the later one's variance times exp(-(difference of memory)) in
        common.
    travel_mm : (frame,) label of a machine without a load cell; None where forces were measured
    force_factors : (2,), or None where forces were measured
        Factors between which every force lies, for the interval of the silicone's modulus; NaN where
        that is not known.
    """

    signal_counts: Float[np.ndarray, "frame face sensor axis"]
    contact_face: Int[np.ndarray, "frame contact"]
    contact_xy_mm: Float[np.ndarray, "frame contact 2"]
    force_n: Float[np.ndarray, "frame contact 3"]
    valid: Bool[np.ndarray, "frame"]
    press_id: Int[np.ndarray, "frame"]
    place_id: Int[np.ndarray, "frame"]
    session_id: Int[np.ndarray, "frame"]
    time_s: Float[np.ndarray, "frame"]
    faces: Int[np.ndarray, "face"]
    grid_x_mm: Float[np.ndarray, "nx"]
    grid_y_mm: Float[np.ndarray, "ny"]
    noise_counts: Float[np.ndarray, "3"]
    source: Literal["simulated", "recorded"]
    spec_hash: str
    seed: int
    lag_frames: int = 0
    true_force_n: Float[np.ndarray, "frame contact 3"] | None = None
    zero_error: Float[np.ndarray, "frame 2"] | None = None
    travel_mm: Float[np.ndarray, "frame"] | None = None
    force_factors: Float[np.ndarray, "2"] | None = None

    def __len__(self) -> int:
        return len(self.time_s)

    def __repr__(self) -> str:
        pressed = np.unique(self.contact_face[self.contact_face != NO_FACE]).tolist()
        return (
            f"FrameSet ({self.source}): {len(self)} frames, {int(self.valid.sum())} valid, of "
            f"{len(np.unique(self.press_id))} presses and rests; {self.signal_counts.shape[2]} sensors on "
            f"each of faces {self.faces.tolist()}, pressed {pressed}; grid {len(self.grid_x_mm)} × "
            f"{len(self.grid_y_mm)}"
        )

    def select(self, frames: Bool[np.ndarray, "frame"] | Int[np.ndarray, "n"]) -> FrameSet:
        """The given frames, in order."""
        chosen = {name: getattr(self, name)[frames] for name in _PER_FRAME}
        for name in _OPTIONAL:
            if getattr(self, name) is not None:
                chosen[name] = getattr(self, name)[frames]
        return replace(self, **chosen)

    def select_faces(self, faces: Sequence[int]) -> FrameSet:
        """With the signals of these faces alone, where the others are dead and nothing pressed them;
        else as it is."""
        others = ~np.isin(self.faces, faces)
        kept = ~others
        spoken = np.isfinite(self.signal_counts[:, others]).any()
        pressed = np.isin(self.contact_face, self.faces[others]).any()
        if spoken or pressed or not set(faces) <= set(self.faces.tolist()):
            return self
        return replace(self, signal_counts=self.signal_counts[:, kept], faces=self.faces[kept])


_PER_FRAME = {
    "signal_counts": ("frame face sensor axis", "count"),
    "contact_face": ("frame contact", "1"),
    "contact_xy_mm": ("frame contact plane", "mm"),
    "force_n": ("frame contact space", "N"),
    "valid": ("frame", "1"),
    "press_id": ("frame", "1"),
    "place_id": ("frame", "1"),
    "session_id": ("frame", "1"),
    "time_s": ("frame", "s"),
}
_OPTIONAL = ("true_force_n", "zero_error", "travel_mm")
PER_FRAME_FIELDS = tuple(_PER_FRAME)
"""Names of the arrays that have one row per frame."""
_FRAMES = FileKind(
    "labelled frames",
    {
        **_PER_FRAME,
        "faces": ("face", "1"),
        "grid_x_mm": ("grid_x", "mm"),
        "grid_y_mm": ("grid_y", "mm"),
        "noise_counts": ("axis", "count"),
        "true_force_n": ("frame contact space", "N"),
        "zero_error": ("frame zero", "1"),
        "travel_mm": ("frame", "mm"),
        "force_factors": ("end", "1"),
    },
    optional=(*_OPTIONAL, "force_factors"),
    packed=("signal_counts",),
    attributes=("source", "spec_hash", "seed", "lag_frames"),
    unit_name="unit",
    origin="`instobj recordings` or `instobj train SPEC` makes one",
    remedy="Make it anew with this version of instobj, of a recording by `instobj recordings`",
    others={
        "counts": "a recording, not a data set. Run `instobj recordings` on it first and give the "
        "frames.nc that this writes"
    },
)


def save_frames(frames: FrameSet, path: Path | str) -> None:
    """Write a data set (NetCDF4): named dimensions, units, provenance."""
    values = {name: getattr(frames, name) for name in _FRAMES.arrays}
    attributes = {name: getattr(frames, name) for name in _FRAMES.attributes}
    write_netcdf(_FRAMES, path, values, attributes)


def load_frames(path: Path | str) -> FrameSet:
    """Read a data set.

    Raises
    ------
    InputError
        No such file, or a recording.
    StoreError
        Damaged, not a data set of instobj, or of another schema version.
    """
    values, attributes = read_netcdf(_FRAMES, path)
    values["signal_counts"] = values["signal_counts"].astype(np.float64)
    values["valid"] = values["valid"].astype(bool)
    return FrameSet(
        **values,
        source=attributes["source"],
        spec_hash=str(attributes["spec_hash"]),
        seed=int(attributes["seed"]),
        lag_frames=int(attributes["lag_frames"]),
    )

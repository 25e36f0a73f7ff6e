"""Labelled presses of one or several tips together as mean signals, to calibrate a whole object on."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float, Int

from design.errors import InputError
from design.spec.object import ObjectSpec
from estimator.calibration.twin.pressed_places import (
    LEAST_FRAMES,
    invalidate_hard_presses,
    is_in_table,
    recorded_noise_counts,
)
from estimator.frames.dataset import NO_FACE, FrameSet
from estimator.frames.heatmap import faces_pressed
from estimator.frames.windows import all_counts
from fem.presses.results import PressForces

LEAST_CASES = 3
"""Sets of contacts from which a model is calibrated, at least."""
_LEVELS = 4
"""Levels of force into which the frames of a case are cut."""


@dataclass(frozen=True)
class PressedCases:
    """Means over frames of like force, of every set of contact locations that is pressed together.

    Attributes
    ----------
    channels : (channel,) those of the object without gaps, as (face · sensors + sensor) · 3 + axis
    face, xy_mm : (case, contact), (case, contact, 2); `NO_FACE` and 0 where a case has fewer
    force_n : (case, level, contact) mean labelled normal force, levels by growing sum; 0 where empty
    counts : (case, level, channel) mean change against rest
    noise_counts2 : (case, level, channel) variance of each mean by white noise and zeroing
    chip_counts : (case, level, channel) rms change of the axes of the channel's chip
    noise_counts : (axis,) white noise of a frame, as recorded where that is known
    """

    channels: Int[np.ndarray, "channel"]
    face: Int[np.ndarray, "case contact"]
    xy_mm: Float[np.ndarray, "case contact 2"]
    force_n: Float[np.ndarray, "case level contact"]
    counts: Float[np.ndarray, "case level channel"]
    noise_counts2: Float[np.ndarray, "case level channel"]
    chip_counts: Float[np.ndarray, "case level channel"]
    noise_counts: Float[np.ndarray, "3"]

    def __len__(self) -> int:
        return len(self.face)

    @property
    def faces(self) -> tuple[int, ...]:
        """That are pressed in any case."""
        return tuple(np.unique(self.face[self.face != NO_FACE]).tolist())


def pressed_cases(spec: ObjectSpec, frames: FrameSet, forces: PressForces) -> PressedCases:
    """Frames in which all contacts of a case (`place_id`) touch, within 0.8 of the deepest simulated
    press, as four means per case.

    Raises
    ------
    InputError
        Fewer than three cases with twelve such frames each, or no channel without gaps.
    """
    touched = frames.contact_face != NO_FACE
    inside = ~touched
    for face in faces_pressed(frames):
        frames = invalidate_hard_presses(frames, forces, face)
        here = frames.contact_face == face
        inside[here] = is_in_table(spec, face, frames.contact_xy_mm[here])
    usable = frames.valid & touched.any(axis=1) & inside.all(axis=1) & (frames.place_id >= 0)
    cases = [
        whole_case(frames, usable, case) for case in np.unique(frames.place_id[usable]).tolist()
    ]
    cases = [rows for rows in cases if len(rows) >= LEAST_FRAMES]
    counts = all_counts(frames)
    used = np.concatenate(cases) if cases else np.arange(0)
    channels = np.flatnonzero(np.isfinite(counts[used]).all(axis=0)) if cases else used
    if len(cases) < LEAST_CASES or not len(channels):
        raise InputError(
            f"contacts that press together calibrate a model with {LEAST_CASES} cases (sets of contact "
            f"locations) or more of {LEAST_FRAMES} frames each, within 0.8 of the deepest simulated "
            f"press; got {len(cases)} such cases and {len(channels)} channels without gaps. Press "
            "more cases, add to press.depths_mm, or train without --twin"
        )
    levels = [np.array_split(rows, _LEVELS) for rows in cases]
    first = [rows[0] for rows in cases]
    noise = recorded_noise_counts(spec, frames)
    white = np.tile(noise**2, counts.shape[1] // 3)

    def means(of: np.ndarray) -> np.ndarray:
        return np.array([[of[level].mean(axis=0) for level in case] for case in levels])

    def noise2(level: np.ndarray) -> np.ndarray:
        zeros = len(np.unique(frames.press_id[level]))
        return (white / len(level) + spec.sensors.zeroing_counts**2 / zeros)[channels]

    mean = means(counts)
    chips = np.nan_to_num(mean).reshape(*mean.shape[:2], -1, 3)
    chip_counts = np.sqrt(np.mean(chips**2, axis=3)).repeat(3, axis=2)
    return PressedCases(
        channels,
        frames.contact_face[first],
        np.nan_to_num(frames.contact_xy_mm[first]),
        means(np.maximum(np.nan_to_num(frames.force_n[..., 2]), 0.0)),
        mean[..., channels],
        np.array([[noise2(level) for level in case] for case in levels]),
        chip_counts[..., channels],
        noise,
    )


def whole_case(frames: FrameSet, usable: np.ndarray, case: int) -> Int[np.ndarray, "row"]:
    """Rows of a case in which it has all its contacts, by growing force."""
    rows = np.flatnonzero(usable & (frames.place_id == case))
    number = np.sum(frames.contact_face[rows] != NO_FACE, axis=1)
    rows = rows[number == number.max()]
    return rows[np.argsort(np.nansum(frames.force_n[rows, :, 2], axis=1), kind="stable")]

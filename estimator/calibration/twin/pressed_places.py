"""Labelled presses of one face as mean signals by place and force, to calibrate a twin on."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Bool, Float, Int

from design.errors import InputError
from design.layout.places.contact_grid import press_lattice
from design.layout.places.contact_places import pressed_nodes
from design.spec.object import ObjectSpec
from estimator.calibration.twin.like_forces import levels_of_like_force
from estimator.frames.dataset import NO_FACE, FrameSet
from estimator.frames.press_protocol import DRIFT_TIME_S
from estimator.signals.continuation import continued
from estimator.signals.interpolation import among_pressed
from estimator.signals.press_states import ASIDE_MM, SIDES_MM
from fem.presses.results import PressForces

LEVELS = 16
"""At most; with few frames at least three make a mean."""
LEAST_PLACES = 4
LEAST_FRAMES = 12
"""Frames of a place, below which it is left out."""
MOST_PLACES = 150
"""Most places; of more, every second, third, … is used: costs grow with the cube of their number."""
REACH = 0.8
"""Share of the deepest simulated force up to which labelled ones are used."""
_STRAIGHT_NOISES = 4.0
"""Sideways force, over the load cell's noise, up to which a press counts as straight."""


@dataclass(frozen=True)
class PressedPlaces:
    """Means over frames of like force, levels by growing force.

    Attributes
    ----------
    channels : (channel,) the face's own channels without gaps, as sensor · 3 + axis
    xy_mm : (place, 2) labelled places in the face's frame
    force_n : (place, level) mean labelled force
    counts : (place, level, channel) mean change against rest
    frames : (place, level) frames in each mean
    zero_counts2 : (place, level, level) covariance of the means by errors of their zeros and by drift
        since then, a random walk. Frames share a zero that are of one session and place (simulated,
        where many presses may follow one zero), or of one press (recorded without `zero_error`)
    noise_counts : (axis,) white noise of a reading as the recording shows it; None or NaN: the
        specification's
    """

    face: int
    channels: Int[np.ndarray, "channel"]
    xy_mm: Float[np.ndarray, "place 2"]
    force_n: Float[np.ndarray, "place level"]
    counts: Float[np.ndarray, "place level channel"]
    frames: Int[np.ndarray, "place level"]
    zero_counts2: Float[np.ndarray, "place level level"]
    noise_counts: Float[np.ndarray, "3"] | None = None

    def __len__(self) -> int:
        return len(self.xy_mm)

    def select_places(
        self, places: Int[np.ndarray, "some"] | Bool[np.ndarray, "place"]
    ) -> PressedPlaces:
        """Some of the places."""
        names = ("xy_mm", "force_n", "counts", "frames", "zero_counts2")
        return replace(self, **{name: getattr(self, name)[places] for name in names})

    def white_counts2(self, spec: ObjectSpec) -> Float[np.ndarray, "place level channel"]:
        """Variance of each mean alone: noise of its frames, and of their labelled forces through the
        signal's slope."""
        force_noise = spec.protocol.force_noise_n
        white = white_noise_counts(spec, self.noise_counts)[self.channels % 3]
        slope = self.counts / np.maximum(self.force_n, 3 * force_noise)[..., None]
        return (white**2 + (force_noise * slope) ** 2) / self.frames[..., None]


def white_noise_counts(
    spec: ObjectSpec, recorded: Float[np.ndarray, "3"] | None
) -> Float[np.ndarray, "3"]:
    """Return the white noise of a reading as recorded, or the specification's where none was."""
    noise = np.asarray(spec.sensors.noise_counts, float)
    return noise if recorded is None else np.where(np.isfinite(recorded), recorded, noise)


def recorded_noise_counts(spec: ObjectSpec, frames: FrameSet) -> Float[np.ndarray, "3"]:
    """White noise of a reading that frames show; simulated ones have the specification's."""
    return white_noise_counts(spec, frames.noise_counts if frames.source == "recorded" else None)


def is_in_table(
    spec: ObjectSpec, face: int, xy_mm: Float[np.ndarray, "press 2"]
) -> Bool[np.ndarray, "press"]:
    """Return which presses of a face, and those a little aside, lie within the table."""
    lattice, pressed = press_lattice(spec), pressed_nodes(spec)[spec.body.sensed.index(face)]
    within = (abs(xy_mm) <= -lattice.xy_mm.min(axis=0) - ASIDE_MM).all(axis=1)
    for side in SIDES_MM:
        within &= among_pressed(lattice, pressed, *(np.nan_to_num(xy_mm) + side).T)
    return within


def invalidate_hard_presses(frames: FrameSet, forces: PressForces, face: int) -> FrameSet:
    """The frames, of which those are invalid that press the face harder than 0.8 of the deepest
    simulated press there: an object may be so much softer than its design."""
    from scipy.interpolate import RegularGridInterpolator

    lattice, deepest = forces.lattice, forces.force_n[forces.faces == face][0, :, -1]
    deepest = continued(deepest, ~np.isnan(deepest), lattice.shape)
    reach_n = RegularGridInterpolator(
        (lattice.x_mm, lattice.y_mm),
        deepest.reshape(lattice.shape),
        bounds_error=False,
        fill_value=0.0,
    )
    on_face = frames.contact_face == face
    beyond = frames.force_n[..., 2] > REACH * reach_n(np.nan_to_num(frames.contact_xy_mm))
    return replace(frames, valid=frames.valid & ~(on_face & beyond).any(axis=1))


def pressed_places(spec: ObjectSpec, frames: FrameSet, face: int) -> PressedPlaces:
    """Frames in which one tip presses this face straight down and nothing else does, up to 16 means
    a place (`place_id`). Places beyond the simulated lattice are left out.

    Raises
    ------
    InputError
        Fewer than four places with 12 such frames each, or no channel of the face without gaps.
    """
    touched = frames.contact_face != NO_FACE
    slot, frame = touched.argmax(axis=1), np.arange(len(frames))
    force, xy = frames.force_n[frame, slot], frames.contact_xy_mm[frame, slot]
    face_counts = frames.signal_counts[:, np.flatnonzero(frames.faces == face)]
    face_counts = face_counts.reshape(len(frames), 3 * spec.sensors.count_per_face)
    straight = np.hypot(force[:, 0], force[:, 1]) <= _STRAIGHT_NOISES * spec.protocol.force_noise_n
    alone = frames.valid & (touched.sum(axis=1) == 1) & (frames.contact_face[frame, slot] == face)
    alone &= straight & np.isfinite(face_counts).any(axis=1) & is_in_table(spec, face, xy)
    force, xy, face_counts = force[alone, 2], xy[alone], face_counts[alone]
    zeroed = (frames.press_id if frames.source == "recorded" else frames.session_id)[alone]
    channels = (
        np.flatnonzero(np.isfinite(face_counts).all(axis=0)) if len(face_counts) else np.arange(0)
    )
    which, press, time_s = (
        values[alone] for values in (frames.place_id, frames.press_id, frames.time_s)
    )
    error = None if frames.zero_error is None else frames.zero_error[alone]
    zeroed = frames.session_id[alone] if error is not None else zeroed
    rows = [np.flatnonzero(which == number) for number in np.unique(which)]
    rows = [row[np.lexsort((time_s[row], press[row]))] for row in rows if len(row) >= LEAST_FRAMES]
    if len(rows) < LEAST_PLACES or not len(channels):
        pressed = frames.valid & (frames.contact_face == face).any(axis=1)
        elsewhere, sideways = (
            int((pressed & (touched.sum(axis=1) > 1)).sum()),
            int((pressed & ~straight).sum()),
        )
        gaps = (
            "" if len(channels) or not alone.any() else "; no channel of the face is without gaps"
        )
        raise InputError(
            f"a twin of face {face} is calibrated on presses straight down by one tip alone, at "
            f"{LEAST_PLACES} places or more with {LEAST_FRAMES} frames each; got {len(rows)} such "
            f"places: of {int(pressed.sum())} frames that press this face {elsewhere} press elsewhere too, "
            f"{sideways} pull sideways{gaps}. Press more places one by one, or invert the design: "
            "instobj train SPEC"
        )
    rows = rows[:: -(-len(rows) // MOST_PLACES)]
    count = min(LEVELS, min(len(row) for row in rows) // 3)
    noise = spec.protocol.force_noise_n
    levels = [
        [row[level] for level in levels_of_like_force(force[row], press[row], noise, count)]
        for row in rows
    ]
    return PressedPlaces(
        face,
        channels,
        np.array([np.median(xy[row], axis=0) for row in rows]),
        np.maximum([[force[level].mean() for level in place] for place in levels], 0.0),
        np.array(
            [[face_counts[level][:, channels].mean(axis=0) for level in place] for place in levels]
        ),
        np.array([[len(level) for level in place] for place in levels]),
        np.array([drifting_zeros(spec, zeroed, time_s, place, error) for place in levels]),
        frames.noise_counts if frames.source == "recorded" else None,
    )


def drifting_zeros(
    spec: ObjectSpec,
    zeroed: Int[np.ndarray, "frame"],
    time_s: Float[np.ndarray, "frame"],
    levels: list[Int[np.ndarray, "_"]],
    error: Float[np.ndarray, "frame 2"] | None = None,
) -> Float[np.ndarray, "level level"]:
    """Covariance (counts²) of means by errors of their zeros, those of `zeroed` on their own each.

    By `FrameSet.zero_error`; without it by `zeroing_counts` and drift, a random walk since the first frame
    of a zero: levels far apart in time have less of it in common.
    """
    frames = np.concatenate(levels)
    level = np.repeat(np.arange(len(levels)), [len(rows_of_level) for rows_of_level in levels])
    weight = (level == np.arange(len(levels))[:, None]) / [
        [len(rows_of_level)] for rows_of_level in levels
    ]
    covariance = np.zeros((len(levels), len(levels)))
    for name in np.unique(zeroed[frames]):
        mine = np.flatnonzero(zeroed[frames] == name)
        mine = mine[np.argsort(time_s[frames[mine]])]
        frame_weights, rows = weight[:, mine], frames[mine]
        if error is not None:
            covariance += remembered_places(frame_weights, *error[rows].T)
            continue
        later = np.cumsum(frame_weights[:, ::-1], axis=1)[:, ::-1]
        since_s = time_s[rows] - time_s[rows[0]]
        covariance += drift_rate(spec) * (later * np.diff(since_s, prepend=0.0)) @ later.T
        covariance += spec.sensors.zeroing_counts**2 * np.outer(
            frame_weights.sum(axis=1), frame_weights.sum(axis=1)
        )
    return covariance


def remembered_places(
    weight: Float[np.ndarray, "level frame"],
    variance: Float[np.ndarray, "frame"],
    memory: Float[np.ndarray, "frame"],
) -> Float[np.ndarray, "level level"]:
    """Covariance of weighted sums of errors of growing memory."""
    half = np.zeros((len(weight), len(weight)))
    earlier, kept = np.zeros(len(weight)), np.exp(-np.diff(memory, prepend=memory[0]))
    for frame_weights, frame_variance, share in zip(weight.T, variance, kept, strict=True):
        earlier = earlier * share + frame_weights / 2
        half += frame_variance * np.outer(earlier, frame_weights)
        earlier = earlier + frame_weights / 2
    return half + half.T


def drift_rate(spec: ObjectSpec) -> float:
    """Return the growth of the variance of the drift (counts² per second)."""
    return spec.sensors.drift_counts**2 / DRIFT_TIME_S

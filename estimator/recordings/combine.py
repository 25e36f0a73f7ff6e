"""Combination of several recordings of one object into one data set."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from jaxtyping import Bool

from design.errors import InputError
from estimator.frames.dataset import NO_FACE, PER_FRAME_FIELDS, FrameSet
from estimator.recordings.checks.faults import Fault, jumped_channels, rows_text
from estimator.recordings.checks.readings import copied_rows
from estimator.recordings.contacts import Place
from estimator.recordings.reading import Recording
from estimator.recordings.table import channel_name


def combine(recordings: Sequence[Recording]) -> FrameSet:
    """One data set with unique press, place and session ids.

    Channels whose rest level jumped between the recordings (`jumps_between`) are NaN throughout; frames
    that an earlier recording has too are not valid; lag and noise are medians over the recordings.

    Raises
    ------
    InputError
        No recording, the same content twice, or recordings with other sensors, grids or labels.
    """
    digests = [recording.frames.spec_hash for recording in recordings]
    if not recordings or len(set(digests)) < len(digests):
        raise InputError(
            f"combining needs recordings, each given once; got {len(recordings)} with "
            f"{len(set(digests))} different contents. Remove the repeats"
        )
    grids = {(*r.frames.grid_x_mm.tolist(), None, *r.frames.grid_y_mm.tolist()) for r in recordings}
    if len(grids) > 1:
        raise InputError(
            f"combining needs recordings on one contact grid; got {len(grids)}. Give --spec, the "
            "specification of the object"
        )
    jumped = jumps_between(recordings)
    places = sorted({place for recording in recordings for place in recording.report.places})
    contacts = max(recording.frames.contact_face.shape[1] for recording in recordings)
    parts, press, session = [], 0, 0
    for recording in recordings:
        parts.append(_renumbered(recording, places, contacts, press, session))
        press += int(recording.frames.press_id.max()) + 1
        session += int(recording.frames.session_id.max()) + 1
    joined = {
        name: np.concatenate([getattr(part, name) for part in parts]) for name in PER_FRAME_FIELDS
    }
    joined["valid"] = joined["valid"] & ~_copied(recordings)[0]
    joined["signal_counts"][:, jumped] = np.nan
    by_travel = [part.travel_mm for part in parts if part.travel_mm is not None]
    if by_travel and len(by_travel) < len(parts):
        raise InputError(
            f"{len(by_travel)} of {len(parts)} recordings are labelled by travel. Combine those of one label"
        )
    errors = [part.zero_error for part in parts if part.zero_error is not None]
    return replace(
        parts[0],
        **joined,
        zero_error=np.concatenate(errors) if len(errors) == len(parts) else None,
        travel_mm=np.concatenate(by_travel) if by_travel else None,
        noise_counts=np.median([part.noise_counts for part in parts], axis=0),
        spec_hash="+".join(digests) if len(digests) > 1 else digests[0],
        lag_frames=round(float(np.median([part.lag_frames for part in parts]))),
    )


def jumps_between(recordings: Sequence[Recording]) -> Bool[np.ndarray, "face sensor 3"]:
    """Channels whose rest level jumped between any two recordings: another magnet or sensor.

    Raises
    ------
    InputError
        The recordings have different numbers of faces or sensors.
    """
    layouts = sorted({recording.rest_counts.shape[1:3] for recording in recordings})
    if len(layouts) > 1:
        sizes = " and ".join(f"{faces} × {sensors}" for faces, sensors in layouts)
        raise InputError(
            f"the recordings have channels of {sizes} (faces × sensors of a face), so they are of "
            "different objects. Give recordings of one"
        )
    levels = [np.median(recording.rest_counts, axis=0) for recording in recordings]
    jumped = [jumped_channels(levels[0], level) for level in levels]
    return np.any(jumped, axis=0)


def _copied(recordings: Sequence[Recording]) -> tuple[Bool[np.ndarray, "frame"], list[Fault]]:
    """Frames of which the raw counts of a face were there before, whatever their zeros and labels."""
    together = np.concatenate(
        [
            np.full(recording.frames.signal_counts.shape[:2], np.nan)
            if recording.prints is None
            else recording.prints
            for recording in recordings
        ]
    )
    copied = np.zeros(len(together), bool)
    for face in together.T:
        rows = np.repeat(face[:, None, None, None], 3, axis=3)
        copied |= copied_rows(rows)[0].any(axis=(1, 2, 3))
    if not copied.any():
        return copied, []
    detail = f"{copied.sum()} of these frames are in an earlier recording, too, number for number"
    where = f"{rows_text(np.flatnonzero(copied))} of all recordings together"
    return copied, [Fault("copied rows", where, detail, "copies not used")]


def faults_between(recordings: Sequence[Recording]) -> list[Fault]:
    """The channels of `jumps_between`, with their rest levels in each recording, and copied frames, by
    their rows of all recordings together."""
    levels = [np.median(recording.rest_counts, axis=0) for recording in recordings]
    faults = []
    for index in np.argwhere(jumps_between(recordings)).tolist():
        shown = " → ".join(f"{level[tuple(index)]:.0f}" for level in levels)
        where = f"{channel_name(*index)}, between the recordings"
        faults.append(Fault("jumping channel", where, f"rest level {shown} counts", "set to NaN"))
    return faults + _copied(recordings)[1]


def _renumbered(
    recording: Recording, places: list[Place], contacts: int, press: int, session: int
) -> FrameSet:
    frames = recording.frames
    new_id = np.array([*(places.index(place) for place in recording.report.places), -1])
    missing = contacts - frames.contact_face.shape[1]
    pad = ((0, 0), (0, missing))
    return replace(
        frames,
        contact_face=np.pad(frames.contact_face, pad, constant_values=NO_FACE),
        contact_xy_mm=np.pad(frames.contact_xy_mm, (*pad, (0, 0)), constant_values=np.nan),
        force_n=np.pad(frames.force_n, (*pad, (0, 0)), constant_values=np.nan),
        press_id=frames.press_id + press,
        place_id=new_id[frames.place_id],
        session_id=frames.session_id + session,
    )

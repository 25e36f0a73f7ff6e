"""Recordings of the real object as data sets: faults found, lag corrected, presses zeroed.

Format and faults: `estimator.recording_files` and `estimator.recording_faults`. Every correction
is stated in the report; nothing is keyed to a file's name.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from jaxtyping import Bool, Float, Int

from design.errors import InputError
from estimator.dataset import NO_FACE, PER_FRAME_FIELDS, FrameSet
from estimator.heatmap import NO_CONTACT_LABELS, label_grid_mm
from estimator.recording_contacts import Place, contact_cases, contact_slots
from estimator.recording_faults import (
    Fault,
    axis_noise_counts,
    channel_faults,
    channel_name,
    dead_channels,
    doubtful_presses,
    jumped_channels,
    mend_face_labels,
    mirror_faults,
    noisy_channels,
    press_responses,
    rest_noise_counts,
    stamp_faults,
)
from estimator.recording_files import FACES, RawTable, read_table
from estimator.recording_presses import (
    CONTACT_FORCE_N,
    LagReport,
    at_rest,
    estimate_lag,
    frame_times_s,
    number_presses,
    shifted_forces,
    stretches,
    tared,
)
from estimator.recording_report import RecordingReport

NOMINAL_RATE_HZ = 10.5
REST_FORCE_N = {"gripper": 0.05, "training": 0.15}
"""Forces below are rest. The training files' converter resolves only about 0.12 N."""
ZERO_FRAMES = 20
LEAST_ZERO_FRAMES = 5
_UNITS = {
    "gripper": "grams-force × 9.8e-3 = N",
    "training": "N, counted from the rest level",
}


@dataclass(frozen=True)
class Recording:
    """Frames of one file with its report.

    `rest_counts` (press, face, sensor, axis) are the raw counts subtracted from each press.
    """

    frames: FrameSet
    report: RecordingReport
    rest_counts: Float[np.ndarray, "press 5 3 3"]


@dataclass(frozen=True)
class _Presses:
    """A table after its force and labels were brought into line with its signals."""

    time_s: Float[np.ndarray, "frame"]
    rate_hz: float
    press: Int[np.ndarray, "frame"]
    force_n: Float[np.ndarray, "frame cell"]
    rest: Bool[np.ndarray, "frame"]
    face: Int[np.ndarray, "frame cell"]
    doubtful: Bool[np.ndarray, "frame"]
    lag: LagReport
    faults: tuple[Fault, ...]


def read_recording(path: Path | str) -> Recording:
    """Read a gripper or training recording, find and correct its faults.

    Raises
    ------
    InputError
        The file is missing or damaged, or holds no press or no rest.
    """
    table = read_table(path)
    presses = _find_presses(path, table)
    zero, zeroed_after = _rest_levels(path, table.counts, presses)
    noise = rest_noise_counts(table.counts, presses.rest)
    session, place, places = contact_cases(
        presses.face, table.position_label, presses.force_n >= CONTACT_FORCE_N
    )
    frames = _frames(table, presses, zero, noise, session, place)
    faults = (
        *stamp_faults(table),
        *channel_faults(table.counts, noise),
        *presses.faults,
        *mirror_faults(presses.face, table.position_label, session),
    )
    report = RecordingReport(
        path=str(path),
        kind=table.kind,
        frames=len(frames),
        contact_frames=int(np.sum(frames.valid & ~presses.rest)),
        rest_frames=int(np.sum(frames.valid & presses.rest)),
        unused_frames=int(np.sum(~frames.valid)),
        faces_pressed=tuple(int(f) for f in np.unique(presses.face)),
        tips=table.position_label.shape[2],
        presses=int(presses.press.max()) + 1,
        sessions=int(session.max()) + 1,
        places=places,
        frame_rate_hz=presses.rate_hz,
        units=_UNITS[table.kind],
        lag=presses.lag,
        noise_counts=_by_name(noise),
        presses_zeroed_after=zeroed_after,
        faults=faults,
    )
    return Recording(frames, report, zero)


def _find_presses(path: Path | str, table: RawTable) -> _Presses:
    labels = table.position_label.reshape(len(table.force_n), -1)
    stretch = stretches(table.time_s, np.column_stack([table.case_label, table.face_label, labels]))
    time_s, rate_hz = frame_times_s(table.time_s, stretch, NOMINAL_RATE_HZ)
    limit_n = REST_FORCE_N[table.kind]
    no_contact = np.all(np.isin(labels, NO_CONTACT_LABELS), axis=1)
    force_n = tared(table.force_n, no_contact, limit_n, signed=table.kind == "gripper")
    if force_n.max() < CONTACT_FORCE_N:
        raise InputError(
            f"{path} holds no press: the largest force is {force_n.max():.3g} N, a contact needs "
            f"{CONTACT_FORCE_N} N. Give a recording with presses"
        )
    press = number_presses(force_n, stretch, limit_n)
    responses = press_responses(table.counts, force_n, press)
    face, mended = mend_face_labels(table, press, responses)
    doubtful, doubts = doubtful_presses(face, press, responses)
    lag = estimate_lag(table.counts, force_n, face, press)
    aligned_n = shifted_forces(force_n, stretch, lag.frames if lag.corrected else 0)
    return _Presses(
        time_s, rate_hz, press, aligned_n, at_rest(aligned_n, limit_n), face, doubtful, lag,
        (*mended, *doubts),
    )  # fmt: skip


def _rest_levels(
    path: Path | str, counts: Float[np.ndarray, "frame 5 3 3"], presses: _Presses
) -> tuple[Float[np.ndarray, "press 5 3 3"], int]:
    """Mean counts of up to `ZERO_FRAMES` rest frames before each press, and how many presses had
    too few of them and took the rest that follows instead."""
    rest = np.flatnonzero(presses.rest)
    if len(rest) < LEAST_ZERO_FRAMES:
        raise InputError(
            f"{path} holds {len(rest)} frames at rest; at least {LEAST_ZERO_FRAMES} are needed to "
            "zero the signals. Record some frames before each press"
        )
    levels, after = [], 0
    loaded = np.any(presses.force_n >= CONTACT_FORCE_N, axis=1)
    for number in range(int(presses.press.max()) + 1):
        frames = np.flatnonzero(presses.press == number)
        begin = frames[loaded[frames]][0] if loaded[frames].any() else frames[-1] + 1
        split = int(np.searchsorted(rest, begin))
        chosen = rest[max(0, split - ZERO_FRAMES) : split]
        if len(chosen) < LEAST_ZERO_FRAMES:
            chosen, after = rest[split : split + ZERO_FRAMES], after + 1
        if len(chosen) < LEAST_ZERO_FRAMES:
            chosen = rest[-ZERO_FRAMES:]
        levels.append(counts[chosen].mean(axis=0))
    return np.array(levels), after


def _frames(
    table: RawTable,
    presses: _Presses,
    zero: Float[np.ndarray, "press 5 3 3"],
    noise: Float[np.ndarray, "5 3 3"],
    session: Int[np.ndarray, "frame"],
    place: Int[np.ndarray, "frame"],
) -> FrameSet:
    grid_x_mm, grid_y_mm = label_grid_mm()
    signal = table.counts - zero[presses.press]
    unusable = dead_channels(table.counts) | noisy_channels(noise)
    gap = np.any(np.isnan(table.counts) & ~unusable & _recorded(table.counts), axis=(1, 2, 3))
    signal[:, unusable] = np.nan
    touching = presses.force_n >= CONTACT_FORCE_N
    clear = presses.rest | touching.all(axis=1)
    contact_face, xy_mm, contact_n = contact_slots(
        presses.face, table.position_label, presses.force_n, touching
    )
    return FrameSet(
        signal_counts=signal,
        contact_face=contact_face,
        contact_xy_mm=xy_mm,
        force_n=contact_n,
        valid=clear & ~presses.doubtful & ~gap,
        press_id=presses.press,
        place_id=place,
        session_id=session,
        time_s=presses.time_s,
        faces=np.array(FACES),
        grid_x_mm=grid_x_mm,
        grid_y_mm=grid_y_mm,
        noise_counts=axis_noise_counts(noise),
        source="recorded",
        spec_hash=table.digest,
        seed=0,
        lag_frames=presses.lag.frames if presses.lag.corrected else 0,
    )


def _recorded(counts: Float[np.ndarray, "frame 5 3 3"]) -> Bool[np.ndarray, "frame 5 1 1"]:
    """Which faces have readings in each frame: a training frame has those of one face."""
    return np.any(np.isfinite(counts), axis=(2, 3), keepdims=True)


def _by_name(noise: Float[np.ndarray, "5 3 3"]) -> dict[str, float | None]:
    return {
        channel_name(*index): None if np.isnan(value) else round(float(value), 2)
        for index, value in np.ndenumerate(noise)
    }


def combine(recordings: Sequence[Recording]) -> FrameSet:
    """One data set with unique press, place and session ids.

    Channels whose rest level jumped between the recordings (`jumps_between`) are NaN throughout;
    lag and noise are medians over the recordings.

    Raises
    ------
    InputError
        No recording, or the same file twice.
    """
    digests = [recording.frames.spec_hash for recording in recordings]
    if not recordings or len(set(digests)) < len(digests):
        raise InputError(
            f"combining needs recordings, each given once; got {len(recordings)} with "
            f"{len(set(digests))} different contents. Remove the repeats"
        )
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
    joined["signal_counts"][:, jumps_between(recordings)] = np.nan
    return replace(
        parts[0],
        **joined,
        noise_counts=np.median([part.noise_counts for part in parts], axis=0),
        spec_hash="+".join(digests) if len(digests) > 1 else digests[0],
        lag_frames=round(float(np.median([part.lag_frames for part in parts]))),
    )


def jumps_between(recordings: Sequence[Recording]) -> Bool[np.ndarray, "5 3 3"]:
    """Channels whose rest level jumped between any two recordings: another magnet or sensor."""
    levels = [np.median(recording.rest_counts, axis=0) for recording in recordings]
    jumped = [jumped_channels(levels[0], level) for level in levels]
    return np.any(jumped, axis=0)


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

"""Recordings of the real object as data sets: faults found, lag corrected, presses zeroed.

Formats: `estimator.recordings.formats.files`; faults: `estimator.recordings.checks.faults`
(channels, faces, stamps) and `estimator.recordings.checks.labels` (contacts and places). Every correction
is stated in the report; nothing is keyed to a file's name.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from jaxtyping import Bool, Float, Int

from design.errors import RecordingError
from estimator.frames.dataset import NO_FACE, FrameSet
from estimator.recordings.checks.cells import check_rate, repaired_forces, wrong_forces
from estimator.recordings.checks.faults import (
    Fault,
    axis_noise_counts,
    correct_face_labels,
    dead_channels,
    dead_faults,
    jump_faults,
    mirror_faults,
    noisy_channels,
    noisy_faults,
    press_responses,
    rest_noise_counts,
    stamp_faults,
    unread_faces,
)
from estimator.recordings.checks.labels import place_label_faults
from estimator.recordings.checks.limits import (
    Limits,
    limit_to_range,
    places_off_the_body,
    usual_limits,
)
from estimator.recordings.checks.readings import without_faults
from estimator.recordings.checks.repeats import Repeats, repeat_faults, repeated_readings
from estimator.recordings.checks.table import PRESSES, RESTS, Judged, judged, spoilt_channels
from estimator.recordings.checks.turned import turned_channels, turned_forces
from estimator.recordings.contacts import (
    Place,
    block_numbers,
    carried_labels,
    contact_cases,
    contact_slots,
    place_keys,
)
from estimator.recordings.drift import levels_under_presses
from estimator.recordings.formats.files import read_table
from estimator.recordings.formats.text import naming
from estimator.recordings.presses import (
    CONTACT_FORCE_N,
    LagReport,
    estimate_lag,
    frame_times_s,
    is_at_rest,
    number_presses,
    rest_limit_n,
    shifted_forces,
    shifted_shear,
    stretches,
    tared,
)
from estimator.recordings.report import RecordingReport, noise_by_name
from estimator.recordings.table import FACES, RawTable
from estimator.recordings.zeros import Zeros, rest_levels

NOMINAL_RATE_HZ = 10.5
REST_FORCE_N = {"gripper": 0.05, "training": 0.15, "generic": 0.15}
"""Forces below are rest. The training files' converter resolves only about 0.12 N."""
_UNITS = {
    "gripper": "grams-force × 9.8e-3 = N",
    "training": "N, counted from the rest level",
    "generic": "N, counted from the rest level",
}


Grid = tuple[Float[np.ndarray, "nx"], Float[np.ndarray, "ny"]]


@dataclass(frozen=True, repr=False)
class Recording:
    """Frames of one file with its report.

    `rest_counts` (press, face, sensor, axis) are the raw counts at rest next to each press: subtracted
    from it, but in generic recordings, whose level is followed frame by frame.
    """

    frames: FrameSet
    report: RecordingReport
    rest_counts: Float[np.ndarray, "press 5 sensor 3"]

    def __repr__(self) -> str:
        return str(self.report)


@dataclass(frozen=True)
class _Presses:
    """A table after its force and labels were brought into line with its signals.

    `doubtful` marks frames whose labels a check names, `hidden` those at rest by the load cells in which
    the signals show a contact.
    """

    time_s: Float[np.ndarray, "frame"]
    rate_hz: float
    press: Int[np.ndarray, "frame"]
    force_n: Float[np.ndarray, "frame cell"]
    shear_n: Float[np.ndarray, "frame cell 2"]
    rest: Bool[np.ndarray, "frame"]
    hidden: Bool[np.ndarray, "frame"]
    face: Int[np.ndarray, "frame cell"]
    tip_xy_mm: Float[np.ndarray, "frame cell tip 2"]
    doubtful: Bool[np.ndarray, "frame"]
    repeats: Repeats
    noise_counts: Float[np.ndarray, "5 sensor 3"]
    lag: LagReport
    faults: tuple[Fault, ...]


def read_recording(
    path: Path | str, grid_mm: Grid | None = None, limits: Limits | None = None
) -> Recording:
    """Read a recording of any format, find and correct its faults.

    Parameters
    ----------
    path : path
        CSV or NetCDF (`instobj docs recordings` describes the formats).
    grid_mm : pair of arrays (nx,), (ny,), optional
        x and y of the contact grid on which heatmaps will be drawn, mm; by default that of the file,
        or 10 × 10 places 3 mm apart.
    limits : Limits, optional
        What the object's chips and faces can show, by default a chip of 16 bits and three times the
        grid's reach.

    Returns
    -------
    Recording
        `frames`, a data set of changes against rest (counts), contacts (mm, N) and which frames are
        valid; `report`, what was found and done (print it); `rest_counts`, counts at rest.

    Raises
    ------
    RecordingError
        The file is missing or damaged, or holds no press or no rest.
    """
    table = read_table(path)
    if grid_mm is not None:
        table = replace(table, grid_x_mm=grid_mm[0], grid_y_mm=grid_mm[1])
    limits = limits or usual_limits(table)
    with naming(path):
        table, left_out, unreadable = _believed(table, limits)
        presses = _find_presses(table)
        zeros = rest_levels(
            table.counts,
            presses.press,
            np.any(presses.force_n >= CONTACT_FORCE_N, axis=1),
            presses.rest & ~presses.hidden,
        )
    zero, zeroed_after = zeros.counts, int(np.sum(~zeros.is_before))
    jumping, jumps = jump_faults(zero)
    block, place, places = contact_cases(
        presses.face, presses.tip_xy_mm, presses.force_n >= CONTACT_FORCE_N
    )
    session = np.unique(table.case, return_inverse=True)[1] if table.kind == "generic" else block
    frames = _frames(table, presses, zeros, jumping | left_out, session, place)
    turned, turns = turned_channels(frames)
    frames.signal_counts[:, turned] = np.nan
    off, off_faults = places_off_the_body(presses.tip_xy_mm, limits)
    wrong, place_faults = place_label_faults(frames, places)
    frames = replace(frames, valid=frames.valid & ~wrong & ~off)
    faults = (
        *stamp_faults(table),
        *unreadable,
        *repeat_faults(presses.repeats, presses.rate_hz),
        *noisy_faults(presses.noise_counts),
        *jumps,
        *turns,
        *presses.faults,
        *off_faults,
        *place_faults,
        *(mirror_faults(presses.face, presses.tip_xy_mm, block) if table.kind == "gripper" else ()),
    )
    report = _report(path, table, presses, frames, places, zeroed_after, faults)
    return Recording(frames, report, zero)


def _believed(
    table: RawTable, limits: Limits
) -> tuple[RawTable, Bool[np.ndarray, "5 sensor 3"], list[Fault]]:
    """The table without readings that a check names, channels to leave out, and what was named."""
    raw = table.counts
    if not np.isfinite(raw).any():
        raise RecordingError(
            f"no channel has a reading in any of its {len(raw)} frames. Check the sensors' wiring (`instobj "
            "bench bringup`) and record anew"
        )
    counts, faults = without_faults(raw)
    if not np.isfinite(counts).any():
        raise RecordingError(f"no reading is left: {'; '.join(map(str, faults[:3]))}")
    spoilt, left_out = spoilt_channels(counts, np.isfinite(raw) & np.isnan(counts))
    table, unreachable = limit_to_range(replace(table, counts=counts), limits)
    faults_found = [
        *faults,
        *unreachable,
        *left_out,
        *dead_faults(raw),
        *unread_faces(raw, table.face),
    ]
    return table, spoilt | dead_channels(raw), faults_found


def _report(
    path: Path | str,
    table: RawTable,
    presses: _Presses,
    frames: FrameSet,
    places: tuple[Place, ...],
    zeroed_after: int,
    faults: tuple[Fault, ...],
) -> RecordingReport:
    read = np.isfinite(table.counts).any(axis=(1, 2, 3))  # copied presses were read before
    return RecordingReport(
        path=str(path),
        kind=table.kind,
        frames=len(frames),
        contact_frames=int(np.sum(frames.valid & ~presses.rest)),
        rest_frames=int(np.sum(frames.valid & presses.rest)),
        unused_frames=int(np.sum(~frames.valid)),
        faces_pressed=tuple(int(f) for f in np.unique(presses.face) if f != NO_FACE),
        tips=table.tip_xy_mm.shape[2],
        presses=len(
            np.unique(presses.press[(presses.force_n >= CONTACT_FORCE_N).any(axis=1) & read])
        ),
        sessions=len(np.unique(frames.session_id)),
        places=places,
        frame_rate_hz=presses.rate_hz,
        units=_UNITS[table.kind],
        lag=presses.lag,
        largest_force_n=float(np.nanmax(presses.force_n)),
        noise_counts=noise_by_name(presses.noise_counts),
        presses_zeroed_after=zeroed_after,
        faults=faults,
    )


def _find_presses(table: RawTable) -> _Presses:
    label_face, tip_xy_mm = table.face, table.tip_xy_mm
    no_contact = table.declared_rest | np.all(np.isnan(tip_xy_mm), axis=(1, 2, 3))
    if table.kind == "generic":
        label_face, tip_xy_mm = carried_labels(label_face, tip_xy_mm, table.case)
    table = replace(table, face=label_face, tip_xy_mm=tip_xy_mm)
    keys = np.column_stack([table.case, place_keys(label_face, tip_xy_mm)])
    stretch = stretches(table.time_s, keys)
    time_s, rate_hz = frame_times_s(table.time_s, stretch, NOMINAL_RATE_HZ)
    check_rate(rate_hz)
    limit_n = REST_FORCE_N[table.kind]
    block = block_numbers(keys)
    wrong, misread = wrong_forces(table.force_n)
    measured_n, turns = repaired_forces(table.force_n, wrong), []
    if table.kind != "training":
        measured_n, turns = turned_forces(measured_n, table.counts, label_face, block, limit_n)
    force_n = tared(measured_n, no_contact, limit_n, signed=table.kind != "training")
    if force_n.max() < CONTACT_FORCE_N:
        raise RecordingError(
            f"it holds no press: the largest force is {force_n.max():.3g} N, a contact needs "
            f"{CONTACT_FORCE_N} N. Give a recording with presses"
        )
    press = number_presses(force_n, stretch, limit_n)
    responses = press_responses(table.counts, force_n, press)
    face, corrected = correct_face_labels(table, press, responses)
    lag = estimate_lag(table.counts, force_n, face, press, stretch)
    late = lag.frames if lag.corrected else 0
    aligned_n = shifted_forces(force_n, stretch, late)
    unsure = np.any(shifted_forces(wrong.astype(float), stretch, late) > 0, axis=1)
    rest = is_at_rest(aligned_n, limit_n)
    shear_n = np.zeros((*aligned_n.shape, 2))
    if table.shear_n is not None:
        shear_n = shifted_shear(table.shear_n, stretch, late, rest)
    repeats = repeated_readings(table.counts)
    noise = rest_noise_counts(table.counts, rest, repeats.stale)
    case = Judged(
        table, face, force_n, press, responses, no_contact, rest, stretch, block, noise
    )  # fmt: skip
    (named, press_faults), (hidden, concealed) = judged(case, PRESSES), judged(case, RESTS)
    return _Presses(
        time_s, rate_hz, press, aligned_n, shear_n, rest, hidden, face, tip_xy_mm, named | hidden | unsure,
        repeats, noise, lag, (*misread, *turns, *corrected, *press_faults, *concealed),
    )  # fmt: skip


def _frames(
    table: RawTable,
    presses: _Presses,
    zeros: Zeros,
    left_out: Bool[np.ndarray, "5 sensor 3"],
    session: Int[np.ndarray, "frame"],
    place: Int[np.ndarray, "frame"],
) -> FrameSet:
    touching = presses.force_n >= CONTACT_FORCE_N
    if table.kind == "generic":
        levels = levels_under_presses(
            table.counts, presses.time_s, session, np.any(touching, axis=1),
            is_at_rest(presses.force_n, rest_limit_n(presses.force_n))
            & ~presses.hidden & ~presses.repeats.rows,
            presses.noise_counts,
        )  # fmt: skip
        zero, error = levels.counts, levels.error
    else:
        zero, error = zeros.counts[presses.press], None
    signal = table.counts - zero
    unusable = noisy_channels(presses.noise_counts) | left_out
    gap = np.any(np.isnan(table.counts) & ~unusable & _recorded(table), axis=(1, 2, 3))
    gap |= ~np.isfinite(table.counts).any(axis=(1, 2, 3))
    signal[:, unusable] = np.nan
    alone = table.kind == "generic"  # a gripper's jaws press together, other load cells may rest
    still = alone & (np.abs(presses.force_n) < REST_FORCE_N[table.kind])
    clear = presses.rest | (touching | still).all(axis=1)
    contact_face, xy_mm, contact_n = contact_slots(
        presses.face, presses.tip_xy_mm, presses.force_n, presses.shear_n, touching
    )
    return FrameSet(
        signal_counts=signal,
        contact_face=contact_face,
        contact_xy_mm=xy_mm,
        force_n=contact_n,
        valid=clear & ~presses.doubtful & ~gap & ~presses.repeats.rows,
        press_id=presses.press,
        place_id=place,
        session_id=session,
        time_s=presses.time_s,
        faces=np.array(FACES),
        grid_x_mm=table.grid_x_mm,
        grid_y_mm=table.grid_y_mm,
        noise_counts=axis_noise_counts(presses.noise_counts),
        source="recorded",
        spec_hash=table.digest,
        seed=0,
        lag_frames=presses.lag.frames if presses.lag.corrected else 0,
        zero_error=error,
    )


def _recorded(table: RawTable) -> Bool[np.ndarray, "frame 5 1 1"]:
    """Return which faces ought to have readings in each frame: faces that ever have, in a training file
    the one of the frame."""
    has_reading = np.any(np.isfinite(table.counts), axis=(2, 3), keepdims=True)
    if table.kind == "training":
        return has_reading
    return np.broadcast_to(has_reading.any(axis=0), has_reading.shape)

"""Recordings of the real object as data sets: faults found, lag corrected, presses zeroed.

Formats: `estimator.recordings.formats.files`; faults: the room `estimator.recordings.checks`. Every
correction is stated in the report; nothing is keyed to a file's name.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from jaxtyping import Bool, Float, Int

from design.errors import RecordingError
from estimator.frames.dataset import NO_FACE, FrameSet
from estimator.recordings.attitude import recorded_motion
from estimator.recordings.checks.cells import check_rate, repaired_forces, wrong_forces
from estimator.recordings.checks.faults import (
    Fault,
    axis_noise_counts,
    correct_face_labels,
    dead_channels,
    jump_faults,
    mirror_faults,
    noisy_channels,
    press_responses,
    rest_noise_counts,
    stamp_faults,
    unread_faces,
)
from estimator.recordings.checks.judged import Judged
from estimator.recordings.checks.limits import (
    Limits,
    limit_to_range,
    places_off_the_body,
    usual_limits,
    without_wrapped,
)
from estimator.recordings.checks.place_labels import place_label_faults
from estimator.recordings.checks.press_labels import hidden_contacts, judge_presses
from estimator.recordings.checks.readings import fingerprints, spoilt_channels, without_faults
from estimator.recordings.checks.repeats import repeat_faults, repeated_readings
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
from estimator.recordings.formats.files import has_load_cells, read_table
from estimator.recordings.formats.text import naming
from estimator.recordings.presses import (
    CONTACT_FORCE_N,
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
from estimator.recordings.table import RawTable, faces_of
from estimator.recordings.travel_labels import TravelForces, force_text, with_forces
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
    from it, but in generic recordings, whose level is followed frame by frame. `prints` are fingerprints of
    the raw counts of every face, by which copies show in other files; NaN where a face has no reading.
    """

    frames: FrameSet
    report: RecordingReport
    rest_counts: Float[np.ndarray, "press face sensor 3"]
    prints: Float[np.ndarray, "frame face"] | None = None

    def __repr__(self) -> str:
        return str(self.report)


def read_recording(
    path: Path | str,
    grid_mm: Grid | None = None,
    limits: Limits | None = None,
    mechanics: TravelForces | None = None,
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
    mechanics : TravelForces, optional
        Mechanics of the object, needed where the label is a machine's travel and no force; they also say
        whether a face that answers more strongly than the labelled one makes the label doubtful.

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
    prints = fingerprints(table.counts)
    if grid_mm is not None:
        table = replace(table, grid_x_mm=grid_mm[0], grid_y_mm=grid_mm[1])
    limits = limits or usual_limits(table)
    with naming(path):
        by_travel = table.labelled_by_travel
        table = with_forces(table, mechanics) if by_travel else table
        table, left_out, unreadable = _believed(table, limits)
        case, unsure, misread = _find_presses(table, mechanics)
        named, press_faults = judge_presses(case)
        hidden, concealed = hidden_contacts(case)
        at_rest = case.rest & ~hidden
        zeros = rest_levels(case.table.counts, case.press, np.any(case.touching, axis=1), at_rest)
    face, tip_xy_mm = case.face, case.table.tip_xy_mm
    block, place, places = contact_cases(face, tip_xy_mm, case.touching)
    session = np.unique(table.case, return_inverse=True)[1] if table.kind == "generic" else block
    noisy, noisy_faults = noisy_channels(case.noise_counts)
    jumping, jumps = jump_faults(zeros.counts)
    frames = _frames(case, zeros, noisy | jumping | left_out, hidden, session, place)
    frames = replace(frames, valid=frames.valid & ~(named | hidden | unsure))
    turned, turns = turned_channels(frames)
    frames.signal_counts[:, turned] = np.nan
    off, off_faults = places_off_the_body(tip_xy_mm, limits)
    wrong, place_faults = place_label_faults(frames, places)
    frames = replace(frames, valid=frames.valid & ~wrong & ~off)
    if by_travel and mechanics is not None and case.table.travel_mm is not None:
        late = frames.lag_frames
        travel_mm = shifted_forces(case.table.travel_mm[:, None], case.stretch, late)[:, 0]
        frames = replace(frames, travel_mm=travel_mm, force_factors=mechanics.spread)
    faults = (
        *stamp_faults(table),
        *unreadable,
        *repeat_faults(case.repeats, case.rate_hz),
        *noisy_faults,
        *jumps,
        *turns,
        *misread,
        *press_faults,
        *concealed,
        *off_faults,
        *place_faults,
        *(mirror_faults(face, tip_xy_mm, block) if table.kind == "gripper" else ()),
    )
    report = _report(path, case, frames, places, int(np.sum(~zeros.is_before)), faults)
    if frames.force_factors is not None:
        report = replace(report, units=force_text(frames.force_factors))
    return Recording(frames, report, zeros.counts, prints)


def loaded_frames(path: Path | str) -> Bool[np.ndarray, "frame"] | None:
    """Return in which frames a load cell shows a press, late as cells are; None where none measures.

    Raises
    ------
    RecordingError
        As `read_table`.
    """
    if not has_load_cells(Path(path)):
        return None
    table = read_table(path)
    if table.labelled_by_travel:
        return None
    nothing = table.declared_rest | np.all(np.isnan(table.tip_xy_mm), axis=(1, 2, 3))
    force_n = tared(table.force_n, nothing, REST_FORCE_N[table.kind], table.kind != "training")
    return np.any(force_n >= CONTACT_FORCE_N, axis=1)


def _believed(
    table: RawTable, limits: Limits
) -> tuple[RawTable, Bool[np.ndarray, "face sensor 3"], list[Fault]]:
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
    table, wrapped = without_wrapped(table, _frame_s(table))
    dead, silent = dead_channels(raw)
    unread = unread_faces(raw, table.face)
    return table, spoilt | dead, [*faults, *unreachable, *wrapped, *left_out, *silent, *unread]


def _frame_s(table: RawTable) -> float:
    """Time from row to row (s)."""
    stretch = stretches(table.time_s, table.case[:, None].astype(float))
    return 1 / frame_times_s(table.time_s, stretch, NOMINAL_RATE_HZ)[1]


def _report(
    path: Path | str,
    case: Judged,
    frames: FrameSet,
    places: tuple[Place, ...],
    zeroed_after: int,
    faults: tuple[Fault, ...],
) -> RecordingReport:
    read = np.isfinite(case.table.counts).any(axis=(1, 2, 3))  # copied presses were read before
    return RecordingReport(
        path=str(path),
        kind=case.table.kind,
        frames=len(frames),
        contact_frames=int(np.sum(frames.valid & ~case.rest)),
        rest_frames=int(np.sum(frames.valid & case.rest)),
        unused_frames=int(np.sum(~frames.valid)),
        faces_pressed=tuple(int(f) for f in np.unique(case.face) if f != NO_FACE),
        tips=case.table.tip_xy_mm.shape[2],
        presses=len(np.unique(case.press[case.touching.any(axis=1) & read])),
        sessions=len(np.unique(frames.session_id)),
        places=places,
        frame_rate_hz=case.rate_hz,
        units=_UNITS[case.table.kind],
        lag=case.lag,
        largest_force_n=float(np.nanmax(case.aligned_n)),
        noise_counts=noise_by_name(case.noise_counts),
        presses_zeroed_after=zeroed_after,
        faults=faults,
        motion=""
        if case.table.motion is None
        else recorded_motion(case.time_s, case.table.motion).text,
    )


def _find_presses(
    table: RawTable, mechanics: TravelForces | None
) -> tuple[Judged, Bool[np.ndarray, "frame"], list[Fault]]:
    """The table with its presses, frames whose force was misread, and what was found of forces and faces."""
    no_contact = table.declared_rest | np.all(np.isnan(table.tip_xy_mm), axis=(1, 2, 3))
    if table.kind == "generic":
        face, tip_xy_mm = carried_labels(table.face, table.tip_xy_mm, table.case)
        table = replace(table, face=face, tip_xy_mm=tip_xy_mm)
    keys = np.column_stack([table.case, place_keys(table.face, table.tip_xy_mm)])
    stretch, block = stretches(table.time_s, keys), block_numbers(keys)
    time_s, rate_hz = frame_times_s(table.time_s, stretch, NOMINAL_RATE_HZ)
    check_rate(rate_hz)
    limit_n = REST_FORCE_N[table.kind]
    wrong, misread = wrong_forces(table.force_n)
    measured_n, turns = repaired_forces(table.force_n, wrong), []
    if table.kind != "training":
        measured_n, turns = turned_forces(measured_n, table.counts, table.face, block, limit_n)
    force_n = tared(measured_n, no_contact, limit_n, signed=table.kind != "training")
    if force_n.max() < CONTACT_FORCE_N:
        raise RecordingError(
            f"it holds no press: the largest force is {force_n.max():.3g} N, a contact needs "
            f"{CONTACT_FORCE_N} N. Give a recording with presses"
        )
    press = number_presses(force_n, stretch, limit_n)
    responses = press_responses(table.counts, force_n, press)
    face, corrected = correct_face_labels(table, press, responses)
    table = replace(table, face=face)
    lag = estimate_lag(table.counts, force_n, face, press, stretch)
    late = lag.frames if lag.corrected else 0
    aligned_n = shifted_forces(force_n, stretch, late)
    unsure = np.any(shifted_forces(wrong.astype(float), stretch, late) > 0, axis=1)
    rest = is_at_rest(aligned_n, limit_n)
    shear_n = np.zeros((*aligned_n.shape, 2))
    if table.shear_n is not None:
        shear_n = shifted_shear(table.shear_n, stretch, late, rest)
    repeats = repeated_readings(table.counts)
    case = Judged(
        table=table, time_s=time_s, rate_hz=rate_hz, force_n=force_n, aligned_n=aligned_n,
        shear_n=shear_n, press=press, stretch=stretch, block=block, responses=responses,
        no_contact=no_contact, rest=rest, repeats=repeats, lag=lag,
        noise_counts=rest_noise_counts(table.counts, rest, repeats.stale), mechanics=mechanics,
    )  # fmt: skip
    return case, unsure, [*misread, *turns, *corrected]


def _frames(
    case: Judged,
    zeros: Zeros,
    left_out: Bool[np.ndarray, "face sensor 3"],
    hidden: Bool[np.ndarray, "frame"],
    session: Int[np.ndarray, "frame"],
    place: Int[np.ndarray, "frame"],
) -> FrameSet:
    table, touching, not_new = case.table, case.touching, case.repeats.rows
    zero, error = zeros.counts[case.press], None
    if table.kind == "generic":
        at_rest = is_at_rest(case.aligned_n, rest_limit_n(case.aligned_n)) & ~hidden & ~not_new
        levels = levels_under_presses(
            table.counts, case.time_s, session, np.any(touching, axis=1), at_rest, case.noise_counts
        )
        zero, error = levels.counts, levels.error
    signal = table.counts - zero
    gap = np.any(np.isnan(table.counts) & ~left_out & _recorded(table), axis=(1, 2, 3))
    gap |= ~np.isfinite(table.counts).any(axis=(1, 2, 3))
    signal[:, left_out] = np.nan
    alone = table.kind == "generic"  # a gripper's jaws press together, other load cells may rest
    still = alone & (np.abs(case.aligned_n) < REST_FORCE_N[table.kind])
    clear = case.rest | (touching | still).all(axis=1)
    contact_face, xy_mm, contact_n = contact_slots(
        case.face, table.tip_xy_mm, case.aligned_n, case.shear_n, touching
    )
    return FrameSet(
        signal_counts=signal,
        contact_face=contact_face,
        contact_xy_mm=xy_mm,
        force_n=contact_n,
        valid=clear & ~gap & ~not_new,
        press_id=case.press,
        place_id=place,
        session_id=session,
        time_s=case.time_s,
        faces=faces_of(table.counts),
        grid_x_mm=table.grid_x_mm,
        grid_y_mm=table.grid_y_mm,
        noise_counts=axis_noise_counts(case.noise_counts),
        source="recorded",
        spec_hash=table.digest,
        seed=0,
        lag_frames=case.lag.frames if case.lag.corrected else 0,
        zero_error=error,
    )


def _recorded(table: RawTable) -> Bool[np.ndarray, "frame face 1 1"]:
    """Return which faces ought to have readings in each frame: faces that ever have, in a training file
    the one of the frame."""
    has_reading = np.any(np.isfinite(table.counts), axis=(2, 3), keepdims=True)
    if table.kind == "training":
        return has_reading
    return np.broadcast_to(has_reading.any(axis=0), has_reading.shape)

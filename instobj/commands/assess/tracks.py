"""Contacts over time in recordings and data sets, by whatever estimators a folder holds."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from design.errors import InputError, RecordingError
from design.layout.places.contact_grid import contact_grid
from design.netcdf import holds
from design.spec.object import ObjectSpec
from design.spec_io import load_spec
from estimator.deploy.zeroing import ReadStill, StillReading, StreamZero, read_through
from estimator.frames.dataset import NO_FACE, FrameSet
from estimator.frames.face_data import HISTORY
from estimator.frames.same_object import same_grid
from estimator.grasps.rests import contacts_between_rests
from estimator.grasps.track import ContactTrack, track_of_networks, track_of_sets
from estimator.inversion.condition import FINE, Condition
from estimator.inversion.inversion import Inversion
from estimator.inversion.readings import ContactSets
from estimator.recordings.attitude import RecordedMotion, read_motion
from estimator.recordings.formats.robot import is_robot_file
from estimator.recordings.table import faces_of
from instobj.commands.contacts import require_read_sensors
from instobj.commands.readings import (
    Stream,
    Zeroing,
    is_data_set,
    is_trained_on,
    no_zero_text,
    recorded_stream,
    training_frames,
    training_set,
    zeroed_data_set,
)
from instobj.store.progress import ProgressLine
from instobj.store.readers import INVERSION, face_model_paths, published_tables

if TYPE_CHECKING:
    from estimator.networks.face_model import FaceModel

MOST_UNEXPLAINED = 0.5
"""Share of pressed frames without explanation from which networks read in the inversion's place."""
_OTHERS = ("contacts.csv", "grasps.csv", *published_tables())
"""Tables that instobj writes next to recordings."""
TENSORS = ".pt"
"""Suffix of recordings that torch wrote: channels without names."""
_STEP = 200
"""Frames between two words of progress."""


@dataclass(frozen=True)
class Estimators:
    """Inversion and networks (by face) of a folder, and the object that they read; `training` holds the
    signals of every frame of the data set in the folder, which they were trained on."""

    path: Path
    spec: ObjectSpec
    inversion: Inversion | None
    networks: dict[int, FaceModel]
    training: frozenset[bytes]


@dataclass(frozen=True)
class ReadRecording:
    """A file as contacts over time.

    Attributes
    ----------
    cells : its frames with load cells and labels; None where it has none
    method : what read it
    texts : what is to be said of it
    faults : that were found in the file and corrected
    trained_on : the estimators were trained on it
    motion : of the object by its IMU; None where it has none
    """

    path: Path
    track: ContactTrack
    cells: FrameSet | None
    method: str
    texts: list[str]
    faults: list[str]
    trained_on: bool
    motion: RecordedMotion | None


def load_estimators(given: Path, spec: Path | None) -> Estimators:
    """Load what a folder of `train` or `run`, or one file of it, holds.

    contacts.nc holds its specification, unless one is given; networks alone hold none.

    Raises
    ------
    InputError
        No estimator, networks alone without a specification, or a specification of another object.
    """
    from estimator.inversion.storage import load_inversion
    from estimator.networks.face_model import load_model

    of_network = given.suffix == ".safetensors"
    contacts = INVERSION.path(given) if given.is_dir() else given
    paths = face_model_paths(given) if given.is_dir() else [given] * of_network
    networks = {model.face: model for model in map(load_model, paths)}
    inverted = None
    if not of_network and (contacts.is_file() or not given.is_dir()):
        inverted = load_inversion(contacts)
    if inverted is None and not networks:
        raise InputError(
            f"{given} holds no estimator ({INVERSION.name} or face_<n>.safetensors). Give the folder "
            "that `instobj train` wrote to"
        )
    if spec is not None:
        described = load_spec(spec, [])
        _require_object_of(described, spec, inverted, networks)
    elif inverted is None:
        raise InputError(
            f"{given} holds networks alone, which do not tell the object's shape. Give its specification "
            "with --spec SPEC.toml"
        )
    else:
        described = inverted.model.spec
    training = training_frames(training_set(given), described.body.sensed)
    return Estimators(given, described, inverted, networks, training)


def _require_object_of(
    described: ObjectSpec, path: Path, inverted: Inversion | None, networks: dict[int, FaceModel]
) -> None:
    """Raise InputError where a specification is of another body than the estimators read.

    Networks know the contact grid, their faces and the sensors on them, and no sizes.
    """
    if inverted is not None and inverted.model.spec.body != described.body:
        raise InputError(
            f"--spec {path} has another body than the one that the inversion reads. Leave --spec out: "
            f"{INVERSION.name} holds its own specification"
        )
    grid = contact_grid(described)
    for face, model in networks.items():
        sensors = max(sensor for _, sensor, _ in model.channels) + 1
        read_faces = {face, *(of_face % HISTORY for of_face, *_ in model.channels)}
        of_model = (model.grid_x_mm, model.grid_y_mm)
        if (
            not same_grid((grid.x_mm, grid.y_mm), of_model)
            or not read_faces <= set(described.body.sensed)
            or sensors > described.sensors.count_per_face
        ):
            raise InputError(
                f"--spec {path} is of another object: the network of face {face} reads {sensors} sensors on "
                f"faces {sorted(read_faces)} and places on a grid of {len(of_model[0])} × "
                f"{len(of_model[1])} from ({of_model[0][0]:g}, {of_model[1][0]:g}) mm on. Give the "
                "specification of the object that was recorded. If this is it, recordings were read without "
                f"it: `instobj recordings FILES --spec {path}`, and train on that data set"
            )


def recordings_in(given: Path) -> list[Path]:
    """Recordings and data sets of a folder, by name; the file itself where it is one.

    Raises
    ------
    InputError
        Nothing there, or a folder without any.
    """
    if not given.is_dir() or is_robot_file(given):
        if not given.exists():
            raise InputError(
                f"no recording at {given}. Give a recording, a data set, or a folder of them"
            )
        return [given]
    tables = [
        path
        for path in sorted(given.iterdir())
        if (path.name.endswith((".csv", ".csv.gz", TENSORS)) or is_robot_file(path))
        and not (path.name.endswith(_OTHERS) or "prediction_" in path.name)
    ]
    sets = [p for p in sorted(given.glob("*.nc")) if is_data_set(p) or holds(p, "counts")]
    if not tables and not sets:
        raise InputError(
            f"{given} holds no recording (CSV, NetCDF, bag or {TENSORS}). Give a folder that does"
        )
    return sorted([*tables, *sets])


def read_grasps_of(path: Path, estimators: Estimators, zeroing: Zeroing) -> ReadRecording:
    """Read the contacts of every frame of a recording or data set.

    The inversion reads where there is one. Where it explains less than half of the pressed frames
    and there are networks, these read instead, and the texts say so.

    Raises
    ------
    InputError
        A bad file, readings of another object, or channels without names.
    """
    if path.suffix == TENSORS:
        raise InputError(
            f"{path} names no channels, so that no estimator can read it. Leave --model out: contact slip is "
            "judged in the channels themselves"
        )
    frames, faults, texts = _frames_of(path, estimators, zeroing)
    labelled = bool(np.any(frames.contact_face != NO_FACE))
    cells = frames if labelled else None
    trained_on = is_trained_on(frames, estimators.training, estimators.spec.body.sensed)
    motion = None if is_data_set(path) else read_motion(path)
    if estimators.inversion is not None:
        track, condition = _inverted(path, frames, estimators.inversion)
        if condition.why:
            texts.append(f"{path.name}, condition of the object: {condition}")
        unexplained = unexplained_share([track])
        if unexplained <= MOST_UNEXPLAINED or not estimators.networks:
            return ReadRecording(path, track, cells, "inversion", texts, faults, trained_on, motion)
        texts.append(
            f"{path.name}: the inversion explains {100 * (1 - unexplained):.0f} % of the pressed frames; "
            "networks read it instead"
        )
    track = _networks_track(frames, estimators.networks)
    return ReadRecording(path, track, cells, "networks", texts, faults, trained_on, motion)


def unexplained_share(tracks: Sequence[ContactTrack]) -> float:
    """Return the share of the pressed frames that the estimator does not explain, of 0 to 1.

    A frame that is not explained counts as pressed: where no contact is read, something changed the signals.
    """
    pressed = [np.any(track.face != NO_FACE, axis=1) | ~track.explained for track in tracks]
    total = sum(int(frames.sum()) for frames in pressed)
    return sum(int((~track.explained).sum()) for track in tracks) / max(total, 1)


def frame_documents(track: ContactTrack) -> Iterator[dict[str, Any]]:
    """Yield frames as `instobj predict --port` prints them, as far as a track holds it."""
    for row in range(len(track)):
        contacts = []
        for slot in np.flatnonzero(track.face[row] != NO_FACE).tolist():
            values = (*track.xy_mm[row, slot].tolist(), *track.force_n[row, slot].tolist())
            names = ("x_mm", "y_mm", "tangential_x_n", "tangential_y_n", "force_n")
            read = {
                name: value for name, value in zip(names, values, strict=True) if value == value
            }
            contacts.append({"face": int(track.face[row, slot])} | read)
        stamp = {"frame": row, "time_s": float(track.time_s[row])}
        yield stamp | {"explained": bool(track.explained[row]), "contacts": contacts}


def _frames_of(
    path: Path, estimators: Estimators, zeroing: Zeroing
) -> tuple[FrameSet, list[str], list[str]]:
    """Zeroed frames, faults of the file, and what is to be said of it."""
    from estimator.recordings.formats.files import has_load_cells
    from estimator.recordings.reading import read_recording

    if is_data_set(path):
        return zeroed_data_set(path, zeroing).select_faces(estimators.spec.body.sensed), [], []
    texts = []
    if zeroing.mode is None and has_load_cells(path):
        try:
            recording = read_recording(path)
        except RecordingError as error:
            # a cell that was not connected must not hide what the sensors felt; damage fails again below
            texts = [f"{path.name}: load cells and labels are not used: {error}"]
        else:
            faults = [f"{path.name}: {fault}" for fault in recording.report.faults]
            return recording.frames.select_faces(estimators.spec.body.sensed), faults, []
    stream = recorded_stream(path)
    faults = [f"{path.name}: {text}" for text in stream.texts]
    frames, said = _zeroed(stream, estimators, zeroing)
    return frames, faults, [*texts, *(f"{path.name}: {text}" for text in said)]


def _zeroed(stream: Stream, estimators: Estimators, zeroing: Zeroing) -> tuple[FrameSet, list[str]]:
    """Changes of a board's readings against the zero that follows rest, as the estimator sees rest, and
    what is said of the zero; frames before the first zero are left out."""
    raw = np.where(stream.left_out, np.nan, stream.raw)
    count, sensed = len(raw), estimators.spec.body.sensed
    stamps = stream.time_s
    if not len(stamps) or not np.all(np.diff(stamps) > 0):
        stamps = np.arange(count) / estimators.spec.sensors.frame_rate_hz
    empty = np.full((count, 1, 3), np.nan)
    grid, one_session = contact_grid(estimators.spec), np.zeros(count, int)
    frames = FrameSet(
        raw, one_session[:, None], empty[..., :2], empty, np.ones(count, bool), one_session,
        one_session - 1, one_session, stamps, faces_of(raw), grid.x_mm, grid.y_mm, np.ones(3),
        "recorded", "", 0,
    ).select_faces(sensed)  # fmt: skip
    raw = frames.signal_counts
    reader, filled = _Zeros(zeroing, _stillness(estimators, frames)), np.nan_to_num(raw)

    def zero_of(number: int) -> np.ndarray | None:
        return reader.level.update(filled[number].ravel(), float(stamps[number]))

    zeros, texts = read_through(count, zero_of, reader, stream.loaded)
    zeroed = np.array([number for number, zero in enumerate(zeros) if zero is not None], int)
    if not len(zeroed):
        raise InputError(no_zero_text(stream.path, count, zeroing, texts))
    levels = np.array([zeros[number] for number in zeroed]).reshape(-1, *raw.shape[1:])
    chosen = frames.select(zeroed)
    return replace(chosen, signal_counts=chosen.signal_counts - levels), texts


class _Zeros:
    """The zero of a stream, taken again where it proves wrong."""

    def __init__(self, zeroing: Zeroing, read: ReadStill) -> None:
        self._zeroing, self._read = zeroing, read
        self.rezero()

    def rezero(self, level: np.ndarray | None = None) -> None:
        """Take the zero from the frames that follow, or the level given."""
        self.level = StreamZero(*self._zeroing.raw_settings, self._read, level=level)


def _stillness(estimators: Estimators, frames: FrameSet) -> ReadStill:
    """Function that reads the chance of a contact and the force in a change of all channels."""
    from estimator.deploy.live_contacts import LiveContacts
    from estimator.networks.face_model import predict

    if estimators.inversion is not None:
        return LiveContacts(estimators.inversion).read_still
    first = frames.select(np.array([0]))

    def read_still(change: np.ndarray, _: int = 1) -> StillReading:
        frame = replace(first, signal_counts=change.reshape(first.signal_counts.shape))
        readings = [predict(model, frame) for model in estimators.networks.values()]
        contact = max(float(reading.contact[0]) for reading in readings)
        return StillReading(contact, sum(float(reading.force_n[0]) for reading in readings))

    return read_still


def _inverted(path: Path, frames: FrameSet, inversion: Inversion) -> tuple[ContactTrack, Condition]:
    """Contacts of every frame, and the object's condition at the end."""
    require_read_sensors(inversion, frames, path)
    progress, sets, condition = ProgressLine(), [], FINE
    counts = frames.signal_counts.reshape(len(frames), -1)
    # every session has a zero of its own
    firsts = np.flatnonzero(np.diff(frames.session_id)) + 1
    with progress.stage(f"contacts in {path}"):
        for session in np.split(np.arange(len(frames)), firsts):

            def show(number: int, first: int = int(session[0])) -> None:
                if number % _STEP == 0:
                    progress.step(f"frame {first + number} of {len(frames)}")

            session_sets, tracker = contacts_between_rests(inversion, counts[session], show)
            sets.append(session_sets)
            condition = tracker.condition()
    force_error = inversion.disturbances.force_error
    return track_of_sets(frames.time_s, ContactSets.joined(sets), force_error), condition


def _networks_track(frames: FrameSet, networks: dict[int, FaceModel]) -> ContactTrack:
    """Contacts in the frames that have the readings of every network."""
    from estimator.networks.face_model import predict_with_gaps

    predictions = {face: predict_with_gaps(model, frames) for face, model in networks.items()}
    cover = min(model.interval_cover for model in networks.values())
    track = track_of_networks(frames.time_s, predictions, cover)
    read = np.isfinite(np.sum([face.force_n for face in predictions.values()], axis=0))
    return track.select(np.flatnonzero(read))

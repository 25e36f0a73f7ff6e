"""Contacts over time in recordings and data sets, by whatever estimators a folder holds."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from design.errors import InputError, RecordingError
from design.netcdf import holds
from design.spec.object import ObjectSpec
from design.spec_io import load_spec
from estimator.frames.dataset import NO_FACE, FrameSet, load_frames
from estimator.grasps.track import ContactTrack, track_of_networks, track_of_sets
from estimator.inversion.inversion import Inversion
from estimator.inversion.readings import ContactSets
from instobj.commands.readings import Zeroing, is_data_set, recorded_frames, recorded_stream
from instobj.store.progress import ProgressLine
from instobj.store.readers import INVERSION, face_model_paths

if TYPE_CHECKING:
    from estimator.networks.face_model import FaceModel

MOST_UNEXPLAINED = 0.5
"""Share of pressed frames without explanation from which networks read in the inversion's place."""
_OTHERS = ("contacts.csv", "grasps.csv", "scores.csv", "bom.csv", "orders.csv")
"""Tables that instobj writes next to recordings."""
_STEP = 200
"""Frames between two words of progress."""


@dataclass(frozen=True)
class Estimators:
    """Inversion and networks (by face) of a folder, and the object that they read."""

    path: Path
    spec: ObjectSpec
    inversion: Inversion | None
    networks: dict[int, FaceModel]


@dataclass(frozen=True)
class ReadRecording:
    """A file as contacts over time.

    Attributes
    ----------
    cells : its frames with load cells and labels; None where it has none
    method : what read it
    texts : what is to be said of it
    faults : that were found in the file and corrected
    """

    path: Path
    track: ContactTrack
    cells: FrameSet | None
    method: str
    texts: list[str]
    faults: list[str]


def load_estimators(given: Path, spec: Path | None) -> Estimators:
    """Load what a folder of `train` or `run`, or one file of it, holds.

    contacts.nc holds its specification, unless one is given; networks alone hold none.

    Raises
    ------
    InputError
        No estimator, or networks alone without a specification.
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
        return Estimators(given, load_spec(spec, []), inverted, networks)
    if inverted is None:
        raise InputError(
            f"{given} holds networks alone, which do not tell the object's shape. Give its specification "
            "with --spec SPEC.toml"
        )
    return Estimators(given, inverted.model.spec, inverted, networks)


def recordings_in(given: Path) -> list[Path]:
    """Recordings and data sets of a folder, by name; the file itself where it is one.

    Raises
    ------
    InputError
        Nothing there, or a folder without any.
    """
    if not given.is_dir():
        if not given.is_file():
            raise InputError(
                f"no recording at {given}. Give a recording, a data set, or a folder of them"
            )
        return [given]
    tables = [
        path
        for path in sorted(given.glob("*.csv"))
        if not path.name.endswith(_OTHERS) and "prediction_" not in path.name
    ]
    sets = [p for p in sorted(given.glob("*.nc")) if is_data_set(p) or holds(p, "counts")]
    if not tables and not sets:
        raise InputError(f"{given} holds no recording (CSV or NetCDF). Give a folder that does")
    return sorted([*tables, *sets])


def read_grasps_of(path: Path, estimators: Estimators, zeroing: Zeroing) -> ReadRecording:
    """Read the contacts of every frame of a recording or data set.

    The inversion reads where there is one. Where it explains less than half of the pressed frames
    and there are networks, these read instead, and the texts say so.

    Raises
    ------
    InputError
        A bad file, or readings of another object.
    """
    frames, faults, texts = _frames_of(path, estimators.spec, zeroing)
    if estimators.inversion is not None:
        track = _inverted(path, frames, estimators.inversion, zeroing)
        pressed = np.any(track.face != NO_FACE, axis=1)
        unexplained = float(np.mean(~track.explained[pressed])) if pressed.any() else 0.0
        if unexplained <= MOST_UNEXPLAINED or not estimators.networks:
            return ReadRecording(path, track, _labelled(frames), "inversion", texts, faults)
        texts.append(
            f"{path.name}: the inversion explains {100 * (1 - unexplained):.0f} % of the pressed frames; "
            "networks read it instead"
        )
    track = networks_track(path, frames, estimators.networks, zeroing)
    return ReadRecording(path, track, _labelled(frames), "networks", texts, faults)


def _labelled(frames: FrameSet | None) -> FrameSet | None:
    labelled = frames is not None and bool(np.any(frames.contact_face != NO_FACE))
    return frames if labelled else None


def _frames_of(
    path: Path, spec: ObjectSpec, zeroing: Zeroing
) -> tuple[FrameSet | None, list[str], list[str]]:
    """Frames of a data set, or of a recording whose load cells show presses, with its faults and what
    is to be said; None where it is read like a board's stream."""
    from estimator.recordings.formats.files import has_load_cells
    from estimator.recordings.reading import read_recording

    if is_data_set(path):
        return load_frames(path).select_faces(spec.body.sensed), [], []
    if zeroing.mode is not None or not has_load_cells(path):
        return None, [], []
    try:
        recording = read_recording(path)
    except RecordingError as error:
        # a cell that was not connected must not hide what the sensors felt; a damaged file fails again
        return None, [], [f"{path.name}: load cells and labels are not used: {error}"]
    return recording.frames, [f"{path.name}: {fault}" for fault in recording.report.faults], []


def _inverted(
    path: Path, frames: FrameSet | None, inversion: Inversion, zeroing: Zeroing
) -> ContactTrack:
    from estimator.deploy.live_contacts import LiveContacts
    from estimator.inversion.tracking import Tracker

    progress, sets, stamps = ProgressLine(), [], []
    with progress.stage(f"contacts in {path}"):
        if frames is None:
            reader = LiveContacts(inversion, *zeroing.of_raw)
            stream = recorded_stream(path)
            for number, time_s, contacts in recorded_frames(
                reader, inversion.channels, stream, zeroing
            ):
                if contacts is not None:
                    sets.append(contacts)
                    stamps.append(time_s)
                if number % _STEP == 0:
                    progress.step(f"frame {number} of {len(stream.raw)}")
            return track_of_sets(
                _clock(np.array(stamps), inversion.model.spec), ContactSets.joined(sets)
            )
        _require_same_sensors(path, frames, inversion)
        counts = frames.signal_counts.reshape(len(frames), -1)
        tracker = Tracker(inversion)
        for number, change in enumerate(counts):
            if number and frames.session_id[number] != frames.session_id[number - 1]:
                tracker = Tracker(inversion)
            sets.append(tracker.feed(change))
            if number % _STEP == 0:
                progress.step(f"frame {number} of {len(frames)}")
    return track_of_sets(frames.time_s, ContactSets.joined(sets))


def _require_same_sensors(path: Path, frames: FrameSet, inversion: Inversion) -> None:
    faces = inversion.model.signals.faces.tolist()
    sensors = inversion.model.channels // (3 * len(faces))
    got = frames.faces.tolist(), frames.signal_counts.shape[2]
    if got != (faces, sensors):
        raise InputError(
            f"{path} has {got[1]} sensors on faces {got[0]}; the estimator reads {sensors} on faces "
            f"{faces}. Give a recording of the object that it was made for"
        )


def _clock(stamps_s: np.ndarray, spec: ObjectSpec) -> np.ndarray:
    """Stamps, or the nominal frame rate where a recording has none or they stand still."""
    if np.isfinite(stamps_s).all() and np.all(np.diff(stamps_s) > 0):
        return stamps_s
    return np.arange(len(stamps_s)) / spec.sensors.frame_rate_hz


def networks_track(
    path: Path, frames: FrameSet | None, networks: dict[int, FaceModel], zeroing: Zeroing
) -> ContactTrack:
    from estimator.networks.face_model import predict_with_gaps

    if frames is None:
        frames = zeroed_stream(path, networks, zeroing)
    predictions = {face: predict_with_gaps(model, frames) for face, model in networks.items()}
    cover = min(model.interval_cover for model in networks.values())
    track = track_of_networks(frames.time_s, predictions, cover)
    read = np.isfinite(np.sum([face.force_n for face in predictions.values()], axis=0))
    return track.select(np.flatnonzero(read))


def zeroed_stream(path: Path, networks: dict[int, FaceModel], zeroing: Zeroing) -> FrameSet:
    """Changes against the zero that follows rest, as networks see rest; frames before it left out."""
    from estimator.deploy.zeroing import StreamZero
    from estimator.networks.face_model import predict

    stream = recorded_stream(path)
    raw = np.where(stream.left_out, np.nan, stream.raw)
    time_s = stream.time_s if len(stream.time_s) else np.arange(len(raw)) / 10.0
    whole = FrameSet(
        raw, np.zeros((len(raw), 1), int), np.full((len(raw), 1, 2), np.nan),
        np.full((len(raw), 1, 3), np.nan), np.ones(len(raw), bool), np.zeros(len(raw), int),
        np.full(len(raw), -1), np.zeros(len(raw), int), time_s, np.arange(1, 6),
        *_grid(networks), np.ones(3), "recorded", "", 0,
    )  # fmt: skip

    def read_still(change: np.ndarray) -> tuple[float, float]:
        frame = replace(
            whole.select(np.array([0])), signal_counts=change.reshape(1, *raw.shape[1:])
        )
        read = [predict(model, frame) for model in networks.values()]
        return max(float(r.contact[0]) for r in read), sum(float(r.force_n[0]) for r in read)

    level, zeros = StreamZero(*zeroing.of_raw, read_still), np.full(raw.shape, np.nan)
    for number, counts in enumerate(np.nan_to_num(raw)):
        zero = level.after(counts.ravel(), float(time_s[number]))
        if zero is not None:
            zeros[number] = zero.reshape(counts.shape)
    zeroed = np.isfinite(zeros).all(axis=(1, 2, 3))
    if not zeroed.any():
        raise InputError(
            f"{path} holds {len(raw)} frames, none of them after {zeroing.frames} at rest that give a "
            "zero. Give a longer recording, or --zero first"
        )
    return replace(whole, signal_counts=raw - zeros).select(np.flatnonzero(zeroed))


def _grid(networks: dict[int, FaceModel]) -> tuple[np.ndarray, np.ndarray]:
    model = next(iter(networks.values()))
    return model.grid_x_mm, model.grid_y_mm

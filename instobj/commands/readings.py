"""Readings of a file or a port for any estimator: zeroed, read one by one, and where results go."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple, Protocol, runtime_checkable

import numpy as np
from jaxtyping import Bool, Float

from design.errors import InputError
from design.files import require_regular_file
from design.netcdf import holds
from estimator.deploy.zeroing import ZERO_FRAMES, Zeroed, ZeroMode, read_through
from estimator.frames.dataset import FrameSet, load_frames
from estimator.frames.face_data import HISTORY, Channel, channel_label
from estimator.frames.same_object import require_same_sensors
from estimator.inversion.condition import DISTRUST_FROM
from estimator.recordings.formats.robot import is_robot_file
from estimator.recordings.table import faces_of
from instobj.store.publish import OWN_FOLDERS, require_writable, run_folder, run_name
from instobj.store.readers import FRAMES


@dataclass(frozen=True)
class Zeroing:
    """Conversion of raw counts to changes against rest (`estimator.deploy.zeroing`); by default they follow
    rest, except those of data sets."""

    mode: ZeroMode | None = None
    frames: int = ZERO_FRAMES

    @property
    def raw_settings(self) -> tuple[ZeroMode, int]:
        """Mode and frames for raw counts."""
        return self.mode or "rest", self.frames


FOLLOW_REST = Zeroing()
SILENT_FRAMES = 10
"""A channel without a reading for longer is silent, as on the live page."""
SHORT_FRAMES = 20
"""Frames that were read below which a file says nothing of its object."""
_TRAINED_SHARE = 0.5
"""Share of a recording's frames that were trained on from which it counts as the training's own."""
_REPEATED = 0.2
"""Share of repeated rows from which the scatter at rest says nothing."""


@runtime_checkable
class Reader(Zeroed, Protocol):
    """Takes raw counts frame by frame; None while there is no zero. `miss` counts a frame that lacks a
    reading and is passed over."""

    @property
    def leaves_out(self) -> bool:
        """Return whether it reads frames without some of its channels."""
        ...

    def feed(
        self,
        raw_counts: Float[np.ndarray, "face sensor 3"],
        time_s: float,
        left_out: Bool[np.ndarray, "face sensor 3"] | None,
    ) -> Any: ...

    def miss(self) -> None: ...


class LiveFrame(NamedTuple):
    """Reading of a frame of a board, its number and stamp, and the state of the line and of
    its readings."""

    number: int
    time_s: float
    reading: Any
    line: dict[str, int | str]


def zeroed_data_set(path: Path, zeroing: Zeroing) -> FrameSet:
    """A data set, which is zeroed already.

    Raises
    ------
    InputError
        It is to be zeroed again.
    """
    if zeroing.mode not in (None, "none"):
        raise InputError(
            f"{path} is a data set, zeroed press by press; got --zero {zeroing.mode}. Leave "
            "--zero out"
        )
    return load_frames(path)


@dataclass(frozen=True)
class Stream:
    """Readings of a recording without labels: stamps (s), raw counts, those of them not to believe
    (`checks.readings.STREAM`), what is said of them, and where load cells, if any, show a press."""

    path: Path
    time_s: Float[np.ndarray, "stamp"]
    raw: Float[np.ndarray, "frame face sensor 3"]
    left_out: Bool[np.ndarray, "frame face sensor 3"]
    texts: list[str]
    loaded: Bool[np.ndarray, "frame"] | None = None


def recorded_stream(path: Path) -> Stream:
    """The readings of any recording, checked; errors as `read_signals`."""
    from estimator.recordings.checks.readings import STREAM, without_faults
    from estimator.recordings.formats.files import read_signals
    from estimator.recordings.reading import loaded_frames

    time_s, raw = read_signals(path)
    believed, faults = without_faults(raw, STREAM)
    left_out, texts = np.isnan(believed) & ~np.isnan(raw), list(map(str, faults))
    return Stream(path, time_s, raw, left_out, texts, loaded_frames(path))


def recorded_frames(
    reader: Reader,
    channels: tuple[Channel, ...],
    stream: Stream,
    zeroing: Zeroing,
    step: Callable[[int], None] = lambda number: None,
) -> list[tuple[int, float, Any]]:
    """Number, stamp (s) and what the reader finds of every frame of a recording after the first zero;
    None for frames that lack a reading, which are passed over. `stream.texts` gets what is said of the zero;
    `step` gets the number of each frame.

    Raises
    ------
    InputError
        Readings of another object, or no zero in the whole file.
    """
    path, raw = stream.path, stream.raw
    require_same_sensors(channels, raw, faces_of(raw), str(path))
    time_s = stream.time_s if len(stream.time_s) else np.full(len(raw), np.nan)
    partly, left_out = reader.leaves_out, stream.left_out
    if partly and (absent := _absent(raw, channels)):
        face, sensor, axis = np.array(absent).T
        raw, left_out = raw.copy(), left_out.copy()
        raw[:, face - 1, sensor, axis], left_out[:, face - 1, sensor, axis] = 0.0, True
        names = ", ".join(channel_label(channel) for channel in absent)
        stream.texts.append(f"{path.name}: no reading of {names} in the whole file, left out")
    lacking = lacks_readings(raw if partly else np.where(left_out, np.nan, raw), channels)
    silent = lacking.all()

    def read(number: int) -> tuple[bool, Any]:
        step(number)
        if lacking[number] and not silent:
            reader.miss()
            return True, None
        contacts = reader.feed(raw[number], float(time_s[number]), left_out[number])
        return contacts is not None, contacts

    results, texts = read_through(len(raw), read, reader, stream.loaded)
    stream.texts.extend(f"{path.name}: {text}" for text in texts)
    if all(result is None for _, result in results):
        repeated = int(np.sum(np.all((raw[1:] == raw[:-1]) | np.isnan(raw[1:]), axis=(1, 2, 3))))
        if repeated > _REPEATED * len(raw):
            raise InputError(
                f"{path} repeats the readings of the row before in {repeated} of {len(raw)} rows, so that "
                "rest does not show. Take the repeated rows out (was it logged faster than the sensors "
                "answer?), or take --zero first"
            )
        raise InputError(no_zero_text(path, len(raw), zeroing, texts))
    return [
        (number, float(time_s[number]), result)
        for number, (was_read, result) in enumerate(results)
        if was_read
    ]


def _absent(
    raw: Float[np.ndarray, "frame face sensor 3"], channels: tuple[Channel, ...]
) -> list[Channel]:
    """Return the channels that a whole file has no reading of; none where it has of none, or no such face
    or sensor."""
    _, faces, sensors, _ = raw.shape
    if any(face > faces or sensor >= sensors for face, sensor, _ in channels):
        return []
    absent = [c for c in channels if np.isnan(raw[:, c[0] - 1, c[1], c[2]]).all()]
    return [] if len(absent) == len(channels) else absent


def no_zero_text(path: Path, frames: int, zeroing: Zeroing, texts: Sequence[str]) -> str:
    """Say why no frame of a file gives a zero, and what to do; `texts` say what was left out."""
    if zeroing.mode == "first":
        why = f"none after the first {zeroing.frames}, which give the zero"
        remedy = "Take fewer frames as rest (--zero first:5)"
    else:
        why = f"and never {zeroing.frames} at rest on end, which give the zero"
        remedy = "Take the first frames as rest (--zero first), touch nothing for a second before presses"
    return (
        f"{path} holds {frames} frames, {why}{''.join('; ' + text for text in texts)}. {remedy} or, for "
        "signals that are changes already, take --zero none"
    )


def lacks_readings(
    counts: Float[np.ndarray, "frame face sensor 3"], channels: tuple[Channel, ...]
) -> Bool[np.ndarray, "frame"]:
    """Return which frames lack a reading of one of the channels."""
    face, sensor, axis = np.array(channels).T
    row = face % HISTORY - 1
    wanted = np.array([row.max() + 1, sensor.max() + 1])
    faces, sensors = np.maximum(wanted - counts.shape[1:3], 0)
    counts = np.pad(counts, ((0, 0), (0, faces), (0, sensors), (0, 0)), constant_values=np.nan)
    return np.any(np.isnan(counts[:, row, sensor, axis]), axis=1)


def live_frames(
    reader: Reader, channels: tuple[Channel, ...], port: str, baud: int
) -> Iterator[LiveFrame]:
    """Yield what the reader finds in the frames of a board, without end.

    Frames that lack a reading are passed over and counted, `SILENT_FRAMES` on end at most; so are those
    of which a needed one is not believed (`checks.stream`). The state of the line names what is left out.

    Raises
    ------
    InputError
        A bad port, or readings of another object.
    """
    from estimator.recordings.boards.lines import LineDecoder
    from estimator.recordings.boards.link import board_readings
    from estimator.recordings.checks.stream import SoundReadings

    decoder, sound = LineDecoder(), SoundReadings()
    partly = reader.leaves_out
    unread, on_end, heard = 0, 0, False
    for number, reading in enumerate(board_readings(port, baud, decoder)):
        if number == 0:
            require_same_sensors(channels, reading.counts[None], faces_of(reading.counts), port)
        believed = sound.known(reading.counts)
        judged = reading.counts if partly else believed
        if heard and on_end < SILENT_FRAMES and lacks_readings(judged[None], channels)[0]:
            unread, on_end = unread + 1, on_end + 1
            reader.miss()
            continue
        left_out = np.isnan(believed) & ~np.isnan(reading.counts)
        reading_found = reader.feed(reading.counts, reading.time_s, left_out)
        on_end, heard = 0, True
        if reading_found is not None:
            line = decoder.statistics
            state = {
                "damaged_lines": line.damaged_lines,
                "lost_frames": line.lost_frames,
                "unread_frames": unread,
                "left_out": sound.text,
            }
            yield LiveFrame(number, reading.time_s, reading_found, state)


def is_unexplained(unexplained: int, frames: int) -> bool:
    """Return whether so much of a file is nothing that its estimator knows that readings are not to be
    believed."""
    return unexplained > DISTRUST_FROM * frames


def unexplained_text(path: Path, unexplained: int, frames: int, cause: str = "") -> list[str]:
    """Return a warning where much of a file is nothing that its estimator knows, or hardly a file.

    A `cause` that the file itself shows stands in place of the likely ones.
    """
    texts = []
    if frames < SHORT_FRAMES:
        texts.append(
            f"{path.name}: {frames} frames were read, too few to judge by; record some seconds of rest and "
            "a press"
        )
    if is_unexplained(unexplained, frames):
        why = cause or (
            "Likely causes: contacts of a kind that it was not made for, or at places that networks were not "
            "trained on; the estimator is of another object or its specification is not as built (instobj "
            "validate); a magnet or iron near by; no rest at the start (--zero)"
        )
        texts.append(
            f"{path.name}: nothing that the estimator knows explains {unexplained} of {frames} frames "
            f"({100 * unexplained / frames:.0f} %); do not believe these. {why}"
        )
    return texts


def training_set(given: Path) -> FrameSet | None:
    """Return the data set that estimators of a folder, or one of its files, were trained on; None where it
    does not lie there."""
    folder = given if given.is_dir() else given.parent
    path = FRAMES.path(folder.parent if folder.name in OWN_FOLDERS else folder)
    return load_frames(path) if path.is_file() else None


def training_frames(training: FrameSet | None, faces: Sequence[int]) -> frozenset[bytes]:
    """Return the signals of every frame of a training, on these faces; none without one."""
    return frozenset() if training is None else frozenset(_frame_keys(training, faces))


def is_trained_on(frames: FrameSet, training: frozenset[bytes], faces: Sequence[int]) -> bool:
    """Return whether most frames of a recording are those of a training, as `training_frames` gives them."""
    repeated = sum(key in training for key in _frame_keys(frames, faces))
    return repeated > _TRAINED_SHARE * len(frames)


def _frame_keys(frames: FrameSet, faces: Sequence[int]) -> list[bytes]:
    """Signals of each frame, as files keep them."""
    signals = frames.select_faces(faces).signal_counts
    return [row.tobytes() for row in np.nan_to_num(signals).astype(np.float32)]


def prediction_path(name: str, path: Path, out: Path) -> Path:
    """Return where predictions of a file go; refused before any work where nothing can be written there."""
    require_writable(out)
    if not is_robot_file(path):  # a bag may be a folder
        missing = f"no recording at {path}. Give the path of a recording or a data set"
        require_regular_file(path, missing)
    return run_folder(out, run_name(path)) / name


def is_data_set(path: Path) -> bool:
    """Return whether a file is a data set of instobj, by what it holds."""
    return path.suffix == ".nc" and holds(path, "press_id")

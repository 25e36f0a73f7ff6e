"""Exported estimators on readings, with onnxruntime alone (no torch)."""

from __future__ import annotations

import json
import math
from collections import deque
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from jaxtyping import Bool, Float

from design.errors import InputError
from design.seal import sealed_content
from estimator.deploy.zeroing import (
    ZERO_FRAMES,
    StillReading,
    StreamZero,
    ZeroMode,
    is_pause,
)
from estimator.frames.dataset import FrameSet
from estimator.frames.face_data import (
    HISTORY,
    Channel,
    channel_counts,
    channel_label,
    frames_with_readings,
)
from estimator.networks.prediction import UNITS, Prediction

_ADVICE = "Give a file that `instobj train --export` wrote, or contacts.nc of `instobj train SPEC`"


@dataclass(frozen=True)
class DeployedModel:
    """An exported estimator; attributes as in `estimator.networks.face_model.FaceModel`."""

    face: int
    channels: tuple[Channel, ...]
    grid_x_mm: Float[np.ndarray, "nx"]
    grid_y_mm: Float[np.ndarray, "ny"]
    history_frames: int
    interval_cover: float
    session: Any


def load_deployed(path: Path | str) -> DeployedModel:
    """Read a file written by `estimator.deploy.export.export_onnx`.

    Raises
    ------
    InputError
        No such file, not an ONNX file, or not an estimator of instobj.
    StoreError
        Damaged, or exported by an earlier version.
    """
    path = Path(path)
    if path.is_dir():
        raise InputError(
            f"{path} is a folder. Give one exported estimator, such as {path / 'face_1.onnx'}"
        )
    if not path.is_file():
        raise InputError(
            f"no model at {path}. `instobj train --export` makes one of a trained estimator"
        )
    if path.suffix == ".safetensors":
        raise InputError(
            f"{path} is a trained estimator that is not exported yet. `instobj train --export {path}` makes "
            f"{path.stem}.onnx; give that"
        )
    session = open_session(path)
    try:
        described = json.loads(session.get_modelmeta().custom_metadata_map["instobj"])
        names = [output.name for output in session.get_outputs()]
        if names != list(UNITS):
            raise ValueError(f"its outputs are {names}")
        model = DeployedModel(
            face=int(described["face"]),
            channels=tuple((int(f), int(s), int(a)) for f, s, a in described["channels"]),
            grid_x_mm=np.array(described["grid_x_mm"], dtype=float),
            grid_y_mm=np.array(described["grid_y_mm"], dtype=float),
            history_frames=int(described["history_frames"]),
            interval_cover=float(described["interval_cover"]),
            session=session,
        )
    except (KeyError, TypeError, ValueError) as error:
        raise InputError(
            f"{path} is an ONNX file, but no estimator of instobj ({error}). {_ADVICE}"
        ) from None
    sealed_content(path, _ADVICE)
    return model


def open_session(path: Path) -> Any:
    """An onnxruntime session on one thread.

    Raises
    ------
    InputError
        Not a file that onnxruntime reads, or one with tensors in other files.
    """
    import onnxruntime

    content = path.read_bytes()
    if not content.strip():
        raise InputError(f"{path} is empty, not a model. {_ADVICE}")
    _require_self_contained(path, content)

    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = 1  # networks this small gain nothing from more
    options.inter_op_num_threads = 1
    options.log_severity_level = 4
    try:
        return onnxruntime.InferenceSession(content, options, providers=["CPUExecutionProvider"])
    except Exception:  # onnxruntime's errors share no base class of their own
        raise InputError(f"{path} is no model that onnxruntime can read. {_ADVICE}") from None


def _require_self_contained(path: Path, content: bytes) -> None:
    """Refuse tensors in other files before onnxruntime opens these."""
    import onnx

    try:
        waiting: list[Any] = [onnx.load_model_from_string(content)]
    except Exception:  # protobuf's DecodeError, whose package comes with onnx
        raise InputError(f"{path} is no model (not an ONNX file). {_ADVICE}") from None
    while waiting:
        message = waiting.pop()
        if isinstance(message, onnx.TensorProto) and message.external_data:
            raise InputError(
                f"{path} keeps the tensor {message.name!r} in another file, which is not read. {_ADVICE}"
            )
        for part, value in message.ListFields():
            if part.message_type is not None:
                waiting.extend(value if part.is_repeated else [value])


def run_model(model: DeployedModel, counts: Float[np.ndarray, "frame channel"]) -> Prediction:
    """Readings of changes against rest (counts), in the model's channel order."""
    outputs = model.session.run(None, {"counts": counts.astype(np.float32)})
    return Prediction(*(output.astype(np.float64) for output in outputs))


def predict_with_gaps(
    model: DeployedModel, frames: FrameSet
) -> tuple[Bool[np.ndarray, "frame"], Prediction]:
    """Return which frames of a data set have all readings (and the change since such), and what is read
    there; presses must be complete if the model reads changes.

    Raises
    ------
    InputError
        No frame has the readings of all channels that the model uses.
    """
    has_readings, chosen = frames_with_readings(frames, model.channels, model.history_frames)
    return has_readings, run_model(model, channel_counts(chosen, model.channels))


@dataclass
class LiveReader:
    """Frames one by one, zeroed as `zero` says (`estimator.deploy.zeroing`), with a reading of each.

    Attributes
    ----------
    zero : "rest" follows rest, also where the first frames were none; "first" takes the mean of the
        first `zero_frames`, in which nothing may touch; "none" takes counts for changes
    zero_frames : how many (still) frames give a zero
    leaves_out : a network needs all of its channels
    """

    model: DeployedModel
    zero: ZeroMode = "rest"
    zero_frames: int = ZERO_FRAMES
    leaves_out: bool = False
    recent: deque[np.ndarray] = field(default_factory=deque)
    last_s: float = math.nan

    def __post_init__(self) -> None:
        self.rezero()

    def feed(
        self,
        raw_counts: Float[np.ndarray, "face sensor 3"],
        time_s: float = math.nan,
        left_out: Bool[np.ndarray, "face sensor 3"] | None = None,
    ) -> Prediction | None:
        """Read one frame of raw counts, faces in order from 1; None while there is no zero.

        Raises
        ------
        InputError
            A channel that the model uses does not exist, misses its reading, or has one that is not to be
            believed (`left_out`).
        """
        if left_out is not None:
            raw_counts = np.where(left_out, np.nan, raw_counts)
        now = channel_readings(raw_counts, self.model.channels)
        if is_pause(time_s - self.last_s):
            self.recent.clear()
        self.last_s = time_s
        self._remember(now)
        zero = self.level.update(now, time_s)
        if zero is None:
            return None
        counts = np.where(self._past, now - self.recent[0], now - zero)
        return run_model(self.model, counts[None])

    def miss(self) -> None:
        """Pass over a frame that lacks a reading: the one before stands in for it, so that changes over
        `history_frames` keep their span."""
        if self.recent:
            self._remember(self.recent[-1])

    def _remember(self, counts: Float[np.ndarray, "channel"]) -> None:
        self.recent.append(counts)
        if len(self.recent) > self.model.history_frames + 1:
            self.recent.popleft()

    def rezero(self, level: Float[np.ndarray, "channel"] | None = None) -> None:
        """Take the zero again from the frames that follow, with nothing pressed, or the level given."""
        self.level = StreamZero(self.zero, self.zero_frames, self.read_still, level=level)
        self.recent.clear()

    @cached_property
    def _past(self) -> Bool[np.ndarray, "channel"]:
        return np.array([face >= HISTORY for face, _, _ in self.model.channels])

    def read_still(self, change: Float[np.ndarray, "channel"], frames: int = 1) -> StillReading:
        prediction = run_model(self.model, np.where(self._past, 0.0, change)[None])
        return StillReading(float(prediction.contact[0]), float(prediction.force_n[0]))


def channel_readings(
    raw_counts: Float[np.ndarray, "face sensor 3"], channels: tuple[Channel, ...]
) -> Float[np.ndarray, "channel"]:
    """Counts of the given channels in one frame, faces in order from 1.

    Raises
    ------
    InputError
        A channel does not exist or misses its reading.
    """
    values = []
    for face, sensor, axis in channels:
        index = (face % HISTORY - 1, sensor, axis)
        inside = index[0] < raw_counts.shape[0] and sensor < raw_counts.shape[1]
        value = raw_counts[index] if inside else np.nan
        if np.isnan(value):
            raise InputError(
                f"channel {channel_label((face % HISTORY, sensor, axis))}, which the model "
                "uses, gives no reading, or none to believe. Fix the sensor, or train anew without it"
            )
        values.append(value)
    return np.array(values)

"""Refusal of readings that are of another object than an estimator's."""

from __future__ import annotations

import numpy as np
from jaxtyping import Float, Int

from design.errors import InputError
from estimator.frames.dataset import FrameSet
from estimator.frames.face_data import HISTORY, Channel

Grid = tuple[Float[np.ndarray, "nx"], Float[np.ndarray, "ny"]]
AnyGrid = tuple[Float[np.ndarray, "_"], Float[np.ndarray, "_"]]
"""Two of them may differ in length."""
_SAME_PLACE_MM = 1e-3
"""Distance below which two places are one."""


def require_same_object(
    channels: tuple[Channel, ...], grid_mm: Grid, frames: FrameSet, source: str
) -> None:
    """Refuse a data set of other sensors or on another contact grid than the estimator's.

    `source` names the data set in the message.

    Raises
    ------
    InputError
        Sensors that the estimator does not know on a face that it reads, or another grid.
    """
    require_same_sensors(channels, frames.signal_counts, frames.faces, source)
    grids = grid_mm, (frames.grid_x_mm, frames.grid_y_mm)
    if same_grid(*grids):
        return
    model_grid, data_grid = (" by ".join(_grid_text(axis) for axis in grid) for grid in grids)
    raise InputError(
        f"the model's contact grid is {model_grid}; that of {source} is {data_grid}, so "
        "it is of another object "
        "or was read without its specification. Use the model of the object that was recorded, or "
        "read the recording with `instobj recordings --spec`"
    )


def same_grid(one_mm: AnyGrid, other_mm: AnyGrid) -> bool:
    """Return whether two contact grids have the same places along both axes, to 1 µm."""
    return all(
        len(a) == len(b) and np.allclose(a, b, atol=_SAME_PLACE_MM)
        for a, b in zip(one_mm, other_mm, strict=True)
    )


def require_same_sensors(
    channels: tuple[Channel, ...],
    counts: Float[np.ndarray, "frame face sensor 3"],
    faces: Int[np.ndarray, "face"],
    source: str,
) -> None:
    """Refuse readings of sensors that the estimator does not know, on the faces that it reads.

    A channel or a sensor that was left out in training may be alive in the readings; more sensors than
    the estimator knows on any face are of another object.

    Raises
    ------
    InputError
        Such a sensor.
    """
    known_sensors = {(face % HISTORY, sensor) for face, sensor, _ in channels}
    read = {face for face, _ in known_sensors}
    numbers = faces.tolist()
    live_pairs = np.argwhere(np.isfinite(counts).any(axis=(0, 3)))
    live = {(numbers[row], int(sensor)) for row, sensor in live_pairs}
    count = 1 + max(sensor for _, sensor in known_sensors)
    unknown = {(face, sensor) for face, sensor in live if face in read and sensor >= count}
    if unknown:
        raise InputError(
            f"the model reads {len(channels)} channels, of the sensors {_sensor_names(known_sensors)}; "
            f"{source} also has readings of {_sensor_names(unknown)}, so it is of another object. "
            "Use the model of the object that was recorded, or train one on its recordings"
        )


def _sensor_names(sensors: set[tuple[int, int]]) -> str:
    return ", ".join(f"F{face}-S{sensor + 1}" for face, sensor in sorted(sensors))


def _grid_text(places_mm: Float[np.ndarray, "n"]) -> str:
    return f"{len(places_mm)} places from {places_mm[0]:g} to {places_mm[-1]:g} mm"

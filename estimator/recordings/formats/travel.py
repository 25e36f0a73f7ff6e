"""Recordings of presses of known travel: field and place of the indenter, one row a reading.

A recording is a folder of two tables without header lines, as the eFlesh project publishes them:
`sensor.csv` holds a time (s) and three readings (µT) of every chip, `states.csv` a time, the
indenter's x, y, z (mm, of the machine) and, where there is one, the reading of a load cell. Rows
belong together by their number; both times are those of one clock.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from jaxtyping import Bool, Float, Int

from design.errors import RecordingError
from estimator.recordings.formats.text import check_complete, csv_rows, naming, numbers, read_bytes

SENSOR_FILE, STATE_FILE = "sensor.csv", "states.csv"
_LARGEST_LAG_S = 1.0
"""Largest time between a reading and the travel's that belongs to it."""
_LARGEST_UT, _LARGEST_MM = 1e6, 1e4
"""Largest reading and travel that may be meant."""
_NO_LOAD = -1.0
"""Value that stands for no load cell."""
_STATE_COLUMNS = ("time", "x", "y", "z", "load")


@dataclass(frozen=True)
class TravelRecording:
    """Readings in the order of the files.

    `place_id` numbers the places by x, then y, whole millimetres apart; a smaller z is deeper. `load`
    is the load cell's reading, in its own unit, NaN where it gave none or there is none.
    """

    time_s: Float[np.ndarray, "press"]
    tip_mm: Float[np.ndarray, "press 3"]
    field_mt: Float[np.ndarray, "press sensor 3"]
    place_id: Int[np.ndarray, "press"]
    load: Float[np.ndarray, "press"] | None = None

    def __len__(self) -> int:
        return len(self.time_s)

    @property
    def places(self) -> int:
        return int(self.place_id.max()) + 1

    def select(self, rows: Bool[np.ndarray, "press"]) -> TravelRecording:
        """Some of the readings; places keep their numbers."""
        load = None if self.load is None else self.load[rows]
        return TravelRecording(
            self.time_s[rows], self.tip_mm[rows], self.field_mt[rows], self.place_id[rows], load
        )


def is_travel_recording(path: Path) -> bool:
    """Return whether a path is a folder of this kind, damaged or not."""
    return path.is_dir() and any((path / name).exists() for name in (SENSOR_FILE, STATE_FILE))


def read_travel(folder: Path | str) -> TravelRecording:
    """Read a folder of `sensor.csv` and `states.csv`.

    Raises
    ------
    RecordingError
        No folder, a file that is missing or damaged, or two that do not belong together.
    """
    folder = Path(folder)
    if folder.is_file():
        raise RecordingError(
            f"{folder} is a file. Give the folder that holds {SENSOR_FILE} and {STATE_FILE}"
        )
    sensor = _table(folder / SENSOR_FILE, None)
    state = _table(folder / STATE_FILE, _STATE_COLUMNS)
    with naming(folder):
        if len(sensor) != len(state):
            raise RecordingError(
                f"{SENSOR_FILE} holds {len(sensor)} rows, {STATE_FILE} {len(state)}. Rows belong "
                "together by their number: copy both files anew"
            )
        lag = np.abs(sensor[:, 0] - state[:, 0])
        if lag.max() > _LARGEST_LAG_S:
            row = int(np.argmax(lag))
            raise RecordingError(
                f"row {row + 1}: {SENSOR_FILE} and {STATE_FILE} are {lag[row]:.3g} s apart, so they "
                "do not belong together. Give the two files of one recording"
            )
    tip = state[:, 1:4]
    _, place = np.unique(np.round(tip[:, :2]), axis=0, return_inverse=True)
    field = 1e-3 * sensor[:, 1:].reshape(len(sensor), -1, 3)
    load = None
    if state.shape[1] > 4:
        load = np.where(state[:, 4] == _NO_LOAD, np.nan, state[:, 4])
    return TravelRecording(sensor[:, 0], tip, field, place.ravel(), load)


def _table(path: Path, columns: tuple[str, ...] | None) -> np.ndarray:
    """All rows of a file without a header; without `columns`, time and three readings per chip."""
    with naming(path):
        rows, _ = csv_rows(read_bytes(path))
        width = len(rows[0])
        if columns is None:
            if width < 4 or (width - 1) % 3:
                raise RecordingError(
                    f"line 1 holds {width} cells; a time and three readings for every chip belong "
                    "there. Give the file as it was recorded"
                )
            columns, largest = ("time", *(f"reading {k}" for k in range(1, width))), _LARGEST_UT
            limited = slice(1, width)
        elif width not in (len(columns) - 1, len(columns)):
            raise RecordingError(
                f"line 1 holds {width} cells; time, x, y, z and perhaps a load belong there. Give "
                "the file as it was recorded"
            )
        else:
            columns, largest, limited = columns[:width], _LARGEST_MM, slice(1, 4)
        names = list(columns)
        values = numbers(rows, names, 1)
        check_complete(values, names)
        beyond = np.abs(values[:, limited]) > largest
        if beyond.any():
            row = int(np.argmax(beyond.any(axis=1)))
            column = names[1 + int(np.argmax(beyond[row]))]
            raise RecordingError(
                f"line {row + 1}: {column} is {values[row, names.index(column)]:g}, beyond "
                f"±{largest:g}. Fix that line or delete it in both files"
            )
    return values

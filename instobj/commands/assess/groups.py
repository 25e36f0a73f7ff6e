"""Groups of recordings that are ranked, and their grasps as rows of tables, CSV and JSON."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from design.tables import write_table
from estimator.grasps.measures import MeasuredGrasp, Reading
from estimator.grasps.phases import START_N
from estimator.grasps.protocols import MEASURES, Measure
from estimator.grasps.ranking import Difference, median_interval
from estimator.grasps.track import track_of_labels
from instobj.commands.assess.tracks import MOST_UNEXPLAINED, ReadRecording, unexplained_share
from instobj.report.cells import shown


@dataclass(frozen=True)
class MeasuredRecording:
    """A file and its grasps; `cells` compares forces of faces with load cells, grasp by grasp."""

    read: ReadRecording
    grasps: list[MeasuredGrasp]
    cells: list[dict[str, Any]]


@dataclass(frozen=True)
class Group:
    """Gripper, policy or pad that is ranked, and its recordings."""

    name: str
    recordings: list[MeasuredRecording]

    @property
    def grasps(self) -> list[tuple[MeasuredRecording, MeasuredGrasp]]:
        """All grasps, in order."""
        return [(recording, grasp) for recording in self.recordings for grasp in recording.grasps]

    @property
    def trusted(self) -> bool:
        """Return whether it has grasps, and the estimator explains most of the pressed frames."""
        return bool(self.grasps) and self.unexplained <= MOST_UNEXPLAINED

    @property
    def unexplained(self) -> float:
        """Share of the pressed frames that are not explained, of those outside the grasps as well."""
        return unexplained_share([recording.read.track for recording in self.recordings])

    def rows(self) -> list[dict[str, Any]]:
        """Name of every grasp: group, recording and number."""
        return [
            {"group": self.name, "recording": recording.read.path.name, "grasp": grasp.grasp.number}
            for recording, grasp in self.grasps
        ]

    def values(self, measure: str) -> np.ndarray:
        """A measure of every grasp."""
        return np.array([grasp.readings[measure].value for _, grasp in self.grasps])


def are_paired(groups: list[Group]) -> bool:
    """Return whether groups hold files of the same names with as many grasps each: one sequence repeated."""
    sequences = [
        [(recording.read.path.name, len(recording.grasps)) for recording in group.recordings]
        for group in groups
    ]
    folders = all(len(sequence) == len(sequences[0]) for sequence in sequences)
    return len(groups) > 1 and folders and all(s == sequences[0] for s in sequences)


def measure_of(name: str) -> Measure:
    """Return what is said of a measure, of a chance of damage as well."""
    if name in MEASURES:
        return MEASURES[name]
    fruit = name.removeprefix("damage_")
    return Measure(
        f"chance of damage to {fruit}", "1", f"share of {fruit} fruits that the peak damages",
        "Hertz and the limit named below. Against a solved ball of flesh its depth is 2 % high; under a "
        "skin of 0.3 mm, ten times as stiff, depth is 8 to 12 % and work 5 to 6 % high, pressure on the skin "
        "12 to 28 % low", "lower",
    )  # fmt: skip


def axis_of(name: str) -> str:
    """Title of a measure with its unit."""
    measure = measure_of(name)
    return measure.title if measure.unit == "1" else f"{measure.title} ({measure.unit})"


def compared_with_cells(read: ReadRecording, grasps: list[MeasuredGrasp]) -> list[dict[str, Any]]:
    """Mean force of each face in the holds, read and by its load cell; nothing without cells."""
    if read.cells is None:
        return []
    cells = track_of_labels(read.cells)
    rows = []
    for grasp in grasps:
        held = (cells.time_s >= read.track.time_s[grasp.grasp.hold]) & (
            cells.time_s <= read.track.time_s[grasp.grasp.release - 1]
        )
        for face in np.unique(cells.face[held][cells.face[held] > 0]).tolist():
            mean = grasp.faces[face][0] if face in grasp.faces else Reading(0.0)
            shown = float(cells.face_force_n(face)[held].mean())
            rows.append(
                {
                    "recording": read.path.name,
                    "grasp": grasp.grasp.number,
                    "face": face,
                    "read N": round(mean.value, 3),
                    "low N": round(mean.low, 3),
                    "high N": round(mean.high, 3),
                    "load cell N": round(shown, 3),
                    "inside": bool(mean.low <= shown <= mean.high),
                }
            )
    return rows


def missed_share(groups: list[Group]) -> float:
    """Share of the frames in which load cells show a grasp's force, but which lie in no grasp; NaN without
    such frames."""
    pressed = missed = 0
    for recording in (recording for group in groups for recording in group.recordings):
        if recording.read.cells is not None:
            felt = track_of_labels(recording.read.cells).total_n > START_N
            pressed += int(felt.sum())
            for grasp in recording.grasps:
                felt[grasp.grasp.start : grasp.grasp.end] = False
            missed += int(felt.sum())
    return missed / pressed if pressed else float("nan")


def cell_rows(groups: list[Group]) -> list[dict[str, Any]]:
    """Rows of `compared_with_cells` of all groups."""
    return [row for group in groups for recording in group.recordings for row in recording.cells]


def named_grasps(groups: list[Group]) -> list[tuple[dict[str, Any], MeasuredGrasp]]:
    """Every grasp with its name."""
    return [
        (name, grasp)
        for group in groups
        for name, (_, grasp) in zip(group.rows(), group.grasps, strict=True)
    ]


def grasp_rows(groups: list[Group], names: list[str]) -> list[dict[str, Any]]:
    """Measures of every grasp with their intervals, in words."""
    return [
        row | {axis_of(name): with_ends(grasp.readings[name]) for name in names}
        for row, grasp in named_grasps(groups)
    ]


def with_ends(reading: Reading) -> str:
    """A figure with its interval, where it has one."""
    if np.isnan(reading.low):
        return shown(reading.value)
    return f"{shown(reading.value)} ({shown(reading.low)} to {shown(reading.high)})"


def median_rows(groups: list[Group], names: list[str]) -> list[dict[str, Any]]:
    """Medians of every group with their intervals, a row a measure."""
    rows = []
    for name in names:
        row = {"measure": axis_of(name)}
        for group in groups:
            if group.grasps:
                row[group.name] = with_ends(Reading(*median_interval(group.values(name))))
        rows.append(row)
    return rows if groups else []


def difference_row(difference: Difference) -> dict[str, Any]:
    """A comparison as tables show it."""
    return {
        "first": difference.first,
        "second": difference.second,
        "second − first": f"{shown(difference.shift)} ({shown(difference.low)} to {shown(difference.high)})",
        "p": float(f"{difference.p_value:.2g}"),
        "test": "signed ranks of pairs" if difference.paired else "rank sums",
        "sure": "yes" if difference.sure else "no",
        "more grasps of each": "–" if difference.more_grasps is None else difference.more_grasps,
    }


def risk_rows(groups: list[Group], limits: list[str]) -> list[dict[str, Any]]:
    """The five contacts with the largest chance of damage, of grasps whose places may be believed."""
    rows = [
        row | {name: round(value, 3) for name, value in place.items()}
        for row, grasp in named_grasps([group for group in groups if group.trusted])
        if grasp.placed
        for place in grasp.places
    ]
    return sorted(rows, key=lambda row: -row[limits[0]])[:5] if limits else []


def full_rows(groups: list[Group]) -> list[dict[str, Any]]:
    """Every measure of every grasp with its interval, a column each; of groups that are not trusted when
    each grasp was, and how little is explained."""
    rows = []
    for group in groups:
        for row, grasp in named_grasps([group]):
            row |= {"start_s": grasp.start_s, "end_s": grasp.end_s}
            for name, reading in grasp.readings.items():
                if group.trusted or name == "unexplained":
                    row |= {name: reading.value} | {
                        f"{name}_{end}": getattr(reading, end) for end in ("low", "high")
                    }
            rows.append(row)
    return rows


def write_csv(path: Path, rows: list[dict[str, Any]]) -> Path:
    """Write rows as CSV; what is not known is empty."""
    header = list(dict.fromkeys(name for row in rows for name in row))
    finite_rows = ({name: value for name, value in row.items() if value == value} for row in rows)
    write_table(path, header, ([row.get(name, "") for name in header] for row in finite_rows))
    return path


def whole_document(document: dict[str, Any], groups: list[Group]) -> dict[str, Any]:
    """The document with all figures of all grasps; what is not known is null."""
    trusted = [group for group in groups if group.trusted]
    withheld = full_rows([group for group in groups if not group.trusted])
    grasps = [
        row
        | {
            "phases": vars(grasp.grasp),
            "wrench": grasp.wrench.tolist(),
            "wrench_covariance": grasp.covariance.tolist(),
            "faces": {
                str(face): {"mean_n": mean.value, "peak_n": peak.value}
                for face, (mean, peak) in grasp.faces.items()
            },
            "places": grasp.places,
        }
        for row, (_, grasp) in zip(full_rows(trusted), named_grasps(trusted), strict=True)
    ]
    return json_value(document | {"grasps": [*grasps, *withheld]})


def json_value(value: Any) -> Any:
    """The same with None for figures that JSON cannot write."""
    if isinstance(value, dict):
        return {name: json_value(member) for name, member in value.items()}
    if isinstance(value, list):
        return [json_value(member) for member in value]
    return None if isinstance(value, float) and not np.isfinite(value) else value

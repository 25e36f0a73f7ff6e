"""`instobj assess`: grasps in recordings measured from the object's side, and grippers ranked."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from design.errors import InputError
from design.files import atomic_path
from design.layout.body import face_frames
from design.spec.object import ObjectSpec
from estimator.grasps.damage import Sphere, read_limits
from estimator.grasps.measures import Conditions, MeasuredGrasp, Reading, measured_grasps
from estimator.grasps.protocols import MEASURES, PROTOCOLS, Measure, Protocol
from estimator.grasps.ranking import (
    LEVEL,
    Difference,
    compare,
    exchanged_share,
    median_interval,
)
from estimator.grasps.track import track_of_labels
from instobj.commands.grasp_tracks import (
    MOST_UNEXPLAINED,
    ReadRecording,
    load_estimators,
    read_grasps_of,
    recordings_in,
)
from instobj.commands.readings import Zeroing
from instobj.figures.grasps import GroupPicture, draw_grasps
from instobj.report.grasps import write_grasps_page
from instobj.report.pages import shown
from instobj.store.publish import file_rows, require_writable, run_folder, run_name

_DISTRUST = 0.2
"""Share of frames without explanation from which a page warns of it."""
_MOST_ROWS = 12
"""Rows of a table that a terminal shows."""
_FEW = 6
"""Grasps below which an interval of their median is too narrow."""


@dataclass(frozen=True)
class AssessOptions:
    """Options of `instobj assess`.

    Attributes
    ----------
    paths : recordings, data sets, or folders of them; each is a gripper or policy
    model : folder of estimators, or one of its files
    limit : name of a fruit, or a TOML file; None for no damage
    friction, weight_n : between gripper and object, and of the object (0: not known)
    """

    paths: tuple[Path, ...]
    model: Path
    spec: Path | None
    protocol: str
    limit: str | None
    friction: float
    weight_n: float
    zeroing: Zeroing
    out: Path


@dataclass(frozen=True)
class MeasuredRecording:
    """A file and its grasps; `cells` compares forces of faces with load cells, grasp by grasp."""

    read: ReadRecording
    grasps: list[MeasuredGrasp]
    cells: list[dict[str, Any]]


@dataclass(frozen=True)
class Group:
    """What is ranked: a gripper, a policy or a pad, and its recordings."""

    name: str
    recordings: list[MeasuredRecording]

    @property
    def grasps(self) -> list[tuple[MeasuredRecording, MeasuredGrasp]]:
        """All grasps, in order."""
        return [(recording, grasp) for recording in self.recordings for grasp in recording.grasps]

    @property
    def trusted(self) -> bool:
        """Return whether it has grasps, most of whose frames the estimator explains."""
        shares = self.values("unexplained")
        return bool(len(shares)) and float(shares.mean()) <= MOST_UNEXPLAINED

    def values(self, measure: str) -> np.ndarray:
        """A measure of every grasp."""
        return np.array([grasp.readings[measure].value for _, grasp in self.grasps])


def assess(options: AssessOptions) -> dict[str, Any]:
    """Measure the grasps of all recordings and rank the groups; writes page, figure, CSV and JSON to
    `runs/<name>/assess/`.

    Raises
    ------
    InputError
        An unknown protocol, bad limits, models or recordings, or no grasp in any recording.
    """
    protocol = PROTOCOLS.get(options.protocol)
    if protocol is None:
        raise InputError(
            f"--protocol {options.protocol!r} is unknown. Choose one of {', '.join(PROTOCOLS)}"
        )
    limits = () if options.limit is None else tuple(read_limits(options.limit))
    files = [recordings_in(path) for path in options.paths]
    names = _names(options.paths)
    require_writable(options.out)
    estimators = load_estimators(options.model, options.spec)
    spec = estimators.spec
    conditions = replace(
        conditions_of(spec), friction=options.friction, weight_n=options.weight_n, limits=limits
    )
    groups = []
    for name, paths in zip(names, files, strict=True):
        read = [read_grasps_of(path, estimators, options.zeroing) for path in paths]
        groups.append(Group(name, [_measured(one, conditions, protocol) for one in read]))
    if not any(group.grasps for group in groups):
        raise InputError(
            f"no grasp in {', '.join(map(str, options.paths))}: the estimator reads less than a touch of two "
            "jaws. Check that the recording is of this object and that it begins at rest (--zero)"
            + " between two opposite sides"
            * protocol.pinch
        )
    return _document(options, protocol, conditions, groups)


def conditions_of(spec: ObjectSpec) -> Conditions:
    """Faces, skin and tips of a specification; the tip is that of its indenter."""
    radius = spec.indenter.radius_mm
    skin = Sphere(spec.silicone.youngs_modulus_mpa, spec.silicone.poisson_ratio, radius)
    return Conditions({frame.number: frame for frame in face_frames(spec)}, skin, radius)


def _names(paths: Sequence[Path]) -> list[str]:
    """Short names of what is compared; where those are the same, the parts of the paths that differ."""
    short = [path.absolute().name if path.is_dir() else run_name(path) for path in paths]
    if len(set(short)) == len(short):
        return short
    parts = [path.absolute().parts for path in paths]
    common = set(parts[0]).intersection(*parts[1:])
    own = ["/".join(part for part in each if part not in common) for each in parts]
    if len(set(own)) < len(own):
        raise InputError(
            "the same recording or folder is given twice. Give each gripper's recordings once"
        )
    return own


def _measured(read: ReadRecording, conditions: Conditions, protocol: Protocol) -> MeasuredRecording:
    grasps = measured_grasps(read.track, conditions)
    if protocol.pinch:
        grasps = [grasp for grasp in grasps if grasp.opposed]
    return MeasuredRecording(read, grasps, _beside_cells(read, grasps))


def _beside_cells(read: ReadRecording, grasps: list[MeasuredGrasp]) -> list[dict[str, Any]]:
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


def _document(
    options: AssessOptions, protocol: Protocol, conditions: Conditions, groups: list[Group]
) -> dict[str, Any]:
    limits = [f"damage_{limit.name}" for limit in conditions.limits]
    names = [*protocol.measures, *limits]
    with_grasps = [group for group in groups if group.trusted]
    paired = _is_paired(with_grasps)
    differences = {
        name: compare({group.name: group.values(name) for group in with_grasps}, paired)
        for name in (protocol.headline, *limits)
    }
    sentences = _sentences(with_grasps, differences)
    folder = (
        run_folder(options.out, "+".join(_file_name(group.name) for group in groups)) / "assess"
    )
    tables = {
        "grasps": _grasp_rows(groups, names),
        "medians": _median_rows(groups, names),
        "ranking": [
            {"measure": _axis(name)} | _difference_row(one)
            for name, pairs in differences.items()
            for one in pairs
        ],
        "faces beside load cells": _cell_rows(groups),
        "places most at risk": _risk_rows(groups, limits),
    }
    faults = [text for group in groups for one in group.recordings for text in one.read.faults]
    document = {
        "command": "assess",
        "protocol": options.protocol,
        "model": str(options.model),
        "definition": protocol.definition,
        "friction": conditions.friction,
        "weight N": conditions.weight_n,
        "faults": faults,
        "texts": [*sentences, *_warnings(options, groups, conditions)],
        "tables": {title: rows for title, rows in tables.items() if rows},
    }
    if len(with_grasps) > 1:
        ranked = {group.name: group.values(protocol.headline) for group in with_grasps}
        document["exchanged"] = exchanged_share(ranked, paired)
    figure = folder / "assess.png"
    headline = protocol.headline
    draw_grasps(
        [_picture(group, headline) for group in groups if group.grasps], _axis(headline), figure
    )
    written = [
        figure,
        _write(folder / "grasps.csv", _csv(_full_rows(groups))),
        _write(folder / "assess.json", json.dumps(_whole(document, groups), indent=1)),
        write_grasps_page(
            folder / "assess.html", document, figure, _definitions(names, conditions)
        ),
    ]
    # long tables stand on the page; a terminal shows those that fit a screen
    short = {title: rows for title, rows in document["tables"].items() if len(rows) <= _MOST_ROWS}
    return document | {"tables": short, "files": file_rows(written)}


def _measure(name: str) -> Measure:
    """Return what is said of a measure, of a chance of damage as well."""
    if name in MEASURES:
        return MEASURES[name]
    fruit = name.removeprefix("damage_")
    return Measure(
        f"chance of damage to {fruit}", "1", f"share of {fruit} fruits that the peak damages",
        "Hertz and the limit named below", "lower",
    )  # fmt: skip


def _axis(name: str) -> str:
    measure = _measure(name)
    return measure.title if measure.unit == "1" else f"{measure.title} ({measure.unit})"


def _is_paired(groups: list[Group]) -> bool:
    """Return whether groups hold files of the same names with as many grasps each: one sequence repeated."""
    sequences = [
        [(one.read.path.name, len(one.grasps)) for one in group.recordings] for group in groups
    ]
    folders = all(len(sequence) == len(sequences[0]) for sequence in sequences)
    return len(groups) > 1 and folders and all(s == sequences[0] for s in sequences)


def _median_text(group: Group, measure: str) -> str:
    values = group.values(measure)
    median, low, high = median_interval(values)
    unit = "" if _measure(measure).unit == "1" else f" {_measure(measure).unit}"
    count = int(np.isfinite(values).sum())
    interval = "" if np.isnan(low) else f", 95 % interval {shown(low)} to {shown(high)}"
    return f"{shown(median)}{unit} (median of {count} grasps{interval})"


def _sentences(groups: list[Group], differences: dict[str, list[Difference]]) -> list[str]:
    """Return what decides something, ready for a paper."""
    texts = []
    for name, pairs in differences.items():
        title = _measure(name).title
        texts += [f"{group.name}: {title} {_median_text(group, name)}." for group in groups]
        texts += [_difference_text(one, name) for one in pairs]
    return texts


def _difference_text(one: Difference, headline: str) -> str:
    measure = _measure(headline)
    test = "Wilcoxon, pairs" if one.paired else "Mann–Whitney"
    unit = "" if measure.unit == "1" else f" {measure.unit}"
    if not one.sure:
        more = "more grasps will hardly tell" if one.more_grasps is None else (
            f"about {one.more_grasps} more grasps of each would, if the difference is as large as it looks"
        )  # fmt: skip
        return (
            f"{one.first} and {one.second} cannot be ranked by {measure.title} (p = {one.p_value:.2g}, "
            f"{test}): {more}."
        )
    less, more = (one.first, one.second) if one.shift > 0 else (one.second, one.first)
    better, worse = (less, more) if measure.better == "lower" else (more, less)
    sign = 1 if one.shift > 0 else -1
    ends = sorted((sign * one.low, sign * one.high))
    relation = "lower" if measure.better == "lower" else "higher"
    return (
        f"{better} has a {relation} {measure.title} than {worse}: by {shown(abs(one.shift))}{unit} in "
        f"the median (95 % interval {shown(ends[0])} to {shown(ends[1])}; p = {one.p_value:.1g}, "
        f"{test})."
    )


def _warnings(options: AssessOptions, groups: list[Group], conditions: Conditions) -> list[str]:
    """Return what cannot be said, and why."""
    tracks = [one.read for group in groups for one in group.recordings]
    texts = list(dict.fromkeys(text for read in tracks for text in read.texts))
    for group in groups:
        if not group.grasps:
            texts.append(f"{group.name}: no grasp found; it is not ranked.")
        elif len(group.grasps) < _FEW:
            texts.append(
                f"{group.name}: {len(group.grasps)} grasps are few; its interval is too narrow."
            )
        shares = group.values("unexplained")
        if len(shares) and shares.mean() > _DISTRUST:
            texts.append(
                f"{group.name}: the estimator cannot explain {100 * shares.mean():.0f} % of the grasps' "
                "frames; forces and places may be wrong by more than their intervals"
                + (", and it is not ranked." if not group.trusted else ".")
            )
    if not any(read.track.has_tangential for read in tracks):
        texts.append(
            "Tangential forces are not read by this estimator: friction used, and the part of the "
            f"balance across the jaws, are unknown within a friction of {conditions.friction:g}."
        )
    if any(read.method == "networks" for read in tracks):
        texts.append(
            "Networks read one whole force and its centre a face: tips of one jaw are not told apart."
        )
    if not options.weight_n:
        texts.append(
            "The weight is not given (--weight): balance is judged as if the object weighed nothing."
        )
    out = _balance_text(groups)
    return [*texts, out] if out else texts


def _balance_text(groups: list[Group]) -> str:
    values = np.concatenate([group.values("equilibrium_p") for group in groups])
    known = values[np.isfinite(values)]
    if not len(known):
        return ""
    balanced = int(np.sum(known >= LEVEL))
    text = f"Contacts balance within their uncertainty in {balanced} of {len(known)} grasps"
    rows = _cell_rows(groups)
    if rows:
        inside = sum(row["inside"] for row in rows)
        text += (
            f"; load cells lie in the 90 % interval of their face in {inside} of {len(rows)} cases"
        )
    return f"{text}."


def _grasp_rows(groups: list[Group], names: list[str]) -> list[dict[str, Any]]:
    return [
        {"group": group.name, "recording": recording.read.path.name, "grasp": grasp.grasp.number}
        | {
            _axis(name): _with_ends(grasp.readings.get(name, Reading(float("nan"))))
            for name in names
        }
        for group in groups
        for recording, grasp in group.grasps
    ]


def _with_ends(reading: Reading) -> str:
    if np.isnan(reading.low):
        return shown(reading.value)
    return f"{shown(reading.value)} ({shown(reading.low)} to {shown(reading.high)})"


def _median_rows(groups: list[Group], names: list[str]) -> list[dict[str, Any]]:
    rows = []
    for name in names:
        row = {"measure": _axis(name)}
        for group in groups:
            if group.grasps:
                row[group.name] = _with_ends(Reading(*median_interval(group.values(name))))
        rows.append(row)
    return rows


def _difference_row(one: Difference) -> dict[str, Any]:
    return {
        "first": one.first,
        "second": one.second,
        "second − first": f"{shown(one.shift)} ({shown(one.low)} to {shown(one.high)})",
        "p": float(f"{one.p_value:.2g}"),
        "test": "signed ranks of pairs" if one.paired else "rank sums",
        "sure": "yes" if one.sure else "no",
        "more grasps of each": "–" if one.more_grasps is None else one.more_grasps,
    }


def _cell_rows(groups: list[Group]) -> list[dict[str, Any]]:
    return [row for group in groups for recording in group.recordings for row in recording.cells]


def _risk_rows(groups: list[Group], limits: list[str]) -> list[dict[str, Any]]:
    """The five contacts with the largest chance of damage."""
    if not limits:
        return []
    rows = [
        {"group": group.name, "recording": recording.read.path.name, "grasp": grasp.grasp.number}
        | {name: round(value, 3) for name, value in place.items()}
        for group in groups
        for recording, grasp in group.grasps
        for place in grasp.places
    ]
    return sorted(rows, key=lambda row: -row[limits[0]])[:5]


def _full_rows(groups: list[Group]) -> list[dict[str, Any]]:
    """Every measure of every grasp with its interval, a column each."""
    rows = []
    for group in groups:
        for recording, grasp in group.grasps:
            row: dict[str, Any] = {
                "group": group.name,
                "recording": recording.read.path.name,
                "grasp": grasp.grasp.number,
                "start_s": grasp.start_s,
                "end_s": grasp.end_s,
            }
            for name, reading in grasp.readings.items():
                ends = {"": reading.value, "_low": reading.low, "_high": reading.high}
                row |= {f"{name}{end}": value for end, value in ends.items()}
            rows.append(row)
    return rows


def _csv(rows: list[dict[str, Any]]) -> str:
    stream = io.StringIO()
    writer = csv.DictWriter(stream, list(dict.fromkeys(name for row in rows for name in row)))
    writer.writeheader()
    writer.writerows(
        {name: "" if value != value else value for name, value in row.items()} for row in rows
    )
    return stream.getvalue()


def _whole(document: dict[str, Any], groups: list[Group]) -> dict[str, Any]:
    """The document with all figures of all grasps; what is not known is null."""
    grasps = [
        row
        | {
            "phases": {
                name: getattr(grasp.grasp, name)
                for name in ("approach", "start", "hold", "release", "end")
            },
            "wrench": grasp.wrench.tolist(),
            "wrench_covariance": grasp.covariance.tolist(),
            "faces": {
                str(face): {"mean_n": mean.value, "peak_n": peak.value}
                for face, (mean, peak) in grasp.faces.items()
            },
            "places": grasp.places,
        }
        for row, (_, grasp) in zip(
            _full_rows(groups), [pair for group in groups for pair in group.grasps], strict=True
        )
    ]
    return _known(document | {"grasps": grasps})


def _known(value: Any) -> Any:
    """The same with None for figures that JSON cannot write."""
    if isinstance(value, dict):
        return {name: _known(one) for name, one in value.items()}
    if isinstance(value, list):
        return [_known(one) for one in value]
    return None if isinstance(value, float) and not np.isfinite(value) else value


def _definitions(names: list[str], conditions: Conditions) -> list[list[str]]:
    rows = [[_axis(name), _measure(name).definition, _measure(name).source] for name in names]
    return rows + [
        [f"limit: {limit.name}", f"{limit.quantity} {limit.median:g}, spread {limit.spread:g} of ln. "
         f"{limit.note}", limit.source]
        for limit in conditions.limits
    ]  # fmt: skip


def _picture(group: Group, headline: str) -> GroupPicture:
    curves = []
    for recording, grasp in group.grasps:
        track = recording.read.track.select(slice(grasp.grasp.start, grasp.grasp.end))
        curves.append((track.time_s - track.time_s[0], track.total_n))
    readings = [grasp.readings[headline] for _, grasp in group.grasps]
    ends = np.array([[one.value, one.low, one.high] for one in readings]).reshape(-1, 3)
    return GroupPicture(group.name, curves, ends, median_interval(group.values(headline)))


def _file_name(name: str) -> str:
    return name.strip("/").replace("/", "_").replace("\\", "_")


def _write(path: Path, text: str) -> Path:
    with atomic_path(path) as temporary:
        temporary.write_text(text, encoding="utf-8")
    return path

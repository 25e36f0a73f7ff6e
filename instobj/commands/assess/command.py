"""`instobj assess`: grasps in recordings measured from the object's side, and grippers ranked."""

from __future__ import annotations

import base64
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from design.errors import InputError
from design.spec.object import ObjectSpec
from estimator.grasps.damage import read_limits
from estimator.grasps.measures import Conditions, conditions_of, measured_grasps
from estimator.grasps.protocols import PROTOCOLS, Protocol
from estimator.grasps.ranking import compare, exchanged_share, median_interval
from instobj.commands.assess.groups import (
    Group,
    MeasuredRecording,
    are_paired,
    axis_of,
    cell_rows,
    compared_with_cells,
    difference_row,
    full_rows,
    grasp_rows,
    measure_of,
    median_rows,
    risk_rows,
    whole_document,
    write_csv,
)
from instobj.commands.assess.played import grasps_scene
from instobj.commands.assess.sentences import sentences, verdict_text, warnings_of
from instobj.commands.assess.tracks import (
    ReadRecording,
    frame_documents,
    load_estimators,
    read_grasps_of,
    recordings_in,
)
from instobj.commands.readings import Zeroing
from instobj.figures.grasps import GroupPicture, draw_grasps
from instobj.report.pages import write_page
from instobj.robot import foxglove_channels, new_mcap_file
from instobj.store.publish import file_rows, require_writable, run_folder, run_name
from instobj.store.stage import write_json

MOST_ROWS = 12
"""Rows of a table that a terminal shows."""
_OWN_TRAINING = (
    "the estimator was trained on this recording, so that its intervals and the frames that it explains say "
    "nothing of others. Assess one that it has not seen."
)


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


def assess(options: AssessOptions) -> dict[str, Any]:
    """Measure the grasps of all recordings and rank the groups; writes page, figure, CSV and JSON to
    `runs/<name>/assess/`. Where `options.out` is an MCAP file, contacts go there too.

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
    mcap = new_mcap_file(options.out, options.paths[0].stem)
    if mcap is not None:
        options = replace(options, out=Path())
    require_writable(options.out)
    estimators = load_estimators(options.model, options.spec)
    spec = estimators.spec
    presses = None if estimators.inversion is None else estimators.inversion.model.skin
    conditions = replace(
        conditions_of(spec, presses),
        friction=options.friction,
        weight_n=options.weight_n,
        limits=limits,
    )
    groups = []
    for name, paths in zip(names, files, strict=True):
        read = [read_grasps_of(path, estimators, options.zeroing) for path in paths]
        groups.append(Group(name, [_measured(tracks, conditions, protocol) for tracks in read]))
    if not any(group.grasps for group in groups):
        raise InputError(
            f"no grasp{' between two opposite sides' * protocol.pinch} in "
            f"{', '.join(map(str, options.paths))}: the estimator reads less than a touch of two jaws. "
            "Check that the recording is of this object and that it begins at rest (--zero)"
        )
    document = _document(options, spec, protocol, conditions, groups)
    if mcap is None:
        return document
    _show_tracks(mcap, spec, groups)
    return document | {"files": [*document["files"], *file_rows([mcap])]}


def _show_tracks(mcap: Path, spec: ObjectSpec, groups: list[Group]) -> None:
    """Write the contacts of all recordings to an MCAP file; of several each has topics of its own."""
    tracks = {
        f"/{_file_name(group.name)}/{_file_name(recording.read.path.name)}": recording.read.track
        for group in groups
        for recording in group.recordings
    }
    with foxglove_channels(mcap, spec) as send:
        for topic, track in tracks.items():
            for frame in frame_documents(track):
                send(frame, topic if len(tracks) > 1 else "/instobj")


def _names(paths: Sequence[Path]) -> list[str]:
    """Short names of what is compared; where those are the same, the parts of the paths that differ."""
    short = [path.absolute().name if path.is_dir() else run_name(path) for path in paths]
    if len(set(short)) == len(short):
        return short
    parts = [path.absolute().parts for path in paths]
    common = set(parts[0]).intersection(*parts[1:])
    differing = ["/".join(part for part in each if part not in common) for each in parts]
    if len(set(differing)) < len(differing):
        raise InputError(
            "the same recording or folder is given twice. Give each gripper's recordings once"
        )
    return differing


def _measured(read: ReadRecording, conditions: Conditions, protocol: Protocol) -> MeasuredRecording:
    grasps = measured_grasps(read.track, replace(conditions, motion=read.motion))
    if protocol.pinch:
        grasps = [grasp for grasp in grasps if grasp.opposed]
    return MeasuredRecording(read, grasps, compared_with_cells(read, grasps))


def _document(
    options: AssessOptions,
    spec: ObjectSpec,
    protocol: Protocol,
    conditions: Conditions,
    groups: list[Group],
) -> dict[str, Any]:
    limits = [f"damage_{limit.name}" for limit in conditions.limits]
    names = [*protocol.measures, *limits]
    trusted = [group for group in groups if group.trusted]
    paired = are_paired(trusted)
    differences = {
        name: compare({group.name: group.values(name) for group in trusted}, paired)
        for name in (protocol.headline, *limits)
    }
    verdicts = [verdict_text(group, conditions) for group in groups]
    tracks = [recording.read for group in groups for recording in group.recordings]
    trained_on = [f"{read.path.name}: {_OWN_TRAINING}" for read in tracks if read.trained_on]
    moved = [f"{read.path.name}: {read.motion.text}" for read in tracks if read.motion is not None]
    said = [*verdicts, *trained_on, *sentences(trusted, differences), *moved]
    folder = (
        run_folder(options.out, "+".join(_file_name(group.name) for group in groups)) / "assess"
    )
    tables = {
        "grasps": grasp_rows(trusted, names),
        "medians": median_rows(trusted, names),
        "ranking": [
            {"measure": axis_of(name)} | difference_row(pair)
            for name, pairs in differences.items()
            for pair in pairs
        ],
        "faces and their load cells": cell_rows(trusted),
        "places most at risk": risk_rows(trusted, limits),
    }
    faults = [text for read in tracks for text in read.faults]
    document = {
        "command": "assess",
        "protocol": options.protocol,
        "model": str(options.model),
        "definition": protocol.definition,
        "friction": conditions.friction,
        "weight N": conditions.weight_n,
        "faults": faults,
        "verdicts": verdicts,
        "texts": [*said, *warnings_of(groups, conditions)],
        "tables": {title: rows for title, rows in tables.items() if rows},
    }
    if len(trusted) > 1:
        ranked = {group.name: group.values(protocol.headline) for group in trusted}
        document["exchanged"] = exchanged_share(ranked, paired)
    figure = folder / "assess.png" if trusted else None
    headline = protocol.headline
    if figure is not None:
        draw_grasps([_picture(group, headline) for group in trusted], axis_of(headline), figure)
    whole = folder / "assess.json"
    write_json(whole_document(document, groups), whole)
    written = [
        *filter(None, [figure]),
        write_csv(folder / "grasps.csv", full_rows(groups)),
        whole,
        write_page(
            folder / "assess.html",
            "assess.html.j2",
            document=document,
            figure=figure,
            scene=base64.b64encode(grasps_scene(spec, trusted)).decode() if trusted else None,
            definitions=_definitions(names, conditions),
        ),
    ]
    # long tables stand on the page; a terminal shows those that fit a screen
    short = {title: rows for title, rows in document["tables"].items() if len(rows) <= MOST_ROWS}
    return document | {"tables": short, "files": file_rows(written)}


def _definitions(names: list[str], conditions: Conditions) -> list[list[str]]:
    rows = [[axis_of(name), measure_of(name).definition, measure_of(name).source] for name in names]
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
    ends = np.array([[reading.value, reading.low, reading.high] for reading in readings]).reshape(
        -1, 3
    )
    return GroupPicture(group.name, curves, ends, median_interval(group.values(headline)))


def _file_name(name: str) -> str:
    return name.strip("/").replace("/", "_").replace("\\", "_")

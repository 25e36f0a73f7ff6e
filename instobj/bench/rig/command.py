"""`instobj bench rig`: presses planned, done by a machine and recorded, or written for a robot arm."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from design.errors import InputError
from design.files import atomic_path
from design.spec.object import ObjectSpec
from design.spec_io import load_spec
from estimator.recordings.boards.growing import finish_recording
from instobj.bench.collect.options import stop_on_signals
from instobj.bench.rig.checked_plan import check_plan
from instobj.bench.rig.dialects import dialect_named
from instobj.bench.rig.journal import Journal, journal_path, new_journal, resumed_journal
from instobj.bench.rig.mounting import Mounting
from instobj.bench.rig.plan import (
    PressPlan,
    PressSettings,
    press_plan,
    stops_of,
)
from instobj.bench.rig.poses import poses, poses_text
from instobj.bench.rig.run import Ports, carry_out, station_on
from instobj.store.progress import ProgressLine
from instobj.store.publish import file_rows


@dataclass(frozen=True)
class RigOptions:
    """Options of the command line; None takes the default of `PressSettings` or the specification's."""

    spec: Path
    machine: str
    out: Path | None = None
    ports: Ports | None = None
    faces: tuple[int, ...] = ()
    mounting: Mounting | None = None
    settings: tuple[tuple[str, Any], ...] = ()
    repeats: int = 1
    reference_every: int = 10
    presses: int | None = None
    resume: bool = False
    overrides: tuple[str, ...] = ()


def rig(options: RigOptions, confirm: Callable[[list[str]], bool]) -> dict[str, Any]:
    """Plan presses; do and record them once `confirm` has said yes to the plan, or list their poses.

    Raises
    ------
    InputError
        Bad options, a plan that the machine cannot do, or a run that was stopped (all that was
        recorded stays, and `resume` goes on).
    """
    spec = load_spec(options.spec, list(options.overrides))
    if options.machine == "poses":
        return _listed(spec, options)
    dialect_named(options.machine)
    if options.ports is None:
        raise InputError(
            f"--machine {options.machine} needs --port (the machine) and --board-port (the sensors)"
        )
    return _pressed(spec, options, options.ports, confirm)


def _listed(spec: ObjectSpec, options: RigOptions) -> dict[str, Any]:
    target = options.out or Path(f"{spec.name}_poses.csv")
    kind = target.suffix[1:]
    if kind not in ("csv", "json"):
        raise InputError(f"--out {target}: poses are written as .csv or .json. Give such a name")
    faces = options.faces or tuple(spec.body.sensed)
    plans = [_plan(spec, face, options) for face in faces]
    listed = poses(spec, plans)
    with atomic_path(target) as path:
        path.write_text(poses_text(listed, kind))
    return {
        "command": "rig",
        "presses": sum(map(len, plans)),
        "texts": [
            f"{sum(map(len, plans))} presses on faces {', '.join(map(str, faces))}, {len(listed)} poses of "
            "the tool in the object's frame"
        ],
        "files": file_rows([target]),
    }


def _plan(spec: ObjectSpec, face: int, options: RigOptions) -> PressPlan:
    given = dict(options.settings)
    full_n = given.get("full_n", PressSettings.full_n)
    by_travel = options.ports is not None and options.ports.by_travel
    if "depths_mm" not in given:
        given["depths_mm"] = stops_of(spec, full_n, by_travel)
    return press_plan(
        spec,
        face,
        PressSettings(**given),
        spec.seed,
        options.repeats,
        options.reference_every,
        options.presses,
    )


def _pressed(
    spec: ObjectSpec, options: RigOptions, ports: Ports, confirm: Callable[[list[str]], bool]
) -> dict[str, Any]:
    base = options.out or Path(spec.name)
    recording = base.with_name(base.name.removesuffix(".nc").removesuffix(".csv") + ".csv")
    journal = _journal(spec, options, recording)
    progress = ProgressLine()
    limit_n = journal.plan.settings.limit_n
    dialect = dialect_named(options.machine)
    with station_on(ports, dialect, spec, limit_n) as station, stop_on_signals(station.stop):
        plan_texts = check_plan(spec, journal, station.machine, ports.by_travel)
        if not confirm(plan_texts):
            raise InputError("nothing was moved: the plan was not confirmed")
        with progress.stage("rig"):
            carry_out(station, spec, journal, recording, progress.step)
    line = station.decoder.statistics
    label = "travel" if ports.by_travel else "force within a second"
    losses = (
        f"{line.lost_frames} frames lost, {line.damaged_lines} damaged lines, "
        f"{station.rows.unlabelled} frames left out that had no {label}"
    )
    texts = [losses, *filter(None, [line.wrapped_text])]
    return _document(journal, recording, texts, ports.by_travel)


def _journal(spec: ObjectSpec, options: RigOptions, recording: Path) -> Journal:
    """Return the journal of the run that goes on, or of a new one."""
    if len(options.faces) != 1:
        raise InputError(
            "give one --face: the one that lies up (only --machine poses takes several)"
        )
    face = options.faces[0]
    if not options.resume:
        if options.mounting is None:
            raise InputError(
                "give --middle X,Y,Z: where the tip just touches the face's middle in the machine's frame, mm"
            )
        return new_journal(recording, _plan(spec, face, options), options.mounting)
    journal = resumed_journal(journal_path(recording, face))
    if journal.plan.object_name != spec.name:
        raise InputError(f"{journal.path} is of {journal.plan.object_name!r}, not of {spec.name!r}")
    return journal


def _document(
    journal: Journal, recording: Path, losses: list[str], by_travel: bool
) -> dict[str, Any]:
    target = recording.with_suffix(".nc")
    frames = finish_recording(recording, target)
    plan = journal.plan
    returns = [journal.finished[k] for k in range(len(plan)) if plan.reference[k]]
    back = [event["largest_n"] for event in returns if "largest_n" in event]
    texts = [
        f"{len(journal.finished)} of {len(plan)} presses done, {frames} frames in the recording"
    ]
    if back:
        texts.append(
            f"reference place: {back[0]:.2f} N at first, {back[-1]:.2f} N at last, {min(back):.2f} to "
            f"{max(back):.2f} N over {len(back)} returns"
        )
    mechanics = " --spec FILE" if by_travel else ""
    texts += [*losses, f"next: instobj recordings {target}{mechanics}"]
    return {
        "command": "rig",
        "presses": len(journal.finished),
        "frames": frames,
        "session": journal.session,
        "reference_n": back,
        "texts": texts,
        "files": file_rows([recording, target, journal.path]),
    }

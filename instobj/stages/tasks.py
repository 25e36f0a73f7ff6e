"""Stages of many specifications as tasks: each stage once, whoever asks for it."""

from __future__ import annotations

import io
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from rich.console import Console

from design.errors import InstobjError
from design.spec.object import ObjectSpec
from instobj.stages.inputs import stage_inputs
from instobj.stages.resources import needed_gib, search_seconds
from instobj.stages.run import Run, versions
from instobj.stages.table import STAGES
from instobj.store.content import StoredResult
from instobj.store.keys import content_key
from instobj.store.progress import ProgressLine


@dataclass(frozen=True)
class StageTask:
    """A stage of a specification; `key` is shared by all that is alike, also in what it needs.

    `needs` are keys of other tasks, `gib` the memory that the stage takes.
    """

    key: str
    stage: str
    spec: ObjectSpec
    needs: tuple[str, ...]
    gib: float

    @property
    def content(self) -> dict[str, Any]:
        """Return what `work` takes."""
        return {"stage": self.stage, "spec": self.spec.model_dump(mode="json")}


def tasks_of(
    specs: Iterable[ObjectSpec], stages: Sequence[str] = ("scores",)
) -> tuple[dict[str, StageTask], list[dict[str, str]]]:
    """All tasks, needed ones first, and by stage the keys of every specification's last
    ones.

    Tasks of the specification that takes longest come first, so that several workers end about together
    (Graham, SIAM J. Appl. Math. 17 (1969) 416).
    """
    all_specs, tasks = list(specs), dict[str, StageTask]()
    last: list[dict[str, str]] = [{}] * len(all_specs)
    seconds = [search_seconds(spec).chain for spec in all_specs]
    for index in sorted(range(len(all_specs)), key=lambda spec_index: -seconds[spec_index]):
        last[index] = {stage: _add(tasks, stage, all_specs[index]) for stage in stages}
    return tasks, last


def _add(tasks: dict[str, StageTask], name: str, spec: ObjectSpec) -> str:
    stage = STAGES[name]
    needs = {need: _add(tasks, need, spec) for need in stage.needs}
    for need, (other_stage, changed) in stage.of_others(spec).items():
        needs[need] = _add(tasks, other_stage, changed)
    key = content_key({"stage": name} | stage_inputs(stage, spec, needs, versions()))
    if key not in tasks:
        tasks[key] = StageTask(key, name, spec, tuple(needs.values()), needed_gib(name, spec))
    return key


def work(
    task: dict[str, Any],
    outcomes_before: list[dict[str, Any]],
    root: str,
    progress: ProgressLine | None = None,
    known_results: dict[str, StoredResult] | None = None,
) -> dict[str, Any]:
    """Make a task's stage in the store at `root`, or read it there; in any process, on any machine.

    Takes and gives plain content: schedulers carry no code of instobj. Where something that it
    needs failed, so has this, for the same reason. `known_results` are results that this process knows by
    their keys; they are verified and reported once, and what comes is added.
    """
    failed = next((done["error"] for done in outcomes_before if done["error"]), "")
    if failed:
        return {"key": "", "error": failed}
    spec, stage = ObjectSpec.model_validate(task["spec"]), task["stage"]
    shown = progress or ProgressLine(Console(file=io.StringIO()))
    results = {} if known_results is None else known_results
    try:
        key = Run(spec, shown, Path(root), known_results=results).require(stage).key
    except (InstobjError, MemoryError) as error:
        return {"key": "", "error": f"{STAGES[stage].title}: {error}"}
    return {"key": key, "error": ""}

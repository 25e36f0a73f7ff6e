"""Stages that are worked through on a data set instead of a specification, and published."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from instobj.store.content import StoredResult, store_root, stored
from instobj.store.keys import content_key
from instobj.store.progress import ProgressLine
from instobj.store.publish import file_rows, publish_to, run_folder, run_name, stage_row

Results = dict[str, StoredResult]


class DataStage(NamedTuple):
    """A stage, what is said of it meanwhile, and what makes it from the results before it."""

    name: str
    title: str
    make: Callable[[Path, Results], None]


def stage_key(stage: str, inputs: dict[str, Any]) -> str:
    """Key of a stage's result."""
    return content_key(_provenance(stage, inputs))


def made_or_stored(
    stage: str, inputs: dict[str, Any], make: Callable[[Path], None], progress: ProgressLine
) -> StoredResult:
    """A stage's result, made where it is not stored."""
    return stored(store_root(), stage, _provenance(stage, inputs), make, progress.say)


def work_through(
    path: Path,
    out: Path,
    inputs: dict[str, Any],
    stages: Sequence[DataStage],
    progress: ProgressLine,
    folder: str = "",
) -> dict[str, Any]:
    """Make the stages of a data set, or find them stored; results go to `runs/<name>`, or to the given
    folder in it."""
    from instobj.report.summary import summarize

    results: Results = {}
    for stage in stages:

        def make(folder: Path, make: Callable[[Path, Results], None] = stage.make) -> None:
            make(folder, results)

        with progress.stage(stage.title):
            results[stage.name] = made_or_stored(stage.name, inputs, make, progress)
    name = run_name(path)
    target = run_folder(out, name) / folder
    files = [file for result in results.values() for file in publish_to(target, result)]
    return {
        "name": f"{name}/{folder}" if folder else name,
        "stages": [stage_row(result) for result in results.values()],
        "summary": summarize(results),
        "files": file_rows(files),
    }


def _provenance(stage: str, inputs: dict[str, Any]) -> dict[str, Any]:
    from instobj.stages.table import STAGES

    return inputs | {"version": STAGES[stage].version}

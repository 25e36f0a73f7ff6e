"""Command of a sweep: a study's specifications taken to their scores, and what came of it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from design.errors import InputError
from instobj.stages.tasks import tasks_of
from instobj.stages.workers import Done, open_workers
from instobj.store.content import store_root
from instobj.store.progress import ProgressLine
from instobj.store.publish import file_rows, require_writable, run_folder
from instobj.sweep.outcome import variant_row, write_outcome
from instobj.sweep.study import load_study


def sweep(path: Path, out: Path, workers: int = 1, scheduler: str | None = None) -> dict[str, Any]:
    """Take every specification of a study to its last stages; write table, figure and page.

    Stages that several specifications share are made once. What is stored is reused, so that an
    interrupted sweep goes on where it stopped.

    Raises
    ------
    InputError
        The study cannot be read, no specification gets there, or there are no such workers.
    """
    require_writable(out)
    study, progress = load_study(path), ProgressLine()
    say = progress.say
    specs = [variant.spec for variant in study.variants if variant.spec is not None]
    for variant in study.variants:
        if variant.refused:
            say(f"{variant.label} is left out: {variant.refused}")
    tasks, last = tasks_of(specs, study.stages)
    say(f"{len(specs)} specifications, {len(tasks)} stages")
    root = store_root().absolute()
    with open_workers(workers, scheduler, progress) as made_by:
        done = made_by.make(tasks, root, say)
    keys = iter(last)
    rows = [
        variant_row(variant, _outcomes(next(keys), done) if variant.spec else {}, root, out)
        for variant in study.variants
    ]
    if all("error" in row for row in rows):
        raise InputError(
            f"{path}: no specification came to {', '.join(study.stages)}: {rows[0]['error']}"
        )
    files = write_outcome(study, rows, run_folder(out, study.name) / "sweep")
    return {"rows": rows, "files": file_rows(files)}


def _outcomes(last: dict[str, str], done: Done) -> dict[str, dict[str, Any]]:
    return {stage: done[key] for stage, key in last.items()}

"""Next step after a command: one line that works when it is pasted."""

from __future__ import annotations

import shlex
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from design.errors import InputError
from instobj.report.cells import GO, NO_GO
from instobj.store.readers import INVERSION

NEXT = {
    "new": "check",
    "check": "score",
    "check failed": "check --fabrication",
    f"score {GO}": "run",
    f"score {NO_GO}": "run --to verdict",
    f"run {GO}": "build",
    f"run {NO_GO}": "optimize",
    "run": "score",
    "build": "bench firmware",
    "build unscored": "score",
    "no search": "docs layout_search",
    "optimize": "run",
    "optimize again": "optimize --resume",
    "optimize cut": "score",
    "recordings": "train",
    "recordings too few": "docs recordings",
    "adopt": "score",
    "train": "train --export",
    "export": "docs calibrate",
    "predict": "docs live",
    "predict unexplained": "docs calibrate",
    "predict several tips": "docs inversion",
    "predict contacts": "assess --model",
    "predict contacts unexplained": "docs inversion",
    "train SPEC": "run --to frames --set collection.kind=continuous --set collection.presses=20",
    "train contacts": "predict",
    "train without twin": "train",
    "adopt order": "validate",
}
"""Command to go on with, by what was done and its outcome."""


def next_step(
    done: str, *paths: Path, out: Path | None = None, overrides: Sequence[str] = ()
) -> str:
    """Return the command to go on with after what was `done` (a key of `NEXT`).

    `paths` are its files; `out` and `overrides` are handed on, so that it finds the same results.
    """
    words = ["instobj", *NEXT[done].split(), *map(str, paths)]
    words += [] if out in (None, Path()) else ["--out", str(out)]
    words += [word for override in overrides for word in ("--set", override)]
    return shlex.join(words)


def verdict_step(
    command: str,
    specs: Sequence[Path],
    out: Path,
    overrides: Sequence[str],
    document: dict[str, Any],
) -> str:
    """Return the next step after a chain: by its verdict, of all objects or of the first that is no go."""
    verdicts = [item["summary"].get("verdict", {}) for item in document["objects"]]
    failing = [spec for spec, verdict in zip(specs, verdicts, strict=True) if NO_GO in verdict]
    if not all(verdicts):
        return next_step("run", *specs, out=out, overrides=overrides)
    if not failing:
        return next_step(f"{command} {GO}", *specs, out=out, overrides=overrides)
    return no_go_step(command, failing[0], out, overrides)


def no_go_step(command: str, path: Path, out: Path, overrides: Sequence[str]) -> str:
    """Return the next step after a chain that found a specification no go."""
    if command == "score":  # what to change is said before a search is worth its time
        return next_step(f"score {NO_GO}", path, out=out, overrides=overrides)
    if (path.parent / "search.json").is_file():  # left by a search that has just been done
        return next_step("no search")
    # slow to load, the second by torch
    from design.search.space import search_space
    from design.spec_io import load_spec
    from estimator.layouts.scorer import require_scorable

    spec = load_spec(path, overrides)
    try:
        require_scorable(spec)
        search_space(spec)
    except InputError:  # a search does not take this object
        return next_step("no search")
    return next_step(f"{command} {NO_GO}", path, out=out, overrides=overrides)


def _estimator_paths(document: dict[str, Any]) -> tuple[list[Path], Path | None]:
    """Return the files that training wrote, and the one of an inversion among them."""
    paths = [Path(row["path"]) for row in document["files"]]
    return paths, next((path for path in paths if path.name == INVERSION.name), None)


def assessing_text(document: dict[str, Any]) -> str:
    """Say how networks of a data set assess grasps: they do not hold the object's specification."""
    paths, contacts = _estimator_paths(document)
    if contacts is not None:
        return ""
    return (
        f"to assess grasps: instobj assess RECORDINGS --model {paths[0].parent} --spec SPEC.toml, where the "
        "data set was read with `recordings --spec SPEC.toml`"
    )


def training_step(source: Path, document: dict[str, Any], out: Path, overrides: list[str]) -> str:
    """Return the next step: what an inversion reads, the export of networks, or networks without the twin
    where it helps on no face."""
    from instobj.report.summary import TWIN_TITLE  # loads mechanics

    paths, contacts = _estimator_paths(document)
    twins = document.get("summary", {}).get(TWIN_TITLE, [])
    if twins and not any(row["helps"].startswith("yes") for row in twins):
        return next_step("train without twin", source, out=out)
    if contacts is None:
        return next_step("train", paths[0].parent)
    if source.suffix == ".nc":
        return next_step("train contacts", contacts, source, out=out)
    return next_step("train SPEC", source, out=out, overrides=overrides)

"""Next step after a command: one line that works when it is pasted."""

from __future__ import annotations

import shlex
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from design.errors import InputError
from instobj.report.cells import GO, NO_GO

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
    "recordings": "train",
    "recordings too few": "docs recordings",
    "adopt": "score",
    "train": "train --export",
    "export": "predict",
    "train SPEC": "run --to frames --set collection.kind=continuous --set collection.presses=20",
    "train contacts": "predict",
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
    if command == "score":  # what to change is said before a search is worth its time
        return next_step(f"score {NO_GO}", failing[0], out=out, overrides=overrides)
    if (failing[0].parent / "search.json").is_file():  # left by a search that has just been done
        return next_step("no search")
    # slow to load, the second by torch
    from design.search.space import search_space
    from design.spec_io import load_spec
    from estimator.layouts.scorer import require_scorable

    spec = load_spec(failing[0], overrides)
    try:
        require_scorable(spec)
        search_space(spec)
    except InputError:  # a search does not take this object
        return next_step("no search")
    return next_step(f"{command} {NO_GO}", failing[0], out=out, overrides=overrides)

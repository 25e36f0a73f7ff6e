"""Experiments by name: what `instobj experiment NAME SPEC` runs, and what it writes.

A module of experiments names them in a tuple `STUDIES` and is listed in `_MODULES`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import Any

from design.errors import InputError
from design.spec.object import ObjectSpec
from design.spec_io import load_spec
from design.tables import write_records
from instobj.store.publish import file_rows, require_writable, run_folder
from instobj.store.stage import write_json

_MODULES: tuple[str, ...] = (
    "instobj.experiments.paper.general",
    "instobj.experiments.paper.places",
    "instobj.experiments.paper.amounts",
    "instobj.experiments.paper.unseen",
    "instobj.experiments.paper.reference",
    "instobj.experiments.paper.grasps",
    "instobj.experiments.paper.slipped",
    "instobj.experiments.paper.force_vectors",
    "instobj.experiments.layouts",
)


@dataclass(frozen=True)
class Study:
    """An experiment.

    `run(spec, folder, quick)` writes its figures into the folder and returns a JSON-able document
    with `rows`, the table; `texts`, what it says in words, and anything else where wanted. `quick`
    asks for the same on fewer and coarser cases, in seconds to a minute.
    """

    name: str
    help: str
    run: Callable[[ObjectSpec, Path, bool], dict[str, Any]]


def studies() -> dict[str, Study]:
    """All experiments by name, in the order of their modules."""
    found = [study for module in _MODULES for study in import_module(module).STUDIES]
    return {study.name: study for study in found}


def run_study(
    name: str, path: Path, out: Path, quick: bool, overrides: list[str]
) -> dict[str, Any]:
    """Run an experiment on a specification; writes `runs/<spec>/experiments/<name>`.

    Raises
    ------
    InputError
        No experiment of that name, a bad specification, or an output that cannot be written.
    """
    known = studies()
    if name not in known:
        raise InputError(f"no experiment is called {name!r}. Choose one of {', '.join(known)}")
    spec = load_spec(path, overrides)
    require_writable(out)
    folder = run_folder(out, spec.name) / "experiments" / name
    folder.mkdir(parents=True, exist_ok=True)
    found = known[name].run(spec, folder, quick)
    write_records(folder / f"{name}.csv", found["rows"])
    write_json(
        {"experiment": name, "spec": spec.name, "quick": quick} | found, folder / f"{name}.json"
    )
    return {
        "command": "experiment",
        "experiment": name,
        "tables": {f"{name}, {spec.name}": found["rows"]},
        **{key: value for key, value in found.items() if key != "rows"},
        "files": file_rows(sorted(path for path in folder.iterdir() if path.is_file())),
    }

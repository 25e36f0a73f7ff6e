"""Studies by name: what `python -m studies NAME SPEC` runs, and what it writes.

A module of studies names them in a tuple `STUDIES` and is listed in `_MODULES`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
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
    "studies.paper.general",
    "studies.paper.places",
    "studies.paper.amounts",
    "studies.paper.unseen",
    "studies.paper.reference",
    "studies.paper.grasps",
    "studies.paper.grasp_contacts",
    "studies.paper.slipped",
    "studies.paper.force_vectors",
    "studies.layouts",
    "studies.electromagnets",
    "studies.weak_areas",
    "studies.blind_start",
    "studies.published_objects",
)


@dataclass(frozen=True)
class StudyResult:
    """What an experiment found; JSON-able.

    Attributes
    ----------
    rows : the table; every row has the same columns, their names carry the units
    texts : what it says in words
    data : further numbers by name, such as the curves of a figure
    """

    rows: list[dict[str, Any]]
    texts: Sequence[str] = ()
    data: dict[str, Any] = field(default_factory=dict)

    def document(self) -> dict[str, Any]:
        """Texts and data by name, without the table."""
        return ({"texts": list(self.texts)} if self.texts else {}) | self.data


@dataclass(frozen=True)
class Study:
    """An experiment.

    `run(spec, folder, quick)` writes its figures into the folder and returns what it found; `quick`
    asks for the same on fewer and coarser cases, in seconds to a minute.
    """

    name: str
    help: str
    run: Callable[[ObjectSpec, Path, bool], StudyResult]


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
    write_records(folder / f"{name}.csv", found.rows)
    about = {"experiment": name, "spec": spec.name, "quick": quick, "rows": found.rows}
    write_json(about | found.document(), folder / f"{name}.json")
    return {
        "command": "experiment",
        "experiment": name,
        "tables": {f"{name}, {spec.name}": found.rows},
        **found.document(),
        "files": file_rows(sorted(path for path in folder.iterdir() if path.is_file())),
    }

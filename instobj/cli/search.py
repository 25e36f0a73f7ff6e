"""Commands of the layout search and of sweeps."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from design.errors import InputError
from instobj.cli.options import (
    HERE,
    JUDGE,
    AsJson,
    Out,
    Overrides,
    Spec,
    Workers,
    show,
    workers_and_scheduler,
)

app = typer.Typer()

Storage = Annotated[
    str | None,
    typer.Option(
        help="Journal file, or a database that many machines share: postgresql+psycopg://… "
        "(default: runs/NAME/search/journal.log)."
    ),
]


@app.command(rich_help_panel=JUDGE)
def optimize(
    spec: Spec,
    resume: Annotated[bool, typer.Option("--resume", help="Resume the existing search.")] = False,
    storage: Storage = None,
    join: Annotated[
        int | None,
        typer.Option(
            metavar="NUMBER", help="Work on the search in --storage, as worker NUMBER of several."
        ),
    ] = None,
    workers: Workers = "1",
    out: Out = HERE,
    as_json: AsJson = False,
    overrides: Overrides = None,
) -> None:
    """Search for a better layout, as the table `search` says; confirm it with the whole chain."""
    from design.search.space import search_space
    from design.spec_io import load_spec

    search_space(load_spec(spec, overrides or []))  # refused before the seconds that imports take

    from instobj.search.optimize import optimize as search_layouts
    from instobj.search.optimize import work

    given = overrides or []
    if join is None:
        number, scheduler = workers_and_scheduler(workers)
        show(search_layouts(spec, out, given, resume, storage, number, scheduler), as_json)
    elif storage is None:
        raise InputError("--join works on the search of others. Give its --storage too")
    else:
        show(work(spec, out, given, storage, join), as_json)


@app.command(rich_help_panel=JUDGE)
def sweep(
    study: Annotated[Path, typer.Argument(help="Study (TOML).", show_default=False)],
    workers: Workers = "1",
    out: Out = HERE,
    as_json: AsJson = False,
) -> None:
    """Score many specifications: a grid, a Latin hypercube, or files."""
    from instobj.sweep.sweep import sweep as score_all

    number, scheduler = workers_and_scheduler(workers)
    show(score_all(study, out, number, scheduler), as_json)

"""Commands of the layout search and of sweeps."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from instobj.cli.options import HERE, AsJson, Out, Overrides, Scheduler, Spec, Workers, show

app = typer.Typer()

Storage = Annotated[
    str | None,
    typer.Option(
        help="Journal file, or a database that many machines share: postgresql+psycopg://… "
        "(default: runs/NAME/search/journal.log)."
    ),
]


@app.command()
def optimize(
    spec: Spec,
    resume: Annotated[bool, typer.Option("--resume", help="Resume the existing search.")] = False,
    storage: Storage = None,
    workers: Workers = 1,
    scheduler: Scheduler = None,
    out: Out = HERE,
    as_json: AsJson = False,
    overrides: Overrides = None,
) -> None:
    """Search for a better layout, as the table `search` says; confirm it with the whole chain."""
    from instobj.search.optimize import optimize as run

    show(run(spec, out, overrides or [], resume, storage, workers, scheduler), as_json)


@app.command()
def worker(
    spec: Spec,
    storage: Annotated[str, typer.Option(help="Storage that all workers share.")],
    number: Annotated[int, typer.Option(help="Worker number; seeds its random generator.")] = 1,
    out: Out = HERE,
    as_json: AsJson = False,
    overrides: Overrides = None,
) -> None:
    """Work on a search together with others, on any number of machines."""
    from instobj.search.optimize import work

    show(work(spec, out, overrides or [], storage, number), as_json)


@app.command()
def sweep(
    study: Annotated[Path, typer.Argument(help="Study (TOML).", show_default=False)],
    workers: Workers = 1,
    scheduler: Scheduler = None,
    out: Out = HERE,
    as_json: AsJson = False,
) -> None:
    """Score many specifications: a grid, a Latin hypercube, or files."""
    from instobj.sweep.sweep import sweep as run

    show(run(study, out, workers, scheduler), as_json)

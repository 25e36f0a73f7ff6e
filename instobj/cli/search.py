"""Commands of the layout search and of experiments: studies of the design, the paper's experiments."""

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
    from design.search.space import search_space
    from design.spec_io import load_spec

    search_space(load_spec(spec, overrides or []))  # refused before the seconds that imports take

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


@app.command()
def experiment(
    name: Annotated[
        str, typer.Argument(help="Name of the experiment; `instobj experiments` lists them.")
    ],
    spec: Spec,
    quick: Annotated[
        bool, typer.Option("--quick", help="Reduced resolution, for a preview only.")
    ] = False,
    out: Out = HERE,
    as_json: AsJson = False,
    overrides: Overrides = None,
) -> None:
    """Run an experiment on a specification: a table and a figure."""
    from instobj.experiments.registry import run_study

    show(run_study(name, spec, out, quick, overrides or []), as_json)


@app.command()
def experiments(as_json: AsJson = False) -> None:
    """List the experiments."""
    from instobj.experiments.registry import studies

    rows = [{"experiment": study.name, "answers": study.help} for study in studies().values()]
    show({"command": "experiments", "tables": {"experiments": rows}}, as_json)

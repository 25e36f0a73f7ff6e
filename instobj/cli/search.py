"""Commands of the layout search."""

from __future__ import annotations

from typing import Annotated

import typer

from instobj.cli.options import HERE, AsJson, Out, Overrides, Spec, show

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
    resume: Annotated[
        bool, typer.Option("--resume", help="Go on with the search there is.")
    ] = False,
    storage: Storage = None,
    out: Out = HERE,
    as_json: AsJson = False,
    overrides: Overrides = None,
) -> None:
    """Search for a better layout, as the specification says under `search`; confirm it by the chain."""
    from instobj.search.optimize import optimize as run

    show(run(spec, out, overrides or [], resume, storage), as_json)


@app.command()
def worker(
    spec: Spec,
    storage: Annotated[str, typer.Option(help="The storage that all workers share.")],
    number: Annotated[int, typer.Option(help="Of this worker, for its random numbers.")] = 1,
    out: Out = HERE,
    as_json: AsJson = False,
    overrides: Overrides = None,
) -> None:
    """Work on a search together with others, on any number of machines."""
    from instobj.search.optimize import work

    show(work(spec, out, overrides or [], storage, number), as_json)

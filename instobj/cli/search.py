"""Commands of the layout search and of sweeps."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from instobj.cli.options import (
    DESIGN,
    HERE,
    JUDGE,
    AsJson,
    BodyKind,
    BodySize,
    Out,
    Overrides,
    Spec,
    Workers,
    show,
    workers_and_scheduler,
)

app = typer.Typer()


@app.command(rich_help_panel=JUDGE)
def optimize(
    spec: Spec,
    resume: Annotated[bool, typer.Option("--resume", help="Resume the existing search.")] = False,
    workers: Workers = "1",
    out: Out = HERE,
    as_json: AsJson = False,
    overrides: Overrides = None,
) -> None:
    """Search for a better layout within the table `search`; confirm it with the chain."""
    from design.search.space import search_space
    from design.spec_io import load_spec

    search_space(load_spec(spec, overrides or []))  # refused before the seconds that imports take

    from instobj.search.optimize import optimize as search_layouts

    number, scheduler = workers_and_scheduler(workers)
    show(search_layouts(spec, out, overrides or [], resume, number, scheduler), as_json)


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


@app.command(rich_help_panel=DESIGN)
def explore(
    spec: Annotated[
        Path | None, typer.Argument(help="Specification (TOML).", show_default=False)
    ] = None,
    kind: BodyKind = None,
    size: BodySize = None,
    page: Annotated[
        int, typer.Option(min=0, max=65535, help="TCP port on this machine; 0: any free one.")
    ] = 8766,
    export: Annotated[
        Path | None,
        typer.Option(metavar="HTML", help="Write a page to look at and press, and serve none."),
    ] = None,
    as_json: AsJson = False,
    overrides: Overrides = None,
) -> None:
    """Move magnets and sensors by hand in the browser; the map follows. Begins from nothing with --kind."""
    from instobj.commands.new import request_of, size_of
    from instobj.explore.command import explore as explore_by_hand

    request = request_of(kind, None if size is None else size_of(size, kind))
    show(explore_by_hand(spec, request, page, export, overrides or []), as_json)

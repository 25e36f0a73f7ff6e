"""Command that simulates recordings."""

from __future__ import annotations

from typing import Annotated

import typer

from instobj.cli.options import HERE, AsBuilt, AsJson, Out, Overrides, Specs, show, with_as_built

app = typer.Typer()


@app.command()
def frames(
    specs: Specs,
    kind: Annotated[
        str | None,
        typer.Option(help="paper (143 000 frames a face), grasp or continuous: [collection]."),
    ] = None,
    out: Out = HERE,
    as_json: AsJson = False,
    overrides: Overrides = None,
    as_built: AsBuilt = None,
) -> None:
    """Simulated recordings as a data set: the paper's collection, grasps, or presses anywhere."""
    from instobj.commands.run import simulate_recordings

    chosen = [] if kind is None else [f"collection.kind={kind}"]
    given = [*with_as_built(overrides, as_built), *chosen]
    show(simulate_recordings(specs, out, given), as_json)

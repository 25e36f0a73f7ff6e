"""Commands that hold a model against recordings of a real object."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from instobj.cli.options import (
    HERE,
    AsBuilt,
    AsJson,
    Out,
    Overrides,
    Recordings,
    Spec,
    show,
    with_as_built,
)

app = typer.Typer()


@app.command()
def selftest(
    spec: Spec,
    resting: Annotated[
        Path,
        typer.Argument(help="Recording, or CSV of frames at rest.", show_default=False),
    ],
    as_json: AsJson = False,
    overrides: Overrides = None,
    as_built: AsBuilt = None,
) -> None:
    """Flipped magnets, swapped or dead channels, from the resting signals of a built object."""
    from instobj.commands.recorded.validate import self_test_of

    result = self_test_of(spec, resting, with_as_built(overrides, as_built))
    show(result, as_json)
    if not result["passed"]:
        raise typer.Exit(1)


@app.command()
def validate(
    spec: Spec,
    recordings: Recordings,
    exchanges: Annotated[
        int, typer.Option(min=1, help="Number of permutations for the null distribution.")
    ] = 19,
    out: Out = HERE,
    as_json: AsJson = False,
    overrides: Overrides = None,
    as_built: AsBuilt = None,
) -> None:
    """Predicted against recorded presses, every figure beside its permutation null."""
    from instobj.commands.recorded.validate import validate_on

    given = with_as_built(overrides, as_built)
    show(validate_on(spec, recordings, exchanges, out, given), as_json)

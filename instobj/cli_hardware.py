"""Commands that meet real things: silicones, recordings, built objects."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from instobj.cli_options import (
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
def recordings(
    files: Recordings,
    out: Out = HERE,
    as_json: AsJson = False,
) -> None:
    """Read recordings, find and correct their faults, and write a data set to train on."""
    from instobj.commands import read_recordings

    show(read_recordings(files, out), as_json)


@app.command()
def material(
    source: Annotated[
        str,
        typer.Argument(help="CSV of a tensile test, a name, or a hardness.", show_default=False),
    ],
    out: Out = HERE,
    as_json: AsJson = False,
) -> None:
    """Young's modulus of a silicone with its spread; solids fitted to a tensile test."""
    from instobj.material import describe_material

    show(describe_material(source, out), as_json)


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
    from instobj.hardware import self_test_of

    result = self_test_of(spec, resting, with_as_built(overrides, as_built))
    show(result, as_json)
    if not result["passed"]:
        raise typer.Exit(1)


@app.command()
def validate(
    spec: Spec,
    recordings: Recordings,
    exchanges: Annotated[
        int, typer.Option(min=1, help="Exchanges of places for the null of the calibration.")
    ] = 19,
    out: Out = HERE,
    as_json: AsJson = False,
    overrides: Overrides = None,
    as_built: AsBuilt = None,
) -> None:
    """Predicted against recorded presses, every figure beside its permutation null."""
    from instobj.hardware import validate_on

    given = with_as_built(overrides, as_built)
    show(validate_on(spec, recordings, exchanges, out, given), as_json)

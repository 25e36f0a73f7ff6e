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
def interfaces(
    spec: Spec,
    recordings: Recordings,
    out: Out = HERE,
    as_json: AsJson = False,
    overrides: Overrides = None,
) -> None:
    """Bonded, frictionless or friction at the core: what each predicts of recorded presses."""
    from instobj.commands.recorded.interfaces import interfaces_on

    show(interfaces_on(spec, recordings, out, overrides or []), as_json)


@app.command()
def conventions(
    spec: Spec,
    recordings: Recordings,
    exchanges: Annotated[
        int, typer.Option(min=1, help="Number of permutations for the null distribution.")
    ] = 499,
    as_json: AsJson = False,
    overrides: Overrides = None,
) -> None:
    """Order of chips, labels and axes: searched on one recording, judged on the other."""
    from instobj.commands.recorded.conventions import conventions_of

    show(conventions_of(spec, recordings, exchanges, overrides or []), as_json)


@app.command()
def cycles(
    recording: Annotated[Path, typer.Argument(help="Folder with sensor.csv and states.csv.")],
    as_json: AsJson = False,
) -> None:
    """Loading cycles at one place: what elasticity, lag and relaxation explain of force and field."""
    from instobj.commands.recorded.cycles import cycles_in

    show(cycles_in(recording), as_json)


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

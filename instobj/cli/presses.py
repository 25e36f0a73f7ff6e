"""Commands that press one object at chosen contact locations, and describe what it is cast of."""

from __future__ import annotations

from typing import Annotated

import typer

from instobj.cli.options import HERE, JUDGE, AsJson, Out, Overrides, Spec, show

app = typer.Typer()


@app.command(rich_help_panel=JUDGE)
def press(
    spec: Spec,
    at: Annotated[
        list[str] | None,
        typer.Option(
            metavar="FACE:X,Y[,DEPTH]",
            help="Contact location in the face's frame and depth (default 2), mm; can be repeated.",
        ),
    ] = None,
    jaw: Annotated[
        list[str] | None,
        typer.Option(
            metavar="FACE:X,Y[;X,Y]",
            help="Contact locations of one jaw's tips, mm; give it twice, for a grasp to --force.",
        ),
    ] = None,
    force: Annotated[
        float | None, typer.Option(help="Force of every press or of each jaw, N.")
    ] = None,
    material: Annotated[
        str,
        typer.Option(
            help="linear: small strain; or large strain: neo-hookean, yeoh:C1,C2,C3, "
            "ogden:μ1,α1,… (MPa)."
        ),
    ] = "linear",
    out: Out = HERE,
    as_json: AsJson = False,
    overrides: Overrides = None,
) -> None:
    """Chosen presses at once, one with large strain, or a grasp: forces, depths, all signals."""
    from instobj.commands.presses.command import PressOptions, press_object

    options = PressOptions(
        spec, tuple(at or ()), tuple(jaw or ()), force, material, out, tuple(overrides or ())
    )
    result = press_object(options)
    show(result, as_json)
    if result["status"] == "refused":
        typer.echo("some presses were refused: see above", err=True)
        raise typer.Exit(2)
    if result["status"] != "converged":
        typer.echo("Newton's method found no equilibrium any deeper", err=True)
        raise typer.Exit(1)

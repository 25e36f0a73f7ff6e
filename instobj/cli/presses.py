"""Commands that press one object at chosen contact locations."""

from __future__ import annotations

from typing import Annotated, Any

import typer

from design.errors import InputError
from instobj.cli.options import HERE, AsJson, Out, Overrides, Spec, show

app = typer.Typer()


@app.command()
def press(
    spec: Spec,
    xy: Annotated[
        tuple[float, float] | None,
        typer.Option(help="Contact location in the face's frame, mm; along a curved surface."),
    ] = None,
    face: Annotated[int, typer.Option(help="Number of the sensed face.")] = 1,
    depth: Annotated[float, typer.Option(help="Indentation depth, mm.")] = 2.0,
    material: Annotated[
        str,
        typer.Option(
            help="Material: neo-hookean, yeoh, ogden, or linear for small strain with any indenter."
        ),
    ] = "neo-hookean",
    constants: Annotated[
        str, typer.Option(help="Constants, MPa: C1,C2,C3 of yeoh; μ1,α1,μ2,α2,… of ogden.")
    ] = "",
    at: Annotated[
        list[str] | None,
        typer.Option(
            metavar="FACE:X,Y[,DEPTH]", help="linear: further contact location; can be repeated."
        ),
    ] = None,
    force: Annotated[float | None, typer.Option(help="linear: force of every press, N.")] = None,
    direction: Annotated[
        tuple[float, float] | None,
        typer.Option(help="linear: inclination of the path towards the face's x and y, degrees."),
    ] = None,
    patch: Annotated[
        tuple[float, float] | None,
        typer.Option(
            help="linear: uniform pressure instead of an indenter: radius mm, pressure MPa."
        ),
    ] = None,
    out: Out = HERE,
    as_json: AsJson = False,
    overrides: Overrides = None,
) -> None:
    """Chosen presses: one with large deformation, or several with --material linear."""
    from instobj.commands.presses.places import places_given

    given = [*(overrides or [])]
    if direction is not None:
        given.append(f"indenter.direction_deg=[{direction[0]}, {direction[1]}]")
    places = places_given(face, xy, at or [], depth)
    if material == "linear":
        from instobj.commands.presses.loads import press_loads

        _show_loads(press_loads(spec, places, force, patch, out, given), as_json)
        return
    if xy is None or at or force is not None or patch is not None:
        raise InputError(
            "--at, --force and --patch are for small strain: add --material linear, or give one "
            "contact location with --xy and --depth"
        )
    from instobj.commands.presses.press import press_specification

    result = press_specification(spec, face, xy, depth, material, constants, out, given)
    show(result, as_json)
    if result["status"] != "converged":
        typer.echo("Newton's method found no equilibrium any deeper", err=True)
        raise typer.Exit(1)


@app.command()
def grasp(
    spec: Spec,
    jaw: Annotated[
        list[str],
        typer.Option(
            metavar="FACE:X,Y[;X,Y]",
            help="Contact locations of one jaw's tips, mm; give it twice, once per jaw.",
        ),
    ],
    force: Annotated[float, typer.Option(help="Force of each jaw, N.")],
    out: Out = HERE,
    as_json: AsJson = False,
    overrides: Overrides = None,
) -> None:
    """A parallel-jaw grasp: forces, depths, signals of all sensors, error of superposition."""
    from instobj.commands.presses.grasp import grasp_specification

    show(grasp_specification(spec, jaw, force, out, overrides or []), as_json)


@app.command()
def slip(
    spec: Spec,
    shift: Annotated[
        tuple[float, float, float], typer.Option(help="Shift of the core in the shell, x y z, mm.")
    ] = (0.0, 0.0, 0.0),
    rotation: Annotated[
        tuple[float, float, float],
        typer.Option(help="Rotation of the core as a rotation vector, x y z, degrees."),
    ] = (0.0, 0.0, 0.0),
    rim: Annotated[
        str, typer.Option(help="Rim of the shell: free, or held on the mounting plate.")
    ] = "free",
    out: Out = HERE,
    as_json: AsJson = False,
    overrides: Overrides = None,
) -> None:
    """Cost of a core slip after calibration: baseline changes, localisation and force errors."""
    from instobj.commands.presses.slip import slip_specification

    show(slip_specification(spec, shift, rotation, rim, out, overrides or []), as_json)


def _show_loads(result: dict[str, Any], as_json: bool) -> None:
    show(result, as_json)
    if result["status"] == "refused":
        typer.echo("some presses were refused: see above", err=True)
        raise typer.Exit(2)

"""The command that runs a press rig."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from instobj.cli.options import AsJson, LoadPort, Overrides, Spec, port_and_baud, show

if TYPE_CHECKING:
    from instobj.bench.rig.mounting import Mounting

app = typer.Typer()


@app.command()
def rig(
    spec: Spec,
    machine: Annotated[
        str,
        typer.Option(
            help="grbl, marlin: press with a machine of that controller and record (grblHAL: grbl); "
            "poses: list of poses for a robot arm."
        ),
    ] = "grbl",
    out: Annotated[
        Path | None,
        typer.Option(help="Recording (default: NAME.csv), or list of poses (.csv or .json)."),
    ] = None,
    port: Annotated[
        str | None, typer.Option(metavar="PORT[@BAUD]", help="Serial port of the machine.")
    ] = None,
    board_port: Annotated[
        str | None,
        typer.Option(
            metavar="PORT[@BAUD]",
            help="Serial port of the board; @BAUD is the load cell's too.",
        ),
    ] = None,
    load_port: LoadPort = None,
    load_scale: Annotated[
        float | None,
        typer.Option(
            help="Newtons per unit of a load port that sends one number per line; 1 where lines name a unit."
        ),
    ] = None,
    face: Annotated[
        list[int] | None, typer.Option(help="Face to press (poses: several, by default all).")
    ] = None,
    middle: Annotated[
        str | None,
        typer.Option(
            metavar="X,Y,Z",
            help="Where the tip just touches the face's middle, in the machine's frame, mm.",
        ),
    ] = None,
    turn: Annotated[
        float,
        typer.Option(
            help="Angle from the machine's X to the face's x, counter-clockwise, degrees."
        ),
    ] = 0.0,
    depth: Annotated[
        list[float] | None,
        typer.Option(
            help="Indentation depth of a stop, mm; can be repeated (default: four of press.depths_mm; "
            "--adaptive: one)."
        ),
    ] = None,
    dwell: Annotated[
        float | None,
        typer.Option(min=0, help="Dwell time at every stop, s (default: 0.5; --adaptive: 0.8)."),
    ] = None,
    speed: Annotated[
        float | None, typer.Option(min=0.05, help="Speed of presses, mm/s (default: 1).")
    ] = None,
    strokes: Annotated[
        int | None,
        typer.Option(
            min=1,
            help="Load cycles per press, the tip lifted in between (default: 1; --adaptive: 9).",
        ),
    ] = None,
    full: Annotated[
        float | None, typer.Option(help="Force that ends a press, N (default: 15).")
    ] = None,
    repeats: Annotated[int, typer.Option(min=1, help="Presses per contact location.")] = 1,
    presses: Annotated[
        int | None, typer.Option(min=1, help="Number of presses to do, from the start of the plan.")
    ] = None,
    adaptive: Annotated[
        bool,
        typer.Option(
            "--adaptive",
            help="Adaptive order: press where a twin of the specification is most uncertain; 40 presses, "
            "returns included, of 9 load cycles (options change them).",
        ),
    ] = False,
    reference_every: Annotated[
        int,
        typer.Option(min=0, help="Presses between returns to the middle location; 0: no returns."),
    ] = 10,
    resume: Annotated[
        bool, typer.Option("--resume", help="Resume the interrupted run with its plan.")
    ] = False,
    yes: Annotated[
        bool, typer.Option("--yes", help="Move without asking for confirmation.")
    ] = False,
    as_json: AsJson = False,
    overrides: Overrides = None,
) -> None:
    """Press planned places with a machine and record them, or list the poses for a robot arm."""
    from instobj.bench.rig.command import RigOptions
    from instobj.bench.rig.command import rig as press_with_rig
    from instobj.bench.rig.run import Ports

    ports = None
    board, baud = port_and_baud(board_port)
    if port is not None and board is not None:
        ports = Ports(port, board, load_port, baud, load_scale)
    given = {
        "depths_mm": tuple(depth) if depth else None, "dwell_s": dwell, "speed_mm_s": speed,
        "strokes": strokes, "full_n": full,
    }  # fmt: skip
    settings = tuple((name, value) for name, value in given.items() if value is not None)
    options = RigOptions(
        spec, machine, out, ports, tuple(face or ()), _mounting(middle, turn), settings, repeats,
        reference_every, presses, adaptive, resume, tuple(overrides or ()),
    )  # fmt: skip

    def confirmed(plan: list[str]) -> bool:
        typer.echo("\n".join(plan), err=True)
        return yes or typer.confirm("Move the machine?", err=True)

    show(press_with_rig(options, confirmed), as_json)


def _mounting(middle: str | None, turn_deg: float) -> Mounting | None:
    from design.errors import InputError
    from instobj.bench.rig.mounting import Mounting

    if middle is None:
        return None
    try:
        x, y, z = (float(part) for part in middle.split(","))
    except ValueError:
        raise InputError(
            f"--middle {middle!r} is not X,Y,Z in mm, such as --middle -150,-100,-42.5. Lower the tip "
            "until it just holds a sheet of paper on the face's middle, and read MPos"
        ) from None
    return Mounting((x, y, z), turn_deg)

"""The command that runs a press rig."""

from __future__ import annotations

from math import isfinite
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from design.errors import InputError
from instobj.bench.rig.plan_options import PLAN_KEYS, plan_choices, port_and_scale
from instobj.cli.options import AsJson, Overrides, Spec, port_and_baud, show

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
    load_port: Annotated[
        str | None,
        typer.Option(
            metavar="PORT[=SCALE]",
            help="Separate serial port of a load cell; with newtons per unit where it sends one number "
            "per line (=1 where lines name a unit). none: no load cell, travel labels presses.",
        ),
    ] = None,
    face: Annotated[
        list[int] | None, typer.Option(help="Face to press (poses: several, by default all).")
    ] = None,
    middle: Annotated[
        str | None,
        typer.Option(
            metavar="X,Y,Z[,TURN]",
            help="Where the tip just touches the face's middle, in the machine's frame, mm; angle from "
            "the machine's X to the face's x, counter-clockwise, degrees.",
        ),
    ] = None,
    plan: Annotated[
        list[str] | None,
        typer.Option(
            metavar="KEY=VALUE",
            help="Part of the plan, can be repeated: "
            + "; ".join(f"{key}, {entry.meaning}" for key, entry in PLAN_KEYS.items()),
        ),
    ] = None,
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
    load, load_scale = port_and_scale(load_port)
    if port is not None and board is not None:
        by_travel = load == "none"
        load = None if by_travel else load
        ports = Ports(port, board, load, baud, load_scale, by_travel=by_travel)
    options = RigOptions(
        spec, machine, out, ports, tuple(face or ()), _mounting(middle), **plan_choices(plan or []),
        resume=resume, overrides=tuple(overrides or ()),
    )  # fmt: skip

    def confirmed(plan: list[str]) -> bool:
        typer.echo("\n".join(plan), err=True)
        return yes or typer.confirm("Move the machine?", err=True)

    show(press_with_rig(options, confirmed), as_json)


def _mounting(middle: str | None) -> Mounting | None:
    from instobj.bench.rig.mounting import Mounting

    if middle is None:
        return None
    try:
        x, y, z, *turn = (float(part) for part in middle.split(","))
        (turn_deg,) = turn or [0.0]
        # a middle that is no place would pass every comparison with the machine's travel
        if not all(map(isfinite, (x, y, z, turn_deg))):
            raise ValueError
    except ValueError:
        raise InputError(
            f"--middle {middle!r} is not X,Y,Z[,TURN] in mm and degrees, such as --middle "
            "-150,-100,-42.5. Lower the tip until it just holds a sheet of paper on the face's middle, "
            "and read MPos"
        ) from None
    return Mounting((x, y, z), turn_deg)

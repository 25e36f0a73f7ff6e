"""Arguments and options that the commands share, and the output of their results."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Annotated, Any, Literal

import typer

Specs = Annotated[
    list[Path], typer.Argument(help="Specification files (TOML).", show_default=False)
]
Spec = Annotated[Path, typer.Argument(help="Specification (TOML).", show_default=False)]
Recordings = Annotated[
    list[Path], typer.Argument(help="Recordings (CSV or NetCDF).", show_default=False)
]
Sources = Annotated[
    list[Path],
    typer.Argument(help="Specifications (TOML) or data sets (NetCDF).", show_default=False),
]
Out = Annotated[Path, typer.Option(help="Folder for cad_out/ and runs/.")]
AsJson = Annotated[bool, typer.Option("--json", help="Print one JSON document on stdout.")]
Overrides = Annotated[
    list[str] | None,
    typer.Option(
        "--set",
        metavar="KEY=VALUE",
        help="Override a key of the specification, e.g. shell.thickness_mm=9; can be repeated.",
    ),
]
AsBuilt = Annotated[
    Path | None,
    typer.Option(help="Measurements of the built object (default: SPEC.as_built.toml)."),
]
Workers = Annotated[
    int, typer.Option(min=1, help="Number of processes on this machine that make stages.")
]
Scheduler = Annotated[
    str | None,
    typer.Option(help="Dask scheduler whose workers make stages, such as tcp://host:8786."),
]
Port = Annotated[str | None, typer.Option(help="Serial port of the board, e.g. /dev/ttyACM0.")]
LoadPort = Annotated[
    str | None, typer.Option(help="Separate serial port of a load cell or machine.")
]
Baud = Annotated[int, typer.Option(min=300, help="Bits per second.")]
ReplaySpeed = Annotated[
    float, typer.Option(min=0, help="Speed of a replay: 1 as recorded, 0 as fast as possible.")
]
Places = Annotated[
    list[str] | None,
    typer.Option(
        "--place",
        metavar="FACE:X,Y",
        help="Contact location of a load cell, mm, one per cell; :X,Y per further tip of the cell.",
    ),
]
Forces = Annotated[
    list[float] | None,
    typer.Option(
        "--force",
        metavar="N",
        help="Constant force (N) if no load cell is connected, e.g. a dead weight; one per cell.",
    ),
]
Seconds = Annotated[float | None, typer.Option(min=0, help="Stop after this many seconds.")]
ZeroMode = Annotated[
    Literal["rest", "first", "none"] | None,
    typer.Option(
        help="Baseline: tracked at rest (default), from the first frames, or already subtracted."
    ),
]
ZeroFrames = Annotated[int, typer.Option(min=5, help="Frames at rest that give the baseline.")]
HERE = Path()


def show(result: dict[str, Any], as_json: bool) -> None:
    """Print what a command returned: one JSON document, or tables for people."""
    if as_json:
        typer.echo(json.dumps(result, indent=2))
        return
    from instobj.cli.tables import print_result

    print_result(result)


def with_as_built(overrides: list[str] | None, as_built: Path | None) -> list[str]:
    """Overrides with the file of measured positions among them."""
    given = [] if as_built is None else [f"as_built={json.dumps(str(as_built.absolute()))}"]
    return [*(overrides or []), *given]

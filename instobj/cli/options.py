"""Arguments and options that the commands share, and the output of their results."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Annotated, Any, Literal

import typer

from design.errors import InputError

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
Workers = Annotated[
    str,
    typer.Option(
        metavar="N|ADDRESS",
        help="Processes on this machine that make stages, or a Dask scheduler, tcp://host:8786.",
    ),
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
DESIGN, JUDGE, MEASURE, KEEP = (
    "Design",
    "Judge a design",
    "Measure and estimate",
    "Results and pages",
)
"""Headings of `instobj --help`."""


def show(result: dict[str, Any], as_json: bool) -> None:
    """Print what a command returned: one JSON document, or tables for people."""
    if as_json:
        typer.echo(json.dumps(result, indent=2))
        return
    from instobj.cli.tables import print_result

    print_result(result)


TARGETS = {
    "mesh": "mesh",
    "presses": "signals discretisation",
    "scores": "scores weak_areas discretisation",
    "compliance": "compliance",
    "identify": "identify",
    "robustness": "robustness",
    "slip": "slip",
    "frames": "frames",
    "pretraining": "pretraining",
    "report": "report",
}
"""Results that `instobj run --to` names, and the stages that make them."""


def run_to(
    stages: str,
    specs: list[Path],
    out: Path,
    as_json: bool,
    overrides: list[str] | None,
    workers: str = "1",
) -> None:
    """Bring specifications to stages (separated by blanks) and print what came out."""
    from instobj.commands.run import run_chain, simulate_recordings

    number, scheduler = workers_and_scheduler(workers)
    if stages == "frames":
        show(simulate_recordings(specs, out, overrides or [], number, scheduler), as_json)
    else:
        chain = tuple(stages.split())
        show(run_chain(specs, chain, out, overrides or [], number, scheduler), as_json)


def workers_and_scheduler(workers: str) -> tuple[int, str | None]:
    """Number of processes, and the address of a Dask scheduler where one is given.

    Raises
    ------
    InputError
        Neither a number above 0 nor an address.
    """
    if "://" in workers:
        return 1, workers
    if not workers.isdecimal() or int(workers) < 1:
        raise InputError(
            f"--workers must be a number of processes above 0, or the address of a Dask scheduler "
            f"(tcp://host:8786); got {workers!r}"
        )
    return int(workers), None

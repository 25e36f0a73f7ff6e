"""Arguments and options that the commands share, and the output of their results."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Annotated, Any, Literal, get_args

import typer

from design.errors import InputError

ZeroMode = Literal["rest", "first", "none"]
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
BodyKind = Annotated[
    str | None, typer.Option(help="Kind of body (see `instobj docs bodies`).", show_default=False)
]
BodySize = Annotated[
    str | None, typer.Option(metavar="X Y Z", help="Box around the body, mm.", show_default=False)
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
Port = Annotated[
    str | None,
    typer.Option(
        metavar="PORT[@BAUD]",
        help="Serial port of the board, e.g. /dev/ttyACM0; 115200 bits per second without @BAUD.",
    ),
]
LoadPort = Annotated[
    str | None, typer.Option(help="Separate serial port of a load cell or machine.")
]
Replay = Annotated[
    str | None,
    typer.Option(
        metavar="FILE[@SPEED]",
        help="Recording to replay in place of a board: @1 as recorded (default), @0 as fast as possible.",
    ),
]
Places = Annotated[
    list[str] | None,
    typer.Option(
        "--place",
        metavar="FACE:X,Y[=N|=2mm]",
        help="Contact location of a load cell, mm, one per cell; :X,Y per further tip of the cell; - where "
        "nothing is pressed yet, -:- by two tips. Without a load cell: =N, constant force (N) of a weight; "
        "=2mm, a machine's travel below first touch.",
    ),
]
Seconds = Annotated[float | None, typer.Option(min=0, help="Stop after this many seconds.")]
Zero = Annotated[
    str | None,
    typer.Option(
        metavar="MODE[:FRAMES]",
        help="Baseline: rest, tracked at rest (default); first, of the first frames; none, already "
        "subtracted. FRAMES at rest give it.",
    ),
]
BAUD = 115_200
"""Bits per second of a serial port, as firmware is written by default."""
_FEWEST_FRAMES = 5
"""Frames of a baseline, at least: fewer do not tell noise from rest."""
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
    "scores": "scores weak_areas press_curves discretisation",
    "compliance": "compliance",
    "identify": "identify",
    "robustness": "robustness",
    "slip": "slip",
    "frames": "frames",
    "verdict": "scores weak_areas press_curves robustness alternatives",
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
    from instobj.commands.run import run_to_target, simulate_recordings

    number, scheduler = workers_and_scheduler(workers)
    if stages == "frames":
        show(simulate_recordings(specs, out, overrides or [], number, scheduler), as_json)
    else:
        chain = tuple(stages.split())
        show(run_to_target(specs, chain, out, overrides or [], number, scheduler), as_json)


def port_and_baud(port: str | None) -> tuple[str | None, int]:
    """Serial port and its bits per second, of `PORT[@BAUD]`.

    Raises
    ------
    InputError
        What follows the last @ is no number of 300 or more.
    """
    name, separator, baud = (port or "").rpartition("@")
    if not separator:
        return port, BAUD
    if not baud.isdecimal() or int(baud) < 300:
        raise InputError(
            f"{port}: {baud!r} is no number of bits per second. Give PORT@BAUD, such as "
            f"/dev/ttyACM0@{BAUD}"
        )
    return name, int(baud)


def replayed_file(text: str | None) -> tuple[Path | None, float]:
    """File and speed of a replay, of `FILE[@SPEED]`; a file whose own name holds the @ comes first.

    Raises
    ------
    InputError
        What follows the last @ is no speed of 0 or more.
    """
    if text is None or "@" not in text or Path(text).exists():
        return (None if text is None else Path(text)), 1.0
    name, _, speed = text.rpartition("@")
    try:
        value = float(speed)
    except ValueError:
        value = -1.0
    if not 0 <= value < float("inf"):
        raise InputError(
            f"--replay {text}: {speed!r} is no speed. Give FILE@2 for twice as fast, FILE@0 for as fast "
            "as possible"
        )
    return Path(name), value


def zero_and_frames(text: str | None, frames: int) -> tuple[ZeroMode | None, int]:
    """Mode and frames of a baseline, of `MODE[:FRAMES]`; `frames` where none are given.

    Raises
    ------
    InputError
        Another mode, or fewer than five frames.
    """
    if text is None:
        return None, frames
    mode, colon, given = text.partition(":")
    many = int(given) if given.isdecimal() else 0 if colon else frames
    for name in get_args(ZeroMode):
        if mode == name and many >= _FEWEST_FRAMES:
            return name, many
    raise InputError(
        f"--zero {text}: give rest, first or none, with :FRAMES of {_FEWEST_FRAMES} or more where "
        f"{frames} are not wanted, such as rest:20"
    )


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

"""Commands that meet real things: silicones, boards, recordings, built objects."""

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
def recordings(
    files: Recordings,
    spec: Annotated[
        Path | None, typer.Option(help="Specification of the object: its contact grid.")
    ] = None,
    out: Out = HERE,
    as_json: AsJson = False,
) -> None:
    """Read recordings, find and correct their faults, and write a data set to train on."""
    from instobj.commands.training import read_recordings

    show(read_recordings(files, out, spec), as_json)


@app.command()
def collect(
    out: Annotated[
        Path,
        typer.Argument(
            metavar="OUT", help="Recording: OUT.csv grows, OUT.nc is written at the end."
        ),
    ],
    port: Annotated[
        str | None, typer.Option(help="Serial port of the board, e.g. /dev/ttyACM0.")
    ] = None,
    replay: Annotated[
        Path | None, typer.Option(help="Recording to replay in place of a board.")
    ] = None,
    load_port: Annotated[
        str | None, typer.Option(help="Separate serial port of a load cell or machine.")
    ] = None,
    place: Annotated[
        list[str] | None,
        typer.Option(
            metavar="FACE:X,Y",
            help="Contact location of load cell 1 (2, …), mm; :X,Y for each further tip.",
        ),
    ] = None,
    force: Annotated[
        list[float] | None,
        typer.Option(
            metavar="N", help="Constant force (N) if no load cell is connected, e.g. a dead weight."
        ),
    ] = None,
    zero: Annotated[
        int, typer.Option(min=0, help="Frames at the start, nothing touching, for the baseline.")
    ] = 20,
    seconds: Annotated[
        float | None, typer.Option(min=0, help="Stop after this many seconds.")
    ] = None,
    frames: Annotated[int | None, typer.Option(min=1, help="Stop after this many frames.")] = None,
    session: Annotated[
        int | None, typer.Option(min=1, help="Session number (default: continue the last session).")
    ] = None,
    cells: Annotated[int | None, typer.Option(min=1, max=9, help="Load cells.")] = None,
    tips: Annotated[int | None, typer.Option(min=1, max=9, help="Tips per load cell.")] = None,
    baud: Annotated[int, typer.Option(min=300, help="Bits per second.")] = 115_200,
    speed: Annotated[
        float, typer.Option(min=0, help="Speed of a replay: 1 as recorded, 0 as fast as possible.")
    ] = 1.0,
    as_json: AsJson = False,
) -> None:
    """Collect labelled frames from a board (or a replay) into a recording to calibrate with."""
    from instobj.commands.hardware.collect import collect as collect_frames
    from instobj.commands.hardware.collect_options import CollectOptions

    options = CollectOptions(
        out, port, replay, load_port, baud, speed, tuple(place or ()), tuple(force or ()),
        cells, tips, session, zero, seconds, frames,
    )  # fmt: skip
    show(collect_frames(options), as_json)


@app.command()
def firmware(
    spec: Spec,
    board: Annotated[str, typer.Option(help="Board that reads the sensors: mega2560 or pico.")],
    way: Annotated[
        str | None,
        typer.Option(help="How chips are told apart, e.g. multiplexers (default: the cheapest)."),
    ] = None,
    lead: Annotated[
        float, typer.Option(min=0, max=5000, help="Wires from the object to the board, mm.")
    ] = 200.0,
    out: Out = HERE,
    as_json: AsJson = False,
    overrides: Overrides = None,
) -> None:
    """Plan the sensors' buses on a board and write its firmware."""
    from instobj.commands.hardware.firmware import write_firmware

    show(write_firmware(spec, board, way, lead, out, overrides or []), as_json)


@app.command()
def material(
    source: Annotated[
        str,
        typer.Argument(help="CSV of a tensile test, a name, or a hardness.", show_default=False),
    ],
    out: Out = HERE,
    as_json: AsJson = False,
) -> None:
    """Young's modulus of a silicone with its uncertainty; models fitted to a tensile test."""
    from instobj.commands.material import describe_material

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
    from instobj.commands.hardware.validate import self_test_of

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
    from instobj.commands.hardware.validate import validate_on

    given = with_as_built(overrides, as_built)
    show(validate_on(spec, recordings, exchanges, out, given), as_json)

"""Commands that read recordings of a real object, and hold a model against them."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from instobj.cli.options import (
    HERE,
    MEASURE,
    AsJson,
    Out,
    Overrides,
    Recordings,
    Spec,
    show,
)

app = typer.Typer()


@app.command(rich_help_panel=MEASURE)
def recordings(
    files: Recordings,
    spec: Annotated[
        Path | None,
        typer.Option(
            help="Specification of the object, for its contact grid and to judge doubtful labels."
        ),
    ] = None,
    out: Annotated[
        Path,
        typer.Option(
            help="Folder for runs/; NAME.mcap, NAME.lerobot: write one recording as a bag of ROS 2, or a "
            "data set of LeRobot, unchanged."
        ),
    ] = HERE,
    as_json: AsJson = False,
) -> None:
    """Read recordings, find and correct their faults, and write a data set to train on."""
    from instobj.commands.training import read_recordings

    show(read_recordings(files, out, spec), as_json)


@app.command(rich_help_panel=MEASURE)
def adopt(
    logs: Annotated[
        list[Path],
        typer.Argument(help="Logs of one object: any tables of numbers.", show_default=False),
    ],
    statements: Annotated[
        list[str] | None,
        typer.Option(
            "--known",
            metavar="KEY=VALUE|FILE",
            help="What the log cannot tell, such as step_mm=1.0, pitch_mm=[10,12], label=travel, axes=chip "
            "or columns=time,face,place,level,chips (a chip is one sensor, three columns); or a TOML file "
            "of these; can be repeated.",
        ),
    ] = None,
    spec: Annotated[
        Path | None, typer.Option(help="Specification to start from; it is fitted to the logs.")
    ] = None,
    out: Out = HERE,
    as_json: AsJson = False,
    overrides: Overrides = None,
) -> None:
    """Identify an object that others built from its logs, and fit a specification to it."""
    from instobj.commands.adopt import adopt_logs

    show(adopt_logs(logs, statements or [], spec, out, overrides or []), as_json)


@app.command(rich_help_panel=MEASURE)
def validate(
    spec: Spec,
    recordings: Recordings,
    out: Out = HERE,
    as_json: AsJson = False,
    overrides: Overrides = None,
) -> None:
    """Predicted against recorded presses, every figure with its permutation null."""
    from instobj.commands.recorded.validate import validate_on

    show(validate_on(spec, recordings, out, overrides or []), as_json)

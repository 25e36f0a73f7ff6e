"""Command line of the studies: `python -m studies NAME INPUT`, in a checkout of the repository."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from instobj.cli.app import run_command
from instobj.cli.options import HERE, AsJson, Out, Overrides, Spec, show
from studies.registry import run_study, studies

app = typer.Typer(
    name="python -m studies",
    help="The paper's tables and figures, and studies of layouts: each writes a table and a figure.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
)


def _add_study(name: str, purpose: str) -> None:
    """Add a study of a specification as a command of its name."""

    def command(
        spec: Spec,
        quick: Annotated[bool, typer.Option("--quick", help="Coarse preview.")] = False,
        out: Out = HERE,
        as_json: AsJson = False,
        overrides: Overrides = None,
    ) -> None:
        show(run_study(name, spec, out, quick, overrides or []), as_json)

    app.command(name, help=purpose)(command)


for _study in studies().values():
    _add_study(_study.name, _study.help)


@app.command()
def travel(
    spec: Spec,
    recording: Annotated[
        Path, typer.Argument(help="Folder with sensor.csv and states.csv, or a log.")
    ],
    repeats: Annotated[
        Path | None, typer.Argument(help="The same of repeated presses on that machine.")
    ] = None,
    known: Annotated[
        list[str] | None, typer.Option(help="Of a log: as for `instobj adopt`.")
    ] = None,
    out: Out = HERE,
    as_json: AsJson = False,
    overrides: Overrides = None,
) -> None:
    """Presses of known travel: places read, the bound of the place, what residuals point to, and
    the presses replayed through the simulated object."""
    from studies.recorded.travel import replay_of_log, travel_of

    if recording.is_file():
        show(replay_of_log(spec, recording, known or [], overrides or []), as_json)
        return
    show(travel_of(spec, recording, repeats, out, overrides or []), as_json)


if __name__ == "__main__":
    run_command(app)

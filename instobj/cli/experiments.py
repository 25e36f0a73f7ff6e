"""Commands that run experiments: studies of the design and the paper's experiments."""

from __future__ import annotations

from typing import Annotated

import typer

from instobj.cli.options import HERE, AsJson, Out, Overrides, Spec, show

app = typer.Typer()


@app.command()
def experiment(
    name: Annotated[
        str, typer.Argument(help="Which experiment; `instobj experiments` lists them.")
    ],
    spec: Spec,
    quick: Annotated[
        bool, typer.Option("--quick", help="Fewer and coarser cases: a look, no result.")
    ] = False,
    out: Out = HERE,
    as_json: AsJson = False,
    overrides: Overrides = None,
) -> None:
    """Run an experiment on a specification: a table and a figure."""
    from instobj.experiments.registry import run_study

    show(run_study(name, spec, out, quick, overrides or []), as_json)


@app.command()
def experiments(as_json: AsJson = False) -> None:
    """List the experiments."""
    from instobj.experiments.registry import studies

    rows = [{"experiment": study.name, "answers": study.help} for study in studies().values()]
    show({"command": "experiments", "tables": {"experiments": rows}}, as_json)

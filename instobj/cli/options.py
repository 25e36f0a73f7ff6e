"""Arguments and options that the commands share, and the output of their results."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Annotated, Any

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
Out = Annotated[Path, typer.Option(help="Folder that gets cad_out/ and runs/.")]
AsJson = Annotated[bool, typer.Option("--json", help="Print one JSON document on stdout.")]
Overrides = Annotated[
    list[str] | None,
    typer.Option("--set", metavar="KEY=VALUE", help="Override, e.g. shell.thickness_mm=9."),
]
AsBuilt = Annotated[
    Path | None,
    typer.Option(help="Measurements of the built object (default: SPEC.as_built.toml)."),
]
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

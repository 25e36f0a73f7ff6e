"""The `instobj` command: thin, typed, and quick to start (heavy imports inside the commands)."""

from __future__ import annotations

import json
import re
import signal
import sys
import warnings
from pathlib import Path
from typing import Annotated

import typer

from design.errors import InstobjError
from instobj.cli import estimators as cli_estimators
from instobj.cli import hardware as cli_hardware
from instobj.cli import presses as cli_presses
from instobj.cli import recorded as cli_recorded
from instobj.cli import rig as cli_rig
from instobj.cli import search as cli_search
from instobj.cli.options import (
    HERE,
    AsBuilt,
    AsJson,
    Out,
    Overrides,
    Scheduler,
    Specs,
    Workers,
    show,
    with_as_built,
)
from instobj.store.progress import show_progress

app = typer.Typer(
    name="instobj",
    help="Design, simulate and calibrate instrumented objects that feel how they are grasped.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
)


@app.command()
def new(
    name: Annotated[str, typer.Argument(help="Name of the object.")],
    kind: Annotated[
        str | None,
        typer.Option(help="Kind of body (see `instobj docs bodies`).", show_default=False),
    ] = None,
    size: Annotated[
        str | None,
        typer.Option(metavar="X Y Z", help="Box around the body, mm.", show_default=False),
    ] = None,
    sensors: Annotated[
        int | None, typer.Option(min=1, max=12, help="Sensors per face (default: 3).")
    ] = None,
    magnets: Annotated[
        int | None,
        typer.Option(min=1, max=12, help="Magnets per face (default: what fits, up to 5)."),
    ] = None,
    file: Annotated[
        Path | None,
        typer.Option("--from", metavar="FILE", help="Closed surface of an imported body."),
    ] = None,
    unit: Annotated[
        str | None, typer.Option(help="Unit of the lengths in the file: mm (default), cm, m, in.")
    ] = None,
    scale: Annotated[
        float | None, typer.Option(help="Factor on the lengths in the file (default: 1).")
    ] = None,
    out: Out = HERE,
) -> None:
    """Write a commented specification to start from, NAME.toml, with everything placed to fit."""
    from instobj.commands.new import new_specification, request_of, size_of

    size_mm = None if size is None else size_of(size, kind)
    request = request_of(kind, size_mm, sensors, magnets, file, unit, scale)
    typer.echo(f"wrote {new_specification(name, out, request)}")


@app.command()
def docs(
    page: Annotated[str | None, typer.Argument(help="Name of a page.", show_default=False)] = None,
) -> None:
    """Print a page of the documentation, or the names of the pages."""
    from instobj.commands.docs import page_names, page_text

    typer.echo(page_text(page) if page else "\n".join(page_names()))


@app.command()
def check(
    specs: Specs,
    fabrication: Annotated[
        bool,
        typer.Option(
            "--fabrication", help="Also check that the parts can be printed, cast and assembled."
        ),
    ] = False,
    out: Out = HERE,
    as_json: AsJson = False,
    overrides: Overrides = None,
) -> None:
    """Validate specifications: keys, bounds, whether everything fits, and sensors at rest."""
    from instobj.commands.run import check_specifications

    result = check_specifications(specs, overrides or [])
    if fabrication:
        from instobj.commands.run import fabrication_of

        result["fabrication"] = fabrication_of(specs, overrides or [], out)
    show(result, as_json)
    if any(item["status"] == "fail" for item in result.get("fabrication", ())):
        raise typer.Exit(1)


def _chain_command(name: str, stages: str, purpose: str) -> None:
    """A command that brings specifications to a stage, or to several."""

    def command(
        specs: Specs,
        out: Out = HERE,
        as_json: AsJson = False,
        overrides: Overrides = None,
        as_built: AsBuilt = None,
        workers: Workers = 1,
        scheduler: Scheduler = None,
    ) -> None:
        from instobj.commands.run import run_chain

        given = with_as_built(overrides, as_built)
        show(run_chain(specs, tuple(stages.split()), out, given, workers, scheduler), as_json)

    app.command(name, help=purpose)(command)


for _name, _stages, _purpose in (
    (
        "build",
        "sheet",
        "Parts, mould, probes and jig as STL, STEP, 3MF and GLB; bill of materials, assembly sheet.",
    ),
    (
        "mesh",
        "mesh",
        "Tetrahedral mesh of the sealed body with every magnet resolved, and its quality.",
    ),
    (
        "simulate",
        "signals discretisation",
        "Mechanics of every press, and the signals of all sensors.",
    ),
    (
        "compliance",
        "compliance",
        "Compliance map: indentation depth per newton on all faces, with and without magnets.",
    ),
    (
        "identify",
        "identify",
        "How many simultaneous contacts are identifiable, by number of sensors.",
    ),
    (
        "robustness",
        "robustness",
        "Effect of the tolerances of assembly, material and surroundings, ranked.",
    ),
    (
        "pretrain",
        "pretraining",
        "Estimators trained on simulated virtual objects, to start `train --start` from.",
    ),
    (
        "report",
        "report",
        "One self-contained report.html: go or no-go, tables, figures and provenance.",
    ),
    ("run", "report", "The whole chain, stage by stage; stored results are reused."),
):
    _chain_command(_name, _stages, _purpose)


@app.command()
def score(
    specs: Specs,
    hull: Annotated[
        str | None,
        typer.Option(
            help="Method for the sensitivity δ: covariance, monte-carlo (any N) or exact (N ≤ 100)."
        ),
    ] = None,
    hull_frames: Annotated[
        int | None, typer.Option(help="Number N of frames in the convex hull.")
    ] = None,
    shear: Annotated[
        bool, typer.Option("--shear", help="Also Cramér–Rao bounds of (x, y, F, Fx, Fy).")
    ] = False,
    out: Out = HERE,
    as_json: AsJson = False,
    overrides: Overrides = None,
    as_built: AsBuilt = None,
) -> None:
    """Sensitivity, Cramér–Rao bounds and maps of every contact location."""
    chosen = {"score.hull": hull, "score.hull_frames": hull_frames}
    more = [f"{key}={value}" for key, value in chosen.items() if value is not None]
    more_scores = ("shear_scores",) if shear else ()
    stages = ("scores", "weak_areas", *more_scores, "discretisation")
    _chain(specs, stages, out, as_json, [*with_as_built(overrides, as_built), *more])


@app.command()
def compare(
    specs: Specs,
    out: Out = HERE,
    as_json: AsJson = False,
    overrides: Overrides = None,
) -> None:
    """Two to four designs side by side: scores, and a page where one press goes to all of them."""
    from instobj.commands.comparison import compare_designs

    show(compare_designs(specs, out, overrides or []), as_json)


@app.command()
def store(
    verify: Annotated[
        bool, typer.Option("--verify", help="Read all files and compare them with their hashes.")
    ] = False,
    free: Annotated[
        str | None,
        typer.Option(
            metavar="SIZE", help="Space to free, e.g. 5GB; least recently used results go first."
        ),
    ] = None,
    older_than: Annotated[
        str | None,
        typer.Option(metavar="AGE", help="Remove only results not used for this long, e.g. 30d."),
    ] = None,
    as_json: AsJson = False,
) -> None:
    """List stored results, verify them, free space; what a running process uses stays."""
    from instobj.commands.stored import look_after_store
    from instobj.store.content import store_root

    result = look_after_store(store_root(), verify, free, older_than)
    show(result, as_json)
    if result["damaged"]:
        raise typer.Exit(1)


app.add_typer(cli_estimators.app)
app.add_typer(cli_presses.app)
app.add_typer(cli_hardware.app)
app.add_typer(cli_recorded.app)
app.add_typer(cli_rig.app)
app.add_typer(cli_search.app)


def _chain(
    specs: list[Path],
    stages: tuple[str, ...],
    out: Path,
    as_json: bool,
    overrides: list[str] | None,
) -> None:
    from instobj.commands.run import run_chain

    show(run_chain(specs, stages, out, overrides or []), as_json)


def main() -> None:
    """Entry point: bad input ends with one error message and exit code 2, without a traceback."""
    show_progress()
    interrupted = _note_interrupts()
    warnings.formatwarning = _warning_line
    code = 0
    try:
        code = app(with_joined_sizes(sys.argv[1:]), standalone_mode=False)
    except typer.BadParameter as error:
        error.show()
        sys.exit(2)
    except typer.TyperException as error:
        _fail(str(error), 2)
    except ArithmeticError as error:
        _fail(f"the computation failed: {error}", 2)
    except InstobjError as error:
        _fail(str(error), 2)
    except MemoryError as error:
        _fail(f"out of memory: {error}. Use a larger mesh.edge_mm or mesh.surface_edge_mm", 2)
    except (KeyboardInterrupt, typer.Abort, ImportError):
        if not interrupted:  # an import that Ctrl-C breaks off may raise ImportError instead
            raise
    if interrupted:
        again = "the same command goes on from there (optimize: with --resume)"
        _fail(f"interrupted. Finished stages are kept: {again}", 130)
    sys.exit(code)


def with_joined_sizes(words: list[str]) -> list[str]:
    """The words of a command, the lengths after --size as one: an option takes a fixed number of them."""
    joined: list[str] = []
    for word in words:
        after_size = len(joined) > 1 and joined[-2] == "--size"
        if after_size and _LENGTH.fullmatch(word) and _LENGTH.match(joined[-1]):
            joined[-1] += f" {word}"
        else:
            joined.append(word)
    return joined


_LENGTH = re.compile(r"[+-]?\.?\d[^ ]*")


def _warning_line(
    message: Warning | str,
    category: type[Warning],
    filename: str,
    lineno: int,
    line: str | None = None,
) -> str:
    """What users are warned of in one line; other warnings with the line of code."""
    if category in (UserWarning, FutureWarning):
        return f"warning: {message}\n"
    return f"{filename}:{lineno}: {category.__name__}: {message}\n"


def _note_interrupts() -> list[int]:
    """Interrupts received so far, besides raising KeyboardInterrupt as usual."""
    received: list[int] = []

    def note(number: int, frame: object) -> None:
        received.append(number)
        raise KeyboardInterrupt

    signal.signal(signal.SIGINT, note)
    return received


def _fail(message: str, code: int) -> None:
    if "--json" in sys.argv:
        typer.echo(json.dumps({"error": message}))
    typer.echo(f"error: {message}", err=True)
    sys.exit(code)

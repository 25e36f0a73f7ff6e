"""The `instobj` command: thin, typed, and quick to start (heavy imports inside the commands)."""

from __future__ import annotations

import _thread
import json
import os
import re
import signal
import sys
import threading
import warnings
from importlib import metadata
from pathlib import Path
from typing import Annotated, Any

import typer

from design.errors import InputError, InstobjError
from design.imports import missing_extra
from design.processes import ONE_THREAD
from instobj.cli import estimators as cli_estimators
from instobj.cli import presses as cli_presses
from instobj.cli import recorded as cli_recorded
from instobj.cli import search as cli_search
from instobj.cli.bench import Bench
from instobj.cli.options import (
    DESIGN,
    HERE,
    JUDGE,
    KEEP,
    MEASURE,
    TARGETS,
    AsJson,
    BodyKind,
    BodySize,
    Out,
    Overrides,
    Specs,
    Workers,
    run_to,
    show,
)
from instobj.cli.renamed import OPTIONS, add_renamed
from instobj.store.progress import show_progress

app = typer.Typer(
    name="instobj",
    add_completion=False,
    pretty_exceptions_enable=False,
)

FIRST_SESSION = """A first session:
  instobj new my_object            write a specification, my_object.toml
  instobj check my_object.toml     does everything fit?
  instobj score my_object.toml     how well is a contact located, and where not?
  instobj optimize my_object.toml  find a better layout of magnets and sensors
  instobj build my_object.toml     parts and mould to print, and what to order

All commands: instobj --help. What one does: instobj COMMAND --help."""


@app.callback(invoke_without_command=True)
def first_session(context: typer.Context) -> None:
    """Design, simulate and calibrate instrumented objects that feel how they are grasped."""
    if context.invoked_subcommand is None:
        typer.echo(f"instobj {metadata.version('instobj')}. {FIRST_SESSION}")


@app.command(rich_help_panel=DESIGN)
def new(
    name: Annotated[str, typer.Argument(help="Name of the object.")],
    kind: BodyKind = None,
    size: BodySize = None,
    sensors: Annotated[
        int | None,
        typer.Option(min=1, max=12, help="Sensors per face (default: 3, or as many as fit)."),
    ] = None,
    magnets: Annotated[
        int | None,
        typer.Option(
            min=1, max=12, help="Magnets per face (default: 5, or 9 where that reads better)."
        ),
    ] = None,
    file: Annotated[
        Path | None,
        typer.Option("--from", metavar="FILE", help="Closed surface of an imported body."),
    ] = None,
    scale: Annotated[
        float | None,
        typer.Option(help="Factor on the lengths in the file: 1 for mm (default), 10 for cm, …"),
    ] = None,
    out: Out = HERE,
) -> None:
    """Write a commented specification to start from, NAME.toml, with everything placed to fit."""
    from instobj.commands.new import new_specification, placed_text, request_of, size_of
    from instobj.commands.next_step import next_step

    size_mm = None if size is None else size_of(size, kind)
    request = request_of(kind, size_mm, sensors, magnets, file, scale)
    written = new_specification(name, out, request)
    text = placed_text(written, request)
    typer.echo(f"wrote {written}\n{text}\nnext: {next_step('new', written)}")


@app.command(rich_help_panel=KEEP)
def docs(
    page: Annotated[str | None, typer.Argument(help="Name of a page.", show_default=False)] = None,
) -> None:
    """Print a page of the documentation, or the names of the pages."""
    from instobj.commands.docs import page_names, page_text

    typer.echo(page_text(page) if page else "\n".join(page_names()))


@app.command(rich_help_panel=DESIGN)
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
    from instobj.commands.next_step import next_step
    from instobj.commands.run import check_specifications

    result = check_specifications(specs, overrides or [])
    if fabrication:
        from instobj.commands.run import fabrication_of

        result["fabrication"] = fabrication_of(specs, overrides or [], out)
    failed = any(item["status"] == "fail" for item in result.get("fabrication", ()))
    done = "check failed" if failed else "check"
    show(result | {"next": next_step(done, *specs, overrides=overrides or [])}, as_json)
    if failed:
        raise typer.Exit(1)


@app.command(rich_help_panel=DESIGN)
def build(
    specs: Specs,
    twin: Annotated[
        bool, typer.Option("--twin", help="Also MJCF, URDF and USD for physics simulators.")
    ] = False,
    out: Out = HERE,
    as_json: AsJson = False,
    overrides: Overrides = None,
) -> None:
    """Parts, mould, probes and jig as STL, STEP, 3MF and GLB; order list, assembly sheet."""
    from instobj.commands.run import build_objects

    result = build_objects(specs, out, overrides or [])
    if twin:
        from instobj.commands.twin import write_twins

        write_twins(specs, overrides or [], out, result)
    show(result, as_json)


@app.command(rich_help_panel=JUDGE)
def run(
    specs: Specs,
    to: Annotated[
        str, typer.Option(help=f"Last stage: {', '.join(TARGETS)}.", show_default=True)
    ] = "report",
    workers: Workers = "1",
    out: Out = HERE,
    as_json: AsJson = False,
    overrides: Overrides = None,
) -> None:
    """The whole chain, stage by stage, or up to one result; stored results are reused."""
    if to not in TARGETS:
        raise InputError(f"--to names no result: {to!r}. Choose one of {', '.join(TARGETS)}")
    run_to(TARGETS[to], specs, out, as_json, overrides, workers)


@app.command(rich_help_panel=JUDGE)
def score(
    specs: Specs,
    also: Annotated[
        list[str] | None,
        typer.Option(
            metavar="shear|jaw",
            help="Bounds beside those of tips: of (x, y, F, Fx, Fy), or of a flat jaw over each face; can "
            "be repeated.",
        ),
    ] = None,
    out: Out = HERE,
    as_json: AsJson = False,
    overrides: Overrides = None,
) -> None:
    """Sensitivity, Cramér–Rao bounds and maps of every contact location; designs side by side."""
    from instobj.commands.comparison import score_designs

    show(score_designs(specs, also or [], out, overrides or []), as_json)


@app.command(rich_help_panel=KEEP)
def store(
    verify: Annotated[
        bool, typer.Option("--verify", help="Read all files and compare them with their hashes.")
    ] = False,
    free: Annotated[
        str | None,
        typer.Option(
            metavar="SIZE|AGE",
            help="Space to free, e.g. 5GB, least recently used results first; or those not used for so "
            "long, e.g. 30d.",
        ),
    ] = None,
    as_json: AsJson = False,
) -> None:
    """List stored results, verify them, free space; results in use are kept."""
    from instobj.commands.stored import look_after_store
    from instobj.store.content import store_root

    result = look_after_store(store_root(), verify, free)
    show(result, as_json)
    if result["damaged"]:
        raise typer.Exit(1)


for _commands in (cli_search, cli_estimators, cli_presses, cli_recorded):
    app.add_typer(_commands.app)
bench = typer.Typer(cls=Bench, help="Boards, machines and built objects.", no_args_is_help=True)
app.add_typer(bench, name="bench", rich_help_panel=MEASURE)
add_renamed(app, score)


def main() -> None:
    """Run the command line of `instobj`."""
    run_command(app, with_joined_sizes(sys.argv[1:]))


def run_command(command: typer.Typer, arguments: list[str] | None = None) -> None:
    """Run a command line: bad input ends with one error and exit code 2, without a traceback.

    Libraries take one thread, unless the environment says otherwise.
    """
    for name, count in ONE_THREAD.items():
        os.environ.setdefault(name, count)
    show_progress()
    interrupted = _note_interrupts()
    warnings.formatwarning = _warning_line
    code = 0
    try:
        code = command(arguments, standalone_mode=False)
    except typer.BadParameter as error:
        error.show()
        sys.exit(2)
    except typer.TyperException as error:
        _fail(str(error) + _instead_of(error), 2)
    except ArithmeticError as error:
        _fail(f"the computation failed: {error}", 2)
    except InstobjError as error:
        _fail(str(error), 2)
    except ModuleNotFoundError as error:
        if interrupted or (advice := missing_extra(error)) is None:
            raise
        _fail(advice, 2)
    except MemoryError as error:
        _fail(f"out of memory: {error}. Use a larger mesh.edge_mm or mesh.surface_edge_mm", 2)
    except (KeyboardInterrupt, typer.Abort, ImportError):
        if not interrupted:  # an import that Ctrl-C breaks off may raise ImportError instead
            raise
    if interrupted:
        again = "the same command goes on from there (optimize: with --resume)"
        _fail(f"interrupted. Finished stages are kept: {again}", 130)
    sys.exit(code)


def _instead_of(error: typer.TyperException) -> str:
    """Return what to write in place of an option that is none: gone with 0.2.0, or a key."""
    name, context = getattr(error, "option_name", ""), getattr(error, "ctx", None)
    of_command = f"{context.info_name} {name}" if context is not None else name
    if instead := OPTIONS.get(of_command) or OPTIONS.get(name):
        stop = "" if str(error)[-1] in ".?" else "."
        return f"{stop} It went with 0.2.0: {instead}"
    # only keys of a specification have a dot in their names
    return f". Keys are set by --set: --set {name.lstrip('-')}=VALUE" if "." in name else ""


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
    """Return what users are warned of in one line; other warnings with the line of code."""
    if category is UserWarning:
        return f"warning: {message}\n"
    return f"{filename}:{lineno}: {category.__name__}: {message}\n"


def _note_interrupts() -> list[int]:
    """Interrupts received so far, apart from raising KeyboardInterrupt as usual."""
    received: list[int] = []

    def note(number: int, frame: object) -> None:
        received.append(number)
        raise KeyboardInterrupt

    signal.signal(signal.SIGINT, note)
    sys.unraisablehook = _interrupt_again
    return received


_AGAIN_S = 0.05
"""Time after which the destructor or callback that met an interrupt has ended."""


def _interrupt_again(ignored: Any) -> None:
    """Raise an interrupt once more that a destructor or callback met, which Python prints and forgets."""
    if issubclass(ignored.exc_type, KeyboardInterrupt):
        again = threading.Timer(
            _AGAIN_S, _thread.interrupt_main
        )  # at once, this hook would meet it
        again.daemon = True
        again.start()
    else:
        sys.__unraisablehook__(ignored)


def _fail(message: str, code: int) -> None:
    if "--json" in sys.argv:
        typer.echo(json.dumps({"error": message}))
    typer.echo(f"error: {message}", err=True)
    sys.exit(code)

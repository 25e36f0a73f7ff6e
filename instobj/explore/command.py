"""`instobj explore`: a page on this machine on which a design is moved by hand, or a file to look at."""

from __future__ import annotations

import socket
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path
from typing import Any

from aiohttp import web

from design.errors import InputError
from design.files import atomic_path
from design.placement.asked import most_printed_mm, place_parts
from design.placement.objects import Request
from design.spec_io import load_spec
from instobj.commands.new import new_specification
from instobj.explore.engine import open_explorer, open_shell
from instobj.explore.server import ADDRESS, Session, application
from instobj.store.progress import ProgressLine
from instobj.store.publish import file_rows


def explore(
    spec: Path | None,
    request: Request | None,
    port: int,
    export: Path | None,
    overrides: list[str],
) -> dict[str, Any]:
    """Serve the page of a specification, or of a new one for what is requested, until it is stopped; or
    write it to a file.

    Raises
    ------
    InputError
        Neither or both of a specification and a request, a specification that the quick model cannot judge,
        or a port that cannot be listened on.
    """
    progress = ProgressLine()
    if request is not None and spec is None:
        with progress.stage("parts placed by rules"):
            spec = requested_specification(request, progress.say)
    elif request is not None or spec is None:
        raise InputError(
            "explore takes a specification, or --kind and --size of a new one. Give one of them"
        )
    design = load_spec(spec, overrides)
    if export is not None:
        progress.say(
            "mechanics of the shell without magnets: minutes the first time, seconds afterwards"
        )
        session = Session(open_explorer(design), spec)
        with atomic_path(export) as temporary:
            temporary.write_text(session.exported(), encoding="utf-8")
        return {"command": "explore", "files": file_rows([export])}
    with progress.stage("first map of the shell"):
        session = Session(open_shell(design), spec)
    try:
        listening = socket.create_server((ADDRESS, port))
    except OSError as error:
        raise InputError(
            f"cannot listen on {ADDRESS}:{port} ({error.strerror}). Give another --page"
        ) from None
    progress.say(f"open http://{ADDRESS}:{listening.getsockname()[1]}/ in a browser; Ctrl-C ends")
    with ProcessPoolExecutor(1, get_context("spawn")) as checking:
        app = application(session, checking)
        web.run_app(app, sock=listening, print=None, access_log=None)
    return {"command": "explore", "files": []}


def requested_specification(request: Request, say: Callable[[str], None]) -> Path:
    """Return the specification of what is requested, placed by rules; one from before is taken again.

    Raises
    ------
    InputError
        As `new_specification`.
    """
    size = "x".join(f"{edge:g}" for edge in request.size_mm)
    name = f"{request.kind}_{size}"
    path = Path(f"{name}.toml")
    if path.is_file():
        say(f"{path} is there from before: it is opened again")
        return path
    if max(request.size_mm) > (longest := most_printed_mm()):
        say(
            f"moulds of bodies above {longest:g} mm are too long for the usual printer: printer.bed_mm"
        )
    return new_specification(name, Path(), request, lambda wanted: (place_parts(wanted), []))

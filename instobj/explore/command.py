"""`instobj explore`: a page on this machine on which a design is moved by hand, or a file to look at."""

from __future__ import annotations

import socket
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path
from typing import Any

from aiohttp import web

from design.errors import InputError
from design.files import atomic_path
from design.spec_io import load_spec
from instobj.explore.engine import open_explorer
from instobj.explore.server import ADDRESS, Session, application
from instobj.store.progress import ProgressLine
from instobj.store.publish import file_rows


def explore(spec: Path, port: int, export: Path | None, overrides: list[str]) -> dict[str, Any]:
    """Serve the page until it is stopped, or write it to a file.

    Raises
    ------
    InputError
        A specification that the quick model cannot judge, or a port that cannot be listened on.
    """
    progress = ProgressLine()
    design = load_spec(spec, overrides)
    progress.say(
        "mechanics of the shell without magnets: minutes the first time, seconds afterwards"
    )
    session = Session(open_explorer(design), spec)
    if export is not None:
        with atomic_path(export) as temporary:
            temporary.write_text(session.exported(), encoding="utf-8")
        return {"command": "explore", "files": file_rows([export])}
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

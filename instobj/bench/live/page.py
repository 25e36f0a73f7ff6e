"""The page's threads: one serves it, one reads contacts; the reader of the board waits for neither."""

from __future__ import annotations

import asyncio
import queue
import sys
import threading
import time
from collections.abc import Callable, Iterator
from concurrent.futures import Future
from contextlib import contextmanager, suppress
from dataclasses import dataclass

from aiohttp import web

from design.errors import InputError
from instobj.bench.live.server import Page, application
from instobj.bench.live.watch import Watch

_READ_EVERY_S = 1 / 60
"""Between two readings of the newest row; a screen shows no more."""
_SWITCH_S = 0.001
"""Between threads: Python's default, 5 ms, would delay frames while contacts are read."""
_CLOSING_S = 3.0
"""Time that the server gets to say goodbye to its viewers."""


@dataclass(frozen=True)
class PageSettings:
    """Settings of the page; `scene` is the archive of the object."""

    scene: bytes
    address: str
    port: int
    token: str

    def url(self, port: int) -> str:
        """Return where a browser of this machine finds the page."""
        host = "127.0.0.1" if self.address in ("localhost", "0.0.0.0", "::") else self.address  # noqa: S104
        host = f"[{host}]" if ":" in host else host
        return f"http://{host}:{port}/" + (f"?token={self.token}" if self.token else "")


@dataclass(frozen=True)
class ServedPage:
    """A page that is served: its address, its thread, and commands of its viewers."""

    url: str
    serving: threading.Thread
    commands_asked: queue.SimpleQueue[str]

    def commands(self) -> list[str]:
        """Return what viewers asked for since the last time."""
        return [self.commands_asked.get() for _ in range(self.commands_asked.qsize())]

    @property
    def alive(self) -> bool:
        """Return whether the page is still served."""
        return self.serving.is_alive()


@contextmanager
def serve_page(watch: Watch, settings: PageSettings) -> Iterator[ServedPage]:
    """Serve the page and read contacts, each in a thread, until the context ends.

    Raises
    ------
    InputError
        An address that cannot be listened on.
    """
    started: Future[tuple[asyncio.AbstractEventLoop, asyncio.Event, int]] = Future()
    commands_asked: queue.SimpleQueue[str] = queue.SimpleQueue()

    def run() -> None:
        try:
            asyncio.run(_serve(watch, settings, commands_asked, started))
        except OSError as error:
            where = f"{settings.address}:{settings.port}"
            started.set_exception(
                InputError(f"cannot listen on {where} ({error.strerror}). Give another --page")
            )

    serving = threading.Thread(target=run, daemon=True)
    switch_before_s = sys.getswitchinterval()
    sys.setswitchinterval(_SWITCH_S)
    try:
        serving.start()
        loop, ended, port = started.result()
        threading.Thread(target=read_frames, args=(watch,), daemon=True).start()
        yield ServedPage(settings.url(port), serving, commands_asked)
        call_within(loop, ended.set)
        serving.join(_CLOSING_S)
    finally:
        watch.end()
        sys.setswitchinterval(switch_before_s)


async def _serve(
    watch: Watch,
    settings: PageSettings,
    commands_asked: queue.SimpleQueue[str],
    started: Future[tuple[asyncio.AbstractEventLoop, asyncio.Event, int]],
) -> None:
    ended, loop = asyncio.Event(), asyncio.get_running_loop()

    def command(text: str) -> None:
        if text == "zero":
            watch.rezero()
        commands_asked.put(text)

    page = Page(watch, settings.scene, settings.address, settings.token, command)
    watch.on_reading = lambda: call_within(loop, page.wake)
    runner = web.AppRunner(application(page), access_log=None, shutdown_timeout=1.0)
    await runner.setup()
    await web.TCPSite(runner, settings.address, settings.port).start()
    started.set_result((loop, ended, runner.addresses[0][1]))
    await ended.wait()
    await runner.cleanup()


def call_within(loop: asyncio.AbstractEventLoop, act: Callable[[], None]) -> None:
    """From another thread; not once the loop has closed."""
    with suppress(RuntimeError):
        loop.call_soon_threadsafe(act)


def read_frames(watch: Watch) -> None:
    """Read contacts until the watch ends; whatever fails here, rows are recorded all the same."""
    try:
        while not watch.ended:
            begun_s = time.monotonic()
            watch.read_next()
            time.sleep(max(0.0, _READ_EVERY_S - (time.monotonic() - begun_s)))
    except Exception as error:  # of a model's runtime, of any kind
        watch.stop_reading(f"contacts are no longer read: {type(error).__name__}: {error}")

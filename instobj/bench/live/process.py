"""The page's own process: the reader of the board never waits for it, and outlives it."""

from __future__ import annotations

import asyncio
import queue
import signal
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from multiprocessing import get_context
from multiprocessing.connection import Connection
from multiprocessing.process import BaseProcess
from pathlib import Path

from design.errors import InputError, InstobjError
from design.imports import missing_extra
from design.spec.object import ObjectSpec
from estimator.deploy.zeroing import ZeroMode
from instobj.bench.live.contacts import frame_document, open_estimator
from instobj.bench.live.watch import Watch
from instobj.robot import foxglove_channels

_READY, _FAILED = b"R", b"E"
_MOST_WAITING = 2000
_PATIENCE_S = 120.0
_READ_EVERY_S = 1 / 60
"""Between two readings of the newest row; a screen shows no more."""
_SWITCH_S = 0.001
"""Between the page's threads: the default, 5 ms, would delay frames while contacts are read."""


@dataclass(frozen=True)
class PageSettings:
    """Settings of the page's process; `spec` is the specification as JSON, `scene` the archive."""

    spec: str
    scene: bytes
    models: tuple[Path, ...]
    zero: ZeroMode
    zero_frames: int
    address: str
    port: int
    token: str
    foxglove: Path | None = None

    def url(self, port: int) -> str:
        """Return where a browser of this machine finds the page, or what is written for Foxglove."""
        if self.foxglove is not None:
            return str(self.foxglove)
        host = "127.0.0.1" if self.address in ("localhost", "0.0.0.0", "::") else self.address  # noqa: S104
        host = f"[{host}]" if ":" in host else host
        return f"http://{host}:{port}/" + (f"?token={self.token}" if self.token else "")


@dataclass
class PageProcess:
    """The reader's end: messages out without ever waiting, commands of viewers in.

    Attributes
    ----------
    lost : messages that the page's process did not take
    """

    connection: Connection
    process: BaseProcess
    url: str
    lost: int = 0
    _waiting: queue.Queue[bytes | None] = field(default_factory=lambda: queue.Queue(_MOST_WAITING))

    def send(self, message: bytes) -> None:
        """Hand a message on; it is lost for the page, and counted, where too many wait."""
        try:
            self._waiting.put_nowait(message)
        except queue.Full:
            self.lost += 1

    def commands(self) -> list[str]:
        """Return what viewers asked for since the last time."""
        messages = []
        with suppress(EOFError, OSError):
            while self.connection.poll():
                messages.append(self.connection.recv_bytes().decode())
        return messages

    @property
    def alive(self) -> bool:
        """Return whether the page is still served."""
        return self.process.is_alive()

    def run_sender(self) -> None:
        """Write what waits, until the end or until nobody reads."""
        with suppress(OSError):
            while (message := self._waiting.get()) is not None:
                self.connection.send_bytes(message)

    def stop_sender(self) -> None:
        """Let the sender end once it has written what waits."""
        with suppress(queue.Full):
            self._waiting.put_nowait(None)


@contextmanager
def page_process(settings: PageSettings) -> Iterator[PageProcess]:
    """Start the page; ends it afterwards.

    Raises
    ------
    InputError
        A bad model, an address that cannot be listened on, or no answer.
    """
    context = get_context("spawn")
    pipe: tuple[Connection, Connection] = context.Pipe()  # pyright: ignore[reportAssignmentType]
    own_end, page_end = pipe
    process = context.Process(target=serve_page, args=(page_end, settings), daemon=True)
    process.start()
    page_end.close()
    try:
        page = PageProcess(own_end, process, settings.url(_port_of(own_end)))
        sender = threading.Thread(target=page.run_sender, daemon=True)
        sender.start()
        yield page
        page.stop_sender()
        sender.join(timeout=1.0)
    finally:
        own_end.close()
        process.join(timeout=3.0)
        process.kill()


def _port_of(connection: Connection) -> int:
    """The port that the page's process listens on, once it does."""
    try:
        answer = connection.recv_bytes() if connection.poll(_PATIENCE_S) else b""
    except EOFError:
        answer = b""
    if answer[:1] == _READY:
        return int(answer[1:])
    raise InputError(answer[1:].decode() or "the page's process did not start. Run it again")


def serve_page(connection: Connection, settings: PageSettings) -> None:
    """Run the page's process, until the reader's end closes."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    sys.setswitchinterval(_SWITCH_S)
    try:
        spec = ObjectSpec.model_validate_json(settings.spec)
        estimator = open_estimator(spec, settings.models, settings.zero, settings.zero_frames)
        watch = Watch(spec, estimator, 0 if settings.zero == "none" else settings.zero_frames)
        if settings.foxglove is not None:
            _show_in_foxglove(connection, settings.foxglove, watch)
            return
        asyncio.run(_serve(connection, settings, watch))
    except (InstobjError, OSError, ModuleNotFoundError) as error:
        missing = missing_extra(error) if isinstance(error, ModuleNotFoundError) else None
        with suppress(OSError):
            connection.send_bytes(_FAILED + (missing or str(error)).encode())


def _show_in_foxglove(connection: Connection, target: Path, watch: Watch) -> None:
    """Send contacts to Foxglove in place of the page, until the reader's end closes."""
    if watch.estimator is None:
        raise InputError(f"--page {target} shows contacts, which an estimator reads. Give --model")
    sent_s = 0.0
    with foxglove_channels(target, watch.spec) as send:

        def show() -> None:
            nonlocal sent_s
            reading = watch.reading
            if reading.arrived_s > sent_s:  # rows may come while there is no zero
                sent_s = reading.arrived_s
                send(frame_document(watch.spec, reading.read, reading.time_s))

        connection.send_bytes(_READY + b"0")
        receiving = threading.Thread(target=_receive, args=(connection, watch), daemon=True)
        receiving.start()
        watch.on_reading = show
        while receiving.is_alive():
            read_for_viewers(watch)


async def _serve(connection: Connection, settings: PageSettings, watch: Watch) -> None:
    from aiohttp import web

    from instobj.bench.live.server import Page, application

    ended, loop = asyncio.Event(), asyncio.get_running_loop()

    def command(text: str) -> None:
        if text == "zero":
            watch.rezero()
        with suppress(OSError):
            connection.send_bytes(text.encode())

    page = Page(watch, settings.scene, settings.address, settings.token, command)
    watch.on_reading = lambda: call_within(loop, page.wake)
    runner = web.AppRunner(application(page), access_log=None, shutdown_timeout=1.0)
    await runner.setup()
    try:
        await web.TCPSite(runner, settings.address, settings.port).start()
    except OSError as error:
        where = f"{settings.address}:{settings.port}"
        raise InputError(
            f"cannot listen on {where} ({error.strerror}). Give another --page"
        ) from None
    connection.send_bytes(_READY + str(runner.addresses[0][1]).encode())
    receiving = threading.Thread(target=_receive, args=(connection, watch), daemon=True)
    receiving.start()
    threading.Thread(target=read_frames, args=(watch,), daemon=True).start()
    threading.Thread(
        target=lambda: (receiving.join(), loop.call_soon_threadsafe(ended.set)), daemon=True
    ).start()
    await ended.wait()
    await runner.cleanup()


def call_within(loop: asyncio.AbstractEventLoop, act: Callable[[], None]) -> None:
    """From another thread; not once the loop has closed."""
    with suppress(RuntimeError):
        loop.call_soon_threadsafe(act)


def _receive(connection: Connection, watch: Watch) -> None:
    with suppress(EOFError, OSError):
        while True:
            watch.take(connection.recv_bytes())


def read_frames(watch: Watch) -> None:
    while True:
        read_for_viewers(watch)


def read_for_viewers(watch: Watch) -> None:
    """Read the next rows, as often as a screen shows them."""
    begun_s = time.monotonic()
    watch.read_next()
    if not watch.needs_every_frame:
        time.sleep(max(0.0, _READ_EVERY_S - (time.monotonic() - begun_s)))

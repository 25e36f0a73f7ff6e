"""The page's server: on this machine alone by default, one WebSocket per viewer."""

from __future__ import annotations

import asyncio
import hmac
from collections.abc import Awaitable, Callable
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from aiohttp import WSCloseCode, WSMsgType, web

from instobj.bench.live.protocol import Head, frames_message, state_message
from instobj.bench.live.watch import Reading, Row, Watch
from instobj.viewer.bundling import program
from instobj.viewer.served import page_headers, refusal

_ROOM = Path(__file__).parent
_LEAST_S, _IDLE_S = 0.01, 1 / 60
"""Between two messages to a viewer, and until it is asked again whether something is new."""
_STATE_S = 0.25
_UNANSWERED = 2
"""Messages of frames that a viewer may not yet have drawn; until it has, its rows wait."""
MOST_ROWS = 400
"""Rows that wait for a viewer; older ones are dropped for it, and counted."""
COMMANDS = ("zero", "record on", "record off")


@dataclass
class Page:
    """Content of the server, its viewers, and the receiver of their commands.

    Attributes
    ----------
    scene : archive of the object
    address : that the server listens on
    token : that every request must carry; empty on the loopback
    command : called with each of `COMMANDS` that a viewer gives
    """

    watch: Watch
    scene: bytes
    address: str
    token: str
    command: Callable[[str], None]
    viewers: set[web.WebSocketResponse] = field(default_factory=set)
    dropped_rows: int = 0
    waiting: set[asyncio.Event] = field(default_factory=set)

    def wake(self) -> None:
        """Tell every viewer that something is new; of the event loop's thread."""
        for event in self.waiting:
            event.set()


_PAGE = web.AppKey("page", Page)


def application(page: Page) -> web.Application:
    """The server's routes, behind its guard."""
    app = web.Application(middlewares=[_guard])
    app[_PAGE] = page
    app.add_routes(
        [
            web.get("/", _index),
            web.get("/program.js", _program),
            web.get("/scene", _scene),
            web.get("/stream", _stream),
        ]
    )
    app.on_shutdown.append(_close_viewers)
    return app


Handler = Callable[[web.Request], Awaitable[web.StreamResponse]]


@web.middleware
async def _guard(request: web.Request, handler: Handler) -> web.StreamResponse:
    """Refuse foreign names, pages of other origins, and requests without the token."""
    page = request.app[_PAGE]
    if refused := refusal(request.host, request.headers.get("Origin"), page.address):
        raise web.HTTPForbidden(text=refused)
    if not hmac.compare_digest(request.query.get("token", "").encode(), page.token.encode()):
        raise web.HTTPForbidden(text="the token is wrong: open the address that was printed\n")
    response = await handler(request)
    return response


async def _index(request: web.Request) -> web.Response:
    text = (_ROOM / "page.html").read_text(encoding="utf-8")
    source = f"/program.js?token={request.app[_PAGE].token}"
    text = text.replace("/program.js", source) if request.app[_PAGE].token else text
    return web.Response(text=text, content_type="text/html", headers=page_headers(request.host))


async def _program(_: web.Request) -> web.Response:
    return web.Response(text=program(), content_type="text/javascript")


async def _scene(request: web.Request) -> web.Response:
    return web.Response(body=request.app[_PAGE].scene, content_type="application/octet-stream")


async def _stream(request: web.Request) -> web.WebSocketResponse:
    """Frames and state to one viewer, until it leaves."""
    page, socket = request.app[_PAGE], web.WebSocketResponse(heartbeat=10.0, max_msg_size=64)
    await socket.prepare(request)
    page.viewers.add(socket)
    viewer = _Viewer(page, socket)
    page.waiting.add(viewer.fresh)
    sending = asyncio.create_task(viewer.send_all())
    try:
        async for message in socket:
            if message.type == WSMsgType.BINARY and len(message.data) == 4:
                viewer.answered = int.from_bytes(message.data, "little")
                viewer.fresh.set()
            elif message.type == WSMsgType.TEXT and message.data in COMMANDS:
                page.command(message.data)
    finally:
        sending.cancel()
        page.viewers.discard(socket)
        page.waiting.discard(viewer.fresh)
    return socket


@dataclass
class _Viewer:
    """One viewer: what it has been sent, and how far it has drawn; `fresh` where something is new."""

    page: Page
    socket: web.WebSocketResponse
    answered: int = 0
    sent: int = 0
    dropped: int = 0
    fresh: asyncio.Event = field(default_factory=asyncio.Event)

    def __post_init__(self) -> None:
        self._newest: Row | None = None
        self._last_reading: Reading | None = None
        rows, _ = self.page.watch.rows_after(0, 1)
        self._next = rows[-1].number if rows else 0

    async def send_all(self) -> None:
        """Messages as long as the viewer takes them; it never holds up anyone else."""
        loop, state_at = asyncio.get_running_loop(), 0.0
        try:
            while not self.socket.closed:
                with suppress(TimeoutError):
                    await asyncio.wait_for(self.fresh.wait(), _IDLE_S)
                self.fresh.clear()
                if loop.time() >= state_at:
                    state_at = loop.time() + _STATE_S
                    state = self.page.watch.state() | {"viewers": len(self.page.viewers)}
                    await self.socket.send_bytes(state_message(state))
                if self.sent - self.answered < _UNANSWERED:
                    await self._send_frames()
                await asyncio.sleep(_LEAST_S)
        except (ConnectionError, asyncio.CancelledError):
            return

    async def _send_frames(self) -> None:
        watch = self.page.watch
        reading, (rows, missed) = watch.reading, watch.rows_after(self._next, MOST_ROWS)
        self._newest = rows[-1] if rows else self._newest
        if self._newest is None or (not rows and reading is self._last_reading):
            return
        newest, self._last_reading = self._newest, reading
        self._next, self.sent = newest.number + 1, self.sent + 1
        self.dropped += missed
        self.page.dropped_rows += missed
        head = Head(self.sent, self.dropped, newest.arrived_s, reading.arrived_s, newest.time_s)
        columns = [np.append(row.time_s - newest.time_s, row.change) for row in rows]
        contacts = reading.read.contacts
        await self.socket.send_bytes(
            frames_message(
                head,
                np.reshape(columns, (len(rows), 1 + len(watch.names))),
                contacts,
                watch.labels,
            )
        )


async def _close_viewers(app: web.Application) -> None:
    for socket in set(app[_PAGE].viewers):
        await socket.close(code=WSCloseCode.GOING_AWAY, message=b"the server ends")

"""The page's server: whom it answers, what it streams, and that a slow viewer costs nobody else."""

import asyncio
from contextlib import asynccontextmanager

import numpy as np
import pytest
from aiohttp import ClientSession, WSServerHandshakeError, web

from design.spec.object import ObjectSpec
from estimator.calibration.resting import channel_names
from instobj.bench.live import server
from instobj.bench.live.contacts import Found
from instobj.bench.live.server import Page, application
from instobj.bench.live.watch import Reading, Watch
from instobj.viewer.served import is_loopback
from tests.support.live_frames import read_frames_message

SPEC = ObjectSpec(name="cube")
NAMES = channel_names(SPEC)


def page_of(token="", address="127.0.0.1"):
    watch = Watch(SPEC, None, 0)
    watch.take_header(NAMES)
    return Page(watch, b"the scene", address, token, [].append)


@asynccontextmanager
async def served(page):
    """Address of the page and a client."""
    runner = web.AppRunner(application(page), shutdown_timeout=0.1)
    await runner.setup()
    await web.TCPSite(runner, "127.0.0.1", 0).start()
    try:
        async with ClientSession() as client:
            yield f"http://127.0.0.1:{runner.addresses[0][1]}", client
    finally:
        await runner.cleanup()


def answers(page, *requests):
    """Status of each request, given as path and headers."""

    async def ask():
        async with served(page) as (url, client):
            found = []
            for path, headers in requests:
                async with client.get(url + path, headers=headers) as answer:
                    found.append(answer.status)
            return found

    return asyncio.run(ask())


def test_foreign_names_and_foreign_pages_are_refused():
    """A page of evil.example may point its name at this machine, or open our address from afar."""
    foreign = {"Host": "evil.example:8765"}
    assert answers(page_of(), ("/", {}), ("/scene", {}), ("/program.js", {})) == [200] * 3
    assert (
        answers(page_of(), *((path, foreign) for path in ("/", "/scene", "/stream"))) == [403] * 3
    )
    origins = [{"Origin": one} for one in ("http://evil.example", "null", "https://localhost")]
    assert answers(page_of(), *(("/stream", one) for one in origins)) == [403] * 3
    assert answers(page_of(), ("/", {"Host": "localhost"}), ("/", {"Host": "[::1]:8"})) == [200] * 2


@pytest.mark.parametrize(
    ("address", "host"),
    [("127.0.0.2", "127.0.0.2:8765"), ("127.9.9.9", "127.9.9.9"), ("::1", "[::1]:8")],
)
def test_the_loopback_address_that_is_printed_is_answered_and_no_other_name(address, host):
    page, foreign = (
        page_of("", address),
        ("127.0.0.3:8765", "evil.example:8765", "127.0.0.2.evil.example"),
    )
    assert answers(page, ("/", {"Host": host})) == [200]
    assert answers(page, *(("/", {"Host": name}) for name in foreign)) == [403] * 3


def test_other_addresses_need_the_token_for_everything():
    page = page_of("secret", "192.168.0.5")
    paths = ("/", "/program.js", "/scene", "/stream")
    assert answers(page, *((path, {}) for path in paths)) == [403] * 4
    assert answers(page, *((path + "?token=wrong", {}) for path in paths)) == [403] * 4
    assert answers(page, *((f"{path}?token=secret", {}) for path in paths[:3])) == [200] * 3


@pytest.mark.parametrize(
    ("address", "here"),
    [("127.0.0.1", True), ("::1", True), ("localhost", True), ("192.168.0.5", False), ("10.1.2.3", False),
     ("robot.example", False)],
)  # fmt: skip
def test_which_addresses_stay_on_this_machine(address, here):
    assert is_loopback(address) is here


def test_the_page_may_run_its_own_program_alone():
    async def ask():
        async with served(page_of()) as (url, client), client.get(url) as answer:
            return answer.headers["Content-Security-Policy"], await answer.text(), url

    policy, text, url = asyncio.run(ask())
    assert "default-src 'none'; script-src 'self';" in policy
    assert f"connect-src 'self' {url.replace('http', 'ws')};" in policy
    assert text.count("<script") == 1


async def adding(page, count, at_once=20):
    """Rows as a board sends them."""
    for number in range(count):
        page.watch.take_row(number / 200, number / 200, tuple(np.full(45, number)))
        if number % at_once == at_once - 1:
            await asyncio.sleep(0.005)


async def frames_of(socket, until, answer=True):
    """Numbers of the rows that a viewer gets, and rows dropped for it, until a row has come."""
    seen, dropped = [], 0
    async for message in socket:
        if message.data[:4] != b"IOF1":
            continue
        head, (rows, *_) = read_frames_message(message.data, 45)
        seen += rows[:, 1].astype(int).tolist()
        dropped = head.dropped_rows
        if answer:
            await socket.send_bytes(head.number.to_bytes(4, "little"))
        if seen[-1] >= until:
            return seen, dropped
    raise AssertionError("the stream ended")


def test_every_viewer_that_keeps_up_gets_every_row_in_order():
    async def watch_both():
        page = page_of()
        async with (
            served(page) as (url, client),
            client.ws_connect(url + "/stream") as a,
            client.ws_connect(url + "/stream") as b,
        ):
            return await asyncio.gather(frames_of(a, 599), frames_of(b, 599), adding(page, 600))

    first, second, _ = asyncio.run(watch_both())
    assert first == second == (list(range(600)), 0)


def test_a_viewer_that_stalls_costs_itself_rows_and_nobody_else(monkeypatch):
    monkeypatch.setattr(server, "MOST_ROWS", 100)

    async def watch_both():
        page = page_of()
        async with (
            served(page) as (url, client),
            client.ws_connect(url + "/stream") as a,
            client.ws_connect(url + "/stream") as b,
        ):
            quick, _ = await asyncio.gather(frames_of(a, 599), adding(page, 600))
            await asyncio.sleep(0.1)
            early = await unanswered(b)
            return quick, early, await frames_of(b, 599), page.dropped_rows

    quick, early, (late, dropped), dropped_in_all = asyncio.run(watch_both())
    assert quick == (list(range(600)), 0)
    assert len(early) == 2  # then the server waits for an answer
    assert late == list(range(500, 600))
    before = sum(len(rows) for _, (rows, *_) in early)
    assert dropped == dropped_in_all == 600 - len(late) - before


async def unanswered(socket):
    """Messages of frames that have come; the last is answered then."""
    found = []
    while True:
        try:
            message = await socket.receive(timeout=0.1)
        except TimeoutError:
            break
        if message.data[:4] == b"IOF1":
            found.append(read_frames_message(message.data, 45))
    await socket.send_bytes(found[-1][0].number.to_bytes(4, "little"))
    return found


def test_commands_of_viewers_are_handed_on_and_nothing_else():
    heard = []

    async def say():
        page = page_of()
        page.command = heard.append
        async with served(page) as (url, client), client.ws_connect(url + "/stream") as socket:
            for text in ("zero", "record on", "rm -rf /", "record off"):
                await socket.send_str(text)
            await asyncio.sleep(0.1)

    asyncio.run(say())
    assert heard == ["zero", "record on", "record off"]


def test_a_foreign_page_opens_no_stream():
    async def connect():
        async with served(page_of()) as (url, client):
            await client.ws_connect(url + "/stream", origin="http://evil.example")

    with pytest.raises(WSServerHandshakeError, match="403"):
        asyncio.run(connect())


def test_a_reading_that_comes_after_its_row_is_sent_without_waiting_for_the_next():
    async def watch():
        page = page_of()
        async with served(page) as (url, client), client.ws_connect(url + "/stream") as socket:
            await adding(page, 1)
            first = await next_frames(socket)
            page.watch.reading = Reading(Found(np.ones((1, 15)), True), 7.0)
            page.wake()
            return first, await asyncio.wait_for(next_frames(socket), 5.0)

    (_, (rows, none, _)), (head, (no_rows, contacts, _)) = asyncio.run(watch())
    assert (len(rows), len(none)) == (1, 0)
    assert (len(no_rows), len(contacts), head.read_s) == (0, 1, 7.0)


async def next_frames(socket):
    """The next message of frames, answered."""
    async for message in socket:
        if message.data[:4] == b"IOF1":
            head, parts = read_frames_message(message.data, 45)
            await socket.send_bytes(head.number.to_bytes(4, "little"))
            return head, parts
    raise AssertionError("the stream ended")

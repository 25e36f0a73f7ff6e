"""The page in a browser, fed with a contact that slides: its pictures leave the object as it is."""

import asyncio
import threading
import time
from contextlib import contextmanager
from io import BytesIO

import numpy as np
import pytest
import trimesh
from aiohttp import web
from PIL import Image

from design.spec.object import ObjectSpec
from estimator.calibration.resting import channel_names
from instobj.bench.live.contacts import Found, placed_contact
from instobj.bench.live.page import call_within, read_frames
from instobj.bench.live.scene import live_scene
from instobj.bench.live.server import Page, application
from instobj.bench.live.watch import Watch
from tests.support.browser import Browser, chromium

pytestmark = pytest.mark.skipif(chromium() is None, reason="no Chromium on this machine")
SPEC = ObjectSpec(name="cube")
NAMES = channel_names(SPEC)
CONTACT = (216, 27, 154)


class Sliding:
    """A contact of 6 N that slides over face 3, and one of 5 N on face 5, behind the object."""

    channels, presses = (), None

    def feed(self, raw_counts, time_s, left_out):
        places = ((3, 8 * np.sin(3 * time_s), 4.0), 6.0), ((5, 0.0, 0.0), 5.0)
        rows = [placed_contact(SPEC, at, (1.5, n, 0.3), np.zeros(2)) for at, n in places]
        return Found(np.array(rows), True)

    def pass_by(self, raw_counts, time_s, left_out):
        pass

    def rezero(self):
        pass


@contextmanager
def served(page):
    """The page's address; the server, its reading and a board at 200 Hz each have a thread."""
    loop, ready, ended = asyncio.new_event_loop(), threading.Event(), threading.Event()
    runner = web.AppRunner(application(page), shutdown_timeout=0.1)

    def serve():
        asyncio.set_event_loop(loop)
        loop.run_until_complete(runner.setup())
        loop.run_until_complete(web.TCPSite(runner, "127.0.0.1", 0).start())
        ready.set()
        loop.run_forever()
        loop.run_until_complete(runner.cleanup())
        loop.close()

    def board():
        page.watch.take_header(NAMES)
        while not ended.wait(0.005):
            now_s = time.time()
            page.watch.take_row(now_s, now_s, tuple(np.arange(45.0)))

    serving = threading.Thread(target=serve)
    for thread in (serving, threading.Thread(target=board)):
        thread.start()
    threading.Thread(target=read_frames, args=(page.watch,), daemon=True).start()
    assert ready.wait(10)
    page.watch.on_reading = lambda: call_within(loop, page.wake)
    yield f"http://127.0.0.1:{runner.addresses[0][1]}/"
    ended.set()
    loop.call_soon_threadsafe(loop.stop)
    serving.join()


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    folder = tmp_path_factory.mktemp("parts")
    edge = SPEC.body.size_mm[0]
    trimesh.creation.box([edge - 2 * SPEC.shell.thickness_mm] * 3).export(folder / "core.stl")
    trimesh.creation.box([edge] * 3).export(folder / "shell.stl")
    watch = Watch(SPEC, Sliding(), 0)
    shown = Page(watch, live_scene(SPEC, folder, "key"), "127.0.0.1", "", lambda _: None)
    with served(shown) as url, Browser(900, 600) as browser:
        browser.send("Page.navigate", url=url)
        browser.wait("window.instobjLive && instobjLive.contacts().length === 2")
        yield browser


def settled(page):
    """Pictures of the object so far, once no further one comes by itself."""
    drawn = -1
    while drawn != (drawn := page.ask("instobjLive.figures().objectDrawn")):
        time.sleep(0.6)
    return drawn


def marked(page):
    """Middle of what the window shows in the contacts' colour."""
    shown = np.asarray(Image.open(BytesIO(page.picture())).convert("RGB"), int)
    rows, columns = np.nonzero(abs(shown - CONTACT).max(axis=2) < 40)
    assert len(rows) > 40
    return np.array([columns.mean(), rows.mean()])


def test_contacts_move_while_the_object_is_drawn_once(page):
    drawn, shown = settled(page), page.ask("instobjLive.figures().shown")
    places = [marked(page)]
    until = time.monotonic() + 15  # thirty pictures come faster than contacts move
    while page.ask("instobjLive.figures().shown") < shown + 30 or (
        np.ptp(places, axis=0).max() <= 5 and time.monotonic() < until
    ):
        places.append(marked(page))
    assert np.ptp(places, axis=0).max() > 5
    assert page.ask("instobjLive.figures().objectDrawn") == drawn
    assert page.problems() == []


def test_a_turned_camera_draws_the_object_anew_and_hides_other_contacts(page):
    drawn = settled(page)
    assert page.ask("instobjLive.hidden()") == [False, True]
    page.ask("document.querySelector('canvas').focus()")
    for _ in range(12):
        page.press("ArrowLeft")
    assert settled(page) > drawn
    assert page.ask("instobjLive.hidden()") == [True, False]


def test_the_page_tells_how_many_pictures_and_how_old(page):
    figures = page.ask("instobjLive.figures()")
    assert figures["perSecond"] > 0
    assert 0 < figures["underwayMs"]["p50"] <= figures["latencyMs"]["p50"]
    told = page.ask("document.querySelector('[data-name=told]').textContent")
    assert "pictures/s" in told
    assert "ms old (99 %:" in told

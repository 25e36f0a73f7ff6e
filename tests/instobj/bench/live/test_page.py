"""`instobj bench live --demo` in a real browser: contacts on the body, recording, and what it asks for."""

import os
import re
import subprocess
import sys
import time
from io import BytesIO

import numpy as np
import pytest
from PIL import Image

from estimator.recordings.formats.files import read_table
from tests.support.browser import Browser, chromium

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(chromium() is None, reason="no Chromium on this machine"),
    pytest.mark.skipif(os.name != "posix", reason="needs signals"),
]
CONTACT = (216, 27, 154)
SMALL = (700, 600)
LATENCY_MS, PER_SECOND, MEASURED_S = 100.0, 30.0, 60.0


@pytest.fixture(scope="module")
def demo(tmp_path_factory):
    """A demo in a folder of its own, with its address; ended like a user ends it."""
    folder = tmp_path_factory.mktemp("demo")
    command = [sys.executable, "-m", "instobj", "bench", "live", "--demo", "--page", "0"]
    process = subprocess.Popen(command, cwd=folder, stderr=subprocess.PIPE, text=True)
    for line in process.stderr:
        if found := re.search(r"open (http://127\.0\.0\.1:\d+/)", line):
            break
    yield folder, found[1], process
    process.terminate()
    process.communicate(timeout=60)


@pytest.fixture(scope="module")
def page(demo):
    _, url, _ = demo
    with Browser(*SMALL) as browser:
        browser.send("Page.navigate", url=url)
        browser.wait('document.getElementById("instobj-live")?.dataset.ready === "yes"')
        browser.wait("instobjLive.figures().shown > 2")
        yield browser


def pixels(page):
    """How many pixels of the window have the colour of contacts."""
    shown = np.asarray(Image.open(BytesIO(page.picture())).convert("RGB"), int)
    return int((abs(shown - CONTACT).max(axis=2) < 40).sum())


def test_contacts_appear_on_the_body_and_in_the_table(page):
    page.wait("instobjLive.contacts().length > 0 && instobjLive.contacts()[0].force > 2")
    (found, rows) = page.ask(
        "[instobjLive.contacts(), document.querySelectorAll('[data-name=contacts] tr').length]"
    )
    assert rows == len(found)
    assert all(one["face"] in range(1, 6) and one["radius"] > 0 for one in found)
    for one in found:
        assert np.dot(one["normal"], one["pull"]) == pytest.approx(-one["force"], rel=1e-3)
        assert np.abs(one["point"]).max() == pytest.approx(21.0, abs=0.01)
    assert pixels(page) > 40


def test_every_channel_is_good_and_nothing_foreign_is_asked_for(page, demo):
    page.wait("instobjLive.state().health?.length === 45")
    assert not {1, 2, 3, 4, 5} & set(page.ask("instobjLive.state().health"))
    assert page.problems() == []
    assert all(one.startswith(demo[1]) for one in page.requests())


def test_for_a_minute_pictures_are_many_and_young_and_leave_the_object_alone(page):
    """30 pictures/s, and 99 of 100 at most 100 ms after the frame that their contacts were read from, by
    the page's own figures; where other programs keep the processors busy, ten times fewer and older."""
    page.wait("instobjLive.figures().rows > 2000")
    drawn = page.ask("instobjLive.figures().objectDrawn")
    page.ask("instobjLive.forget()")
    time.sleep(MEASURED_S)
    figures = page.ask("instobjLive.figures()")
    free = os.getloadavg()[0] < os.cpu_count() + 1
    assert figures["objectDrawn"] == drawn
    assert figures["shown"] >= PER_SECOND * MEASURED_S / (1 if free else 10)
    assert figures["latencyMs"]["p99"] <= LATENCY_MS * (1 if free else 10)


def test_forces_read_are_those_of_the_simulated_hand(page):
    """Seen in the strips' numbers over a whole cycle: contacts found against crosses told."""
    told, found = 0, 0
    for _ in range(100):
        forces, labels = page.ask(
            "[instobjLive.contacts().map((c) => c.force), instobjLive.labels().map((l) => l.force)]"
        )
        told, found = told + sum(labels), found + sum(forces)
        time.sleep(0.25)
    assert found == pytest.approx(told, rel=0.15)


def test_recording_from_the_page_outlives_it(page, demo):
    folder, _, process = demo
    page.ask("document.querySelector('[data-name=record]').click()")
    page.wait("instobjLive.state().recording.on && instobjLive.state().recording.rows > 100")
    shown = page.ask("instobjLive.state().recording.rows")
    page.send("Page.navigate", url="about:blank")
    process.terminate()
    process.communicate(timeout=60)
    table = read_table(folder / "demo_live.nc")
    assert len(table.counts) >= shown
    assert table.counts.shape[1:] == (5, 3, 3)

"""`instobj bench live`: sources, recording, and what a page may cost."""

import os
import re
import signal
import socket
import threading
import time
import urllib.request
from contextlib import closing
from dataclasses import replace

import numpy as np
import pytest

from design.errors import InputError, StoreError
from design.spec.object import ObjectSpec
from estimator.recordings.boards import link
from estimator.recordings.boards.lines import (
    Frame,
    Header,
    LineDecoder,
    Load,
    checksum,
    encode_frame,
    encode_header,
    encode_load,
)
from estimator.recordings.boards.link import replay_chunks, serial_chunks
from estimator.recordings.formats.files import read_table
from instobj.bench.collect.options import CollectOptions
from instobj.bench.live.command import live, run_live
from instobj.bench.live.contacts import open_estimator
from instobj.bench.live.page import PageSettings, serve_page
from instobj.bench.live.source import LiveOptions, LiveSource, data_set_table
from instobj.bench.live.watch import Watch
from instobj.commands.readings import Zeroing
from instobj.store.progress import ProgressLine
from tests.support.mechanics.inverted import labelled_frames
from tests.support.recordings.dummy_board import dummy_board

pytestmark = pytest.mark.skipif(os.name != "posix", reason="needs pseudo-terminals")
SPEC = ObjectSpec(name="cube")
UPGRADE = (
    "GET /stream HTTP/1.1\r\nHost: 127.0.0.1:{}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
    "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n\r\n"
)
"""Request of a viewer (RFC 6455)."""


def source_of(port, out):
    readings = CollectOptions(out, port, cells=1, tips=1, zero_frames=5)
    zeroing = Zeroing("first", 5)
    return LiveSource(SPEC, b"scene", port, serial_chunks(port), readings, None, zeroing)


def numbered(k):
    """Lines of a frame that tells its number."""
    load = encode_load(Load(10 * k, 1, k / 1000, None, ()))
    return load + encode_frame(k, 10 * k, [float(k), 0.0, 0.0, 0.0, 0.0, -float(k)])


def test_viewers_cost_no_row_of_the_recording(tmp_path):
    """Viewers come, read nothing and are cut off: rows go on as a board sent them."""
    csv, found = tmp_path / "cube.csv", []
    with socket.create_server(("127.0.0.1", 0)) as free:
        page_port = free.getsockname()[1]

    def rows_in(least):
        """Wait for so many rows; how many there are."""
        until = time.monotonic() + 30
        while (rows := csv.read_bytes().count(b"\n") - 1 if csv.exists() else 0) < least:
            assert time.monotonic() < until, rows
            time.sleep(0.02)
        return rows

    def watch_and_leave():
        try:
            rows = rows_in(30)
            url = f"http://127.0.0.1:{page_port}/scene"
            found.append(urllib.request.urlopen(url, timeout=30).read())
            for _ in range(5):
                with socket.create_connection(("127.0.0.1", page_port)) as viewer:
                    viewer.sendall(UPGRADE.format(page_port).encode())
                    found.append(viewer.recv(12))
                    rows = rows_in(rows + 10)
            found.append(rows_in(rows + 30))
        finally:
            os.kill(os.getpid(), signal.SIGINT)

    watching = threading.Thread(target=watch_and_leave)
    with dummy_board(numbered) as port:
        source = source_of(port, tmp_path / "cube")
        options = LiveOptions(None, source.readings, record=True, page_port=page_port)
        watching.start()
        told = run_live(source, options, "", ProgressLine())
        watching.join()
    scene, *upgraded, rows = found
    assert (scene, upgraded) == (b"scene", [b"HTTP/1.1 101"] * 5)
    table = read_table(tmp_path / "cube.nc")
    assert told["frames_added"] == len(table.counts) >= rows
    numbers = table.counts[:, 0, 0, 0]
    np.testing.assert_array_equal(table.counts[:, 2, 0, 2], -numbers)
    np.testing.assert_allclose(table.force_n[:, 0], numbers / 1000)
    assert np.all(np.diff(numbers) > 0)
    assert numbers[-1] - numbers[0] + 1 == len(numbers) + told["lost_frames"]


def test_the_battery_of_a_wireless_object_is_said(tmp_path):
    body = b"S,20,3840,0,0,0,power,24.0,25.0"
    said = b"$" + body + f"*{checksum(body)}\n".encode()
    with dummy_board(lambda k: numbered(k) + said) as port:
        source = source_of(port, tmp_path / "cube")
        options = LiveOptions(None, source.readings, page_port=0, seconds=2.0)
        done = run_live(source, options, "", ProgressLine())
    assert any("battery 3.84 V, about 50 %" in text for text in done["texts"])


class Failing:
    """An estimator whose runtime fails."""

    channels, presses = (), None

    def feed(self, raw_counts, time_s, left_out):
        raise RuntimeError("no kernel image")


def test_a_runtime_that_fails_ends_the_reading_of_contacts_alone():
    watch = Watch(SPEC, Failing(), 0)
    watch.take_header(["F1-X1"])
    with serve_page(watch, PageSettings(b"scene", "127.0.0.1", 0, "")) as page:
        watch.take_row(1.0, 1.0, (5.0,))
        until = time.monotonic() + 10
        while not watch.state()["trouble"] and time.monotonic() < until:
            time.sleep(0.01)
        assert (
            watch.state()["trouble"] == "contacts are no longer read: RuntimeError: no kernel image"
        )
        watch.take_row(2.0, 2.0, (6.0,))
        assert len(watch.rows_after(0, 10)[0]) == 2
        assert urllib.request.urlopen(page.url + "scene", timeout=30).read() == b"scene"  # noqa: S310
        assert page.alive
    assert not page.alive


def test_an_address_in_use_is_told():
    with socket.create_server(("127.0.0.1", 0)) as taken:
        settings = PageSettings(b"", "127.0.0.1", taken.getsockname()[1], "")
        with (
            pytest.raises(InputError, match=r"cannot listen on 127\.0\.0\.1.* --page"),
            serve_page(Watch(SPEC, None, 0), settings),
        ):
            pass


def messages_of(chunks, count):
    """The first messages of a source."""
    decoder, found = LineDecoder(), []
    with closing(chunks):
        for chunk in chunks:
            found += decoder.feed(chunk)
            if len(found) >= count:
                return found[:count], decoder.statistics
    return found, decoder.statistics


def test_pauses_of_a_recording_are_shortened_in_a_replay(monkeypatch):
    """A rig is moved for minutes between presses; times in the lines stay what they were."""
    monkeypatch.setattr(link, "LONGEST_PAUSE_S", 0.2)
    frames = labelled_frames(
        np.zeros((4, 1), int), np.full((4, 1, 2), np.nan), np.full((4, 1), np.nan)
    )
    table = replace(data_set_table(frames), time_s=np.array([0.0, 0.1, 90.0, 90.1]))
    began_s = time.monotonic()
    found, _ = messages_of(replay_chunks(table, 1.0), 100)
    assert 0.35 < time.monotonic() - began_s < 20.0
    assert [one.board_ms for one in found if isinstance(one, Frame)] == [0, 100, 90_000, 90_100]


def test_a_data_set_is_replayed_with_its_labels():
    face, xy = np.array([[0, 0], [2, 0], [2, 4]]), np.full((3, 2, 2), np.nan)
    xy[1, 0], xy[2] = [1.0, -2.0], [[1.0, -2.0], [3.0, 4.0]]
    force = np.where(face > 0, [[0, 0], [5.0, 0], [6.0, 7.0]], np.nan)
    counts = np.random.default_rng(1).normal(0, 300, (3, 5, 3, 3)).round(2)
    frames = replace(labelled_frames(face, xy, force), signal_counts=counts)
    found, statistics = messages_of(replay_chunks(data_set_table(frames), 0.0), 10)
    assert statistics.damaged_lines == 0
    assert [len(one.channels) for one in found if isinstance(one, Header)] == [45]
    read = [one.counts for one in found if isinstance(one, Frame)]
    np.testing.assert_allclose(read, counts.reshape(3, 45))
    loads = [(one.face, one.force_n, one.tips_mm) for one in found if isinstance(one, Load)]
    assert [force for _, force, _ in loads] == [0.0, 0.0, 5.0, 0.0, 6.0, 7.0]
    assert loads[4:] == [(2, 6.0, ((1.0, -2.0),)), (4, 7.0, ((3.0, 4.0),))]


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({}, "give one of --port, --replay and --demo.* got 0"),
        ({"port": "/dev/nothing", "demo": True}, "got 2"),
        ({"port": "/dev/nothing"}, "give the specification"),
    ],
)
def test_what_cannot_be_shown(tmp_path, given, words):
    of_readings = {"port": given.pop("port", None)}
    with pytest.raises(InputError, match=words):
        live(LiveOptions(None, CollectOptions(tmp_path / "x", **of_readings), **given))


def test_a_model_that_is_not_there_is_told_before_anything_is_opened_or_built(tmp_path):
    (tmp_path / "cube.toml").write_text('name = "cube"\n', encoding="utf-8")
    readings = CollectOptions(tmp_path / "x", port="/dev/nothing")
    missing = tmp_path / "nope.nc"
    with pytest.raises(InputError, match=r"no model at .*nope\.nc"):
        live(LiveOptions(tmp_path / "cube.toml", readings, model=missing))


@pytest.mark.parametrize("wrong", ["port", "load_port"])
def test_a_port_that_cannot_be_opened_is_told_before_solids_are_built(tmp_path, monkeypatch, wrong):
    monkeypatch.setenv("INSTOBJ_STORE", str(tmp_path / "store"))
    given = {"port": str(tmp_path / "none")} if wrong == "port" else {
        "replay": tmp_path / "none.csv", "load_port": str(tmp_path / "none")
    }  # fmt: skip
    (tmp_path / "cube.toml").write_text('name = "cube"\n', encoding="utf-8")
    options = LiveOptions(tmp_path / "cube.toml", CollectOptions(tmp_path / "out", **given))
    with pytest.raises(InputError, match="cannot open"):
        live(options)
    assert not (tmp_path / "store").exists()


def test_only_other_addresses_have_a_token(tmp_path):
    readings = CollectOptions(tmp_path / "x")
    assert LiveOptions(None, readings).token == ""
    far = LiveOptions(None, readings, address="192.168.0.5")
    assert len(far.token) >= 20
    assert far.token != far.token


def test_a_file_that_is_no_estimator_is_told(tmp_path):
    network = tmp_path / "face_1.onnx"
    network.write_bytes(b"network")
    with pytest.raises((InputError, StoreError), match="face_1"):
        open_estimator(SPEC, network, "rest", 8)
    assert open_estimator(SPEC, None, "rest", 8) is None


def test_another_objects_board_is_refused(tmp_path):
    with dummy_board(channels=("F1-X9", "F1-Y1", "F1-Z1", "F3-X1", "F3-Y1", "F3-Z1")) as port:
        source = source_of(port, tmp_path / "x")
        with pytest.raises(InputError, match="names channels that cube has not: F1-X9"):
            run_live(source, LiveOptions(None, source.readings, page_port=0), "", ProgressLine())


def test_the_last_line_tells_the_rate_at_which_frames_came(tmp_path):
    """They end a second before the page does."""

    def chunks():
        began_s = time.monotonic()
        yield encode_header(["F1-X1", "F1-Y1", "F1-Z1", "F3-X1", "F3-Y1", "F3-Z1"])
        for k in range(300):
            while time.monotonic() - began_s < k / 200:
                time.sleep(0.001)
            yield numbered(k)

    source = replace(source_of("board", tmp_path / "cube"), chunks=chunks())
    options = LiveOptions(None, source.readings, page_port=0, seconds=3.0)
    told = run_live(source, options, "", ProgressLine())
    assert told["frames"] == 300
    rate = int(re.search(r"frames at (\d+)/s", told["texts"][0])[1])
    assert 180 <= rate <= 210

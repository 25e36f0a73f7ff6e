"""`instobj bench collect`: a dummy board on a pseudo-terminal, replays, interruptions and damage."""

import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import numpy as np
import pytest

from design.errors import InputError
from estimator.recordings.boards.lines import Load, encode_frame, encode_header, encode_load
from estimator.recordings.formats.files import read_table
from instobj.bench.collect.command import collect
from instobj.bench.collect.options import CollectOptions
from tests.support.cli import assert_one_clear_error, run
from tests.support.recordings.dummy_board import (
    CHANNELS,
    board_lines,
    counts_at,
    dummy_board,
    force_at,
)

pytestmark = pytest.mark.skipif(os.name != "posix", reason="needs pseudo-terminals")


@pytest.fixture
def collected(tmp_path, monkeypatch):
    """Collect into cube.csv within this process; `typed` arrives on standard input."""

    def run_here(typed="", **options):
        read, write = os.pipe()
        os.write(write, typed.encode())
        os.close(write)
        with os.fdopen(read) as stdin:
            monkeypatch.setattr(sys, "stdin", stdin)
            return collect(CollectOptions(tmp_path / "cube", **options))

    return run_here


def started(tmp_path, port, *arguments):
    """A collection running beside the test, once it has written its first rows."""
    process = subprocess.Popen(
        [sys.executable, "-m", "instobj", "bench", "collect", "cube", "--port", port, *arguments],
        cwd=tmp_path,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    before = rows_of(tmp_path)
    until = time.monotonic() + 30
    while rows_of(tmp_path) < before + 20 and time.monotonic() < until:
        time.sleep(0.05)
    assert process.poll() is None, process.stderr and process.stderr.read()
    return process


def rows_of(tmp_path):
    path = tmp_path / "cube.csv"
    return path.read_bytes().count(b"\n") - 1 if path.exists() else 0


def test_frames_labels_and_zero_from_a_port(tmp_path, collected):
    with dummy_board() as port:
        found = collected(port=port, frames=150, zero_frames=10)
    assert (found["frames_added"], found["frames"], found["damaged_lines"]) == (150, 150, 0)
    assert found["lost_frames"] == 0
    assert found["rate_hz"] == pytest.approx(100, rel=0.05)
    table = read_table(tmp_path / "cube.nc")
    start = int(np.argmin([np.abs(first_counts(table) - counts_at(k)).sum() for k in range(400)]))
    expected = np.array([counts_at(start + k) for k in range(150)])
    np.testing.assert_array_equal(table.counts[:, [0, 2], 0].reshape(150, 6), expected)
    forces = np.array([force_at(start + k) for k in range(150)])
    np.testing.assert_allclose(table.force_n[:, 0], forces, atol=1e-4)
    assert table.declared_rest.tolist() == [True] * 10 + [False] * 140
    assert np.all(table.face[10:] == 3)
    np.testing.assert_allclose(table.tip_xy_mm[10:, 0, 0], np.tile([1.5, -4.5], (140, 1)))
    np.testing.assert_allclose(np.diff(table.time_s), 0.01, atol=1e-5)
    assert abs(table.time_s[0] - time.time()) < 60


def first_counts(table):
    return table.counts[0, [0, 2], 0].ravel()


def test_damage_and_loss_are_counted_and_nothing_false_is_kept(tmp_path, collected):
    def damaged(k):
        line = board_lines(k)
        if k % 20 == 7:
            return b""
        return b"\x00\xfe$F,garbage\n" + line if k % 20 == 13 else line

    with dummy_board(damaged) as port:
        found = collected(port=port, frames=100, zero_frames=0)
    assert 4 <= found["lost_frames"] <= 6
    assert 4 <= found["damaged_lines"] <= 7
    table = read_table(tmp_path / "cube.csv")
    sent = {tuple(counts_at(k)) for k in range(600)}
    assert {tuple(row) for row in table.counts[:, [0, 2], 0].reshape(-1, 6)} <= sent


def test_the_place_from_the_command_line_and_typed(tmp_path, collected):
    def unplaced(k):
        return board_lines(k, place=None)

    with dummy_board(unplaced) as port:
        options = {"port": port, "zero_frames": 0, "frames": 40}
        collected(**options, places=("3:0,7.5:0,-7.5",))
        collected(**options, places=("-:-",), typed="nonsense\n1:-3,6\n")
    table = read_table(tmp_path / "cube.nc")
    assert table.tip_xy_mm[0, 0].tolist() == [[0, 7.5], [0, -7.5]]
    assert (table.face[0, 0], table.face[-1, 0]) == (3, 1)
    np.testing.assert_array_equal(table.tip_xy_mm[-1, 0], [[-3, 6], [np.nan, np.nan]])
    assert table.case.tolist() == [1] * 80


def test_weights_are_labelled_only_once_the_user_says_so(tmp_path):
    def bare(k):
        return board_lines(k, loads=False)

    with dummy_board(bare) as port:
        command = [sys.executable, "-m", "instobj", "bench", "collect", "cube", "--port", port]
        command += ["--place", "3:0,0=9.81", "--zero", "15", "--stop", "40"]
        process = subprocess.Popen(command, cwd=tmp_path, stdin=subprocess.PIPE, text=True)
        while rows_of(tmp_path) < 15:
            time.sleep(0.05)
        time.sleep(0.3)
        assert rows_of(tmp_path) == 15
        process.communicate("\n", timeout=30)
    table = read_table(tmp_path / "cube.nc")
    assert table.force_n[:, 0].tolist() == [0.0] * 15 + [9.81] * 25


def test_travel_is_the_label_where_no_load_cell_is(tmp_path):
    """After the baseline frames wait for the tip; levels are typed, as a script beside a machine does."""

    def bare(k):
        return board_lines(k, loads=False)

    def rows_are(count):
        while rows_of(tmp_path) < count:
            time.sleep(0.02)

    with dummy_board(bare) as port:
        command = [sys.executable, "-m", "instobj", "bench", "collect", "cube", "--port", port]
        command += ["--place", "-=0mm", "--zero", "15"]
        process = subprocess.Popen(
            command, cwd=tmp_path, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        )
        assert process.stdin is not None
        rows_are(15)
        time.sleep(0.3)
        assert rows_of(tmp_path) == 15
        for typed in ("3:1.5,-4.5=1mm", "3:1.5,-4.5=2.5mm", "-"):
            process.stdin.write(f"{typed}\n")
            process.stdin.flush()
            rows_are(rows_of(tmp_path) + 30)
        said, _ = process.communicate("q\n", timeout=30)
    assert "--spec SPEC" in said
    table = read_table(tmp_path / "cube.nc")
    assert table.labelled_by_travel
    assert table.travel_mm is not None
    order = [float(t) for t in table.travel_mm[np.isfinite(table.travel_mm)]]
    assert order == sorted(order)
    assert set(order) == {1.0, 2.5}
    pressed = table.face[:, 0] == 3
    np.testing.assert_array_equal(pressed, np.isfinite(table.travel_mm))
    np.testing.assert_array_equal(table.tip_xy_mm[pressed][:, 0, 0], [[1.5, -4.5]] * pressed.sum())
    assert not pressed[-20:].any()
    assert table.declared_rest.sum() == 15


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--place", "3:0,0=2mm", "--place", "5:0,0"], "one --place of one tip"),
        (["--place", "3:0,0:1,1=2mm"], "one --place of one tip"),
        (["--place", "3:0,0=2mm", "--load-port", "nowhere"], "no --load-port"),
        (["--place", "3:0,0=2cm"], "or a travel, 3:0,0=2mm"),
    ],
)
def test_travel_beside_another_label_is_refused(tmp_path, words, message):
    done = run("bench", "collect", "cube", "--port", "nowhere", *words, cwd=tmp_path)
    assert_one_clear_error(done, message)


@pytest.mark.parametrize("ends", ["load lines", "frames"])
def test_seconds_end_where_load_lines_or_frames_have_ended(tmp_path, collected, ends):
    def silent(k):
        if k < 60:
            return board_lines(k)
        return (
            board_lines(k, loads=False)
            if ends == "load lines"
            else encode_load(Load(10 * k, 1, 0.0, None, ()))
        )

    with dummy_board(silent) as port:
        began_s = time.monotonic()
        found = collected(port=port, seconds=3.0, zero_frames=0)
    assert time.monotonic() - began_s < 5.0
    assert 40 <= found["frames_added"] <= 170
    assert ends == "frames" or found["frames_without_force"] > 50


@pytest.mark.parametrize(
    ("clock_ms", "words"),
    [
        (lambda k: 10 * k, ""),
        (lambda k: 10_000 * k, "does it send microseconds"),
        (lambda k: 10 * k + 1_728_000_000 * (k > 50), "did its clock jump"),
        (lambda k: k // 10, ""),
    ],
)
def test_a_clock_that_is_wrong_is_told(tmp_path, collected, clock_ms, words):
    """A right one; microseconds sent as milliseconds; 20 days ahead; one that crawls, too little to tell."""

    def lines(k):
        ms = clock_ms(k)
        return encode_load(Load(ms, 1, 0.0, None, ())) + encode_frame(k, ms, counts_at(k))

    with dummy_board(lines) as port:
        began_s = time.monotonic()
        try:
            told = " ".join(collected(port=port, seconds=1.5, zero_frames=0)["texts"])
        except InputError as error:  # times that no recording can have
            told = str(error)
    assert time.monotonic() - began_s < 4.0
    assert rows_of(tmp_path) > 80
    assert ("times of the recording are wrong" in told) == bool(words)
    assert words in told


def test_a_load_cell_on_a_port_of_its_own(tmp_path, collected):
    def loads(k):
        return encode_load(Load(10 * k + 77777, 1, 4.5, 5, ((3.0, 0.0),)))

    def bare(k):
        return board_lines(k, loads=False)

    with dummy_board(bare) as port, dummy_board(loads, header=False) as cell:
        collected(port=port, load_port=cell, frames=50, zero_frames=0)
    table = read_table(tmp_path / "cube.nc")
    assert set(table.force_n[:, 0]) == {4.5}
    assert set(table.face[:, 0]) == {5}


def test_ctrl_c_ends_in_order(tmp_path):
    with dummy_board() as port:
        process = started(tmp_path, port)
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=30)
    assert process.returncode == 0, err
    assert "Traceback" not in out + err
    assert len(read_table(tmp_path / "cube.nc").force_n) == rows_of(tmp_path)


def test_kill_loses_nothing_and_the_same_command_goes_on(tmp_path, collected):
    with dummy_board() as port:
        process = started(tmp_path, port)
        process.kill()
        process.communicate(timeout=30)
        kept = rows_of(tmp_path)
        assert kept >= 20
        assert not (tmp_path / "cube.nc").exists()
        with (tmp_path / "cube.csv").open("a") as file:
            file.write("1795283334.64,1,0,12")
        found = collected(port=port, frames=30)
    assert (found["frames_added"], found["frames"]) == (30, kept + 30)
    assert "unfinished last line of 20 bytes" in " ".join(found["texts"])
    assert sorted(path.name for path in tmp_path.iterdir()) == ["cube.csv", "cube.nc"]


def test_a_board_that_is_unplugged_keeps_what_came(tmp_path):
    master, slave = os.openpty()
    command = [
        sys.executable,
        "-m",
        "instobj",
        "bench",
        "collect",
        "cube",
        "--port",
        os.ttyname(slave),
    ]
    process = subprocess.Popen(command, cwd=tmp_path, stdin=subprocess.DEVNULL,
                               stderr=subprocess.PIPE, stdout=subprocess.PIPE, text=True)  # fmt: skip
    os.read(master, 10)
    os.write(master, encode_header(CHANNELS))
    for k in range(30):
        os.write(master, board_lines(k))
    while rows_of(tmp_path) < 30:
        time.sleep(0.05)
    os.close(slave)
    os.close(master)
    _, err = process.communicate(timeout=30)
    assert process.returncode == 2
    assert "Traceback" not in err
    assert "30 frames kept" in " ".join(err.split())
    assert len(read_table(tmp_path / "cube.nc").force_n) == 30


def test_a_replay_is_the_recording_again(tmp_path, collected):
    with dummy_board() as port:
        collected(port=port, frames=120, zero_frames=10)
    (tmp_path / "cube.csv").rename(tmp_path / "first.csv")
    (tmp_path / "cube.nc").unlink()
    began = time.monotonic()
    collected(replay=tmp_path / "first.csv", zero_frames=0)
    assert time.monotonic() - began >= 1.19
    first, again = read_table(tmp_path / "first.csv"), read_table(tmp_path / "cube.nc")
    np.testing.assert_array_equal(first.counts[:, [0, 2], :1], again.counts[:, [0, 2], :1])
    np.testing.assert_allclose(first.force_n, again.force_n, atol=1e-4)
    np.testing.assert_array_equal(first.tip_xy_mm[10:], again.tip_xy_mm[10:])
    assert np.isnan(again.tip_xy_mm[:10]).all()
    np.testing.assert_allclose(np.diff(first.time_s), np.diff(again.time_s), atol=2e-3)


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({}, "--port or --replay"),
        ({"port": "/dev/none"}, "cannot open /dev/none.*Ports found"),
        ({"replay": Path("none.csv")}, "no recording at"),
        ({"port": "x", "places": ("7:0,0",)}, "'7:0,0' is not a contact location"),
        ({"port": "x", "places": ("3:0,0=heavy",)}, "'heavy' is no force in N"),
    ],
)
def test_what_cannot_be_collected(collected, options, words):
    with pytest.raises(InputError, match=words):
        collected(**options)


def test_a_replay_of_presses_labelled_by_travel_has_no_damaged_line(tmp_path, collected):
    rows = ["time_s,F1-X1,F1-Y1,F1-Z1,cell1_face,cell1_x1_mm,cell1_y1_mm,travel_mm"]
    rows += [f"{k / 10},{k % 7},{k % 5},{k},1,0,0,{k / 20}" for k in range(40)]
    (tmp_path / "travel.csv").write_text("\n".join(rows) + "\n")
    document = collected(
        replay=tmp_path / "travel.csv", speed=0.0, zero_frames=5, places=("1:0,0=1mm",)
    )
    assert (document["damaged_lines"], document["frames_added"]) == (0, 5)


def test_a_recording_is_not_replayed_into_itself(tmp_path, collected):
    (tmp_path / "cube.csv").write_text("time_s\n")
    with pytest.raises(InputError, match="itself"):
        collected(replay=tmp_path / "cube.csv")


def test_another_board_does_not_append_to_the_file(tmp_path):
    """Through the command, which ends with one error."""
    (tmp_path / "cube.csv").write_text("time_s,session,rest,F1-X1,cell1_force_n,cell1_face\n")
    with dummy_board() as port:
        done = run("bench", "collect", "cube", "--port", port, cwd=tmp_path)
    assert_one_clear_error(done, "other columns")


def test_a_board_without_force_is_told_so(tmp_path):
    def bare(k):
        return board_lines(k, loads=False)

    asked = threading.Event()
    with dummy_board(bare, asked=asked) as port:
        process = subprocess.Popen(
            [sys.executable, "-m", "instobj", "bench", "collect", "cube", "--port", port, "--zero", "0"],
            cwd=tmp_path, stdin=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
        )  # fmt: skip
        assert asked.wait(60)
        time.sleep(1)
        process.send_signal(signal.SIGINT)
        _, err = process.communicate(timeout=30)
    assert process.returncode == 2
    assert "no labelled frame came" in err

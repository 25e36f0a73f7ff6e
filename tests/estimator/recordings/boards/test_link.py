"""Replays of recordings, the patience with a silent board, and the clock of a board."""

from dataclasses import replace

import numpy as np
import pytest

from design.errors import InputError
from estimator.recordings.boards import link
from estimator.recordings.boards.lines import Frame, Header, LineDecoder, Load, encode_header
from tests.support.recordings.judged_cases import raw_table

FRAMES = 4


def recording():
    counts = np.full((FRAMES, 5, 2, 3), np.nan)
    counts[:, 0, 1, 2] = [1, 2, 3, 4]
    counts[:, 3, 0, 0] = [5, np.nan, 7, 8]
    tips = np.full((FRAMES, 2, 1, 2), np.nan)
    tips[:3, 1, 0] = [1.5, -2.0]
    return raw_table(
        FRAMES,
        cells=2,
        time_s=np.array([100.0, 100.1, 107.0, 107.1]),
        force_n=np.array([[0.5, 1.0]] * FRAMES),
        counts=counts,
        face=np.where(np.isnan(tips[:, :, 0, 0]), 0, 4),
        tip_xy_mm=tips,
        declared_rest=np.array([False, True, False, False]),
    )


def test_a_replay_sends_the_live_channels_the_loads_and_the_frames_in_order():
    decoder = LineDecoder()
    found = [m for chunk in link.replay_chunks(recording(), 0.0) for m in decoder.feed(chunk)]
    assert found[0] == Header(("F1-Z2", "F4-X1"))
    frames = [one for one in found if isinstance(one, Frame)]
    assert [(one.sequence, one.board_ms, one.counts[0]) for one in frames] == [
        (0, 0, 1.0),
        (1, 100, 2.0),
        (2, 7000, 3.0),
        (3, 7100, 4.0),
    ]
    assert [frames[k].counts[1] for k in (0, 2, 3)] == [5.0, 7.0, 8.0]
    assert np.isnan(frames[1].counts[1])
    loads = [one for one in found if isinstance(one, Load)]
    assert loads[:4] == [
        Load(0, 1, 0.5, 0, ()),
        Load(0, 2, 1.0, 4, ((1.5, -2.0),)),
        Load(100, 1, 0.5, 0, ()),
        Load(100, 2, 1.0, 0, ()),
    ]


class Clock:
    """A clock that moves only while one sleeps, and notes how long."""

    def __init__(self):
        self.now_s, self.slept = 0.0, []

    def monotonic(self):
        return self.now_s

    def sleep(self, wait_s):
        self.slept.append(wait_s)
        self.now_s += wait_s


@pytest.mark.parametrize(("speed", "due_s"), [(1.0, 3.2), (2.0, 1.6)])
def test_a_replay_keeps_time_and_waits_three_seconds_at_most(monkeypatch, speed, due_s):
    """Steps of 0.1, 6.9 and 0.1 s: the pause is cut to 3 s. Nothing is waited for longer than 0.2 s."""
    clock = Clock()
    monkeypatch.setattr(link, "time", clock)
    chunks = list(link.replay_chunks(recording(), speed))
    assert clock.now_s == pytest.approx(due_s)
    assert max(clock.slept) == pytest.approx(0.2)
    assert chunks.count(b"") == len(clock.slept)


def test_a_board_that_is_silent_for_ten_seconds_is_given_up(monkeypatch):
    clock = Clock()
    monkeypatch.setattr(link, "time", clock)

    def chunks(pauses, what=b""):
        for pause_s in pauses:
            clock.now_s += pause_s
            yield what

    silent = link.board_messages(chunks([5.0, 5.0, 0.1]), LineDecoder(), "port")
    assert [next(silent), next(silent)] == [[], []]
    with pytest.raises(InputError, match="port"):
        next(silent)
    heard = link.board_messages(
        chunks([9.0, 9.0, 9.0], encode_header(["F1-X1"])), LineDecoder(), "port"
    )
    assert len(list(heard)) == 3
    with pytest.raises(InputError, match="27 bytes since the start, 3 damaged"):
        list(link.board_messages(chunks([4.0] * 3, b"no head \n"), LineDecoder(), "port"))


def test_a_clock_follows_lines_a_second_out_of_order_and_begins_anew_behind_that():
    clock = link.BoardClock()
    assert clock.time_s(5000, 70.0) == 70.0
    assert clock.time_s(4000, 99.0) == 69.0  # a second late: kept
    assert clock.time_s(5000, 99.0) == 70.0
    assert clock.time_s(3999, 99.0) == 99.0  # more: the board started anew
    later = link.BoardClock(not_before_s=80.0)
    assert later.time_s(0, 70.0) == 80.0
    assert later.time_s(500, 70.0) == 80.5


def test_a_table_without_rows_of_a_channel_leaves_it_out():
    none = replace(recording(), counts=np.full((FRAMES, 5, 1, 3), 1.0))
    (header,) = LineDecoder().feed(next(link.replay_chunks(none, 0.0)))
    assert len(header.channels) == 15


def test_a_port_is_asked_for_its_header_and_read_as_bytes_come(monkeypatch):
    """One byte is waited for where there are none; a broken line is told."""
    made = []

    class Port:
        def __init__(self, *given, **options):
            self.given, self.written, self.asked = (given, options), [], []
            self.waiting = [0, 7, 10**6]
            made.append(self)

        def __enter__(self):
            return self

        def __exit__(self, *error):
            self.closed = True

        @property
        def in_waiting(self):
            if not self.waiting:
                raise OSError("unplugged")
            return self.waiting.pop(0)

        def write(self, text):
            self.written.append(text)

        def read(self, most):
            self.asked.append(most)
            return b"x" * min(most, 3)

    monkeypatch.setattr("serial.Serial", Port)
    chunks = link.serial_chunks("/dev/ttyX", 9600, 0.5)
    assert [next(chunks) for _ in range(3)] == [b"x", b"xxx", b"xxx"]
    (port,) = made
    assert port.given == (("/dev/ttyX", 9600), {"timeout": 0.5, "exclusive": True})
    assert port.written == [b"?\n"]
    assert port.asked == [1, 7, 65536]
    with pytest.raises(InputError, match=r"/dev/ttyX: the line broke off \(unplugged\)"):
        next(chunks)
    assert port.closed

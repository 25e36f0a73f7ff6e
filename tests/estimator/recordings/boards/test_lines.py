"""Lines of boards: what is sent comes out, and whatever is damaged is counted, never believed."""

import binascii
import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from design.errors import InputError
from estimator.recordings.boards.lines import (
    Frame,
    Header,
    LineDecoder,
    Load,
    Status,
    checksum,
    encode_header,
    encode_load,
)
from estimator.recordings.boards.lines import encode_frame as encode_floats
from estimator.recordings.boards.link import BoardClock, counts_of

CHANNELS = ("F3-X1", "F1-Z2", "F5-Y3")


def encode_frame(sequence, board_ms, counts):
    return encode_floats(sequence, board_ms, [float(value) for value in counts])


def lines(count=5, first=0):
    return [encode_frame(first + k, 100 * k, [k, -7.5, float("nan")]) for k in range(count)]


def started():
    decoder = LineDecoder()
    decoder.feed(encode_header(CHANNELS))
    return decoder


def test_checksum_is_the_published_one():
    """Check value of CRC-16/CCITT-FALSE."""
    assert checksum(b"123456789") == "29B1"
    assert binascii.crc_hqx(b"123456789", 0) != 0x29B1


def test_messages_round_trip():
    loads = [
        Load(12, 2, 7.25, 3, ((1.5, -4.5), (0.0, 13.5))),
        Load(13, 1, -0.02, None, ()),
        Load(14, 1, 0.0, 0, ()),
        Load(15, 9, 1.0, None, ()),
    ]
    sent = encode_header(CHANNELS) + encode_frame(65537, 2**32 + 5, [3, -2, 8.125])
    sent += b"".join(encode_load(load) for load in loads)
    assert LineDecoder().feed(sent) == [
        Header(CHANNELS),
        Frame(1, 5, (3.0, -2.0, 8.125)),
        *loads,
    ]


def test_a_status_is_read_with_a_silent_sensor():
    (found,) = started().feed(body_line("S,7,,1,2,3,watchdog,24.5,,-3.0"))
    assert found.sensors_c[::2] == (24.5, -3.0)
    assert np.isnan(found.sensors_c[1])
    assert (found.board_ms, found.supply_mv, found.start) == (7, None, "watchdog")
    assert (found.supply_errors, found.bus_errors, found.bus_recoveries) == (1, 2, 3)


def test_a_status_needs_as_many_temperatures_as_the_header_has_sensors():
    decoder = started()
    assert decoder.feed(body_line("S,0,5000,0,0,0,power,20.0,21.0")) == []
    assert decoder.statistics.damaged_lines == 1


@pytest.mark.parametrize("cell", [0, 10])
def test_load_cells_are_numbered_from_1_to_9(cell):
    decoder = started()
    assert decoder.feed(encode_load(Load(1, cell, 1.0, None, ()))) == []
    assert decoder.statistics.damaged_lines == 1


def test_a_silent_sensor_is_an_empty_cell():
    (frame,) = started().feed(encode_frame(0, 0, [5, float("nan"), 6]))
    assert np.isnan(frame.counts[1])
    assert b",5,,6*" in encode_frame(0, 0, [5, float("nan"), 6])


@given(cuts=st.lists(st.integers(0, 400), max_size=30))
def test_however_the_bytes_are_cut(cuts):
    sent = encode_header(CHANNELS) + b"".join(lines(8))
    edges = sorted({0, len(sent), *(cut for cut in cuts if cut < len(sent))})
    decoder = LineDecoder()
    found = [
        message
        for first, last in itertools.pairwise(edges)
        for message in decoder.feed(sent[first:last])
    ]
    assert [frame.sequence for frame in found[1:]] == list(range(8))
    assert decoder.statistics.damaged_lines == 0


@settings(max_examples=200, deadline=None)
@given(garbage=st.binary(min_size=1, max_size=300), after=st.integers(0, 4))
def test_garbage_costs_no_sound_line_behind_its_end(garbage, after):
    sent = lines(5)
    sent.insert(after, garbage + b"\n")
    decoder = started()
    found = [m for m in decoder.feed(b"".join(sent)) if isinstance(m, Frame)]
    assert [frame.sequence for frame in found] == list(range(5))
    assert decoder.statistics.lost_frames == 0


def test_garbage_glued_to_a_line_is_skipped():
    decoder = started()
    assert decoder.feed(b"\xff\x00$F,1,$$" + lines(1)[0])[0].sequence == 0
    assert decoder.statistics.damaged_lines == 0


@given(place=st.integers(0, 10**6), bit=st.integers(0, 7))
def test_one_flipped_bit_is_never_believed(place, bit):
    line = bytearray(encode_frame(7, 900, [123, -45, 6]))
    line[place % (len(line) - 1)] ^= 1 << bit
    decoder = started()
    found = decoder.feed(bytes(line) + encode_frame(8, 1000, [1, 2, 3]))
    sound = [frame for frame in found if frame.sequence == 7]
    assert all(frame == Frame(7, 900, (123.0, -45.0, 6.0)) for frame in sound)
    assert found[-1].sequence == 8
    assert sound or decoder.statistics.damaged_lines


def test_without_a_checksum_the_flip_would_be_believed():
    """The planted fault: the same line with a checksum of its own damaged text."""
    line = encode_frame(7, 900, [123, -45, 6]).replace(b"123", b"923")
    assert started().feed(line) == []
    body = line[1 : line.rfind(b"*")]
    (frame,) = started().feed(b"$" + body + b"*" + checksum(body).encode() + b"\n")
    assert frame.counts[0] == 923


def test_lost_frames_and_restarts_are_counted():
    decoder = started()
    for sequence in (65533, 65535, 0, 3, 40000):
        decoder.feed(encode_frame(sequence, 0, [1, 2, 3]))
    found = decoder.statistics
    assert (found.frames, found.lost_frames, found.restarts) == (5, 1 + 0 + 2, 1)


@pytest.mark.parametrize(
    "body",
    ["F,1", "F,1,2,3,4", "F,1,2,3,4,5,6", "F,a,2,3,4,5", "F,1,2,3,4,1e30", "F,1,2,inf,4,5",
     "L,1,0,3", "L,1,1,nan", "L,1,1,2,7,0,0", "L,1,1,2,3", "L,1,1,2,3,4", "L,1,1,2,0,1,1",
     "L,1,1,99999", "Q,1", "", "S,1", "S,1,,0,0,0,luck,1,2,3", "S,1,,0,-1,0,power,1,2,3",
     "S,1,,0,0,0,power,1,2,1e9", "S,1,9e9,0,0,0,power,1,2,3"],
)  # fmt: skip
def test_sound_lines_that_make_no_sense_are_damaged(body):
    decoder = started()
    assert decoder.feed(f"${body}*{checksum(body.encode())}\n".encode()) == []
    assert decoder.statistics.damaged_lines == 1


@pytest.mark.parametrize(
    ("body", "words"),
    [
        ("H,2,F1-X1", "line format"),
        ("H,1", "channels"),
        ("H,1,X1", "X1"),
        ("H,1,F1-X1,F1-X1", "named once"),
        ("H,1,F7-X1", "F7-X1"),
    ],
)
def test_headers_that_cannot_be_followed(body, words):
    with pytest.raises(InputError, match=words):
        LineDecoder().feed(f"${body}*{checksum(body.encode())}\n".encode())


def test_frames_before_the_header_are_skipped():
    decoder = LineDecoder()
    assert decoder.feed(b"".join(lines(3))) == []
    assert decoder.statistics.frames == 0


def test_an_endless_line_does_not_fill_the_memory():
    decoder = started()
    for _ in range(50):
        decoder.feed(b"x" * 1000)
    assert decoder.statistics.damaged_lines >= 9
    assert len(decoder.feed(b"\n" + lines(1)[0])) == 1


def test_counts_in_this_package_order():
    counts = counts_of(CHANNELS, (1.0, 2.0, 3.0))
    assert counts.shape == (5, 3, 3)
    assert (counts[2, 0, 0], counts[0, 1, 2], counts[4, 2, 1]) == (1, 2, 3)
    assert np.isfinite(counts).sum() == 3


def test_clock_of_a_board():
    """It wraps after 49 days, may be a little out of order, and starts anew with the board."""
    clock = BoardClock()
    times = [clock.time_s(ms, 50.0) for ms in (2**32 - 400, 2**32 - 100, 200, 150, 1200)]
    np.testing.assert_allclose(times, [50, 50.3, 50.6, 50.55, 51.6], atol=1e-9)
    assert clock.time_s(2**31, 80.0) == pytest.approx(50.6 + (2**31 - 200) / 1000)
    assert clock.time_s(10, 99.0) == 99.0


def body_line(body):
    return f"${body}*{checksum(body.encode())}\n".encode()


@pytest.mark.parametrize(
    ("sound", "damaged"),
    [
        ("F,1,2,16777216,-16777216,0", "F,1,2,16777217,0,0"),
        ("L,1,1,1000", "L,1,1,1000.1"),
        ("L,1,1,-1000", "L,1,1,-1000.1"),
        ("L,1,1,2,3,300,-300", "L,1,1,2,3,300.1,0"),
        ("L,1,9,2,6,1,1", "L,1,9,2,7,1,1"),
        ("L,1,1,2,1,1,1,2,2", "L,1,1,2,1,1,1,2"),
        ("S,1,60000,0,0,0,power,300,-300,", "S,1,60001,0,0,0,power,1,2,3"),
        ("S,1,0,0,0,0,reset,1,2,3", "S,1,-1,0,0,0,reset,1,2,3"),
        ("S,1,,0,0,0,brownout,1,2,3", "S,1,,0,0,-1,brownout,1,2,3"),
        ("S,1,,0,0,0,watchdog,1,2,3", "S,1,,-1,0,0,watchdog,1,2,3"),
        ("S,1,,0,0,0,watchdog,1,2,3", "S,1,,0,0,0,watchdog,1,2,300.1"),
    ],
)
def test_values_at_the_border_are_believed_and_beyond_it_damaged(sound, damaged):
    decoder = started()
    assert len(decoder.feed(body_line(sound))) == 1
    assert decoder.statistics.damaged_lines == 0
    assert decoder.feed(body_line(damaged)) == []
    assert decoder.statistics.damaged_lines == 1


def test_a_status_counts_chips_and_not_channels():
    decoder = LineDecoder()
    decoder.feed(encode_header(["F1-X1", "F1-Y1", "F1-X2", "F2-X1", "F2-Z10"]))
    four = Status(0, 5000, 0, 0, 0, "power", (20.0, 21.0, 22.0, 23.0))
    assert decoder.feed(body_line("S,0,5000,0,0,0,power,20.0,21.0,22.0,23.0")) == [four]
    assert decoder.feed(body_line("S,0,5000,0,0,0,power" + 5 * ",20.0")) == []
    assert LineDecoder().feed(body_line("S,3,,0,0,0,reset")) == [
        Status(3, None, 0, 0, 0, "reset", ())
    ]


def test_every_lost_frame_up_to_ten_thousand_is_counted_and_more_is_a_restart():
    decoder = started()
    for sequence in (0, 10_001, 20_003):
        decoder.feed(encode_frame(sequence, 0, [1, 2, 3]))
    assert (decoder.statistics.lost_frames, decoder.statistics.restarts) == (10_000, 1)


def test_a_line_of_4096_bytes_is_waited_for_and_a_longer_one_dropped():
    decoder = started()
    decoder.feed(b"x" * 4096)
    assert decoder.statistics.damaged_lines == 0
    decoder.feed(b"x")
    assert decoder.statistics.damaged_lines == 1
    assert len(decoder.feed(lines(1)[0])) == 1
    assert decoder.feed(b"\n  \r\n") == []
    assert decoder.statistics.damaged_lines == 1
    assert len(decoder.feed(lines(1)[0].replace(b"\n", b"\r\n"))) == 1


def counts_read(decoder, channel):
    """What is read of one channel, frame by frame."""
    read = []
    for k, value in enumerate(channel):
        (frame,) = decoder.feed(encode_frame(k, 100 * k, [value, 2, 3]))
        assert frame.counts[1:] == (2.0, 3.0)
        read.append(frame.counts[0])
    return read


@pytest.mark.parametrize("sign", [1, -1])
def test_counts_that_wrap_round_are_undone(sign):
    """A field that grows beyond a chip of 16 bits and shrinks again, as an MLX90393 sends it."""
    true = sign * np.concatenate([np.arange(0, 60_000, 3_000), np.arange(60_000, 0, -3_000)])
    decoder = started()
    read = np.array(counts_read(decoder, ((true + 32_768) % 65_536 - 32_768).tolist()))
    beyond = (true > 32_767) | (true < -32_768)
    assert np.array_equal(read, true)
    assert decoder.statistics.unwrapped_readings == beyond.sum()
    assert decoder.statistics.wrapped_readings == 0
    assert "wrapped round beyond the chip's range" in decoder.statistics.wrapped_text


@pytest.mark.parametrize(
    ("step_ms", "others"), [(100, 9_000.0), (400, 0.0), (20, 0.0)], ids=["shaken", "late", "fast"]
)
def test_a_wrap_that_may_be_another_is_left_out_until_counts_come_back(step_ms, others):
    """Neighbours jump too, frames are missing, or the change is faster than the bound."""
    true = [30_000.0, 36_000.0, 37_000.0, 31_000.0, 30_500.0]
    decoder, read = started(), []
    for k, value in enumerate(true):
        raw = (value + 32_768) % 65_536 - 32_768
        moved = others * (k % 2)
        (frame,) = decoder.feed(encode_frame(k, k * step_ms, [raw, moved, -moved]))
        read.append(frame.counts[0])
    np.testing.assert_array_equal(read, [30_000, np.nan, np.nan, 31_000, 30_500])
    assert decoder.statistics.wrapped_readings == 2


def test_counts_that_saturate_or_belong_to_wider_chips_are_believed():
    nan = float("nan")
    saturated = [30_000.0, 32_767.0, 32_767.0, nan, 20_000.0, -28_000.0]
    wide = [-40_000.0, 40_000.0, 2_000_000.0, -2_000_000.0]
    for channel in (saturated, wide):
        decoder = started()
        assert np.array_equal(counts_read(decoder, channel), channel, equal_nan=True)
        assert decoder.statistics.wrapped_text == ""


def test_a_restart_forgets_how_often_counts_wrapped():
    decoder = started()
    decoder.feed(encode_frame(0, 0, [32_000, 2, 3]))
    (frame,) = decoder.feed(encode_frame(1, 100, [-32_000, 2, 3]))
    assert frame.counts[0] == 33_536
    (frame,) = decoder.feed(encode_frame(40_000, 200, [-32_000, 2, 3]))
    assert frame.counts[0] == -32_000

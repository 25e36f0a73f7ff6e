"""Messages of frames hold what they were given, byte for byte where the page looks for it."""

import json
import struct

import numpy as np
from numpy.testing import assert_array_equal

from instobj.bench.live.protocol import Head, frames_message, state_message
from tests.support.live_frames import read_frames_message


def message_of(rows=3, contacts=2, labels=1, channels=6):
    rng = np.random.default_rng(1)
    parts = [
        rng.normal(size=(count, wide)).astype(np.float32)
        for count, wide in ((rows, 1 + channels), (contacts, 15), (labels, 10))
    ]
    parts[0][0, 3] = np.nan
    head = Head(7, 5, 1.7e9 + 0.25, 1.7e9, 12.5)
    return head, parts, frames_message(head, *parts)


def test_a_message_comes_back_whole():
    for counts in ((3, 2, 1), (400, 0, 0), (1, 6, 3)):
        head, parts, message = message_of(*counts)
        found, back = read_frames_message(message, 6)
        assert found == head
        for part, there in zip(parts, back, strict=True):
            assert_array_equal(there, part)


def test_numbers_stand_where_the_page_reads_them():
    """The places of instobj/viewer/source/messages.js."""
    _, (rows, contacts, labels), message = message_of()
    assert message[:4] == b"IOF1"
    assert struct.unpack_from("<HBB", message, 4) == (3, 2, 1)
    assert struct.unpack_from("<II", message, 8) == (7, 5)
    assert struct.unpack_from("<3d", message, 16) == (1.7e9 + 0.25, 1.7e9, 12.5)
    values = np.frombuffer(message[40:], "<f4")
    assert_array_equal(values[:7], rows[0])
    assert_array_equal(values[21:36], contacts[0])
    assert_array_equal(values[51:], labels[0])


def test_a_state_is_json_behind_its_name():
    message = state_message({"health": [0, 4], "told": "läuft"})
    assert message[:4] == b"IOS1"
    assert json.loads(message[4:]) == {"health": [0, 4], "told": "läuft"}

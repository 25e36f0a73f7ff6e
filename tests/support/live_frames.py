"""Messages of frames to the live page, taken apart as `instobj.bench.live.protocol` lays them out."""

import struct

import numpy as np

from instobj.bench.live.protocol import CONTACT_WIDTH, LABEL_WIDTH, Head

HEAD = struct.Struct("<4sHBBIIddd")


def read_frames_message(message, channels):
    """Return what `frames_message` was given: head, and rows, contacts, labels (float32)."""
    mark, rows, contacts, labels, number, dropped, *times = HEAD.unpack_from(message)
    assert mark == b"IOF1"
    values, parts, start = np.frombuffer(message, "<f4", offset=HEAD.size), [], 0
    for count, wide in ((rows, 1 + channels), (contacts, CONTACT_WIDTH), (labels, LABEL_WIDTH)):
        parts.append(values[start : start + count * wide].reshape(count, wide))
        start += count * wide
    return Head(number, dropped, *times), parts

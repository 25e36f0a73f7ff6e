"""A small new object for tests of its bring-up, and its board on a pseudo-terminal."""

import os
import select
import threading
import time
import tty
from contextlib import contextmanager, suppress

from design.spec.object import ObjectSpec
from estimator.recordings.boards.lines import encode_frame, encode_header

SMALL_TEXT = """name = "small"
[sensors]
count_per_face = 2
chip_spread = [0.0, 0.01]
[magnets]
positions_mm = [[0, 0], [10, 6]]
"""
SMALL = ObjectSpec.model_validate(
    {
        "name": "small",
        "sensors": {"count_per_face": 2, "chip_spread": [0.0, 0.01]},
        "magnets": {"positions_mm": [[0, 0], [10, 6]]},
    }
)
"""Ten chips, ten magnets."""


class PlayedBoard:
    """Sends the frames of whatever recording it is shown, over and over; `leave` pulls the plug."""

    def __init__(self, channels):
        self.channels, self.frames, self.sent = channels, [], 0
        self.master, self.slave = os.openpty()
        tty.setraw(self.slave)
        os.set_blocking(self.master, False)
        self.port, self.stop = os.ttyname(self.slave), threading.Event()
        self.thread = threading.Thread(target=self._send)

    def show(self, recording):
        counts = recording.counts.reshape(len(recording.counts), -1)
        self.frames = [tuple(map(float, row)) for row in counts]

    def leave(self):
        self.stop.set()
        self.thread.join()
        for handle in (self.master, self.slave):
            with suppress(OSError):
                os.close(handle)

    def _send(self):
        while not self.stop.is_set():
            with suppress(OSError):
                if select.select([self.master], [], [], 0)[0] and b"?" in os.read(self.master, 99):
                    os.write(self.master, encode_header(self.channels))
            frames = self.frames
            if frames:
                line = encode_frame(self.sent, 10 * self.sent, frames[self.sent % len(frames)])
                with suppress(BlockingIOError):
                    os.write(self.master, line)
                self.sent += 1
            time.sleep(0.0005)


@contextmanager
def played_board(channels):
    board = PlayedBoard(channels)
    board.thread.start()
    try:
        yield board
    finally:
        board.leave()

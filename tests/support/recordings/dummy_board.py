"""A board without hardware: sends lines into a pseudo-terminal as a real one would into its port."""

import os
import select
import threading
import time
import tty
from contextlib import contextmanager, suppress

from estimator.recordings.boards.lines import Load, encode_frame, encode_header, encode_load

CHANNELS = ("F1-X1", "F1-Y1", "F1-Z1", "F3-X1", "F3-Y1", "F3-Z1")
RATE_HZ = 100.0


def force_at(k):
    """Force (N) of frame k: rest, a press of 6 N, rest, one of 9 N, … each 60 frames long."""
    phase = k % 60
    return (6.0 + 3.0 * (k // 60 % 2)) * max(0.0, 1 - abs(phase - 40) / 15)


def counts_at(k):
    force = force_at(k)
    gains = (1, -2, 1, 40, -25, 60)
    noise = [((7919 * k + 31 * c) % 4111) % 41 - 20 for c in range(6)]
    return [
        float(100 * c + round(g * force) + n)
        for c, (g, n) in enumerate(zip(gains, noise, strict=True))
    ]


def board_lines(k, loads=True, place=(3, ((1.5, -4.5),))):
    """Bytes of frame k with its load cell's line before it; `place` None: the cell knows none."""
    ms = round(1000 * k / RATE_HZ)
    face, tips = place or (None, ())
    load = encode_load(Load(ms, 1, force_at(k), face, tips)) if loads else b""
    return load + encode_frame(k, ms, counts_at(k))


@contextmanager
def dummy_board(lines=board_lines, first=0, header=True, channels=CHANNELS, asked=None):
    """Name of a port on which frames come at `RATE_HZ` until the context ends.

    The event `asked` is set when a reader asks for the channels.
    """
    master, slave = os.openpty()
    tty.setraw(slave)
    os.set_blocking(master, False)
    stop = threading.Event()

    def send():
        k, started = first, time.monotonic()
        while not stop.is_set():
            if select.select([master], [], [], 0)[0] and b"?" in os.read(master, 1024) and header:
                os.write(master, encode_header(channels))
                if asked is not None:
                    asked.set()
            with suppress(BlockingIOError):  # nobody reads: a real port loses the line as well
                os.write(master, lines(k))
            k += 1
            stop.wait(max(0.0, started + (k - first) / RATE_HZ - time.monotonic()))

    thread = threading.Thread(target=send)
    thread.start()
    try:
        yield os.ttyname(slave)
    finally:
        stop.set()
        thread.join()
        os.close(master)
        os.close(slave)

"""Readings from a board on a serial port, or replayed from a recording through the same lines."""

from __future__ import annotations

import time
from collections.abc import Generator, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float

from design.catalogue.bus_parts import MOTION
from design.errors import InputError
from estimator.recordings.boards.lines import (
    Frame,
    Header,
    LineDecoder,
    Load,
    Message,
    encode_frame,
    encode_header,
    encode_load,
)
from estimator.recordings.formats.generic import counts_of_column
from estimator.recordings.presses import frame_times_s, stretches
from estimator.recordings.table import RawTable, channel_name

if TYPE_CHECKING:
    from serial import Serial

BAUD = 115_200
"""Bits per second of the serial line, as the firmware has it."""
PATIENCE_S = 10.0
"""Time without a sound line after which the board counts as silent."""
_SLICE_S = 0.2
"""Longest wait for bytes: an empty chunk then lets the caller go on."""
_CLOCK = 2**32
"""Milliseconds after which a board's 32-bit clock begins again."""
_DISORDER_MS = 1000
"""Step back of the clock up to which lines are in disorder; more, and the board has restarted."""


@dataclass(frozen=True)
class Reading:
    """One frame: time (s since 1970, by the board's clock) and raw counts, NaN where silent."""

    time_s: float
    counts: Float[np.ndarray, "face sensor 3"]


@dataclass
class BoardClock:
    """A board's milliseconds as seconds since 1970: set at its first line and after restarts.

    Never before `not_before_s`: boards' clocks and this machine's differ, and what is added to a
    recording comes after what it holds.
    """

    not_before_s: float = 0.0
    _base_s: float = 0.0
    _last_ms: int | None = None

    def time_s(self, board_ms: int, now_s: float) -> float:
        """Time of a line that arrived at `now_s`; lines up to 1 s out of order keep their times."""
        if self._last_ms is None:
            self._base_s, self._last_ms = max(now_s, self.not_before_s), board_ms
            return self._base_s
        step_ms = (board_ms - self._last_ms + _CLOCK // 2) % _CLOCK - _CLOCK // 2
        if -_DISORDER_MS <= step_ms < 0:
            return self._base_s + step_ms / 1000
        self._base_s = self._base_s + step_ms / 1000 if step_ms >= 0 else now_s
        self._last_ms = board_ms
        return self._base_s


def board_readings(
    port: str, baud: int = BAUD, decoder: LineDecoder | None = None
) -> Iterator[Reading]:
    """Readings of a board as they come, without end; `decoder` keeps the statistics of the line.

    Raises
    ------
    InputError
        No such port, no sound frame for `PATIENCE_S`, or the board was unplugged.
    """
    decoder, clock, channels = decoder or LineDecoder(), BoardClock(), ()
    for messages in board_messages(serial_chunks(port, baud), decoder, port):
        for message in messages:
            if isinstance(message, Header):
                channels = message.channels
            elif isinstance(message, Frame):
                now_s = clock.time_s(message.board_ms, time.time())
                yield Reading(now_s, counts_of(channels, message.counts))


def counts_of(
    channels: tuple[str, ...], values: tuple[float, ...]
) -> Float[np.ndarray, "face sensor 3"]:
    """Values in the order of a header as (face, sensor, axis), NaN where there is no channel."""
    named = {name: np.array([value]) for name, value in zip(channels, values, strict=True)}
    return counts_of_column(named, 1)[0]


def board_messages(
    chunks: Iterator[bytes], decoder: LineDecoder, where: str
) -> Iterator[list[Message]]:
    """Messages of every chunk (often none).

    Raises
    ------
    InputError
        No sound line for `PATIENCE_S`.
    """
    heard_s, received = time.monotonic(), 0
    for chunk in chunks:
        messages = decoder.feed(chunk)
        received += len(chunk)
        if messages:
            heard_s = time.monotonic()
        elif time.monotonic() - heard_s > PATIENCE_S:
            raise InputError(
                f"{where}: no sound line for {PATIENCE_S:g} s ({received} bytes since the start, "
                f"{decoder.statistics.damaged_lines} damaged lines). Check the baud rate and the "
                "line format (`instobj docs recordings`)"
            )
        yield messages


def serial_chunks(port: str, baud: int = BAUD, timeout_s: float = _SLICE_S) -> Generator[bytes]:
    """Bytes from a serial port as they come; empty after `timeout_s` without any.

    Asks for the header at the start (`?`), which the board may also send by itself.

    Raises
    ------
    InputError
        The port cannot be opened, or the board was unplugged.
    """
    from serial import SerialException

    with _opened(port, baud, timeout_s) as link:
        try:
            link.write(b"?\n")
            while True:
                yield link.read(min(max(1, link.in_waiting), 65536))
        except (SerialException, OSError) as error:
            raise InputError(
                f"{port}: the line broke off ({error}). Plug the board in again and repeat the "
                "command: it goes on where it stopped"
            ) from None


def require_port(port: str, baud: int = BAUD) -> None:
    """Raise InputError where a serial port cannot be opened, before work that takes minutes."""
    _opened(port, baud, _SLICE_S).close()


def _opened(port: str, baud: int, timeout_s: float) -> Serial:
    from serial import Serial, SerialException

    try:
        return Serial(port, baud, timeout=timeout_s, exclusive=True)
    except (SerialException, ValueError, OSError) as error:
        raise InputError(f"cannot open {port}: {error}. {_ports()}") from None


def _ports() -> str:
    from serial.tools.list_ports import comports

    names = ", ".join(port.device for port in comports())
    return f"Ports found: {names or 'none'}; on Linux you must belong to the group dialout"


LONGEST_PAUSE_S = 3.0
"""Between two rows of a replay: recordings pause for minutes while a rig is moved."""


def replay_chunks(table: RawTable, speed: float) -> Generator[bytes]:
    """A recording as the lines that a board would have sent.

    `speed` 1 keeps its own times, 2 is twice as fast, 0 as fast as possible. Pauses of more than
    `LONGEST_PAUSE_S` take no longer than that; the lines keep their times.
    """
    channels = [
        index
        for index in np.ndindex(*table.counts.shape[1:])
        if np.isfinite(table.counts[(slice(None), *index)]).any()
    ]
    motion = np.zeros((len(table.counts), 0)) if table.motion is None else table.motion
    names = [channel_name(*index) for index in channels]
    yield encode_header([*names, *MOTION[: motion.shape[1]]])
    stretch = stretches(table.time_s, table.case[:, None].astype(float))
    times_s, _ = frame_times_s(table.time_s, stretch, 10.0)
    due_s = np.cumsum(np.minimum(np.diff(times_s, prepend=times_s[0]), LONGEST_PAUSE_S))
    started_s = time.monotonic()
    for row, time_s in enumerate(times_s - times_s[0]):
        while speed > 0 and (wait_s := due_s[row] / speed - (time.monotonic() - started_s)) > 0:
            time.sleep(min(wait_s, _SLICE_S))
            yield b""
        board_ms = round(1000 * max(time_s, 0.0))
        loads = [encode_load(load) for load in _loads(table, row, board_ms)]
        counts = [float(table.counts[(row, *index)]) for index in channels]
        counts += motion[row].tolist()
        yield b"".join([*loads, encode_frame(row, board_ms, counts)])


def _loads(table: RawTable, row: int, board_ms: int) -> list[Load]:
    loads = []
    if table.labelled_by_travel:  # no load cell said anything
        return loads
    for cell, force_n in enumerate(table.force_n[row]):
        tips = [(float(x), float(y)) for x, y in table.tip_xy_mm[row, cell] if np.isfinite(x)]
        stated = bool(tips) and not table.declared_rest[row]
        face = int(table.face[row, cell]) if stated else 0
        loads.append(Load(board_ms, cell + 1, float(force_n), face, tuple(tips) if stated else ()))
    return loads

"""A machine with Grbl 1.1 on a serial port: lines streamed by counting characters, state, alarms."""

from __future__ import annotations

import math
import re
from collections import deque
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Protocol, runtime_checkable

from design.errors import InputError
from instobj.bench.rig.clock import Clock, Listening
from instobj.bench.rig.grbl_lines import (
    ALARMS,
    ERRORS,
    FEED_HOLD,
    RECEIVE_BYTES,
    SOFT_RESET,
    STATUS,
    Alarm,
    Done,
    Greeting,
    Refused,
    Reply,
    ReplyReader,
    Setting,
    State,
)

GRBL_BAUD = 115_200
"""That of every Grbl 1.1; grblHAL on USB takes any."""
_HEIGHT = re.compile(r"Z(-?[0-9.]+)")


class MachineFault(InputError):
    """The machine did not do what it was sent."""


@runtime_checkable
class ByteLine(Protocol):
    """A serial port that never waits."""

    def read(self, size: int, /) -> bytes: ...

    def write(self, data: bytes, /) -> int | None: ...


@dataclass
class GrblLink:
    """Lines to a machine and its answers.

    A line is sent once it fits into what is free of the machine's receive buffer, lines that belong
    together once all of them do. No line that goes below `floor_mm` (machine's Z) is sent, whoever asks
    for it; until a floor is set none that names a height is. `states` counts the reports of its state,
    `state` is the last one; `trusted` is False while alarms and refusals are expected (a reset, homing);
    `lost` is True once its position means nothing, until it is homed.
    """

    line: ByteLine
    where: str
    state: State | None = None
    states: int = 0
    greetings: int = 0
    alarm: int | None = None
    settings: dict[int, float] = field(default_factory=dict)
    trusted: bool = False
    lost: bool = False
    floor_mm: float = math.inf
    clock: Clock = field(default_factory=Clock)
    _resets: int = 0
    _reader: ReplyReader = field(default_factory=ReplyReader)
    _queue: deque[list[bytes]] = field(default_factory=deque)
    _sent: deque[bytes] = field(default_factory=deque)

    @property
    def unanswered(self) -> int:
        """Lines that wait here or in the machine."""
        return sum(map(len, self._queue)) + len(self._sent)

    def send(self, *lines: str) -> None:
        """Queue lines, and send what fits."""
        for line in lines:
            self.send_whole([line])

    def send_whole(self, lines: list[str]) -> None:
        """Queue lines that are sent at once, when all of them fit.

        Raises
        ------
        MachineFault
            One goes below the floor; none of them is sent.
        """
        for line in lines:
            self._require_above_floor(line)
        self._queue.append([f"{line}\n".encode() for line in lines])
        self._fill()

    def ask(self) -> None:
        """Have the machine report its state."""
        self._write(STATUS)

    def hold(self) -> None:
        """Stop the feed; what was queued here is not sent any more."""
        self._write(FEED_HOLD)
        self._queue.clear()

    def reset(self) -> None:
        """Empty the machine's buffers. While it moves, its position is lost by this."""
        self._resets += 1
        self._write(SOFT_RESET)
        self.forget()

    def forget(self) -> None:
        """Expect no answers any more."""
        self._queue.clear()
        self._sent.clear()

    def poll(self) -> list[Reply]:
        """Take in what has come.

        Raises
        ------
        MachineFault
            An alarm, a refused line, a reset that nobody asked for, or the line broke off.
        """
        replies = self._reader.feed(self._read())
        for reply in replies:
            self._take(reply)
        self._fill()
        return replies

    def _take(self, reply: Reply) -> None:
        if isinstance(reply, State):
            self.state, self.states = reply, self.states + 1
        elif isinstance(reply, Setting):
            self.settings[reply.number] = reply.value
        elif isinstance(reply, Alarm):
            self.alarm = reply.code
            self._fail(f"ALARM:{reply.code} ({ALARMS.get(reply.code, 'unknown')})")
        elif isinstance(reply, Greeting):
            self._take_greeting()
        elif isinstance(reply, Done | Refused):
            line = self._sent.popleft() if self._sent else b""
            if isinstance(reply, Refused):
                why = ERRORS.get(reply.code, "unknown")
                self._fail(f"error:{reply.code} ({why}) to {line.decode().strip()!r}")

    def _take_greeting(self) -> None:
        """A reset that nobody asked for may be a lost supply: the axes may have dropped meanwhile, and
        some controllers then call the place where they are zero."""
        self.greetings += 1
        self.forget()
        if self.trusted or self._resets <= 0:
            self.lost = True
        self._resets = max(self._resets - 1, 0)
        self._fail("it was reset, or lost its supply")

    def _require_above_floor(self, line: str) -> None:
        match = _HEIGHT.search(line)
        if match is not None and not float(match[1]) >= self.floor_mm:
            raise MachineFault(
                f"{self.where}: {line!r} goes below Z = {self.floor_mm:g} mm, the lowest height that is "
                "safe now. It was not sent"
            )

    def _fail(self, what: str) -> None:
        if self.trusted:
            raise MachineFault(f"{self.where}: {what}")

    def _fill(self) -> None:
        while self._queue:
            whole = b"".join(self._queue[0])
            if sum(map(len, self._sent)) + len(whole) > RECEIVE_BYTES:
                return
            self._write(whole)
            self._sent.extend(self._queue.popleft())

    def _read(self) -> bytes:
        return self._guarded(lambda: self.line.read(4096))

    def _write(self, data: bytes) -> None:
        self._guarded(lambda: self.line.write(data) and b"")

    def _guarded(self, act: Callable[[], bytes | int | None]) -> bytes:
        from serial import SerialException

        try:
            return act() or b""  # pyright: ignore[reportReturnType]
        except (SerialException, OSError) as error:
            raise MachineFault(f"{self.where}: the line broke off ({error})") from None


@contextmanager
def grbl_link(port: str, baud: int = GRBL_BAUD) -> Iterator[GrblLink]:
    """The machine on a port.

    Raises
    ------
    InputError
        The port cannot be opened.
    """
    from serial import Serial, SerialException

    try:
        line = Serial(port, baud, timeout=0, write_timeout=1, exclusive=True)
    except (SerialException, ValueError, OSError) as error:
        raise InputError(f"cannot open {port}: {error}. Give the machine's --port") from None
    with line:
        yield GrblLink(line, port)


def until(
    link: GrblLink, tick: Callable[[], None], met: Callable[[], bool], what: str, patience_s: float
) -> None:
    """Tick until something is met.

    Raises
    ------
    MachineFault
        It was not, for `patience_s`.
    """
    listening = Listening(patience_s, link.clock)
    give_up_s = listening.now_s + patience_s
    while not met():
        if listening.look() > give_up_s:
            state = "no state" if link.state is None else link.state.name
            raise MachineFault(
                f"{link.where}: {what} did not come within {patience_s:g} s (last: {state}, "
                f"{link.unanswered} lines without answer). Characters may have been lost"
            )
        tick()

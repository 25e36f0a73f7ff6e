"""A machine on a serial port, in its dialect: lines sent as it has room for them, state, alarms."""

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
from instobj.bench.rig.dialects import DIALECTS, Dialect, Speech
from instobj.bench.rig.replies import Alarm, Done, Greeting, Refused, Reply, Setting, State, Travel

_HEIGHT = re.compile(r"Z(-?[0-9.]+)")
_DWELL = re.compile(r"G4P([0-9.]+)")
_ASKED_AGAIN_S, _BUSY_S = 0.3, 5.0
"""Time after which a question without answer is asked again, where a machine queues questions; the second
while it has not taken a line, as it homes: questions of a minute fit into its buffer."""


class MachineFault(InputError):
    """The machine did not do what it was sent."""


@runtime_checkable
class ByteLine(Protocol):
    """A serial port that never waits."""

    def read(self, size: int, /) -> bytes: ...

    def write(self, data: bytes, /) -> int | None: ...


@dataclass
class MachineLink:
    """Lines to a machine and its answers.

    Lines are given in Grbl's words. One is sent once it fits into what is free of the machine's receive
    buffer, lines that belong together once all of them do; a machine whose stop leaves its buffer full
    (`room_bytes` 0) gets one at a time, once it has done the one before. No line that goes below `floor_mm`
    (machine's Z) is sent, whoever asks for it; until a floor is set none that names a height is. `states`
    counts the reports of its state, `state` is the last one; `trusted` is False while alarms and refusals are
    expected (a reset, homing); `lost` is True once its position means nothing, until it is homed.
    """

    line: ByteLine
    where: str
    state: State | None = None
    states: int = 0
    greetings: int = 0
    alarm: Alarm | None = None
    settings: dict[str, float] = field(default_factory=dict)
    trusted: bool = False
    lost: bool = False
    floor_mm: float = math.inf
    clock: Clock = field(default_factory=Clock)
    dialect: Dialect = DIALECTS["grbl"]
    _resets: int = 0
    _asked_s: float = -math.inf
    _taken: bool = False
    _dwell_end_s: float = -math.inf
    _queue: deque[list[str]] = field(default_factory=deque)
    _sent: deque[str] = field(default_factory=deque)
    _speech: Speech = field(init=False)

    def __post_init__(self) -> None:
        self._speech = self.dialect.speech()

    @property
    def travel(self) -> Travel:
        """Room in which the machine moves, by its settings.

        Raises
        ------
        InputError
            It did not tell them, or they keep it from working safely.
        """
        return self.dialect.travel(self.settings)

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
        self._queue.append(lines)
        self._fill()

    def ask(self) -> None:
        """Have the machine report its state; a question that queues behind lines waits for its answer."""
        if not self.dialect.room_bytes:
            now_s, is_dwelling = self.clock.now_s(), self._dwell_end_s > -math.inf
            is_busy = bool(self._sent) and not self._taken and not is_dwelling
            if now_s - self._asked_s < (_BUSY_S if is_busy else _ASKED_AGAIN_S):
                return
            self._asked_s = now_s
        self._write(self._speech.status)

    def hold(self) -> None:
        """Stop the feed; what was queued here is not sent any more."""
        self._write(self.dialect.hold)
        self._queue.clear()
        if not self.dialect.room_bytes:
            self.forget()

    def reset(self) -> None:
        """Empty the machine's buffers. While a Grbl moves, its position is lost by this."""
        self._resets += 1
        self._write(self.dialect.reset)
        self._speech.restart()
        self.forget()

    def forget(self) -> None:
        """Expect no answers any more."""
        self._queue.clear()
        self._sent.clear()
        self._taken, self._dwell_end_s = False, -math.inf

    def poll(self) -> list[Reply]:
        """Take in what has come.

        Raises
        ------
        MachineFault
            An alarm, a refused line, a reset that nobody asked for, or the line broke off.
        """
        replies = self._speech.feed(self._read())
        for reply in replies:
            self._take(reply)
        self._fill()
        return replies

    def _take(self, reply: Reply) -> None:
        if isinstance(reply, State):
            self.state, self.states = reply, self.states + 1
            self._asked_s = -math.inf
            if self._taken and reply.name == "Idle":
                self._finish_line()
        elif isinstance(reply, Setting):
            self.settings[reply.name] = reply.value
        elif isinstance(reply, Alarm):
            self.alarm = reply
            self._fail(reply.why)
        elif isinstance(reply, Greeting):
            self._take_greeting(reply)
        elif isinstance(reply, Done) and not self.dialect.room_bytes:
            self._taken = bool(self._sent)
        elif isinstance(reply, Done | Refused):
            line = self._finish_line()
            if isinstance(reply, Refused):
                self._fail(f"{reply.why} to {line!r}")

    def _finish_line(self) -> str:
        self._taken = False
        return self._sent.popleft() if self._sent else ""

    def _take_greeting(self, greeting: Greeting) -> None:
        """A reset that nobody asked for may be a lost supply: the axes may have dropped meanwhile, and
        some controllers then call the place where they are zero."""
        self.greetings += 1
        self.forget()
        if greeting.restarted or self.trusted or self._resets <= 0:
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
        if not self.dialect.room_bytes:
            self._send_next()
            return
        while self._queue:
            part = self._queue[0]
            if sum(len(line) + 1 for line in (*self._sent, *part)) > self.dialect.room_bytes:
                return
            self._write(b"".join(map(self._speech.encode, part)))
            self._sent.extend(self._queue.popleft())

    def _send_next(self) -> None:
        """Send the next line, once nothing is left to do of the one before; dwells pass here."""
        if -math.inf < self._dwell_end_s <= self.clock.now_s():
            self._dwell_end_s = -math.inf
            self._finish_line()
        if self._sent or not self._queue:
            return
        line = self._queue[0].pop(0)
        if not self._queue[0]:
            self._queue.popleft()
        self._sent.append(line)
        if dwell := _DWELL.fullmatch(line):
            self._dwell_end_s = self.clock.now_s() + float(dwell[1])
        else:
            self._write(self._speech.encode(line))

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
def machine_link(port: str, dialect: Dialect) -> Iterator[MachineLink]:
    """The machine on a port, PORT or PORT@BAUD.

    Raises
    ------
    InputError
        The port cannot be opened.
    """
    from serial import Serial, SerialException

    try:
        name, _, baud = port.partition("@")
        line = Serial(name, int(baud or dialect.baud), timeout=0, write_timeout=1, exclusive=True)
    except (SerialException, ValueError, OSError) as error:
        raise InputError(f"cannot open {port}: {error}. Give the machine's --port") from None
    with line:
        yield MachineLink(line, port, dialect=dialect)


def until(
    link: MachineLink,
    tick: Callable[[], None],
    met: Callable[[], bool],
    what: str,
    patience_s: float,
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

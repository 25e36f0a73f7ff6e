"""Board, load cell and machine heard side by side: frames recorded, forces and positions watched."""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np

from design.errors import InputError
from estimator.recordings.boards.growing import GrowingRecording
from estimator.recordings.boards.lines import Frame, Header, LineDecoder, Load
from estimator.recordings.boards.link import BoardClock
from instobj.rig.grbl import GrblLink, Listening, MachineFault
from instobj.rig.grbl_lines import State

ASIDE_MM = 0.1
BELOW_MM = 0.05
_NAP_S = 0.001
_ASK_S = 0.05
_RECENT = 200
_GAP_S = 1.0


class ForceBeyondLimit(InputError):
    """The load cell says more than it may."""


class Silence(InputError):
    """Board or load cell no longer speak."""


@dataclass(frozen=True)
class Spot:
    """Where the tips are or will press: face, place and tips on it (mm), the machine's X and Y."""

    face: int
    tips_mm: tuple[tuple[float, float], ...]
    machine_mm: tuple[float, float]


@dataclass
class LoadCell:
    """Forces of the one load cell, counted from its tare (N), with the times of their readings (s)."""

    tare_n: float = 0.0
    tared: bool = False
    readings: int = 0
    heard_s: float = 0.0
    recent_n: deque[float] = field(default_factory=lambda: deque(maxlen=_RECENT))
    times_s: deque[float] = field(default_factory=lambda: deque(maxlen=_RECENT))

    @property
    def force_n(self) -> float:
        return self.recent_n[-1] - self.tare_n if self.recent_n else float("nan")

    def take(self, force_n: float, time_s: float) -> None:
        """One reading, tare included."""
        self.recent_n.append(force_n)
        self.times_s.append(time_s)
        self.readings += 1

    def mean_n(self, readings: int) -> float:
        """Mean of the last readings, with the tare."""
        return float(np.mean(list(self.recent_n)[-readings:]))

    def force_at(self, time_s: float) -> float | None:
        """Force between the readings before and after a time (N): None until there is one after, NaN
        where they are more than a second apart."""
        if not self.times_s or self.times_s[-1] < time_s:
            return None
        after = next(k for k, reading_s in enumerate(self.times_s) if reading_s >= time_s)
        before = max(after - 1, 0)
        if self.times_s[after] - min(self.times_s[before], time_s) > _GAP_S:
            return float("nan")
        return float(np.interp(time_s, self.times_s, self.recent_n)) - self.tare_n


@dataclass
class _Row:
    """A frame that waits for the machine's position and for the load cell."""

    time_s: float
    signals: list[float]
    label: list[float]
    travel_mm: float | None = None
    force_n: float | None = None


@dataclass
class Station:
    """All that a run listens to.

    The tip may be anywhere at or above `safe_mm`, and below only at `spot`, down to `lowest_mm`
    (machine's Z): reports of other positions stop the feed. `watching` is False while the machine is
    brought to a stop, when nothing may stand in the way of that. Rows wait for the machine's next
    report and the load cell's next reading, so that every frame has its travel below `surface_mm` and
    its force; those that the load cell left without are counted, not written.
    """

    machine: GrblLink
    board: Iterator[bytes] | None
    loads: Iterator[list[float]] | None
    limit_n: float
    lost_s: float
    safe_mm: float = 0.0
    lowest_mm: float = 0.0
    surface_mm: float = float("nan")
    spot: Spot | None = None
    resting: bool = False
    recording: bool = False
    watching: bool = True
    stopped: bool = False
    growing: GrowingRecording | None = None
    channels: tuple[str, ...] = ()
    frames: int = 0
    frame_ms: int = 0
    without_force: int = 0
    cell: LoadCell = field(default_factory=LoadCell)
    decoder: LineDecoder = field(default_factory=LineDecoder)
    clock: BoardClock = field(default_factory=BoardClock)
    _rows: deque[_Row] = field(default_factory=deque)
    _states: int = 0
    _board_s: float = 0.0
    _state_s: float = 0.0
    _asked_s: float = 0.0
    _listening: Listening = field(init=False)

    def __post_init__(self) -> None:
        self._listening = Listening(self.lost_s)

    def stop(self) -> None:
        """End as if a fault had come."""
        self.stopped = True

    def tick(self) -> None:
        """Take in what came from all three lines.

        Raises
        ------
        InputError
            A force beyond the limit (the feed is stopped already), a line that broke off or is silent,
            a machine that faults or is where it may not be, or Ctrl-C.
        """
        self._listening.look()
        self._take_machine()  # reports that waited here are older than the frames that come now
        came = self._take_board() + self._take_loads()
        self._take_machine()
        if self.watching:
            self._watch()
        now_s = time.monotonic()
        if now_s - self._asked_s > _ASK_S:
            self._ask(now_s)
        if not came:
            time.sleep(_NAP_S)

    def expect(self) -> None:
        """Count silence from now on."""
        self._board_s = self.cell.heard_s = self._state_s = self._listening.now_s

    @property
    def waiting(self) -> bool:
        """Whether rows wait for their travel or their force."""
        return bool(self._rows)

    def close_rows(self) -> None:
        """Write rows whose travel never came without it; count those without a force."""
        known = [row for row in self._rows if row.force_n is not None]
        self.without_force += len(self._rows) - len(known)
        for row in known:
            row.travel_mm = float("nan") if row.travel_mm is None else row.travel_mm
        self._rows = deque(known)
        self._write_rows()

    def _ask(self, now_s: float) -> None:
        self._asked_s = now_s
        self.machine.ask()

    def _take_board(self) -> int:
        messages = self.decoder.feed(self._heard(self.board))
        for message in messages:
            if isinstance(message, Load) and self.loads is None and message.cell == 1:
                self._take_force(message.force_n, message.board_ms / 1000)
            elif isinstance(message, Header):
                self._take_header(message)
            elif isinstance(message, Frame):
                self._take_frame(message)
        return len(messages)

    def _heard(self, chunks: Iterator[bytes] | None) -> bytes:
        try:
            return b"" if chunks is None else next(chunks)
        except InputError:
            self.board = None
            if self.watching:
                raise
            return b""

    def _take_loads(self) -> int:
        try:
            forces = [] if self.loads is None else next(self.loads)
        except InputError:
            self.loads = iter(lambda: [], None)
            if self.watching:
                raise
            return 0
        for force_n in forces:
            self._take_force(force_n, time.monotonic())
        return len(forces)

    def _take_force(self, force_n: float, time_s: float) -> None:
        self.cell.take(force_n, time_s)
        self.cell.heard_s = self._listening.now_s
        self._label_rows()
        if self.watching and abs(self.cell.force_n) > self.limit_n:
            self.machine.hold()
            raise ForceBeyondLimit(
                f"the load cell says {self.cell.force_n:.2f} N, more than --limit {self.limit_n:g} N"
            )

    def _take_header(self, header: Header) -> None:
        if self.channels and header.channels != self.channels:
            raise InputError("the board names other channels than before. Was it exchanged?")
        self.channels = header.channels

    def _take_frame(self, frame: Frame) -> None:
        self.frames, self.frame_ms = self.frames + 1, frame.board_ms
        self._board_s, heard_s = self._listening.now_s, time.monotonic()
        self._ask(heard_s)
        if not self.recording or self.growing is None or self.spot is None:
            return
        time_s = self.clock.time_s(frame.board_ms, time.time())
        tips = [value for tip in self.spot.tips_mm for value in tip]
        head = [time_s, float(self.growing.session), float(self.resting)]
        at_s = frame.board_ms / 1000 if self.loads is None else heard_s
        label = [float(self.spot.face), *tips]
        self._rows.append(_Row(at_s, [*head, *frame.counts], label))
        self._label_rows()

    def _take_machine(self) -> None:
        self.machine.poll()
        state = self.machine.state
        if state is None or self.machine.states == self._states:
            return
        self._states, self._state_s = self.machine.states, self._listening.now_s
        for row in self._rows:
            if row.travel_mm is None:
                row.travel_mm = self.surface_mm - state.position_mm[2]
        self._write_rows()
        if self.watching and self.machine.trusted:
            self._require_allowed(state)

    def _label_rows(self) -> None:
        """Forces of the rows that wait for one."""
        for row in self._rows:
            row.force_n = self.cell.force_at(row.time_s) if row.force_n is None else row.force_n

    def _write_rows(self) -> None:
        while self._rows and self.growing is not None:
            row = self._rows[0]
            if row.travel_mm is None or row.force_n is None:
                return
            self._rows.popleft()
            if np.isnan(row.force_n):
                self.without_force += 1
                continue
            last = [round(row.force_n, 4), *row.label, round(row.travel_mm, 4)]
            self.growing.append([*row.signals, *last])

    def _require_allowed(self, state: State) -> None:
        x, y, z = state.position_mm
        if z >= self.safe_mm - BELOW_MM:
            return
        at = (np.inf, np.inf) if self.spot is None else self.spot.machine_mm
        aside_mm = float(np.hypot(x - at[0], y - at[1]))
        if aside_mm > ASIDE_MM or z < self.lowest_mm - BELOW_MM:
            self.machine.hold()
            raise MachineFault(
                f"the tip is at ({x:g}, {y:g}, {z:g}) mm, where it was not sent. A character of a line "
                "may have been lost, or the machine was moved by others"
            )

    def _watch(self) -> None:
        now_s = self._listening.now_s
        if self.stopped:
            raise InputError("stopped by the user")
        heard = {"board": self._board_s, "load cell": self.cell.heard_s}
        if self.machine.trusted:
            heard["machine"] = self._state_s
        for who, heard_s in heard.items():
            if heard_s and now_s - heard_s > self.lost_s:
                raise Silence(f"the {who} has said nothing for {self.lost_s:g} s. Check its cable")

"""Board, load cell and machine heard side by side: frames recorded, and whatever must stop the run."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np

from design.errors import InputError
from estimator.recordings.boards.growing import GrowingRecording
from estimator.recordings.boards.lines import Frame, Header, LineDecoder, Load
from estimator.recordings.boards.link import BoardClock
from instobj.bench.rig.clock import Listening
from instobj.bench.rig.load_cell import LoadCell
from instobj.bench.rig.machine import MachineFault, MachineLink
from instobj.bench.rig.phases import DOWNWARD, Phase, require_following
from instobj.bench.rig.replies import State
from instobj.bench.rig.rows import Rows
from instobj.bench.rig.stop import lift
from instobj.bench.rig.witnesses import Witnesses

ASIDE_MM = 0.1
BELOW_MM = 0.05
_NAP_S = 0.001
_ASK_S = 0.05
_LATE_S = 0.5
_MOST_CHUNKS = 1000
"""Thrown away after a stop: more than 30 s of a line at its fastest."""
_DEAF_MM = 1.0
"""Longest way down (mm) without a reading: twice what the tip does in a frame at the fastest strokes."""


class ForceBeyondLimit(InputError):
    """The load cell says more than it may."""


class Silence(InputError):
    """Board or load cell no longer speak."""


@dataclass(frozen=True)
class Spot:
    """Spot that the tips are or will press: face, place and tips on it (mm), the machine's X and Y.

    `lowest_mm` is the machine's Z below which nothing goes there, whatever any sensor says.
    """

    face: int
    tips_mm: tuple[tuple[float, float], ...]
    machine_mm: tuple[float, float]
    lowest_mm: float = -math.inf


@dataclass
class Station:
    """All that a run listens to, and the phase that it is in.

    The tip may be anywhere at or above `safe_mm`, and below only at `spot`, down to the machine's
    floor: reports of other positions stop the feed. While the machine is stopped and the tip lifted
    nothing but its own line is heard; what the others said meanwhile is thrown away.
    """

    machine: MachineLink
    board: Iterator[bytes] | None
    loads: Iterator[list[float]] | None
    limit_n: float
    lost_s: float
    witnesses: Witnesses
    phase: Phase = Phase.OFF
    safe_mm: float = 0.0
    surface_mm: float = float("nan")
    spot: Spot | None = None
    resting: bool = False
    recording: bool = False
    stopped: bool = False
    channels: tuple[str, ...] = ()
    frames: int = 0
    frame_ms: int = 0
    rows: Rows = field(default_factory=Rows)
    decoder: LineDecoder = field(default_factory=LineDecoder)
    clock: BoardClock = field(default_factory=BoardClock)
    _deaf_mm: dict[str, float] = field(default_factory=dict)
    _states: int = 0
    _board_s: float = 0.0
    _state_s: float = 0.0
    _asked_s: float = 0.0
    _listening: Listening = field(init=False)

    def __post_init__(self) -> None:
        self._listening = Listening(self.lost_s, self.machine.clock)

    @property
    def growing(self) -> GrowingRecording | None:
        """The recording, once it is open."""
        return self.rows.growing

    @property
    def cell(self) -> LoadCell | None:
        """The first witness of contact, where there is one."""
        return self.witnesses.cell

    @property
    def readings(self) -> int:
        """Readings of the load cell; frames where there is none."""
        return self.frames if self.cell is None else self.cell.readings

    @property
    def heard_s(self) -> float:
        """Time spent listening."""
        return self._listening.now_s

    @property
    def height_mm(self) -> float:
        """The tip's by the machine's last report, NaN before the first."""
        state = self.machine.state
        return float("nan") if state is None else state.position_mm[2]

    def stop(self) -> None:
        """End as if a fault had come."""
        self.stopped = True

    def enter(self, phase: Phase, floor_mm: float = math.inf) -> None:
        """Go on with something else, down to a height at most (machine's Z); without one no move is sent."""
        require_following(self.phase, phase)
        lowest_mm = -math.inf if self.spot is None else self.spot.lowest_mm
        self.phase, self.machine.floor_mm = phase, max(floor_mm, lowest_mm)
        self._deaf_mm = {}
        self.witnesses.begin()

    def raise_tip(self) -> float:
        """Stop the feed and lift the tip to the safe height; the height (mm) at which it was stopped.

        Raises
        ------
        MachineFault
            Where the tip is is not known.
        """
        self.enter(Phase.STOPPING, self.safe_mm)
        try:
            stopped_mm, interrupted = lift(self.machine, self.safe_mm)
        except BaseException:
            self.enter(Phase.LOST)
            raise
        self.stopped = self.stopped or interrupted
        self.enter(Phase.ABOVE, self.safe_mm)
        return stopped_mm

    def listen_again(self, stopped_mm: float) -> None:
        """Go on after the tip was lifted. Rows that waited have the travel at which it was stopped; what
        board and load cell said meanwhile is thrown away, because its place is not known."""
        self.rows.travelled(self.surface_mm - stopped_mm)
        self.rows.close()
        for _ in range(_MOST_CHUNKS):
            if self.board is None or not next(self.board):
                break
        for _ in range(_MOST_CHUNKS):
            if self.loads is None or not next(self.loads):
                break
        self.witnesses.chips.forget()
        self.expect()

    def tick(self) -> None:
        """Take in what came from all three lines.

        Raises
        ------
        InputError
            A force beyond the limit (the feed is stopped already), readings that are none, witnesses of
            contact that differ, a line that broke off or is silent, a machine that faults or is where
            it may not be, or Ctrl-C.
        """
        self._listening.look()
        self._take_machine()  # reports that waited here are older than the frames that come now
        came = self._take_board() + self._take_loads()
        self._take_machine()
        self._watch()
        now_s = self.machine.clock.now_s()
        if now_s - self._asked_s > _ASK_S:
            self._ask(now_s)
        if not came:
            self.machine.clock.nap(_NAP_S)

    def expect(self) -> None:
        """Count silence from now on."""
        self._board_s = self._state_s = self._listening.now_s
        if self.cell is not None:
            self.cell.heard_s = self._listening.now_s

    def _ask(self, now_s: float) -> None:
        self._asked_s = now_s
        self.machine.ask()

    def _take_board(self) -> int:
        messages = [] if self.board is None else self.decoder.feed(next(self.board))
        for message in messages:
            if isinstance(message, Load) and self.loads is None and message.cell == 1:
                self._take_load(message, self._only_cell())
            elif isinstance(message, Header):
                self._take_header(message)
            elif isinstance(message, Frame):
                self._take_frame(message)
        return len(messages)

    def _take_loads(self) -> int:
        forces = [] if self.loads is None else next(self.loads)
        for force_n in forces:
            self._take_force(force_n, self.machine.clock.now_s(), self._only_cell())
        return len(forces)

    def _only_cell(self) -> LoadCell:
        if self.cell is None:
            raise InputError(
                "the board sends forces of a load cell. Leave --load-port none out: a force can stop a press"
            )
        return self.cell

    def _take_load(self, load: Load, cell: LoadCell) -> None:
        late_s = (self.frame_ms - load.board_ms) / 1000
        if self.phase in DOWNWARD and _LATE_S < late_s < self.lost_s + _LATE_S:
            raise Silence(
                f"the load cell's readings are {late_s:.1f} s older than the frames beside them. A force "
                "that comes late cannot stop a press; read the cell faster"
            )
        self._take_force(load.force_n, load.board_ms / 1000, cell)

    def _take_force(self, force_n: float, time_s: float, cell: LoadCell) -> None:
        cell.take(force_n, time_s)
        cell.heard_s = self._listening.now_s
        self._deaf_mm["load cell"] = self.height_mm
        self.rows.loaded(cell)
        if cell.tared and abs(cell.force_n) > self.limit_n:
            self.machine.hold()
            raise ForceBeyondLimit(
                f"the load cell says {cell.force_n:.2f} N, more than the limit of {self.limit_n:.3g} N"
            )

    def _take_header(self, header: Header) -> None:
        if self.channels and header.channels != self.channels:
            raise InputError("the board names other channels than before. Was it exchanged?")
        self.channels = header.channels

    def _take_frame(self, frame: Frame) -> None:
        self.witnesses.chips.take(frame.counts, frame.board_ms)
        self.frames, self.frame_ms = self.frames + 1, frame.board_ms
        self._board_s, heard_s = self._listening.now_s, self.machine.clock.now_s()
        self._ask(heard_s)
        self._deaf_mm["board"] = self.height_mm
        self.witnesses.take_frame(self.height_mm, self.surface_mm, self._board_s)
        if not self.recording or self.growing is None or self.spot is None:
            return
        time_s = self.clock.time_s(frame.board_ms, self.machine.clock.epoch_s())
        tips = [value for tip in self.spot.tips_mm for value in tip]
        head = [time_s, float(self.growing.session), float(self.resting)]
        at_s = frame.board_ms / 1000 if self.loads is None else heard_s
        self.rows.add(at_s, [*head, *frame.counts], [float(self.spot.face), *tips])
        if self.cell is not None:
            self.rows.loaded(self.cell)

    def _take_machine(self) -> None:
        self.machine.poll()
        state = self.machine.state
        if state is None or self.machine.states == self._states:
            return
        self._states, self._state_s = self.machine.states, self._listening.now_s
        self.rows.travelled(self.surface_mm - state.position_mm[2])
        if self.machine.trusted:
            self._require_allowed(state)

    def _require_allowed(self, state: State) -> None:
        x, y, z = state.position_mm
        if z >= self.safe_mm - BELOW_MM:
            return
        spot_mm = (np.inf, np.inf) if self.spot is None else self.spot.machine_mm
        aside_mm = float(np.hypot(x - spot_mm[0], y - spot_mm[1]))
        if aside_mm > ASIDE_MM or z < self.machine.floor_mm - BELOW_MM:
            self.machine.hold()
            raise MachineFault(
                f"the tip is at ({x:g}, {y:g}, {z:g}) mm, where it was not sent. A character of a line "
                "may have been lost, or the machine was moved by others"
            )

    def _watch(self) -> None:
        if self.stopped:
            raise InputError("stopped by the user")
        heard = {"board": self._board_s}
        if self.cell is not None:
            heard["load cell"] = self.cell.heard_s
        if self.machine.trusted:
            heard["machine"] = self._state_s
        for who, heard_s in heard.items():
            if heard_s and self.heard_s - heard_s > self.lost_s:
                raise Silence(f"the {who} has said nothing for {self.lost_s:g} s. Check its cable")
        if self.cell is not None and self.cell.tared:
            self.cell.require_alive(self.height_mm, self.witnesses.touch_n)
        if self.phase in DOWNWARD:
            self._require_heard_on_the_way()
            self.witnesses.require_agreement(self.surface_mm - self.height_mm)
        if self.phase is Phase.NEARING:
            self.witnesses.require_clear(self.height_mm - self.surface_mm, self.heard_s)

    def _require_heard_on_the_way(self) -> None:
        """Stop a tip that goes on below the surface while nobody knows what it meets."""
        for who, from_mm in self._deaf_mm.items():
            if min(from_mm, self.surface_mm) - self.height_mm > _DEAF_MM:
                raise Silence(
                    f"the {who} has said nothing for {_DEAF_MM:g} mm of the way down. Check its cable"
                )

r"""Lines of text, with a checksum, that boards with Hall sensors, load cells or machines send.

Each line is `$` body `*` CRC `\n`, where CRC is CRC-16/CCITT-FALSE of the body in four hexadecimal
digits. Bodies, comma-separated:

- `H,1,F1-X1,F1-Y1,…`  format version and the channels of the frames that follow, in their order; those of
  an IMU are named `acceleration_x_m_s2` … `rate_z_rad_s`
- `F,sequence,ms,v1,v2,…`  one reading of all channels (raw counts, empty where a sensor is silent);
  the sequence counts frames modulo 65536, ms is the board's clock modulo 2³²
- `L,ms,cell,force_n,face,x1_mm,y1_mm,…`  load cell (1…9), its normal force in N, and where it
  presses: face and places of its tips, or nothing after the force where nobody knows
- `S,ms,supply_mv,supply_errors,bus_errors,bus_recoveries,start,t1,t2,…`  how the board is: its supply
  (empty where it is not measured), how often a sensor saw too low a supply, transfers that failed,
  times that a hung bus was freed, why the board started last (power, reset, brownout, watchdog), and the
  temperature of every sensor in °C (in the header's order, empty where it is silent). Boards need not
  send it; readers that do not know it count it as damaged

Everything else on the line is skipped and counted: after garbage the next `$` starts again.
"""

from __future__ import annotations

from binascii import crc_hqx
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from statistics import median

from design.catalogue.bus_parts import MOTION
from design.errors import InputError
from estimator.recordings.formats.generic import CHANNEL, cell_text
from estimator.recordings.table import LARGEST_COUNT, LARGEST_FORCE_N, LARGEST_PLACE_MM, MOST_FACES

FORMAT_VERSION = 1
_SEQUENCES = 65536
_RESTART_GAP = 10_000
"""A larger step of the sequence is a board that started again, not lost frames."""
_LONGEST_LINE = 4096
"""Characters without an end of line after which they are dropped."""


@dataclass(frozen=True)
class Header:
    """Channels of the frames that follow."""

    channels: tuple[str, ...]


@dataclass(frozen=True)
class Frame:
    """One reading of all channels: raw counts, NaN where a sensor is silent."""

    sequence: int
    board_ms: int
    counts: tuple[float, ...]


@dataclass(frozen=True)
class Load:
    """Force that a load cell holds, and where its tips press (`face` None where the line says nothing)."""

    board_ms: int
    cell: int
    force_n: float
    face: int | None
    tips_mm: tuple[tuple[float, float], ...]


@dataclass(frozen=True)
class Status:
    """State of the board: supply (None: not measured), counts since its start, why it started, and the
    temperature of every sensor (°C, NaN where it is silent)."""

    board_ms: int
    supply_mv: int | None
    supply_errors: int
    bus_errors: int
    bus_recoveries: int
    start: str
    sensors_c: tuple[float, ...]


Message = Header | Frame | Load | Status
STARTS = ("power", "reset", "brownout", "watchdog")
_LARGEST_MV, _LARGEST_C = 60_000, 300.0
"""Largest supply (mV) and temperature (°C) that a sound line may tell."""


@dataclass
class LineStatistics:
    """Statistics of a line: frames, damaged lines, frames lost (gaps of the sequence), restarts, and
    readings of chips whose counts had wrapped round beyond their range: those left out, those undone."""

    frames: int = 0
    damaged_lines: int = 0
    lost_frames: int = 0
    restarts: int = 0
    wrapped_readings: int = 0
    unwrapped_readings: int = 0

    @property
    def wrapped_text(self) -> str:
        """In words, empty where no counts wrapped."""
        if not self.wrapped_readings + self.unwrapped_readings:
            return ""
        return _WRAPPED.format(self.unwrapped_readings, self.wrapped_readings)


_WRAPPED = (
    "counts wrapped round beyond the chip's range: {} readings undone, {} left out. Choose a wider "
    "sensors.range_mt, or more room between magnet and chip"
)
WRAP_COUNTS, END_COUNTS = 49_152, 32_768
"""Three quarters of 16 bits: from one end of a chip's scale to the other between two frames. A chip that
saturates stays at an end; an MLX90393 goes on at the other one (esphome#7635)."""
TURN_COUNTS = 2 * END_COUNTS
"""Counts of a whole turn: added or taken off once a wrap is undone."""
FASTEST_COUNTS_PER_S = 100_000.0
"""Bound of a channel's change: a magnet's field of 120 mT/s at 820 counts/mT, beyond what presses make."""
SMOOTH_COUNTS = 4096.0
"""Median change of the other channels up to which a frame goes on from the one before."""


def may_undo(step: float, elapsed_s: float, others_step: float) -> bool:
    """Return whether a jump of `step` counts is surely one turn: without the turn the change stays within
    the bound of rate × time, which is too short for half a turn more, and other channels move smoothly."""
    bound = FASTEST_COUNTS_PER_S * elapsed_s
    return TURN_COUNTS - abs(step) <= bound <= END_COUNTS and others_step <= SMOOTH_COUNTS


@dataclass
class LineDecoder:
    """Bytes to messages; keeps the unfinished line and the statistics."""

    statistics: LineStatistics = field(default_factory=LineStatistics)
    _rest: bytes = b""
    _channels: int | None = None
    _sensors: int | None = None
    _sequence: int | None = None
    _last: list[float] = field(default_factory=list)
    _last_ms: list[int] = field(default_factory=list)
    _turns: list[int] = field(default_factory=list)
    _doubted: list[bool] = field(default_factory=list)

    def feed(self, data: bytes) -> list[Message]:
        """Messages completed by `data`; frames before the first header are skipped.

        Raises
        ------
        InputError
            A sound line of another format version, or a header that names no known channel.
        """
        *lines, self._rest = (self._rest + data).split(b"\n")
        if len(self._rest) > _LONGEST_LINE:
            self._rest = b""
            self.statistics.damaged_lines += 1
        messages = [self._message(line) for line in lines]
        return [message for message in messages if message is not None]

    def _message(self, line: bytes) -> Message | None:
        if not line.strip():
            return None
        body = _body(line)
        message = None if body is None else _parsed(body)
        if isinstance(message, Header):
            self._channels = len(message.channels)
            sensed = filter(CHANNEL.fullmatch, message.channels)
            self._sensors = len({(name[1], name[4:]) for name in sensed})
        elif isinstance(message, Frame):
            if self._channels is None:
                return None
            message = message if len(message.counts) == self._channels else None
        elif isinstance(message, Status) and len(message.sensors_c) != (self._sensors or 0):
            message = None
        if message is None:
            self.statistics.damaged_lines += 1
        elif isinstance(message, Frame):
            self._count(message.sequence)
            return self._unwrapped(message)
        return message

    def _unwrapped(self, frame: Frame) -> Frame:
        """Undo turns of channels that left their range by one end and came in by the other; NaN for those
        that may have turned otherwise, until they go back."""
        if len(self._last) != len(frame.counts):
            self._last, self._turns = list(frame.counts), [0] * len(frame.counts)
            self._last_ms = [frame.board_ms] * len(frame.counts)
            self._doubted = [False] * len(frame.counts)
        others_step = self._median_step(frame)
        for k, value in enumerate(frame.counts):
            if value != value:
                continue
            # Chips of more bits have no end there.
            sixteen = max(abs(value), abs(self._last[k])) <= END_COUNTS
            step = value - self._last[k] if sixteen else 0.0
            elapsed_s = (frame.board_ms - self._last_ms[k]) / 1000
            turn = (step < -WRAP_COUNTS) - (step > WRAP_COUNTS)
            if turn and not may_undo(step, elapsed_s, others_step):
                self._doubted[k] = True
            # Unseen for longer than half a turn may take, a turned channel may have come back.
            late = FASTEST_COUNTS_PER_S * elapsed_s > END_COUNTS
            self._doubted[k] |= bool(self._turns[k]) and late
            self._turns[k] += turn
            self._doubted[k] &= bool(self._turns[k])
            self._last[k], self._last_ms[k] = value, frame.board_ms
        if not any(self._turns):
            return frame
        return replace(
            frame, counts=tuple(map(self._undone, range(len(frame.counts)), frame.counts))
        )

    def _undone(self, channel: int, value: float) -> float:
        """Return a channel's count without its turns, NaN where those are in doubt."""
        if not self._turns[channel] or value != value:
            return value
        if self._doubted[channel]:
            self.statistics.wrapped_readings += 1
            return float("nan")
        self.statistics.unwrapped_readings += 1
        return value + TURN_COUNTS * self._turns[channel]

    def _median_step(self, frame: Frame) -> float:
        """Median change of the channels that did not jump; none is infinite."""
        steps = [abs(value - last) for value, last in zip(frame.counts, self._last, strict=True)]
        calm = [step for step in steps if step <= WRAP_COUNTS]
        return median(calm) if calm else float("inf")

    def _count(self, sequence: int) -> None:
        last_sequence, self._sequence = self._sequence, sequence
        self.statistics.frames += 1
        if last_sequence is None:
            return
        gap = (sequence - last_sequence - 1) % _SEQUENCES
        if gap > _RESTART_GAP:
            self.statistics.restarts += 1
            self._last = []
        else:
            self.statistics.lost_frames += gap


def encode_header(channels: Sequence[str]) -> bytes:
    """Line that names the channels."""
    return _line(f"H,{FORMAT_VERSION},{','.join(channels)}")


def encode_frame(sequence: int, board_ms: int, counts: Sequence[float]) -> bytes:
    """Line of one reading; NaN becomes an empty cell."""
    cells = ",".join(cell_text(float(value)) for value in counts)
    return _line(f"F,{sequence % _SEQUENCES},{board_ms % 2**32},{cells}")


def encode_load(load: Load) -> bytes:
    """Line of one load cell."""
    place = (
        [] if load.face is None else [str(load.face), *(f"{v:g}" for t in load.tips_mm for v in t)]
    )
    cells = [str(load.board_ms % 2**32), str(load.cell), f"{load.force_n:.4f}", *place]
    return _line(f"L,{','.join(cells)}")


def checksum(body: bytes) -> str:
    """CRC-16/CCITT-FALSE (polynomial 0x1021, start 0xFFFF) in four hexadecimal digits."""
    return f"{crc_hqx(body, 0xFFFF):04X}"


def _line(body: str) -> bytes:
    return f"${body}*{checksum(body.encode())}\n".encode()


def _body(line: bytes) -> str | None:
    """Return what stands between the last `$` and `*`, if its checksum is right."""
    body, star, crc = line.rstrip(b"\r")[line.rfind(b"$") + 1 :].partition(b"*")
    if not star or b"$" not in line or crc.decode("ascii", "replace").upper() != checksum(body):
        return None
    try:
        return body.decode("ascii")
    except UnicodeDecodeError:
        return None


def _parsed(body: str) -> Message | None:
    kind, *cells = body.split(",")
    if kind == "H":
        return _header(cells)
    if "_" in body:  # Python takes 1_0 for a number
        return None
    try:
        return _PARSERS[kind](cells)
    except (KeyError, ValueError, IndexError):
        return None


def _header(cells: list[str]) -> Header:
    if not cells or cells[0] != str(FORMAT_VERSION):
        raise InputError(
            f"the board speaks line format {cells[:1]}, this is version {FORMAT_VERSION}. See "
            "`instobj docs recordings`"
        )
    channels = tuple(cells[1:])
    # An IMU's six stand behind all others, so that readers can cut them off.
    halls = channels[: -len(MOTION)] if channels[-len(MOTION) :] == MOTION else channels
    wrong = [name for name in halls if not CHANNEL.fullmatch(name)]
    if wrong or not halls or len(set(channels)) < len(channels):
        raise InputError(
            f"the board names channels {wrong[:5] or list(channels)[:5]}. Each must be named once, "
            "F1-X1 and so on: face, axis, number of the sensor; an IMU's six columns come last"
        )
    return Header(channels)


def _frame(cells: list[str]) -> Frame | None:
    counts = tuple(float(cell) if cell else float("nan") for cell in cells[2:])
    if not all(abs(value) <= LARGEST_COUNT for value in counts if value == value):
        return None
    return Frame(int(cells[0]), int(cells[1]), counts)


def _load(cells: list[str]) -> Load | None:
    ms, cell, force_n = int(cells[0]), int(cells[1]), float(cells[2])
    if not 1 <= cell <= 9 or not abs(force_n) <= LARGEST_FORCE_N:
        return None
    if len(cells) == 3 or not cells[3]:
        return Load(ms, cell, force_n, None, ())
    face, values = int(cells[3]), [float(value) for value in cells[4:]]
    sound = all(abs(value) <= LARGEST_PLACE_MM for value in values)
    if (
        face not in range(1 + MOST_FACES)
        or len(values) % 2
        or not sound
        or (face > 0) != bool(values)
    ):
        return None
    return Load(ms, cell, force_n, face, tuple(zip(values[::2], values[1::2], strict=True)))


def _status(cells: list[str]) -> Status | None:
    supply = int(cells[1]) if cells[1] else None
    supply_errors, bus_errors, recoveries = (int(cell) for cell in cells[2:5])
    celsius = tuple(float(cell) if cell else float("nan") for cell in cells[6:])
    sound = all(abs(value) <= _LARGEST_C for value in celsius if value == value)
    least = min(supply_errors, bus_errors, recoveries)
    if cells[5] not in STARTS or not 0 <= (supply or 0) <= _LARGEST_MV or least < 0:
        return None
    if not sound:
        return None
    return Status(int(cells[0]), supply, supply_errors, bus_errors, recoveries, cells[5], celsius)


_PARSERS = {"F": _frame, "L": _load, "S": _status}

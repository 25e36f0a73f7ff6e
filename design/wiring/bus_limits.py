"""Limits of an I²C bus: capacitance, pull-up resistors and the time of a frame (NXP UM10204)."""

from __future__ import annotations

from dataclasses import dataclass, replace

from design.catalogue.bus_parts import (
    IMU_READ_BYTES,
    MOTION,
    SELECT_BYTES,
    Board,
    BusChip,
    frame_ms,
)
from design.spec.sensors import BUS_KHZ

_SINK_MA = 3.0
_LOW_V = 0.4
_RISE = 0.8473
"""tr = 0.8473 R C between 30 and 70 % of the supply (UM10204, section 7.1)."""
_E12 = (1.0, 1.2, 1.5, 1.8, 2.2, 2.7, 3.3, 3.9, 4.7, 5.6, 6.8, 8.2)
"""Values of a decade of the E12 series of resistors (IEC 60063)."""
_LARGEST_PF = 400.0
"""Largest capacitance of a bus in I²C's standard and fast modes (NXP UM10204)."""
STANDARD_KHZ, FAST_KHZ = 100.0, BUS_KHZ
"""Clocks of I²C's standard mode and of the bus as it is used."""


def rise_time_ns(khz: float) -> float:
    """Longest rise time of standard (100 kHz) and fast mode (400 kHz)."""
    return 1000.0 if khz <= STANDARD_KHZ else 300.0


def _smallest_pullup_kohm(supply_v: float) -> float:
    return (supply_v - _LOW_V) / _SINK_MA


def largest_capacitance_pf(khz: float, supply_v: float) -> float:
    """Capacitance of a line whose pull-up is as small as chips that sink 3 mA allow, 400 pF at most."""
    by_rise = rise_time_ns(khz) / (_RISE * _smallest_pullup_kohm(supply_v))
    return min(_LARGEST_PF, by_rise)


def pullup_kohm(khz: float, supply_v: float, capacitance_pf: float) -> float | None:
    """Largest pull-up of the E12 series with which the line rises in time; None where there is none."""
    most = rise_time_ns(khz) / (_RISE * capacitance_pf)
    least = _smallest_pullup_kohm(supply_v)
    return max((r for r in _E12 if least <= r <= most), default=None)


@dataclass(frozen=True)
class FrameTime:
    """Time of a frame by its parts (ms), and the fastest rate (Hz) with a status line a second and
    the lines of a load cell (`loads_ms`, a second)."""

    conversion_ms: float
    reading_ms: float
    line_ms: float
    status_ms: float
    loads_ms: float = 0.0

    @property
    def fastest_hz(self) -> float:
        each_ms = frame_ms(self.conversion_ms, self.reading_ms + self.line_ms)
        return max(0.0, 1e3 - self.status_ms - self.loads_ms) / each_ms


def frame_time(
    board: Board,
    chip: BusChip,
    averaging: int,
    khz: float,
    baud: int,
    reads: int,
    selects: int,
    axes: int,
) -> FrameTime:
    """Time of a frame of `reads` chips with `selects` changes of a multiplexer's channel.

    Chips convert by themselves all the time; the board reads one after the other and writes the line,
    counted at its longest (six characters and a comma per channel).
    """
    transfers = reads + selects
    bits = 9 * (chip.read_bytes * reads + SELECT_BYTES * selects) + 3 * transfers
    reading = bits / khz + 1e-3 * board.call_us * transfers
    character = _character_ms(board, baud)
    line = character * (26 + 7 * axes * reads)
    status = character * (50 + 6 * reads)
    return FrameTime(chip.conversion_ms(averaging), reading, line, status)


def with_imu(time: FrameTime, board: Board, khz: float, baud: int) -> FrameTime:
    """Add the reading of an IMU to a frame, and its cells of nine characters at most (`-156.905,`)."""
    reading = (9 * IMU_READ_BYTES + 3) / khz + 1e-3 * board.call_us
    line = 9 * len(MOTION) * _character_ms(board, baud)
    return replace(time, reading_ms=time.reading_ms + reading, line_ms=time.line_ms + line)


def _character_ms(board: Board, baud: int) -> float:
    """Time to send a character, of ten bits."""
    return max(board.byte_us * 1e-3, 0.0 if board.usb else 1e4 / baud)

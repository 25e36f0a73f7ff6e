"""The load cell on the reading board: pins, lines per second, wires, parts, and newtons per step."""

from __future__ import annotations

from dataclasses import dataclass

from design.catalogue.bus_parts import MEGA2560, Board
from design.catalogue.orders import BTA_ADAPTER, HX711, LOAD_CELL, RESISTOR, VERNIER
from design.errors import InputError
from design.spec.load_cell import SUPPLY_V, LoadCellSpec

LINE_CHARACTERS = 28
"""Length of a line `L` with a clock of nine digits and a force of three: $L,170300123,1,-99.9999*FFFF."""
LINES_HZ = {"hx711": 80.0, "analog": 40.0}
"""Most lines a second: an HX711's fast rate, and the mean of at least 25 ms of a voltage."""
HX711_STEPS_PER_V_PER_V = 128 * 2**24
"""Steps of an HX711 at gain 128 by bridge output over supply: ±2²³ are ±0.5 / 128."""
DIVIDER_KOHM = (10.0, 15.0)
"""From the sensor to the pin, and from the pin to ground: 5 V become 3 V."""
_HX711_SUPPLY_MA = 6.5
"""1.5 mA of the chip and 5 mA of a bridge of 1 kΩ at 5 V."""


@dataclass(frozen=True)
class LoadCellPlan:
    """A load cell on its pins, with the most lines `L` a second."""

    kind: str
    pins: tuple[str, ...]
    lines_hz: float

    @property
    def title(self) -> str:
        """Return what is read, where."""
        if self.kind == "hx711":
            return f"HX711 with data on {self.pins[0]} and clock on {self.pins[1]}"
        return f"force sensor with a voltage on {self.pins[0]}"

    def seconds_a_second(self, board: Board, baud: int) -> float:
        """Share of the board's time that its lines take."""
        character_us = max(board.byte_us, 0.0 if board.usb else 1e7 / baud)
        return 1e-6 * self.lines_hz * (board.load_line_us + LINE_CHARACTERS * character_us)

    @property
    def rail_ma(self) -> float:
        """Drawn from a 3.3 V pin where that supplies it."""
        return _HX711_SUPPLY_MA if self.kind == "hx711" else 0.0

    def parts(self, board: Board) -> tuple[tuple[str, int], ...]:
        """Return what is bought for it."""
        if self.kind == "hx711":
            return ((HX711, 1), (LOAD_CELL, 1))
        divider = ((RESISTOR, 2),) if board.adc[2] < 1 else ()
        return ((VERNIER, 1), (BTA_ADAPTER, 1), *divider)

    def wires(self, board: Board) -> list[tuple[str, str, str]]:
        """Start, end and signal of its wires, in the order of soldering."""
        if self.kind == "hx711":
            supply = "board 5V" if board.logic_v > 4 else "strip 3V3"
            cell = (("red", "E+"), ("black", "E-"), ("white", "A-"), ("green", "A+"))
            return [
                *((f"load cell {colour}", f"HX711 {pad}", pad) for colour, pad in cell),
                ("HX711 VCC", supply, "VCC"),
                ("HX711 GND", "strip GND", "GND"),
                ("HX711 DT", f"board {self.pins[0]}", "SDA"),
                ("HX711 SCK", f"board {self.pins[1]}", "SCL"),
            ]
        ends = [
            ("force sensor 5V", "board 5V" if board is MEGA2560 else "board VBUS", "VCC"),
            ("force sensor GND", "strip GND", "GND"),
        ]
        if board.adc[2] == 1:
            return [*ends, ("force sensor SIG1", f"board {self.pins[0]}", "SDA")]
        through = f"strip divider {DIVIDER_KOHM[0]:g}k / {DIVIDER_KOHM[1]:g}k to GND"
        return [
            *ends,
            ("force sensor SIG1", through, "SDA"),
            (through, f"board {self.pins[0]}", "SDA"),
        ]


def load_cell_plan(cell: LoadCellSpec, board: Board) -> LoadCellPlan | None:
    """The load cell of a specification on a board; None where there is none.

    Raises
    ------
    InputError
        Pins that the board does not have for it, or one pin for two things.
    """
    if cell.kind == "none":
        return None
    room = board.load_pins if cell.kind == "hx711" else board.analog_pins
    if not room:
        raise InputError(
            f"load_cell.kind = {cell.kind!r}: {board.title} has no pin for it. Take "
            'load_cell.kind = "hx711", or another --board'
        )
    pins = cell.pins or room[: 2 if cell.kind == "hx711" else 1]
    wrong = [pin for pin in pins if pin not in room]
    if wrong or len(set(pins)) < len(pins):
        raise InputError(
            f"load_cell.pins = {list(pins)}: {cell.kind} on {board.title} takes different pins of "
            f"{', '.join(room)}. Leave load_cell.pins out for {', '.join(room[: len(pins)])}"
        )
    return LoadCellPlan(cell.kind, tuple(pins), LINES_HZ[cell.kind])


def newtons_per_step(cell: LoadCellSpec, board: Board) -> float:
    """Newtons of an HX711's count, or of a step of the board's converter."""
    if cell.kind == "hx711":
        return cell.newtons_per_unit / (1e-3 * HX711_STEPS_PER_V_PER_V)
    full_v, steps, share = board.adc
    return cell.newtons_per_unit * full_v / steps / share


def zero_steps(cell: LoadCellSpec, board: Board) -> float:
    """Steps at no load by the data sheet: an HX711's bridge is balanced, converters round down."""
    if cell.kind == "hx711":
        return 0.0
    full_v, steps, share = board.adc
    return SUPPLY_V / 2 * share * steps / full_v - 0.5

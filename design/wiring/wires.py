"""Wires from the sensor boards' pads to the reading board: colour, length and order of soldering."""

from __future__ import annotations

from dataclasses import dataclass

from design.catalogue.bus_parts import EXPANDER_NAME, MUX_NAME
from design.wiring.bus_plan import BusPlan
from design.wiring.dealing import ChipOnBus

COLOURS = {"VCC": "red", "GND": "black", "SDA": "blue", "SCL": "yellow"}
_BRIDGE_COLOURS = {"E+": "red", "E-": "black", "A-": "white", "A+": "green"}
"""Colours of the cable that hangs on most load cells; its maker's sheet counts."""
_ALL_COLOURS = COLOURS | _BRIDGE_COLOURS
_STRIP_MM = 60.0
"""Length of a wire between the strip, where the sensors' wires end, and a pin of the board."""
LOAD_CABLE_MM = 200.0
"""Length of a load cell's own cable, at least."""


@dataclass(frozen=True)
class Wire:
    """One wire: number in the order of soldering, both ends, colour, and length to cut (mm)."""

    number: int
    start: str
    end: str
    signal: str
    colour: str
    length_mm: int


def wires_of(plan: BusPlan) -> tuple[Wire, ...]:
    """Wires in the order of soldering: at the sensors first, then from the strip to the board.

    Sensors' wires end on rows of a strip (bus 0 SDA, 3V3, …), which joins what belongs together;
    lengths are rounded up to 5 mm.
    """
    ends = [
        (f"{chip.label} {pad}", _end(plan, chip, pad), pad, chip.wire_mm)
        for chip in plan.chips
        for pad in COLOURS
    ]
    ends += [(start, end, signal, _STRIP_MM) for start, end, signal in _board_ends(plan)]
    if plan.imu is not None:
        lines = {"VCC": "strip 3V3", "GND": "strip GND"}
        bus = f"strip bus {plan.buses[0]}"
        ends += [
            (f"{plan.imu.name} {pad}", lines.get(pad, f"{bus} {pad}"), pad, _STRIP_MM)
            for pad in COLOURS
        ]
    loads = [] if plan.load is None else plan.load.wires(plan.board)
    ends += [(start, end, signal, _load_mm(start)) for start, end, signal in loads]
    return tuple(
        Wire(k, start, end, signal, _ALL_COLOURS[signal], int(-(-length // 5) * 5))
        for k, (start, end, signal, length) in enumerate(ends, start=1)
    )


def _load_mm(start: str) -> float:
    """A load cell and a force sensor have cables of their own; the rest lies on the strip."""
    return LOAD_CABLE_MM if start.startswith(("load cell", "force sensor")) else _STRIP_MM


def _end(plan: BusPlan, chip: ChipOnBus, pad: str) -> str:
    """Return where the wire of a sensor's pad ends."""
    if pad == "GND":
        return "strip GND"
    if pad == "VCC" and chip.expander is not None:
        return f"{_part(EXPANDER_NAME, chip.bus, chip.expander)} {chip.supply}"
    if pad == "VCC":
        return f"strip {_switched(plan, chip.supply)}" if chip.supply else "strip 3V3"
    if chip.multiplexer is None:
        return f"strip bus {chip.bus} {pad}"
    line = {"SDA": "SD", "SCL": "SC"}[pad]
    return f"{_part(MUX_NAME, chip.bus, chip.multiplexer)} {line}{chip.channel}"


def _part(name: str, bus: int, address: int) -> str:
    return f"{name} 0x{address:02X} (bus {bus})"


def _switched(plan: BusPlan, supply: str) -> str:
    """A supply pin by itself, or behind a buffer on 3.3 V where the board has 5 V."""
    return supply if plan.board.logic_v < 4 else f"{supply} buffered"


def _board_ends(plan: BusPlan) -> list[tuple[str, str, str]]:
    """Start, end and signal of the wires between strip, multiplexers and board."""
    board, ends = (
        plan.board,
        [("strip GND", "board GND", "GND"), ("strip 3V3", "board 3V3", "VCC")],
    )
    for bus in plan.buses:
        pins = board.buses[bus]
        shifted = " by level shifter" if board.logic_v > 4 and not plan.multiplexers else ""
        ends += [
            (f"strip bus {bus} SDA", f"board {pins.sda}{shifted}", "SDA"),
            (f"strip bus {bus} SCL", f"board {pins.scl}{shifted}", "SCL"),
        ]
    parts = [_part(MUX_NAME, *place) for place in plan.multiplexers]
    parts += [_part(EXPANDER_NAME, *place) for place in plan.expanders]
    for name, (bus, _) in zip(parts, (*plan.multiplexers, *plan.expanders), strict=True):
        ends += [
            (f"{name} VIN", "strip 3V3", "VCC"),
            (f"{name} GND", "strip GND", "GND"),
            (f"{name} SDA", f"strip bus {bus} SDA", "SDA"),
            (f"{name} SCL", f"strip bus {bus} SCL", "SCL"),
            (f"{name} RST", f"board {plan.reset}", "VCC"),
        ]
    ends += [
        (
            f"strip {_switched(plan, chip.supply_pin)}",
            f"board {_buffered_pin(plan, chip.supply_pin)}",
            "VCC",
        )
        for chip in plan.chips
        if chip.supply_pin is not None
    ]
    return ends


def _buffered_pin(plan: BusPlan, supply: str) -> str:
    return supply if plan.board.logic_v < 4 else f"{supply} by CD74HC4050E on 3V3"


def wire_length_m(plan: BusPlan) -> float:
    """Wire to buy, m; a load cell's cable hangs on it."""
    bought = (wire for wire in wires_of(plan) if _load_mm(wire.start) == _STRIP_MM)
    return sum(wire.length_mm for wire in bought) / 1e3

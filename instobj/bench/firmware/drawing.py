"""Wiring drawing as SVG: sensors on the left, strip and multiplexers between, the board on the right."""

from __future__ import annotations

from collections.abc import Sequence
from xml.sax.saxutils import escape

from design.wiring.bus_plan import BusPlan
from design.wiring.wires import Wire, wires_of

_STROKES = {
    "red": "#c1121f",
    "black": "#222222",
    "blue": "#1d4e9e",
    "yellow": "#c99700",
    "green": "#2d7d46",
    "white": "#9a9a9a",
}
_LINE, _BOX, _GAP, _TOP = 3.2, 46.0, 62.0, 14.0
"""mm: height of a pin's row, width of a box, room for wires between boxes, and above all."""


def wiring_svg(plan: BusPlan, title: str) -> str:
    """A drawing to print at its size in mm; every wire carries its number of the table."""
    wires = wires_of(plan)
    columns = [_pins(wires, kind) for kind in ("F", "strip", "board")]
    height = _TOP + _LINE * (max(_rows(column) for column in columns) + 2)
    width = 3 * _BOX + 2 * _GAP + 8
    places: dict[tuple[str, str], float] = {}
    shapes = []
    for number, column in enumerate(columns):
        corner = (4 + number * (_BOX + _GAP), _TOP + _LINE / 3 * number)
        shapes += _column(column, corner, height, places)
    lines = [_wire(wire, places, lane) for wire, lane in zip(wires, _lanes(wires), strict=True)]
    head = f'<text x="4" y="7" font-size="4.2">{escape(title)}</text>'
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:g}mm" height="{height:g}mm" '
        f'viewBox="0 0 {width:g} {height:g}" font-family="sans-serif" font-size="2.2">'
        f'<rect width="100%" height="100%" fill="white"/>{head}{"".join(lines + shapes)}</svg>\n'
    )


def _box_of(end: str) -> tuple[str, str]:
    """Box and pin of a wire's end: F1-S1 VCC, strip GND, board D20, TCA9548A 0x70 (bus 0) SD0."""
    for box in ("strip", "board"):
        if end.startswith(f"{box} "):
            return box, end.removeprefix(f"{box} ")
    box, _, pin = end.rpartition(" ")
    return box, pin


def _side(box: str) -> str:
    cell = box in ("load cell", "force sensor")
    return "board" if box == "board" else "F" if cell or box.startswith("F") else "strip"


def _pins(wires: Sequence[Wire], side: str) -> dict[str, list[str]]:
    """Boxes of a column with their pins, in the order of the wires."""
    boxes: dict[str, list[str]] = {}
    for wire in wires:
        for box, pin in (_box_of(wire.start), _box_of(wire.end)):
            if _side(box) == side and pin not in boxes.setdefault(box, []):
                boxes[box].append(pin)
    return {box: pins for box, pins in boxes.items() if pins}


def _rows(column: dict[str, list[str]]) -> int:
    return sum(len(pins) + 1 for pins in column.values())


def _column(
    column: dict[str, list[str]],
    corner: tuple[float, float],
    height: float,
    places: dict[tuple[str, str], float],
) -> list[str]:
    """Boxes under each other, spread over the height; notes where each pin lies.

    Pins lie whole rows apart, so that columns whose corners differ by less have no row in common.
    """
    x, y = corner
    spare = _LINE * ((height - y - _LINE * _rows(column)) // (_LINE * max(1, len(column))))
    shapes = []
    for box, pins in column.items():
        tall = _LINE * (len(pins) + 0.7)
        shapes.append(
            f'<rect x="{x:g}" y="{y:g}" width="{_BOX:g}" height="{tall:g}" rx="1" fill="#f3f3f0" '
            f'stroke="#444" stroke-width="0.25"/><text x="{x + 1:g}" y="{y + 2.6:g}" '
            f'font-weight="bold">{escape(box)}</text>'
        )
        for k, pin in enumerate(pins):
            row = y + _LINE * (k + 0.85)
            places[box, pin] = row
            shapes.append(
                f'<text x="{x + _BOX - 1:g}" y="{row + 0.8:g}" text-anchor="end">{escape(pin)}</text>'
            )
        y += tall + 0.3 * _LINE + spare
    return shapes


def _lanes(wires: Sequence[Wire]) -> list[float]:
    """Return where each wire turns (0 to 1 of its gap): wires to one pin turn together, others apart."""
    ends: dict[tuple[int, bool], dict[str, int]] = {}
    for wire in wires:
        pins = ends.setdefault(_gap(wire), {})
        pins.setdefault(wire.end, len(pins))
    return [(ends[_gap(wire)][wire.end] + 0.5) / len(ends[_gap(wire)]) for wire in wires]


def _gap(wire: Wire) -> tuple[int, bool]:
    """The left one of a wire's columns, next to which it turns, and whether both are the same one."""
    start, end = _left_to_right(wire)
    return _order(start[0]), _order(start[0]) == _order(end[0])


def _left_to_right(wire: Wire) -> tuple[tuple[str, str], tuple[str, str]]:
    start, end = sorted((_box_of(wire.start), _box_of(wire.end)), key=lambda e: _order(e[0]))
    return start, end


def _wire(wire: Wire, places: dict[tuple[str, str], float], lane: float) -> str:
    start, end = _left_to_right(wire)
    y1, y2 = places[start], places[end]
    x1 = 4 + _order(start[0]) * (_BOX + _GAP) + _BOX
    x2 = 4 + _order(end[0]) * (_BOX + _GAP)
    if _gap(wire)[1]:  # between strip and multiplexer
        x1 = x2
        turn = x2 - 3 - 8 * lane
    else:
        turn = x1 + _GAP * (0.08 + 0.72 * lane)
    return (
        f'<path d="M {x1:g} {y1:g} H {turn:.2f} V {y2:g} H {x2:g}" fill="none" '
        f'stroke="{_STROKES[wire.colour]}" stroke-width="0.3"/>'
        f'<text x="{x1 + (0.6 if turn >= x1 else -0.6):g}" y="{y1 - 0.4:g}" font-size="1.6" '
        f'text-anchor="{"start" if turn >= x1 else "end"}">{wire.number}</text>'
    )


def _order(box: str) -> int:
    return ("F", "strip", "board").index(_side(box))

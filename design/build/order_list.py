"""Order list of an object: maker's numbers, pieces, packs, and the range of prices."""

from __future__ import annotations

import csv
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, fields, replace
from pathlib import Path

from design.build.amounts import silicone_amount
from design.catalogue.magnets import GRADES, MAGNET_PARTS, STOCK
from design.catalogue.orders import (
    ADHESIVE,
    GLUE,
    ORDERS,
    PRICED,
    PRIMER,
    RELEASE,
    SCREW,
    SILICONE_KIT_G,
    STRIP,
    WIRE,
    Order,
)
from design.layout.core_hold import why_no_mould
from design.layout.mould.frame import mould_style, opening_of
from design.layout.places.positions import sensor_layout
from design.spec.object import ObjectSpec
from design.tables import write_table
from design.wiring.bus_plan import BusPlan
from design.wiring.wires import wire_length_m

_WIRE_M_A_PACK = 10.0
"""Wire in a pack as it is sold (m)."""
SCREWS = 4
"""Through the flanges of a mould's halves."""
CHECK = "price estimated; check number, price and stock before ordering"


@dataclass(frozen=True)
class OrderLine:
    """One part: pieces that the object takes, packs to buy, what all of them cost (EUR), estimated when."""

    part: str
    maker: str
    number: str
    pieces: int
    packs: int
    low_eur: float
    high_eur: float
    priced: str
    note: str


def order_list(spec: ObjectSpec, plan: BusPlan | None) -> list[OrderLine]:
    """Electronics by the plan, magnets, what is cast and glued, what is printed of.

    Without a plan, because the catalogue knows no bus for the sensors, they stand by their name alone.
    """
    lines = [_sensors_alone(spec)] if plan is None else _electronics(plan)
    return [*lines, *_magnets(spec), *_casting(spec), _line(ORDERS[spec.printer.preset.process], 1)]


def write_orders(lines: list[OrderLine], target: Path) -> None:
    """Write as CSV, one line per part. Raises as `design.tables.write_table`."""
    write_table(target, ORDER_COLUMNS, map(order_row, lines))


ORDER_COLUMNS = tuple(field.name for field in fields(OrderLine))


def order_row(line: OrderLine) -> tuple[object, ...]:
    """Its cells, in the order of `ORDER_COLUMNS`."""
    return tuple(getattr(line, name) for name in ORDER_COLUMNS)


def load_orders(path: Path) -> list[OrderLine]:
    """Read what `write_orders` wrote."""
    with path.open(newline="", encoding="utf-8") as file:
        return [
            OrderLine(part, maker, number, int(pieces), int(packs), float(low), float(high), *texts)
            for part, maker, number, pieces, packs, low, high, *texts in list(csv.reader(file))[1:]
        ]


def price_text(lines: Sequence[OrderLine]) -> str:
    """Say what all lines cost together, at least and at most."""
    low, high = sum(line.low_eur for line in lines), sum(line.high_eur for line in lines)
    return f"{low:.0f} to {high:.0f} EUR, estimated {lines[0].priced} without shipping"


def _electronics(plan: BusPlan) -> list[OrderLine]:
    wire_packs = -(-wire_length_m(plan) // _WIRE_M_A_PACK)
    wanted = [
        (plan.board.name, 1),
        (f"USB {plan.board.name}", 1),
        *sorted(Counter(chip.part for chip in plan.chips).items()),
        ("100 nF", len(plan.chips)),
        ("sensor board", len(plan.chips)),
        *plan.extras,
        (STRIP, 1),
        (WIRE, int(wire_packs)),
    ]
    return [_line(ORDERS[name], pieces) for name, pieces in wanted]


def _casting(spec: ObjectSpec) -> list[OrderLine]:
    """Silicone or the filament of a printed shell, and what keeps it from sticking or makes it stick."""
    wanted = [(GLUE, 1)]
    if spec.silicone.cure != "none":
        wanted += [(PRIMER, 1), (RELEASE, 1)]
    if opening_of(spec) == "open":
        wanted.append((ADHESIVE, 1))
    if mould_style(spec) == "split" and why_no_mould(spec) is None:
        wanted.append((SCREW, SCREWS))
    return [_silicone(spec), *(_line(ORDERS[name], pieces) for name, pieces in wanted)]


def _silicone(spec: ObjectSpec) -> OrderLine:
    """Order kits, or by its name alone what the catalogue does not know."""
    name, mixed_g = spec.silicone.name, silicone_amount(spec).mixed_g
    if name in ORDERS:
        return _line(ORDERS[name], int(-(-mixed_g // SILICONE_KIT_G)))
    note = f"{mixed_g:.0f} g; its price is not known and in no sum; {CHECK}"
    return OrderLine(name, "not in the catalogue", name, 1, 1, 0.0, 0.0, PRICED, note)


def _line(order: Order, pieces: int) -> OrderLine:
    packs = order.packs(pieces)
    low, high = (round(price * packs, 2) for price in order.price_eur)
    number = f"number as in {order.source}" if order.source else "number not looked up"
    note = "; ".join(filter(None, (order.note, number, CHECK)))
    return OrderLine(order.title, order.maker, order.number, pieces, packs, low, high, PRICED, note)


def _sensors_alone(spec: ObjectSpec) -> OrderLine:
    line = _line(ORDERS["sensor board"], len(sensor_layout(spec).face))
    return replace(
        line,
        part=f"Hall sensor {spec.sensors.part} on its board",
        maker="not in the catalogue",
        number=spec.sensors.part,
        note=f"the price is the board's alone; {CHECK}",
    )


def _magnets(spec: ObjectSpec) -> list[OrderLine]:
    """Order by a seller's number where the catalogue has one, else by shape, size and grade; a line each
    kind."""
    faces = len(spec.body.sensed)
    parts, lines = spec.magnets.parts, []
    for which in spec.magnets.numbers_by_kind.values():
        part = MAGNET_PARTS.get(parts[which[0]]) if parts else None
        line = _line(ORDERS["magnet"], faces * len(which))
        if part is not None and part.source != STOCK:
            seller, _, number = part.source.partition(", ")
            lines.append(replace(line, part=f"magnet {part.name}", maker=seller, number=number))
        else:
            name = _magnet_name(spec, which[0])
            lines.append(replace(line, number=f"{name}, {_grades(spec, which[0])}, axial"))
    return lines


def _magnet_name(spec: ObjectSpec, magnet: int) -> str:
    """One magnet of a face as one would order it."""
    magnets = spec.magnets
    kind = f"{magnets.shape} magnet"
    grade = f" {magnets.grades[magnet]}" if magnets.grades else ""
    part = f"{magnets.parts[magnet]}, " if magnets.parts else ""
    return f"{part}{kind}{grade} {magnets.sizes[magnet].told}"


def _grades(spec: ObjectSpec, magnet: int) -> str:
    """The grade given, else the grades with the remanence of the specification."""
    if spec.magnets.grades:
        return spec.magnets.grades[magnet]
    remanence = spec.magnets.remanences_t[magnet]
    fit = [grade.name for grade in GRADES.values() if grade.admits(remanence)]
    return " or ".join(fit) or f"remanence {remanence:g} T"

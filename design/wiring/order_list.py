"""Everything to order for an object read by a board: numbers, packs, and the range of prices."""

from __future__ import annotations

from dataclasses import dataclass

from design.catalogue.orders import ORDERS, PRICED, STRIP, WIRE, Order, order_of
from design.layout.positions import magnet_layout
from design.spec.object import ObjectSpec
from design.wiring.bus_plan import BusPlan
from design.wiring.wires import wire_length_m

_WIRE_M_A_PACK = 10.0


@dataclass(frozen=True)
class OrderLine:
    """One part: pieces that the object takes, packs to buy, and what all of them cost (EUR)."""

    title: str
    maker: str
    number: str
    pieces: int
    packs: int
    price_eur: tuple[float, float]
    priced: str


def order_list(spec: ObjectSpec, plan: BusPlan) -> list[OrderLine]:
    """Electronics by the plan, magnets, silicone and filament; prints and boards' drawings are your own."""
    parts = [chip.part for chip in plan.chips]
    wire_packs = -(-wire_length_m(plan) // _WIRE_M_A_PACK)
    wanted = [
        (ORDERS[plan.board.name], 1),
        *((ORDERS[part], parts.count(part)) for part in sorted(set(parts))),
        (ORDERS["100 nF"], len(parts)),
        (ORDERS["sensor board"], len(parts)),
        *((ORDERS[name], count) for name, count in plan.extras),
        (ORDERS[STRIP], 1),
        (ORDERS[WIRE], int(wire_packs)),
    ]
    lines = [_line(order, pieces) for order, pieces in wanted]
    silicone = order_of(spec.silicone.name)
    return [
        *lines,
        _magnets(spec),
        *([] if silicone is None else [_line(silicone, 1)]),
        _line(ORDERS["filament"], 1),
    ]


def _line(order: Order, pieces: int) -> OrderLine:
    packs = order.packs(pieces)
    low, high = order.price_eur
    price = (round(low * packs, 2), round(high * packs, 2))
    return OrderLine(order.title, order.maker, order.number, pieces, packs, price, PRICED)


def _magnets(spec: ObjectSpec) -> OrderLine:
    """Magnets of many sellers are ordered by shape, size and grade."""
    magnets, line = spec.magnets, _line(ORDERS["magnet"], len(magnet_layout(spec).face))
    across = {
        "disk": f"Ø{magnets.diameter_mm:g}",
        "ring": f"Ø{magnets.diameter_mm:g}/{magnets.inner_diameter_mm:g}",
        "block": f"{magnets.size_mm[0]:g} × {magnets.size_mm[1]:g}",
    }[magnets.shape]
    grade = magnets.grade or f"remanence {magnets.remanence_t:g} T"
    number = f"{magnets.shape} {across} × {magnets.height_mm:g} mm, {grade}, axial"
    return OrderLine(
        "magnet", line.maker, number, line.pieces, line.packs, line.price_eur, line.priced
    )

"""Plans, wires, orders and bills of objects off their symmetries, on record."""

from dataclasses import astuple

import pytest

from design.build.bom import bill_of_materials
from design.build.manifest import BuildManifest, PartManifest
from design.build.order_list import order_list, order_row
from design.catalogue.bus_parts import BOARDS
from design.wiring.bus_plan import all_plans
from design.wiring.lengths import wire_lengths_mm
from design.wiring.load_cell import newtons_per_step, zero_steps
from design.wiring.wires import wire_length_m, wires_of
from tests.support.objects.worked_objects import worked
from tests.support.recorded_facts import assert_on_record, told

CELLS = {
    "hx711": {"kind": "hx711", "rate_sps": 10, "capacity_n": 30.0, "output_mv_per_v": -0.9},
    "analog": {"kind": "analog", "newtons_per_v": 21.0, "zero_v": 2.2},
}


def part(name, volume_mm3, high_mm, material="printed", count=1):
    box, flags = ((0.0, 1.0, 2.0), high_mm), (9, 1, 1.0, True, 4)
    return PartManifest(name, volume_mm3, box, (0.0,) * 3, *flags, material, count)


PARTS = (
    part("core", 21000.0, (30.0, 35.5, 43.0)),
    part("shell", 70000.0, (46.0, 50.0, 56.0), "silicone"),
    part("mould_half_a", 90000.0, (50.0, 60.0, 70.0)),
    part("mould_pin", 150.0, (5.0, 6.0, 9.25), count=12),
)


def of_plan(plan):
    time = plan.time
    yield f"{plan.way}: buses {plan.buses}, multiplexers {plan.multiplexers}, extras {plan.extras}"
    figures = [plan.khz, plan.baud, plan.capacitance_pf, plan.pullup_kohm, plan.pins, plan.wires]
    yield told("clock, baud, pF, kΩ, pins, wires, EUR", [*figures, plan.cost_eur])
    times = [time.conversion_ms, time.reading_ms, time.line_ms, time.status_ms, time.loads_ms]
    yield told("times and rate", [*times, time.fastest_hz])
    last = plan.chips[-1]
    where = f"0x{last.address:02x} on bus {last.bus}, channel {last.channel}, supply {last.supply}"
    yield f"last chip: {last.label} {last.part} at {where}"
    wires = wires_of(plan)
    yield told("wire to buy", [wire_length_m(plan), len(wires), sum(w.length_mm for w in wires)])


@pytest.mark.parametrize("board", BOARDS)
@pytest.mark.parametrize("load", ["none", *CELLS])
def test_plans_are_as_on_record(board, load):
    cell = worked("box").load_cell.changed(**CELLS[load]) if load != "none" else None
    spec = worked("box") if cell is None else worked("box").changed(load_cell=cell)
    choice = all_plans(spec, BOARDS[board], 350.0)
    lines = [line for plan in choice.plans for line in of_plan(plan)]
    lines += [f"{way} cannot: {why}" for way, why in choice.refused]
    if cell is not None:
        steps = [newtons_per_step(cell, BOARDS[board]), zero_steps(cell, BOARDS[board])]
        lines.append(told("steps", steps))
        plan = choice.plans[0].load
        wires = " | ".join(", ".join(wire) for wire in plan.wires(BOARDS[board]))
        lines.append(f"{plan.title}: {plan.parts(BOARDS[board])}; {wires}")
    assert_on_record("plans", f"{board}, load cell {load}", lines)


@pytest.mark.parametrize("name", ["box", "reverse box", "capsule", "closed sphere"])
def test_lengths_of_wires_are_as_on_record(name):
    assert_on_record("wires", name, [told("lengths", wire_lengths_mm(worked(name), 120.0))])


@pytest.mark.parametrize("name", ["box", "reverse box", "box open at a side"])
def test_bills_and_orders_are_as_on_record(name):
    spec = worked(name)
    plan = all_plans(spec, BOARDS["mega2560"]).plans[0]
    lines = [
        " | ".join(map(str, astuple(item)))
        for item in bill_of_materials(spec, BuildManifest("worked", "", PARTS, {}), plan)
    ]
    lines += [" | ".join(map(str, order_row(line)[:8])) for line in order_list(spec, plan)]
    assert_on_record("orders", name, lines)


@pytest.mark.parametrize(("board", "number"), [("mega2560", 0), ("mega2560", 1), ("pico", -1)])
def test_one_set_of_wires_is_as_on_record(board, number):
    spec = worked("box").changed(body=worked("box").body.changed(sensed_faces=(1, 3)))
    plan = all_plans(spec, BOARDS[board]).plans[number]
    lines = [" | ".join(map(str, astuple(wire))) for wire in wires_of(plan)]
    assert_on_record("wires", f"{board}, {plan.way}", lines)

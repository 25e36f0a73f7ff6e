"""Plans, wires and orders of objects off their symmetries: a page that a person can judge."""

from design.build.order_list import order_list
from design.catalogue.bus_parts import BOARDS
from design.wiring.bus_plan import all_plans
from design.wiring.lengths import wire_lengths_mm
from design.wiring.load_cell import newtons_per_step, zero_steps
from design.wiring.wires import wire_length_m, wires_of
from tests.support.objects.worked_objects import worked
from tests.support.physics_pages import assert_page

CELLS = {
    "hx711": {"kind": "hx711", "scale_n": -30.0 / 0.9},
    "analog": {"kind": "analog", "scale_n": 21.0},
}


def of_plan(board, plan):
    yield (
        f"{board}, {plan.way}: kHz, pF, kΩ, pins, wires, EUR",
        [
            plan.khz,
            plan.capacitance_pf,
            plan.pullup_kohm,
            plan.pins,
            plan.wires,
            plan.cost_eur,
        ],
    )
    time = plan.time
    times = [time.conversion_ms, time.reading_ms, time.line_ms, time.loads_ms, time.fastest_hz]
    yield "its times (ms) and rate (Hz)", times


def of_plans():
    for board in ("mega2560", "pico"):
        for plan in all_plans(worked("box"), BOARDS[board], 350.0).plans:
            yield from of_plan(board, plan)
    for kind, content in CELLS.items():
        cell = worked("box").load_cell.changed(**content)
        spec = worked("box").changed(load_cell=cell)
        plan = all_plans(spec, BOARDS["mega2560"], 350.0).plans[0]
        board = BOARDS["mega2560"]
        steps = [newtons_per_step(cell, board), zero_steps(cell, board), plan.time.fastest_hz]
        yield f"{kind}: N a step, zero (steps), rate (Hz)", steps


def of_wires_and_orders():
    for name in ("box", "reverse box", "capsule"):
        yield f"{name}: lengths of wires (mm)", wire_lengths_mm(worked(name), 120.0)
    spec = worked("box")
    plan = all_plans(spec, BOARDS["mega2560"]).plans[0]
    yield "wires, to buy (m)", [len(wires_of(plan)), wire_length_m(plan)]
    yield (
        "orders",
        ", ".join(f"{line.packs} × {line.part}" for line in order_list(spec, plan)),
    )


def test_the_page_of_wiring():
    assert_page("design/wiring", [*of_plans(), *of_wires_and_orders()])

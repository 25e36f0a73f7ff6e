"""Wires: every pad has one, each net joins what it must, and all are counted, drawn and ordered."""

import re
from collections import Counter
from itertools import combinations
from xml.etree import ElementTree

import pytest

from design.build.order_list import order_list
from design.catalogue.bus_parts import BOARDS, PICO
from design.spec.object import ObjectSpec
from design.spec_io import load_spec
from design.wiring.bus_plan import all_plans, choose_plan
from design.wiring.dealing import MIXED
from design.wiring.wires import wire_length_m, wires_of
from instobj.bench.firmware.drawing import wiring_svg
from tests.support.pages import ROOT

SPEC = ObjectSpec.model_validate({"name": "wired"})
KINDS = ("none", "hx711", "analog")


def with_load_cell(kind, spec=SPEC, **cell):
    return spec.changed(load_cell={"kind": kind, **cell})


def plans_of(spec):
    return [
        plan
        for board in BOARDS.values()
        for kind in KINDS
        if kind != "analog" or board.analog_pins
        for plan in all_plans(with_load_cell(kind, spec), board).plans
    ]


PLANS = plans_of(SPEC)


def name_of(plan):
    return f"{plan.board.name}-{plan.way}-{plan.load.kind if plan.load else 'none'}"


@pytest.mark.parametrize("plan", PLANS, ids=name_of)
def test_every_pad_of_every_sensor_has_one_wire_and_all_are_counted(plan):
    wires = wires_of(plan)
    starts = Counter(wire.start for wire in wires)
    assert {wire.end.split()[1] for wire in wires if wire.end.startswith("board ")} >= {
        *(plan.load.pins if plan.load else ())
    }
    pads = {f"{chip.label} {pad}" for chip in plan.chips for pad in ("VCC", "GND", "SDA", "SCL")}
    assert {start for start in starts if re.match(r"F\d", start)} == pads
    assert max(starts.values()) == 1
    assert len(wires) == plan.wires
    assert [wire.number for wire in wires] == list(range(1, len(wires) + 1))
    needed = {chip.label: chip.wire_mm for chip in plan.chips}
    for wire in wires[: 4 * len(plan.chips)]:
        assert 0 <= wire.length_mm - needed[wire.start[: wire.start.rindex(" ")]] < 5


@pytest.mark.parametrize("plan", PLANS, ids=name_of)
def test_followed_along_its_wires_every_pad_reaches_the_board(plan):
    onward = {wire.start: wire.end for wire in wires_of(plan)}
    for chip in plan.chips:
        for pad in ("VCC", "GND", "SDA", "SCL"):
            end = onward[f"{chip.label} {pad}"]
            if "TCA9548A" in end:  # through the multiplexer to its own line
                end = onward[
                    re.sub(r" S([DC])\d$", lambda m: f" S{m[1]}{'A' if m[1] == 'D' else 'L'}", end)
                ]
            if "MCP23017" in end:  # powered by the sensor's own output, which the strip's 3V3 feeds
                assert end == f"MCP23017 0x{chip.expander:02X} (bus {chip.bus}) {chip.supply}"
                end = onward[end.replace(chip.supply, "VIN")]
            assert onward[end].startswith("board ")
            if pad in ("SDA", "SCL"):
                pin = getattr(plan.board.buses[chip.bus], pad.lower())
                assert onward[end].split()[1] == pin
            if pad == "VCC" and chip.supply_pin:
                assert onward[end].split()[1] == chip.supply


@pytest.mark.parametrize("kind", KINDS)
def test_the_drawing_has_every_wire_in_its_colour(kind):
    plan, _ = choose_plan(with_load_cell(kind), PICO, way=MIXED)
    root = ElementTree.fromstring(wiring_svg(plan, "a <title> & more"))
    paths = root.findall("{http://www.w3.org/2000/svg}path")
    assert len(paths) == plan.wires
    strokes = Counter(path.get("stroke") for path in paths)
    assert strokes["#222222"] == sum(wire.colour == "black" for wire in wires_of(plan))


@pytest.mark.parametrize("example", [None, "eflesh_pad", "hall_skin", "three_axis_dome"])
def test_no_two_wires_of_the_drawing_lie_on_each_other(example):
    """Level and upright parts of wires that share no pin, on every board and way."""
    for plan in plans_of(load_spec(ROOT / f"examples/{example}.toml")) if example else PLANS:
        root = ElementTree.fromstring(wiring_svg(plan, "title"))
        paths = root.findall("{http://www.w3.org/2000/svg}path")
        level, upright = [], []
        for wire, path in zip(wires_of(plan), paths, strict=True):
            x1, y1, turn, y2, x2 = map(float, re.findall(r"[\d.]+", path.get("d")))
            level += [(wire, y, *sorted(ends)) for y, ends in ((y1, (x1, turn)), (y2, (turn, x2)))]
            upright.append((wire, turn, *sorted((y1, y2))))
        for parts in (level, upright):
            for (one, at, low, high), (other, there, left, right) in combinations(parts, 2):
                if not {one.start, one.end} & {other.start, other.end}:
                    apart = abs(at - there) > 0.4 or min(high, right) - max(low, left) < 0.01
                    assert apart, (one, other)


@pytest.mark.parametrize("kind", ["hx711", "analog"])
def test_a_load_cell_is_wired_and_ordered(kind):
    for board in BOARDS.values():
        if kind == "analog" and not board.analog_pins:
            continue
        spec = with_load_cell(kind)
        plan, _ = choose_plan(spec, board)
        bare, _ = choose_plan(SPEC, board)
        assert plan.pins == bare.pins + len(plan.load.pins)
        assert plan.wires == bare.wires + len(plan.load.wires(board))
        extra = {line.part for line in order_list(spec, plan)} - {
            line.part for line in order_list(SPEC, bare)
        }
        assert len(extra) == 2
        assert plan.cost_eur > bare.cost_eur
        assert wire_length_m(plan) - wire_length_m(bare) < 0.5

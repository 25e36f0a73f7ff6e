"""Bus plans: every chip is reached alone, limits of the bus hold, and what cannot be done is refused."""

import numpy as np
import pytest

from design.catalogue.bus_parts import BOARDS, MEGA2560, PICO, bus_chip
from design.errors import InputError
from design.spec.object import ObjectSpec
from design.wiring.bus_limits import FrameTime, largest_capacitance_pf, pullup_kohm
from design.wiring.bus_plan import all_plans, choose_plan, first_plan, plan_or_none
from design.wiring.dealing import EXPANDED, FACTORY, MIXED, MULTIPLEXED, STARTED
from design.wiring.lengths import wire_lengths_mm

MLX = {"part": "MLX90393", "range_mt": 49.2, "noise_counts": [5.0, 5.0, 5.0]}
TLE = {"part": "TLE493DW2B6A1", "noise_counts": [1.0, 1.0, 1.0]}


def object_of(**sensors):
    return ObjectSpec.model_validate({"name": "planned", "sensors": sensors})


def answering(plan, asked, moved=True):
    """Chips that answer when `asked` is read: same bus, channel open, powered, same address."""
    return [
        chip
        for chip in plan.chips
        if chip.bus == asked.bus
        and (chip.multiplexer, chip.channel) == (asked.multiplexer, asked.channel)
        and (chip.address if moved else chip.factory) == asked.address
    ]


@pytest.mark.parametrize("board", BOARDS.values(), ids=BOARDS)
@pytest.mark.parametrize("sensors", [{}, {"count_per_face": 1}, {"count_per_face": 2}, MLX, TLE])
def test_every_chip_is_reached_alone(board, sensors):
    choice = all_plans(object_of(**sensors), board)
    assert choice.plans
    for plan in choice.plans:
        for chip in plan.chips:
            assert answering(plan, chip) == [chip]
            factory = dict(bus_chip(chip.part).addresses).values()
            assert chip.factory in factory
            assert chip.address not in range(0x70, 0x78)
        outputs = [chip.supply_pin for chip in plan.chips if chip.supply_pin] + [plan.reset] * bool(
            plan.reset
        )
        assert len(set(outputs)) == len(outputs)
        assert set(outputs) <= set(board.outputs)


def test_without_new_addresses_chips_of_one_part_would_answer_together():
    """The planted fault: the same plan read at the factory's address."""
    plan, _ = choose_plan(object_of(), PICO, way=STARTED)
    assert len(answering(plan, plan.chips[0], moved=False)) == 0
    assert len({chip.factory for chip in plan.chips}) == 1


def test_the_papers_plan_is_the_cheapest_of_its_board():
    """Arduino Mega, 15 supply wires, SDA, SCL: as the paper's object, at 10.5 frames per second."""
    plan, _ = choose_plan(object_of(), MEGA2560)
    assert (plan.way, plan.pins, len(plan.chips)) == (STARTED, 17, 15)
    assert plan.time.fastest_hz > 10.5
    assert plan.khz == 100
    assert dict(plan.extras)["supply buffer"] == 3


def test_capacitance_is_that_of_all_wires_and_pins():
    plan, _ = choose_plan(object_of(), PICO, way=STARTED)
    by_hand = 10.0 + sum(10.0 + 0.06 * length for length in wire_lengths_mm(object_of()))
    assert plan.capacitance_pf == pytest.approx(by_hand)


def test_the_pull_up_lets_the_line_rise_in_time():
    """Simulated step of an RC line, 30 to 70 % of the supply, against fast mode's 300 ns."""
    kohm = pullup_kohm(400.0, 3.3, 150.0)
    t_ns = np.linspace(0, 3000, 300_001)
    share = 1 - np.exp(-t_ns / (kohm * 150.0))
    rise_ns = t_ns[np.searchsorted(share, 0.7)] - t_ns[np.searchsorted(share, 0.3)]
    assert 0.75 * 300 < rise_ns <= 300
    assert pullup_kohm(400.0, 3.3, 1.01 * largest_capacitance_pf(400.0, 3.3)) is None


def test_wires_are_as_long_as_their_path():
    """On face 3 of the cube: 7.75 in the recess, 4.5 of wall, and to the middle of the open face."""
    lengths = wire_lengths_mm(object_of(), lead_mm=100.0)
    assert lengths[0] == pytest.approx(100 + 7.75 + 4.5 + (13 - 4.5) + 21, abs=0.2)
    assert lengths[6] == pytest.approx(100 + 7.75 + 4.5 + np.hypot(8.5, 21), abs=0.2)


def test_longer_leads_need_multiplexers():
    plan, choice = choose_plan(object_of(), MEGA2560, lead_mm=900.0)
    assert plan.way == MIXED
    assert "pF" in dict(choice.refused)[STARTED]


@pytest.mark.parametrize(
    ("sensors", "board", "way", "words"),
    [
        ({}, MEGA2560, FACTORY, "15 chips, but TMAG5273 has 4 addresses"),
        (MLX, PICO, STARTED, "cannot be changed while it runs"),
        ({"frame_rate_hz": 150, "averaging": 4}, MEGA2560, None, "frames per second at most"),
        ({"count_per_face": 5}, PICO, STARTED, "25 chips need a supply pin each"),
        ({"count_per_face": 5}, MEGA2560, MULTIPLEXED, "draw 57 mA"),
    ],
)
def test_what_cannot_be_done_is_refused_with_the_reason_and_what_can(sensors, board, way, words):
    with pytest.raises(InputError, match=words) as refused:
        choose_plan(object_of(**sensors), board, way=way)
    assert "--board" in str(refused.value) or "lower sensors" in str(refused.value)


def test_parts_without_a_bus_are_refused():
    generic = {"part": "generic", "range_mt": 40, "counts_per_mt": 820, "noise_counts": [1, 1, 1]}
    with pytest.raises(InputError, match="no I²C bus"):
        choose_plan(object_of(**generic), PICO)


def test_faster_frames_take_a_faster_line():
    slow, _ = choose_plan(object_of(), MEGA2560)
    fast, _ = choose_plan(object_of(frame_rate_hz=40, averaging=8), MEGA2560)
    assert (slow.baud, fast.baud > slow.baud) == (115_200, True)


def test_a_frame_takes_the_longer_of_converting_and_of_reading_and_writing():
    assert FrameTime(2.0, 60.0, 30.0, 100.0).fastest_hz == pytest.approx(10.0)
    assert FrameTime(120.0, 60.0, 30.0, 100.0).fastest_hz == pytest.approx(7.5)


def test_a_load_cell_takes_its_pins_and_its_share_of_the_line():
    spec = object_of().changed(load_cell={"kind": "hx711"})
    plan, _ = choose_plan(spec, PICO, way=STARTED)
    assert plan.load.pins == ("GP2", "GP3")
    assert not {"GP2", "GP3"} & {chip.supply for chip in plan.chips}
    bare, _ = choose_plan(object_of(), PICO, way=STARTED)
    assert plan.time.fastest_hz < 0.95 * bare.time.fastest_hz


def test_every_supply_pin_taken_leaves_none_for_a_load_cell():
    """22 outputs: 21 sensors fit one by one, 20 beside an HX711."""
    three_faces = {"body": {"sensed_faces": [1, 2, 3]}, "sensors": {"count_per_face": 7}}
    spec = ObjectSpec.model_validate({"name": "many", **three_faces})
    assert STARTED in {plan.way for plan in all_plans(spec, PICO).plans}
    refused = dict(all_plans(spec.changed(load_cell={"kind": "hx711"}), PICO).refused)
    assert "21 chips need a supply pin each, the board has 20" in refused[STARTED]


@pytest.mark.parametrize(
    ("cell", "words"),
    [
        ({"kind": "hx711", "pins": ["D20", "D41"]}, "takes different pins of D40"),
        ({"kind": "hx711", "pins": ["D40", "D40"]}, "takes different pins"),
        ({"kind": "analog", "pins": ["D40"]}, "takes different pins of A0"),
    ],
)
def test_pins_that_a_load_cell_cannot_have_are_refused(cell, words):
    with pytest.raises(InputError, match=words):
        choose_plan(object_of().changed(load_cell=cell), MEGA2560)


def test_a_rate_that_the_load_cell_leaves_no_time_for_is_refused_with_its_share():
    bare, _ = choose_plan(object_of(averaging=4), MEGA2560, way=MIXED)
    fast = object_of(averaging=4, frame_rate_hz=round(0.99 * bare.time.fastest_hz, 1))
    plan, _ = choose_plan(fast, MEGA2560, way=MIXED)
    loaded, _ = choose_plan(fast.changed(load_cell={"kind": "hx711"}), MEGA2560, way=MIXED)
    assert loaded.baud > plan.baud


@pytest.mark.parametrize(
    ("cell", "words"),
    [
        ({"kind": "hx711", "pins": ["D40"]}, "takes 2"),
        ({"kind": "hx711", "scale_n": 0}, "must not be 0"),
    ],
)
def test_load_cells_that_make_no_sense_are_refused(cell, words):
    with pytest.raises(InputError, match=words):
        object_of().changed(load_cell=cell)


def test_a_tle493d_is_named_by_its_address_and_not_moved():
    choice = all_plans(object_of(**TLE), MEGA2560)
    assert dict(choice.refused).keys() == {FACTORY, STARTED, EXPANDED}
    mixed = next(plan for plan in choice.plans if plan.way == MIXED)
    assert [chip.part[-2:] for chip in mixed.chips[:5]] == ["A0", "A1", "A2", "A3", "A0"]
    alone = next(plan for plan in choice.plans if plan.way == MULTIPLEXED)
    assert {(chip.part, chip.address) for chip in alone.chips} == {("TLE493DW2B6A1", 0x22)}


@pytest.mark.parametrize("sensors", [3, 5])
def test_the_first_board_that_reads_an_object_is_taken(sensors):
    """No board before it in the catalogue can; 25 chips draw more than the first one gives."""
    spec = object_of(count_per_face=sensors)
    board = first_plan(spec).board.name
    can = [name for name, entry in BOARDS.items() if plan_or_none(spec, entry) is not None]
    assert board == can[0]
    assert (board == next(iter(BOARDS))) == (sensors == 3)

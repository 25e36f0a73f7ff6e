"""Figures of bus plans, worked out by hand: times, wires, pins, parts and newtons per step."""

import numpy as np
import pytest

from design.catalogue.bus_parts import IMUS, MEGA2560, PICO, TLE493D, TMAG5273, bus_chip
from design.catalogue.orders import BTA_ADAPTER, HX711, LOAD_CELL, RESISTOR, VERNIER
from design.spec.load_cell import LoadCellSpec
from design.spec.object import ObjectSpec
from design.spec.sensors import fastest_frame_rate_hz
from design.wiring.bus_limits import (
    FrameTime,
    frame_time,
    largest_capacitance_pf,
    pullup_kohm,
    rise_time_ns,
)
from design.wiring.bus_plan import choose_plan, require_current
from design.wiring.dealing import MULTIPLEXED, STARTED, CannotError, ChipOnBus
from design.wiring.load_cell import LoadCellPlan, load_cell_plan, newtons_per_step, zero_steps

CUBE = ObjectSpec(name="planned")


def test_a_frame_s_times_are_its_bits_calls_and_characters():
    """15 chips at 100 kHz and 115 200 baud: 12 bytes of 9 bits and 3 bits around each transfer."""
    time = frame_time(MEGA2560, TMAG5273, 16, 100.0, 115_200, 15, 0, 3)
    character = 10 / 115.2
    assert time.conversion_ms == pytest.approx(1.625)
    assert time.reading_ms == pytest.approx(15 * (9 * 12 + 3) / 100 + 15 * 0.170)
    assert time.line_ms == pytest.approx((26 + 7 * 45) * character)
    assert time.status_ms == pytest.approx((50 + 6 * 15) * character)
    assert time.loads_ms == 0
    each_ms = time.reading_ms + time.line_ms
    assert time.fastest_hz == pytest.approx((1000 - time.status_ms) / each_ms)
    selected = frame_time(MEGA2560, TLE493D, 16, 400.0, 1_000_000, 15, 4, 2)
    bits = 9 * (15 * 21 + 4 * 2) + 3 * 19
    assert selected.reading_ms == pytest.approx(bits / 400 + 19 * 0.170)
    assert selected.line_ms == pytest.approx(0.016 * (26 + 7 * 30)), "slower than the line"
    usb = frame_time(PICO, TMAG5273, 16, 400.0, 115_200, 15, 0, 3)
    assert usb.line_ms == pytest.approx(0.015 * (26 + 7 * 45)), "no baud rate by USB"
    assert FrameTime(1.0, 2.0, 3.0, 600.0, 500.0).fastest_hz == 0


def test_limits_of_the_bus_are_those_of_um10204():
    """Smallest pull-up: 3 mA at 0.4 V; rise time 1000 ns up to 100 kHz, 300 ns above."""
    assert (rise_time_ns(100.0), rise_time_ns(101.0)) == (1000.0, 300.0)
    assert largest_capacitance_pf(100.0, 3.3) == 400.0
    assert largest_capacitance_pf(400.0, 3.3) == pytest.approx(300 / 0.8473 / (2.9 / 3))
    assert largest_capacitance_pf(400.0, 5.0) == pytest.approx(300 / 0.8473 / (4.6 / 3))
    assert pullup_kohm(100.0, 3.3, 100.0) == 8.2
    assert pullup_kohm(100.0, 3.3, 400.0) == 2.7
    assert pullup_kohm(400.0, 3.3, 300.0) == 1.0
    assert pullup_kohm(400.0, 5.0, 225.0) is None, "1.5 kΩ would be needed, 1.53 are the least"
    series = sorted({pullup_kohm(100.0, 3.3, 1180 / r) for r in np.linspace(1.01, 10, 900)})
    assert series == [1.0, 1.2, 1.5, 1.8, 2.2, 2.7, 3.3, 3.9, 4.7, 5.6, 6.8, 8.2], "E12"
    assert pullup_kohm(100.0, 3.3, 1.0001 * 1000 / 0.8473) is None


def test_pull_ups_are_those_of_the_e12_series_that_let_a_line_rise_in_time():
    """Of 5 V and 3 mA at least 1.53 kΩ, and at most 1000 ns over 0.8473 C."""
    series = [1.8, 2.2, 2.7, 3.3, 3.9, 4.7, 5.6, 6.8, 8.2]
    for kohm in series:
        just = 1000 / (0.8473 * kohm)
        assert pullup_kohm(100.0, 5.0, 0.999 * just) == kohm
        assert pullup_kohm(100.0, 5.0, 1.001 * just) == max(
            (one for one in series if one < kohm), default=None
        )
    assert pullup_kohm(400.0, 3.3, 1e-3) == 8.2
    assert pullup_kohm(400.0, 3.3, 300 / (0.8473 * 1.001)) == 1.0
    assert pullup_kohm(400.0, 3.3, 300 / (0.8473 * 0.96)) is None


def test_the_papers_plan_has_these_parts_pins_and_wires():
    """15 chips by supply pins of a Mega: one bus, one shifter, three packages of six buffers."""
    plan, choice = choose_plan(CUBE, MEGA2560, way=STARTED)
    assert dict(plan.extras) == {RESISTOR: 2, "level shifter": 1, "supply buffer": 3}
    assert plan.cost_eur == pytest.approx(2 * 0.125 + 4.0 + 3 * 0.85)
    assert plan.wires == 4 * 15 + 2 + 15 + 2
    assert plan.pins == 2 + 15
    assert (plan.buses, plan.multiplexers, plan.reset) == ((0,), (), None)
    costs = [(one.cost_eur, one.wires) for one in choice.plans]
    assert costs == sorted(costs)


def test_multiplexers_need_pull_ups_on_every_channel_and_a_reset():
    plan, _ = choose_plan(CUBE, MEGA2560, way=MULTIPLEXED)
    assert dict(plan.extras) == {RESISTOR: 2 * (1 + 15), "multiplexer board": 2}
    assert plan.cost_eur == pytest.approx(32 * 0.125 + 2 * 7.5)
    assert plan.multiplexers == ((0, 0x70), (0, 0x71))
    assert plan.wires == 4 * 15 + 5 * 2 + 2 + 2
    assert plan.pins == 2 + 1
    assert plan.reset == MEGA2560.outputs[0]
    longest = max(chip.wire_mm for chip in plan.chips)
    assert plan.capacitance_pf == pytest.approx(10 * (1 + 2 * 2) + 10 + 0.06 * longest)
    time = frame_time(MEGA2560, TMAG5273, 16, plan.khz, plan.baud, 15, 15, 3)
    assert plan.time == time


def test_a_load_cell_adds_its_pins_wires_parts_and_lines():
    spec = CUBE.changed(load_cell={"kind": "hx711"})
    plan, _ = choose_plan(spec, MEGA2560, way=STARTED)
    assert plan.pins == 2 + 15 + 2
    assert plan.wires == 4 * 15 + 2 + 15 + 2 + 8
    assert dict(plan.extras)[HX711] == dict(plan.extras)[LOAD_CELL] == 1
    seconds = plan.load.lines_hz * 1e-6 * (600 + 28 * 1e7 / 115_200)
    assert plan.load.seconds_a_second(MEGA2560, 115_200) == pytest.approx(seconds)
    assert plan.time.loads_ms == pytest.approx(1e3 * seconds)
    assert plan.load.seconds_a_second(MEGA2560, 1_000_000) == pytest.approx(
        plan.load.lines_hz * 1e-6 * (600 + 28 * 16)
    )
    assert plan.load.seconds_a_second(PICO, 115_200) == pytest.approx(
        plan.load.lines_hz * 1e-6 * (700 + 28 * 15)
    )


def test_an_hx711_draws_from_the_pico_s_rail_and_not_from_its_outputs():
    """1.5 mA and 5 V over a bridge of 1 kΩ."""
    hx711, sensor = LoadCellPlan("hx711", ("a", "b"), 80.0), LoadCellPlan("analog", ("a",), 40.0)
    assert (hx711.rail_ma, sensor.rail_ma) == (6.5, 0.0)
    assert bus_chip(CUBE.sensors.part).supply_ma * 20 + hx711.rail_ma > PICO.outputs_ma


@pytest.mark.parametrize(
    ("board", "supply", "load", "imu", "most", "source"),
    [
        (MEGA2560, "D22", None, None, 21, "3.3 V pin gives 50 mA"),
        (MEGA2560, None, None, None, 21, "3.3 V pin gives 50 mA"),
        (MEGA2560, None, "hx711", None, 21, "3.3 V pin gives 50 mA"),
        (PICO, "GP8", None, None, 21, "outputs give 50 mA"),
        (PICO, "GP8", "hx711", None, 21, "outputs give 50 mA"),
        (PICO, None, None, None, 130, "3.3 V pin gives 300 mA"),
        (PICO, None, "hx711", None, 127, "3.3 V pin gives 300 mA"),
        (PICO, None, None, "LSM6DS3", 129, "3.3 V pin gives 300 mA"),
        (PICO, "GP8", None, "LSM6DS3", 21, "outputs give 50 mA"),
        (MEGA2560, "D22", None, "LSM6DS3", 21, "3.3 V pin gives 50 mA"),
    ],
)
def test_chips_draw_no_more_than_what_powers_them_gives(board, supply, load, imu, most, source):
    """2.3 mA each: a Pico's outputs power chips that are started one by one, a Mega's only switch
    buffers on its 3.3 V pin; an HX711's 6.5 mA come from a Pico's 3.3 V or from a Mega's 5 V, an
    IMU's 1.25 mA from either's 3.3 V."""
    cell = None if load is None else LoadCellPlan(load, ("a", "b"), 80.0)
    imu_part = None if imu is None else IMUS[imu]
    chip = ChipOnBus(1, 1, "TMAG5273A1", "order code", 0x35, 0x35, 0, 100.0, supply=supply)
    require_current([chip] * most, TMAG5273, board, cell, imu_part)
    with pytest.raises(CannotError, match=f"{most + 1} chips draw .* {source}"):
        require_current([chip] * (most + 1), TMAG5273, board, cell, imu_part)


def test_a_force_sensor_is_wired_through_a_divider_where_the_board_bears_less_than_its_5_v():
    cell = LoadCellSpec(kind="analog")
    mega, pico = (load_cell_plan(cell, board) for board in (MEGA2560, PICO))
    assert (mega.pins, pico.pins, mega.lines_hz) == (("A0",), ("GP28",), 40.0)
    assert mega.parts(MEGA2560) == ((VERNIER, 1), (BTA_ADAPTER, 1))
    assert pico.parts(PICO) == ((VERNIER, 1), (BTA_ADAPTER, 1), (RESISTOR, 2))
    assert mega.wires(MEGA2560) == [
        ("force sensor 5V", "board 5V", "VCC"),
        ("force sensor GND", "strip GND", "GND"),
        ("force sensor SIG1", "board A0", "SDA"),
    ]
    divider = "strip divider 10k / 15k to GND"
    assert pico.wires(PICO) == [
        ("force sensor 5V", "board VBUS", "VCC"),
        ("force sensor GND", "strip GND", "GND"),
        ("force sensor SIG1", divider, "SDA"),
        (divider, "board GP28", "SDA"),
    ]
    assert (mega.title, pico.title) == (
        "force sensor with a voltage on A0",
        "force sensor with a voltage on GP28",
    )


@pytest.mark.parametrize(("board", "supply"), [(MEGA2560, "board 5V"), (PICO, "strip 3V3")])
def test_an_hx711_is_wired_colour_by_colour(board, supply):
    plan = load_cell_plan(LoadCellSpec(kind="hx711"), board)
    data, clock = board.load_pins[:2]
    assert plan.title == f"HX711 with data on {data} and clock on {clock}"
    assert plan.parts(board) == ((HX711, 1), (LOAD_CELL, 1))
    assert plan.wires(board) == [
        ("load cell red", "HX711 E+", "E+"), ("load cell black", "HX711 E-", "E-"),
        ("load cell white", "HX711 A-", "A-"), ("load cell green", "HX711 A+", "A+"),
        ("HX711 VCC", supply, "VCC"), ("HX711 GND", "strip GND", "GND"),
        ("HX711 DT", f"board {data}", "SDA"), ("HX711 SCK", f"board {clock}", "SCL"),
    ]  # fmt: skip


def test_steps_of_a_load_cell_in_newtons():
    """±2²³ steps of an HX711 are ±0.5 / 128 of its supply; a converter's are volts of the sensor."""
    hx711 = LoadCellSpec(kind="hx711", scale_n=49.0)
    full_scale = 1e-3 / (0.5 / 128) * 2**23
    assert newtons_per_step(hx711, MEGA2560) == pytest.approx(49.0 / full_scale)
    assert zero_steps(hx711, MEGA2560) == 0
    analog = LoadCellSpec(kind="analog", scale_n=-24.5)
    assert newtons_per_step(analog, MEGA2560) == pytest.approx(-24.5 * 5 / 1024)
    assert newtons_per_step(analog, PICO) == pytest.approx(-24.5 * 3.3 / 0.6 / 65536)
    assert zero_steps(analog, MEGA2560) == pytest.approx(511.5)
    assert zero_steps(analog, PICO) == pytest.approx(2.5 * 0.6 / 3.3 * 65536 - 0.5)


def test_check_and_firmware_bound_a_slow_chip_alike():
    """14.8 ms a conversion of the MLX90393: 67 Hz, whoever is asked."""
    spec = ObjectSpec(
        name="cube",
        sensors={"part": "MLX90393", "range_mt": 4.9, "noise_counts": [10, 10, 16]},
    )
    plan, _ = choose_plan(spec, PICO)
    stated = fastest_frame_rate_hz(spec.sensors, 5)
    assert stated == pytest.approx(67.4, abs=0.1)
    assert 0.95 * stated < plan.time.fastest_hz <= stated


def test_boards_of_the_mlx90393_at_0x18_can_be_named():
    sensors = {"part": "MLX90393-0x18", "range_mt": 4.9, "noise_counts": [10, 10, 16]}
    spec = ObjectSpec(name="cube", sensors=sensors)
    plan, _ = choose_plan(spec, PICO)
    assert {chip.address for chip in plan.chips} == {0x18, 0x19, 0x1A, 0x1B}
    usual, _ = choose_plan(ObjectSpec(name="cube", sensors={**sensors, "part": "MLX90393"}), PICO)
    assert {chip.address for chip in usual.chips} == {0x0C, 0x0D, 0x0E, 0x0F}
    assert plan.time == usual.time

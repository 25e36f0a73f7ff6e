"""Catalogued figures entered twice: here from names, formulas and tables of data sheets."""

import re

import pytest
from numpy.testing import assert_allclose

from design.catalogue.bus_parts import (
    BOARDS,
    MEGA2560,
    MLX90393,
    MUX_ADDRESSES,
    PICO,
    bus_chip,
    conversion_ms,
)
from design.catalogue.hall_sensors import (
    GENERIC_PART,
    HALL_PARTS,
    HallPart,
    SensorRange,
    is_fine,
    wider_range,
)
from design.catalogue.magnets import GRADES, MAGNET_PARTS
from design.catalogue.orders import ORDERS, Order
from design.catalogue.silicones import SILICONES, ModulusEstimate
from design.errors import InputError

DISKS = "3x1 3x1.5 3x2 3x3 4x1 4x1.5 4x2 4x3 5x1 5x1.5 5x2 5x3 6x1 6x1.5 6x2 6x3 8x1 8x2 8x3 10x1 10x2 10x3"
LARGE_DISKS = "15x3 15x5 20x3 20x5"
RINGS, BLOCKS = "6x2x2 8x4x2 10x4x2", "5x5x1 5x5x2 5x5x5 8x4x2"
SOLD = "MP 12x5x2 / N38, MP 20x5x5 / N38, MP 20x10x5 / N38, MPL 10x5x1.5 / N38, MPL 20x5x3 / N38"


def test_magnets_are_sold_in_these_sizes_and_their_names_say_them():
    wanted = [f"D{one}" for one in f"{DISKS} {LARGE_DISKS}".split()] + [
        f"R{one}" for one in RINGS.split()
    ]
    wanted += [f"B{one}" for one in BLOCKS.split()] + SOLD.split(", ")
    assert list(MAGNET_PARTS) == wanted
    shapes = {"D": "disk", "R": "ring", "B": "block", "MP": "ring", "MPL": "block"}
    for name, part in MAGNET_PARTS.items():
        kind = re.match("[A-Z]+", name)[0]
        *across, height = (float(one) for one in re.findall(r"\d+(?:\.\d+)?", name.split("/")[0]))
        assert part.shape == shapes[kind], name
        assert (*part.across_mm, part.height_mm) == (*across, height), name
        assert part.grade == (name.split(" / ")[1] if "/" in name else None)


def test_a_part_gives_the_sizes_of_its_own_shape():
    assert MAGNET_PARTS["D6x1"].figures() == {
        "shape": "disk", "height_mm": 1.0, "diameter_mm": 6.0, "inner_diameter_mm": 0.0,
    }  # fmt: skip
    assert MAGNET_PARTS["R8x4x2"].figures() == {
        "shape": "ring", "height_mm": 2.0, "diameter_mm": 8.0, "inner_diameter_mm": 4.0,
    }  # fmt: skip
    assert MAGNET_PARTS["B8x4x2"].figures() == {
        "shape": "block", "height_mm": 2.0, "size_mm": (8.0, 4.0),
    }  # fmt: skip


TABLE = """
N35 1.17 1.20 1.23
N38 1.22 1.24 1.26
N40 1.25 1.27 1.29
N42 1.28 1.31 1.33
N45 1.32 1.35 1.38
N48 1.37 1.40 1.42
N50 1.40 1.43 1.46
N52 1.42 1.45 1.48
"""
"""Remanence (T) as sellers' tables have it: least, typical, largest."""


def test_grades_are_those_of_sellers_tables_and_admit_their_own_range():
    for grade, row in zip(GRADES.values(), TABLE.split("\n")[1:-1], strict=True):
        wanted = (grade.remanence_min_t, grade.remanence_t, grade.remanence_max_t)
        assert f"{grade.name} {'{:.2f} {:.2f} {:.2f}'.format(*wanted)}" == row
    grades = GRADES.values()
    for grade in grades:
        assert grade.admits(grade.remanence_min_t)
        assert grade.admits(grade.remanence_max_t)
        assert not grade.admits(grade.remanence_min_t - 1e-9)
        assert not grade.admits(grade.remanence_max_t + 1e-9)


def test_addresses_of_chips_are_those_of_their_data_sheets():
    """SLYS045 table 5; Melexis 0b00011 and two pins; Infineon's A0 to A3 in 8 bits: 6A, 44, F0, 88."""
    tmag, mlx, tle = (bus_chip(part) for part in ("TMAG5273A1", "MLX90393", "TLE493DW2B6A0"))
    assert dict(tmag.addresses) == {"A": 0x35, "B": 0x22, "C": 0x78, "D": 0x44}
    assert [address for _, address in mlx.addresses] == [0b0001100 + pins for pins in range(4)]
    assert [name[-3:] for name, _ in mlx.addresses] == ["0 0", "0 1", "1 0", "1 1"]
    assert [2 * address for _, address in tle.addresses] == [0x6A, 0x44, 0xF0, 0x88]
    assert [chip.movable for chip in (tmag, mlx, tle)] == [True, False, False]
    assert [chip.variant for chip in (tmag, mlx, tle)] == [1, 0, 0]
    assert (tmag.read_bytes, mlx.read_bytes, tle.read_bytes) == (12, 12, 21)
    assert (tmag.supply_ma, mlx.supply_ma) == (2.3, 3.0)
    assert tle.supply_ma == pytest.approx(3.4 / 4, abs=0.2)
    assert tmag.power_up_ms == 0.27
    assert MUX_ADDRESSES == (0x70, 0x71, 0x72, 0x73, 0x74, 0x75, 0x76, 0x77)


def test_conversions_take_what_the_data_sheets_say():
    assert bus_chip("TMAG5273C2").conversion_ms(8) == pytest.approx(0.825)
    axis, around = 67 + 64 * 2**2 * (2 + 2**4), 424 + 120
    wanted = 1e-3 * (3 * axis + 67 + 192 + around)
    for averaging in (1, 32):
        assert MLX90393.conversion_ms(averaging) == pytest.approx(wanted, rel=1e-3)
    assert 1e3 / bus_chip("TLE493DW2B6A3").conversion_ms(1) < 770
    kilohertz = {1: 10, 2: 5.7, 4: 3.1, 8: 1.6, 16: 0.8, 32: 0.4}
    fixed_us, each_us = bus_chip("TMAG5273A2").conversion_us
    for averaging, rate in kilohertz.items():  # the table is of three axes; we read temperature too
        assert 1e3 / (fixed_us + 3 / 4 * each_us * averaging) == pytest.approx(rate, rel=0.04)
    assert conversion_ms("MLX90393", 4) == MLX90393.conversion_ms(4)
    assert conversion_ms("generic", 4) == 0.0


def test_boards_have_their_pins():
    mega, pico = MEGA2560, PICO
    assert mega.outputs == tuple(f"D{n}" for n in range(22, 50) if not 38 <= n <= 41)
    assert mega.load_pins[:4] == ("D40", "D41", "D38", "D39")
    assert mega.load_pins[4:] == ("D50", "D51", "D52", "D53")
    assert mega.analog_pins == ("A0", "A1", "A2", "A3", "A4", "A5", "A6", "A7")
    assert [(bus.sda, bus.scl) for bus in mega.buses] == [("D20", "D21")]
    assert [(bus.sda, bus.scl) for bus in pico.buses] == [("GP4", "GP5"), ("GP6", "GP7")]
    free = {f"GP{n}" for n in range(29)} - {f"GP{n}" for n in (4, 5, 6, 7, 23, 24, 25)}
    assert set(pico.outputs) == set(pico.load_pins) == free
    assert pico.outputs[-4:] == ("GP0", "GP1", "GP2", "GP3")
    assert pico.outputs[:15] == tuple(f"GP{n}" for n in range(8, 23))
    assert pico.load_pins[:4] == ("GP2", "GP3", "GP0", "GP1")
    assert pico.analog_pins == ("GP28", "GP27", "GP26")
    for board in BOARDS.values():
        for pins in (board.outputs, board.load_pins, board.analog_pins):
            assert len(set(pins)) == len(pins)


def test_boards_give_what_their_makers_say():
    """ATmega2560: 10 bits at 5 V, 50 mA at 3.3 V, 200 mA of outputs; RP2040: MicroPython's 16 bits at
    3.3 V through 15 / 25 of a divider, 300 mA at 3.3 V, 50 mA of outputs."""
    assert (MEGA2560.logic_v, PICO.logic_v) == (5.0, 3.3)
    assert MEGA2560.adc == (5.0, 2**10, 1.0)
    assert PICO.adc == (3.3, 2**16, 15 / 25)
    assert (MEGA2560.rail_ma, MEGA2560.outputs_ma) == (50.0, 200.0)
    assert (PICO.rail_ma, PICO.outputs_ma) == (300.0, 50.0)
    assert MEGA2560.bauds == (115_200, 250_000, 500_000, 1_000_000)
    assert (PICO.bauds, PICO.usb, MEGA2560.usb) == ((115_200,), True, False)


def test_hall_sensors_have_the_ranges_of_their_data_sheets():
    """Steps in µT of MLX90393 at HALLCONF 0xC; bits of the TLE493D over ±160 mT."""
    ranges = {n: [(r.range_mt, r.counts_per_mt) for r in p.ranges] for n, p in HALL_PARTS.items()}
    for letter in "ABCD":
        assert ranges[f"TMAG5273{letter}1"] == [(40.0, 820.0), (80.0, 410.0)]
        assert ranges[f"TMAG5273{letter}2"] == [(133.0, 250.0), (266.0, 125.0)]
        assert HALL_PARTS[f"TMAG5273{letter}1"].datasheet_noise_ut == (125.0, 125.0, 68.0)
        assert HALL_PARTS[f"TMAG5273{letter}2"].datasheet_noise_ut == (147.0, 147.0, 89.0)
    steps_ut = [1e3 / counts for _, counts in ranges["MLX90393"]]
    assert_allclose(steps_ut, [0.150, 0.300, 0.751, 1.502], rtol=1e-12)
    full_mt = [2**15 * 1e-3 * step for step in steps_ut]
    assert_allclose([r for r, _ in ranges["MLX90393"]], full_mt, rtol=5e-3)
    for k in range(4):
        assert ranges[f"TLE493DW2B6A{k}"] == [(80.0, 15.4), (160.0, 7.7)]
    assert set(HALL_PARTS) == {
        *(f"TMAG5273{letter}{v}" for letter in "ABCD" for v in (1, 2)),
        *(f"TLE493DW2B6A{k}" for k in range(4)), "MLX90393", "MLX90393-0x18", GENERIC_PART,
    }  # fmt: skip


def test_noise_of_the_sheet_is_of_one_conversion_in_microtesla():
    noise = HALL_PARTS.named("TMAG5273B1").noise
    assert (noise.counts, noise.counts_per_mt, noise.averaging) == ((125.0, 125.0, 68.0), 1e3, 1)
    assert_allclose(noise.scaled(820.0, 32), (18.12, 18.12, 9.857), rtol=1e-3)
    assert HALL_PARTS.named("MLX90393").noise is None


def test_a_range_that_just_holds_is_taken_and_a_wider_one_exceeds():
    assert HALL_PARTS.named("TMAG5273A1").range_covering(40.0).range_mt == 40.0
    assert HALL_PARTS.named("TMAG5273A1").range_covering(40.01).range_mt == 80.0
    with pytest.raises(InputError, match=r"80\.01 is beyond"):
        HALL_PARTS.named("TMAG5273A1").range_covering(80.01)
    part, wider = wider_range("TMAG5273A1", 40.0, 80.0)
    assert (part.name[-1], wider.range_mt) == ("2", 133.0)
    assert wider_range("TMAG5273A1", 40.0, 266.0) is None
    assert wider_range("TMAG5273A1", 266.0, 20.0) is None
    assert wider_range("TLE493DW2B6A0", 80.0, 90.0)[1].range_mt == 160.0, "its own, coarse or not"


def test_a_part_is_fine_where_all_of_its_ranges_are():
    for counts, fine in (((100.0,), True), ((99.9,), False), ((200.0, 50.0), False)):
        assert is_fine(HallPart("made up", tuple(SensorRange(1.0, one) for one in counts))) == fine


def test_rubbers_are_those_of_their_makers_bulletins():
    """Mix ratio, pot life (min), cure (h), elongation at break (%) and g/cm³."""
    bulletins = {
        "Platsil Gel-10": ((1, 1), 6, 0.5, 970, 1.07), "Ecoflex 00-30": ((1, 1), 45, 4, 900, 1.07),
        "Dragon Skin 10": ((1, 1), 20, 5, 1000, 1.07), "Dragon Skin 20": ((1, 1), 25, 4, 620, 1.08),
        "Dragon Skin 30": ((1, 1), 45, 16, 364, 1.08), "TPU 85A": ((1, 0), None, None, 600, 1.18),
    }  # fmt: skip
    found = {
        name: (one.casting.mix_ratio, one.casting.pot_life_min, one.casting.cure_h,
               one.casting.elongation_percent, one.density_g_per_cm3)
        for name, one in SILICONES.items()
    }  # fmt: skip
    assert found == bulletins
    assert {one.poisson_ratio for one in SILICONES.values()} == {0.4999, 0.48}


def test_moduli_follow_from_the_makers_100_percent_moduli_and_hardness():
    """Smooth-On in psi at 100 %: 10, 22, 49, 86; E = 12/7 σ lies in the interval of each."""
    for name, psi in (
        ("Ecoflex 00-30", 10),
        ("Dragon Skin 10", 22),
        ("Dragon Skin 20", 49),
        ("Dragon Skin 30", 86),
    ):
        modulus = SILICONES[name].modulus
        secant = 12 / 7 * psi * 6.895e-3
        assert modulus.admits(secant * 0.98), name
        assert modulus.low_mpa < modulus.youngs_modulus_mpa < modulus.high_mpa
        middle = (modulus.low_mpa * modulus.high_mpa) ** 0.5
        assert modulus.youngs_modulus_mpa == pytest.approx(middle, rel=0.2)
    assert SILICONES["Platsil Gel-10"].modulus.range_mpa == (0.15, 0.54)
    estimate = ModulusEstimate(1.0, 0.5, 2.0, "here")
    assert estimate.admits(0.5)
    assert estimate.admits(2.0)
    assert not estimate.admits(0.49)
    assert not estimate.admits(2.01)


def test_packs_hold_the_pieces_and_prices_are_ranges():
    order = Order("screws", "a", "b", (2.0, 5.0), 20)
    assert [order.packs(n) for n in (0, 1, 20, 21, 40, 41)] == [0, 1, 1, 2, 2, 3]
    assert order.middle_eur == pytest.approx(3.5 / 20)
    assert Order("one", "a", "b", (2.0, 5.0)).middle_eur == 3.5
    for name, one in ORDERS.items():
        low, high = one.price_eur
        assert 0 < low < high <= 6 * low, name
        assert one.pieces == (20 if name == "M3 x 16" else 1)
    assert set(HALL_PARTS) - {GENERIC_PART} <= set(ORDERS)
    assert {"mega2560", "pico", "USB mega2560", "USB pico", *SILICONES} <= set(ORDERS)

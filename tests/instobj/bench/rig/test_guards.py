"""Guards of a press rig one by one: the floor of the line, readings that are none, the expected force."""

import numpy as np
import pytest

from design.spec.load_cell import LoadCellSpec
from design.spec.object import ObjectSpec
from instobj.bench.rig.chips import Chips, NoWitness
from instobj.bench.rig.contact_law import contact_law
from instobj.bench.rig.load_cell import LoadCell, NoReading, largest_reading_n
from instobj.bench.rig.machine import MachineFault, MachineLink
from instobj.bench.rig.phases import Phase, require_following


class Sink:
    def __init__(self):
        self.got = b""

    def read(self, _):
        return b""

    def write(self, data):
        self.got += data
        return len(data)


def test_no_line_below_the_floor_leaves_for_the_machine():
    line = Sink()
    link = MachineLink(line, "machine")
    with pytest.raises(MachineFault, match="It was not sent"):
        link.send("G53G0Z-1")  # before any floor is set
    link.floor_mm = -10.0
    link.send("G53G0X-1Y-2", "G53G1Z-10F60")
    for below in ("G53G1Z-10.01F60", "G53G0X-1Z-11"):
        with pytest.raises(MachineFault, match="lowest height that is safe now"):
            link.send_whole(["G53G0Z-2", below])
    assert line.got == b"G53G0X-1Y-2\nG53G1Z-10F60\n"


def test_a_press_follows_homing_only_and_nothing_follows_a_lost_position_but_homing():
    require_following(Phase.ABOVE, Phase.PRESSING)
    for now, then in [
        (Phase.OFF, Phase.PRESSING),
        (Phase.OFF, Phase.SEEKING),
        (Phase.SEEKING, Phase.PRESSING),
        (Phase.LOST, Phase.STOPPING),
        (Phase.LOST, Phase.PRESSING),
    ]:
        with pytest.raises(AssertionError):
            require_following(now, then)


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf, 200.0, -200.0])
def test_readings_at_the_end_of_a_scale_are_none(value):
    cell = LoadCell(largest_reading_n(LoadCellSpec(kind="hx711")))
    cell.take(150.0, 0.0)
    with pytest.raises(NoReading, match="end of its scale"):
        cell.take(value, 0.1)


def test_ends_of_scales_follow_from_the_data_sheet():
    """2^23 counts of an HX711 at gain 128 are 20 mV: four times the capacity of a bridge of 1 mV/V at 5 V."""
    assert largest_reading_n(LoadCellSpec(kind="hx711")) == pytest.approx(4 * 49.03, rel=0.06)
    assert largest_reading_n(LoadCellSpec(kind="analog")) == pytest.approx(61.25, rel=0.06)
    assert largest_reading_n(LoadCellSpec()) == np.inf


@pytest.mark.parametrize("digits", [1, 2, 3, 6])
def test_a_cell_that_rounds_may_repeat_itself_and_no_longer(digits):
    """A sound cell of any resolution never counts as stuck in 20 000 readings; a stuck one does soon."""
    rng, cell = np.random.default_rng(5), LoadCell()

    def reading():
        return round(0.4 + 0.05 * rng.standard_normal(), digits)

    for k in range(60):
        cell.take(reading(), 0.1 * k)
    cell.learn(60, 20.0)
    for k in range(20_000):
        cell.take(reading(), 0.1 * k)
        cell.require_alive(-1.0, 0.2)
    last = reading()
    for _ in range(120):
        cell.take(last, 0.0)
    with pytest.raises(NoReading, match="stands still"):
        cell.require_alive(-1.0, 0.2)


def test_a_force_that_does_not_change_while_the_tip_goes_on_is_told_at_the_third_reading():
    rng, cell = np.random.default_rng(5), LoadCell()
    for k in range(60):
        cell.take(0.4 + 0.01 * rng.standard_normal(), 0.1 * k)
    cell.learn(60, 20.0)
    for height_mm in (-1.0, -1.15):
        cell.take(3.0, 0.0)
        cell.require_alive(height_mm, 0.2)
    cell.take(3.0, 0.0)
    cell.require_alive(-1.15, 0.2)  # at a stop it may repeat itself
    with pytest.raises(NoReading, match="3 readings"):
        cell.require_alive(-1.3, 0.2)


def test_chips_see_a_contact_and_not_their_noise():
    """Noise of 20 000 frames is never a contact, and 150 counts on one of 45 channels always are."""
    spec, rng = ObjectSpec(name="cube").sensors, np.random.default_rng(2)
    names = tuple(f"F{face}-{axis}{k}" for face in range(1, 6) for k in (1, 2, 3) for axis in "XYZ")
    noise = np.array([spec.noise_counts["XYZ".index(name[3])] for name in names])
    chips = Chips(spec.noise_counts, 0.0)

    def frame(k, more=0.0):
        counts = 500 + noise * rng.standard_normal(len(names))
        counts[20] += more
        chips.take(tuple(np.round(counts).tolist()), 100 * k)

    chips.rest()
    for k in range(15):
        frame(k)
    chips.rested(names, 0.0)
    seen = unseen = 0
    for k in range(15, 5015):
        frame(k)
        seen, unseen = seen + chips.see(1.0), unseen + chips.see_nothing(1.0)
    assert seen == 0
    assert unseen > 0.98 * 5000
    for k in range(5015, 5020):
        frame(k, 200.0)
    assert chips.see(1.0)
    assert not chips.see_nothing(1.0)


def test_a_board_that_stands_still_is_told_and_one_that_repeats_a_reading_is_not():
    chips, rng = Chips((22.0, 22.0, 11.0), 60.0), np.random.default_rng(1)
    for k in range(200):  # reads every chip at half its rate of frames
        if k % 2 == 0:
            counts = tuple(rng.integers(0, 999, 9).astype(float).tolist())
        chips.take(counts, 100 * k)
    for k in range(200, 203):
        chips.take(counts, 100 * k)
    with pytest.raises(NoWitness, match="6 frames of the board in a row are the same"):
        chips.take(counts, 100 * k + 100)
    for _ in range(5):
        chips.take(tuple(rng.integers(0, 999, 9).astype(float).tolist()), 77)
    with pytest.raises(NoWitness, match="times of frames"):
        chips.take(tuple(rng.integers(0, 999, 9).astype(float).tolist()), 77)
    with pytest.raises(NoWitness, match="no chip"):
        chips.take((np.nan,) * 9, 78)


def test_the_expected_force_is_hertz_on_a_thick_shell_and_boussinesq_under_a_flat_punch():
    """4/3 E* √R d^1.5 and 2 E* a d on a half-space; the layer adds its factor, which is 1 for none."""
    thick = {"body": {"size_mm": [900.0] * 3}, "shell": {"thickness_mm": 200.0}}
    ball = contact_law(ObjectSpec(name="cube", **thick))
    modulus = 0.414 / (1 - 0.4999**2)
    for depth_mm in (1.0, 2.0):
        hertz = 4 / 3 * modulus * 5**0.5 * depth_mm**1.5
        assert ball.force_n(depth_mm) == pytest.approx(hertz, rel=0.05)
    flat = contact_law(
        ObjectSpec(name="cube", indenter={"kind": "flat", "radius_mm": 4.0}, **thick)
    )
    assert flat.force_n(3.0) == pytest.approx(2 * modulus * 4.0 * 3.0, rel=0.05)
    assert flat.force_n(6.0) == pytest.approx(2 * flat.force_n(3.0), rel=0.01)


def test_on_the_papers_cube_it_lies_in_the_upper_half_of_what_finite_elements_give():
    """5 to 9 N over the places at 2 mm: a bound lies above the soft ones."""
    law = contact_law(ObjectSpec(name="cube"))
    assert 7.0 < law.force_n(2.0) < 9.0
    assert law.depth_mm(law.force_n(2.0)) == pytest.approx(2.0, abs=0.01)
    assert law.ratio(
        np.array([0.0, 1.0, 2.0]), 2 * np.array([0.0, law.force_n(1.0), law.force_n(2.0)])
    ) == (pytest.approx(2.0, rel=1e-3))

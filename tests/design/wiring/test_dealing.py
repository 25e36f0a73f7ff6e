"""Chips dealt to buses, each way up to where it is full, by hand."""

from dataclasses import replace

import pytest

from design.catalogue.bus_parts import MEGA2560, MUX_ADDRESSES, PICO, bus_chip
from design.wiring.dealing import (
    EXPANDED,
    FACTORY,
    MIXED,
    MULTIPLEXED,
    STARTED,
    CannotError,
    ChipOnBus,
    dealt,
)

TMAG = bus_chip("TMAG5273A1")


def chips(count, part="TMAG5273A1"):
    one = ChipOnBus(1, 1, part, "A", 0x35, 0x35, 0, 100.0)
    return [replace(one, number=k + 1) for k in range(count)]


@pytest.mark.parametrize(("board", "buses"), [(MEGA2560, 1), (PICO, 2)])
def test_factory_addresses_serve_four_chips_of_a_bus(board, buses):
    found = dealt(FACTORY, chips(4 * buses), board, buses)
    letters = [(chip.bus, chip.part, chip.address) for chip in found]
    each = [("TMAG5273A1", 0x35), ("TMAG5273B1", 0x22), ("TMAG5273C1", 0x78), ("TMAG5273D1", 0x44)]
    assert letters == [(bus, *one) for bus in range(buses) for one in each]
    assert all(chip.factory == chip.address for chip in found)
    with pytest.raises(CannotError, match="has 4 addresses by order code"):
        dealt(FACTORY, chips(4 * buses + 1), board, buses)


def test_chips_started_one_by_one_get_a_free_address_and_an_output_each():
    most = len(MEGA2560.outputs)
    found = dealt(STARTED, chips(most), MEGA2560, 1)
    assert [chip.supply for chip in found] == list(MEGA2560.outputs)
    taken = {address for _, address in TMAG.addresses}
    free = [a for a in range(0x10, 0x70) if a not in taken][:most]
    assert [chip.address for chip in found] == free
    assert {chip.factory for chip in found} == {0x35}
    with pytest.raises(CannotError, match="need a supply pin each"):
        dealt(STARTED, chips(most + 1), MEGA2560, 1)
    with pytest.raises(CannotError, match="cannot be changed while it runs"):
        dealt(STARTED, chips(2, "MLX90393"), MEGA2560, 1)


def test_expanders_power_sixteen_chips_each_away_from_all_addresses_of_chips():
    """0x22 is an address of a TMAG5273: no expander has it."""
    found = dealt(EXPANDED, chips(33), PICO, 1)
    assert [chip.expander for chip in found] == [0x20] * 16 + [0x21] * 16 + [0x23]
    assert [found[k].supply for k in (0, 7, 8, 15, 16)] == ["GPA0", "GPA7", "GPB0", "GPB7", "GPA0"]
    addresses = [chip.address for chip in found]
    assert len(set(addresses)) == 33
    assert not set(addresses) & {0x35, 0x22, 0x78, 0x44, *range(0x20, 0x28)}
    assert all(chip.supply_pin is None for chip in found)
    with pytest.raises(CannotError, match="free addresses"):
        dealt(EXPANDED, chips(90), PICO, 1)
    with pytest.raises(CannotError, match="cannot be changed while it runs"):
        dealt(EXPANDED, chips(2, "MLX90393"), PICO, 1)
    with pytest.raises(CannotError, match="5 V"):
        dealt(EXPANDED, chips(2), MEGA2560, 1)


@pytest.mark.parametrize(("way", "per_channel"), [(MULTIPLEXED, 1), (MIXED, 4)])
def test_eight_multiplexers_take_eight_channels_each(way, per_channel):
    room = 8 * 8 * per_channel
    found = dealt(way, chips(room), MEGA2560, 1)
    for k in (0, 1, per_channel, 8 * per_channel - 1, 8 * per_channel, room - 1):
        chip = found[k]
        assert (chip.multiplexer, chip.channel) == (
            MUX_ADDRESSES[k // per_channel // 8],
            k // per_channel % 8,
        )
        assert chip.address == TMAG.addresses[k % per_channel][1]
    assert len({(c.multiplexer, c.channel, c.address) for c in found}) == room
    with pytest.raises(CannotError, match=f"eight multiplexers take {room}"):
        dealt(way, chips(room + 1), MEGA2560, 1)


def test_buses_share_the_chips_as_evenly_as_possible_in_their_order():
    found = dealt(MULTIPLEXED, chips(7), PICO, 2)
    assert [chip.bus for chip in found] == [0] * 4 + [1] * 3
    assert [chip.number for chip in found] == list(range(1, 8))
    assert [chip.channel for chip in found] == [0, 1, 2, 3, 0, 1, 2]

"""Ways to keep chips of one part apart on I²C buses: which chip at which bus, channel, address, pin.

Chips that differ in their factory addresses; chips powered one after another that are given other
addresses at every start, by pins of the board as the paper's
object does, or of an I/O expander; multiplexers with one chip per channel;
multiplexers with chips of different addresses on each channel.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

from design.catalogue.bus_parts import (
    EXPANDER_ADDRESSES,
    EXPANDER_NAME,
    EXPANDER_OUTPUTS,
    IMUS,
    MUX_ADDRESSES,
    MUX_CHANNELS,
    Board,
    BusChip,
    bus_chip,
)
from design.spec.object import ObjectSpec
from design.wiring.lengths import wire_lengths_mm

FACTORY, STARTED, EXPANDED, MULTIPLEXED, MIXED = (
    "factory-addresses",
    "one-by-one",
    "expander",
    "multiplexers",
    "mixed-multiplexers",
)
WAYS = (FACTORY, STARTED, EXPANDED, MULTIPLEXED, MIXED)
_EXPANDER_V = 3.3
"""Supply of sensors and expanders."""
_DEALT_ADDRESSES = [a for a in range(0x10, 0x70) if a not in {imu.address for imu in IMUS.values()}]
"""I²C addresses that are dealt out: none of an IMU, and none reserved by UM10204 or of a multiplexer."""


class CannotError(Exception):
    """Why a way does not work."""


@dataclass(frozen=True)
class ChipOnBus:
    """One sensor: its face and number there, part, and how it is reached.

    `factory` is the address after power-up, `address` the one at which it is read; `multiplexer` is
    that chip's address and `supply` the output that powers the sensor (None:
    always powered), of the board or of the `expander` of that address.
    """

    face: int
    number: int
    part: str
    set_by: str
    factory: int
    address: int
    bus: int
    wire_mm: float
    multiplexer: int | None = None
    channel: int | None = None
    supply: str | None = None
    expander: int | None = None

    @property
    def supply_pin(self) -> str | None:
        """The board's pin that powers the sensor."""
        return None if self.expander is not None else self.supply

    @property
    def label(self) -> str:
        """F1-S2: sensor 2 of face 1."""
        return f"F{self.face}-S{self.number}"


def bare_chips(spec: ObjectSpec, lead_mm: float) -> list[ChipOnBus]:
    """Chips in the order of the frame's channels, all at the address of the specified part."""
    sensors, chip = spec.sensors, bus_chip(spec.sensors.part)
    set_by, address = _specified_address(sensors.part, chip)
    lengths = iter(wire_lengths_mm(spec, lead_mm))
    return [
        ChipOnBus(face, number, sensors.part, set_by, address, address, 0, next(lengths))
        for face in spec.body.sensed
        for number in range(1, sensors.count_per_face + 1)
    ]


def _specified_address(part: str, chip: BusChip) -> tuple[str, int]:
    letter = part[len(chip.name) : len(part) - chip.variant]
    return next((pair for pair in chip.addresses if pair[0] == letter), chip.addresses[0])


def _with_address(chip: ChipOnBus, family: BusChip, index: int) -> ChipOnBus:
    """The chip in its variant of that address: another order code, or other address pins."""
    set_by, address = family.addresses[index]
    by_code = family.set_by == "order code"
    variant = chip.part[len(chip.part) - family.variant :]
    part = f"{family.name}{set_by}{variant}" if by_code else chip.part
    return replace(chip, part=part, set_by=set_by, factory=address, address=address)


def _split_over_buses(chips: Sequence[ChipOnBus], buses: int) -> Iterator[list[ChipOnBus]]:
    """The chips of each bus, split as evenly as possible in their order."""
    edges = [round(len(chips) * k / buses) for k in range(buses + 1)]
    for bus, (first, last) in enumerate(pairwise(edges)):
        yield [replace(chip, bus=bus) for chip in chips[first:last]]


def _deal_factory(
    chips: list[ChipOnBus], family: BusChip, board: Board, buses: int
) -> tuple[ChipOnBus, ...]:
    room = len(family.addresses)
    if len(chips) > room * buses:
        raise CannotError(
            f"{len(chips)} chips, but {family.name} has {room} addresses by {family.set_by} and the "
            f"board {buses} {'bus' if buses == 1 else 'buses'}"
        )
    return tuple(
        _with_address(chip, family, k)
        for dealt in _split_over_buses(chips, buses)
        for k, chip in enumerate(dealt)
    )


def _require_movable(family: BusChip) -> None:
    if not family.movable:
        raise CannotError(f"the address of {family.name} cannot be changed while it runs")


def _free_addresses(family: BusChip) -> list[int]:
    """Addresses that neither a chip after power-up nor an expander has."""
    taken = {address for _, address in family.addresses} | set(EXPANDER_ADDRESSES)
    return [a for a in _DEALT_ADDRESSES if a not in taken]


def _deal_expanded(
    chips: list[ChipOnBus], family: BusChip, board: Board, buses: int
) -> tuple[ChipOnBus, ...]:
    _require_movable(family)
    if board.logic_v > _EXPANDER_V:
        raise CannotError(
            f"{EXPANDER_NAME} would feed sensors with the board's {board.logic_v:g} V"
        )
    if not board.outputs:
        raise CannotError("no pin of the board is left to reset expanders")
    factory = {address for _, address in family.addresses}
    addresses = [a for a in EXPANDER_ADDRESSES if a not in factory]
    free, room = _free_addresses(family), len(addresses) * len(EXPANDER_OUTPUTS)
    powered = []
    for dealt in _split_over_buses(chips, buses):
        if len(dealt) > min(room, len(free)):
            raise CannotError(f"{len(dealt)} chips on a bus, which has {len(free)} free addresses")
        for k, chip in enumerate(dealt):
            number, output = divmod(k, len(EXPANDER_OUTPUTS))
            place = {"supply": EXPANDER_OUTPUTS[output], "expander": addresses[number]}
            powered.append(replace(chip, address=free[k], **place))
    return tuple(powered)


def _deal_started(
    chips: list[ChipOnBus], family: BusChip, board: Board, buses: int
) -> tuple[ChipOnBus, ...]:
    _require_movable(family)
    outputs = board.outputs
    if len(chips) > len(outputs):
        raise CannotError(
            f"{len(chips)} chips need a supply pin each, the board has {len(outputs)}"
        )
    taken = {address for _, address in family.addresses}
    free = [a for a in _DEALT_ADDRESSES if a not in taken]
    pins = iter(outputs)
    return tuple(
        replace(chip, address=free[k], supply=next(pins))
        for dealt in _split_over_buses(chips, buses)
        for k, chip in enumerate(dealt)
    )


def _deal_multiplexed(
    chips: list[ChipOnBus], family: BusChip, board: Board, buses: int
) -> tuple[ChipOnBus, ...]:
    return _put_behind_multiplexers(chips, family, buses, 1)


def _deal_mixed(
    chips: list[ChipOnBus], family: BusChip, board: Board, buses: int
) -> tuple[ChipOnBus, ...]:
    return _put_behind_multiplexers(chips, family, buses, len(family.addresses))


_DEALT: dict[str, Callable[..., tuple[ChipOnBus, ...]]] = {
    FACTORY: _deal_factory,
    STARTED: _deal_started,
    EXPANDED: _deal_expanded,
    MULTIPLEXED: _deal_multiplexed,
    MIXED: _deal_mixed,
}


def _put_behind_multiplexers(
    chips: list[ChipOnBus], family: BusChip, buses: int, per_channel: int
) -> tuple[ChipOnBus, ...]:
    room = len(MUX_ADDRESSES) * MUX_CHANNELS * per_channel
    chips_behind = []
    for dealt in _split_over_buses(chips, buses):
        if len(dealt) > room:
            raise CannotError(f"{len(dealt)} chips on a bus, eight multiplexers take {room}")
        for k, chip in enumerate(dealt):
            number, channel = divmod(k // per_channel, MUX_CHANNELS)
            placed = _with_address(chip, family, k % per_channel) if per_channel > 1 else chip
            chips_behind.append(replace(placed, multiplexer=MUX_ADDRESSES[number], channel=channel))
    return tuple(chips_behind)


def dealt(way: str, chips: list[ChipOnBus], board: Board, buses: int) -> tuple[ChipOnBus, ...]:
    """Deal the chips over `buses` of the board's buses, one way.

    Raises
    ------
    CannotError
        Too many chips for the addresses or pins, or chips that cannot be distinguished that way.
    """
    return _DEALT[way](chips, bus_chip(chips[0].part), board, buses)

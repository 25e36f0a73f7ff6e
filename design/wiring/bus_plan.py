"""Plan of the I²C buses of an object on a board: which chip at which bus, channel, address and pin.

Every way of `dealing` is tried on as few buses as it needs; the cheapest that works is taken.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace

from design.catalogue.bus_parts import (
    BOARDS,
    IMUS,
    PIN_PF,
    WIRE_PF_PER_MM,
    Board,
    BusChip,
    Imu,
    bus_chip,
)
from design.catalogue.orders import BUFFER, EXPANDER, MUX, ORDERS, RESISTOR, SHIFTER
from design.errors import InputError
from design.spec.object import ObjectSpec
from design.wiring.bus_limits import (
    FAST_KHZ,
    STANDARD_KHZ,
    FrameTime,
    frame_time,
    largest_capacitance_pf,
    pullup_kohm,
    with_imu,
)
from design.wiring.dealing import WAYS, CannotError, ChipOnBus, bare_chips, dealt
from design.wiring.lengths import LEAD_MM
from design.wiring.load_cell import LoadCellPlan, load_cell_plan

_CHIP_V = 3.3
"""Logic level of the chips; a board of another level needs a buffer."""
_BUFFERS_A_PACKAGE = 6
"""Buffers in one package."""


@dataclass(frozen=True)
class BusPlan:
    """A plan that works: chips in the order of the frame's channels, and its figures.

    `capacitance_pf` is the capacitance of the largest line as the board sees it with one channel switched on;
    `reset` the output that resets multiplexers and expanders.
    """

    board: Board
    way: str
    chips: tuple[ChipOnBus, ...]
    khz: float
    baud: int
    capacitance_pf: float
    pullup_kohm: float
    time: FrameTime
    reset: str | None
    extras: tuple[tuple[str, int], ...]
    load: LoadCellPlan | None = None
    imu: Imu | None = None

    @property
    def buses(self) -> tuple[int, ...]:
        """Numbers of the board's buses that are used."""
        return tuple(sorted({chip.bus for chip in self.chips}))

    @property
    def multiplexers(self) -> tuple[tuple[int, int], ...]:
        """Bus and address of every multiplexer."""
        addresses = {(c.bus, c.multiplexer) for c in self.chips if c.multiplexer is not None}
        return tuple(sorted(addresses))

    @property
    def expanders(self) -> tuple[tuple[int, int], ...]:
        """Bus and address of every I/O expander."""
        return _expanders(self.chips)

    @property
    def pins(self) -> int:
        """Pins of the board besides supply and ground."""
        supplies = sum(chip.supply_pin is not None for chip in self.chips)
        loads = 0 if self.load is None else len(self.load.pins)
        return 2 * len(self.buses) + supplies + (self.reset is not None) + loads

    @property
    def wires(self) -> int:
        """Four for each sensor and the IMU, five for each multiplexer or expander,
        those to the board's pins, and the load cell's."""
        supplies = sum(chip.supply_pin is not None for chip in self.chips)
        to_board = 2 * len(self.buses) + supplies + 2
        loads = [] if self.load is None else self.load.wires(self.board)
        parts = len(self.multiplexers) + len(self.expanders)
        motion = 0 if self.imu is None else 4
        return 4 * len(self.chips) + 5 * parts + to_board + len(loads) + motion

    @property
    def cost_eur(self) -> float:
        """Cost of what the plan needs beyond board and sensors, at the middle of the guide prices."""
        return sum(ORDERS[name].middle_eur * count for name, count in self.extras)


@dataclass(frozen=True)
class Choice:
    """All plans that work, cheapest first, and why the others do not."""

    plans: tuple[BusPlan, ...]
    refused: tuple[tuple[str, str], ...]


def choose_plan(
    spec: ObjectSpec, board: Board, lead_mm: float = LEAD_MM, way: str | None = None
) -> tuple[BusPlan, Choice]:
    """The cheapest plan that can (fewest wires among equals), or that of one way.

    Raises
    ------
    InputError
        No plan works: every reason, and what the other boards can do.
    """
    choice = all_plans(spec, board, lead_mm)
    plans = [plan for plan in choice.plans if way in (None, plan.way)]
    if plans:
        return plans[0], choice
    reasons = "; ".join(f"{name}: {why}" for name, why in choice.refused if way in (None, name))
    raise InputError(
        f"no bus plan{f' ({way})' if way else ''} reads {spec.name} with {board.title}: {reasons}. "
        f"{_working_plans(spec, board, lead_mm, choice)}"
    )


def plan_or_none(spec: ObjectSpec, board: Board) -> BusPlan | None:
    """The cheapest plan that can, None where no plan works."""
    try:
        return choose_plan(spec, board)[0]
    except InputError:
        return None


def first_plan(spec: ObjectSpec) -> BusPlan | None:
    """Return the plan of the catalogue's first board that can read the object; None where none can."""
    plans = (plan_or_none(spec, board) for board in BOARDS.values())
    return next((plan for plan in plans if plan is not None), None)


def all_plans(spec: ObjectSpec, board: Board, lead_mm: float = LEAD_MM) -> Choice:
    """Every way on as few of the board's buses as it needs.

    Raises
    ------
    InputError
        A part without an I²C interface.
    """
    bus_chip(spec.sensors.part)
    plans, refused = [], []
    for way in WAYS:
        for buses in range(1, len(board.buses) + 1):
            try:
                plans.append(_plan(spec, board, lead_mm, way, buses))
                break
            except CannotError as error:
                reason = str(error)
        else:
            refused.append((way, reason))
    plans.sort(key=lambda plan: (plan.cost_eur, plan.wires))
    return Choice(tuple(plans), tuple(refused))


def _working_plans(spec: ObjectSpec, board: Board, lead_mm: float, choice: Choice) -> str:
    """Plans that work, here or on another board."""
    named = [(board, plan) for plan in choice.plans[:1]]
    others = (other_board for other_board in BOARDS.values() if other_board is not board)
    named += [(o, plan) for o in others for plan in all_plans(spec, o, lead_mm).plans[:1]]
    if not named:
        return (
            "No other board can: lower sensors.frame_rate_hz, have fewer sensors or shorter leads"
        )
    able = "; ".join(
        f"--board {b.name} can, by {p.way} ({p.pins} pins, {p.cost_eur:.0f} EUR of parts, up to "
        f"{p.time.fastest_hz:.0f} Hz)"
        for b, p in named
    )
    return f"The cheapest that can: {able}"


def _plan(spec: ObjectSpec, board: Board, lead_mm: float, way: str, buses: int) -> BusPlan:
    chip = bus_chip(spec.sensors.part)
    load = load_cell_plan(spec.load_cell, board)
    free = replace(board, outputs=_pins_left(board.outputs, load))
    chips = dealt(way, bare_chips(spec, lead_mm), free, buses)
    imu = IMUS.get(spec.imu)
    require_current(chips, chip, board, load, imu)
    require_level(imu, board, chips)
    resets = chips[0].multiplexer is not None or chips[0].expander is not None
    reset = free.outputs[0] if resets else None
    khz, capacitance, pullup = _clock(spec, board, chips)
    time, baud = _rate(spec, board, chip, chips, khz, load)
    extras = _extras(board, chips, load) + (() if imu is None else ((imu.name, 1),))
    return BusPlan(
        board, way, chips, khz, baud, capacitance, pullup, time, reset, extras, load, imu
    )


def require_level(imu: Imu | None, board: Board, chips: Sequence[ChipOnBus]) -> None:
    """Refuse an IMU of 3.6 V at most on a bus of 5 V, which multiplexers have at such a board."""
    if imu is not None and board.logic_v > _CHIP_V and chips[0].multiplexer is not None:
        raise CannotError(
            f"{imu.name} bears 3.6 V, and the bus before multiplexers has {board.logic_v:g} V"
        )


def _pins_left(outputs: tuple[str, ...], load: LoadCellPlan | None) -> tuple[str, ...]:
    """Pins that the load cell leaves for the sensors."""
    taken = () if load is None else load.pins
    return tuple(pin for pin in outputs if pin not in taken)


def require_current(
    chips: Sequence[ChipOnBus],
    family: BusChip,
    board: Board,
    load: LoadCellPlan | None,
    imu: Imu | None,
) -> None:
    needed_ma = len(chips) * family.supply_ma
    from_outputs = chips[0].supply_pin is not None and board.logic_v == _CHIP_V
    if load is not None and board.logic_v == _CHIP_V and not from_outputs:
        needed_ma += load.rail_ma
    if imu is not None and not from_outputs:
        needed_ma += imu.supply_ma
    given_ma = board.outputs_ma if from_outputs else board.rail_ma
    if needed_ma > given_ma:
        source = "outputs give" if from_outputs else "3.3 V pin gives"
        raise CannotError(
            f"{len(chips)} chips draw {needed_ma:.0f} mA, the board's {source} {given_ma:.0f} mA"
        )


def _clock(
    spec: ObjectSpec, board: Board, chips: Sequence[ChipOnBus]
) -> tuple[float, float, float]:
    """Bus clock (kHz), capacitance (pF) and pull-up (kΩ): 400 kHz, else 100 kHz."""
    pulled_v = board.logic_v if chips[0].multiplexer is not None else _CHIP_V
    capacitance = largest_line_pf(chips) + (PIN_PF if spec.imu in IMUS else 0.0)
    for khz in (FAST_KHZ, STANDARD_KHZ):
        pullup = pullup_kohm(khz, pulled_v, capacitance)
        if pullup is not None and capacitance <= largest_capacitance_pf(khz, pulled_v):
            return khz, capacitance, pullup
    raise CannotError(
        f"a line of the bus has {capacitance:.0f} pF, and may have "
        f"{largest_capacitance_pf(STANDARD_KHZ, pulled_v):.0f} pF even at {STANDARD_KHZ:g} kHz"
    )


def largest_line_pf(chips: Sequence[ChipOnBus]) -> float:
    """Capacitance of the largest line: board, multiplexers, and the channel that is switched on."""
    loads: dict[tuple[int, int | None, int | None], float] = {}
    for chip in chips:
        line = (chip.bus, chip.multiplexer, chip.channel)
        loads[line] = loads.get(line, 0.0) + PIN_PF + WIRE_PF_PER_MM * chip.wire_mm
    muxes = Counter(bus for bus, mux in {(c.bus, c.multiplexer) for c in chips} if mux is not None)
    expanders = Counter(bus for bus, _ in _expanders(chips))
    return max(
        PIN_PF * (1 + 2 * muxes[bus] + expanders[bus]) + load for (bus, _, _), load in loads.items()
    )


def _expanders(chips: Sequence[ChipOnBus]) -> tuple[tuple[int, int], ...]:
    """Bus and address of every I/O expander."""
    places = {(chip.bus, chip.expander) for chip in chips if chip.expander is not None}
    return tuple(sorted(places))


def _rate(
    spec: ObjectSpec,
    board: Board,
    family: BusChip,
    chips: Sequence[ChipOnBus],
    khz: float,
    load: LoadCellPlan | None,
) -> tuple[FrameTime, int]:
    """Times of a frame, and the slowest baud rate that keeps the specified frame rate."""
    routes = [(c.bus, c.multiplexer, c.channel) for c in chips if c.multiplexer is not None]
    selects = len(set(routes))
    axes = len(spec.sensors.axes)
    wanted = spec.sensors.frame_rate_hz
    for baud in board.bauds:
        time = frame_time(
            board, family, spec.sensors.averaging, khz, baud, len(chips), selects, axes
        )
        if spec.imu in IMUS:
            time = with_imu(time, board, khz, baud)
        if load is not None:
            time = replace(time, loads_ms=1e3 * load.seconds_a_second(board, baud))
        if time.fastest_hz >= wanted:
            return time, baud
    raise CannotError(
        f"{time.fastest_hz:.1f} frames per second at most ({time.reading_ms:.1f} ms to read at "
        f"{khz:g} kHz, {time.line_ms:.1f} ms to send, {time.conversion_ms:.1f} ms to convert, "
        f"{time.loads_ms:.0f} ms per second for the load cell), sensors.frame_rate_hz = {wanted:g}"
    )


def _extras(
    board: Board, chips: Sequence[ChipOnBus], load: LoadCellPlan | None
) -> tuple[tuple[str, int], ...]:
    """Parts beyond board and sensors: 3.3 V chips at a 5 V board need their levels changed."""
    muxes = len({(c.bus, c.multiplexer) for c in chips if c.multiplexer is not None})
    buses = len({c.bus for c in chips})
    lines = 2 * (buses + len({(c.bus, c.multiplexer, c.channel) for c in chips if muxes}))
    counts = {RESISTOR: lines, MUX: muxes, EXPANDER: len(_expanders(chips))}
    if board.logic_v > _CHIP_V and not muxes:
        counts[SHIFTER] = buses
        counts[BUFFER] = -(-sum(c.supply is not None for c in chips) // _BUFFERS_A_PACKAGE)
    for name, count in () if load is None else load.parts(board):
        counts[name] = counts.get(name, 0) + count
    return tuple((name, count) for name, count in counts.items() if count)

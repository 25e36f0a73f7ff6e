"""I²C parts: how Hall sensors are addressed, the multiplexer, and the boards that read them.

Sources. TMAG5273: Texas Instruments SLYS045 (addresses by order code, the register that changes the
address until power is lost, 1.7 to 3.6 V, 2.3 mA, start-up 270 µs). MLX90393: Melexis 3901090393 (two
address pins; 2.2 to 3.6 V, 3 mA in burst mode). TLE493D-W2B6: registers, addresses and rates as in Infineon's
own driver (XENSIV 3D magnetic sensor library, generation 2); its current is an estimate: 3.4 mA for a
quarter of the time. TCA9548A: Texas Instruments SCPS207 (0x70 to 0x77 by
three pins, eight channels, supply 1.65 to 5.5 V, inputs bear 5 V). Limits of the bus: NXP UM10204.
HX711: Avia Semiconductor's data sheet (±0.5 AVDD over the gain is full scale of 24 bits; ready by a low
data line, 25 clock pulses for gain 128, 60 µs of a high clock power it down; 10 or 80 readings per second).
Boards: Arduino A000067 (ATmega2560), Raspberry Pi SC0915 (RP2040) and their data sheets.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from design.errors import InputError


@dataclass(frozen=True)
class BusChip:
    """A family of Hall sensors on the bus.

    `addresses` name what sets each factory address: the last part of the order code (`A1`), or the
    levels of the address pins. `movable`: a register changes the address until power is lost.
    `conversion_us` is (fixed, per conversion averaged) with temperature, in continuous mode. So many
    characters as `variant` stand behind what sets the address in a part's name (the 1 of `A1`).
    `read_bytes` go over the bus for one reading, addresses included. `driver` names the firmware's file.
    """

    family: str
    addresses: tuple[tuple[str, int], ...]
    set_by: str
    movable: bool
    supply_ma: float
    power_up_ms: float
    conversion_us: tuple[float, float]
    driver: str
    variant: int = 0
    read_bytes: int = 12

    def conversion_ms(self, averaging: int) -> float:
        """Time between two readings of all axes and the temperature."""
        fixed, each = self.conversion_us
        return 1e-3 * (fixed + each * averaging)


TMAG5273 = BusChip(
    "TMAG5273",
    (("A", 0x35), ("B", 0x22), ("C", 0x78), ("D", 0x44)),
    "order code",
    movable=True,
    supply_ma=2.3,
    power_up_ms=0.27,
    conversion_us=(25.0, 100.0),
    driver="tmag5273",
    variant=1,
)
MLX90393 = BusChip(
    "MLX90393",
    (("A1 A0 = 0 0", 0x0C), ("A1 A0 = 0 1", 0x0D), ("A1 A0 = 1 0", 0x0E), ("A1 A0 = 1 1", 0x0F)),
    "address pins",
    movable=False,
    supply_ma=3.0,
    power_up_ms=1.5,
    conversion_us=(14_830.0, 0.0),
    driver="mlx90393",
)
"""Conversion at the settings that the firmware writes, OSR 2 and filter 4, whatever `averaging` says:
67 + 64 · 2² · (2 + 2⁴) µs for each axis, 67 + 192 µs for temperature, 424 + 120 µs around them."""
MLX90393_0X18 = replace(
    MLX90393,
    family="MLX90393-0x18",
    addresses=tuple((pins, address + 0x0C) for pins, address in MLX90393.addresses),
)
"""Chip of order codes whose fixed address bits are others, as on boards at 0x18 to 0x1B."""

TLE493D = BusChip(
    "TLE493DW2B6A",
    (("0", 0x35), ("1", 0x22), ("2", 0x78), ("3", 0x44)),
    "order code",
    movable=False,
    supply_ma=1.0,
    power_up_ms=5.0,
    conversion_us=(1500.0, 0.0),
    driver="tle493d",
    read_bytes=21,
)
"""Converts 770 times a second by itself (low-power mode), whatever `averaging` says. Its register of
addresses chooses among the same four as the order codes, so a chip that is started again would answer
together with the one that kept the factory's address: it is not moved. All registers up to MOD1 are
read, so that a chip that lost its settings is known."""

_FAMILIES = (TMAG5273, MLX90393_0X18, MLX90393, TLE493D)
"""The longer of two names that begin alike goes first."""
SELECT_BYTES = 2
"""Address of a multiplexer and its channel mask."""


def bus_chip(part: str) -> BusChip:
    """Family of a part by its name.

    Raises
    ------
    InputError
        The part has no I²C interface in the catalogue.
    """
    for chip in _FAMILIES:
        if part.startswith(chip.family):
            return chip
    raise InputError(
        f"sensors.part = {part!r} has no I²C bus in the catalogue, so no firmware can be written for it. "
        "Choose TMAG5273 (A1 to D2), MLX90393, MLX90393-0x18 or TLE493DW2B6 (A0 to A3)"
    )


def conversion_ms(part: str, averaging: int) -> float:
    """Time between two readings of a part; 0 of one without a bus in the catalogue, whose time is not
    known."""
    is_catalogued = any(part.startswith(chip.family) for chip in _FAMILIES)
    return bus_chip(part).conversion_ms(averaging) if is_catalogued else 0.0


def frame_ms(conversion_ms: float, busy_ms: float) -> float:
    """Time of a frame: chips convert by themselves while the board is busy with the frame before."""
    return max(conversion_ms, busy_ms)


MUX_NAME = "TCA9548A"
MUX_ADDRESSES = tuple(range(0x70, 0x78))
MUX_CHANNELS = 8
PIN_PF = 10.0
"""Capacitance of every chip on a bus line, at most (UM10204, table 10)."""
WIRE_PF_PER_MM = 0.06
"""Capacitance of a thin hook-up wire in a bundle with its ground; assumed, ribbon cables have 0.04 to
0.07."""


@dataclass(frozen=True)
class Bus:
    """An I²C controller of a board and its pins."""

    name: str
    sda: str
    scl: str


@dataclass(frozen=True)
class Board:
    """A microcontroller board.

    `outputs` are pins that can switch chips on; `logic_v` is their level. `rail_ma` is what its 3.3 V
    pin gives, `outputs_ma` all outputs together. `bauds` of the serial line, slowest first; one entry
    where the line is USB and takes any. `call_us` is the time around each bus transfer and `byte_us`
    to write a character, both of our firmware (Mega: simulated, tests/instobj/bench/firmware). A load cell
    takes pins of `load_pins` (HX711) or one of `analog_pins`, the first ones unless others are asked
    for; `adc` is what its analogue readings are made of: volts of full scale, steps, and the share of
    the sensor's 5 V that reaches the pin. `load_line_us` is the time of reading and of preparing a
    line `L`, without its characters.
    """

    name: str
    title: str
    logic_v: float
    buses: tuple[Bus, ...]
    outputs: tuple[str, ...]
    rail_ma: float
    outputs_ma: float
    bauds: tuple[int, ...]
    usb: bool
    call_us: float
    byte_us: float
    load_pins: tuple[str, ...]
    analog_pins: tuple[str, ...]
    adc: tuple[float, int, float]
    load_line_us: float


MEGA2560 = Board(
    "mega2560",
    "Arduino Mega 2560",
    5.0,
    (Bus("TWI", "D20", "D21"),),
    tuple(f"D{n}" for n in (*range(22, 38), *range(42, 50))),
    rail_ma=50.0,
    outputs_ma=200.0,
    bauds=(115_200, 250_000, 500_000, 1_000_000),
    usb=False,
    call_us=170.0,
    byte_us=16.0,
    load_pins=("D40", "D41", "D38", "D39", *(f"D{n}" for n in range(50, 54))),
    analog_pins=tuple(f"A{n}" for n in range(8)),
    adc=(5.0, 1024, 1.0),
    load_line_us=600.0,
)
PICO = Board(
    "pico",
    "Raspberry Pi Pico (RP2040, MicroPython)",
    3.3,
    (Bus("I2C0", "GP4", "GP5"), Bus("I2C1", "GP6", "GP7")),
    tuple(f"GP{n}" for n in (*range(8, 23), 26, 27, 28, 0, 1, 2, 3)),
    rail_ma=300.0,
    outputs_ma=50.0,
    bauds=(115_200,),
    usb=True,
    call_us=150.0,
    byte_us=15.0,
    load_pins=("GP2", "GP3", *(f"GP{n}" for n in (0, 1, *range(8, 23), 26, 27, 28))),
    analog_pins=("GP28", "GP27", "GP26"),
    adc=(3.3, 65536, 0.6),
    load_line_us=700.0,
)
BOARDS = {board.name: board for board in (MEGA2560, PICO)}


def board_named(name: str) -> Board:
    """The board of that name.

    Raises
    ------
    InputError
        No such board.
    """
    if name not in BOARDS:
        raise InputError(f"no board is called {name!r}. Choose one of {', '.join(BOARDS)}")
    return BOARDS[name]

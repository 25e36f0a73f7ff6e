"""I²C parts: how Hall sensors are addressed, the multiplexer, and the boards that read them.

Sources: bus_chips.toml, boards.toml, imus.toml. TCA9548A: Texas Instruments SCPS207 (0x70 to 0x77 by three
pins, eight channels, supply 1.65 to 5.5 V, inputs bear 5 V). Limits of the bus: NXP UM10204.
HX711: Avia Semiconductor's data sheet (±0.5 AVDD over the gain is full scale of 24 bits; ready by a low
data line, 25 clock pulses for gain 128, 60 µs of a high clock power it down; 10 or 80 readings per second).
"""

from __future__ import annotations

from dataclasses import dataclass

from design.catalogue.tables import read_table
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

    name: str
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


BUS_CHIPS = read_table("bus_chips", BusChip)
TMAG5273, MLX90393 = BUS_CHIPS["TMAG5273"], BUS_CHIPS["MLX90393"]
TLE493D = BUS_CHIPS["TLE493DW2B6A"]
SELECT_BYTES = 2
"""Address of a multiplexer and its channel mask."""


def bus_chip(part: str) -> BusChip:
    """Family of a part by its name.

    Raises
    ------
    InputError
        The part has no I²C interface in the catalogue.
    """
    for chip in BUS_CHIPS.values():
        if part.startswith(chip.name):
            return chip
    raise InputError(
        f"sensors.part = {part!r} has no I²C bus in the catalogue, so no firmware can be written for it. "
        "Choose TMAG5273 (A1 to D2), MLX90393, MLX90393-0x18 or TLE493DW2B6 (A0 to A3)"
    )


def conversion_ms(part: str, averaging: int) -> float:
    """Time between two readings of a part; 0 of one without a bus in the catalogue, whose time is not
    known."""
    is_catalogued = any(part.startswith(chip.name) for chip in BUS_CHIPS.values())
    return bus_chip(part).conversion_ms(averaging) if is_catalogued else 0.0


def frame_ms(conversion_ms: float, busy_ms: float) -> float:
    """Time of a frame: chips convert by themselves while the board is busy with the frame before."""
    return max(conversion_ms, busy_ms)


@dataclass(frozen=True)
class Imu:
    """An inertial part: its address, the register that names it, and what the firmware writes and reads.

    `setup` are pairs of register and value. From the register `data` come twelve bytes: three of the
    angular rate and three of the acceleration, 16 bits each.
    """

    name: str
    address: int
    who: tuple[int, int]
    setup: tuple[tuple[int, int], ...]
    data: int
    rate_first: bool
    low_byte_first: bool
    counts_per_g: float
    counts_per_deg_s: float
    supply_ma: float


IMUS = read_table("imus", Imu)
MOTION = (
    *(f"acceleration_{axis}_m_s2" for axis in "xyz"),
    *(f"rate_{axis}_rad_s" for axis in "xyz"),
)
"""Columns of an IMU in lines and recordings: along the object's axes, specific force and angular rate."""
IMU_READ_BYTES = 15
"""Address, register, address again, and twelve bytes."""
EXPANDER_NAME = "MCP23017"
EXPANDER_ADDRESSES = tuple(range(0x20, 0x28))
EXPANDER_OUTPUTS = tuple(f"GP{port}{bit}" for port in "AB" for bit in range(8))
"""Outputs of 25 mA each, 125 mA together (Microchip DS20001952), which power sensors."""
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
    line `L`, without its characters. `battery_pin` reads half a battery's voltage; a board that has
    one sends by ESP-NOW to a second board, which stands on USB.
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
    battery_pin: str = ""


BOARDS = read_table("boards", Board, "board")
MEGA2560, PICO = BOARDS["mega2560"], BOARDS["pico"]

"""The header `plan.h` of the Arduino Mega's firmware: pins, addresses and settings of an object."""

from __future__ import annotations

from design.spec.object import ObjectSpec
from design.wiring.bus_plan import BusPlan
from design.wiring.dealing import ChipOnBus
from instobj.bench.firmware.settings import (
    axes_in_order,
    channel_names,
    chip_settings,
    frame_us,
    load_settings,
    motion_steps,
    waits_ms,
)

_CLOCK_HZ = 16_000_000
_CONVERSIONS = 256
"""Conversions of the analogue converter in a reading of the load cell (load_cell.c)."""


def port_of(pin: str) -> tuple[str, int]:
    """Port letter and bit of a digital pin (Arduino Mega 2560 Rev3, pinout A000067)."""
    number = int(pin[1:])
    if 22 <= number <= 29:
        return "A", number - 22
    if 30 <= number <= 37:
        return "C", 37 - number
    if number in (38, 39, 40, 41):
        return (("D", 7), ("G", 2), ("G", 1), ("G", 0))[number - 38]
    if 42 <= number <= 49:
        return "L", 49 - number
    if 50 <= number <= 53:
        return "B", 53 - number
    raise ValueError(f"{pin} is none of the pins that plans use (D22 to D53)")


def plan_header(spec: ObjectSpec, plan: BusPlan) -> str:
    """C source of `plan.h`.

    Raises
    ------
    InputError
        Settings that the chip cannot take.
    """
    power_up, conversion = waits_ms(spec, plan)
    figures = {
        "CHIPS": len(plan.chips),
        "AXES": f"0x{sum(2 ** (1 + 'XYZ'.index(axis)) for axis in axes_in_order(spec)):02X}",
        "MULTIPLEXERS": len(plan.multiplexers),
        "FRAME_US": f"{frame_us(spec)}UL",
        "POWER_UP_MS": power_up,
        "CONVERSION_MS": conversion,
        "BUS_TWBR": bit_rate(plan.khz),
        "LINE_BAUD": f"{plan.baud}UL",
        **chip_settings(spec, plan),
        **_reset(plan),
        **_load_cell(spec, plan),
        **_imu(plan),
    }
    defines = "\n".join(f"#define {name} {value}" for name, value in figures.items())
    rows = "\n".join(f"    {_row(chip)}" for chip in plan.chips)
    return _HEADER.format(
        name=spec.name, defines=defines, rows=rows, channels=",".join(channel_names(spec, plan))
    )


def bit_rate(khz: float) -> int:
    """Register TWBR for that clock: f = 16 MHz / (16 + 2 TWBR), never faster (ATmega2560, 24.5.2)."""
    return max(10, -(-int(_CLOCK_HZ / (1e3 * khz) - 16) // 2))


def _reset(plan: BusPlan) -> dict[str, str]:
    if plan.reset is None:
        return {}
    port, bit = port_of(plan.reset)
    return {"RESET_PORT": f"PORT{port}", "RESET_MASK": f"0x{1 << bit:02X}"}


def _load_cell(spec: ObjectSpec, plan: BusPlan) -> dict[str, str | int]:
    """Kind, pins and scale of the load cell; nothing where there is none."""
    if plan.load is None:
        return {}
    kinds: dict[str, str | int] = {"LOAD_HX711": 1, "LOAD_ANALOG": 2}
    kinds["LOAD_CELL"] = f"LOAD_{plan.load.kind.upper()}"
    if plan.load.kind == "analog":
        channel = {"LOAD_CHANNEL": int(plan.load.pins[0][1:])}
        return {**kinds, **channel, **_long(load_settings(spec, plan, sum_of=_CONVERSIONS))}
    for name, pin in zip(("DATA", "CLOCK"), plan.load.pins, strict=True):
        port, bit = port_of(pin)
        kinds |= {f"LOAD_{name}_{what}": f"{what}{port}" for what in ("PORT", "DDR", "PIN")}
        kinds[f"LOAD_{name}_MASK"] = f"0x{1 << bit:02X}"
    return {**kinds, **_long(load_settings(spec, plan))}


def _imu(plan: BusPlan) -> dict[str, str | int]:
    """Registers and scales of the IMU, 1/65536 mm/s² and 1/65536 of 0.1 mrad/s a count."""
    if plan.imu is None:
        return {}
    m_s2, rad_s = motion_steps(plan.imu)
    pairs = ", ".join(f"{{0x{register:02X}, 0x{value:02X}}}" for register, value in plan.imu.setup)
    return {
        "IMU_ADDRESS": f"0x{plan.imu.address:02X}",
        "IMU_WHO": f"0x{plan.imu.who[0]:02X}",
        "IMU_NAME": f"0x{plan.imu.who[1]:02X}",
        "IMU_SETUP": f"{{{pairs}}}",
        "IMU_DATA": f"0x{plan.imu.data:02X}",
        "IMU_RATE_FIRST": int(plan.imu.rate_first),
        "IMU_LOW_FIRST": int(plan.imu.low_byte_first),
        "IMU_ACCELERATION": f"{round(1e3 * m_s2 * 2**16)}LL",
        "IMU_RATE": f"{round(1e4 * rad_s * 2**16)}LL",
    }


def _long(figures: dict[str, int]) -> dict[str, str]:
    return {name: f"({value}LL)" for name, value in figures.items()}


def _row(chip: ChipOnBus) -> str:
    port, bit = ("0", 0) if chip.supply is None else port_of(chip.supply)
    supply = "0, 0" if chip.supply is None else f"&PORT{port}, 0x{1 << bit:02X}"
    mux = (
        "0, 0"
        if chip.multiplexer is None or chip.channel is None
        else f"0x{chip.multiplexer:02X}, 0x{1 << chip.channel:02X}"
    )
    return f"{{0x{chip.factory:02X}, 0x{chip.address:02X}, {mux}, {supply}}}, /* {chip.label} */"


_HEADER = """\
/* Sensors of {name}: written by instobj bench firmware. */
#pragma once
#include <avr/io.h>
#include <avr/pgmspace.h>
#include <stdint.h>

{defines}

typedef struct {{
    uint8_t factory, address;     /* after power-up, and while it is read */
    uint8_t multiplexer, channel; /* address and channel's bit, 0: none */
    volatile uint8_t *supply_port; /* 0: always powered */
    uint8_t supply_mask;
}} place_t;

static const place_t PLACES[CHIPS] PROGMEM = {{
{rows}
}};

static const char CHANNELS[] PROGMEM = "{channels}";
"""

"""The header `plan.h` of the Arduino Mega's firmware: pins, addresses and settings of an object."""

from __future__ import annotations

from design.spec.object import ObjectSpec
from design.wiring.bus_plan import BusPlan
from design.wiring.dealing import ChipOnBus
from instobj.firmware.settings import (
    axes_in_order,
    channel_names,
    chip_settings,
    frame_us,
    waits_ms,
)

_CLOCK_HZ = 16_000_000


def port_of(pin: str) -> tuple[str, int]:
    """Port letter and bit of a digital pin (Arduino Mega 2560 Rev3, pinout A000067)."""
    number = int(pin[1:])
    if 22 <= number <= 29:
        return "A", number - 22
    if 30 <= number <= 37:
        return "C", 37 - number
    if 42 <= number <= 49:
        return "L", 49 - number
    raise ValueError(f"{pin} is none of the pins that plans use (D22 to D37, D42 to D49)")


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
/* Sensors of {name}: written by instobj firmware. */
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

"""The module `plan.py` of the MicroPython firmware: pins, addresses and settings of an object."""

from __future__ import annotations

from design.catalogue.bus_parts import EXPANDER_OUTPUTS
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

_PARTS = 256
"""Parts of a step of the analogue converter, in which means are counted (load_cell.py)."""


def gpio_of(pin: str) -> int:
    """Number of a pin by its name."""
    return int(pin[2:])  # GP12, or IO12 on ESP32s


def plan_module(spec: ObjectSpec, plan: BusPlan) -> str:
    """MicroPython source of `plan.py`.

    Raises
    ------
    InputError
        Settings that the chip cannot take.
    """
    power_up, conversion = waits_ms(spec, plan)
    buses = [
        (number, gpio_of(plan.board.buses[number].sda), gpio_of(plan.board.buses[number].scl))
        for number in plan.buses
    ]
    figures = {
        "FRAME_US": frame_us(spec),
        "HERTZ": int(1e3 * plan.khz),
        "POWER_UP_MS": power_up,
        "CONVERSION_MS": conversion,
        "AXES": tuple(1 + "XYZ".index(axis) for axis in axes_in_order(spec)),
        "RESET": None if plan.reset is None else gpio_of(plan.reset),
        "BATTERY": gpio_of(plan.board.battery_pin) if plan.board.battery_pin else None,
        "BUSES": tuple(buses),
        "CHANNELS": ",".join(channel_names(spec, plan)),
        **chip_settings(spec, plan),
        **_load_cell(spec, plan),
        **_imu(plan),
    }
    lines = [f"{name} = {value!r}" for name, value in figures.items()]
    rows = [f"    {_place(chip)!r},  # {chip.label}" for chip in plan.chips]
    return "\n".join(
        [
            f'"""Sensors of {spec.name}: written by instobj bench firmware."""',
            "",
            *lines,
            "PLACES = (  # bus, address after power-up, while read, multiplexer, channel, supply",
            *rows,
            ")",
            "",
        ]
    )


def _load_cell(spec: ObjectSpec, plan: BusPlan) -> dict[str, object]:
    """Kind, pins and scale of the load cell."""
    if plan.load is None:
        return {"LOAD_CELL": None, "LOAD_PINS": (), "LOAD_ZERO": 0, "LOAD_SCALE": 0}
    sum_of = _PARTS if plan.load.kind == "analog" else 1
    pins = tuple(map(gpio_of, plan.load.pins))
    return {"LOAD_CELL": plan.load.kind, "LOAD_PINS": pins, **load_settings(spec, plan, sum_of)}


def _imu(plan: BusPlan) -> dict[str, object]:
    """Registers and scales of the IMU: factors of its six numbers, and which of them are accelerations."""
    if plan.imu is None:
        return {"IMU": None}
    m_s2, rad_s = motion_steps(plan.imu)
    return {
        "IMU": plan.imu.address,
        "IMU_WHO": plan.imu.who,
        "IMU_SETUP": plan.imu.setup,
        "IMU_DATA": plan.imu.data,
        "IMU_ORDER": ("<" if plan.imu.low_byte_first else ">") + 6 * "h",
        "IMU_RATE_FIRST": plan.imu.rate_first,
        "IMU_STEPS": (m_s2, rad_s),
    }


def _place(chip: ChipOnBus) -> tuple[int | tuple[int, int] | None, ...]:
    supply = None if chip.supply_pin is None else gpio_of(chip.supply_pin)
    if chip.expander is not None:
        supply = (chip.expander, EXPANDER_OUTPUTS.index(chip.supply))
    return (chip.bus, chip.factory, chip.address, chip.multiplexer, chip.channel, supply)

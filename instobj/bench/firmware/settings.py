"""Settings that every firmware gets from a specification and its bus plan."""

from __future__ import annotations

from math import ceil, radians

from design.catalogue.bus_parts import MLX90393, MOTION, TLE493D, TMAG5273, BusChip, Imu, bus_chip
from design.catalogue.hall_sensors import HALL_PARTS
from design.errors import InputError
from design.spec.object import ObjectSpec
from design.wiring.bus_plan import BusPlan
from design.wiring.dealing import ChipOnBus
from design.wiring.load_cell import newtons_per_step, zero_steps

_MLX_SETTINGS = {4.9: (7, 0), 9.8: (4, 0), 24.6: (0, 0), 49.2: (0, 1)}
"""Range (mT) to GAIN_SEL and RES of the catalogue's figures (Melexis 3901090393, table of gains)."""


def family_of(plan: BusPlan) -> BusChip:
    """Family of the plan's chips."""
    return bus_chip(plan.chips[0].part)


def supply_text(chip: ChipOnBus) -> str:
    """Return what powers a sensor."""
    expander = "" if chip.expander is None else f"0x{chip.expander:02X} "
    return f"{expander}{chip.supply or '3.3 V'}"


def channel_names(spec: ObjectSpec, plan: BusPlan) -> list[str]:
    """F1-X1, F1-Y1, … in the order of the frames, then the IMU's columns where there is one."""
    chips = [f"F{c.face}-{axis}{c.number}" for c in plan.chips for axis in axes_in_order(spec)]
    return chips if plan.imu is None else [*chips, *MOTION]


def axes_in_order(spec: ObjectSpec) -> list[str]:
    """Axes that are sent, X before Y before Z."""
    return [axis for axis in "XYZ" if axis in spec.sensors.axes]


def frame_us(spec: ObjectSpec) -> int:
    """Time between two frames (µs)."""
    return round(1e6 / spec.sensors.frame_rate_hz)


def waits_ms(spec: ObjectSpec, plan: BusPlan) -> tuple[int, int]:
    """Whole milliseconds from power to the first transfer, and of a conversion."""
    family = family_of(plan)
    return ceil(family.power_up_ms), ceil(family.conversion_ms(spec.sensors.averaging))


def chip_settings(spec: ObjectSpec, plan: BusPlan) -> dict[str, int]:
    """Range and averaging as the chip's registers take them.

    Raises
    ------
    InputError
        A range or gain that the part's registers cannot give.
    """
    sensors, part = spec.sensors, HALL_PARTS.named(spec.sensors.part)
    selected = part.range_covering(sensors.range_mt)
    if abs(sensors.counts_per_mt / selected.counts_per_mt - 1) > 0.5:
        raise InputError(
            f"sensors.counts_per_mt = {sensors.counts_per_mt:g}, but {part.name} has "
            f"{selected.counts_per_mt:.4g} in its range of ±{selected.range_mt:g} mT. Leave the key out, "
            "or give what was measured in that range"
        )
    if family_of(plan) is TMAG5273:
        wide = selected is not part.ranges[0]
        return {"TMAG_WIDE": int(wide), "TMAG_AVERAGING": sensors.averaging.bit_length() - 1}
    if family_of(plan) is TLE493D:
        return {"TLE_SHORT": int(selected is part.ranges[0])}
    assert family_of(plan).driver == MLX90393.driver
    gain, resolution = _MLX_SETTINGS[selected.range_mt]
    return {"MLX_GAIN": gain, "MLX_RESOLUTION": resolution}


STANDARD_GRAVITY_M_S2 = 9.80665
"""Standard acceleration of free fall (CGPM 1901)."""


def motion_steps(imu: Imu) -> tuple[float, float]:
    """Return m/s² of a count of acceleration, and rad/s of a count of the angular rate."""
    return STANDARD_GRAVITY_M_S2 / imu.counts_per_g, radians(1 / imu.counts_per_deg_s)


LOAD_SCALE_BITS = 24
"""Digits of LOAD_SCALE behind its point."""


def load_settings(spec: ObjectSpec, plan: BusPlan, sum_of: int = 1) -> dict[str, int]:
    """Zero, and 0.1 mN per unit, of a load cell's readings, which are sums of `sum_of` steps."""
    per_step = newtons_per_step(spec.load_cell, plan.board)
    return {
        "LOAD_ZERO": round(zero_steps(spec.load_cell, plan.board) * sum_of),
        "LOAD_SCALE": round(1e4 * per_step / sum_of * 2**LOAD_SCALE_BITS),
    }

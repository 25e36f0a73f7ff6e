"""Tolerances in a specification: how far a built object may lie from what was designed.

Each figure is one standard deviation of a normal spread; docs/units.md gives the source of each
default. Those marked "estimate" there are ours, from how the parts are made.
"""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from design.spec.base import NonNegative, SpecPart


class TolerancesSpec(SpecPart):
    """Spread of assembly, material and surroundings (standard deviations; 0 leaves one out).

    Magnets, sensors and channels vary independently of each other; core, silicone, temperature and
    surroundings are common to the whole object. `magnet_seat_mm` is each of the two lateral
    directions, `magnet_seat_depth_mm` the third; `sensor_seat_mm` and `core_shift_mm` each of three.
    `core_yaw_deg` turns the core about z in the shell. `modulus_relative` is that of ln E.
    `earth_field_ut` is the field's size: its direction is unknown when the signals are zeroed, and
    again in the press, because a gripper turns the object.
    """

    magnet_seat_mm: NonNegative = 0.1
    magnet_seat_depth_mm: NonNegative = 0.1
    magnet_tilt_deg: NonNegative = 2.0
    remanence_relative: NonNegative = 0.01
    sensor_seat_mm: NonNegative = 0.1
    sensor_rotation_deg: NonNegative = 2.0
    sensor_gain_relative: NonNegative = 0.02
    sensor_offset_ut: NonNegative = 100.0
    core_shift_mm: Annotated[float, Field(ge=0, le=0.6)] = 0.3
    core_yaw_deg: Annotated[float, Field(ge=0, le=2)] = 1.0
    modulus_relative: NonNegative = 0.1
    temperature_k: NonNegative = 5.0
    earth_field_ut: NonNegative = 50.0

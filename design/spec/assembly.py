"""The built object in a specification: measured parts, and tolerances of all others.

What was measured lies next to a specification as `<specification>.as_built.toml`, or is named by its
key `as_built`. Places and directions are in the face's frame: x, y, and height above the face
(negative inside). Magnets and sensors are counted from 1, in the order of the specification.

Each tolerance is one standard deviation of a normal spread; docs/units.md gives the source of each
default. Those marked "estimate" there are ours, from how the parts are made.
"""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, model_validator

from design.spec.base import (
    Angle,
    Component,
    Coordinate,
    Count,
    Distinct,
    Offset,
    Remanence,
    SpecPart,
)

FaceNumber = Annotated[int, Field(ge=1, le=6)]
Place = tuple[Coordinate, Coordinate, Coordinate]
Direction = tuple[Component, Component, Component]
Turns = tuple[Angle, Angle, Angle]
SpreadMm = Annotated[float, Field(ge=0, le=5)]
SpreadDeg = Annotated[float, Field(ge=0, le=30)]
Spread = Annotated[float, Field(ge=0, le=0.5)]
"""Relative, one standard deviation."""
Axis = Literal["X", "Y", "Z"]


class BuiltMagnet(SpecPart):
    """One magnet as found: what is left out is as designed. `axis` points north, of any length.

    `dent_mm` is how far the seal over its pocket has sunk.
    """

    face: FaceNumber
    magnet: Count
    centre_mm: Place | None = None
    axis: Direction | None = None
    flipped: bool = False
    remanence_t: Remanence | None = None
    dent_mm: Offset | None = None

    @model_validator(mode="after")
    def _has_a_direction(self) -> BuiltMagnet:
        if self.axis is not None and not any(self.axis):
            raise ValueError(
                f"as_built: the axis of magnet {self.magnet} of face {self.face} has no direction; "
                "got [0, 0, 0]. Give the direction of its north pole, or leave axis out"
            )
        return self


class BuiltSensor(SpecPart):
    """One sensor as found. `rotation_deg` turns the chip by that rotation vector."""

    face: FaceNumber
    sensor: Count
    position_mm: Place | None = None
    rotation_deg: Turns = (0.0, 0.0, 0.0)
    dead: Annotated[tuple[Axis, ...], Distinct] = ()


class AsBuiltSpec(SpecPart):
    """Everything that was measured; empty where the object is taken as designed."""

    magnets: tuple[BuiltMagnet, ...] = ()
    sensors: tuple[BuiltSensor, ...] = ()

    @model_validator(mode="after")
    def _require_each_once(self) -> AsBuiltSpec:
        named = [("magnet", m.face, m.magnet) for m in self.magnets]
        named += [("sensor", s.face, s.sensor) for s in self.sensors]
        for kind, face, number in named:
            if named.count((kind, face, number)) > 1:
                raise ValueError(
                    f"as_built names {kind} {number} of face {face} more than once. Merge the entries"
                )
        return self

    def require_known(self, magnets: int, sensors: int, faces: tuple[int, ...]) -> None:
        """Raise ValueError where an entry names a face, magnet or sensor that there is not."""
        named = [("magnet", m.face, m.magnet, magnets) for m in self.magnets]
        named += [("sensor", s.face, s.sensor, sensors) for s in self.sensors]
        for kind, face, number, count in named:
            if face not in faces:
                raise ValueError(
                    f"as_built names {kind} {number} of face {face}; the sensed faces are {list(faces)}. "
                    "Name one of them"
                )
            if number > count:
                raise ValueError(
                    f"as_built names {kind} {number} of face {face}; each face has {count}. Count "
                    "from 1 in the order of the specification"
                )


class TolerancesSpec(SpecPart):
    """Spread of assembly, material and surroundings (standard deviations; 0 leaves one out).

    Magnets, sensors and channels vary independently of each other; core, silicone, temperature and
    surroundings are common to the whole object. `magnet_seat_mm`, `sensor_seat_mm` and
    `core_shift_mm` are each of three directions.
    `core_yaw_deg` turns the core about z in the shell. `modulus_relative` is the deviation of ln E.
    `earth_field_ut` is the field's size: its direction is unknown when the signals are zeroed, and
    again in the press, because a gripper turns the object.
    """

    magnet_seat_mm: SpreadMm = 0.1
    magnet_tilt_deg: SpreadDeg = 2.0
    remanence_relative: Spread = 0.02
    sensor_seat_mm: SpreadMm = 0.1
    sensor_rotation_deg: SpreadDeg = 2.0
    sensor_gain_relative: Spread = 0.02
    sensor_offset_ut: Annotated[float, Field(ge=0, le=1e4)] = 100.0
    core_shift_mm: Annotated[float, Field(ge=0, le=0.6)] = 0.3
    core_yaw_deg: Annotated[float, Field(ge=0, le=2)] = 1.0
    modulus_relative: Annotated[float, Field(ge=0, le=1)] = 0.1
    temperature_k: Annotated[float, Field(ge=0, le=60)] = 5.0
    earth_field_ut: Annotated[float, Field(ge=0, le=100)] = 50.0

"""The sensors in a specification: which part, where, how they are turned, how good they are.

Defaults are the paper's cube (Knopke et al., RA-L 2024); docs/units.md gives the source of each.
"""

from __future__ import annotations

from math import atan2, cos, radians, sin
from typing import Annotated, Any, Literal, get_args

from pydantic import Field, model_validator

from design.catalogue.bus_parts import conversion_ms, frame_ms
from design.catalogue.hall_sensors import HALL_PARTS
from design.spec.base import (
    Angle,
    Coordinate,
    Counts,
    Distinct,
    FieldRange,
    Length,
    Offset,
    SpecPart,
)

Averaging = Literal[1, 2, 4, 8, 16, 32]
Places = Annotated[tuple[tuple[Coordinate, Coordinate], ...], Field(min_length=1, max_length=24)]
Turns = Annotated[tuple[tuple[Angle, Angle, Angle], ...], Field(min_length=1, max_length=24)]
Axis = Literal["X", "Y", "Z"]
Noise = Annotated[float, Field(gt=0, le=32_768)]
"""White noise of one axis (rms counts)."""
ChipSpread = Annotated[float, Field(ge=0, lt=0.5)]
BUS_KHZ = 400.0
"""Clock of the one bus of all sensors: the I²C bus's fast mode (NXP UM10204)."""
FACES_OF_A_CUBE = 5
"""Sensed faces of the default body, for which lists of places are filled up."""


class SensorSpec(SpecPart):
    """Hall sensors, by default the same ring on every sensed face of the core.

    `axes` are those of the chip that it measures: all three, or ["Z"] of a linear Hall sensor.
    `first_azimuth_deg` is for faces 1, 2, …, over again where there are more. `positions_mm` puts
    sensors elsewhere: x, y in the face's frame, one list for every face or one for each, of equal
    length. Chip axes: X = −tangential, Y = radial outward, Z = the face's outward normal, with the
    chip facing inward; "outward" turns it about Y. `rotations_deg` takes the place of both on boards with
    chips turned any way: one rotation vector for each sensor, one list for every face or one for
    each; it turns X, Y, Z from the face's x, y, n. `range_mt`, `counts_per_mt` and
    `noise_counts` are those of `part` where they are left out; the default part's noise, gain and
    drift were measured on the recordings (16× averaging, ±40 mT). `averaging` is the number of
    conversions in a reading. With a `chip_spread` above 0, simulated chips are drawn with the
    specification's seed: the gain of each axis and the share of other axes in it (rms).
    Where sensors sit in the shell (`arrangement`), each is a rigid board of `package_mm`
    (tangential, radial, thick) on its pocket's floor, sensing at its centre. `chip_mm` is the chip
    with its leads on the board (as `package_mm`), for the checks alone.
    """

    part: str = "TMAG5273A1"
    axes: Annotated[tuple[Axis, ...], Field(min_length=1), Distinct] = ("X", "Y", "Z")
    averaging: Averaging = 16
    count_per_face: Annotated[int, Field(ge=1, le=24)] = 3
    radius_mm: Length = 8.585
    depth_below_core_face_mm: Offset = 2.3
    first_azimuth_deg: Annotated[tuple[Angle, ...], Field(min_length=1)] = (
        240.0,
        180.0,
        240.0,
        60.0,
        300.0,
    )
    positions_mm: tuple[Places, ...] | None = None
    package_mm: tuple[Length, Length, Length] = (6.6, 6.2, 1.6)
    chip_mm: tuple[Length, Length, Length] = (2.9, 2.8, 1.25)
    chip: Literal["inward", "outward"] = "inward"
    rotations_deg: tuple[Turns, ...] | None = None
    counts_per_mt: Annotated[float, Field(ge=0.1, le=1e6)] = 820.0
    range_mt: FieldRange = 40.0
    noise_counts: tuple[Noise, Noise, Noise] = (22.0, 22.0, 11.0)
    chip_spread: tuple[ChipSpread, ChipSpread] = (0.0, 0.0)
    zeroing_counts: Counts = 10.0
    drift_counts: Counts = 60.0
    frame_rate_hz: Annotated[float, Field(ge=0.01, le=1e5)] = 10.5

    @property
    def places(self) -> tuple[tuple[tuple[float, float, float], ...], ...]:
        """x, y (mm, in the face's frame) and azimuth (rad) of every sensor, list by list.

        `design.layout.pockets.sensor_places` gives the faces' own. Azimuths run from x counter-clockwise,
        seen from outside.
        """
        if self.positions_mm is not None:
            return tuple(
                tuple((x, y, atan2(y, x)) for x, y in places) for places in self.positions_mm
            )
        return tuple(self._ring(float(first)) for first in self.first_azimuth_deg)

    def _ring(self, first_deg: float) -> tuple[tuple[float, float, float], ...]:
        count = self.count_per_face
        azimuths = [radians(first_deg + 360 * k / count) for k in range(count)]
        return tuple((self.radius_mm * cos(a), self.radius_mm * sin(a), a) for a in azimuths)

    @model_validator(mode="before")
    @classmethod
    def _fill_in_defaults(cls, given: Any) -> Any:
        if not isinstance(given, dict):
            return given
        turns = _lists_of_faces(given.get("rotations_deg"))
        turned = {} if turns is None else {"rotations_deg": turns}
        return {**_part_figures(given), **given, **_explicit_places(given), **turned}

    @model_validator(mode="after")
    def _require_equal_counts(self) -> SensorSpec:
        counts = {len(face) for face in self.positions_mm or ()} or {self.count_per_face}
        if counts != {self.count_per_face}:
            raise ValueError(
                f"sensors.positions_mm must hold sensors.count_per_face = {self.count_per_face} places "
                f"on every face; got {sorted(counts)}. Leave count_per_face out, or fix the lists"
            )
        return self

    @model_validator(mode="after")
    def _a_rotation_for_every_sensor(self) -> SensorSpec:
        if self.rotations_deg is None:
            return self
        counts = {len(face) for face in self.rotations_deg}
        if counts != {self.count_per_face}:
            raise ValueError(
                f"sensors.rotations_deg must hold one rotation vector for each of the "
                f"{self.count_per_face} sensors of a face; got lists of {sorted(counts)}. Fix the "
                "lists, or leave rotations_deg out"
            )
        if self.chip != "inward":
            raise ValueError(
                "sensors.rotations_deg says how every chip is turned; sensors.chip = "
                f"{self.chip!r} turns them too. Give rotations_deg alone"
            )
        return self


_READ_BITS = 9 * 9 + 3
"""Address, register, address again and six bytes of data, nine bits each; start, restart, stop."""


def fastest_frame_rate_hz(sensors: SensorSpec, faces: int = FACES_OF_A_CUBE) -> float:
    """Frames per second at most: sensors convert by themselves and are read one by one over one I²C bus.

    A part without a conversion time in the catalogue is limited by the bus alone. Firmware, line and
    multiplexers come on top: the paper's object ran at 10.5 Hz.
    """
    read_ms = faces * sensors.count_per_face * _READ_BITS / BUS_KHZ
    return 1e3 / frame_ms(conversion_ms(sensors.part, sensors.averaging), read_ms)


def _explicit_places(given: dict[str, Any]) -> dict[str, Any]:
    """`positions_mm` of five faces where one list was given, and how many sensors it has; malformed
    lists are left to pydantic."""
    places = given.get("positions_mm")
    if not isinstance(places, list | tuple) or not places:
        return {}
    faces = _lists_of_faces(places)
    first = faces[0]
    counted = isinstance(first, list | tuple) and "count_per_face" not in given
    return {"positions_mm": faces, **({"count_per_face": len(first)} if counted else {})}


def _lists_of_faces(given: Any) -> Any:
    """One list for each of five faces where a single list of number lists was given, else as given."""
    if not isinstance(given, list | tuple):
        return given
    numbers = all(isinstance(p, list | tuple) and all(_is_number(n) for n in p) for p in given)
    return (given,) * FACES_OF_A_CUBE if given and numbers else given


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _part_figures(given: dict[str, Any]) -> dict[str, Any]:
    """The part's range, gain and noise where `given` has none; values of other types are left."""
    name, averaging = given.get("part", "TMAG5273A1"), given.get("averaging", 16)
    range_mt, counts_per_mt = given.get("range_mt"), given.get("counts_per_mt")
    numbers = all(isinstance(n, int | float | None) for n in (range_mt, counts_per_mt))
    if not (isinstance(name, str) and averaging in get_args(Averaging) and numbers):
        return {}
    part = HALL_PARTS.named(name)
    if range_mt is None and part.ranges:
        range_mt = part.ranges[0].range_mt
    if counts_per_mt is None and range_mt is not None and part.ranges:
        counts_per_mt = part.range_covering(float(range_mt)).counts_per_mt
    noise_counts = given.get("noise_counts")
    if noise_counts is None and counts_per_mt is not None and part.noise is not None:
        noise_counts = part.noise.scaled(float(counts_per_mt), int(averaging))
    figures = {"range_mt": range_mt, "counts_per_mt": counts_per_mt, "noise_counts": noise_counts}
    missing = [f"sensors.{key}" for key, value in figures.items() if value is None]
    if missing:
        raise ValueError(
            f"sensors.part = {name!r} has no figure in the catalogue for {', '.join(missing)}. Give "
            "what was measured or the datasheet says; noise, rms counts of X, Y, Z: "
            "sensors.noise_counts = [10, 10, 15]"
        )
    return figures

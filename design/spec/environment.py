"""Surroundings of the object in a specification: Earth's field, other magnets, steel.

All of it stands in the object's frame and stays as it is while places are pressed. By default there
is nothing.
"""

from __future__ import annotations

from math import hypot
from typing import Annotated

from pydantic import Field, model_validator

from design.spec.base import (
    Component,
    Coordinate,
    Length,
    SpecPart,
)

EarthSize = Annotated[float, Field(ge=0, le=100)]
"""Size of Earth's field, µT."""
EarthPart = Annotated[float, Field(ge=-100, le=100)]
"""Component of Earth's field, µT."""
RemanencePart = Annotated[float, Field(ge=-2, le=2)]
"""Component of a remanence, T; the strongest magnets that are sold have 1.55."""
Place = tuple[Coordinate, Coordinate, Coordinate]
Direction = tuple[Component, Component, Component]


class StrayMagnetSpec(SpecPart):
    """A disk magnet outside the object: its centre, diameter and height, and its remanence as a vector
    towards its north pole."""

    position_mm: Place
    size_mm: tuple[Length, Length] = (10.0, 5.0)
    remanence_t: tuple[RemanencePart, RemanencePart, RemanencePart] = (0.0, 0.0, 1.3)

    @model_validator(mode="after")
    def _remanence_points_somewhere(self) -> StrayMagnetSpec:
        if not any(self.remanence_t):
            raise ValueError(
                "environment.magnets remanence_t must not be zero. Give it along its north direction"
            )
        return self


class SteelPlateSpec(SpecPart):
    """A thick steel plate: a point of its surface, and the normal that points out of the steel."""

    position_mm: Place
    normal: Direction
    relative_permeability: Annotated[float, Field(ge=1, le=1e12)] = 1000.0

    @model_validator(mode="after")
    def _normal_points_somewhere(self) -> SteelPlateSpec:
        if not any(self.normal):
            raise ValueError(
                "environment.steel_plates normal must not be zero. Give the direction out of the steel"
            )
        return self


class EnvironmentSpec(SpecPart):
    """Earth's field, magnets and steel plates about the object.

    `earth_ut` is Earth's field in the object's frame: 25 to 65 µT times (cos I, 0, −sin I) at the
    inclination I for an object whose x points to magnetic north. A number alone is its size: one
    orientation is then drawn with the specification's seed.
    """

    earth_ut: EarthSize | tuple[EarthPart, EarthPart, EarthPart] = 0.0
    magnets: tuple[StrayMagnetSpec, ...] = ()
    steel_plates: tuple[SteelPlateSpec, ...] = ()

    @property
    def earth_size_ut(self) -> float:
        """Size of Earth's field."""
        return hypot(*self.earth_ut) if isinstance(self.earth_ut, tuple) else self.earth_ut

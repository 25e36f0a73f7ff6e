"""Surroundings of the object in a specification: Earth's field, other magnets, steel.

All of it stands in the object's frame and stays as it is while places are pressed. By default there
is nothing.
"""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, model_validator

from design.spec.base import (
    Component,
    Coordinate,
    Length,
    Remanence,
    SpecPart,
)

Place = tuple[Coordinate, Coordinate, Coordinate]
Direction = tuple[Component, Component, Component]


class StrayMagnetSpec(SpecPart):
    """A disk magnet outside the object: its centre, and the direction of its north pole."""

    position_mm: Place
    axis: Direction = (0.0, 0.0, 1.0)
    diameter_mm: Length = 10.0
    height_mm: Length = 5.0
    remanence_t: Remanence = 1.3

    @model_validator(mode="after")
    def _axis_points_somewhere(self) -> StrayMagnetSpec:
        if not any(self.axis):
            raise ValueError("environment.magnets axis must not be zero. Give its north direction")
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

    `earth_field_ut` is 25 to 65 µT on Earth's surface. `earth_direction` is its direction in
    the object's frame: (cos I, 0, −sin I) at the inclination I for an object whose x points to
    magnetic north; "random" draws one orientation with the specification's seed.
    """

    earth_field_ut: Annotated[float, Field(ge=0, le=100)] = 0.0
    earth_direction: Direction | Literal["random"] = (0.0, 0.0, -1.0)
    magnets: tuple[StrayMagnetSpec, ...] = ()
    steel_plates: tuple[SteelPlateSpec, ...] = ()

    @model_validator(mode="after")
    def _earth_points_somewhere(self) -> EnvironmentSpec:
        if self.earth_direction != "random" and not any(self.earth_direction):
            raise ValueError(
                "environment.earth_direction must not be zero. Give a direction, or 'random'"
            )
        return self

"""Field from outside the object: Earth's, stray magnets', and what steel plates make of it.

A plate is taken as a half-space of linear steel: every magnet then has one image behind its
surface, of strength (μ − 1)/(μ + 1), which is exact. Real plates do less. Against a square plate of
infinite permeability over the middle of a face of the paper's cube (solved by panels of surface
charge, `tests/estimator/field/test_environment.py`), the half-space overstates the change at the sensors
by 9, 7 and 4 % for a touching plate of 42, 84 and 126 mm, and by 37, 12 and 5 % of a change a third
as large for one 5 mm away. The pull on magnets (`estimator.field.forces`) it overstates by 1 % or less
for a touching plate of 42 mm, by 2 % for one 4 mm and 32 % for one 10 mm away. Thin steel passes flux:
of μ 1000 and 2 mm it reflects 2 to 4 % less, of μ 100 and 2 mm 10 to 30 % less. Left out are images
of images between several plates, 4 % of the change for jaws that touch two opposite faces of the
paper's cube, and what plates make of Earth's field.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from jaxtyping import Float, Int

from design.spec.object import ObjectSpec
from estimator.field.models import FieldModel, MagnetsModel, sum_over_magnets
from estimator.field.sources import DiskMagnet, self_demagnetised
from estimator.field.vectors import Vector, dot


@dataclass(frozen=True)
class Plate:
    """A steel half-space: a point of its surface (mm), unit normal out of it, image strength."""

    position_mm: Float[np.ndarray, "3"]
    normal: Float[np.ndarray, "3"]
    strength: float

    def image_of_place(self, place_mm: Vector) -> Vector:
        """Mirrored behind the surface, mm."""
        height = dot(_minus(place_mm, _vector(self.position_mm)), _vector(self.normal))
        return _minus_scaled(place_mm, 2 * height, self.normal)

    def image_of_moment(self, direction: Vector) -> Vector:
        """Tangential part reversed, normal part kept, so that H meets the steel at right angles."""
        x, y, z = _minus_scaled(direction, 2 * dot(direction, _vector(self.normal)), self.normal)
        return -x, -y, -z


@dataclass(frozen=True)
class Environment:
    """Everything outside the object that its sensors feel.

    `uniform_t` is Earth's field; stray magnets are (model, centre in mm, axis) each.
    """

    uniform_t: Float[np.ndarray, "3"]
    strays: tuple[tuple[FieldModel, Vector, Vector], ...]
    plates: tuple[Plate, ...]

    def field_at(self, points_mm: Vector) -> Vector:
        """B (T) without the object's own magnets and their images, at points of any one shape."""
        total = _vector(self.uniform_t)
        for model, *place in self.strays:
            centre, axis = (_lead_with_magnet(given, points_mm) for given in place)
            total = _plus(total, with_images(points_mm, centre, axis, model, self.plates))
        return total


def environment(spec: ObjectSpec) -> Environment:
    """The environment that a specification describes."""
    around = spec.environment
    strays = []
    for stray in around.magnets:
        size_t = float(np.linalg.norm(stray.remanence_t))
        body = self_demagnetised(DiskMagnet(*stray.size_mm, 1.0), size_t)
        place, axis = np.asarray(stray.position_mm), _unit(stray.remanence_t)
        strays.append((FieldModel(body, "exact"), _column(place), _column(axis)))
    plates = tuple(
        Plate(
            np.asarray(plate.position_mm, float),
            _unit(plate.normal),
            (plate.relative_permeability - 1) / (plate.relative_permeability + 1),
        )
        for plate in around.steel_plates
    )
    return Environment(_earth_t(spec), tuple(strays), plates)


def with_images(
    points_mm: Vector,
    centres_mm: Vector,
    axes: Vector,
    model: MagnetsModel,
    plates: tuple[Plate, ...],
    sides: Vector | None = None,
    strength: Any = 1.0,
    size: Int[np.ndarray, "magnet"] | None = None,
) -> Vector:
    """`field.sum_over_magnets`, with the magnets' images in every plate."""
    total = sum_over_magnets(points_mm, centres_mm, axes, model, sides, strength, size)
    for plate in plates:
        side = None if sides is None else plate.image_of_moment(sides)
        image = sum_over_magnets(
            points_mm,
            plate.image_of_place(centres_mm),
            plate.image_of_moment(axes),
            model,
            side,
            strength,
            size,
        )
        total = _plus(total, image, plate.strength)
    return total


def _earth_t(spec: ObjectSpec) -> Float[np.ndarray, "3"]:
    earth_ut = spec.environment.earth_ut
    if isinstance(earth_ut, tuple):
        return 1e-6 * np.asarray(earth_ut)
    return 1e-6 * earth_ut * _unit(tuple(np.random.default_rng(spec.seed).standard_normal(3)))


def _unit(direction: tuple[float, ...]) -> Float[np.ndarray, "3"]:
    vector = np.asarray(direction, float)
    return vector / np.linalg.norm(vector)


def _vector(array: Float[np.ndarray, "3"]) -> Vector:
    x, y, z = array.tolist()
    return x, y, z


def _column(array: Float[np.ndarray, "3"]) -> Vector:
    """Components with a first dimension of one magnet."""
    x, y, z = array[:, None]
    return x, y, z


def _lead_with_magnet(magnet: Vector, points_mm: Vector) -> Vector:
    """Components of one magnet, in a dimension before those of the points."""
    dimensions = max(np.ndim(part) for part in points_mm)
    x, y, z = (part.reshape(-1, *[1] * dimensions) for part in magnet)
    return x, y, z


def _minus(a: Vector, b: Vector) -> Vector:
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def _minus_scaled(a: Vector, factor: object, b: Float[np.ndarray, "3"]) -> Vector:
    x, y, z = (part - factor * component for part, component in zip(a, _vector(b), strict=True))  # pyright: ignore[reportOperatorIssue]
    return x, y, z


def _plus(a: Vector, b: Vector, factor: float = 1.0) -> Vector:
    return a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]

"""Fruits that an object may stand for: stiffness with its spread, radius, source."""

from __future__ import annotations

from dataclasses import dataclass

from design.catalogue.tables import read_table


@dataclass(frozen=True)
class Fruit:
    """A fruit as a soft sphere: Young's modulus (MPa, small strain), and the interval that it may lie in."""

    name: str
    youngs_modulus_mpa: float
    low_mpa: float
    high_mpa: float
    radius_mm: float
    source: str
    poisson_ratio: float = 0.35


FRUITS = read_table("fruits", Fruit)

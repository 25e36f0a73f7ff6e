"""Damage of what the object stands for: contact pressure by Hertz, limits, and their probability."""

from __future__ import annotations

import tomllib
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any, Literal, get_args

import numpy as np
from jaxtyping import Float
from scipy.stats import norm

from design.errors import InputError

SHIPPED = Path(__file__).with_name("limits.toml")
"""Limits from the literature, each with its source and what it does not tell."""
Quantity = Literal["force_n", "pressure_mpa", "strain", "energy_mj"]


@dataclass(frozen=True)
class Sphere:
    """Pair of a soft body and the rigid round tip that presses it.

    Attributes
    ----------
    modulus_mpa, poisson : of the body
    radius_mm : of the pair, 1/R = 1/R_body + 1/R_tip
    """

    modulus_mpa: float
    poisson: float
    radius_mm: float

    @property
    def plane_modulus_mpa(self) -> float:
        """E* = E/(1 − ν²) against a rigid tip."""
        return self.modulus_mpa / (1 - self.poisson**2)


def patch_radius_mm(force_n: Float[np.ndarray, "*n"], pair: Sphere) -> Float[np.ndarray, "*n"]:
    """Radius of the contact patch, a³ = 3 F R/(4 E*) (Hertz; Johnson, Contact Mechanics, 1985, 4.2).

    Small strain, frictionless, bodies large against a. On a layer of silicone over a rigid core the
    patch is smaller and the pressure higher, the more so the thinner the layer.
    """
    return np.cbrt(3 * np.maximum(force_n, 0.0) * pair.radius_mm / (4 * pair.plane_modulus_mpa))


def mean_pressure_mpa(force_n: Float[np.ndarray, "*n"], pair: Sphere) -> Float[np.ndarray, "*n"]:
    """Mean pressure F/(π a²); the largest, in the middle, is 1.5 times as high.

    A sphere begins to yield inside where the mean pressure is 1.1 times the stress at which a column of
    the material yields (Johnson 1985, 6.1): failure stresses of flesh are compared with this mean.
    """
    radius = patch_radius_mm(force_n, pair)
    return np.divide(force_n, np.pi * radius**2, out=np.zeros_like(radius), where=radius > 0)


def indentation_mm(force_n: Float[np.ndarray, "*n"], pair: Sphere) -> Float[np.ndarray, "*n"]:
    """Depth δ = a²/R of the tip; on a thin layer the true depth is less."""
    return patch_radius_mm(force_n, pair) ** 2 / pair.radius_mm


def energy_mj(force_n: Float[np.ndarray, "*n"], pair: Sphere) -> Float[np.ndarray, "*n"]:
    """Work of loading to a force, ∫F dδ = 2/5 F δ, N mm = mJ; on a thin layer the true work is less."""
    return 0.4 * np.maximum(force_n, 0.0) * indentation_mm(force_n, pair)


@dataclass(frozen=True)
class DamageLimit:
    """Load at which half of the fruits are damaged, and how fruits differ.

    Attributes
    ----------
    name : of the fruit
    quantity : what is limited: force of a contact, its mean pressure, nominal strain δ/R of the fruit
        between two jaws, or energy put in by a contact
    median : in the unit of the quantity
    spread : standard deviation of its natural logarithm over fruits
    modulus_mpa, poisson, radius_mm : of the fruit, for Hertz; not used for forces
    source : where median and spread come from
    note : what the figures leave out
    """

    name: str
    quantity: Quantity
    median: float
    spread: float
    source: str
    note: str = ""
    modulus_mpa: float = 1.0
    poisson: float = 0.35
    radius_mm: float = 35.0

    def load(
        self, force_n: Float[np.ndarray, "*n"], tip_radius_mm: float
    ) -> Float[np.ndarray, "*n"]:
        """Quantity that a force puts on the fruit under a round tip of that radius."""
        pair = Sphere(self.modulus_mpa, self.poisson, 1 / (1 / self.radius_mm + 1 / tip_radius_mm))
        if self.quantity == "force_n":
            return force_n
        if self.quantity == "pressure_mpa":
            return mean_pressure_mpa(force_n, pair)
        if self.quantity == "energy_mj":
            return energy_mj(force_n, pair)
        # two jaws press in δ each, of a diameter of 2 R
        return indentation_mm(force_n, pair) / self.radius_mm

    def probability(self, load: Float[np.ndarray, "*n"]) -> Float[np.ndarray, "*n"]:
        """Share of fruits that the load damages: limits are log-normal over fruits."""
        share = np.log(np.maximum(load, 1e-12) / self.median) / self.spread
        return np.asarray(norm.cdf(share))


def damage_probability(
    limit: DamageLimit, force_n: Float[np.ndarray, "draw contact"], tip_radius_mm: float
) -> tuple[Float[np.ndarray, "draw"], Float[np.ndarray, "contact"]]:
    """Chance that a grasp damages the fruit in each draw of the forces that the estimator allows, and the
    mean chance that each contact does.

    One fruit has one limit, so that its worst contact decides, not the product over contacts.
    """
    load = limit.load(force_n, tip_radius_mm)
    whole = limit.probability(load.max(axis=1, initial=0.0))
    return whole, limit.probability(load).mean(axis=0)


def read_limits(given: str) -> list[DamageLimit]:
    """Limits of a TOML file, or one shipped limit by its fruit's name.

    Raises
    ------
    InputError
        No such file or fruit, no `[[limit]]`, an unknown or missing key, or a figure that is not
        above 0.
    """
    path = Path(given)
    if path.suffix != ".toml":
        shipped = _parsed(SHIPPED)
        chosen = [limit for limit in shipped if limit.name == given]
        if not chosen:
            names = ", ".join(limit.name for limit in shipped)
            raise InputError(
                f"--limit {given!r} is no fruit with a limit; there are {names}. Name one, or give "
                "a TOML file of your own"
            )
        return chosen
    return _parsed(path)


def _parsed(path: Path) -> list[DamageLimit]:
    try:
        content = tomllib.loads(path.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise InputError(
            f"{path}: cannot be read as limits: {error}. Give a TOML file with [[limit]] tables"
        ) from None
    tables = content.get("limit")
    if not isinstance(tables, list) or not tables:
        raise InputError(
            f"{path} holds no [[limit]]. Give name, quantity, median, spread and source"
        )
    return [_limit(path, table) for table in tables]


def _limit(path: Path, table: Any) -> DamageLimit:
    keys = {field.name: field.type for field in fields(DamageLimit)}
    needed = ("name", "quantity", "median", "spread", "source")
    given = table if isinstance(table, dict) else {}
    wrong = [key for key in given if key not in keys] + [key for key in needed if key not in given]
    if wrong:
        raise InputError(
            f"{path}: a [[limit]] has {', '.join(wrong)} unknown or missing. It takes "
            f"{', '.join(keys)}, of which {', '.join(needed)} are needed"
        )
    if given["quantity"] not in get_args(Quantity):
        raise InputError(
            f"{path}: quantity is one of {', '.join(get_args(Quantity))}; got {given['quantity']!r}"
        )
    figures = [name for name, kind in keys.items() if kind == "float" and name in given]
    for key in figures:
        value = given[key]
        if isinstance(value, bool) or not isinstance(value, int | float) or not 0 < value < 1e9:
            raise InputError(f"{path}: {key} must be a number above 0; got {value!r}")
    if given.get("poisson", 0.35) > 0.5:
        raise InputError(f"{path}: poisson is at most 0.5; got {given['poisson']!r}")
    whole: dict[str, Any] = given | {key: float(given[key]) for key in figures}
    return DamageLimit(**whole)

"""Tensile tests: a CSV of stretch and nominal stress, and the hyperelastic solids that fit it.

Incompressible uniaxial tension, nominal stress P at stretch λ (forms as in `fem.large_strain.hyperelastic`):

    neo-Hookean, Yeoh   P = 2 (λ − λ⁻²) Σ i c_i (I − 3)^(i−1),   I = λ² + 2/λ
    Ogden, one term     P = μ (λ^(α − 1) − λ^(−α/2 − 1))
"""

from __future__ import annotations

import csv
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from jaxtyping import Float

from design.catalogue.silicones import ModulusEstimate
from design.errors import InputError
from design.files import require_regular_file

LEAST_POINTS = 6
_LEAST_STRETCH = 1.1
_STRETCH_COLUMNS: dict[str, Callable[[np.ndarray], np.ndarray]] = {
    "stretch": lambda value: value,
    "strain": lambda value: 1 + value,
    "strain_percent": lambda value: 1 + value / 100,
}
_STRESS_COLUMNS = {"nominal_stress_mpa": 1.0, "nominal_stress_kpa": 1e-3}
FIT_TO_STRETCH = 2.0
"""Points beyond it are not fitted."""
_STABLE_FROM_STRETCH = 0.5
_LARGEST_RESIDUAL_PERCENT = 10.0
_EXPONENTS = (0.1, 12.0)


@dataclass(frozen=True)
class TensileTest:
    """Stretch (1 at rest, increasing) and nominal stress (force over undeformed area, MPa)."""

    stretch: Float[np.ndarray, "point"]
    nominal_stress_mpa: Float[np.ndarray, "point"]


@dataclass(frozen=True)
class SolidFit:
    """One solid fitted to a test.

    `constants` are c_i in MPa, or Ogden's μ and α, as `instobj press --constants` takes them.
    `residual_mpa` is the rms misfit over the degrees of freedom left. `stable`: the stress grows
    with the stretch everywhere from 0.5 to the largest one fitted.
    """

    solid: str
    constants: tuple[float, ...]
    youngs_modulus_mpa: float
    residual_mpa: float
    residual_percent: float
    stable: bool


@dataclass(frozen=True)
class TensileFit:
    """All solids fitted to the points up to a stretch of 2, and the modulus with its spread."""

    test: TensileTest
    solids: tuple[SolidFit, ...]
    modulus: ModulusEstimate


def read_tensile_test(path: Path) -> TensileTest:
    """Read a CSV with a column `stretch`, `strain` or `strain_percent`, and one
    `nominal_stress_mpa` or `nominal_stress_kpa`.

    Raises
    ------
    InputError
        An unreadable file, missing columns, too few points, or points that are not numbers, not
        sorted, compressive, or of negative stress.
    """
    missing = f"cannot read tensile data from {path}: no such file. Give the path of a CSV file"
    require_regular_file(path, missing)
    try:
        with path.open(encoding="utf-8-sig", newline="") as stream:
            rows = list(csv.DictReader(stream))
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise InputError(f"cannot read tensile data from {path}: {error}") from None
    columns = list(rows[0]) if rows else []
    strain = next((name for name in _STRETCH_COLUMNS if name in columns), None)
    stress = next((name for name in _STRESS_COLUMNS if name in columns), None)
    if strain is None or stress is None:
        raise InputError(
            f"{path} has the columns {columns}; tensile data need one of {list(_STRETCH_COLUMNS)} and "
            f"one of {list(_STRESS_COLUMNS)}. Name them in the first line, separated by commas"
        )
    stretch = _STRETCH_COLUMNS[strain](_numbers(rows, strain, path))
    test = TensileTest(stretch, _numbers(rows, stress, path) * _STRESS_COLUMNS[stress])
    _require_sound(test, path)
    return test


def left_out(test: TensileTest) -> str:
    """What of a test is not fitted, and why; empty where all of it is."""
    count = int((test.stretch > FIT_TO_STRETCH).sum())
    if not count:
        return ""
    return (
        f"{count} of {len(test.stretch)} points lie beyond a stretch of {FIT_TO_STRETCH:g} (up to "
        f"{test.stretch[-1]:g}) and are not fitted: presses do not stretch the silicone that far, and "
        "such points pull the modulus at small strain away"
    )


def fit_tensile(test: TensileTest, name: str) -> TensileFit:
    """Least squares of three solids, and E at small strain from those that fit.

    Points beyond a stretch of 2, more than a press reaches, are left out: with them E of one test
    of Platsil Gel-10 moves from 0.15 to 0.23 MPa (Yeoh). E is that of the stable solid with the
    least residual; its interval spans all stable solids that fit to 10 % of the largest stress: the
    spread between models of one specimen, not between batches.

    Raises
    ------
    InputError
        No stable solid fits to 10 %.
    """
    kept = test.stretch <= FIT_TO_STRETCH
    part = TensileTest(test.stretch[kept], test.nominal_stress_mpa[kept])
    solids = (_polynomial(part, "neo-hookean", 1), _polynomial(part, "yeoh", 3), _ogden(part))
    sound = [s for s in solids if s.stable and s.residual_percent < _LARGEST_RESIDUAL_PERCENT]
    if not sound:
        raise InputError(
            f"no solid fits {name} to {_LARGEST_RESIDUAL_PERCENT:g} % of its largest stress: a soft "
            "rubber's stress grows steadily with the stretch. Drop points after the specimen's "
            "failure, and check the units"
        )
    best = min(sound, key=lambda solid: solid.residual_mpa)
    moduli = [solid.youngs_modulus_mpa for solid in sound]
    source = f"{best.solid} fitted to {name}"
    return TensileFit(
        test, solids, ModulusEstimate(best.youngs_modulus_mpa, min(moduli), max(moduli), source)
    )


def nominal_stress_mpa(
    solid: str, constants: tuple[float, ...], stretch: Float[np.ndarray, "point"]
) -> Float[np.ndarray, "point"]:
    """P (MPa) of a solid in uniaxial tension."""
    if solid == "ogden":
        modulus, exponent = constants
        return modulus * _ogden_pull(stretch, exponent)
    return _polynomial_terms(stretch, len(constants)) @ np.array(constants)


def _numbers(rows: list[dict[str, str]], column: str, path: Path) -> np.ndarray:
    try:
        return np.array([float(row[column]) for row in rows])
    except (TypeError, ValueError) as error:
        raise InputError(
            f"{path}, column {column}: {error}. Every line needs a number with a decimal point"
        ) from None


def _require_sound(test: TensileTest, path: Path) -> None:
    stretch, stress = test.stretch, test.nominal_stress_mpa
    if not (np.isfinite(stretch).all() and np.isfinite(stress).all()):
        raise InputError(f"{path} holds values that are not finite. Remove those lines")
    if stretch.min() < 1 or stress.min() < 0:
        line = int(np.argmax((stretch < 1) | (stress < 0))) + 2
        raise InputError(
            f"{path}, line {line}: stretch {stretch[line - 2]:g}, stress {stress[line - 2]:g} MPa. "
            "Tension is needed: stretch ≥ 1 and stress ≥ 0. Zero the load cell, drop those lines"
        )
    if (np.diff(stretch) <= 0).any():
        line = int(np.argmax(np.diff(stretch) <= 0)) + 3
        raise InputError(
            f"{path}, line {line}: the stretch {stretch[line - 2]:g} does not exceed the one before. "
            "Give one pull, sorted by stretch; leave unloading out"
        )
    usable = int((stretch <= FIT_TO_STRETCH).sum())
    if usable < LEAST_POINTS or stretch[-1] < _LEAST_STRETCH:
        raise InputError(
            f"{path} has {usable} points up to a stretch of {min(stretch[-1], FIT_TO_STRETCH):g}; at "
            f"least {LEAST_POINTS} that reach {_LEAST_STRETCH:g} are needed. Pull further or keep more"
        )


def _polynomial_terms(stretch: np.ndarray, count: int) -> np.ndarray:
    invariant = stretch**2 + 2 / stretch - 3
    pull = 2 * (stretch - stretch**-2)
    return np.stack([i * pull * invariant ** (i - 1) for i in range(1, count + 1)], axis=1)


def _polynomial(test: TensileTest, solid: str, count: int) -> SolidFit:
    terms = _polynomial_terms(test.stretch, count)
    constants, *_ = np.linalg.lstsq(terms, test.nominal_stress_mpa)
    return _fit(test, solid, tuple(float(c) for c in constants), 6 * float(constants[0]))


def _ogden_pull(stretch: np.ndarray, exponent: float) -> np.ndarray:
    return stretch ** (exponent - 1) - stretch ** (-exponent / 2 - 1)


def _ogden(test: TensileTest) -> SolidFit:
    """The exponent by a bounded search for the least residual, the modulus by projection."""
    from scipy.optimize import minimize_scalar

    stress = test.nominal_stress_mpa

    def modulus(exponent: float) -> float:
        pull = _ogden_pull(test.stretch, exponent)
        return float(pull @ stress / (pull @ pull))

    def misfit(exponent: float) -> float:
        rest = modulus(exponent) * _ogden_pull(test.stretch, exponent) - stress
        return float(rest @ rest)

    coarse = np.linspace(*_EXPONENTS, 100)
    start = float(coarse[np.argmin([misfit(exponent) for exponent in coarse])])
    bounds = (max(start - 0.2, _EXPONENTS[0]), start + 0.2)
    found: Any = minimize_scalar(misfit, bounds=bounds, options={"xatol": 1e-10})
    exponent = float(found.x)
    mu = modulus(exponent)
    return _fit(test, "ogden", (mu, exponent), 1.5 * mu * exponent)


def _fit(
    test: TensileTest, solid: str, constants: tuple[float, ...], youngs_modulus_mpa: float
) -> SolidFit:
    misfit = nominal_stress_mpa(solid, constants, test.stretch) - test.nominal_stress_mpa
    residual = float(np.sqrt(misfit @ misfit / (len(misfit) - len(constants))))
    range_ = np.linspace(_STABLE_FROM_STRETCH, test.stretch[-1], 400)
    grows = bool((np.diff(nominal_stress_mpa(solid, constants, range_)) > 0).all())
    return SolidFit(
        solid,
        constants,
        youngs_modulus_mpa,
        residual,
        100 * residual / float(test.nominal_stress_mpa.max()),
        grows and youngs_modulus_mpa > 0,
    )

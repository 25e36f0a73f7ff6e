"""Hyperelastic solids that fit a tensile test, and the modulus at small strain.

Incompressible uniaxial tension, nominal stress P at stretch λ (forms as in `fem.large_strain.hyperelastic`):

    neo-Hookean, Yeoh   P = 2 (λ − λ⁻²) Σ i c_i (I − 3)^(i−1),   I = λ² + 2/λ
    Ogden, one term     P = μ (λ^(α − 1) − λ^(−α/2 − 1))
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from jaxtyping import Float

from design.catalogue.silicones import ModulusEstimate
from design.catalogue.tensile_files import FIT_TO_STRETCH, LEAST_POINTS, TensileTest
from design.errors import InputError

_STABLE_FROM_STRETCH = 0.5
"""Least stretch at which a solid must be stable: presses compress, tensile tests do not."""
_LARGEST_RESIDUAL_PERCENT = 10.0
"""Residual above which a solid does not describe the material (% of the largest stress)."""
_EXPONENTS = (0.1, 12.0)
"""Exponents among which Ogden's is sought."""
_RANGES_TO_STRETCH = (1.25, 1.5, 2.0, 3.0)
"""Stretches up to which the modulus is fitted, to show how it depends on the range."""
_NORMAL_90 = 1.645
"""Half the 90 % interval of a normal distribution, in standard deviations."""
_LARGEST_CORRELATION = 0.95
"""Bound on the correlation ρ of neighbouring residuals, as (1 + ρ)/(1 − ρ) has no value at 1."""


@dataclass(frozen=True)
class SolidFit:
    """One solid fitted to a test.

    `constants` are c_i in MPa, or Ogden's μ and α, as `instobj press --material` takes them.
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
class RangeFit:
    """One solid fitted to the points up to a stretch, with the 90 % interval of its modulus.

    The interval is of the fit alone, neighbouring residuals being alike; how much the moduli of
    solids and ranges differ says more.
    """

    to_stretch: float
    points: int
    fit: SolidFit
    low_mpa: float
    high_mpa: float


@dataclass(frozen=True)
class TensileFit:
    """All solids fitted to the points up to a stretch of 2, and the modulus with its spread."""

    test: TensileTest
    solids: tuple[SolidFit, ...]
    modulus: ModulusEstimate


def left_out(test: TensileTest) -> str:
    """Return what of a test is not fitted, and why; empty where all of it is."""
    count = int((test.stretch > FIT_TO_STRETCH).sum())
    if not count:
        return ""
    return (
        f"{count} of {len(test.stretch)} points lie beyond a stretch of {FIT_TO_STRETCH:g} (up to "
        f"{test.stretch[-1]:g}) and are not fitted: presses do not stretch the silicone that far, and "
        "such points pull the modulus at small strain away"
    )


def fit_tensile(test: TensileTest, name: str) -> TensileFit:
    """Least squares of three solids, and E at small strain from the solids that fit.

    Points beyond a stretch of 2, more than a press reaches, are left out: with them E of one test
    of Platsil Gel-10 moves from 0.15 to 0.23 MPa (Yeoh). E comes from the stable solid with the
    least residual; its interval spans all stable solids that fit to 10 % of the largest stress: the
    spread between models of one specimen, not between batches.

    Raises
    ------
    InputError
        No stable solid fits to 10 %.
    """
    kept = test.stretch <= FIT_TO_STRETCH
    part = TensileTest(test.stretch[kept], test.nominal_stress_mpa[kept])
    solids = _solids(part)
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


def fits_by_range(test: TensileTest) -> tuple[RangeFit, ...]:
    """Every solid fitted to the points up to stretches of 1.25, 1.5, 2 and 3, where the test reaches.

    A range needs six points, twice as many as Yeoh's solid has constants.
    """
    fits = []
    for stretch in _RANGES_TO_STRETCH:
        kept = test.stretch <= stretch
        if kept.sum() < LEAST_POINTS or test.stretch[-1] < stretch:
            continue
        part = TensileTest(test.stretch[kept], test.nominal_stress_mpa[kept])
        for fit in _solids(part):
            half = _NORMAL_90 * _standard_error_mpa(part, fit)
            modulus = fit.youngs_modulus_mpa
            fits.append(RangeFit(stretch, int(kept.sum()), fit, modulus - half, modulus + half))
    return tuple(fits)


def _standard_error_mpa(test: TensileTest, fit: SolidFit) -> float:
    """Standard error of the modulus: linear in the constants, residuals of a first-order autoregression."""
    constants = np.array(fit.constants)
    steps = np.diag(1e-4 * np.maximum(abs(constants), 1e-6))

    def slope(value: Callable[[tuple[float, ...]], Any]) -> np.ndarray:
        sides = [
            (value(tuple(constants + step)) - value(tuple(constants - step))) / (2 * step.sum())
            for step in steps
        ]
        return np.stack(sides, axis=-1)

    jacobian = slope(lambda c: nominal_stress_mpa(fit.solid, c, test.stretch))
    gradient = slope(lambda c: np.asarray(_modulus_mpa(fit.solid, c)))
    residual = nominal_stress_mpa(fit.solid, fit.constants, test.stretch) - test.nominal_stress_mpa
    alike = float(residual[1:] @ residual[:-1] / max(residual @ residual, 1e-30))
    alike = float(np.clip(alike, 0, _LARGEST_CORRELATION))
    covariance = np.linalg.pinv(jacobian.T @ jacobian, rcond=1e-12)
    variance = gradient @ covariance @ gradient * (1 + alike) / (1 - alike)
    return fit.residual_mpa * float(np.sqrt(max(variance, 0.0)))


def nominal_stress_mpa(
    solid: str, constants: tuple[float, ...], stretch: Float[np.ndarray, "point"]
) -> Float[np.ndarray, "point"]:
    """P (MPa) of a solid in uniaxial tension."""
    if solid == "ogden":
        modulus, exponent = constants
        return modulus * _ogden_pull(stretch, exponent)
    return _polynomial_terms(stretch, len(constants)) @ np.array(constants)


def _solids(test: TensileTest) -> tuple[SolidFit, ...]:
    return _polynomial(test, "neo-hookean", 1), _polynomial(test, "yeoh", 3), _ogden(test)


def _modulus_mpa(solid: str, constants: tuple[float, ...]) -> float:
    """E at small strain."""
    if solid == "ogden":
        return 1.5 * constants[0] * constants[1]
    return 6 * constants[0]


def _polynomial_terms(stretch: np.ndarray, count: int) -> np.ndarray:
    invariant = stretch**2 + 2 / stretch - 3
    pull = 2 * (stretch - stretch**-2)
    return np.stack([i * pull * invariant ** (i - 1) for i in range(1, count + 1)], axis=1)


def _polynomial(test: TensileTest, solid: str, count: int) -> SolidFit:
    terms = _polynomial_terms(test.stretch, count)
    constants, *_ = np.linalg.lstsq(terms, test.nominal_stress_mpa)
    return _fit(test, solid, tuple(float(c) for c in constants))


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
    minimum: Any = minimize_scalar(misfit, bounds=bounds, options={"xatol": 1e-10})
    exponent = float(minimum.x)
    return _fit(test, "ogden", (modulus(exponent), exponent))


def _fit(test: TensileTest, solid: str, constants: tuple[float, ...]) -> SolidFit:
    youngs_modulus_mpa = _modulus_mpa(solid, constants)
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

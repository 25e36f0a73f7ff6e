"""Hyperelastic silicones: strain energy per undeformed volume and its derivatives.

    W(F) = Σ c_i I^i + Σ_p (μ_p/α_p) (λ_1^α_p + λ_2^α_p + λ_3^α_p − 3 − α_p ln J),
    I = |F|² − 3 − 2 ln J,   J = det F,   λ_a the principal stretches.

One c_1 is the neo-Hookean solid, up to three c_i are Yeoh's (Rubber Chem. Technol. 66 (1993)
754), the second sum is Ogden's (Proc. R. Soc. Lond. A 326 (1972) 565 and 328 (1972) 567). The
terms in ln J leave F = 1 free of stress, make W'' there exactly 2μ ε:ε of small strain, and vanish
where the volume is kept; resistance to change of volume is added by the mixed element.

Derivatives are written by hand: stretches repeat in every undeformed or uniaxially stretched
element, and there automatic differentiation of an eigendecomposition divides by zero, while the
divided differences of `_ogden_modulus` are exact.

Arrays are (..., 3, 3) for F and P = ∂W/∂F, (..., 3, 3, 3, 3) for ∂P/∂F.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from design.errors import InputError

_PAIRS = ((0, 1), (0, 2), (1, 2))
"""Pairs of principal directions."""


@dataclass(frozen=True)
class Hyperelastic:
    """Coefficients c_i (MPa) and Ogden's pairs (μ_p in MPa, α_p); either may be empty."""

    name: str
    invariant_coefficients_mpa: tuple[float, ...] = ()
    ogden_terms: tuple[tuple[float, float], ...] = ()

    @property
    def shear_modulus_mpa(self) -> float:
        """μ of small strain: 2 c_1 + ½ Σ μ_p α_p."""
        first = self.invariant_coefficients_mpa[0] if self.invariant_coefficients_mpa else 0.0
        return 2 * first + sum(mu * alpha for mu, alpha in self.ogden_terms) / 2


def neo_hookean(youngs_modulus_mpa: float, poisson_ratio: float) -> Hyperelastic:
    """c_1 = μ/2 with μ = E / (2 (1 + ν))."""
    return Hyperelastic("neo-hookean", (youngs_modulus_mpa / (4 * (1 + poisson_ratio)),))


def yeoh(c1_mpa: float, c2_mpa: float = 0.0, c3_mpa: float = 0.0) -> Hyperelastic:
    """Yeoh's solid; μ = 2 c_1.

    Raises
    ------
    InputError
        c_1 is not positive.
    """
    return _stable(Hyperelastic("yeoh", (c1_mpa, c2_mpa, c3_mpa)))


def ogden(moduli_mpa: tuple[float, ...], exponents: tuple[float, ...]) -> Hyperelastic:
    """Ogden's solid, W = Σ (μ_p/α_p)(Σ λ^α_p − 3); μ = ½ Σ μ_p α_p.

    Raises
    ------
    InputError
        Unequal numbers of constants, an exponent of zero, or a shear modulus that is not positive.
    """
    if len(moduli_mpa) != len(exponents) or not exponents or 0 in exponents:
        raise InputError(
            "Ogden's solid needs as many moduli as exponents, none of them zero; got "
            f"{list(moduli_mpa)} and {list(exponents)}. Give pairs μ_1 α_1 μ_2 α_2 …"
        )
    return _stable(Hyperelastic("ogden", (), tuple(zip(moduli_mpa, exponents, strict=True))))


def first_piola_stress(
    material: Hyperelastic, deformation: Float[np.ndarray, "*point 3 3"]
) -> Float[np.ndarray, "*point 3 3"]:
    """P = ∂W/∂F in MPa."""
    inverse_transposed = inverse_transpose(deformation)
    stress = np.zeros_like(deformation)
    if material.invariant_coefficients_mpa:
        first, _ = _invariant_derivatives(material, deformation)
        stress += 2 * first[..., None, None] * (deformation - inverse_transposed)
    if material.ogden_terms:
        values, vectors = np.linalg.eigh(_right_cauchy_green(deformation))
        second = sum(mu * values ** (alpha / 2 - 1) for mu, alpha in material.ogden_terms)
        stress += deformation @ _from_principal(vectors, np.asarray(second))
        stress -= sum(mu for mu, _ in material.ogden_terms) * inverse_transposed
    return stress


def tangent_modulus(
    material: Hyperelastic, deformation: Float[np.ndarray, "*point 3 3"]
) -> Float[np.ndarray, "*point 3 3 3 3"]:
    """∂P_ij/∂F_kl in MPa, symmetric under (ij) ↔ (kl)."""
    modulus = np.zeros((*deformation.shape, 3, 3))
    inverse_transposed = inverse_transpose(deformation)
    # F⁻ᵀ_il F⁻ᵀ_kj = −∂F⁻ᵀ_ij/∂F_kl
    swapped = np.einsum("...il,...kj->...ijkl", inverse_transposed, inverse_transposed)
    if material.invariant_coefficients_mpa:
        first, second = _invariant_derivatives(material, deformation)
        direction = 2 * (deformation - inverse_transposed)
        modulus += 2 * first[..., None, None, None, None] * (_identity() + swapped)
        if second.any():
            scaled = second[..., None, None] * direction
            # Chain rule through the invariant: W'' (∂I/∂F)_ij (∂I/∂F)_kl
            modulus += np.einsum("...ij,...kl->...ijkl", scaled, direction)
    if material.ogden_terms:
        modulus += _ogden_modulus(material, deformation)
        modulus += sum(mu for mu, _ in material.ogden_terms) * swapped
    return modulus


def inverse_transpose(
    deformation: Float[np.ndarray, "*point 3 3"],
) -> Float[np.ndarray, "*point 3 3"]:
    """F⁻ᵀ, by cofactors: quicker than a general inverse."""
    a, b, c = (deformation[..., row, :] for row in range(3))
    cofactors = np.stack([np.cross(b, c), np.cross(c, a), np.cross(a, b)], axis=-2)
    # det F = a · (b × c), the first row by its cofactors
    return cofactors / np.einsum("...i,...i->...", a, cofactors[..., 0, :])[..., None, None]


def _stable(material: Hyperelastic) -> Hyperelastic:
    if not material.shear_modulus_mpa > 0:
        raise InputError(
            f"the {material.name} constants give a shear modulus of "
            f"{material.shear_modulus_mpa:g} MPa at small strain; it must be positive. Check their "
            "order and signs"
        )
    return material


def _identity() -> np.ndarray:
    """δ_ik δ_jl."""
    return np.einsum("ik,jl->ijkl", np.eye(3), np.eye(3))


def _right_cauchy_green(deformation: np.ndarray) -> np.ndarray:
    return np.swapaxes(deformation, -1, -2) @ deformation


def _invariant_derivatives(
    material: Hyperelastic, deformation: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """dW/dI and d²W/dI²."""
    volume_ratio = np.linalg.det(deformation)
    invariant = (deformation**2).sum(axis=(-2, -1)) - 3 - 2 * np.log(volume_ratio)
    first, second = np.zeros_like(invariant), np.zeros_like(invariant)
    for power, coefficient in enumerate(material.invariant_coefficients_mpa, start=1):
        first += power * coefficient * invariant ** (power - 1)
        if power > 1 and coefficient:
            second += power * (power - 1) * coefficient * invariant ** (power - 2)
    return first, second


def _from_principal(vectors: np.ndarray, values: np.ndarray) -> np.ndarray:
    # Σ_a v_a n_a n_aᵀ: a principal direction, i and j coordinates
    return np.einsum("...ia,...a,...ja->...ij", vectors, values, vectors)


def _ogden_modulus(material: Hyperelastic, deformation: np.ndarray) -> np.ndarray:
    """∂(F S)/∂F with S = Σ μ_p C^(α_p/2 − 1), a function of the matrix C = FᵀF.

    In the principal axes of C, dS_ab = s[c_a, c_b] dC_ab with the divided differences of s.
    """
    values, vectors = np.linalg.eigh(_right_cauchy_green(deformation))
    stress = np.zeros_like(values)
    slopes = np.zeros_like(deformation)
    for mu, alpha in material.ogden_terms:
        stress += mu * values ** (alpha / 2 - 1)
        slopes += mu * divided_differences(values, alpha / 2 - 1)
    # dP = dF S + F dS. Second part: with f_a = F n_a, dC_ab = n_aᵀ dFᵀ f_b + f_aᵀ dF n_b, so that
    # F dS = Σ_ab s[c_a, c_b] dC_ab f_a n_bᵀ is a sum of dyads `left` ⊗ `right`.
    principal = deformation @ vectors
    modulus = np.zeros((*deformation.shape, 3, 3))
    for a in range(3):
        for b in range(3):
            # left = f_a n_bᵀ, right = ∂C_ab/∂F = f_a n_bᵀ + f_b n_aᵀ; their dyad is summed over a and b
            left = np.einsum("...i,...j->...ij", principal[..., a], vectors[..., b])
            right = left + np.einsum("...k,...l->...kl", principal[..., b], vectors[..., a])
            left *= slopes[..., a, b, None, None]
            modulus += np.einsum("...ij,...kl->...ijkl", left, right)
    second = _from_principal(vectors, stress)  # first part: ∂(dF S)_ij/∂F_kl = δ_ik S_lj
    return modulus + np.einsum("ik,...jl->...ijkl", np.eye(3), second)


def divided_differences(values: np.ndarray, power: float) -> np.ndarray:
    """(a^β − b^β)/(a − b) of all pairs of `values` (..., 3), exact where they coincide."""
    table = np.zeros((*values.shape, 3))
    for a in range(3):
        table[..., a, a] = power * values[..., a] ** (power - 1)
    for a, b in _PAIRS:
        log_ratio = np.log(values[..., a] / values[..., b])
        near = abs(log_ratio) < 1e-9
        safe = np.where(near, 1.0, log_ratio)
        quotient = np.where(near, power, np.expm1(power * safe) / np.expm1(safe))
        table[..., a, b] = table[..., b, a] = values[..., b] ** (power - 1) * quotient
    return table

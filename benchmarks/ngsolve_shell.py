"""Elasticity of a shell with stiff magnets in NGSolve, which the references of contact forces share."""

from __future__ import annotations

from importlib import import_module
from typing import Any

STIFFER = 3e3
"""Modulus of a magnet over that of the silicone: stiff as steel is to rubber, without rounding."""


def shell_system(
    mesh: Any, magnets: int, modulus_mpa: float, poisson_ratio: float, held_along_y: str = ""
) -> tuple[Any, Any, Any, list[Any]]:
    """Return a factored shell: space, test function of the displacement, inverse, and magnets' means.

    Taylor–Hood elements (displacement of order 2, pressure of order 1). The boundary "held" stands
    fast, `held_along_y` moves in its plane. Means are rows (magnet x, y, z) on the space's unknowns.
    """
    ng: Any = import_module("ngsolve")
    mu = modulus_mpa / 2 / (1 + poisson_ratio)
    lam = modulus_mpa * poisson_ratio / (1 + poisson_ratio) / (1 - 2 * poisson_ratio)
    stiff = mesh.MaterialCF({f"magnet{i}": STIFFER for i in range(magnets)}, default=1.0)
    space = ng.VectorH1(mesh, order=2, dirichlet="held", dirichlety=held_along_y)
    space = space * ng.H1(mesh, order=1)
    (u, p), (v, q) = space.TnT()
    matrix = ng.BilinearForm(space, symmetric=True)
    strain = ng.InnerProduct(ng.Sym(ng.Grad(u)), ng.Sym(ng.Grad(v)))
    # weak form of 2 μ ε(u) − p 1 and p = −λ div u, stiffness times `stiff` in magnets
    matrix += (
        2 * mu * stiff * strain - p * ng.div(v) - q * ng.div(u) - p * q / lam / stiff
    ) * ng.dx
    inverse = matrix.Assemble().mat.Inverse(space.FreeDofs(), inverse="sparsecholesky")
    means = []
    for index in range(magnets):
        region = ng.dx(definedon=mesh.Materials(f"magnet{index}"))
        volume = ng.Integrate(ng.CF(1.0) * region, mesh)
        for k in range(3):
            mean = ng.LinearForm(space)
            mean += v[k] / volume * region
            means.append(mean.Assemble().vec.FV().NumPy().copy())
    return space, v, inverse, means

"""Single solves of this project beside its peers: plain P2, and Taylor–Hood.

Plain P2 is no element of the product (it locks): it is assembled here from the product's own
reference tensors, because CalculiX has nothing better. Where silicone is nearly incompressible, P2
is compared at ν 0.3 and Taylor–Hood at ν 0.4999.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module

import numpy as np
import scipy.sparse as sp
from mechanics_peers import (
    Problem,
    Solved,
    netgen_mesh,
    solve_with_calculix,
    solve_with_ngsolve,
    why_no_calculix,
    why_no_dolfinx,
    why_no_ngsolve,
)
from skfem import Basis, ElementTetP2, MeshTet

from fem.linear.assembly import (
    UPPER_BLOCKS,
    affine_elements,
    elastic_blocks,
    node_pattern,
    reference_shapes,
    vector_matrix,
)
from fem.linear.elements import assemble, free_motion_basis, saddle_point_matrix, taylor_hood
from fem.linear.factorization import Factorization
from fem.linear.material import lame_constants
from fem.linear.sparse import shape_of

NGSOLVE_INVERSES = ("sparsecholesky", "pardiso")
"""UMFPACK is several times slower than either on every size tried."""


@dataclass(frozen=True)
class Contest:
    """Rivals that solve one problem with one element; `ours` is among them."""

    name: str
    vertices: int
    nodes: int
    rivals: dict[str, Callable[[], Solved]]
    missing: dict[str, str]


def solve_taylor_hood(problem: Problem) -> Solved:
    """This project's default element and factorization."""
    wall, cpu = {}, time.process_time()
    start = time.perf_counter()
    space = taylor_hood(problem.mesh)
    held = _held_nodes(problem, space.displacement)
    material = lame_constants(problem.youngs_modulus_mpa, problem.poisson_ratio)
    basis = free_motion_basis(~held)
    matrix = saddle_point_matrix(assemble(space, material), basis, space.pressure_nodes)
    load = np.zeros(shape_of(matrix)[0])
    motions = basis.T @ problem.nodal_forces().ravel()
    load[: len(motions)] = motions
    wall["assemble"] = time.perf_counter() - start
    solution = _solve(matrix, load, wall)
    return _solved(problem, basis @ solution[: len(motions)], wall, cpu)


def solve_plain_p2(problem: Problem) -> Solved:
    """Displacement alone, by the product's assembly and factorization."""
    wall, cpu = {}, time.process_time()
    start = time.perf_counter()
    space = Basis(problem.mesh, ElementTetP2(), intorder=2)
    elements, shapes = affine_elements(space), reference_shapes(ElementTetP2())
    mu, lam = problem.lame_mpa
    blocks = elastic_blocks(elements, shapes, mu)
    products = (lam * shapes.slope_slope).reshape(9, -1)
    for block, (i, j) in zip(blocks, UPPER_BLOCKS, strict=True):
        weight = np.einsum(
            "ek,el,e->ekl", elements.slopes[..., i], elements.slopes[..., j], elements.volumes_mm3
        )
        block += weight.reshape(-1, 9) @ products
    pattern = node_pattern(np.asarray(space.element_dofs).T, int(space.N))
    basis = free_motion_basis(~_held_nodes(problem, space))
    matrix = sp.csr_matrix(basis.T @ vector_matrix(pattern, blocks) @ basis)
    load = basis.T @ problem.nodal_forces().ravel()
    wall["assemble"] = time.perf_counter() - start
    return _solved(problem, basis @ _solve(matrix, load, wall), wall, cpu)


def contests(mesh: MeshTet, held: np.ndarray, threads: int) -> list[Contest]:
    """P2 at ν 0.3 and Taylor–Hood at ν 0.4999 on one mesh, with whatever peers are installed."""
    compressible, silicone = (Problem(mesh, held, 0.3, nu) for nu in (0.3, 0.4999))
    p2: dict[str, Callable[[], Solved]] = {"instobj": lambda: solve_plain_p2(compressible)}
    mixed: dict[str, Callable[[], Solved]] = {"instobj": lambda: solve_taylor_hood(silicone)}
    missing = {
        name: why
        for name, why in {
            "NGSolve": why_no_ngsolve(),
            "CalculiX": why_no_calculix(),
            "dolfinx": why_no_dolfinx(),
        }.items()
        if why
    }
    if "NGSolve" not in missing:
        p2 |= _ngsolve_rivals(compressible, False, threads)
        mixed |= _ngsolve_rivals(silicone, True, threads)
    if "CalculiX" not in missing:
        p2["CalculiX, SPOOLES"] = lambda: solve_with_calculix(compressible, threads)
    vertices, nodes = mesh.p.shape[1], int(Basis(mesh, ElementTetP2(), intorder=1).N)
    return [
        Contest("P2, displacement alone", vertices, nodes, p2, missing),
        Contest("Taylor–Hood", vertices, nodes, mixed, missing),
    ]


def _ngsolve_rivals(problem: Problem, mixed: bool, threads: int) -> dict[str, Callable[[], Solved]]:
    import_module("ngsolve").SetNumThreads(threads)
    mesh = netgen_mesh(problem)
    return {
        f"NGSolve, {inverse}": lambda inverse=inverse: solve_with_ngsolve(
            problem, mesh, mixed, inverse
        )
        for inverse in NGSOLVE_INVERSES
    }


def _solve(matrix: sp.csr_matrix, load: np.ndarray, wall: dict[str, float]) -> np.ndarray:
    start = time.perf_counter()
    with Factorization(matrix) as factor:
        wall["factor"] = time.perf_counter() - start
        start = time.perf_counter()
        solution = factor.solve(load[:, None])[:, 0]
    wall["solve"] = time.perf_counter() - start
    return solution


def _held_nodes(problem: Problem, basis: Basis) -> np.ndarray:
    held = np.zeros(int(basis.N), bool)
    held[np.asarray(basis.get_dofs(facets=problem.held).all())] = True
    return held


def _solved(problem: Problem, u: np.ndarray, wall: dict[str, float], cpu: float) -> Solved:
    vertices = problem.mesh.p.shape[1]
    return Solved(u.reshape(3, -1)[:, :vertices], wall, time.process_time() - cpu)

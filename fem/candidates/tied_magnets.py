"""Rigid magnets tied to a mesh that does not know them, with Lagrange multipliers.

The displacement on a magnet's skin is held to a rigid motion (c, ω) in the mean, weighted with
polynomials ψ_k: ∫ ψ_k (u − c − ω × r) dS = 0. The multipliers are the magnet's tractions. With the
flexibility S = Φᵀ A⁻¹ Φ of these functionals Φ, everything but their solves is small and dense, so
any layout is answered by the one factorization of the magnet-free mesh.

Elements that the skin crosses stiffen too, so on coarse elements a magnet acts as if it were larger.
Ties therefore lie `INSET` = 0.035 mean edge lengths inside the skin (at most a fifth of the height),
found to suit edges of 1 to 3 mm. Against a mesh that resolves one magnet with edges of 0.5 mm
(largest error of four patch loads over and next to it, in compliance, displacement and rotation of
the magnet), 36 functionals:

| mean edge at the magnet | compliance | displacement | rotation |
|---|---|---|---|
| 1.06 mm | −1.8 % | 1.5 % | 1.7 % |
| 1.06 mm, on the very skin | −3.6 % | 1.7 % | 1.7 % |
| 1.16 mm | −2.0 % | 1.5 % | 2.0 % |
| 1.43 mm | −3.8 % | 1.4 % | 1.8 % |
| 2.66 mm, the default mesh | −4.5 % | 1.2 % | 4.7 % |
| 2.66 mm, on the very skin | −9.9 % | 4.8 % | 7.1 % |
| 0.72 mm | +3.8 % | 3.9 % | 3.5 % |

The last row shows too few functionals for fine elements: the silicone then squeezes between them,
and a higher `degree` is due. The default of 2 takes 36 for a disk. Layouts tied to one mesh differ
by nothing but the layout, where meshing each again adds the scatter between meshes.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations

import numpy as np
import scipy.linalg
import scipy.sparse as sp
from jaxtyping import Float

from design.errors import InputError
from design.layout.places.positions import shell_body_layout
from design.spec.object import ObjectSpec
from fem.candidates.point_motions import containing_tets, interpolate_at
from fem.candidates.quadrature import skin_quadrature
from fem.linear.elements import DisplacementSpace
from fem.linear.factorization import Factorization, SingularSystemError
from fem.linear.response import ElasticSystem, ResponseOperator, face_pressure_loads
from fem.linear.sparse import rows_of, shape_of

DEGREE = 2
"""Degree of the polynomials across a magnet: 36 functionals for a disk (the table above)."""
INSET, MOST_INSET = 0.035, 0.2
"""Depth of the ties inside the skin: mean edge lengths, and at most this share of the height."""
_CHUNK = 128
"""Right-hand sides solved at once: it bounds the memory."""
_INDEPENDENT = 1e-6
"""Share of the largest singular value below which polynomials depend on each other."""


def rigid_magnet_response(
    spec: ObjectSpec,
    system: ElasticSystem,
    factor: Factorization,
    plain: ResponseOperator,
    degree: int = DEGREE,
) -> ResponseOperator:
    """The response of the object with this specification's magnets, from the magnet-free one.

    Parameters
    ----------
    system, factor : `elastic_system(mesh, spec)` on a magnet-free mesh, and its matrix, factored
    plain : `build_response` of the same
    degree : of the polynomials across the magnet; 3 (degree + 1)(degree + 2) functionals a magnet

    Raises
    ------
    InputError
        A magnet outside the silicone, or a frictionless core.
    SingularSystemError
        The mesh cannot tell the functionals apart: too high a degree for its elements.
    """
    if plain.core is not None:
        raise InputError(
            'magnets are tied on a bonded core only; got mechanics.interface = "frictionless". Mesh '
            "the magnets instead"
        )
    functionals, rigid = tie_functionals(spec, system.space, degree)
    flexibility, crossed = flexibilities(spec, system, factor, functionals)
    return replace(
        plain, compliance=tied_compliance(np.asarray(plain.compliance), flexibility, crossed, rigid)
    )


def tie_functionals(
    spec: ObjectSpec, space: DisplacementSpace, degree: int
) -> tuple[sp.csr_matrix, Float[np.ndarray, "functional motion"]]:
    """Weighted means over every magnet's skin, of nodal displacements and of its rigid motions.

    Shapes (functional, 3·node) and (functional, 6·magnet), magnet by magnet.
    """
    layout = shell_body_layout(spec)
    rows, rigid = [], []
    for centre, frame, body in zip(layout.centre_mm, layout.frame, layout.bodies, strict=True):
        whole, _ = skin_quadrature(body.outline, body.height_mm)
        inset = INSET * edge_mm(space, centre + whole @ frame.T)
        inset = min(inset, MOST_INSET * body.height_mm)
        local, weights = skin_quadrature(body.outline.inset(inset), body.height_mm - 2 * inset)
        psi = polynomials(local, weights, degree) * weights[:, None]
        arm = local @ frame.T
        values = interpolate_at(space, centre + arm)
        rows.append(sp.block_diag([sp.csr_matrix(psi.T) @ values] * 3))
        rigid.append(np.concatenate([psi.T @ part for part in rigid_motions(arm)]))
    return rows_of(rows), np.asarray(scipy.linalg.block_diag(*rigid))


def flexibilities(
    spec: ObjectSpec, system: ElasticSystem, factor: Factorization, functionals: sp.csr_matrix
) -> tuple[np.ndarray, np.ndarray]:
    """Φᵀ A⁻¹ Φ, and Φᵀ A⁻¹ L of the faces' pressures L."""
    basis = system.motion_basis
    motions, count = shape_of(basis)[1], shape_of(functionals)[0]
    phi = sp.csc_matrix(basis.T @ functionals.T)
    loads = sp.csr_matrix(basis.T @ face_pressure_loads(system.space, spec)[1])
    flexibility, crossed = np.zeros((count, count)), np.zeros((count, shape_of(loads)[1]))
    for first in range(0, count, _CHUNK):
        chunk = slice(first, min(first + _CHUNK, count))
        right = np.zeros((shape_of(system.matrix)[0], chunk.stop - first), order="F")
        right[:motions] = phi[:, chunk].toarray()
        solved = factor.solve(right)[:motions]
        flexibility[:, chunk] = phi.T @ solved
        crossed[chunk] = (loads.T @ solved).T
    return (flexibility + flexibility.T) / 2, crossed


def tied_compliance(
    plain: np.ndarray, flexibility: np.ndarray, crossed: np.ndarray, rigid: np.ndarray
) -> np.ndarray:
    """Compliance of pressures and magnet loads under the ties: a Schur complement of both.

    With λ the magnets' tractions on the silicone, d their motions and g the loads on them:
    crossed p + flexibility λ = rigid d, rigidᵀ λ = g.
    """
    try:
        lower = np.linalg.cholesky(flexibility)
    except np.linalg.LinAlgError as error:
        raise SingularSystemError(
            "the mesh cannot tell the magnets' ties apart. Use a lower degree or smaller edges"
        ) from error
    crossed, rigid = (
        scipy.linalg.solve_triangular(lower, block, lower=True) for block in (crossed, rigid)
    )
    motion_compliance = np.linalg.inv(rigid.T @ rigid)
    coupling = rigid.T @ crossed
    moved = motion_compliance @ coupling
    surface = plain - crossed.T @ crossed + coupling.T @ moved
    return np.block([[(surface + surface.T) / 2, moved.T], [moved, motion_compliance]])


def edge_mm(space: DisplacementSpace, points_mm: np.ndarray) -> float:
    """Mean edge length of the elements that hold the points, each counted as often as it does."""
    tets = np.asarray(space.mesh.t)[:, containing_tets(space.mesh, points_mm)]
    corner = np.asarray(space.mesh.p)[:, tets]
    ends = [corner[:, a] - corner[:, b] for a, b in combinations(range(4), 2)]
    return float(np.mean(np.linalg.norm(ends, axis=1)))


def polynomials(points_mm: np.ndarray, weights: np.ndarray, degree: int) -> np.ndarray:
    """Orthonormal basis (point, k) of x^a y^b z^c, a + b ≤ degree, c ≤ 1, on the quadrature."""
    x, y, z = (points_mm / abs(points_mm).max(axis=0)).T
    powers = [(n - b, b, c) for c in (0, 1) for n in range(degree + 1) for b in range(n + 1)]
    values = np.stack([x**a * y**b * z**c for a, b, c in powers], axis=1)
    root = np.sqrt(weights)[:, None]
    basis, size, _ = np.linalg.svd(values * root, full_matrices=False)
    return basis[:, size > _INDEPENDENT * size[0]] / root


def rigid_motions(arm_mm: np.ndarray) -> list[np.ndarray]:
    """Columns of u_x, u_y and u_z under unit (c, ω): u = c + ω × r."""
    x, y, z = arm_mm.T
    ones, zeros = np.ones_like(x), np.zeros_like(x)
    return [
        np.column_stack([ones, zeros, zeros, zeros, z, -y]),
        np.column_stack([zeros, ones, zeros, -z, zeros, x]),
        np.column_stack([zeros, zeros, ones, y, -x, zeros]),
    ]

"""Displacements and turns of points in the silicone, as rows on nodal displacements.

A point moves by u and turns by ½ curl u; how a rigid magnet there moves is told by
`fem.candidates.rigid_body`.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy.sparse as sp
from jaxtyping import Float, Int
from scipy.spatial import KDTree
from skfem import MeshTet

from design.errors import InputError
from fem.linear.elements import DisplacementSpace
from fem.linear.sparse import columns_of, rows_of, shape_of

_LEVI_CIVITA = ((0, 1, 2), (1, 2, 0), (2, 0, 1))
_NEAREST = (8, 64, 512)
_LOOKUPS = 500_000
_TOLERANCE = 1e-9


@dataclass(frozen=True)
class PointInterpolation:
    """Rows that take one displacement component at the nodes to points, and to its slopes there.

    `values` (point, node); `slopes` ∂/∂x, ∂/∂y, ∂/∂z (point, node), per mm.
    """

    values: sp.csr_matrix
    slopes: tuple[sp.csr_matrix, sp.csr_matrix, sp.csr_matrix]


def interpolate_at(
    space: DisplacementSpace, points_mm: Float[np.ndarray, "point 3"]
) -> PointInterpolation:
    """Evaluate the finite-element displacement at points, exactly as the elements represent it.

    Raises
    ------
    InputError
        A point outside the mesh.
    ValueError
        The space does not cover the whole mesh (rigid magnets cut out of it).
    """
    basis = space.displacement
    if basis.nelems != basis.mesh.nelements:
        raise ValueError("points are looked up in the whole mesh: use one without rigid magnets")
    cells = containing_tets(space.mesh, points_mm)
    local = basis.mapping.invF(np.ascontiguousarray(points_mm.T)[:, :, None], tind=cells)
    fields = [basis.elem.gbasis(basis.mapping, local, k, tind=cells)[0] for k in range(basis.Nbfun)]
    rows = np.tile(np.arange(len(points_mm)), basis.Nbfun)
    columns = basis.element_dofs[:, cells].ravel()
    shape = (len(points_mm), basis.N)

    def matrix(values: list[np.ndarray]) -> sp.csr_matrix:
        return sp.csr_matrix((np.concatenate(values), (rows, columns)), shape=shape)

    x, y, z = (matrix([np.asarray(field.grad)[a][:, 0] for field in fields]) for a in range(3))
    return PointInterpolation(matrix([np.asarray(field)[:, 0] for field in fields]), (x, y, z))


def containing_tets(
    mesh: MeshTet, points_mm: Float[np.ndarray, "point 3"]
) -> Int[np.ndarray, "point"]:
    """The element that each point lies in: first the few with the nearest centroids, then more.

    Raises
    ------
    InputError
        A point outside the mesh.
    """
    corner = np.moveaxis(np.asarray(mesh.p)[:, np.asarray(mesh.t)], 0, -1)  # (4, tet, 3)
    inverse = np.linalg.inv(np.moveaxis(corner[1:] - corner[0], 0, -1))
    tree = KDTree(corner.mean(axis=0))
    found = np.full(len(points_mm), -1)
    for count in _NEAREST:
        missing = np.flatnonzero(found < 0)
        for some in np.array_split(missing, 1 + len(missing) * count // _LOOKUPS):
            if len(some) == 0:
                continue
            near = np.asarray(tree.query(points_mm[some], min(count, len(inverse)))[1])
            offset = points_mm[some, None] - corner[0][near]
            share = np.einsum("pnij,pnj->pni", inverse[near], offset)
            inside = np.minimum(share.min(axis=2), 1 - share.sum(axis=2))
            best = inside.argmax(axis=1)
            row = np.arange(len(some))
            found[some] = np.where(inside[row, best] > -_TOLERANCE, near[row, best], -1)
    if (found < 0).any():
        x, y, z = points_mm[found < 0][0]
        raise InputError(
            f"the point ({x:g}, {y:g}, {z:g}) mm lies outside the silicone. Keep points inside the "
            "shell"
        )
    return found


def motion_rows(interpolation: PointInterpolation) -> sp.csr_matrix:
    """Displacement, then ½ curl u, of every point: (6·point, 3·node), nodes by component."""
    values, slopes = interpolation.values, interpolation.slopes
    zero = sp.csr_matrix(shape_of(values))
    rows = [
        columns_of([values if component == i else zero for component in range(3)]) for i in range(3)
    ]
    for _, j, k in _LEVI_CIVITA:  # ω_i = ½ (∂_j u_k − ∂_k u_j)
        blocks = [zero] * 3
        blocks[k], blocks[j] = slopes[j] / 2, -slopes[k] / 2
        rows.append(columns_of(blocks))
    return _interleaved(rows_of(rows))


def _interleaved(rows: sp.csr_matrix) -> sp.csr_matrix:
    """From component by component to point by point."""
    count = shape_of(rows)[0] // 6
    return rows[np.arange(6 * count).reshape(6, count).T.ravel()]

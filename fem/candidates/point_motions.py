"""Displacements of points in the silicone, as rows on nodal displacements.

`fem.candidates.rigid_body` says how a rigid magnet there moves.
"""

from __future__ import annotations

import numpy as np
import scipy.sparse as sp
from jaxtyping import Float, Int
from scipy.spatial import KDTree
from skfem import MeshTet

from design.errors import InputError
from fem.linear.elements import DisplacementSpace

_NEAREST = (8, 64, 512)
"""Tets round a point that are tried, nearest first; more only for points that are not found."""
_LOOKUPS = 500_000
"""Pairs of point and tet that are compared at once: it bounds the memory."""
_TOLERANCE = 1e-9
"""Barycentric coordinate below 0 that is rounding."""


def interpolate_at(
    space: DisplacementSpace, points_mm: Float[np.ndarray, "point 3"]
) -> sp.csr_matrix:
    """Rows (point, node) that take one displacement component at the nodes to points, exactly as the
    elements represent it.

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
    values = np.concatenate([np.asarray(field)[:, 0] for field in fields])
    return sp.csr_matrix((values, (rows, columns)), shape=(len(points_mm), basis.N))


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
    tets = np.full(len(points_mm), -1)
    for count in _NEAREST:
        missing = np.flatnonzero(tets < 0)
        for some in np.array_split(missing, 1 + len(missing) * count // _LOOKUPS):
            if len(some) == 0:
                continue
            near = np.asarray(tree.query(points_mm[some], min(count, len(inverse)))[1])
            offset = points_mm[some, None] - corner[0][near]
            # Barycentric coordinates: p point, n near tet, j coordinate, i of three corners.
            # Inside a tet
            # all of them and 1 less their sum are ≥ 0.
            share = np.einsum("pnij,pnj->pni", inverse[near], offset)
            inside = np.minimum(share.min(axis=2), 1 - share.sum(axis=2))
            best = inside.argmax(axis=1)
            row = np.arange(len(some))
            tets[some] = np.where(inside[row, best] > -_TOLERANCE, near[row, best], -1)
    if (tets < 0).any():
        x, y, z = points_mm[tets < 0][0]
        raise InputError(
            f"the point ({x:g}, {y:g}, {z:g}) mm lies outside the silicone. Keep points inside the "
            "shell"
        )
    return tets

"""scikit-fem's tetrahedra with edges and facets found by whole numbers, not by rows."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from jaxtyping import Float, Int
from skfem import MeshTet

_BITS = 21
"""Bits of a vertex: three make a number of 63 bits."""


def tet_mesh(points_mm: Float[np.ndarray, "vertex 3"], tets: Int[np.ndarray, "tet 4"]) -> MeshTet:
    """A `MeshTet` that numbers its edges and facets as ever, in a tenth of the time."""
    mesh = MeshTet(points_mm.T.copy(), tets.T.copy())
    vars(mesh)["build_entities"] = build_entities
    return mesh


def build_entities(
    t: Int[np.ndarray, "4 tet"], indices: Sequence[Sequence[int]], sort: bool = True
) -> tuple[Int[np.ndarray, "corner entity"], Int[np.ndarray, "own tet"]]:
    """Vertices of every edge or facet in ascending order, and those of each element, by its own.

    `indices` are the corners of an element's own edges or facets.
    """
    if len(indices[0]) > 3 or not sort or t.max() >> _BITS:
        return MeshTet.build_entities(t, indices, sort)  # pyright: ignore[reportReturnType]
    corners = np.sort(np.hstack([t[corner] for corner in indices]), axis=0)
    number = np.zeros(corners.shape[1], np.int64)
    for corner in corners:
        number = (number << _BITS) | corner
    entities, mapping = np.unique(number, return_inverse=True)
    shifts = _BITS * np.arange(len(corners))[::-1, None]
    vertices = (entities >> shifts) & ((1 << _BITS) - 1)
    return vertices.astype(corners.dtype), mapping.reshape(len(indices), t.shape[1])

"""Motion of the body's surface under presses, from the stored response alone: no further solve.

The compliance of the pressures at two vertices is ∫ φᵢ u·(−n) dA: over ∫ φᵢ dA it is how far the
surface moves inwards there, averaged over the vertex's hat. Motion along the surface is not known.
"""

from __future__ import annotations

import numpy as np
from jaxtyping import Float, Int
from scipy.spatial import KDTree

from design.errors import StoreError
from design.layout.body import face_frame
from design.processes import one_blas_thread
from design.spec.object import ObjectSpec
from fem.linear.response import ResponseOperator
from fem.mesh.surfaces import surface_tolerance_mm
from fem.presses.table import press_places, surface_weights_mm2


def inward_motion_mm(
    spec: ObjectSpec,
    response: ResponseOperator,
    face_index: int,
    xy_mm: Float[np.ndarray, "place 2"],
    depths_mm: Float[np.ndarray, "step"],
) -> Float[np.ndarray, "place step vertex"]:
    """Return how far the vertices of every face, one after the other, move inwards under presses of one.

    Right under the tip the surface shows up to some 5 % less depth than the tip has: an average over
    the mesh's hats cannot follow it further.
    """
    pressure = press_places(spec, response, face_index, xy_mm, depths_mm)
    surface = slice(0, response.magnet_loads.start)
    weights = np.concatenate([surface_weights_mm2(face) for face in response.surfaces])
    rows = np.asarray(response.compliance[surface, response.face_loads(face_index)])
    with one_blas_thread():
        moments = pressure.reshape(-1, pressure.shape[-1]) @ rows.T
    return (moments / weights).reshape(*pressure.shape[:2], -1)


def mesh_vertices(
    spec: ObjectSpec,
    response: ResponseOperator,
    points_mm: Float[np.ndarray, "point 3"],
) -> tuple[Int[np.ndarray, "vertex"], Float[np.ndarray, "vertex 3"]]:
    """Return which point of the mesh each vertex of the faces is, one face after the other, and the
    outward normal there.

    Raises
    ------
    StoreError
        The response belongs to another mesh.
    """
    tree, vertices, normals = KDTree(points_mm), [], []
    for surface in response.surfaces:
        frame = face_frame(spec, surface.number)
        vertices_mm = frame.centre_mm + surface.points_mm @ frame.axes.T
        distance, index = map(np.asarray, tree.query(vertices_mm))
        if distance.max() > surface_tolerance_mm(spec) or len(set(index)) < len(index):
            raise StoreError(
                f"the stored response of face {surface.number} belongs to another mesh. Delete the "
                "store's folders mesh and response, and run again"
            )
        vertices.append(index)
        normals.append(frame.axes_at(surface.xy_mm)[..., 2])
    return np.concatenate(vertices), np.concatenate(normals)

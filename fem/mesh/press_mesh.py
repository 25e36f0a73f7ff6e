"""A mesh that is fine where one press is, and coarse elsewhere."""

from __future__ import annotations

import numpy as np

from design.layout.positions import face_frame
from design.spec.object import ObjectSpec
from fem.mesh.tetrahedra import TetMesh, tetrahedralize

_FINE_WITHIN_RADII = 1.1
_COARSE_BEYOND_RADII = 3.0
_COARSE_EDGE_MM = 6.0


def tetrahedralize_for_press(spec: ObjectSpec, face: int, x_mm: float, y_mm: float) -> TetMesh:
    """Edges of `mesh.surface_edge_mm` around the tip, growing to 6 mm three radii away.

    A quarter of the unknowns of the mesh that serves all presses, with the same resolution of this
    one's contact.

    Raises
    ------
    InputError
        The mesher fails, or a magnet got no element.
    """
    frame = face_frame(spec, face)
    place = frame.to_object(np.array([x_mm, y_mm, 0.0]))
    radius = spec.indenter.radius_mm
    fine, coarse = spec.mesh.surface_edge_mm, max(_COARSE_EDGE_MM, spec.mesh.edge_mm)
    reach = np.array([_FINE_WITHIN_RADII, _COARSE_BEYOND_RADII]) * radius

    def edge_length(points_mm: np.ndarray) -> np.ndarray:
        distance = np.linalg.norm(points_mm - place, axis=1)
        return np.interp(distance, reach, [fine, coarse])

    return tetrahedralize(spec, edge_length)

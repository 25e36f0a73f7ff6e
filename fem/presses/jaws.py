"""Faces prepared for flat jaws: compliance of their cells, and what each does to the magnets."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from design.errors import InputError
from design.layout.body import face_frames
from design.spec.mechanics import IndenterSpec
from design.spec.object import ObjectSpec
from fem.contact.jaw import CELLS, JawFace, face_cells
from fem.contact.refined import joint_compliance, spread_cells
from fem.linear.response import ResponseOperator
from fem.presses.joint import refined_faces

_FINER = 2
"""Pieces along each side of a cell: by cells in one piece, motions were off by 2 % on some meshes."""


def coverable_faces(spec: ObjectSpec) -> list[int]:
    """Return the sensed faces that a flat jaw covers: flat rectangles."""
    return [frame.number for frame in face_frames(spec) if frame.flat and not frame.round]


def jaw_faces(
    spec: ObjectSpec, response: ResponseOperator, faces: Sequence[int] = ()
) -> tuple[JawFace, ...]:
    """Return what a rigid jaw needs of each of the faces, by default all.

    Raises
    ------
    InputError
        A curved face: a flat jaw covers none.
    """
    prepared = refined_faces(spec, response)
    rigid = spec.changed(indenter=IndenterSpec(kind="flat"))
    per_load, jaws = response.compliance[response.magnet_loads], []
    for face in faces or tuple(prepared):
        frame = prepared[face].frame
        if not frame.flat or frame.round:
            raise InputError(
                f"face {face} is no flat rectangle, and a jaw that covers it is not known. Score tips, "
                "or sense flat faces only (body.sensed_faces)"
            )
        half = np.asarray(frame.half_extents_mm, float)
        finer = face_cells(half, _FINER * CELLS)
        spread = spread_cells(prepared[face], finer, np.zeros(2))
        compliance = joint_compliance(response, [spread], rigid)
        columns = response.face_loads(spread.face.index).start + spread.rows
        motion = (per_load[:, columns] @ (spread.matrix / finer.area_mm2)).T
        # a, c cells along x, b, d those in them; i, k and j, l along y; m motions
        parts = (CELLS, _FINER, CELLS, _FINER)
        compliance = np.einsum("abijcdkl->aick", compliance.reshape(parts + parts))
        motion = np.einsum("abijm->aim", motion.reshape(*parts, -1)) / _FINER**2
        jaws.append(
            JawFace(face, half, compliance.reshape(CELLS**2, -1), motion.reshape(CELLS**2, -1, 6))
        )
    return tuple(jaws)

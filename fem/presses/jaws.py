"""Flat jaws that cover a whole face: force, centre of pressure and magnets' motions by depth and tilt.

A jaw's pressures scale with its pose: twice the depth and twice the tilt give twice the pressures. So
one table over tilt per depth holds every pose, at one contact problem for each tilt on the compliance
of the face's cells.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from design.errors import InputError
from design.layout.body import face_frames
from design.spec.mechanics import IndenterSpec
from design.spec.object import ObjectSpec
from fem.contact.complementarity import contact_pressures
from fem.linear.response import ResponseOperator
from fem.presses.joint import JointCells, Tip, centres_mm, joint_cells, refined_faces, spread_motion

_WIDER = 1.5
"""Edges of the jaw over those of the face: what hangs over presses nothing."""


@dataclass(frozen=True)
class JawFace:
    """A jaw over one face, and the face's half edges (mm)."""

    face: int
    half_mm: Float[np.ndarray, "2"]
    cells: JointCells
    response: ResponseOperator

    def press(
        self, lean: Float[np.ndarray, "2"]
    ) -> tuple[float, Float[np.ndarray, "2"], Float[np.ndarray, "magnet 6"]]:
        """Force (N), centre of pressure (mm) and motions per mm of depth at the face's middle.

        `lean` is the depth gained from the middle to the border at +x and at +y, over the depth at the
        middle: at −1 and 1 the jaw just leaves a border.
        """
        away, area = self.cells.away_mm, self.cells.area_mm2
        gap = -(away / self.half_mm) @ lean * area
        pressure = contact_pressures(self.cells.compliance, gap, area, np.ones(1))[0]
        bears = pressure * area
        (centre,) = centres_mm(bears, away, self.cells.tip, 1)
        motion = spread_motion(self.response, self.cells.spreads, pressure)
        return float(bears.sum()), centre, motion


def coverable_faces(spec: ObjectSpec) -> list[int]:
    """Return the sensed faces that a flat jaw covers: flat rectangles."""
    return [frame.number for frame in face_frames(spec) if frame.flat and not frame.round]


def jaw_faces(
    spec: ObjectSpec, response: ResponseOperator, faces: Sequence[int] = ()
) -> tuple[JawFace, ...]:
    """Return a rigid jaw over each of the faces, by default all.

    Raises
    ------
    InputError
        A curved face: a flat jaw covers none.
    """
    prepared = refined_faces(spec, response)
    jaws = []
    for face in faces or tuple(prepared):
        frame = prepared[face].frame
        if not frame.flat or frame.round:
            raise InputError(
                f"face {face} is no flat rectangle, and a jaw that covers it is not known. Score tips, "
                "or sense flat faces only (body.sensed_faces)"
            )
        half = np.asarray(frame.half_extents_mm, float)
        size = tuple((2 * _WIDER * half).tolist())
        flat = spec.changed(indenter=IndenterSpec(kind="cuboid", size_mm=size))
        cells = joint_cells(flat, response, [Tip(face, 0.0, 0.0)], np.zeros(1), prepared)
        jaws.append(JawFace(face, half, cells, response))
    return tuple(jaws)

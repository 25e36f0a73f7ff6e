"""Mounting of an object under a machine that presses straight down, and checks against its travel.

The machine's frame is its own after homing, Z upwards: a Grbl's runs from minus the travel to 0. The
pressed face lies up; its middle is at the mounting's X and Y, its x axis is turned from the machine's X by
an angle, counter-clockwise seen from above.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from design.errors import InputError
from design.layout.body import face_frame
from design.spec.object import ObjectSpec
from instobj.bench.rig.replies import Travel

LARGEST_TILT_DEG = 3.0
"""Largest lean of a face at its places on a machine that presses straight down."""
UNEVEN_MM = 0.3
"""Departure of touched points from a plane that is reported."""


@dataclass(frozen=True)
class Mounting:
    """Position of the middle of a face in the machine's frame (X, Y, Z at which the tip just touches it), and
    how the face is turned, seen from above."""

    middle_mm: tuple[float, float, float]
    turn_deg: float

    def machine_mm(self, xy_mm: Float[np.ndarray, "*n 2"]) -> Float[np.ndarray, "*n 2"]:
        """X and Y of places of the face."""
        turn = np.deg2rad(self.turn_deg)
        axes = np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]])
        return np.asarray(xy_mm, float) @ axes + np.asarray(self.middle_mm[:2])


@dataclass(frozen=True)
class Surface:
    """Height of the object in the machine's frame: of the specification's, `plane` higher.

    `plane` holds the height (mm) over the face's middle and its slopes along the face's x and y.
    """

    spec: ObjectSpec
    face: int
    plane: tuple[float, float, float]
    uneven_mm: float

    def height_mm(self, xy_mm: Float[np.ndarray, "*n 2"]) -> Float[np.ndarray, "*n"]:
        """Machine Z at which places of the face are first touched."""
        xy = np.asarray(xy_mm, float)
        return relief_mm(self.spec, self.face, xy) + self.plane[0] + xy @ np.array(self.plane[1:])


def touched_surface(
    spec: ObjectSpec,
    face: int,
    xy_mm: Float[np.ndarray, "touch 2"],
    height_mm: Float[np.ndarray, "touch"],
) -> Surface:
    """The plane through the heights at which places were touched (least squares).

    Raises
    ------
    InputError
        The heights leave a plane by more than 0.3 mm: another face, place or angle than stated.
    """
    columns = np.column_stack([np.ones(len(xy_mm)), xy_mm])
    above = height_mm - relief_mm(spec, face, xy_mm)
    plane, *_ = np.linalg.lstsq(columns, above, rcond=None)
    uneven = float(np.abs(above - columns @ plane).max())
    if uneven > UNEVEN_MM:
        raise InputError(
            f"heights of touch on face {face} leave a plane by {uneven:.2f} mm. Check that this face "
            "lies up, that --middle is right, and that the object cannot move"
        )
    z, along_x, along_y = plane.tolist()
    return Surface(spec, face, (z, along_x, along_y), uneven)


def touch_places(places_mm: Float[np.ndarray, "place 2"]) -> Float[np.ndarray, "touch 2"]:
    """Return where to touch off: the place nearest to the middle, and the farthest along four diagonals."""
    middle = int(np.linalg.norm(places_mm, axis=1).argmin())
    diagonals = np.array([[1, 1], [-1, 1], [-1, -1], [1, -1]])
    corners = (places_mm @ diagonals.T).argmax(axis=0).tolist()
    return places_mm[list(dict.fromkeys([middle, *corners]))]


def require_upright(spec: ObjectSpec, face: int, xy_mm: Float[np.ndarray, "place 2"]) -> None:
    """Refuse faces that a machine cannot press along their normal.

    Raises
    ------
    InputError
        The surface at a place leans by more than 3°.
    """
    frame = face_frame(spec, face)
    normals = frame.axes_at(frame.to_plane(xy_mm))[..., 2] @ frame.normal
    lean = np.rad2deg(np.arccos(np.clip(normals, -1, 1)))
    if lean.max() > LARGEST_TILT_DEG:
        raise InputError(
            f"face {face} leans by up to {lean.max():.0f}° at its places, and this machine presses "
            "straight down. Use --machine poses with a robot arm"
        )


def require_travel(travel: Travel, corners_mm: Sequence[tuple[str, float]]) -> None:
    """Check that coordinates (axis X, Y or Z; mm) lie within the machine's travel.

    Raises
    ------
    InputError
        A coordinate lies outside.
    """
    for axis, value in corners_mm:
        low, high = (ends["XYZ".index(axis)] for ends in (travel.low_mm, travel.high_mm))
        if not low <= value <= high:
            raise InputError(
                f"the plan reaches {axis} = {value:.1f} mm; the machine's travel is {low:g} to {high:g}. "
                "Mount the object elsewhere, or correct --middle"
            )


def safe_height_mm(top_mm: float, wanted_mm: float) -> float:
    """Machine Z for moves in the air: whole millimetres, and nowhere above that after homing."""
    return float(min(np.floor(top_mm), np.ceil(wanted_mm)))


def relief_mm(
    spec: ObjectSpec, face: int, xy_mm: Float[np.ndarray, "*n 2"]
) -> Float[np.ndarray, "*n"]:
    """Height of the surface over the plane that touches it in the face's middle."""
    frame = face_frame(spec, face)
    xy = frame.to_plane(xy_mm)
    flat = np.concatenate([xy, np.zeros((*xy.shape[:-1], 1))], axis=-1)
    return frame.plane_coordinates(frame.to_object(flat))[..., 2]

"""Pieces of an object as triangles in their places, and a picture of several seen from one side."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, cast

import numpy as np
from jaxtyping import Float, UInt8

from instobj.render.parts import PartView, camera_axes, depth_image, shade

if TYPE_CHECKING:
    from collections.abc import Sequence

    import trimesh

Direction = tuple[float, float, float]


@dataclass(frozen=True)
class Piece:
    """Triangles in their place in the view, their colour, and what is written next to them."""

    mesh: trimesh.Trimesh
    colour: tuple[float, float, float]
    label: str = ""


@dataclass(frozen=True)
class Picture:
    """Colours by pixel, left, right, lower and upper end in mm, and the camera's axes as rows."""

    rgb: UInt8[np.ndarray, "row column 3"]
    extent_mm: tuple[float, float, float, float]
    camera: Float[np.ndarray, "3 3"]


def moved(mesh: trimesh.Trimesh, by_mm: Float[np.ndarray, "3"]) -> trimesh.Trimesh:
    """A copy of the mesh elsewhere."""
    copy = mesh.copy()
    copy.apply_translation(by_mm)
    return copy


def picture_of(pieces: Sequence[Piece], towards_viewer: Direction, up: Direction) -> Picture:
    """All pieces, the nearer before the farther, edges as lines."""
    import trimesh

    whole = cast("trimesh.Trimesh", trimesh.util.concatenate([piece.mesh for piece in pieces]))
    colours = np.concatenate([np.tile(p.colour, (len(p.mesh.faces), 1)) for p in pieces])
    camera = camera_axes(towards_viewer, up)
    image = depth_image(np.asarray(whole.triangles) @ camera.T)
    view = PartView("all", "", towards_viewer, up, colours)
    return Picture(shade(image, whole, camera, view), image.extent_mm, camera)

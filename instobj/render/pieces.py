"""Pieces of an object as triangles in their places, and a picture of several seen from one side."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

import numpy as np
from jaxtyping import Bool, Float, UInt8

from design.errors import InputError
from instobj.render.raster import DepthImage, camera_axes, depth_image, shade

if TYPE_CHECKING:
    from collections.abc import Sequence

    import trimesh
    from matplotlib.axes import Axes

Direction = tuple[float, float, float]
Colour = tuple[float, float, float]
_ARROW = {"arrowstyle": "->", "shrinkA": 0, "shrinkB": 0}
CUT_COLOUR = (0.80, 0.36, 0.25)
POLES = (0.80, 0.16, 0.14), (0.16, 0.32, 0.72)
"""Colours of a magnet's north and south half."""
COLOURS = {
    "core": (0.55, 0.66, 0.78),
    "shell": (0.93, 0.84, 0.68),
    "mould_box": (0.66, 0.77, 0.62),
    "mould_half_a": (0.66, 0.77, 0.62),
    "mould_half_b": (0.58, 0.70, 0.56),
    "mould_plug": (0.76, 0.70, 0.84),
    "mould_holder": (0.76, 0.70, 0.84),
    "mould_seal_box": (0.56, 0.71, 0.76),
    "mould_seal_half_a": (0.56, 0.71, 0.76),
    "mould_seal_half_b": (0.49, 0.63, 0.69),
    "pin": (0.80, 0.45, 0.30),
    "board": (0.10, 0.45, 0.22),
    "jig": (0.70, 0.70, 0.70),
    "magnet_template": (0.85, 0.72, 0.60),
}
"""Colours of parts by their name, in every picture; pins and boards have several names."""


@dataclass(frozen=True)
class Piece:
    """Triangles in their place in the view, their colour (one, or one each), and the words next to them."""

    mesh: trimesh.Trimesh
    colour: Colour | Float[np.ndarray, "triangle 3"]
    label: str = ""

    def moved(self, by_mm: Float[np.ndarray, "3"]) -> Piece:
        """The same elsewhere."""
        copy = self.mesh.copy()
        copy.apply_translation(by_mm)
        return replace(self, mesh=copy)


@dataclass(frozen=True)
class Picture:
    """Colours by pixel, what each pixel shows, and the camera's axes as rows."""

    rgb: UInt8[np.ndarray, "row column 3"]
    image: DepthImage
    camera: Float[np.ndarray, "3 3"]

    @property
    def extent_mm(self) -> tuple[float, float, float, float]:
        """Left, right, lower and upper end."""
        return self.image.extent_mm

    def figure(self, width_inches: float, beside_inches: float = 0.0) -> tuple[Any, Axes]:
        """A figure of the picture alone, so wide, and its axes in mm; with room at its right."""
        from matplotlib.figure import Figure

        left, right, bottom, top = self.extent_mm
        height = width_inches * (top - bottom) / (right - left)
        figure = Figure(figsize=(width_inches + beside_inches, height), layout="constrained")
        axes = figure.subplots()
        self.show(axes)
        return figure, axes

    def show(self, axes: Axes) -> None:
        """Draw it into axes, in mm."""
        axes.imshow(self.rgb, extent=self.extent_mm, interpolation="antialiased")
        axes.set_axis_off()

    def add_axes_and_scale(self, axes: Axes) -> None:
        """Draw the object's axes and a 10 mm bar into the lower corners."""
        left, right, bottom, _ = self.extent_mm
        length = 0.065 * (right - left)
        x, y = left + 0.9 * length, bottom + 0.9 * length
        for name, (dx, dy) in zip("xyz", (length * self.camera[:2].T).tolist(), strict=True):
            axes.annotate("", (x + dx, y + dy), (x, y), arrowprops=_ARROW)
            axes.text(x + 1.3 * dx, y + 1.3 * dy, name, ha="center", va="center")
        end, height = right - 0.4 * length, bottom + 0.6 * length
        axes.plot([end - 10, end], [height, height], color="black", linewidth=2)
        axes.text(end - 5, height + 0.1 * length, "10 mm", ha="center", va="bottom")


def picture_of(pieces: Sequence[Piece], towards_viewer: Direction, up: Direction) -> Picture:
    """All pieces, the nearer before the farther, edges as lines."""
    import trimesh

    whole = cast("trimesh.Trimesh", trimesh.util.concatenate([piece.mesh for piece in pieces]))
    colours = [np.broadcast_to(piece.colour, (len(piece.mesh.faces), 3)) for piece in pieces]
    camera = camera_axes(towards_viewer, up)
    image = depth_image(np.asarray(whole.triangles) @ camera.T)
    normals = np.asarray(whole.face_normals) @ camera.T
    return Picture(shade(image, normals, np.concatenate(colours)), image, camera)


def load_stl(path: Path) -> trimesh.Trimesh:
    import trimesh

    if not path.is_file():
        raise InputError(f"no part at {path}. Build the object again")
    mesh = trimesh.load_mesh(path)
    if not isinstance(mesh, trimesh.Trimesh) or len(mesh.faces) == 0:
        raise InputError(f"{path} holds no triangles. Build the object again")
    return mesh


def cut_open(piece: Piece) -> Piece:
    """The piece without its quarter x > 0, y < 0; where it was cut it has a colour of its own."""
    mesh = without_quarter(piece.mesh)
    colours = np.tile(piece.colour, (len(mesh.faces), 1))
    colours[_is_on_cut(mesh)] = CUT_COLOUR
    return Piece(mesh, colours, piece.label)


def without_quarter(mesh: trimesh.Trimesh) -> trimesh.Trimesh:
    """The mesh without its quarter x > 0, y < 0."""
    import trimesh

    reach = 2 * float(np.abs(mesh.bounds).max())
    knife = trimesh.creation.box(bounds=[(0, -reach, -reach), (reach, 0, reach)])
    return trimesh.boolean.difference([mesh, knife], engine="manifold")


def _is_on_cut(mesh: trimesh.Trimesh) -> Bool[np.ndarray, "triangle"]:
    """Triangles on the planes x = 0 and y = 0 of the removed quarter."""
    x, y = np.abs(np.asarray(mesh.triangles)[..., :2]).max(axis=1).T
    return (x < 1e-4) | (y < 1e-4)

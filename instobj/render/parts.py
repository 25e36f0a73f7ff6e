"""Picture of the printed and cast parts: the STL files of a build, rendered by matplotlib alone.

matplotlib sorts the triangles of a 3-D plot by their centres, which tears flat faces of long
triangles. The parts are therefore projected here with a depth buffer and shown as images.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Bool, Float, Int, UInt8

from design.build.manifest import MANIFEST_NAME, BuildManifest, PartManifest
from design.errors import InputError
from instobj.figures.saving import save_figure

if TYPE_CHECKING:
    import trimesh
    from matplotlib.axes import Axes

PIXELS = 1100
EDGE_ANGLE_DEG = 25.0
DEPTH_STEP_MM = 0.4
STEEPEST_PIXELS = 5.0
"""Surfaces that fall by fewer pixels in one are drawn without lines."""
_LINE_GREY = 0.12
_ARROW = {"arrowstyle": "->", "shrinkA": 0, "shrinkB": 0}
CUT_COLOUR = (0.80, 0.36, 0.25)
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
}
"""Colours of parts by their name, in every picture; pins and boards have several names."""


@dataclass(frozen=True)
class PartView:
    """View of one part: direction towards the viewer, object axis drawn upwards, colour.

    The colour is one, or one a triangle.
    """

    part: str
    title: str
    towards_viewer: tuple[float, float, float]
    up: tuple[float, float, float]
    colour: tuple[float, float, float] | Float[np.ndarray, "triangle 3"]
    cut_open: bool = False


VIEWS = {
    view.part: view
    for view in (
        PartView("core", "Core, from +x, −y and +z", (1, -1.25, 1), (0, 0, 1), COLOURS["core"]),
        PartView("shell", "Shell, cut open", (1, -1.25, 0.9), (0, 0, 1), COLOURS["shell"], True),
        PartView(
            "mould_box",
            "Mould box, open side up",
            (0.7, -1, -1.6),
            (0, 0, -1),
            COLOURS["mould_box"],
        ),
        PartView(
            "mould_half_a",
            "Mould half, from its seam",
            (-1, -0.8, 0.7),
            (0, 0, 1),
            COLOURS["mould_half_a"],
        ),
        PartView("mould_plug", "Mould plug", (1.2, -0.9, 0.7), (0, 0, 1), COLOURS["mould_plug"]),
        PartView(
            "mould_holder", "Rod for the core", (1.2, -0.9, 0.7), (0, 0, 1), COLOURS["mould_holder"]
        ),
        PartView("jig", "Jig", (0.7, -1, 1), (0, 0, 1), (0.70, 0.70, 0.70)),
        PartView(
            "magnet_template", "Magnet template", (0.5, -0.9, 1.6), (0, 0, 1), (0.85, 0.72, 0.60)
        ),
    )
}
"""Parts in the order shown, where the build has them."""


@dataclass(frozen=True)
class DepthImage:
    """Content of each pixel: the triangle nearest to the viewer (−1: none), and its depth in mm."""

    triangle: Int[np.ndarray, "row column"]
    depth_mm: Float[np.ndarray, "row column"]
    extent_mm: tuple[float, float, float, float]


def draw_parts(folder: Path | str, png_path: Path | str) -> Path:
    """Draw core, shell (cut open), mould, jig and template of a build into one PNG.

    Parameters
    ----------
    folder
        The folder that `design.build.export.build_object` wrote, or the manifest.json in it.
    png_path
        The picture to write.

    Raises
    ------
    InputError
        The folder holds no manifest or lacks a part's STL, or the picture cannot be written.
    """
    from matplotlib.figure import Figure

    folder = Path(folder)
    folder = folder.parent if folder.name == MANIFEST_NAME else folder
    manifest = BuildManifest.read(folder)
    figure = Figure(figsize=(15.5, 11.4), layout="constrained")
    figure.suptitle(f"Parts of {manifest.name}", fontsize=15)
    shown = {part.name for part in manifest.parts}
    views = [view for name, view in VIEWS.items() if name in shown]
    places = figure.subplots(2, 3).ravel()
    for axes in places:
        axes.set_axis_off()
    for axes, view in zip(places, views, strict=False):
        _draw_view(axes, view, load_stl(folder / f"{view.part}.stl"), manifest.part(view.part))
    target = Path(png_path)
    save_figure(figure, target)
    return target


def load_stl(path: Path) -> trimesh.Trimesh:
    import trimesh

    if not path.is_file():
        raise InputError(f"no part at {path}. Build the object again")
    mesh = trimesh.load_mesh(path)
    if not isinstance(mesh, trimesh.Trimesh) or len(mesh.faces) == 0:
        raise InputError(f"{path} holds no triangles. Build the object again")
    return mesh


def _draw_view(axes: Axes, view: PartView, mesh: trimesh.Trimesh, part: PartManifest) -> None:
    if view.cut_open:
        mesh = without_quarter(mesh)
    camera = camera_axes(view.towards_viewer, view.up)
    image = depth_image(np.asarray(mesh.triangles) @ camera.T)
    axes.imshow(
        shade(image, mesh, camera, view), extent=image.extent_mm, interpolation="antialiased"
    )
    size = " × ".join(f"{edge:.4g}" for edge in part.size_mm)
    axes.set_title(
        f"{view.title}\n{size} mm, {part.volume_mm3 / 1000:.2f} cm³",
        fontsize=12,
        y=1.0,  # given, it is not looked for among ticks that do not show
    )
    axes.set_axis_off()
    draw_axes_and_scale(axes, camera, image.extent_mm)


def without_quarter(mesh: trimesh.Trimesh) -> trimesh.Trimesh:
    """The mesh without its quarter x > 0, y < 0."""
    import trimesh

    reach = 2 * float(np.abs(mesh.bounds).max())
    knife = trimesh.creation.box(bounds=[(0, -reach, -reach), (reach, 0, reach)])
    return trimesh.boolean.difference([mesh, knife], engine="manifold")


def camera_axes(
    towards_viewer: tuple[float, float, float], up: tuple[float, float, float]
) -> Float[np.ndarray, "3 3"]:
    """Rows: the picture's right, its up, and the direction towards the viewer (orthonormal)."""
    towards = np.asarray(towards_viewer, float) / np.linalg.norm(towards_viewer)
    right = np.cross(up, towards)
    right /= np.linalg.norm(right)
    return np.stack([right, np.cross(towards, right), towards])


def depth_image(triangles_mm: Float[np.ndarray, "triangle 3 3"]) -> DepthImage:
    """Orthographic depth buffer of triangles given as (right, up, towards the viewer), mm."""
    low, high = triangles_mm.min(axis=(0, 1)), triangles_mm.max(axis=(0, 1))
    margin = 0.08 * float((high - low)[:2].max())
    step = (float((high - low)[:2].max()) + 2 * margin) / PIXELS
    columns, rows = (int(n) for n in np.ceil((high - low)[:2] / step + 2 * margin / step))
    origin = low[:2] - margin
    nearest = np.full((rows, columns), -np.inf)
    index = np.full((rows, columns), -1)
    _draw_triangles(triangles_mm, origin, step, nearest, index)
    right, top = origin + step * np.array([columns, rows])
    extent = (float(origin[0]), float(right), float(origin[1]), float(top))
    return DepthImage(index[::-1], nearest[::-1], extent)


def _draw_triangles(
    triangles_mm: Float[np.ndarray, "triangle 3 3"],
    origin: Float[np.ndarray, "2"],
    step: float,
    nearest: Float[np.ndarray, "row column"],
    index: Int[np.ndarray, "row column"],
) -> None:
    """Enter triangles that face the viewer into the buffers in place, where each is the nearest."""
    edges = triangles_mm[:, 1:] - triangles_mm[:, :1]
    (front,) = np.nonzero(np.linalg.det(edges[..., :2]) > 1e-12)
    inverse, rise = np.linalg.inv(edges[front, :, :2]), edges[front, :, 2]
    pixel = (triangles_mm[front, :, :2] - origin) / step
    first = np.maximum(np.floor(pixel.min(axis=1) - 0.5), 0).astype(int)
    last = np.ceil(pixel.max(axis=1) + 0.5).astype(int)
    for k, number in enumerate(front.tolist()):
        window = np.s_[first[k, 1] : last[k, 1], first[k, 0] : last[k, 0]]
        x0, y0, z0 = triangles_mm[number, 0]
        x = origin[0] + step * (np.arange(first[k, 0], last[k, 0]) + 0.5) - x0
        y = origin[1] + step * (np.arange(first[k, 1], last[k, 1])[:, None] + 0.5) - y0
        (xa, xb), (ya, yb) = inverse[k]
        a, b = x * xa + y * ya, x * xb + y * yb
        depth = z0 + a * rise[k, 0] + b * rise[k, 1]
        inside = (a >= -1e-9) & (b >= -1e-9) & (a + b <= 1 + 1e-9)
        wins = inside & (depth > nearest[window])
        nearest[window][wins] = depth[wins]
        index[window][wins] = number


def shade(
    image: DepthImage, mesh: trimesh.Trimesh, camera: Float[np.ndarray, "3 3"], view: PartView
) -> UInt8[np.ndarray, "row column 3"]:
    """Diffuse light from above left of the viewer, dark lines where the surface turns or steps.

    In whole numbers to 255: Matplotlib scales these in a third of the time.
    """
    normals = np.asarray(mesh.face_normals) @ camera.T
    light = np.array([-0.45, 0.65, 0.62])
    brightness = 0.45 + 0.55 * np.clip(normals @ (light / np.linalg.norm(light)), 0, 1)
    colours = np.broadcast_to(view.colour, (len(normals), 3)).copy()
    if view.cut_open:
        colours[_is_on_cut(mesh)] = CUT_COLOUR
    palette = np.vstack([colours * brightness[:, None], np.full(3, _LINE_GREY), np.ones(3)])
    line = len(palette) - 2  # the last one, at −1, is for pixels without a triangle
    shown = np.where(_edges(image, normals), line, image.triangle)
    return np.rint(255 * palette).astype(np.uint8)[shown]


def _is_on_cut(mesh: trimesh.Trimesh) -> Bool[np.ndarray, "triangle"]:
    """Triangles on the planes x = 0 and y = 0 of the removed quarter."""
    x, y = np.abs(np.asarray(mesh.triangles)[..., :2]).max(axis=1).T
    return (x < 1e-4) | (y < 1e-4)


def _edges(
    image: DepthImage, normals: Float[np.ndarray, "triangle 3"]
) -> Bool[np.ndarray, "row column"]:
    marked = np.zeros_like(image.triangle, bool)
    pixel = (image.extent_mm[1] - image.extent_mm[0]) / len(marked[0])
    step = max(DEPTH_STEP_MM, STEEPEST_PIXELS * pixel)
    for axis in (0, 1):
        triangle, depth, mark = (
            np.moveaxis(given, axis, 0) for given in (image.triangle, image.depth_mm, marked)
        )
        border = np.abs(np.diff(np.where(triangle < 0, -1e6, depth), axis=0)) > step
        meet = np.nonzero(triangle[:-1] != triangle[1:])
        near, far = (normals[side[meet]] for side in (triangle[:-1], triangle[1:]))
        border[meet] |= (near * far).sum(axis=-1) < np.cos(np.deg2rad(EDGE_ANGLE_DEG))
        mark[:-1] |= border
        mark[1:] |= border
    background = image.triangle < 0
    return marked & ~background


def draw_axes_and_scale(
    axes: Axes,
    camera: Float[np.ndarray, "3 3"],
    extent: tuple[float, float, float, float],
) -> None:
    """Object axes and a 10 mm bar in the lower corners of the picture."""
    left, right, bottom, _ = extent
    length = 0.065 * (right - left)
    x, y = left + 0.9 * length, bottom + 0.9 * length
    for name, (dx, dy) in zip("xyz", (length * camera[:2].T).tolist(), strict=True):
        axes.annotate("", (x + dx, y + dy), (x, y), arrowprops=_ARROW)
        axes.text(x + 1.3 * dx, y + 1.3 * dy, name, ha="center", va="center")
    end, height = right - 0.4 * length, bottom + 0.6 * length
    axes.plot([end - 10, end], [height, height], color="black", linewidth=2)
    axes.text(end - 5, height + 0.1 * length, "10 mm", ha="center", va="bottom")

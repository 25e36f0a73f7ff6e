"""Depth buffer: triangles projected to pixels, shaded, with dark lines where the surface turns or steps.

matplotlib sorts the triangles of a 3-D plot by their centres, which tears flat faces of long
triangles. Solids are therefore projected here and shown as images.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float, Int, UInt8

PIXELS = 1100
EDGE_ANGLE_DEG = 25.0
DEPTH_STEP_MM = 0.4
STEEPEST_PIXELS = 5.0
"""Surfaces that fall by fewer pixels in one are drawn without lines."""
_LINE_GREY = 0.12


@dataclass(frozen=True)
class DepthImage:
    """Content of each pixel: the triangle nearest to the viewer (−1: none), and its depth in mm."""

    triangle: Int[np.ndarray, "row column"]
    depth_mm: Float[np.ndarray, "row column"]
    extent_mm: tuple[float, float, float, float]


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
    image: DepthImage,
    normals: Float[np.ndarray, "triangle 3"],
    colours: Float[np.ndarray, "triangle 3"],
) -> UInt8[np.ndarray, "row column 3"]:
    """Diffuse light from above left of the viewer, dark lines where the surface turns or steps.

    `normals` are those of the triangles in the camera's axes. In whole numbers to 255: Matplotlib
    scales these in a third of the time.
    """
    light = np.array([-0.45, 0.65, 0.62])
    brightness = 0.45 + 0.55 * np.clip(normals @ (light / np.linalg.norm(light)), 0, 1)
    palette = np.vstack([colours * brightness[:, None], np.full(3, _LINE_GREY), np.ones(3)])
    line = len(palette) - 2  # the last one, at −1, is for pixels without a triangle
    shown = np.where(_edges(image, normals), line, image.triangle)
    return np.rint(255 * palette).astype(np.uint8)[shown]


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

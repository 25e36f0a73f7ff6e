"""Contacts as heatmaps on a face's contact grid, and the labels of the public recordings.

A heatmap holds the normal force (N) at each contact's pixel and zero elsewhere; its first axis
is the face's x, its second the face's y. Label p = 1…100 of the recordings runs in a snake:
X = (p − 1) // 10, Y = (p − 1) % 10, with Y reversed where X is odd (Knopke et al., RA-L 2024).
"""

from __future__ import annotations

import numpy as np
from jaxtyping import Float, Int

from design.errors import InputError
from estimator.frames.dataset import NO_FACE, FrameSet

LABEL_GRID = (10, 10)
LABEL_PITCH_MM = 3.0
"""Distance of the labels' places."""
NO_CONTACT_LABELS = (0, 101)


def label_grid_mm() -> tuple[Float[np.ndarray, "10"], Float[np.ndarray, "10"]]:
    """Pixel centres (mm) along x and y of the recordings' 10 × 10 grid, centred on the face."""
    nx, ny = LABEL_GRID
    return (np.arange(nx) - (nx - 1) / 2) * LABEL_PITCH_MM, (
        np.arange(ny) - (ny - 1) / 2
    ) * LABEL_PITCH_MM


def label_to_pixel(label: Int[np.ndarray, "*n"]) -> Int[np.ndarray, "*n 2"]:
    """Pixel (X, Y), counted from 0, of snake labels 1…100.

    Raises
    ------
    InputError
        A label outside 1…100; 0 and 101 mean no contact and have no pixel.
    """
    nx, ny = LABEL_GRID
    label = np.asarray(label)
    outside = (label < 1) | (label > nx * ny)
    if np.any(outside):
        raise InputError(
            f"position labels must lie in 1…{nx * ny} (0 and 101 mean no contact); got "
            f"{np.unique(label[outside]).tolist()}. Correct the label column"
        )
    x, y = np.divmod(label - 1, ny)
    return np.stack([x, np.where(x % 2 == 1, ny - 1 - y, y)], axis=-1)


def pixel_to_mm(
    pixel: Int[np.ndarray, "*n 2"],
    grid_x_mm: Float[np.ndarray, "nx"],
    grid_y_mm: Float[np.ndarray, "ny"],
) -> Float[np.ndarray, "*n 2"]:
    """Centres (mm) of pixels (X, Y)."""
    return np.stack([grid_x_mm[pixel[..., 0]], grid_y_mm[pixel[..., 1]]], axis=-1)


def mm_to_pixel(
    xy_mm: Float[np.ndarray, "*n 2"],
    grid_x_mm: Float[np.ndarray, "nx"],
    grid_y_mm: Float[np.ndarray, "ny"],
) -> Int[np.ndarray, "*n 2"]:
    """Nearest pixel (X, Y) of points in mm; beyond the grid the nearest border pixel."""
    columns = [_nearest(xy_mm[..., k], grid) for k, grid in enumerate((grid_x_mm, grid_y_mm))]
    return np.stack(columns, axis=-1)


def _nearest(value: Float[np.ndarray, "*n"], grid: Float[np.ndarray, "g"]) -> Int[np.ndarray, "*n"]:
    boundaries = (grid[1:] + grid[:-1]) / 2
    return np.searchsorted(boundaries, value, side="left")


def force_heatmaps(frames: FrameSet, face: int) -> Float[np.ndarray, "frame 3 nx ny"]:
    """True force (N, along the face's x, y and inward normal) of one face's contacts at their
    nearest pixels.

    Contacts that share a pixel add up; contacts of other faces do not show.
    """
    shape = (len(frames), 3, len(frames.grid_x_mm), len(frames.grid_y_mm))
    heatmaps = np.zeros(shape)
    row, slot = np.nonzero(frames.contact_face == face)
    pixel = mm_to_pixel(frames.contact_xy_mm[row, slot], frames.grid_x_mm, frames.grid_y_mm)
    for axis in range(3):
        force_n = frames.force_n[row, slot, axis]
        np.add.at(heatmaps[:, axis], (row, pixel[:, 0], pixel[:, 1]), force_n)
    return heatmaps


def faces_pressed(frames: FrameSet) -> tuple[int, ...]:
    """Faces that carry a contact in some valid frame, in increasing order."""
    pressed = np.unique(frames.contact_face[frames.valid])
    return tuple(int(face) for face in pressed if face != NO_FACE)

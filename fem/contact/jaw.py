"""Rigid flat jaws over a flat face or a part of it: force, centre of pressure and magnets' motions.

A jaw's pressures scale with its pose: twice the depth and twice the tilt give twice the pressures. So one
contact problem, on the compliance of the face's cells, holds all depths.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from jaxtyping import Float, Int

from fem.contact.complementarity import Contact, contact, solve_positive
from fem.contact.half_space import Patches

CELLS = 20
"""Cells along each side of a face: edges of 2.1 mm on the paper's cube change force by 0.4 %."""
_LEAST_SHARE = 1e-3
"""Share of a cell that a jaw must cover for the cell to bear."""


@dataclass(frozen=True, eq=False)
class JawFace:
    """One face as a jaw needs it.

    Attributes
    ----------
    face : its number
    half_mm : half edges of the face
    compliance : (cell, cell) ∫ u_n dA over each cell per unit pressure on each, mm³/MPa
    motion : (cell, magnet, 6) motions of the magnets, mm and rad per N on each cell
    """

    face: int
    half_mm: Float[np.ndarray, "2"]
    compliance: Float[np.ndarray, "cell cell"]
    motion: Float[np.ndarray, "cell magnet 6"]

    @property
    def whole_mm(self) -> Float[np.ndarray, "axis end"]:
        """Return low and high edge of the face along x and y."""
        return self.half_mm[:, None] * [-1.0, 1.0]

    def press(
        self, lean: Float[np.ndarray, "2"], edges_mm: Float[np.ndarray, "axis end"] | None = None
    ) -> tuple[float, Float[np.ndarray, "2"], Float[np.ndarray, "magnet 6"]]:
        """Force (N), centre of pressure (mm) and motions per mm of depth at the middle of the part covered.

        `edges_mm` of the jaw end at the face's at most; None covers the face. `lean` is the depth gained
        from the middle to the edge at +x and at +y, over the depth at the middle: at −1 and 1 the jaw just
        leaves an edge.
        """
        edges = self.whole_mm if edges_mm is None else edges_mm
        part = _part(self, *edges.ravel().tolist())
        depth = np.array([1.0, *lean])
        pressure = part.pressure @ depth
        if (pressure < 0).any():  # the jaw leaves a part of what it covers
            still = -part.moments @ [0.0, *lean]
            near, area = Contact(part.latest[None], part.latest[None]), part.moments[:, 0]
            pressure = contact(part.compliance, still, area, np.ones(1), near).pressure_mpa[0]
            part.latest[:] = pressure
        bears = pressure * part.moments[:, 0]
        force = float(bears.sum())
        motion = np.tensordot(bears, self.motion[part.cells], 1)
        return force, bears @ part.centre_mm / force, motion


class _Part(NamedTuple):
    """A part of a face under a jaw: its cells with their centres and compliance, and (cell, 3) of a unit of
    depth at the middle and of depths gained towards +x and +y: its moments ∫ depth dA over the cells, and the
    pressures where all cells stay in contact. `latest` are those of the press before, where the next begins.
    """

    cells: Int[np.ndarray, "cell"]
    centre_mm: Float[np.ndarray, "cell 2"]
    compliance: Float[np.ndarray, "cell cell"]
    moments: Float[np.ndarray, "cell 3"]
    pressure: Float[np.ndarray, "cell 3"]
    latest: Float[np.ndarray, "cell"]


@lru_cache(maxsize=16)
def _part(jaw: JawFace, x_low: float, x_high: float, y_low: float, y_high: float) -> _Part:
    """The part between four edges (mm); slopes of a fit ask for one part again and again."""
    edges = np.array([[x_low, x_high], [y_low, y_high]])
    (x, x_width), (y, y_width) = map(_covered_mm, jaw.half_mm, edges)
    area = np.multiply.outer(x_width, y_width).ravel()
    share = area / (4 * jaw.half_mm.prod() / CELLS**2)
    (used,) = np.nonzero(share > _LEAST_SHARE)
    area, share = area[used], share[used]
    centre = np.stack(np.meshgrid(x, y, indexing="ij"), axis=-1).reshape(-1, 2)[used]
    compliance = jaw.compliance.take(used, axis=0).take(used, axis=1)
    # a cell that is covered in part bears as much less than a whole one at the same depth
    diagonal = share * compliance.diagonal()
    compliance = compliance * np.multiply.outer(share, share)
    np.fill_diagonal(compliance, diagonal)
    away = (centre - edges.mean(axis=1)) / (np.diff(edges)[:, 0] / 2)
    moments = np.column_stack([area, away * area[:, None]])
    pressure = solve_positive(compliance.copy(), moments)
    return _Part(used, centre, compliance, moments, pressure, pressure[:, 0].copy())


def face_cells(half_mm: Float[np.ndarray, "2"], count: int) -> Patches:
    """Return `count` cells along each side of a face; `CELLS` of them are those of `JawFace`."""
    (x, width), (y, height) = (
        _covered_mm(half, half * np.array([-1.0, 1.0]), count) for half in half_mm
    )
    centre = np.stack(np.meshgrid(x, y, indexing="ij"), axis=-1).reshape(-1, 2)
    # variance of a rectangle along one axis, in the mean: (a² + b²)/24
    variance = np.add.outer(width**2, height**2).ravel() / 24
    return Patches(np.multiply.outer(width, height).ravel(), centre, variance)


def _covered_mm(
    half_mm: float, ends_mm: Float[np.ndarray, "end"], count: int = CELLS
) -> tuple[Float[np.ndarray, "cell"], Float[np.ndarray, "cell"]]:
    """Middles and widths of what lies between two ends of each cell along one side."""
    lines = np.linspace(-half_mm, half_mm, count + 1)
    low, high = np.maximum(lines[:-1], ends_mm[0]), np.minimum(lines[1:], ends_mm[1])
    return (low + high) / 2, np.clip(high - low, 0, None)

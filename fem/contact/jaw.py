"""Rigid flat jaws over a flat face or a part of it: force, centre of pressure and magnets' motions.

A jaw's pressures scale with its pose: twice the depth and twice the tilt give twice the pressures. So one
contact problem, on the compliance of the face's cells, holds all depths.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
from jaxtyping import Bool, Float, Int

from fem.contact.complementarity import MAX_SWITCHES, contact, solve_positive
from fem.contact.half_space import Patches

CELLS = 20
"""Cells along each side of a face: edges of 2.1 mm on the paper's cube change force by 0.4 %."""
_LEAST_SHARE = 1e-3
"""Share of a cell that a jaw must cover for the cell to bear."""
_ROUNDING = 1e-10
"""Share of the largest gap that is rounding."""


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
        pressure = self._pressure(part, np.array([1.0, *lean]))
        bears = pressure * part.moments[:, 0]
        force = float(bears.sum())
        motion = np.tensordot(bears, self.motion[part.cells], 1)
        return force, bears @ part.centre_mm / force, motion

    def _pressure(self, part: _Part, depth: Float[np.ndarray, "3"]) -> Float[np.ndarray, "cell"]:
        """Pressures on the cells of a part; the cells that bear are sought from those of the press before."""
        gap = -part.moments @ depth
        rounding = _ROUNDING * abs(gap).max()
        bears = self._bears[part.cells]
        for _ in range(MAX_SWITCHES):
            pressure = part.pressures(bears) @ depth
            switched = np.where(bears, pressure > 0, part.compliance @ pressure + gap < -rounding)
            if (switched == bears).all():
                break
            bears = switched
        else:  # a set that cycles
            (pressure,) = contact(
                part.compliance, gap, part.moments[:, 0], np.zeros(1)
            ).pressure_mpa
        self._bears[part.cells] = pressure > 0
        return pressure

    @cached_property
    def _bears(self) -> Bool[np.ndarray, "cell"]:
        """Cells that bore in the press before, all of them at first: where the next begins.

        This changes how soon the cells that bear are known, not which; frames of jaws take a fifth less time.
        """
        return np.ones(len(self.compliance), bool)


@dataclass(frozen=True, eq=False)
class _Part:
    """A part of a face under a jaw.

    Attributes
    ----------
    cells, centre_mm, compliance : of its cells
    moments : (cell, 3) ∫ depth dA over the cells, of a unit of depth at the middle and of depths gained
        towards +x and +y
    """

    cells: Int[np.ndarray, "cell"]
    centre_mm: Float[np.ndarray, "cell 2"]
    compliance: Float[np.ndarray, "cell cell"]
    moments: Float[np.ndarray, "cell 3"]

    def pressures(self, bears: Bool[np.ndarray, "cell"]) -> Float[np.ndarray, "cell 3"]:
        """Pressures of each of the three depths where some cells bear: kept, as leans ask for them again."""
        key = bears.tobytes()
        if key not in self._solved:
            pressures = np.zeros(self.moments.shape)
            (index,) = np.nonzero(bears)
            if len(index):
                block = self.compliance.take(index, axis=0).take(index, axis=1)
                pressures[index] = solve_positive(block, self.moments[index])
            self._solved[key] = pressures
        return self._solved[key]

    @cached_property
    def _solved(self) -> dict[bytes, Float[np.ndarray, "cell 3"]]:
        return {}


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
    return _Part(used, centre, compliance, moments)


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

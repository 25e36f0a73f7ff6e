"""Rigid flat jaws over a flat face or a part of it: force, centre of pressure and magnets' motions.

A jaw's pressures scale with its pose: twice the depth and twice the tilt give twice the pressures. So one
contact problem, on the compliance of the face's cells, holds all depths.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
from jaxtyping import Bool, Float, Int

from fem.contact.complementarity import MAX_SWITCHES, contact, solve_factored, solve_positive
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
        part = self._part(edges_mm)
        bears = self._forces(part, np.array([1.0, *lean]))
        force = float(bears.sum())
        motion = np.tensordot(part.spread_over_face(bears), self.motion, 1)
        return force, bears @ part.centre_mm / force, motion

    def motion_with_slopes(
        self, lean: Float[np.ndarray, "2"], edges_mm: Float[np.ndarray, "axis end"]
    ) -> tuple[Float[np.ndarray, "magnet 6"], Float[np.ndarray, "shape magnet 6"]]:
        """Motions per newton, and their derivatives by both leans and by the edges, low and high along x,
        then along y (per mm)."""
        part = self._part(edges_mm)
        bears = self._forces(part, np.array([1.0, *lean]))
        slopes = np.column_stack([part.forces(bears > 0)[:, 1:], part.slopes_by_edges(bears, lean)])
        # V = Σ b m / Σ b of forces b and motions m per newton, so V' = (Σ b' m − V Σ b') / Σ b
        rows = np.column_stack([bears, slopes]).T
        motion, force = np.tensordot(part.spread_over_face(rows), self.motion, 1), rows.sum(axis=1)
        per_newton = motion[0] / force[0]
        return per_newton, (motion[1:] - force[1:, None, None] * per_newton) / force[0]

    def _part(self, edges_mm: Float[np.ndarray, "axis end"] | None) -> _Part:
        edges = self.whole_mm if edges_mm is None else edges_mm
        return _part(self, *edges.ravel().tolist())

    def _forces(self, part: _Part, depth: Float[np.ndarray, "3"]) -> Float[np.ndarray, "cell"]:
        """Forces on the cells of a part; the cells that bear are sought from those of the press before."""
        gap = -part.depths @ depth
        rounding = _ROUNDING * abs(gap).max()
        bears = self._bears[part.cells]
        for _ in range(MAX_SWITCHES):
            force = part.forces(bears) @ depth
            switched = force > 0
            if not bears.all():
                switched = np.where(bears, switched, part.sunk_mm(force) + gap < -rounding)
            if (switched == bears).all():
                break
            bears = switched
        else:  # a set that cycles
            block = part.block(np.arange(len(gap)))
            (force,) = contact(block, gap, np.ones(len(gap)), np.zeros(1)).pressure_mpa
        self._bears[part.cells] = force > 0
        return force

    @cached_property
    def _bears(self) -> Bool[np.ndarray, "cell"]:
        """Cells that bore in the press before, all of them at first: where the next begins.

        This changes how soon the cells that bear are known, not which; frames of jaws take a fifth less time.
        """
        return np.ones(len(self.compliance), bool)

    @cached_property
    def mm_per_newton(self) -> Float[np.ndarray, "cell cell"]:
        """Return the mean depth of each cell per newton on each."""
        return self.compliance / (4 * self.half_mm.prod() / CELLS**2) ** 2


@dataclass(frozen=True, eq=False)
class _Part:
    """A part of a face under a jaw.

    Attributes
    ----------
    jaw, edges_mm : the face, and low and high edge of the part along x and y
    cells, centre_mm, size_mm : of what is covered of its cells
    share : of each cell that is covered
    """

    jaw: JawFace
    edges_mm: Float[np.ndarray, "axis end"]
    cells: Int[np.ndarray, "cell"]
    centre_mm: Float[np.ndarray, "cell 2"]
    size_mm: Float[np.ndarray, "cell 2"]
    share: Float[np.ndarray, "cell"]

    @cached_property
    def depths(self) -> Float[np.ndarray, "cell 3"]:
        """Depths at the cells, of a unit at the middle and of depths gained towards +x and +y."""
        away = (self.centre_mm - self.edges_mm.mean(axis=1)) / self._half_mm
        return np.column_stack([np.ones(len(away)), away])

    @property
    def _half_mm(self) -> Float[np.ndarray, "2"]:
        return np.diff(self.edges_mm)[:, 0] / 2

    @cached_property
    def _self_compliance(self) -> Float[np.ndarray, "cell"]:
        return self.jaw.mm_per_newton.diagonal()[self.cells]

    @cached_property
    def _softer_mm_per_newton(self) -> Float[np.ndarray, "cell"]:
        """Return how much deeper each cell sinks per newton on itself where it is covered in part."""
        # a cell that is covered in part bears as much less than a whole one at the same depth
        return self._self_compliance * (1 / self.share - 1)

    def block(self, chosen: Int[np.ndarray, "chosen"]) -> Float[np.ndarray, "chosen chosen"]:
        """Return depths per newton of some of the cells."""
        index = self.cells[chosen]
        block = self.jaw.mm_per_newton.take(index, axis=0).take(index, axis=1)
        block[range(len(index)), range(len(index))] += self._softer_mm_per_newton[chosen]
        return block

    def sunk_mm(self, force: Float[np.ndarray, "cell"]) -> Float[np.ndarray, "cell"]:
        """Return the depths of all cells under forces on them."""
        sunk = self.jaw.mm_per_newton @ self.spread_over_face(force)
        return sunk[self.cells] + self._softer_mm_per_newton * force

    def spread_over_face(
        self, rows: Float[np.ndarray, "*row cell"]
    ) -> Float[np.ndarray, "*row all_cells"]:
        """Return values of the part's cells on all cells of the face, 0 elsewhere."""
        # cheaper than to take matrices apart
        spread = np.zeros((*rows.shape[:-1], len(self.jaw.motion)))
        spread[..., self.cells] = rows
        return spread

    def forces(self, bears: Bool[np.ndarray, "cell"]) -> Float[np.ndarray, "cell 3"]:
        """Forces of each of the three depths where some cells bear."""
        return _solved(self, bears.tobytes())[0]

    def slopes_by_edges(
        self, force: Float[np.ndarray, "cell"], lean: Float[np.ndarray, "2"]
    ) -> Float[np.ndarray, "cell edge"]:
        """Return the derivatives of the cells' forces by the four edges, where the same cells bear."""
        bears = force > 0
        sides, away = [], self.depths[:, 1:]
        for axis, end in ((0, 0), (0, 1), (1, 0), (1, 1)):
            out, half = 2 * end - 1, self._half_mm[axis]
            border = self.centre_mm[:, axis] + out * self.size_mm[:, axis] / 2
            strip = abs(border - self.edges_mm[axis, end]) < _ROUNDING * half
            # (c + diag(own (1/share − 1))) force = depth, by the edge: `away` changes with the part's middle
            # and half; of cells that the edge cuts the middle moves half as far, share grows by its 1/size
            moved = ((strip - 1) / 2 - out * away[:, axis] / 2) / half
            grown = np.where(strip, out / self.size_mm[:, axis], 0.0)
            grown *= self._self_compliance / self.share
            sides.append(lean[axis] * moved + grown * force)
        slopes = np.zeros((len(force), len(sides)))
        slopes[bears] = solve_factored(
            _solved(self, bears.tobytes())[1], np.column_stack(sides)[bears]
        )
        return slopes


@lru_cache(maxsize=16)
def _part(jaw: JawFace, x_low: float, x_high: float, y_low: float, y_high: float) -> _Part:
    """The part between four edges (mm), kept: a fit asks for the slopes where it has just pressed."""
    edges = np.array([[x_low, x_high], [y_low, y_high]])
    (x, x_width), (y, y_width) = map(_covered_mm, jaw.half_mm, edges)
    share = np.multiply.outer(x_width, y_width).ravel() / (4 * jaw.half_mm.prod() / CELLS**2)
    (used,) = np.nonzero(share > _LEAST_SHARE)
    column, row = used // CELLS, used % CELLS
    centre = np.column_stack([x[column], y[row]])
    size = np.column_stack([x_width[column], y_width[row]])
    return _Part(jaw, edges, used, centre, size, share[used])


@lru_cache(maxsize=32)
def _solved(
    part: _Part, bears: bytes
) -> tuple[Float[np.ndarray, "cell 3"], Float[np.ndarray, "chosen chosen"]]:
    """Forces of each of the three depths where some cells bear, and Cholesky's factor: kept, as other leans
    and the slopes ask for them again."""
    (index,) = np.nonzero(np.frombuffer(bears, bool))
    forces, factor = np.zeros(part.depths.shape), np.zeros((0, 0))
    if len(index):
        forces[index], factor = solve_positive(part.block(index), part.depths[index])
    return forces, factor


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

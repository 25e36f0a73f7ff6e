"""Unilateral contact with Coulomb's friction between an elastic body and a rigid core.

At each site the core pushes with λ along its normal and drags with τ along its wall:
    opening w ≥ 0, λ ≥ 0, λ w = 0;      |τ| ≤ μ λ, slip against τ where |τ| = μ λ, none where less.
Both laws say that the force is the projection of force − ρ · motion: of its normal part onto
λ ≥ 0, then of its tangential part onto the disk of radius μ λ, for any ρ > 0. Displacements and
forces are found by the alternating direction method of multipliers (Glowinski & Le Tallec, Augmented
Lagrangian and Operator-Splitting Methods, 1989), indenters' pressures p ≥ 0 with them: one inverse
for a whole path, then products and projections, so that the forces returned are in the cone
exactly. With friction this is no minimum of an energy, and convergence is observed, not proved.
Slip depends on the path: the body is brought to its state in steps.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy.linalg
from jaxtyping import Bool, Float

from design.errors import SolverError
from studies.loose_core.response import CoreWalls

TOLERANCE = 1e-6
"""Of the largest force before or after a step, in forces and (times ρ) in motions."""
_MAX_ITERATIONS, _CHECKED_EVERY = 30_000, 25
_RELAXED = 1.6
_SITE_UNITS = 5.0
"""ρ of the sites in units of the stiffness given; that of cells is 1 / their own compliance."""


@dataclass(frozen=True)
class SiteLaw:
    """Friction coefficient μ; a stiffness of every site (N/mm), for the size of the body's own.

    `hold` times it draws the body back to the core where it has left: nothing else may hold it.
    """

    friction: float
    stiffness_n_per_mm: Float[np.ndarray, "site"]
    hold: float = 0.0


@dataclass(frozen=True)
class WallState:
    """Displacements of the vertices (x, y, z of each), and at every site along its normal and its two
    tangents the motion against the core (mm) and the core's force on the body (N);
    `dissipated_mj` (N mm) since the beginning."""

    displacement_mm: Float[np.ndarray, "unknown"]
    relative_mm: Float[np.ndarray, "site 3"]
    force_n: Float[np.ndarray, "site 3"]
    slipping: Bool[np.ndarray, "site"]
    dissipated_mj: float

    @property
    def opening_mm(self) -> Float[np.ndarray, "site"]:
        """Return how far the body has left the core, 0 where it touches."""
        left = np.maximum(self.relative_mm[:, 0], 0.0)
        return np.where(self.force_n[:, 0] > 0, 0.0, left)


@dataclass(frozen=True)
class Indented:
    """Cells of indenters on the body: their motions are C p − Fᵀ u, mm³ per MPa."""

    compliance: Float[np.ndarray, "cell cell"]
    force_per_load: Float[np.ndarray, "unknown cell"]


def untouched(walls: CoreWalls) -> WallState:
    """Before anything has moved."""
    sites = len(walls.vertex)
    zero = np.zeros((sites, 3))
    return WallState(np.zeros(3 * len(walls.points_mm)), zero, zero, np.zeros(sites, bool), 0.0)


def site_axes(normal: Float[np.ndarray, "site 3"]) -> Float[np.ndarray, "site 3 3"]:
    """Rows: the normal and two tangents of every site."""
    least = np.eye(3)[np.argmin(abs(normal), axis=1)]
    first = np.cross(normal, least)
    first /= np.linalg.norm(first, axis=1)[:, None]
    return np.stack([normal, first, np.cross(normal, first)], axis=1)


def onto_cone(trial_n: Float[np.ndarray, "site 3"], friction: float) -> Float[np.ndarray, "site 3"]:
    """Nearest push, then the nearest drag that it allows."""
    push = np.maximum(trial_n[:, 0], 0)
    drag = np.linalg.norm(trial_n[:, 1:], axis=1)
    share = np.minimum(1, friction * push / np.maximum(drag, 1e-300))
    return np.column_stack([push, share[:, None] * trial_n[:, 1:]])


class LooseBody:
    """An elastic body on a core, with the indenters that press it; `stiffness` is K in N/mm."""

    def __init__(
        self,
        stiffness: Float[np.ndarray, "unknown unknown"],
        walls: CoreWalls,
        law: SiteLaw,
        indented: Indented | None = None,
    ) -> None:
        size = len(stiffness)
        given = indented or Indented(np.zeros((0, 0)), np.zeros((size, 0)))
        self.walls, self.law, self.axes = walls, law, site_axes(walls.normal)
        self._on_vertices = _force_map(walls, self.axes)
        self._site = _SITE_UNITS * law.stiffness_n_per_mm[:, None]
        self._cell = 1 / np.diag(given.compliance)
        self._hold = law.hold * law.stiffness_n_per_mm
        matrix = _in_motions(stiffness, given)
        normal = self._on_vertices[:, ::3]
        matrix[:size, :size] += (normal * self._hold) @ normal.T
        penalty = np.repeat(self._site[:, 0], 3)
        matrix[:size, :size] += (self._on_vertices * penalty) @ self._on_vertices.T
        cells = np.arange(size, len(matrix))
        matrix[cells, cells] += self._cell
        self._inverse = scipy.linalg.inv(matrix, check_finite=False)

    def advance(
        self,
        before: WallState,
        core_mm: Float[np.ndarray, "site 3"],
        gap: Float[np.ndarray, "cell"] | None = None,
        pressure_mpa: Float[np.ndarray, "cell"] | None = None,
    ) -> tuple[Float[np.ndarray, "cell"], WallState]:
        """Pressures (MPa) and the state after one step.

        Parameters
        ----------
        core_mm : displacement of the core's surface at every site since nothing had moved, in the
            object's axes
        gap : mm³, of every cell before anything moves, negative where the indenter has come in
        pressure_mpa : those of the step before, to begin with

        Raises
        ------
        SolverError
            The iteration did not settle.
        """
        size, site, cell = len(before.displacement_mm), self._site, self._cell
        gap = np.zeros(len(cell)) if gap is None else gap
        held = np.einsum("sij,sj->si", self.axes, core_mm)
        base = held.copy()
        base[:, 1:] += before.relative_mm[:, 1:]
        pull = self._on_vertices[:, ::3] @ (self._hold * held[:, 0])
        largest = max(abs(before.force_n).max(), 1e-9)
        hardest = 1e-9 if pressure_mpa is None else max(pressure_mpa.max(initial=0), 1e-9)
        force, motion = before.force_n, before.relative_mm.copy()
        motion[:, 1:] = 0
        pressure = np.zeros(len(cell)) if pressure_mpa is None else pressure_mpa
        open_ = np.where(pressure > 0, 0.0, np.maximum(gap, 0))
        for iteration in range(1, _MAX_ITERATIONS + 1):
            on_sites = self._on_vertices @ (force + site * (base + motion)).ravel() + pull
            x = self._inverse @ np.concatenate([on_sites, pressure + cell * (open_ - gap)])
            moved = (self._on_vertices.T @ x[:size]).reshape(-1, 3) - base
            relaxed = _RELAXED * moved + (1 - _RELAXED) * motion
            above = _RELAXED * (x[size:] + gap) + (1 - _RELAXED) * open_
            trial = force - site * relaxed
            force_next = onto_cone(trial, self.law.friction)
            pressure_next = np.maximum(pressure - cell * above, 0)
            motion_next = relaxed + (force_next - force) / site
            open_next = above + (pressure_next - pressure) / cell
            if iteration % _CHECKED_EVERY == 0:
                unit = max(abs(force_next).max(), largest)
                load = max(pressure_next.max(initial=0), hardest)
                off = (
                    abs(site * (moved - motion_next)).max() / unit,
                    abs(site * (motion_next - motion)).max() / unit,
                    abs(cell * (x[size:] + gap - open_next)).max(initial=0) / load,
                    abs(cell * (open_next - open_)).max(initial=0) / load,
                )
                if max(off) < TOLERANCE:
                    slid = motion_next[:, 1:]
                    lost = -float(np.sum(force_next[:, 1:] * slid))
                    far = np.linalg.norm(site * slid, axis=1) > 10 * TOLERANCE * unit
                    slips = (force_next[:, 0] > 0) & far
                    there = motion_next.copy()
                    there[:, 1:] += before.relative_mm[:, 1:]
                    total = before.dissipated_mj + lost
                    return pressure_next, WallState(x[:size], there, force_next, slips, total)
            force, motion, pressure, open_ = force_next, motion_next, pressure_next, open_next
        raise SolverError(
            f"contact with friction at the core did not settle in {_MAX_ITERATIONS} iterations. Press "
            "in smaller steps or less deep, or with more friction"
        )


def _force_map(walls: CoreWalls, axes: np.ndarray) -> Float[np.ndarray, "unknown force"]:
    """Forces on the vertices by those along the sites' axes."""
    sites = len(walls.vertex)
    matrix = np.zeros((len(walls.points_mm), 3, sites, 3))
    matrix[walls.vertex, :, np.arange(sites)] = np.swapaxes(axes, 1, 2)
    return matrix.reshape(-1, 3 * sites)


def _in_motions(stiffness: np.ndarray, indented: Indented) -> np.ndarray:
    """Stiffness of displacements u and motions q of the cells: p = C⁻¹ (q + Fᵀ u), r = F p + K u."""
    forces = indented.force_per_load
    inner = scipy.linalg.inv(indented.compliance) if forces.shape[1] else indented.compliance
    inner = (inner + inner.T) / 2
    mixed = forces @ inner
    return np.block([[stiffness + mixed @ forces.T, mixed], [mixed.T, inner]])

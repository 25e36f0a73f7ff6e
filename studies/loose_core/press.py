"""Presses on a shell that was pushed onto its core: along the path, with friction there."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from design.errors import InputError
from design.spec.object import ObjectSpec
from fem.linear.core_interface import CoreState
from fem.presses.joint import JointCells, JointPress, Tip, joint_cells, require_apart
from studies.loose_core.coulomb import Indented, LooseBody, SiteLaw, WallState, untouched
from studies.loose_core.response import LooseShell

HOLD = 1e-3
"""Of the layer's own stiffness E/h: draws a shell back that nothing else would hold on its core."""


@dataclass(frozen=True)
class LooseCore:
    """How the shell sits on its core: Coulomb's coefficient, and by how much the core is larger on
    every side than the cavity it was pushed into (mm)."""

    friction: float
    interference_mm: float = 0.0

    def __post_init__(self) -> None:
        if not (self.friction >= 0 and 0 <= self.interference_mm <= 1):
            raise InputError(
                "a loose core needs a friction coefficient of 0 or more and an interference of 0 to "
                f"1 mm; got {self.friction:g} and {self.interference_mm:g}. Give both so"
            )


@dataclass(frozen=True)
class LoosePress:
    """A joint press, and the state of the core's walls in it.

    Motions and forces of `joint` are changes against the shell at rest on its core; its `core` holds
    the sites' normal forces and openings as they are.
    """

    joint: JointPress
    walls: WallState


def law_of(spec: ObjectSpec, shell: LooseShell, core: LooseCore) -> SiteLaw:
    """Friction at the shell's sites, and the layer's stiffness E/h there."""
    unit = spec.silicone.youngs_modulus_mpa / spec.shell.thickness_mm * shell.walls.weights_mm2
    return SiteLaw(core.friction, unit, HOLD)


def at_rest(spec: ObjectSpec, shell: LooseShell, core: LooseCore) -> WallState:
    """The shell on its core before any press, stretched by the interference in one step."""
    state = untouched(shell.walls)
    if not core.interference_mm:
        return state
    body = LooseBody(shell.stiffness, shell.walls, law_of(spec, shell, core))
    return body.advance(state, core.interference_mm * shell.walls.outward)[1]


def press_loose(
    spec: ObjectSpec,
    shell: LooseShell,
    core: LooseCore,
    tips: Sequence[Tip],
    depths_mm: Float[np.ndarray, "step tip"],
    rest: WallState | None = None,
) -> tuple[LoosePress, ...]:
    """Press along a path of depths, from the shell at rest; depth counts from the first touch.

    Steps are the rows of `depths_mm`. The indenter itself is frictionless.

    Raises
    ------
    InputError
        An oblique path, or tips that overlap or hang over a face's border.
    SolverError
        A step that does not settle.
    """
    require_apart(spec, tips)
    if any(spec.indenter.direction_deg):
        raise InputError(
            "presses on a loose core go straight down. Leave indenter.direction_deg out"
        )
    rest = rest or at_rest(spec, shell, core)
    path = _Path(spec, shell, core, tips, rest)
    state, pressure, found = rest, None, []
    for depths in np.asarray(depths_mm, float):
        pressure, state = path.body.advance(state, path.core_mm, path.gap(depths), pressure)
        found.append(path.press(depths, pressure, state))
    return tuple(found)


class _Path:
    """What does not change along a path."""

    def __init__(
        self,
        spec: ObjectSpec,
        shell: LooseShell,
        core: LooseCore,
        tips: Sequence[Tip],
        rest: WallState,
    ) -> None:
        self.shell, self.tips, self.rest = shell, tuple(tips), rest
        self.core_mm = core.interference_mm * shell.walls.outward
        self.cells: JointCells = joint_cells(spec, shell.bonded, tips, np.zeros(len(tips)), None)
        self.loads, self.spread = _spread(shell, self.cells)
        self.forces = shell.force_per_load[:, self.loads] @ self.spread
        indented = Indented(self.cells.compliance, self.forces)
        self.body = LooseBody(shell.stiffness, shell.walls, law_of(spec, shell, core), indented)

    def gap(self, depths_mm: np.ndarray) -> np.ndarray:
        """Between the shell before anything has moved and the indenters, integrated over cells.

        The machine zeroes on the shell as it rests: its bulging there is no gap.
        """
        gap = (self.cells.gap_mm - depths_mm[self.cells.tip]) * self.cells.area_mm2
        return gap + self.forces.T @ self.rest.displacement_mm

    def press(self, depths_mm: np.ndarray, pressure: np.ndarray, state: WallState) -> LoosePress:
        """The joint press at depths."""
        cells, count = self.cells, len(self.tips)
        force = np.bincount(cells.tip, pressure * cells.area_mm2, minlength=count)
        touched = np.bincount(cells.tip, (pressure > 0) * cells.area_mm2, minlength=count)
        bonded, magnets = self.shell.bonded, self.shell.bonded.magnet_loads
        moved = bonded.compliance[magnets][:, self.loads] @ (self.spread @ pressure)
        change = state.displacement_mm - self.rest.displacement_mm
        moved = moved - self.shell.force_per_load[:, magnets].T @ change
        core = CoreState(np.maximum(state.force_n[:, 0], 0), state.opening_mm)
        joint = JointPress(
            self.tips, depths_mm, force, np.zeros((count, 2)), touched, moved.reshape(-1, 6), core
        )
        return LoosePress(joint, state)


def _spread(shell: LooseShell, cells: JointCells) -> tuple[np.ndarray, np.ndarray]:
    """Loads that stand for the cells' pressures, and the matrix (load, cell) that does it."""
    parts = [shell.bonded.face_loads(one.face.index).start + one.rows for one in cells.spreads]
    loads, row = np.unique(np.concatenate(parts), return_inverse=True)
    matrix = np.zeros((len(loads), len(cells.gap_mm)))
    first_row = first_cell = 0
    for one in cells.spreads:
        height, width = one.matrix.shape
        rows = row[first_row : first_row + height]
        matrix[np.ix_(rows, np.arange(first_cell, first_cell + width))] += one.matrix
        first_row, first_cell = first_row + height, first_cell + width
    return loads, matrix

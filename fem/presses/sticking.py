"""Presses with sticking friction: what an indenter has touched moves with it until it lifts off.

Small strain, in steps along the path. A cell that comes into contact keeps from then on its
tangential place on the indenter, u_t = T + (u_t − T at the step before), T being the indenter's
sideways motion; the contact stays unilateral (p ≥ 0, gap ≥ 0), and a cell that lifts off is free.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
import scipy.linalg
from jaxtyping import Bool, Float, Int
from scipy.optimize import brentq

from design.errors import InputError, SolverError
from design.layout.tips import TipShape, path_mm, tip_heights_mm, tip_places_mm, tip_shape
from design.spec.object import ObjectSpec
from fem.contact.indenter import TipCells, moved, tip_cells
from fem.contact.traction import TractionResponse, traction_response
from fem.mesh.tetrahedra import TetMesh
from fem.presses.joint import JointPress, Tip, centres_mm, require_apart

_LARGEST_STEP_MM = 0.1
"""Depth of a step along the path, at most."""
_FEWEST_STEPS = 10
"""Steps of a press, at least."""
_MAX_SWITCHES = 60
"""Rounds in which cells switch between contact and none; more, and contact has not settled."""
LARGEST_SHARE = 0.8
"""Deepest press over the tip's height or the shell's thickness."""
_TOLERANCE = 1e-9
"""Penetration over the depth that is rounding."""


@dataclass(frozen=True)
class StickingSetting:
    """Cells of all indenters, the indenter and tip of each, and their compliance."""

    spec: ObjectSpec
    tips: tuple[Tip, ...]
    cells: TipCells
    indenter: Int[np.ndarray, "cell"]
    shape: TipShape
    response: TractionResponse


@dataclass(frozen=True)
class StickingState:
    """Tractions (MPa; inwards, x, y), the cells in contact, the indenter's height over them, and
    their tangential place on it (mm)."""

    traction_mpa: Float[np.ndarray, "3 cell"]
    touching: Bool[np.ndarray, "cell"]
    height_mm: Float[np.ndarray, "cell"]
    anchor_mm: Float[np.ndarray, "2 cell"]
    path_mm: Float[np.ndarray, "2 cell"]


def sticking_setting(spec: ObjectSpec, mesh: TetMesh, tips: Sequence[Tip]) -> StickingSetting:
    """Condense tractions in three directions at every indenter.

    Raises
    ------
    InputError
        Two indenters overlap.
    """
    require_apart(spec, tips)
    cut = tip_cells(spec.indenter)
    groups = [moved(cut.patches, np.array([tip.x_mm, tip.y_mm])) for tip in tips]
    response = traction_response(spec, mesh, [tip.face for tip in tips], groups)
    count = len(tips)
    cells = replace(
        cut,
        patches=replace(
            cut.patches,
            area_mm2=np.tile(cut.patches.area_mm2, count),
            centre_mm=np.tile(cut.patches.centre_mm, (count, 1)),
            variance_mm2=np.tile(cut.patches.variance_mm2, count),
        ),
        height_mm=np.tile(cut.height_mm, count),
        tip=np.tile(cut.tip, count),
    )
    owner = np.repeat(np.arange(count), len(cut.height_mm))
    return StickingSetting(spec, tuple(tips), cells, owner, tip_shape(spec.indenter), response)


def press_sticking(
    setting: StickingSetting, depths_mm: Float[np.ndarray, "tip"]
) -> list[JointPress]:
    """Press all indenters in step to their depths; the joint press after every step.

    Steps are 0.1 mm of the deepest at most. Halving them changes the force of the R 5 mm sphere,
    2 mm deep in the paper's cube, by 0.15 % and its shear on a path 30° oblique by 1.8 %.

    Raises
    ------
    SolverError
        The set of cells in contact does not settle.
    """
    count = max(_FEWEST_STEPS, int(np.ceil(np.max(depths_mm) / _LARGEST_STEP_MM - 1e-9)))
    cells = len(setting.indenter)
    nowhere = np.zeros((2, cells))
    state = StickingState(
        np.zeros((3, cells)), np.zeros(cells, bool), np.zeros(cells), nowhere, nowhere
    )
    presses = []
    for step in range(1, count + 1):
        depth = np.asarray(depths_mm, float) * step / count
        state = next_state(setting, state, depth)
        presses.append(joint_press_of(setting, state, depth))
    return presses


def press_sticking_to_force(setting: StickingSetting, force_n: float) -> list[JointPress]:
    """The press of a single indenter until it bears `force_n`, to 1e-6 mm of travel.

    Raises
    ------
    InputError
        Several indenters, or a force that is not positive or not reached within the indenter's
        height and the shell's thickness.
    """
    if len(setting.tips) != 1:
        raise InputError(
            f"with sticking friction one press at a time goes to a force; got {len(setting.tips)}. "
            "Press them one by one, or to depths"
        )
    deepest = LARGEST_SHARE * min(setting.shape.height_mm, setting.spec.shell.thickness_mm)

    def missing(depth_mm: float) -> float:
        return float(press_sticking(setting, np.array([depth_mm]))[-1].force_n[0]) - force_n

    most = missing(deepest) + force_n
    if not 0 < force_n <= most:
        raise InputError(
            f"{force_n:g} N are not reached: the press must be positive and bears {most:.3g} N at "
            f"{deepest:.3g} mm. Press less hard"
        )
    depth = brentq(missing, 1e-6, deepest, xtol=1e-6)
    return press_sticking(setting, np.array([depth]))


def next_state(
    setting: StickingSetting, state: StickingState, depth_mm: np.ndarray
) -> StickingState:
    """Equilibrium at the next depth: cells in contact are switched until all signs are right."""
    area = setting.cells.patches.area_mm2
    previous_mm = displacement_mm(setting, state)[1:]
    path = path_mm(setting.spec.indenter, depth_mm).T[:, setting.indenter]
    anchor = np.where(state.touching, state.anchor_mm, previous_mm - state.path_mm)
    slid_over = heights_mm(setting, path - previous_mm)
    height = np.where(state.touching, state.height_mm, slid_over)
    reach = depth_mm[setting.indenter] - height
    touching = state.touching | (reach > 0.4 * depth_mm[setting.indenter])
    for _ in range(_MAX_SWITCHES):
        wanted = np.vstack([reach, path + anchor])
        traction = tractions_of(setting, wanted, touching)
        # Mean normal displacement of cell i by tractions in directions b (normal, x, y) on cells j,
        # less the wanted depth: 0 in contact, above 0 where the tip is off.
        gap = np.einsum("ibj,bj->i", setting.response.compliance[0], traction) / area - reach
        lifting = touching & (traction[0] <= 0)
        sinking = ~touching & (gap < -_TOLERANCE * depth_mm.max())
        if not (lifting.any() or sinking.any()):
            return StickingState(traction, touching, height, anchor, path)
        touching = (touching & ~lifting) | sinking
    raise SolverError(
        f"sticking contact does not settle at {depth_mm.max():.3g} mm: "
        f"{int(lifting.sum() + sinking.sum())} cells still switch. Press less deep or less oblique"
    )


def tractions_of(
    setting: StickingSetting, wanted_mm: np.ndarray, touching: np.ndarray
) -> np.ndarray:
    """Tractions on the touching cells that give the target displacements (3, cell)."""
    traction = np.zeros_like(wanted_mm)
    if touching.any():
        chosen = setting.response.compliance[:, touching][:, :, :, touching]
        count = 3 * int(touching.sum())
        area = setting.cells.patches.area_mm2[touching]
        moved_by = scipy.linalg.solve(
            chosen.reshape(count, count), (wanted_mm[:, touching] * area).ravel(), assume_a="pos"
        )
        traction[:, touching] = moved_by.reshape(3, -1)
    return traction


def displacement_mm(setting: StickingSetting, state: StickingState) -> np.ndarray:
    """Mean displacement of every cell (3, cell): inwards, x, y."""
    moved_by = np.tensordot(setting.response.compliance, state.traction_mpa, axes=2)
    return moved_by / setting.cells.patches.area_mm2


def heights_mm(
    setting: StickingSetting, slip_mm: Float[np.ndarray, "2 cell"]
) -> Float[np.ndarray, "cell"]:
    """Height of the indenter over cells that it has slid over by `slip_mm`; ∞ off it."""
    cells = setting.cells
    local = cells.patches.centre_mm - tip_places_mm(setting.spec.indenter)[cells.tip]
    mean_less_middle = cells.height_mm - tip_heights_mm(setting.shape, local)
    beside = ~np.isfinite(mean_less_middle)
    return tip_heights_mm(setting.shape, local - slip_mm.T) + np.where(beside, 0, mean_less_middle)


def joint_press_of(
    setting: StickingSetting, state: StickingState, depth_mm: np.ndarray
) -> JointPress:
    area, tips = setting.cells.patches.area_mm2, setting.tips
    normal, x, y = (
        np.bincount(setting.indenter, part * area, minlength=len(tips))
        for part in state.traction_mpa
    )
    touched = np.bincount(setting.indenter, state.touching * area, minlength=len(tips))
    motion = np.tensordot(setting.response.motion, state.traction_mpa, axes=2).reshape(-1, 6)
    bears = state.traction_mpa[0] * area
    centre = centres_mm(bears, setting.cells.patches.centre_mm, setting.indenter, len(tips))
    return JointPress(
        tips, depth_mm, normal, np.column_stack([x, y]), touched, motion, centre_mm=centre
    )

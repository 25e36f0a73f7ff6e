"""Several rigid indenters at once, on one face or on several, with contact solved jointly.

Presses side by side and parallel-jaw grasps: every indenter's pressure moves the surface under
every other one, through the compliance between all faces.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np
from jaxtyping import Float, Int

from design.errors import InputError
from design.layout.tips import path_mm, tips_overlap
from design.spec.object import ObjectSpec
from fem.contact.complementarity import contact_pressures
from fem.contact.indenter import TipCells, moved, tip_cells
from fem.contact.lift_off import lift_off
from fem.contact.refined import (
    RefinedFace,
    Spread,
    joint_compliance,
    refined_face,
    spread_cells,
)
from fem.linear.core_interface import CoreState
from fem.linear.response import ResponseOperator
from fem.presses.table import cells_over, require_landing, require_on_patch, resting_gap_mm


@dataclass(frozen=True)
class Tip:
    """One indenter: the face (1…5) and where it lands on it, mm; on a curved one along the surface."""

    face: int
    x_mm: float
    y_mm: float


@dataclass(frozen=True)
class JointPress:
    """Indenters pressed together: force of each (N) at its depth (mm), and all magnets' motions.

    `shear_n` are the forces along the face's x and y, 0 without friction. `motion` (magnet, 6) is
    in mm and rad, in the object's frame, as in `MagnetMotions`. `core` is None for a bonded one.
    `centre_mm` is the centre of pressure, about the place pressed in the plane that touches it there:
    None over an edge, 0 where nothing presses.
    """

    tips: tuple[Tip, ...]
    depth_mm: Float[np.ndarray, "tip"]
    force_n: Float[np.ndarray, "tip"]
    shear_n: Float[np.ndarray, "tip 2"]
    contact_area_mm2: Float[np.ndarray, "tip"]
    motion: Float[np.ndarray, "magnet 6"]
    core: CoreState | None = None
    centre_mm: Float[np.ndarray, "tip 2"] | None = None


@dataclass(frozen=True)
class JointCells:
    """All indenters' cells over the body, with their mutual compliance, wherever their paths have
    brought them; `away_mm` is from the place pressed."""

    cut: tuple[TipCells, ...]
    spreads: tuple[Spread, ...]
    compliance: Float[np.ndarray, "cell cell"]
    gap_mm: Float[np.ndarray, "cell"]
    area_mm2: Float[np.ndarray, "cell"]
    tip: Int[np.ndarray, "cell"]
    away_mm: Float[np.ndarray, "cell 2"]


def refined_faces(spec: ObjectSpec, response: ResponseOperator) -> dict[int, RefinedFace]:
    """Every face prepared for contact, for those who press many times."""
    numbers = [surface.number for surface in response.surfaces]
    return {number: refined_face(response, i, spec) for i, number in enumerate(numbers)}


def press_path(
    spec: ObjectSpec,
    response: ResponseOperator,
    tips: Sequence[Tip],
    depths_mm: Float[np.ndarray, "step tip"],
    faces: dict[int, RefinedFace] | None = None,
) -> tuple[JointPress, ...]:
    """`press_tips` at several depths, at the cost of little more than one.

    A frictionless core holds the shell both ways here.
    """
    press = presser(spec, response, tips, faces)
    return tuple(press(depths) for depths in np.asarray(depths_mm, float))


def press_tips(
    spec: ObjectSpec,
    response: ResponseOperator,
    tips: Sequence[Tip],
    depths_mm: Float[np.ndarray, "tip"],
) -> JointPress:
    """Press every indenter to its own depth, all together, without friction.

    A frictionless core only pushes: the shell lifts off where it would pull (`fem.contact.lift_off`).

    Raises
    ------
    InputError
        An indenter on no sensed face, over a face's border, or overlapping another.
    """
    depths = np.asarray(depths_mm, float)
    return press_on_core(spec, response, lambda given: presser(spec, given, tips)(depths))


def press_on_core(
    spec: ObjectSpec, response: ResponseOperator, press: Callable[[ResponseOperator], JointPress]
) -> JointPress:
    """The press as it is on a bonded core; a frictionless one only pushes."""
    if response.core is None:
        return press(response)
    pressed, state = lift_off(spec, response, press, _core_force)
    return replace(pressed, core=state)


def _core_force(press: JointPress) -> np.ndarray:
    assert press.core is not None
    return press.core.force_n


def presser(
    spec: ObjectSpec,
    response: ResponseOperator,
    tips: Sequence[Tip],
    faces: dict[int, RefinedFace] | None = None,
) -> Callable[[np.ndarray], JointPress]:
    """Function from the tips' depths to their joint press; on straight paths cells stay."""
    require_apart(spec, tips)
    straight = not any(spec.indenter.direction_deg)
    kept = joint_cells(spec, response, tips, np.zeros(len(tips)), faces) if straight else None

    def press(depths_mm: np.ndarray) -> JointPress:
        cells = kept or joint_cells(spec, response, tips, depths_mm, faces)
        for cut, spread, depth in zip(cells.cut, cells.spreads, depths_mm, strict=True):
            require_on_patch(cut, spread, depth)
        gap = (cells.gap_mm - depths_mm[cells.tip]) * cells.area_mm2
        pressure = contact_pressures(cells.compliance, gap, cells.area_mm2, np.zeros(1))[0]
        bears = pressure * cells.area_mm2
        force = np.bincount(cells.tip, bears, minlength=len(tips))
        centre = centres_mm(bears, cells.away_mm, cells.tip, len(tips))
        touched = np.bincount(cells.tip, (pressure > 0) * cells.area_mm2, minlength=len(tips))
        motion = spread_motion(response, cells.spreads, pressure)
        shear = np.zeros((len(tips), 2))
        core = _held_core(response, cells.spreads, pressure)
        return JointPress(tuple(tips), depths_mm, force, shear, touched, motion, core, centre)

    return press


def centres_mm(
    force_n: Float[np.ndarray, "cell"],
    away_mm: Float[np.ndarray, "cell 2"],
    tip: Int[np.ndarray, "cell"],
    tips: int,
) -> Float[np.ndarray, "tip 2"]:
    """Centre of pressure of every tip; 0 where nothing presses."""
    total = np.bincount(tip, force_n, minlength=tips)
    moments = [np.bincount(tip, force_n * part, minlength=tips) for part in away_mm.T]
    return np.column_stack(moments) / np.where(total > 0, total, 1.0)[:, None]


def spread_motion(
    response: ResponseOperator, spreads: Sequence[Spread], pressure_mpa: Float[np.ndarray, "cell"]
) -> Float[np.ndarray, "magnet 6"]:
    """Motions of all magnets under the pressures of cells."""
    per_load = response.compliance[response.magnet_loads]
    return sum_over_spreads(response, per_load, spreads, pressure_mpa).reshape(-1, 6)


def _held_core(
    response: ResponseOperator, spreads: Sequence[Spread], pressure_mpa: np.ndarray
) -> CoreState | None:
    """Forces of a frictionless core that holds the shell both ways."""
    if response.core is None:
        return None
    force = sum_over_spreads(response, response.core.force_per_load, spreads, pressure_mpa)
    return CoreState(force, np.zeros(len(force)))


def sum_over_spreads(
    response: ResponseOperator,
    per_load: Float[np.ndarray, "row load"],
    spreads: Sequence[Spread],
    pressure_mpa: np.ndarray,
) -> np.ndarray:
    """Sum of what the cells' pressures do through rows per load."""
    total, first = np.zeros(len(per_load)), 0
    for spread in spreads:
        last = first + len(spread.patches.area_mm2)
        columns = response.face_loads(spread.face.index).start + spread.rows
        total += per_load[:, columns] @ (spread.matrix @ pressure_mpa[first:last])
        first = last
    return total


def joint_cells(
    spec: ObjectSpec,
    response: ResponseOperator,
    tips: Sequence[Tip],
    depths_mm: np.ndarray,
    faces: dict[int, RefinedFace] | None,
) -> JointCells:
    """All indenters' cells where their paths have brought them at some depths."""
    numbers = [surface.number for surface in response.surfaces]
    used = {tip.face for tip in tips}
    if faces is None:
        faces = {n: refined_face(response, i, spec) for i, n in enumerate(numbers) if n in used}
    indenter, whole = spec.indenter, tip_cells(spec.indenter)
    spreads, cuts, away = [], [], []
    for tip, sideways in zip(tips, path_mm(indenter, depths_mm), strict=True):
        if tip.face not in numbers:
            raise InputError(f"face {tip.face} is not a sensed face. Press one of {numbers}")
        place = faces[tip.face].frame.to_plane(np.array([tip.x_mm, tip.y_mm]))
        require_landing(faces[tip.face], spec, np.stack([place, place + sideways]))
        cuts.append(cells_over(faces[tip.face], indenter, whole, place + sideways))
        patches = moved(cuts[-1].patches, place + sideways)
        away.append(patches.centre_mm - place)
        spreads.append(spread_cells(faces[tip.face], patches, place))
    gaps = [resting_gap_mm(cut, spread) for cut, spread in zip(cuts, spreads, strict=True)]
    return JointCells(
        tuple(cuts),
        tuple(spreads),
        joint_compliance(response, spreads, spec),
        np.concatenate(gaps),
        np.concatenate([cut.patches.area_mm2 for cut in cuts]),
        np.repeat(np.arange(len(tips)), [len(gap) for gap in gaps]),
        np.concatenate(away),
    )


def require_apart(spec: ObjectSpec, tips: Sequence[Tip]) -> None:
    """Raise InputError where two indenters on a face overlap."""
    for a, b in combinations(tips, 2):
        offset = np.array([b.x_mm - a.x_mm, b.y_mm - a.y_mm])
        if a.face == b.face and tips_overlap(spec.indenter, offset):
            raise InputError(
                f"two indenters on face {a.face}, {np.hypot(*offset):.3g} mm apart at ({a.x_mm:g}, "
                f"{a.y_mm:g}) and ({b.x_mm:g}, {b.y_mm:g}) mm, overlap. Move them apart or use "
                "smaller ones"
            )

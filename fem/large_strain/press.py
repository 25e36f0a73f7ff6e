"""Presses of the hemisphere with large deformation, compared with small strain on the same mesh."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

import numpy as np
from scipy.spatial.transform import Rotation

from design.spec.object import ObjectSpec
from fem.large_strain.hyperelastic import Hyperelastic
from fem.large_strain.newton import PressState, StepDivergedError, equilibrium, undeformed
from fem.large_strain.results import LargeStrainPress
from fem.large_strain.single_press import (
    PressRow,
    PressSetting,
    linear_press,
    press_setting,
    require_modulus,
    require_press,
    sphere_centre_mm,
)
from fem.large_strain.sphere_contact import contact_state, normal_force_n
from fem.mesh.tetrahedra import TetMesh
from fem.presses.shape import FacePressure, deformed_shape, face_vertices, shape_of_unknowns

Progress = Callable[[str], None]

LARGEST_STEP_MM = 0.5
"""Depth of the first step and of any, at most."""
SMALLEST_STEP_MM = 0.02
"""Depth of a step below which a press is given up."""


def press_large_strain(
    spec: ObjectSpec,
    mesh: TetMesh,
    face: int,
    x_mm: float,
    y_mm: float,
    depths_mm: Sequence[float],
    material: Hyperelastic,
    progress: Progress | None = None,
) -> LargeStrainPress:
    """Press one place of a face to each depth with large deformation, and linearly on the same mesh.

    The linear model has the material's modulus at small strain. Depths increase; between them
    load steps are halved where Newton's method diverges, down to 0.02 mm, and the press ends
    there with the depths so far. A mean rotation stands for the magnets' where they are points.

    Raises
    ------
    InputError
        An unknown face, a tip beyond the face's border, depths that do not increase or reach the
        tip's radius, or a material whose modulus is not the specification's.
    """
    require_press(spec, face, x_mm, y_mm, depths_mm)
    require_modulus(spec, material)
    setting = press_setting(spec, mesh, face, np.array([x_mm, y_mm], float), material)
    rows: list[PressRow] = []
    state = undeformed(setting.problem)
    for depth, state in converged_states(setting, depths_mm, progress or (lambda _: None)):
        rows.append(row_of_state(setting, depth, state))
    return collected_press(setting, material, rows, state, depths_mm[-1])


def converged_states(
    setting: PressSetting, depths_mm: Sequence[float], progress: Progress
) -> Iterator[tuple[float, PressState]]:
    """Equilibrium at each depth; where a load step cannot be halved further, the last one found."""
    state, reached, step = undeformed(setting.problem), 0.0, LARGEST_STEP_MM
    answered: list[float] = []
    for depth in depths_mm:
        while reached < depth:
            target = min(depth, reached + step)
            try:
                state = equilibrium(setting.problem, state, sphere_centre_mm(setting, target))
            except StepDivergedError as error:
                step = (target - reached) / 2
                progress(f"{target:.3g} mm: {error}; the load step is halved")
                if step >= SMALLEST_STEP_MM:
                    continue
                if reached not in answered:
                    yield reached, state
                return
            reached, step = target, min(2 * step, LARGEST_STEP_MM)
            progress(f"{reached:.3g} of {depths_mm[-1]:.3g} mm")
        answered.append(depth)
        yield depth, state


def row_of_state(setting: PressSetting, depth_mm: float, state: PressState) -> PressRow:
    problem, face = setting.problem, setting.problem.face
    centre = sphere_centre_mm(setting, depth_mm)
    contact = contact_state(face, state.displacement_mm, centre, problem.radius_mm)
    turn = Rotation.from_matrix(state.rotation).as_rotvec()
    return PressRow(
        depth_mm,
        normal_force_n(face, contact, state.contact_mpa),
        float(face.weights_mm2[state.contact_mpa > 0].sum()),
        np.column_stack([state.shift_mm, turn]),
    )


def collected_press(
    setting: PressSetting,
    material: Hyperelastic,
    rows: list[PressRow],
    state: PressState,
    wanted_mm: float,
) -> LargeStrainPress:
    small = linear_press(setting, np.array([row.depth_mm for row in rows]))
    linear = small.rows
    return LargeStrainPress(
        face=setting.frame.number,
        x_mm=float(setting.xy_mm[0]),
        y_mm=float(setting.xy_mm[1]),
        material=material,
        depth_mm=_column("depth_mm", rows),
        force_n=_column("force_n", rows),
        linear_force_n=_column("force_n", linear),
        contact_area_mm2=_column("contact_area_mm2", rows),
        linear_contact_area_mm2=_column("contact_area_mm2", linear),
        motion=_column("motion", rows),
        linear_motion=_column("motion", linear),
        status="converged" if rows[-1].depth_mm >= wanted_mm else "diverged",
        shape=deformed_shape(
            setting.mesh,
            setting.system.space,
            state.displacement_mm,
            state.pressure_mpa,
            vertices_under_the_tip(setting, state.contact_mpa),
        ),
        linear_shape=shape_of_unknowns(
            setting.system,
            setting.mesh,
            small.unknowns,
            vertices_under_the_tip(setting, small.contact_mpa),
        ),
    )


def _column(name: str, rows: list[PressRow]) -> np.ndarray:
    return np.array([getattr(row, name) for row in rows], float)


def vertices_under_the_tip(setting: PressSetting, contact_mpa: np.ndarray) -> FacePressure:
    vertices = face_vertices(setting.system, setting.spec, setting.frame.number)
    pressure = np.zeros(len(vertices))
    pressure[setting.near] = contact_mpa
    return FacePressure(vertices, pressure)

"""Presses of the hemisphere with large deformation, beside small strain on the same mesh."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
import scipy.sparse as sp
from jaxtyping import Float, Int
from scipy.spatial.transform import Rotation

from design.errors import InputError
from design.layouts import FaceFrame, face_frames, magnet_layout
from design.spec import ObjectSpec
from fem.contact import contact_pressures
from fem.factorization import solve_symmetric
from fem.finite_strain import finite_strain_elements
from fem.hyperelastic import Hyperelastic
from fem.large_strain_newton import (
    PressProblem,
    PressState,
    StepDivergedError,
    equilibrium,
    undeformed,
)
from fem.magnets import magnet_of_nodes, mean_motion_functionals
from fem.material import LameConstants, lame_constants
from fem.presses import profile_moments_mm3, surface_weights_mm2
from fem.response import ElasticSystem, FaceSurface, elastic_system, face_facets, face_surface
from fem.sphere_contact import contact_face, contact_state, normal_force_n
from fem.tet_mesh import TetMesh

Progress = Callable[[str], None]

_LARGEST_STEP_MM = 0.5
_SMALLEST_STEP_MM = 0.02
_MODULUS_TOLERANCE = 0.01


@dataclass(frozen=True)
class DeformedShape:
    """Quadratic tetrahedra of the silicone (corners, then edges 01 12 02 03 13 23) at one depth."""

    nodes_mm: Float[np.ndarray, "node 3"]
    tets: Int[np.ndarray, "tet 10"]
    displacement_mm: Float[np.ndarray, "node 3"]
    pressure_mpa: Float[np.ndarray, "node"]


@dataclass(frozen=True)
class LargeStrainPress:
    """One press at increasing depths: large deformation, and small strain on the same mesh.

    Areas are of the undeformed face. `motion` is the displacement of each magnet's centre (mm) and
    its rotation vector (rad) in the object's frame. `status` is "converged", or "diverged" where
    a deeper press was asked for; then the last depth is the last converged one.
    """

    face: int
    x_mm: float
    y_mm: float
    material: Hyperelastic
    depth_mm: Float[np.ndarray, "step"]
    force_n: Float[np.ndarray, "step"]
    linear_force_n: Float[np.ndarray, "step"]
    contact_area_mm2: Float[np.ndarray, "step"]
    linear_contact_area_mm2: Float[np.ndarray, "step"]
    motion: Float[np.ndarray, "step magnet 6"]
    linear_motion: Float[np.ndarray, "step magnet 6"]
    status: str
    shape: DeformedShape


@dataclass(frozen=True)
class LinearityLimits:
    """Depths (mm) at which linear and nonlinear force differ by 5 % and 20 %; None: not reached."""

    five_percent_mm: float | None
    twenty_percent_mm: float | None


@dataclass(frozen=True)
class _Setting:
    """Everything that both models share: the body, the face's frame and its candidates."""

    spec: ObjectSpec
    system: ElasticSystem
    mesh: TetMesh
    frame: FaceFrame
    surface: FaceSurface
    moments: sp.csc_matrix
    xy_mm: Float[np.ndarray, "2"]
    near: Int[np.ndarray, "candidate"]
    problem: PressProblem

    @property
    def rigid(self) -> bool:
        return self.spec.mechanics.magnets == "rigid"


@dataclass(frozen=True)
class _Row:
    """What one depth gives."""

    depth_mm: float
    force_n: float
    contact_area_mm2: float
    motion: Float[np.ndarray, "magnet 6"]


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
    """Press one place of a face to each depth with large deformation, and linearly beside it.

    The linear model has the material's modulus at small strain. Depths increase; between them
    load steps are halved where Newton's method diverges, down to 0.02 mm, and the press ends
    there with the depths so far. A mean rotation stands for the magnets' where they are points.

    Raises
    ------
    InputError
        An unknown face, a tip beyond the face's border, depths that do not increase or reach the
        tip's radius, or a material whose modulus is not the specification's.
    """
    _require_press(spec, face, x_mm, y_mm, depths_mm)
    _require_modulus(spec, material)
    setting = _setting(spec, mesh, face, np.array([x_mm, y_mm]), material)
    rows: list[_Row] = []
    state = undeformed(setting.problem)
    for depth, state in _converged_states(setting, depths_mm, progress or _silent):
        rows.append(_row(setting, depth, state))
    return _collected(setting, material, rows, state, depths_mm[-1])


def linearity_limits(press: LargeStrainPress) -> LinearityLimits:
    """Depths at which the linear force is first 5 % and 20 % off the nonlinear one.

    Shares are of the nonlinear force; depths are interpolated, from agreement at depth 0.
    """
    touched = (press.force_n > 0) & (press.linear_force_n > 0)
    depth = np.append(0, press.depth_mm[touched])
    off = np.append(0, abs(1 - press.linear_force_n[touched] / press.force_n[touched]))
    return LinearityLimits(_first_crossing(depth, off, 0.05), _first_crossing(depth, off, 0.20))


def _first_crossing(depth: np.ndarray, off: np.ndarray, share: float) -> float | None:
    above = np.flatnonzero(off >= share)
    if not len(above):
        return None
    last = above[0]
    part = (share - off[last - 1]) / (off[last] - off[last - 1])
    return float(depth[last - 1] + part * (depth[last] - depth[last - 1]))


def _setting(
    spec: ObjectSpec, mesh: TetMesh, face: int, xy_mm: np.ndarray, material: Hyperelastic
) -> _Setting:
    frame = next(frame for frame in face_frames(spec) if frame.number == face)
    system = elastic_system(mesh, _with_modulus_of(spec, material))
    facets = face_facets(system.mesh, spec, frame)
    surface, moments = face_surface(system.mesh, facets, frame)
    radius = spec.indenter.radius_mm
    near = np.flatnonzero(np.linalg.norm(surface.xy_mm - xy_mm, axis=1) < radius)
    problem = _problem(spec, mesh, system, material, frame, facets, near)
    return _Setting(spec, system, mesh, frame, surface, moments, xy_mm, near, problem)


def _problem(
    spec: ObjectSpec,
    mesh: TetMesh,
    system: ElasticSystem,
    material: Hyperelastic,
    frame: FaceFrame,
    facets: np.ndarray,
    near: np.ndarray,
) -> PressProblem:
    space = system.space
    rigid = spec.mechanics.magnets == "rigid"
    owner = magnet_of_nodes(mesh, space) if rigid else np.full(space.node_count, -1)
    moved = np.diff(system.motion_basis.indptr)[: space.node_count] > 0
    vertices = np.unique(np.asarray(system.mesh.facets)[:, facets])[near]
    pressure_nodes = space.pressure_nodes
    return PressProblem(
        finite_strain_elements(space),
        material,
        _lame(spec, material).inverse_lambda_per_mpa,
        system.operators.compressibility[pressure_nodes][:, pressure_nodes],
        space.nodes_mm,
        moved & (owner < 0),
        owner,
        magnet_layout(spec).centre_mm if rigid else np.zeros((0, 3)),
        contact_face(system.mesh, facets, vertices, frame),
        spec.indenter.radius_mm,
    )


def _converged_states(
    setting: _Setting, depths_mm: Sequence[float], progress: Progress
) -> Iterator[tuple[float, PressState]]:
    """Equilibrium at each depth; where a load step cannot be halved further, the last one found."""
    state, reached, step = undeformed(setting.problem), 0.0, _LARGEST_STEP_MM
    for depth in depths_mm:
        while reached < depth:
            target = min(depth, reached + step)
            try:
                state = equilibrium(setting.problem, state, _sphere_centre(setting, target))
            except StepDivergedError as error:
                step = (target - reached) / 2
                progress(f"{target:.3g} mm: {error}; the load step is halved")
                if step < _SMALLEST_STEP_MM:
                    yield reached, state
                    return
                continue
            reached, step = target, min(2 * step, _LARGEST_STEP_MM)
            progress(f"{reached:.3g} of {depths_mm[-1]:.3g} mm")
        yield depth, state


def _sphere_centre(setting: _Setting, depth_mm: float) -> np.ndarray:
    radius = setting.spec.indenter.radius_mm
    return np.asarray(setting.frame.to_object(np.append(setting.xy_mm, radius - depth_mm)))


def _row(setting: _Setting, depth_mm: float, state: PressState) -> _Row:
    problem, face = setting.problem, setting.problem.face
    centre = _sphere_centre(setting, depth_mm)
    contact = contact_state(face, state.displacement_mm, centre, problem.radius_mm)
    if setting.rigid:
        turn = Rotation.from_matrix(state.rotation).as_rotvec()
        motion = np.column_stack([state.shift_mm, turn])
    else:
        functionals = mean_motion_functionals(setting.mesh, setting.system.space)
        motion = (functionals @ state.displacement_mm).reshape(-1, 6)
    return _Row(
        depth_mm,
        normal_force_n(face, contact, state.contact_mpa),
        float(face.weights_mm2[state.contact_mpa > 0].sum()),
        motion,
    )


def _collected(
    setting: _Setting,
    material: Hyperelastic,
    rows: list[_Row],
    state: PressState,
    wanted_mm: float,
) -> LargeStrainPress:
    linear = _linear_rows(setting, np.array([row.depth_mm for row in rows]))

    def column(name: str, of: list[_Row]) -> np.ndarray:
        return np.array([getattr(row, name) for row in of])

    return LargeStrainPress(
        setting.frame.number,
        *(float(value) for value in setting.xy_mm),
        material,
        column("depth_mm", rows),
        column("force_n", rows),
        column("force_n", linear),
        column("contact_area_mm2", rows),
        column("contact_area_mm2", linear),
        column("motion", rows),
        column("motion", linear),
        "converged" if rows[-1].depth_mm >= wanted_mm else "diverged",
        _shape(setting, state),
    )


def _linear_rows(setting: _Setting, depths_mm: np.ndarray) -> list[_Row]:
    """The same press with small strain: contact as in `fem.presses`, on these candidates only."""
    system, near = setting.system, setting.near
    tractions = sp.vstack([-part * setting.moments[:, near] for part in setting.frame.normal])
    loads = system.motion_basis.T @ tractions
    padded = np.zeros((system.matrix.shape[0], len(near)))
    padded[: loads.shape[0]] = loads.toarray()
    motions = solve_symmetric(system.matrix, padded)[: loads.shape[0]]
    compliance = loads.T @ motions
    weights = surface_weights_mm2(setting.surface)[near]
    radius = setting.spec.indenter.radius_mm
    profile = profile_moments_mm3(setting.surface, setting.xy_mm[None], radius)[0, near]
    pressures = contact_pressures((compliance + compliance.T) / 2, profile, weights, depths_mm)
    magnets = len(magnet_layout(setting.spec).face)
    if setting.rigid:
        moved = motions[-6 * magnets :]
    else:
        functionals = mean_motion_functionals(setting.mesh, system.space)
        moved = functionals @ (system.motion_basis @ motions)
    return [
        _Row(
            float(depth),
            float(pressure @ weights),
            float(weights[pressure > 0].sum()),
            (moved @ pressure).reshape(magnets, 6),
        )
        for depth, pressure in zip(depths_mm, pressures, strict=True)
    ]


def _shape(setting: _Setting, state: PressState) -> DeformedShape:
    """Deformed silicone with pressures at mid-edge nodes halfway between the corners'."""
    space = setting.system.space
    used = space.displacement.element_dofs.T
    nodes, tets = np.unique(used, return_inverse=True)
    tets = tets.reshape(used.shape)
    pressure = np.zeros(len(nodes))
    corner = state.pressure_mpa[setting.problem.elements.pressure_nodes]
    pressure[tets[:, :4]] = corner
    for node, (a, b) in enumerate(((0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3)), start=4):
        pressure[tets[:, node]] = (corner[:, a] + corner[:, b]) / 2
    displacement = state.displacement_mm.reshape(3, -1).T
    return DeformedShape(space.nodes_mm[nodes], tets, displacement[nodes], pressure)


def _lame(spec: ObjectSpec, material: Hyperelastic) -> LameConstants:
    nu = spec.silicone.poisson_ratio
    return lame_constants(2 * (1 + nu) * material.shear_modulus_mpa, nu)


def _with_modulus_of(spec: ObjectSpec, material: Hyperelastic) -> ObjectSpec:
    modulus = 2 * (1 + spec.silicone.poisson_ratio) * material.shear_modulus_mpa
    silicone = spec.silicone.model_copy(update={"youngs_modulus_mpa": modulus})
    return spec.model_copy(update={"silicone": silicone})


def _require_modulus(spec: ObjectSpec, material: Hyperelastic) -> None:
    silicone = spec.silicone
    own = 2 * (1 + silicone.poisson_ratio) * material.shear_modulus_mpa
    if abs(own / silicone.youngs_modulus_mpa - 1) > _MODULUS_TOLERANCE:
        raise InputError(
            f"the {material.name} constants give E = {own:.4g} MPa at small strain, but "
            f"silicone.youngs_modulus_mpa is {silicone.youngs_modulus_mpa:g}. Set it to {own:.4g}, or "
            "scale the constants"
        )


def _require_press(
    spec: ObjectSpec, face: int, x_mm: float, y_mm: float, depths_mm: Sequence[float]
) -> None:
    frames = {frame.number: frame for frame in face_frames(spec)}
    if face not in frames:
        raise InputError(f"face {face} is not sensed. Choose one of {sorted(frames)}")
    radius = spec.indenter.radius_mm
    half_x, half_y = frames[face].half_extents_mm
    if abs(x_mm) + radius > half_x or abs(y_mm) + radius > half_y:
        raise InputError(
            f"a tip of radius {radius:g} mm at ({x_mm:g}, {y_mm:g}) mm hangs over the border of face "
            f"{face} (±{half_x:g}, ±{half_y:g} mm). Move the press inwards or use a smaller indenter"
        )
    depths = np.asarray(depths_mm, float)
    increasing = len(depths) > 0 and depths[0] > 0 and (np.diff(depths) > 0).all()
    if not increasing or depths[-1] >= min(radius, spec.shell.thickness_mm):
        raise InputError(
            "depths must increase from above 0 and stay below the tip's radius and the shell's "
            f"thickness ({min(radius, spec.shell.thickness_mm):g} mm); got {list(depths_mm)}"
        )


def _silent(_: str) -> None:
    pass

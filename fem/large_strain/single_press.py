"""One press of the hemisphere on its own mesh: what both models share, and small strain."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import cast

import numpy as np
import scipy.sparse as sp
from jaxtyping import Float, Int

from design.body.surface_chart import FaceFrame
from design.errors import InputError
from design.layout.body import face_frames
from design.layout.dents import dents_mm
from design.layout.places.positions import shell_body_layout
from design.spec.object import ObjectSpec
from fem.contact.complementarity import contact_pressures
from fem.large_strain.elements import finite_strain_elements
from fem.large_strain.hyperelastic import Hyperelastic
from fem.large_strain.newton import PressProblem
from fem.large_strain.sphere_contact import contact_face
from fem.linear.elements import TaylorHood
from fem.linear.factorization import solve_symmetric
from fem.linear.magnets import magnet_of_nodes
from fem.linear.material import LameConstants, lame_constants
from fem.linear.response import (
    ElasticSystem,
    FaceSurface,
    elastic_system,
    face_facets,
    face_surface,
)
from fem.linear.sparse import shape_of
from fem.mesh.tetrahedra import TetMesh
from fem.presses.table import profile_moments_mm3, surface_weights_mm2

_MODULUS_TOLERANCE = 0.01
"""Relative difference of the solid's modulus from the specification's that counts as another one."""


@dataclass(frozen=True)
class PressSetting:
    """The body, the pressed face (its contact candidates `near` the tip), and the large-strain problem.

    `moments` are ∫ φ_i v dA of P1 pressures against P2 nodes (node, vertex).
    """

    spec: ObjectSpec
    system: ElasticSystem
    mesh: TetMesh
    frame: FaceFrame
    surface: FaceSurface
    moments: sp.csc_matrix
    xy_mm: Float[np.ndarray, "2"]
    near: Int[np.ndarray, "candidate"]
    problem: PressProblem


@dataclass(frozen=True)
class PressRow:
    """Result of one depth; the area is of the undeformed face."""

    depth_mm: float
    force_n: float
    contact_area_mm2: float
    motion: Float[np.ndarray, "magnet 6"]


@dataclass(frozen=True)
class LinearPress:
    """Small strain at all depths; unknowns and contact pressures (MPa) of the last one."""

    rows: list[PressRow]
    unknowns: Float[np.ndarray, "unknown"]
    contact_mpa: Float[np.ndarray, "candidate"]


def press_setting(
    spec: ObjectSpec,
    mesh: TetMesh,
    face: int,
    xy_mm: Float[np.ndarray, "2"],
    material: Hyperelastic,
) -> PressSetting:
    """Assemble the body with the material's modulus at small strain, for a tip at (x, y).

    The specification has passed `require_press`.
    """
    frame = next(frame for frame in face_frames(spec) if frame.number == face)
    system = elastic_system(mesh, with_modulus_of(spec, material))
    facets = face_facets(system.mesh, spec, frame)
    surface, moments = face_surface(system.space, facets, frame)
    radius = spec.indenter.radius_mm
    near = np.flatnonzero(np.linalg.norm(surface.xy_mm - xy_mm, axis=1) < radius)
    problem = press_problem(spec, mesh, system, material, frame, facets, near)
    return PressSetting(spec, system, mesh, frame, surface, moments, xy_mm, near, problem)


def sphere_centre_mm(setting: PressSetting, depth_mm: float) -> Float[np.ndarray, "3"]:
    """Centre of the tip when it is pressed to a depth, in the object's frame."""
    radius = setting.spec.indenter.radius_mm
    return np.asarray(setting.frame.to_object(np.append(setting.xy_mm, radius - depth_mm)))


def linear_press(setting: PressSetting, depths_mm: Float[np.ndarray, "step"]) -> LinearPress:
    """The same press with small strain: contact as in `fem.presses.table`, on these candidates only."""
    system, near = setting.system, setting.near
    tractions = sp.vstack([-part * setting.moments[:, near] for part in setting.frame.normal])
    loads = (system.motion_basis.T @ tractions).toarray()
    no_pressure = np.zeros((shape_of(system.matrix)[0] - len(loads), len(near)))
    solution = solve_symmetric(system.matrix, np.vstack([loads, no_pressure]))
    motions = solution[: len(loads)]
    compliance = loads.T @ motions
    weights = surface_weights_mm2(setting.surface)[near]
    radius = setting.spec.indenter.radius_mm
    profile = profile_moments_mm3(setting.surface, setting.xy_mm[None], radius)[0, near]
    pressures = contact_pressures((compliance + compliance.T) / 2, profile, weights, depths_mm)
    magnets = setting.mesh.magnets
    moved = motions[len(motions) - 6 * magnets :]
    rows = [
        PressRow(
            float(depth),
            float(pressure @ weights),
            float(weights[pressure > 0].sum()),
            (moved @ pressure).reshape(magnets, 6),
        )
        for depth, pressure in zip(depths_mm, pressures, strict=True)
    ]
    return LinearPress(rows, solution @ pressures[-1], pressures[-1])


def require_modulus(spec: ObjectSpec, material: Hyperelastic) -> None:
    """Raise InputError where the material at small strain is not the specification's, to 1 %."""
    silicone = spec.silicone
    modulus_mpa = 2 * (1 + silicone.poisson_ratio) * material.shear_modulus_mpa
    if abs(modulus_mpa / silicone.youngs_modulus_mpa - 1) > _MODULUS_TOLERANCE:
        raise InputError(
            f"the {material.name} constants give E = {modulus_mpa:.4g} MPa at small strain, but "
            f"silicone.youngs_modulus_mpa is {silicone.youngs_modulus_mpa:g}. Set it to {modulus_mpa:.4g}, "
            "or scale the constants"
        )


def _require_hemisphere(spec: ObjectSpec) -> None:
    indenter = spec.indenter
    if not indenter.is_one_plain_ball:
        raise InputError(
            "large deformation presses one hemisphere, rigid, straight and without friction; got "
            f"indenter.kind = {indenter.kind!r}, tip_count = {indenter.tip_count}, direction_deg = "
            f"{list(indenter.direction_deg)}, friction = {indenter.friction!r}, pad = "
            f"{list(indenter.pad)}. Set them back, or use "
            "small strain: `instobj press --material linear`, mechanics.correction = 'none'"
        )


def require_press(
    spec: ObjectSpec, face: int, x_mm: float, y_mm: float, depths_mm: Sequence[float]
) -> None:
    """Raise InputError for another element, core or indenter, an unknown or curved face, a tip over
    the border, or bad depths."""
    _require_hemisphere(spec)
    if spec.mechanics.element != "taylor-hood":
        raise InputError(
            "presses with large deformation need the Taylor–Hood element; mechanics.element is "
            f'"{spec.mechanics.element}". Set mechanics.element = "taylor-hood"'
        )
    _require_bonded(spec)
    if dents_mm(spec).any():
        raise InputError(
            "dents of the seals (as_built) are known at small strain only. Press with "
            "small strain: `instobj press --material linear`, or set them to 0"
        )
    frames = {frame.number: frame for frame in face_frames(spec)}
    if face not in frames:
        raise InputError(f"face {face} is not sensed. Choose one of {sorted(frames)}")
    if not frames[face].flat:
        raise InputError(
            f"large deformation is known on flat faces only; face {face} is curved. Press with small "
            "strain: `instobj press --material linear`"
        )
    radius = spec.indenter.radius_mm
    half_x, half_y = frames[face].half_extents_mm
    if not (abs(x_mm) + radius <= half_x and abs(y_mm) + radius <= half_y):
        raise InputError(
            f"a tip of radius {radius:g} mm at ({x_mm:g}, {y_mm:g}) mm hangs over the border of face "
            f"{face} (±{half_x:g}, ±{half_y:g} mm). Move the press inwards or use a smaller indenter"
        )
    depths = np.asarray(depths_mm, float)
    increasing = len(depths) > 0 and depths[0] > 0 and (np.diff(depths) > 0).all()
    if not (increasing and depths[-1] < min(radius, spec.shell.thickness_mm)):
        raise InputError(
            "depths must increase from above 0 and stay below the tip's radius and the shell's "
            f"thickness ({min(radius, spec.shell.thickness_mm):g} mm); got {list(depths_mm)}"
        )


def _require_bonded(spec: ObjectSpec) -> None:
    mechanics = spec.mechanics
    if mechanics.interface != "bonded":
        raise InputError(
            "presses with large deformation need a bonded core; got mechanics.interface = "
            f"{mechanics.interface!r}. Set it to 'bonded'"
        )
    if mechanics.slip.slipped:
        raise InputError(
            "presses with large deformation do not know a core that has slipped. Set "
            "mechanics.slip.shift_mm and rotation_deg to zeros"
        )


def press_problem(
    spec: ObjectSpec,
    mesh: TetMesh,
    system: ElasticSystem,
    material: Hyperelastic,
    frame: FaceFrame,
    facets: np.ndarray,
    near: np.ndarray,
) -> PressProblem:
    space = system.space
    owner = magnet_of_nodes(mesh, space)
    moved = np.diff(system.motion_basis.indptr)[: space.node_count] > 0
    vertices = np.unique(np.asarray(system.mesh.facets)[:, facets])[near]
    pressure_nodes = space.pressure_nodes
    return PressProblem(
        finite_strain_elements(cast(TaylorHood, space)),
        material,
        lame_of(spec, material).inverse_lambda_per_mpa,
        system.operators.compressibility[pressure_nodes][:, pressure_nodes],
        space.nodes_mm,
        moved & (owner < 0),
        owner,
        shell_body_layout(spec).centre_mm[: mesh.magnets],
        contact_face(system.mesh, facets, vertices, frame),
        spec.indenter.radius_mm,
    )


def lame_of(spec: ObjectSpec, material: Hyperelastic) -> LameConstants:
    nu = spec.silicone.poisson_ratio
    return lame_constants(2 * (1 + nu) * material.shear_modulus_mpa, nu)


def with_modulus_of(spec: ObjectSpec, material: Hyperelastic) -> ObjectSpec:
    modulus = 2 * (1 + spec.silicone.poisson_ratio) * material.shear_modulus_mpa
    silicone = spec.silicone.changed(youngs_modulus_mpa=modulus, youngs_modulus_range_mpa=None)
    return spec.changed(silicone=silicone)

"""Blocks, presses on them and prescribed stretches that tests of large deformation share."""

from dataclasses import dataclass, replace

import numpy as np
import scipy.sparse as sp

from design.body.surface_chart import FaceFrame
from fem.contact.complementarity import contact_pressures
from fem.large_strain import newton
from fem.large_strain.elements import (
    deformation_gradients,
    finite_strain_elements,
    internal_forces,
    tangent_blocks,
)
from fem.large_strain.hyperelastic import neo_hookean, ogden, yeoh
from fem.large_strain.newton import PressProblem, equilibrium, motion_basis, undeformed
from fem.large_strain.sphere_contact import contact_face, contact_state, normal_force_n
from fem.linear.elements import (
    MixedOperators,
    TaylorHood,
    assemble,
    saddle_point_matrix,
    taylor_hood,
)
from fem.linear.factorization import solve_symmetric
from fem.linear.magnets import magnet_of_nodes
from fem.linear.material import lame_constants
from fem.linear.response import face_surface
from fem.mesh.tetrahedra import TetMesh
from fem.presses.table import profile_moments_mm3, surface_weights_mm2
from tests.support.mechanics.fem_cases import box_mesh, component_basis

E_MPA, NU = 0.3, 0.4999
MATERIALS = [
    neo_hookean(E_MPA, NU),
    yeoh(0.05, -0.004, 0.002),
    ogden((0.08, -0.02, 0.01), (1.5, -2.0, 4.0)),
]
BLOCK_MM = (12.0, 10.0, 6.0)
PLACE_MM = (5.3, 4.6)


@dataclass(frozen=True)
class Block:
    """A block held below with one magnet in it, and a sphere over its top, in both models."""

    problem: PressProblem
    space: TaylorHood
    weights: np.ndarray
    moments: sp.csr_matrix
    profile: np.ndarray

    def centre(self, depth_mm):
        return np.array([*PLACE_MM, BLOCK_MM[2] + self.problem.radius_mm - depth_mm])

    def linear_force(self, depth_mm):
        """Small strain, with the contact of `fem.contact.complementarity`, on the same mesh."""
        basis = motion_basis(self.problem, undeformed(self.problem).rotation)
        operators = assemble(self.space, lame_constants(E_MPA, NU))
        matrix = saddle_point_matrix(operators, basis, self.space.pressure_nodes)
        empty = sp.csr_matrix((2 * self.space.node_count, len(self.weights)))
        loads = (basis.T @ sp.vstack([empty, -self.moments])).toarray()
        padded = np.zeros((matrix.shape[0], len(self.weights)))
        padded[: len(loads)] = loads
        compliance = loads.T @ solve_symmetric(matrix, padded)[: len(loads)]
        depths = np.array([depth_mm])
        pressures = contact_pressures(compliance, self.profile, self.weights, depths)
        return float(pressures[0] @ self.weights)


def block(cells=(8, 7, 4), radius_mm=5.0, material=MATERIALS[0], magnet=True):
    """BLOCK_MM of silicone; the magnet is a box off the axis of the press, 1.5 mm below the top."""
    mesh = box_mesh(cells, BLOCK_MM, jiggle=0.1)
    centroid = mesh.p[:, mesh.t].mean(axis=1).T
    low, high = np.array([6.0, 4.3, 2.9]), np.array([9.1, 7.2, 4.6])
    inside = np.all((centroid > low) & (centroid < high), axis=1) & magnet
    tets = TetMesh(mesh.p.T.copy(), mesh.t.T.astype(int), np.where(inside, 0, -1))
    space = taylor_hood(mesh, np.flatnonzero(~inside))
    owner = magnet_of_nodes(tets, space)
    held = space.nodes_mm[:, 2] < 1e-9
    frame = FaceFrame(1, *np.eye(3)[[2, 0, 1]], np.array([0, 0, BLOCK_MM[2]]), BLOCK_MM[:2])
    facets = mesh.facets_satisfying(lambda x: abs(x[2] - BLOCK_MM[2]) < 1e-9, True)
    surface, moments = face_surface(space, facets, frame)
    near = np.flatnonzero(np.linalg.norm(surface.xy_mm - PLACE_MM, axis=1) < 5.0)
    vertices = np.unique(mesh.facets[:, facets])[near]
    operators = assemble(space, lame_constants(E_MPA, NU))
    nodes = space.pressure_nodes
    problem = PressProblem(
        finite_strain_elements(space),
        material,
        lame_constants(E_MPA, NU).inverse_lambda_per_mpa,
        operators.compressibility[nodes][:, nodes],
        space.nodes_mm,
        space.elastic_nodes & ~held & (owner < 0),
        owner,
        np.array([[7.5, 5.7, 3.75]]) if magnet else np.zeros((0, 3)),
        contact_face(mesh, facets, vertices, frame),
        radius_mm,
    )
    weights = surface_weights_mm2(surface)[near]
    profile = profile_moments_mm3(surface, np.array([PLACE_MM]), radius_mm)[0, near]
    return Block(problem, space, weights, moments[:, near], profile)


def large_strain_force(setup, depth_mm, scale=1.0):
    """Force (N) of the large-deformation model from rest, all moduli taken `scale` times."""
    problem = replace(
        setup.problem,
        inverse_lambda_per_mpa=setup.problem.inverse_lambda_per_mpa * scale,
        compressibility=setup.problem.compressibility * scale,
    )
    centre = setup.centre(depth_mm)
    state = equilibrium(problem, undeformed(problem), centre)
    contact = contact_state(problem.face, state.displacement_mm, centre, problem.radius_mm)
    return scale * normal_force_n(problem.face, contact, state.contact_mpa)


def stretch(space, material, inverse_lambda, free, prescribed_mm, steps):
    """Displacements (3, node) and pressures: `prescribed_mm` where not `free`, in load steps."""
    elements = finite_strain_elements(space)
    basis = component_basis(free)
    mass = assemble(space, lame_constants(1.0, 0.3)).compressibility
    mass = mass[space.pressure_nodes][:, space.pressure_nodes]
    mass = mass * (inverse_lambda / lame_constants(1.0, 0.3).inverse_lambda_per_mpa)
    u, p = np.zeros(3 * space.node_count), np.zeros(elements.pressure_count)
    for part in np.linspace(0, 1, steps + 1)[1:]:
        jump = np.where(free, 0, part * prescribed_mm - u.reshape(3, -1)).ravel()
        for _ in range(12):
            forces = internal_forces(elements, material, inverse_lambda, u, p)
            blocks = tangent_blocks(elements, material, u, p)
            right = np.concatenate(
                [
                    basis.T @ (forces.nodal_n + blocks.stiffness @ jump),
                    forces.volume_mm3 + blocks.divergence @ jump,
                ]
            )
            if abs(right).max() < 1e-11:
                break
            operators = MixedOperators(blocks.stiffness, blocks.divergence, mass)
            matrix = saddle_point_matrix(operators, basis, np.arange(len(p)))
            step = solve_symmetric(matrix, -right[:, None])[:, 0]
            u = u + jump + basis @ step[: basis.shape[1]]
            p, jump = p + step[basis.shape[1] :], 0 * jump
    return u, p, internal_forces(elements, material, inverse_lambda, u, p)


def energy_density(material, deformation):
    """W (MPa) as its formula stands in `fem.large_strain.hyperelastic`, from the principal stretches."""
    stretches = np.linalg.svd(deformation, compute_uv=False)
    log_volume = np.log(stretches).sum(axis=-1)
    invariant = (stretches**2).sum(axis=-1) - 3 - 2 * log_volume
    energy = np.zeros_like(log_volume)
    for power, coefficient in enumerate(material.invariant_coefficients_mpa, start=1):
        energy += coefficient * invariant**power
    for mu, alpha in material.ogden_terms:
        energy += mu / alpha * ((stretches**alpha).sum(axis=-1) - 3 - alpha * log_volume)
    return energy


def potential_energy_n_mm(
    elements, material, inverse_lambda_per_mpa, displacement_mm, pressure_mpa
):
    """∫ W − p (J − 1) − p²/(2λ): at equilibrium, the strain energy stored."""
    deformation = deformation_gradients(elements, displacement_mm)
    pressure = pressure_mpa[elements.pressure_nodes] @ elements.hats.T
    density = energy_density(material, deformation)
    density -= pressure * (np.linalg.det(deformation) - 1)
    density -= inverse_lambda_per_mpa * pressure**2 / 2
    return float((elements.weights_mm3 * density).sum())


def tangent_matrix(problem, state, sphere_centre_mm):
    """The derivative that Newton's steps use, by (q, p) at fixed contact pressures."""
    return newton.tangent_matrix(problem, state, newton.forces_of(problem, state, sphere_centre_mm))

"""Meshes, loads and closed forms that several tests of mechanics share."""

from dataclasses import dataclass, replace

import numpy as np
import scipy.sparse as sp
from skfem import FacetBasis, LinearForm, MeshTet

from design.body.surface_chart import FaceFrame
from design.layout.body import face_frames
from design.layout.places.contact_grid import press_lattice
from design.spec.object import MeshSpec, ObjectSpec, PressSpec, SiliconeSpec
from fem.contact.complementarity import contact_pressures
from fem.linear.elements import MixedOperators, assemble, saddle_point_matrix, taylor_hood
from fem.linear.factorization import compliance_of_loads, solve_symmetric
from fem.linear.material import lame_constants
from fem.linear.response import face_surface
from fem.mesh.tetrahedra import SILICONE
from fem.presses.table import press_places, profile_moments_mm3, surface_weights_mm2
from tests.support.mechanics.kept_factors import solve_with_kept_factor

YOUNGS_MODULUS_MPA = 0.3
COARSE_EDGES_MM = (2.1, 6.0)
PATCH_RADIUS_MM = 5.0
DEPTHS_MM = np.array([0.5, 1.0, 2.0])
SHELL_COMPLIANCE_MM_PER_N = {0.49: 0.23170, 0.4999: 0.22621, 0.5: 0.22615}
"""Converged Taylor–Hood compliance of the patch load on the paper's shell without magnets."""


def paper_cube(edges_mm, poisson_ratio=0.4999):
    """The paper's cube in silicone of 0.3 MPa; `edges_mm` at the surface and in the bulk.

    Rims of magnets are as coarse as the silicone around them, which saves half of the unknowns.
    """
    return ObjectSpec(
        name="cube",
        silicone=SiliconeSpec(youngs_modulus_mpa=YOUNGS_MODULUS_MPA, poisson_ratio=poisson_ratio),
        mesh=MeshSpec(surface_edge_mm=edges_mm[0], edge_mm=edges_mm[1], rim_edge_ratio=1.0),
        press=PressSpec(depths_mm=tuple(DEPTHS_MM.tolist())),
    )


def all_silicone(mesh):
    """The same tetrahedra, magnets taken for silicone."""
    return replace(mesh, magnet=np.full_like(mesh.magnet, SILICONE))


def box_mesh(shape, size=(1.0, 1.0, 1.0), jiggle=0.0):
    """Structured tetrahedra of a box; `jiggle` moves inner vertices by that part of a cell."""
    axes = [np.linspace(0, edge, n + 1) for edge, n in zip(size, shape, strict=True)]
    mesh = MeshTet.init_tensor(*axes)
    points = mesh.p.copy()
    inner = np.all(
        [(p > 1e-9) & (p < edge - 1e-9) for p, edge in zip(points, size, strict=True)], 0
    )
    cell = np.array(size)[:, None] / np.array(shape)[:, None]
    shift = np.random.default_rng(7).uniform(-jiggle, jiggle, points.shape) * cell
    return MeshTet(points + shift * inner, mesh.t)


def component_basis(free):
    """u = T q with the displacement components `free` (3, node) as unknowns."""
    selections = []
    for mask in free:
        nodes = np.flatnonzero(mask)
        selections.append(
            sp.csr_matrix(
                (np.ones(len(nodes)), (nodes, np.arange(len(nodes)))), (len(mask), len(nodes))
            )
        )
    return sp.csr_matrix(sp.block_diag(selections))


@dataclass(frozen=True)
class MixedSolution:
    """Displacement (3, node) in mm and pressure at the vertices in MPa."""

    u_mm: np.ndarray
    pressure_mpa: np.ndarray


def solve_mixed(space, material, free, forces_n, prescribed_mm):
    """Displacements `prescribed_mm` (3, node) where not `free`, nodal forces elsewhere."""
    operators = assemble(space, material)
    basis = component_basis(free)
    known = np.where(free, 0, prescribed_mm).ravel()
    motions = basis.T @ (forces_n.ravel() - operators.stiffness @ known)
    pressures = -(operators.divergence @ known)[space.pressure_nodes]
    matrix = saddle_point_matrix(operators, basis, space.pressure_nodes)
    solution = solve_symmetric(matrix, np.concatenate([motions, pressures])[:, None])[:, 0]
    count = len(motions)
    u = (known + basis @ solution[:count]).reshape(3, -1)
    return MixedSolution(u, solution[count:])


def patch_loads(system, spec):
    """Nodal forces (3·node, face) of p = (1 − r²/25)² MPa at each face's centre, and totals (N)."""
    return _central_loads(
        system, spec, lambda r2: np.clip(1 - r2 / PATCH_RADIUS_MM**2, 0, None) ** 2
    )


def hertz_loads(system, spec):
    """The same for p = √(1 − r²/9) MPa, Hertz's pressure of radius 3 mm."""
    return _central_loads(system, spec, lambda r2: np.sqrt(np.clip(1 - r2 / 9, 0, None)))


def _central_loads(system, spec, pressure_mpa):
    mesh = system.mesh
    boundary = mesh.boundary_facets()
    centre = mesh.p[:, mesh.facets[:, boundary]].mean(axis=1).T
    forces, totals = [], []
    for frame in face_frames(spec):
        facets = boundary[abs(frame.from_object(centre)[:, 2]) < 0.1]
        nodal = _pressure_form(frame, pressure_mpa).assemble(
            FacetBasis(mesh, system.space.displacement.elem, facets=facets, intorder=8)
        )
        totals.append(nodal.sum())
        forces.append(np.concatenate([-component * nodal for component in frame.normal]))
    return np.array(forces).T, np.array(totals)


def _pressure_form(frame, pressure_mpa):
    @LinearForm
    def form(v, w):
        r2 = sum(np.einsum("i,i...->...", axis, w.x) ** 2 for axis in (frame.x, frame.y))
        return v * pressure_mpa(r2)

    return form


def with_poisson_ratio(system, before, after):
    """The same system for another ν: K scales with μ and C with 1/λ, B stays."""
    old, new = (lame_constants(YOUNGS_MODULUS_MPA, nu) for nu in (before, after))
    operators = MixedOperators(
        system.operators.stiffness * (new.shear_modulus_mpa / old.shear_modulus_mpa),
        system.operators.divergence,
        system.operators.compressibility
        * (new.inverse_lambda_per_mpa / old.inverse_lambda_per_mpa),
    )
    matrix = saddle_point_matrix(operators, system.motion_basis, system.space.pressure_nodes)
    return replace(system, operators=operators, matrix=matrix)


def patch_compliances(system, spec):
    """C = ∫ p u_n dA / F² of the patch load at the five face centres, mm/N, and p in the bulk."""
    forces, totals = patch_loads(system, spec)
    solution = solve_loads(system, forces)
    motions = system.motion_basis.shape[1]
    u = system.motion_basis @ solution[:motions]
    return np.einsum("nf,nf->f", forces, u) / totals**2, solution[motions:]


def solve_loads(system, nodal_forces):
    """Unknowns (q, p) of an `ElasticSystem` under nodal forces (3·node, load)."""
    motions = system.motion_basis.T @ nodal_forces
    pressures = np.zeros((system.matrix.shape[0] - len(motions), motions.shape[1]))
    return solve_with_kept_factor(system.matrix, np.vstack([motions, pressures]))


def graded_axis(cell, uniform_cells, growth, length):
    """0 … length: some equal cells, then cells that grow by the factor `growth`."""
    points, step = list(cell * np.arange(uniform_cells + 1)), cell
    while points[-1] < length:
        step *= growth
        points.append(points[-1] + step)
    points = np.array(points)
    graded = slice(uniform_cells, None)
    start = points[uniform_cells]
    points[graded] = start + (points[graded] - start) * (length - start) / (points[-1] - start)
    return points


def forces_on_quarter_block(poisson_ratio, radius_mm, depths_mm, plan, height, candidates_mm):
    """Force (N) of a sphere pressed on a block held below, by its quarter with mirror planes.

    `plan` and `height` are the coordinates of the mesh along x (and y), and below the surface.
    """
    mesh = MeshTet.init_tensor(plan, plan, -height[::-1])
    space = taylor_hood(mesh)
    held = space.nodes_mm[:, 2] < -height[-1] + 1e-9
    free = np.stack([*(space.nodes_mm[:, :2].T > 1e-9), np.ones_like(held)]).astype(bool) & ~held
    basis = component_basis(free)
    material = lame_constants(YOUNGS_MODULUS_MPA, poisson_ratio)
    matrix = saddle_point_matrix(assemble(space, material), basis, space.pressure_nodes)
    x, y, z = np.eye(3)
    frame = FaceFrame(1, z, x, y, np.zeros(3), (plan[-1], plan[-1]))
    facets = mesh.facets_satisfying(lambda x: abs(x[2]) < 1e-9, boundaries_only=True)
    surface, moments = face_surface(space, facets, frame)
    near = np.flatnonzero(np.linalg.norm(surface.xy_mm, axis=1) < candidates_mm)
    loads = basis.T @ sp.vstack(
        [sp.csr_matrix((2 * space.node_count, len(near))), -moments[:, near]]
    )
    empty = sp.csr_matrix((len(space.pressure_nodes), len(near)))
    condensed = compliance_of_loads(matrix, sp.csr_matrix(sp.vstack([loads, empty])))
    weights = surface_weights_mm2(surface)[near]
    profile = profile_moments_mm3(surface, np.zeros((1, 2)), radius_mm)[0, near]
    return 4 * contact_pressures(condensed.matrix, profile, weights, depths_mm) @ weights


def hertz_force_n(depth_mm, radius_mm, poisson_ratio):
    """F = 4/3 E* √R δ^(3/2) of a rigid sphere (paraboloid) on a half-space."""
    modulus = YOUNGS_MODULUS_MPA / (1 - poisson_ratio**2)
    return 4 / 3 * modulus * np.sqrt(radius_mm) * depth_mm**1.5


def dimitriadis_force_n(depth_mm, radius_mm, thickness_mm):
    """Sphere on a bonded incompressible layer: Dimitriadis et al., Biophys. J. 82 (2002) 2798."""
    chi = np.sqrt(radius_mm * depth_mm) / thickness_mm
    series = 1 + 1.133 * chi + 1.283 * chi**2 + 0.769 * chi**3 + 0.0975 * chi**4
    return 16 / 9 * YOUNGS_MODULUS_MPA * np.sqrt(radius_mm) * depth_mm**1.5 * series


def random_places(count, reach_mm):
    return np.random.default_rng(11).uniform(-reach_mm, reach_mm, (count, 2))


def forces_near_the_centre(spec, response, count):
    """Force (N) at random places within ±4 mm of every face's centre; (face, place, step)."""
    xy = random_places(count, 4.0)
    return np.array(
        [
            press_places(spec, response, index, xy, DEPTHS_MM) @ surface_weights_mm2(surface)
            for index, surface in enumerate(response.surfaces)
        ]
    )


def relative_mirror_difference(force_n, spec):
    """Root mean square over places of 2 (F − F mirrored)/(F + F mirrored) under x → −x."""
    nx, ny = press_lattice(spec).shape
    force = force_n.reshape(nx, ny, -1)
    mirrored = force[::-1]
    return np.sqrt(np.mean((2 * (force - mirrored) / (force + mirrored)) ** 2, axis=(0, 1)))

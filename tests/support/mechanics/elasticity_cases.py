"""Closed forms that the elements are held against: a smooth field, and Lamé's hollow sphere."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from skfem import Basis, ElementTetP1, FacetBasis, LinearForm, MeshTet, MeshTri

from fem.linear.elements import element_space
from fem.linear.material import lame_constants
from tests.support.mechanics.fem_cases import box_mesh, solve_mixed

GRADIENT = np.array([[0.3, -0.2, 0.5], [0.7, -0.4, 0.1], [-0.6, 0.8, 0.9]])
"""An asymmetric displacement gradient whose trace is not zero."""


ELEMENTS = ("taylor-hood", "p2-p0", "p2")
SIZE_MM = (1.0, 1.4, 0.7)

WAVE = np.array([1.0, 0.5, -1.2])


class SmoothField:
    """u = s + ∇sin(a·x)/λ with div s = 0: p = −λ div u = |a|² sin(a·x) for every ν.

    The body force balances it: f = −μ (Δu + ∇ div u) + ∇p.
    """

    def __init__(self, material):
        self.mu, self.kappa = material.shear_modulus_mpa, material.inverse_lambda_per_mpa

    def u(self, x):
        phase = np.einsum("i,i...->...", WAVE, x)
        solenoidal = np.array(
            [np.sin(x[1] + 2 * x[2]), np.cos(x[2] + 1.5 * x[0]), np.sin(x[0] - x[1])]
        )
        return solenoidal + self.kappa * np.einsum("i,...->i...", WAVE, np.cos(phase))

    def gradient(self, x):
        """g[i, j] = ∂_j u_i."""
        zero = 0 * x[0]
        first, second, third = x[1] + 2 * x[2], x[2] + 1.5 * x[0], x[0] - x[1]
        solenoidal = np.array(
            [
                [zero, np.cos(first), 2 * np.cos(first)],
                [-1.5 * np.sin(second), zero, -np.sin(second)],
                [np.cos(third), -np.cos(third), zero],
            ]
        )
        phase = np.einsum("i,i...->...", WAVE, x)
        return solenoidal - self.kappa * np.einsum("i,j,...->ij...", WAVE, WAVE, np.sin(phase))

    def pressure(self, x):
        return WAVE @ WAVE * np.sin(np.einsum("i,i...->...", WAVE, x))

    def force(self, x):
        phase = np.einsum("i,i...->...", WAVE, x)
        slope = WAVE @ WAVE * np.einsum("i,...->i...", WAVE, np.cos(phase))
        laplacian = [
            -5 * np.sin(x[1] + 2 * x[2]),
            -3.25 * np.cos(x[2] + 1.5 * x[0]),
            -2 * np.sin(x[0] - x[1]),
        ]
        return -self.mu * (np.array(laplacian) - 2 * self.kappa * slope) + slope

    def traction_on_x(self, x):
        """σ e_x, σ = 2μ ε − p I."""
        g = self.gradient(x)
        traction = self.mu * (g[:, 0] + g[0, :])
        traction[0] -= self.pressure(x)
        return traction


def nodal_forces(field, space):
    """Body force, and the traction on the face x = 1 (the others are prescribed)."""
    mesh, shape = space.mesh, space.displacement.elem
    volume = Basis(mesh, shape, intorder=6)
    facets = mesh.facets_satisfying(lambda x: abs(x[0] - 1) < 1e-9, boundaries_only=True)
    face = FacetBasis(mesh, shape, facets=facets, intorder=6)
    return np.array(
        [
            LinearForm(lambda v, w, i=i: field.force(w.x)[i] * v).assemble(volume)
            + LinearForm(lambda v, w, i=i: field.traction_on_x(w.x)[i] * v).assemble(face)
            for i in range(3)
        ]
    )


def errors_on(element, cells, poisson_ratio):
    """Errors (L2 of u, H1 seminorm of u, L2 of p if there is one) on a box of cells³ bricks."""
    mesh = box_mesh((cells, cells, cells))
    space, material = element_space(mesh, element), lame_constants(1.0, poisson_ratio)
    field = SmoothField(material)
    nodes = space.nodes_mm
    loose = (nodes > 1e-9).all(axis=1) & (nodes[:, 1:] < 1 - 1e-9).all(axis=1)
    solution = solve_mixed(
        space, material, np.tile(loose, (3, 1)), nodal_forces(field, space), field.u(nodes.T)
    )
    fine = Basis(mesh, space.displacement.elem, intorder=6)
    x = fine.global_coordinates()
    u: list[Any] = [fine.interpolate(component) for component in solution.u_mm]
    exact, slope = field.u(np.asarray(x)), field.gradient(np.asarray(x))
    l2 = sum(np.sum((np.asarray(u[i]) - exact[i]) ** 2 * fine.dx) for i in range(3))
    h1 = sum(np.sum((u[i].grad - slope[i]) ** 2 * fine.dx) for i in range(3))
    if not len(space.pressure_nodes):
        return np.sqrt([l2, h1])
    p = Basis(mesh, ElementTetP1(), intorder=6).interpolate(solution.pressure_mpa)
    pressure = np.sum((np.asarray(p) - field.pressure(np.asarray(x))) ** 2 * fine.dx)
    return np.sqrt([l2, h1, pressure])


def sphere_octant(inner, outer, division, layers):
    """Octant of a hollow sphere: spherical triangles × graded layers, prisms cut in three."""
    flat = MeshTri(np.array([[0.0, 1, 0], [0, 0, 1]]), np.array([[0], [1], [2]]))
    for _ in range(division):
        flat = flat.refined()
    barycentric = np.vstack([1 - flat.p.sum(axis=0), flat.p])
    unit = barycentric / np.linalg.norm(barycentric, axis=0)
    radii = np.geomspace(inner, outer, layers + 1)
    points = np.concatenate([radius * unit for radius in radii], axis=1)
    bottom = np.sort(flat.t, axis=0)
    count = unit.shape[1]
    tets = []
    for layer in range(layers):
        a, b = bottom + layer * count, bottom + (layer + 1) * count
        tets += [[a[0], a[1], a[2], b[2]], [a[0], a[1], b[1], b[2]], [a[0], b[0], b[1], b[2]]]
    return MeshTet(points, np.concatenate([np.array(t) for t in tets], axis=1))


def lame_radial_mm(r, inner, outer, pressure, modulus, nu):
    """Hollow sphere under internal pressure, free outside (Timoshenko & Goodier, art. 136)."""
    scale = pressure * inner**3 / (outer**3 - inner**3) / modulus
    return scale * ((1 - 2 * nu) * r + (1 + nu) * outer**3 / (2 * r**2))


@dataclass(frozen=True)
class RadialDisplacement:
    """Measured and exact radial displacement at the vertices, and the mesh's number of nodes."""

    radius_mm: np.ndarray
    measured_mm: np.ndarray
    exact_mm: np.ndarray
    nodes: int


def octant_displacement(poisson_ratio, division, layers, element="taylor-hood"):
    """Radial displacement at every vertex over Lamé's."""
    radial = octant_radial(poisson_ratio, division, layers, element)
    return radial.measured_mm / radial.exact_mm


def octant_radial(poisson_ratio, division, layers, element="taylor-hood"):
    """Hollow sphere of radii 1 and 2 mm under 0.07 MPa inside."""
    inner, outer, pressure = 1.0, 2.0, 0.07
    mesh = sphere_octant(inner, outer, division, layers)
    space, material = element_space(mesh, element), lame_constants(0.3, poisson_ratio)
    middle = mesh.p[:, mesh.facets].mean(axis=1)
    inside = (np.linalg.norm(middle, axis=0) < inner * 1.001) & (middle.min(axis=0) > 1e-9)
    shape = space.displacement.elem
    face = FacetBasis(mesh, shape, facets=np.flatnonzero(inside), intorder=4)
    forces = np.array(
        [LinearForm(lambda v, w, i=i: -pressure * w.n[i] * v).assemble(face) for i in range(3)]
    )
    free = space.nodes_mm.T > 1e-9
    solution = solve_mixed(space, material, free, forces, np.zeros_like(forces))
    vertices = slice(0, mesh.p.shape[1])  # they lie on their spheres, edge midpoints do not
    radius = np.linalg.norm(mesh.p, axis=0)
    radial = np.einsum("in,in->n", solution.u_mm[:, vertices], mesh.p) / radius
    exact = lame_radial_mm(radius, inner, outer, pressure, 0.3, poisson_ratio)
    return RadialDisplacement(radius, radial, exact, space.node_count)

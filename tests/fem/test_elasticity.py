"""The elements: rigid modes, patch test, convergence rates, Lamé's hollow sphere, locking."""

from typing import Any

import numpy as np
import pytest
from fem_cases import box_mesh, solve_mixed
from numpy.testing import assert_allclose
from skfem import Basis, ElementTetP1, FacetBasis, LinearForm, MeshTet, MeshTri

from fem import elasticity
from fem.assembly import ReferenceShapes
from fem.elasticity import assemble, element_space
from fem.material import lame_constants

GRADIENT = np.array([[0.3, -0.2, 0.5], [0.7, -0.4, 0.1], [-0.6, 0.8, 0.9]])
"""An asymmetric displacement gradient whose trace is not zero."""


ELEMENTS = ("taylor-hood", "p2-p0", "p1")
SIZE_MM = (1.0, 1.4, 0.7)


@pytest.fixture(scope="module", params=ELEMENTS)
def jiggled(request):
    return element_space(box_mesh((5, 6, 4), SIZE_MM, jiggle=0.2), request.param)


def energy(operators, u):
    return u.ravel() @ operators.stiffness @ u.ravel()


RIGID_GRADIENTS = {
    "rotation about x": np.array([[0, 0, 0], [0, 0, -1], [0, 1, 0.0]]),
    "rotation about y": np.array([[0, 0, 1], [0, 0, 0], [-1, 0, 0.0]]),
    "rotation about z": np.array([[0, -1, 0], [1, 0, 0], [0, 0, 0.0]]),
}


@pytest.mark.parametrize("name", [*RIGID_GRADIENTS, "translation"])
def test_rigid_motions_cost_no_energy_and_no_divergence(jiggled, name):
    operators = assemble(jiggled, lame_constants(0.3, 0.4999))
    if name == "translation":
        u = np.array([[0.4], [-1.1], [0.7]]) * np.ones((1, jiggled.node_count))
    else:
        u = RIGID_GRADIENTS[name] @ jiggled.nodes_mm.T
    scale = abs(operators.stiffness).max() * np.sum(u**2)
    assert abs(energy(operators, u)) <= 1e-12 * scale
    force = operators.stiffness @ u.ravel()
    assert abs(force).max() <= 1e-12 * abs(operators.stiffness).max() * abs(u).max() * 100
    assert abs(operators.divergence @ u.ravel()).max(initial=0) <= 1e-12 * abs(u).max()


def test_a_linear_field_costs_the_energy_of_its_strain(jiggled):
    material = lame_constants(0.3, 0.4999)
    operators = assemble(jiggled, material)
    u = GRADIENT @ jiggled.nodes_mm.T
    expected = energy_of_gradient(material, mixed=len(jiggled.pressure_nodes) > 0)
    assert_allclose(energy(operators, u), expected, rtol=1e-12)
    if len(jiggled.pressure_nodes):
        div = -np.sum(operators.divergence @ u.ravel())
        assert_allclose(div, np.trace(GRADIENT) * np.prod(SIZE_MM), rtol=1e-12)


def energy_of_gradient(material, mixed):
    """∫ 2μ ε:ε, and λ (div u)² where no pressure carries it."""
    strain = (GRADIENT + GRADIENT.T) / 2
    density = 2 * material.shear_modulus_mpa * np.sum(strain**2)
    if not mixed:
        density += np.trace(GRADIENT) ** 2 / material.inverse_lambda_per_mpa
    return density * np.prod(SIZE_MM)


FAULTS = {
    "grad-div for its transpose": lambda s: ReferenceShapes(s.slope_slope.swapaxes(0, 1), s.slope),
    "mean divergence": lambda s: ReferenceShapes(s.slope_slope, 1.1 * s.slope),
    "one slope": lambda s: ReferenceShapes(s.slope_slope * [[[[1]]], [[[1]]], [[[1.1]]]], s.slope),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_a_faulty_reference_element_shows_in_the_energy_of_a_linear_field(monkeypatch, fault):
    right = elasticity.reference_shapes
    monkeypatch.setattr(elasticity, "reference_shapes", lambda e: FAULTS[fault](right(e)))
    space = element_space(box_mesh((3, 2, 2), SIZE_MM, jiggle=0.2), "p2-p0")
    material = lame_constants(0.3, 0.4)
    stored = energy(assemble(space, material), GRADIENT @ space.nodes_mm.T)
    assert abs(stored / energy_of_gradient(material, mixed=False) - 1) > 0.01


@pytest.mark.parametrize("poisson_ratio", [0.3, 0.4999])
def test_patch_of_linear_displacement_is_reproduced_with_its_pressure(jiggled, poisson_ratio):
    material = lame_constants(0.3, poisson_ratio)
    exact = GRADIENT @ jiggled.nodes_mm.T
    on_boundary = np.zeros(jiggled.node_count, bool)
    on_boundary[jiggled.displacement.get_dofs().all()] = True
    free = np.tile(~on_boundary, (3, 1))
    assert free.sum() > 100
    solution = solve_mixed(jiggled, material, free, np.zeros_like(exact), exact)
    assert_allclose(solution.u_mm, exact, rtol=0, atol=1e-12 * abs(exact).max())
    pressure = -np.trace(GRADIENT) / material.inverse_lambda_per_mpa
    assert_allclose(solution.pressure_mpa, pressure, rtol=1e-12)


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


RATES = {
    ("taylor-hood", 0.3): ([3, 2, 2], 0.15, [1.5e-4, 1e-2, 1.3e-3]),
    ("taylor-hood", 0.4999): ([3, 2, 2], 0.15, [1.5e-4, 1e-2, 1.3e-3]),
    ("p2-p0", 0.3): ([2, 1], 0.22, [1.8e-3, 0.1]),
    ("p2-p0", 0.4999): ([2, 1], 0.33, [2.6e-3, 0.12]),
    ("p1", 0.3): ([2, 1], 0.15, [1.5e-2, 0.33]),
}
"""Orders for u in L2, its gradient, the pressure; how far off they may be; bounds on 8³ bricks.

The constant pressure of P2/P0 costs an order, which it nears from below (1.68 to 1.88 here)."""


@pytest.mark.parametrize(("element", "poisson_ratio"), RATES)
def test_errors_fall_at_the_rates_of_the_element(element, poisson_ratio):
    cells = np.array([3, 5, 8])
    errors = np.array([errors_on(element, n, poisson_ratio) for n in cells])
    rates = -np.diff(np.log(errors), axis=0) / np.diff(np.log(cells))[:, None]
    orders, tolerance, bounds = RATES[element, poisson_ratio]
    assert_allclose(rates, [orders] * 2, rtol=0, atol=tolerance)
    assert (errors[-1] < bounds).all()


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


def octant_displacement(poisson_ratio, division, layers, element="taylor-hood"):
    """Radial displacement at every vertex over Lamé's."""
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
    return radial / lame_radial_mm(radius, inner, outer, pressure, 0.3, poisson_ratio)


@pytest.mark.parametrize("element", ["taylor-hood", "p2-p0"])
def test_lame_s_hollow_sphere_nearly_incompressible(element):
    assert_allclose(octant_displacement(0.4999, 5, 4, element), 1, rtol=5e-3)


def test_plain_linear_tetrahedra_lock():
    """Right to 5 % at ν 0.3, they lose a fifth of the displacement at 0.49 and most at 0.4999."""
    means = [octant_displacement(nu, 4, 4, "p1").mean() for nu in (0.3, 0.49, 0.4999)]
    assert_allclose(means, [0.96, 0.79, 0.16], rtol=0, atol=0.03)


@pytest.mark.parametrize("poisson_ratio", [0.3, 0.4999])
def test_the_sphere_s_error_is_that_of_its_flat_facets(poisson_ratio):
    """Halving the facets divides it by about four."""
    coarse, fine = (octant_displacement(poisson_ratio, n, n).mean() - 1 for n in (3, 4))
    assert 3.2 < coarse / fine < 5

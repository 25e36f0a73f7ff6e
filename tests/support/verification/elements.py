"""Proofs of the elements: rigid modes, patch test, rates, Lamé's sphere, the nonlinear model's limit."""

from functools import cache

import numpy as np
from skfem import Basis, ElementTetP1

from fem.large_strain import elements as finite_strain
from fem.linear import elements as elasticity
from fem.linear.assembly import ReferenceShapes
from fem.linear.elements import DisplacementSpace, assemble, element_space
from fem.linear.material import lame_constants
from tests.support.mechanics import elasticity_cases
from tests.support.mechanics.elasticity_cases import (
    ELEMENTS,
    GRADIENT,
    SIZE_MM,
    errors_on,
    octant_radial,
)
from tests.support.mechanics.fem_cases import box_mesh, solve_mixed
from tests.support.mechanics.large_strain_cases import (
    E_MPA,
    MATERIALS,
    NU,
    block,
    large_strain_force,
)
from tests.support.verification.proof import Check, Curve, Fault, Measured

RIGID_GRADIENTS = {
    "turn about x": np.array([[0, 0, 0], [0, 0, -1], [0, 1, 0.0]]),
    "turn about y": np.array([[0, 0, 1], [0, 0, 0], [-1, 0, 0.0]]),
    "turn about z": np.array([[0, -1, 0], [1, 0, 0], [0, 0, 0.0]]),
}
CELLS = np.array([3, 5, 8])
ORDERS = (3, 2, 2)


@cache
def jiggled(element):
    return element_space(box_mesh((5, 6, 4), SIZE_MM, jiggle=0.2), element)


def rigid_modes():
    """Largest nodal force of a rigid motion over the stiffest entry times the largest shift."""
    curves = []
    for element in ELEMENTS:
        space = jiggled(element)
        operators = assemble(space, lame_constants(0.3, 0.4999))
        errors = []
        for u in (
            *np.eye(3)[:, :, None],
            *(g @ space.nodes_mm.T for g in RIGID_GRADIENTS.values()),
        ):
            motion = np.broadcast_to(u, (3, space.node_count)).ravel()
            scale = abs(operators.stiffness).max() * abs(motion).max()
            force = abs(operators.stiffness @ motion).max() / scale
            divergence = abs(operators.divergence @ motion).max(initial=0) / abs(motion).max()
            errors.append(max(force, divergence))
        curves.append(Curve(element, np.arange(1, 7), np.array(errors)))
    worst = max(curve.measured.max() for curve in curves)
    words = "Motions 1 to 3 are shifts along x, y, z, 4 to 6 turns about them; distorted box."
    return Measured(float(worst), words, tuple(curves))


def patch_test():
    """Largest relative error of displacement and pressure, at nodes inside a distorted box."""
    ratios, curves = np.array([0.3, 0.45, 0.4999]), []
    for element in ELEMENTS:
        errors = [_patch_error(jiggled(element), nu) for nu in ratios]
        curves.append(Curve(element, ratios, np.array(errors)))
    worst = max(curve.measured.max() for curve in curves)
    words = "Displacements of a linear field given on the border alone; distorted box."
    return Measured(float(worst), words, tuple(curves))


def _patch_error(space, poisson_ratio):
    material = lame_constants(0.3, poisson_ratio)
    exact = GRADIENT @ space.nodes_mm.T
    free = np.ones(space.node_count, bool)
    free[space.displacement.get_dofs().all()] = False
    solution = solve_mixed(space, material, np.tile(free, (3, 1)), np.zeros_like(exact), exact)
    error = abs(solution.u_mm - exact).max() / abs(exact).max()
    if len(solution.pressure_mpa):
        pressure = -np.trace(GRADIENT) / material.inverse_lambda_per_mpa
        error = max(error, abs(solution.pressure_mpa / pressure - 1).max())
    return error


def manufactured_rates():
    """How far the slopes over 3³, 5³ and 8³ bricks lie from the element's orders, at two ν."""
    curves, off, found = [], 0.0, []
    for nu in (0.3, 0.4999):
        errors = np.array([errors_on("taylor-hood", n, nu) for n in CELLS])
        rates = -np.diff(np.log(errors), axis=0) / np.diff(np.log(CELLS))[:, None]
        off = max(off, float(abs(rates - ORDERS).max()))
        found.append(f"ν {nu:g}: " + ", ".join(f"{rate:.2f}" for rate in rates[-1]))
        if nu == 0.3:
            labels = ("u in L2 (slope 3)", "u in H1 (slope 2)", "p in L2 (slope 2)")
            for label, error, order in zip(labels, errors.T, ORDERS, strict=True):
                line = 0.75 * error[0] * (CELLS[0] / CELLS) ** order
                curves.append(Curve(label, 1 / CELLS, error, line))
    words = f"Slopes between the two finer meshes of u in L2, u in H1, p in L2: {'; '.join(found)}."
    return Measured(off, words, tuple(curves))


def lame_sphere():
    """Radial displacement at every vertex against the closed form."""
    radial = octant_radial(0.4999, 5, 4)
    order = np.argsort(radial.radius_mm)
    error = float(abs(radial.measured_mm / radial.exact_mm - 1).max())
    words = (
        f"{radial.nodes} nodes, Poisson's ratio 0.4999; what is left comes from flat facets, a "
        "quarter of it after every halving."
    )
    curve = Curve(
        "displacement at every vertex",
        *(values[order] for values in (radial.radius_mm, radial.measured_mm, radial.exact_mm)),
    )
    return Measured(error, words, (curve,))


@cache
def blunt_press(material):
    """Block under a tip of 2000 mm, so blunt that strains stay small, and its linear forces."""
    setup = block((6, 5, 4), radius_mm=2000.0, material=material)
    depths = np.array([0.004, 0.008])
    own = lame_constants(E_MPA, NU).shear_modulus_mpa
    scale = own / material.shear_modulus_mpa
    return setup, depths, scale, np.array([setup.linear_force(depth) for depth in depths])


def small_strain_limit():
    """Force of the large-deformation model over the linear one's, less 1."""
    curves = []
    for material in MATERIALS:
        setup, depths, scale, linear = blunt_press(material)
        force = [large_strain_force(setup, depth, scale) for depth in depths]
        curves.append(Curve(material.name, depths, np.array(force) / linear - 1))
    worst = max(abs(curve.measured).max() for curve in curves)
    words = "Block of 12 × 10 × 6 mm with a rigid magnet; the difference vanishes with the depth."
    return Measured(float(worst), words, tuple(curves))


def _reference_fault(change):
    right = elasticity.reference_shapes
    return lambda patch: patch.setattr(
        elasticity, "reference_shapes", lambda element: change(right(element))
    )


def linear_tetrahedra(mesh):
    """Displacements without a pressure, which lock."""
    return DisplacementSpace(Basis(mesh, ElementTetP1(), intorder=2))


def _without_pressure(patch):
    patch.setattr(elasticity_cases, "element_space", lambda mesh, _: linear_tetrahedra(mesh))


def _one_slope_off(shapes):
    return ReferenceShapes(shapes.slope_slope * [[[[1]]], [[[1]]], [[[1.1]]]], shapes.slope)


def _doubled_mass(patch):
    right = elasticity.mass_matrix
    patch.setattr(elasticity, "mass_matrix", lambda *a: 2 * right(*a))


def _transposed_shear(patch):
    right = elasticity.elastic_blocks

    def without_the_transpose(elements, shapes, mu, *others):
        both, halved = (right(elements, shapes, m, *others) for m in (mu, 0.5 * mu))
        crossed = [1, 2, 4]
        both[crossed] = halved[crossed]
        return both

    patch.setattr(elasticity, "elastic_blocks", without_the_transpose)


def _softer_stress(patch):
    right = finite_strain.first_piola_stress
    patch.setattr(finite_strain, "first_piola_stress", lambda m, f: 0.995 * right(m, f))


CHECKS = (
    Check(
        "rigid_modes",
        "Rigid motions strain nothing",
        "zero, to rounding",
        1e-12,
        rigid_modes,
        Fault("shear terms between two components halved", _transposed_shear),
        "errors",
        ("rigid motion", "largest nodal force, relative"),
    ),
    Check(
        "patch_test",
        "A linear displacement is reproduced, with its pressure",
        "the linear field itself (patch test)",
        1e-12,
        patch_test,
        Fault(
            "one slope of the reference element 10 % too steep", _reference_fault(_one_slope_off)
        ),
        "errors",
        ("Poisson's ratio", "largest error inside, relative"),
    ),
    Check(
        "manufactured_solution",
        "Errors fall at the orders of the Taylor–Hood element",
        "a smooth field with its own body force (manufactured solution), orders 3, 2 and 2",
        0.15,
        manufactured_rates,
        Fault("compressibility counted twice", _doubled_mass),
        "rates",
        ("width of a brick, of a box of 1", "error over the box (ν 0.3)"),
    ),
    Check(
        "lame_sphere",
        "A nearly incompressible hollow sphere under internal pressure does not lock",
        "Lamé's closed form (Timoshenko & Goodier, Theory of Elasticity, art. 136)",
        5e-3,
        lame_sphere,
        Fault("plain linear tetrahedra in place of Taylor–Hood", _without_pressure),
        "values",
        ("radius, mm", "radial displacement, mm"),
    ),
    Check(
        "small_strain_limit",
        "Large deformation becomes linear elasticity at small depth",
        "the linear model of the same block on the same mesh",
        1e-3,
        small_strain_limit,
        Fault("stress of the large-deformation model 0.5 % too small", _softer_stress),
        "errors",
        ("depth of a tip of radius 2000 mm, mm", "force over the linear model's, less 1"),
    ),
)

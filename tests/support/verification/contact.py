"""Proofs of the contact: Hertz, and spheres on bonded layers."""

import numpy as np
import scipy.sparse as sp

from fem.linear.material import lame_constants
from fem.linear.response import face_surface
from fem.presses.table import profile_moments_mm3, surface_weights_mm2
from tests.support.mechanics import fem_cases
from tests.support.mechanics.fem_cases import (
    dimitriadis_force_n,
    forces_on_quarter_block,
    graded_axis,
    hertz_force_n,
)
from tests.support.mechanics.layer_cases import sphere_on_layer_n
from tests.support.verification.proof import Check, Curve, Fault, Measured

RADIUS_MM = 5.0
POISSON_RATIO = 0.4999
MODULUS_MPA = fem_cases.YOUNGS_MODULUS_MPA


def hertz():
    """Paraboloid law on blocks of growing size; judged on the largest."""
    sizes, depths = np.array([20.0, 40.0, 160.0]), np.array([0.1, 0.15, 0.25])
    off = []
    for size in sizes:
        plan, height = graded_axis(0.2, 8, 1.8, size), graded_axis(0.2, 1, 1.7, size)
        force = forces_on_quarter_block(POISSON_RATIO, RADIUS_MM, depths, plan, height, 1.6)
        off.append(force / hertz_force_n(depths, RADIUS_MM, POISSON_RATIO) - 1)
    off = np.array(off)
    curves = tuple(
        Curve(f"{depth:g} mm deep", sizes, one, one[0] * sizes[0] / sizes if last else None)
        for depth, one, last in zip(depths, off.T, depths == depths[-1], strict=True)
    )
    words = (
        f"Sphere of radius 5 mm, depth/radius up to 0.05, on blocks as high as half their width. "
        f"Largest error {abs(off[0]).max():.1%} on the smallest block, {abs(off[-1]).max():.2%} on "
        "the largest: what is left of a finite block falls as 1/size (line)."
    )
    return Measured(float(abs(off[-1]).max()), words, curves)


def _layer_forces(thickness_mm, depths, layers):
    plan = graded_axis(0.5, 8, 1.6, 5 * thickness_mm)
    height = np.linspace(0, thickness_mm, layers + 1)
    return forces_on_quarter_block(0.5, RADIUS_MM, depths, plan, height, 4.9)


def bonded_layer():
    """Forces on 8 mm at the depths of the paper's presses."""
    depths = np.array([0.25, 0.5, 1.0, 2.0])
    force = _layer_forces(8.0, depths, 5)
    exact = np.array(
        [sphere_on_layer_n(depth, RADIUS_MM, 8.0, MODULUS_MPA, 0.5) for depth in depths]
    )
    published = dimitriadis_force_n(depths[1:3], RADIUS_MM, 8.0)
    error = max(
        abs(force / exact - 1)[1:].max(),
        abs(force[2:] / [1.69, 5.5] - 1).max(),
        abs(force[1:3] / published - 1).max(),
    )
    words = (
        f"{force[2]:.3f} N at 1 mm and {force[3]:.3f} N at 2 mm against 1.69 and 5.5 N of a converged "
        f"axisymmetric solution. Off Dimitriadis et al. by {force[1] / published[0] - 1:+.1%} and "
        f"{force[2] / published[1] - 1:+.1%} at 0.5 and 1 mm, "
        f"{force[0] / exact[0] - 1:+.1%} at 0.25 mm. The last is drawn but not judged, as it spans "
        "three cells."
    )
    return Measured(float(error), words, (Curve("force", depths, force, exact),))


def layer_factors():
    """How much a bonded layer stiffens the contact, by its thickness."""
    thickness, depth = np.array([4.0, 8.0, 16.0]), 0.5
    half_space = hertz_force_n(depth, RADIUS_MM, 0.5)
    force = [
        float(_layer_forces(h, np.array([depth]), layers)[0])
        for h, layers in zip(thickness, (4, 5, 7), strict=True)
    ]
    exact = [sphere_on_layer_n(depth, RADIUS_MM, h, MODULUS_MPA, 0.5) for h in thickness]
    measured, reference = np.array(force) / half_space, np.array(exact) / half_space
    error = float(abs(measured / reference - 1).max())
    words = "Sphere of radius 5 mm, 0.5 mm deep, layers five times as wide as high to either side."
    curve = Curve("force over that on a half-space", thickness, measured, reference)
    return Measured(error, words, (curve,))


def _twice_the_radius(patch):
    patch.setattr(
        fem_cases,
        "profile_moments_mm3",
        lambda s, xy, radius: profile_moments_mm3(s, xy, 2 * radius),
    )


def _lumped_forces(patch):
    """Forces at the vertices, each of its share of the area, in place of consistent pressures."""

    def lumped(space, facets, frame):
        surface, moments = face_surface(space, facets, frame)
        vertices = np.unique(np.asarray(space.mesh.facets)[:, facets])
        weights = surface_weights_mm2(surface)
        columns = np.arange(len(vertices))
        return surface, sp.csc_matrix((weights, (vertices, columns)), shape=moments.shape)

    patch.setattr(fem_cases, "face_surface", lumped)


def _halved_modulus(patch):
    patch.setattr(fem_cases, "lame_constants", lambda e, nu: lame_constants((1 + nu) * e, nu))


LAYER = (
    "integral equation of a tip on a bonded layer (Lebedev & Ufliand, PMM 22 (1958) 442), which gives "
    "the punch factors printed by Hayes et al. (J. Biomechanics 5 (1972) 541) to 0.3 %"
)
CHECKS = (
    Check(
        "hertz_sphere",
        "A sphere on a large block presses as Hertz has it",
        "F = 4/3 E* √R δ^1.5 on a half-space (Hertz)",
        0.01,
        hertz,
        Fault("diameter of the tip for its radius", _twice_the_radius),
        "rates",
        ("half width of the block, mm", "force over Hertz's, less 1"),
    ),
    Check(
        "bonded_layer",
        "A sphere on the bonded layer of 8 mm",
        f"{LAYER}; a converged axisymmetric solution; Dimitriadis et al., Biophys. J. 82 (2002) 2798",
        0.02,
        bonded_layer,
        Fault("forces at vertices in place of P1 pressures", _lumped_forces),
        "values",
        ("depth, mm", "force, N"),
    ),
    Check(
        "layer_factors",
        "A bonded layer stiffens the contact by the published factor",
        LAYER,
        0.02,
        layer_factors,
        Fault("shear modulus E/2 in place of E/(2 (1 + ν))", _halved_modulus),
        "values",
        ("thickness of the layer, mm", "force over a half-space's"),
    ),
)

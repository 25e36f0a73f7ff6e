"""Masses of objects against closed forms and integrals over the triangles of their parts."""

import re

import numpy as np
import pytest
import trimesh

from design.build.amounts import silicone_amount
from design.build.masses import (
    BOARD_G_PER_CM3,
    MAGNET_G_PER_CM3,
    Mass,
    mass_text,
    masses_of,
    solid_mass,
    total,
)
from design.build.parts import parts_of
from design.build.scene import magnet_halves
from design.layout.boards import board_blocks
from design.layout.places.positions import magnet_layout
from design.solids.body import cavity_solid, outer_solid
from design.solids.booleans import convert_to_triangles
from design.solids.kernel import cq
from design.spec.body import CoreSpec
from design.spec.object import ObjectSpec
from tests.support.objects.body_cases import body_spec

FINE = 0.002, 0.05
"""Deviation of triangles, mm and rad: a ball of 44 mm is then 5e-4 of its silicone too light."""


def integrals(mesh):
    """Volume, first moment and inertia about the origin of a surface, by its tetrahedra."""
    corners = np.asarray(mesh.triangles, float)
    volume = np.linalg.det(corners) / 6
    centre = (volume[:, None] * corners.sum(axis=1) / 4).sum(axis=0)
    # ∫ x xᵀ over a tetrahedron from the origin: V / 20 (Σ vᵢ vᵢᵀ + (Σ vᵢ)(Σ vᵢ)ᵀ)
    outer = np.einsum("tvi,tvj->tij", corners, corners)
    summed = corners.sum(axis=1)
    second = np.einsum("t,tij->ij", volume / 20, outer + summed[:, :, None] * summed[:, None])
    return volume.sum(), centre, np.trace(second) * np.eye(3) - second


def summed_integrals(weighted):
    parts = [(density, *integrals(mesh)) for density, mesh in weighted]
    mass = sum(density * volume for density, volume, _, _ in parts)
    first = sum(density * moment for density, _, moment, _ in parts)
    about_origin = sum(density * inertia for density, _, _, inertia in parts)
    centre = first / mass
    steiner = mass * (centre @ centre * np.eye(3) - np.outer(centre, centre))
    return mass, centre, about_origin - steiner


def agree(found: Mass, mass, centre, inertia, share=1e-3):
    assert found.mass_g == pytest.approx(mass, rel=share)
    size = np.sqrt(np.trace(inertia) / mass)
    np.testing.assert_allclose(found.centre_mm, centre, atol=share * size)
    np.testing.assert_allclose(found.inertia_g_mm2, inertia, atol=share * np.trace(inertia) / 3)


def test_a_box_has_the_mass_and_inertia_of_its_closed_form():
    solid = cq.Solid.makeBox(20, 30, 40, cq.Vector(1, 2, 3))
    mass = 1.2e-3 * 20 * 30 * 40
    inertia = mass / 12 * np.diag([30**2 + 40**2, 20**2 + 40**2, 20**2 + 30**2])
    triangles = trimesh.creation.box((20, 30, 40)).apply_translation((11, 17, 23))
    for shape in (solid, triangles):
        agree(solid_mass(shape, 1.2), mass, np.array([11, 17, 23]), inertia, 1e-9)


def test_a_ball_taken_out_of_a_ball_leaves_a_hollow_one():
    outer, inner = (
        solid_mass(cq.Solid.makeSphere(r, angleDegrees1=-90), 2.0) for r in (20.0, 12.0)
    )
    mass = 2e-3 * 4 / 3 * np.pi * (20**3 - 12**3)
    inertia = 2 / 5 * mass * (20**5 - 12**5) / (20**3 - 12**3) * np.eye(3)
    agree(total([outer, inner.scaled(-1.0)]), mass, np.zeros(3), inertia, 1e-6)


def test_two_bodies_turn_about_their_common_centre():
    two = [Mass(m, np.array([x, 0.0, 0.0]), np.zeros((3, 3))) for m, x in ((1.0, 0.0), (3.0, 4.0))]
    # reduced mass 3/4 at a distance of 4
    agree(total(two), 4.0, np.array([3.0, 0, 0]), np.diag([0.0, 12.0, 12.0]), 1e-12)


def with_blocks(**magnets):
    return {"magnets": {"positions_mm": [[1.0, -2.0]], **magnets}}


@pytest.mark.parametrize(
    ("body", "changes"),
    [
        ("two_open", with_blocks(shape="block", size_mm=(5.0, 3.0))),
        ("cylinder", with_blocks(shape="ring", diameter_mm=6.0, inner_diameter_mm=2.0)),
        ("ellipsoid", {}),
        ("two_open", {"arrangement": "sensors-in-shell"}),
    ],
)
def test_the_whole_is_the_integral_over_the_triangles_of_all_parts(body, changes):
    spec = body_spec(body)
    spec = spec.changed(
        **{
            key: getattr(spec, key).changed(**value) if isinstance(value, dict) else value
            for key, value in changes.items()
        }
    )
    printed = spec.printer.preset.density_g_per_cm3 / 1e3
    silicone = spec.silicone.density_g_per_cm3 / 1e3
    magnets = [half for pair in magnet_halves(spec, magnet_layout(spec)) for half in pair]
    boards = [
        trimesh.creation.box(2 * block.half_mm, _placed(block)) for block in board_blocks(spec)
    ]
    inside = magnets if spec.arrangement == "sensors-in-core" else boards
    core = next(part for part in parts_of(spec) if part.name == "core").make()
    if body == "ellipsoid":
        from design.layout.body import body_of

        sealed = body_of(spec).outer_surface().difference(body_of(spec).cavity_surface())
    else:
        room = cavity_solid(spec, 0.5)
        sealed = convert_to_triangles(outer_solid(spec).cut(room), FINE, False)
    weighted = [(printed, convert_to_triangles(core, FINE, False)), (silicone, sealed)]
    weighted += [(-silicone, mesh) for mesh in inside]
    weighted += [(MAGNET_G_PER_CM3 / 1e3, mesh) for mesh in magnets]
    weighted += [(BOARD_G_PER_CM3 / 1e3, mesh) for mesh in boards]
    masses = masses_of(spec)
    agree(total(masses.values()), *summed_integrals(weighted))
    assert masses["shell"].mass_g == pytest.approx(silicone_amount(spec).mass_g, rel=1e-3)


def test_the_text_holds_the_sum_of_the_parts_and_their_centre():
    """The paper's cube has a core open below: the centre lies above the middle."""
    cube = ObjectSpec(name="cube")
    figures = [float(x) for x in re.findall(r"-?\d+\.\d", mass_text(cube))]
    whole, *parts, x, y, z = figures
    assert whole == pytest.approx(sum(parts), abs=0.2)
    assert whole == pytest.approx(sum(mass.mass_g for mass in masses_of(cube).values()), abs=0.051)
    assert (x, y) == (0.0, 0.0)
    assert "-0.0" not in mass_text(cube)
    assert z == pytest.approx(total(masses_of(cube).values()).centre_mm[2], abs=0.051)
    assert 1 < z < 3


def test_a_core_that_is_no_solid_has_no_mass():
    wide = CoreSpec(wire_hole_top_diameter_mm=60.0, wire_hole_side_diameter_mm=60.0)
    broken = ObjectSpec(name="cube").model_copy(update={"core": wide})
    assert mass_text(broken).startswith("mass is unknown: core must be one closed body")


def _placed(block):
    placed = np.eye(4)
    placed[:3, :3], placed[:3, 3] = block.axes, block.centre_mm
    return placed

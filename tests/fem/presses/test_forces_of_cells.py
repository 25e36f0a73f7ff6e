"""Cells under uniform pressure against the half-space; presses to a force; the core's reaction."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.spec.mechanics import IndenterSpec
from fem.contact.indenter import moved, tip_cells
from fem.contact.refined import joint_compliance, refined_face, spread_cells
from fem.presses.joint import Tip, press_tips
from fem.presses.to_force import press_to_force
from tests.support.mechanics.block_cases import (
    known_block_response,
    plane_strain_modulus_mpa,
    spec_of,
)


@pytest.mark.parametrize(
    ("edge_mm", "cells", "within"),
    [(2.0, 3, 0.025), pytest.param(1.0, 4, 0.008, marks=pytest.mark.slow)],
)
def test_a_disk_of_pressure_sinks_as_on_the_half_space(edge_mm, cells, within):
    """Mean displacement 16 p a/(3π E*) (Johnson, Contact Mechanics, 3.4), by block size 2 e₂ − e₁.

    The factor of hats is that of waves of five edges: a disk of two edges, whose pressure ends in a step,
    answers 2.2 % too stiffly, of four edges 0.4 %. With a single hat's own factor, 0.9615, it is 1.2 and
    0.3 %, but forces of a sphere over magnets are 1 to 2.5 % smaller at 1 mm.
    """
    nu, radius, pressure = 0.4999, 2.0, 0.01
    exact = 16 * pressure * radius / (3 * np.pi * plane_strain_modulus_mpa(nu))
    errors, disk = [], IndenterSpec(kind="flat", radius_mm=radius)
    for size in (20.0, 40.0):
        block = known_block_response(nu, size, size, edge_mm, cells)
        tip, place = tip_cells(disk), np.array([0.6, -0.9])
        face = refined_face(block, 0, spec_of(nu).changed(indenter=disk))
        spread = spread_cells(face, moved(tip.patches, place), place)
        assert_allclose(tip.patches.area_mm2.sum(), np.pi * radius**2, rtol=0.003)
        moments = joint_compliance(block, [spread], spec_of(nu)) @ np.full(
            len(tip.height_mm), pressure
        )
        errors.append(moments.sum() / tip.patches.area_mm2.sum() / exact - 1)
    assert errors[0] < errors[1] < 0
    assert abs(2 * errors[1] - errors[0]) < within, 2 * errors[1] - errors[0]


def test_three_presses_to_one_force_each(rigid_spec, rigid_response):
    tips = [Tip(1, -8.0, 3.0), Tip(1, 8.0, 1.0), Tip(4, 2.0, -5.0)]
    press = press_to_force(rigid_spec, rigid_response, [[tip] for tip in tips], 4.0)
    assert_allclose(press.force_n, 4.0, rtol=1e-5)
    again = press_tips(rigid_spec, rigid_response, tips, press.depth_mm)
    assert_allclose(again.force_n, press.force_n, rtol=1e-12)
    assert_allclose(again.motion, press.motion, rtol=0, atol=1e-12)


def test_an_oblique_press_to_a_force_lands_beside_its_place(rigid_spec, rigid_response):
    indenter = rigid_spec.indenter.model_copy(update={"direction_deg": (0.0, 40.0)})
    oblique = rigid_spec.model_copy(update={"indenter": indenter})
    press = press_to_force(oblique, rigid_response, [[Tip(2, 1.0, 2.0)]], 5.0)
    y = 2.0 + press.depth_mm[0] * np.tan(np.deg2rad(40))
    straight = press_tips(rigid_spec, rigid_response, [Tip(2, 1.0, float(y))], press.depth_mm)
    assert_allclose(straight.force_n, 5.0, rtol=1e-5)
    assert_allclose(straight.motion, press.motion, rtol=0, atol=1e-12)


def test_the_core_bears_what_the_indenter_presses(rigid_system, rigid_spec, coarse_mesh):
    """Applied force against the reaction where the silicone is held, straight and oblique."""
    from dataclasses import replace

    from design.layout.body import face_frames
    from fem.contact.half_space import Patches
    from fem.contact.refined import spread_cells
    from fem.contact.traction import refined_surface, traction_loads

    frame = next(frame for frame in face_frames(rigid_spec) if frame.number == 3)
    face, moments = refined_surface(rigid_system, rigid_spec, frame, coarse_mesh.magnets)
    cells = Patches(np.array([0.7, 0.4]), np.array([[4.0, -6.0], [4.9, -5.2]]), np.full(2, 0.05))
    spread = spread_cells(replace(face), cells, np.zeros(2))
    for direction, axis in enumerate((-frame.normal, frame.x, frame.y)):
        loads = traction_loads(frame, direction, moments[:, spread.rows]) @ spread.matrix
        applied = (loads @ np.array([1.0, 2.0])).reshape(3, -1).sum(axis=1)
        assert_allclose(applied, axis * 1.5, rtol=0, atol=1e-10)

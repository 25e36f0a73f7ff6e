"""The estimate of the discretisation error: exact on made differences, and of the right size."""

from dataclasses import replace

import numpy as np
from numpy.testing import assert_allclose

from design.layout.places.contact_grid import contact_grid
from fem.presses.discretisation import (
    COARSENING,
    ORDER,
    ROTATION_ARM_MM,
    PressSample,
    coarser,
    discretisation_error,
    mesh_difference,
    patch_compliance_mm_per_n,
    sample_presses,
)
from fem.presses.table import press_face
from tests.support.mechanics.fem_cases import patch_compliances

SHARE = 1 / (COARSENING**ORDER - 1)


def made_sample(force_factor, rate_factor):
    """Two presses of two steps with three components of motion; the second press starts late."""
    force = np.array([[0.5, 1.3], [0.0, 0.9]]) * force_factor
    rate = np.array([[[0.2, -0.1, 0.4], [0.3, 0.0, 0.1]], [[0.1, 0.2, -0.3], [-0.2, 0.5, 0.6]]])
    return PressSample(force, rate_factor * rate * force[..., None])


def test_forces_and_motions_per_newton_are_compared_separately():
    difference = mesh_difference(made_sample(1.1, 0.8), made_sample(1.0, 1.0))
    assert_allclose(difference.force, [[0.1, 0.1], [np.nan, 0.1]], rtol=1e-12)
    assert_allclose(difference.motion, [[0.2, 0.2], [np.nan, 0.2]], rtol=1e-12)


def test_the_coarser_object_differs_in_its_mesh_alone(rigid_spec):
    mesh = coarser(rigid_spec).mesh
    assert_allclose(mesh.edge_mm, 1.5 * rigid_spec.mesh.edge_mm)
    assert_allclose(mesh.surface_edge_mm, 1.5 * rigid_spec.mesh.surface_edge_mm)
    assert coarser(rigid_spec).model_copy(update={"mesh": rigid_spec.mesh}) == rigid_spec


def test_up_to_25_places_of_each_face_are_pressed(rigid_spec, rigid_response):
    sample = sample_presses(rigid_spec, rigid_response)
    assert sample.force_n.shape == (125, len(rigid_spec.press.depths_mm))
    assert sample.motion_mm.shape == (*sample.force_n.shape, 25 * 6)
    assert (np.diff(sample.force_n, axis=1) > 0).all()


def test_a_mesh_compared_with_itself_shows_no_error(rigid_spec, rigid_response):
    error = discretisation_error(rigid_spec, rigid_response, rigid_response)
    assert error.patch_compliance == 0
    assert {(s.force_rms, s.force_worst, s.motion_rms, s.motion_worst) for s in error.steps} == {
        (0.0, 0.0, 0.0, 0.0)
    }


def test_a_shell_softer_by_five_percent_shows_as_such(rigid_spec, rigid_response):
    """All of it in the patch load; under a tip less, part of whose compliance is a half-space's."""
    softer = replace(rigid_response, compliance=1.05 * np.asarray(rigid_response.compliance))
    error = discretisation_error(rigid_spec, rigid_response, softer)
    assert_allclose(error.patch_compliance, 0.05 * SHARE, rtol=1e-9)
    for step in error.steps:
        assert 0.4 < step.force_rms / (0.05 * SHARE) < 1
        assert 0.9 < step.motion_rms / (0.05 * SHARE) < 1.1
        assert step.force_rms <= step.force_worst < 0.05 * SHARE
        assert step.motion_rms <= step.motion_worst < 0.06 * SHARE


def test_a_tip_that_misses_a_mesh_leaves_no_estimate(rigid_spec, rigid_response):
    shallow = rigid_spec.press.model_copy(update={"depths_mm": (1e-9, 1.0)})
    error = discretisation_error(
        rigid_spec.model_copy(update={"press": shallow}), rigid_response, rigid_response
    )
    assert error.steps[0].force_rms is None
    assert error.steps[1].force_rms == 0


def test_the_projected_patch_load_gives_the_direct_solution_s_compliance(
    plain_system, rigid_spec, plain_response
):
    """P1 pressures on triangles of 2.1 mm leave 0.9 to 2.6 % of the load's compliance out.

    On triangles of 1.7 mm 0.5 to 1.0 %.
    """
    direct, _ = patch_compliances(plain_system, rigid_spec)
    projected = []
    for face, surface in enumerate(plain_response.surfaces):
        rows = plain_response.face_loads(face)
        block = plain_response.compliance[rows, rows]
        projected.append(patch_compliance_mm_per_n(surface, block))
    assert_allclose(projected, direct, rtol=0.03)
    assert (np.array(projected) < direct).all()


def test_rotations_count_by_their_arm_and_shifts_as_they_are(rigid_spec, rigid_response):
    """Against the compliance itself, for one place of the first face."""
    sample = sample_presses(rigid_spec, rigid_response)
    depths = np.asarray(rigid_spec.press.depths_mm)
    x, y = contact_grid(rigid_spec).xy_mm[0]
    presses = press_face(rigid_spec, rigid_response, 0, np.array([[x, y]]), depths)
    rows = rigid_response.compliance[rigid_response.magnet_loads, rigid_response.face_loads(0)]
    motion = (presses.vertex_mpa[0] @ rows.T).reshape(len(depths), -1, 2, 3)
    found = sample.motion_mm[0].reshape(len(depths), -1, 2, 3)
    assert ROTATION_ARM_MM not in (0.0, 1.0)
    assert_allclose(found[:, :, 0], motion[:, :, 0], rtol=1e-6, atol=1e-12)
    assert_allclose(found[:, :, 1], ROTATION_ARM_MM * motion[:, :, 1], rtol=1e-6, atol=1e-12)

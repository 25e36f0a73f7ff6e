"""Contact of a ball at large strain: gaps, their derivatives, and where they are integrated."""

import numpy as np
from numpy.testing import assert_allclose

from fem.large_strain.sphere_contact import contact_state, contact_stiffness
from tests.support.mechanics.large_strain_cases import block


def test_contact_derivatives_by_finite_differences(pressed):
    setup, state = pressed
    face, centre = setup.problem.face, setup.centre(1.0)
    random = np.random.default_rng(4)
    direction = random.standard_normal(len(state.displacement_mm))
    pressure = random.uniform(0, 1, len(face.weights_mm2))

    def at(step):
        return contact_state(face, state.displacement_mm + step * direction, centre, 5.0)

    step, now = 1e-5, at(0)
    gap = (at(step).gap_mm3 - at(-step).gap_mm3) / (2 * step)
    assert_allclose(now.gradient @ direction, gap, rtol=0, atol=1e-8)
    force = -(at(step).gradient - at(-step).gradient).T @ pressure / (2 * step)
    stiffness = contact_stiffness(face, now, pressure) @ direction
    assert_allclose(stiffness, force, rtol=0, atol=1e-7 * abs(force).max())


def test_the_gap_of_a_flat_face_is_the_volume_below_the_sphere():
    """∑ gap_i of a flat face: a cone's solid-angle share of the sphere, taken from its volume."""
    setup = block(cells=(12, 10, 2), magnet=False)
    face = setup.problem.face
    centre = setup.centre(-0.4)
    gaps = contact_state(face, np.zeros(3 * face.node_count), centre, 5.0).gap_mm3
    points, area = face.frame_mm[:, :, 0], face.area_mm2
    offset = points - centre
    distance = np.linalg.norm(offset, axis=-1)
    height = (1 - (5.0 / distance) ** 3) / 3 * 5.4
    known = np.where(face.candidate >= 0, 1.0, 0.0)
    shares = np.einsum("fqh,fh->fq", face.hats, known)
    assert_allclose(gaps.sum(), (height * shares * area).sum(), rtol=1e-12)
    assert (gaps > 0).all()
    nearest = np.argmin(gaps / face.weights_mm2)
    assert 0.4 < gaps[nearest] / face.weights_mm2[nearest] < 0.5


def test_only_facets_at_candidates_are_integrated():
    setup = block()
    face = setup.problem.face
    assert (face.candidate >= 0).any(axis=1).all()
    assert_allclose(face.weights_mm2, setup.weights, rtol=1e-12)

"""The correction for large deformation: found again from made-up presses, applied to a table."""

from dataclasses import replace

import numpy as np
from numpy.testing import assert_allclose

from design.layout.places.contact_grid import PlaceGrid
from design.spec.object import ObjectSpec
from fem.large_strain.correction import (
    PressPair,
    StrainCorrection,
    corrected_table,
    fit_correction,
    leave_one_out,
)
from fem.presses.results import MagnetMotions, PressForces

DEPTHS = np.array([0.5, 1.0, 2.0, 3.5])
THICKNESS_MM = 7.0
OWN = np.arange(6) < 4
NORMAL = np.array([0.6, 0.0, 0.8])
TRUE = StrainCorrection(THICKNESS_MM, (-0.1, 0.9), (-0.3, 1.2), (-0.25,))


def small_strain(seed):
    """Force and motions of a press in small strain: they grow with depth, magnet 2 sinks most."""
    rng = np.random.default_rng(seed)
    motion = rng.normal(0, 0.05, (6, 6)) * DEPTHS[:, None, None]
    motion[:, 2, :3] -= rng.uniform(0, 0.6) * DEPTHS[:, None] ** 1.2 * NORMAL
    return rng.uniform(1, 3) * DEPTHS**1.5, motion


def by_hand(force, motion):
    """The formulas of the module once more, magnet by magnet."""
    force, motion, small = force.copy(), motion.copy(), motion
    for step, depth in enumerate(DEPTHS):
        x = depth / THICKNESS_MM
        sunk = max(0.0, *(-float(small[step, m, :3] @ NORMAL) for m in range(4)))
        force[step] *= 1 + x * (-0.1 + 0.9 * sunk / depth)
        for m in range(6):
            u, w = small[step, m, :3], small[step, m, 3:]
            carried = [
                w[1] * u[2] - w[2] * u[1],
                w[2] * u[0] - w[0] * u[2],
                w[0] * u[1] - w[1] * u[0],
            ]
            motion[step, m, :3] = u * (1 - 0.3 * x) + 1.2 * np.array(carried)
            motion[step, m, 3:] = w * (1 - 0.25 * x)
    return force, motion


def made_up_pair(seed, noise=0.0):
    linear_force, linear_motion = small_strain(seed)
    force, motion = by_hand(linear_force, linear_motion)
    rng = np.random.default_rng(seed + 100)
    force = force * (1 + noise * rng.standard_normal(len(DEPTHS)))
    return PressPair(DEPTHS, force, linear_force, motion, linear_motion, OWN, NORMAL)


PAIRS = [made_up_pair(seed) for seed in range(5)]


def check_the_coefficients():
    found = fit_correction(PAIRS, THICKNESS_MM)
    assert_allclose(found.force, TRUE.force, rtol=1e-9)
    assert_allclose(found.shift, TRUE.shift, rtol=1e-9)
    assert_allclose(found.rotation, TRUE.rotation, rtol=1e-9)


def test_coefficients_are_found_again():
    check_the_coefficients()


def test_errors_of_motions_are_shares_of_the_most_moved_magnet():
    error = leave_one_out(PAIRS, THICKNESS_MM)
    for quantity, part in ((error.shift, slice(3)), (error.rotation, slice(3, 6))):
        shares = []
        for pair in PAIRS:
            off = np.linalg.norm((pair.linear_motion - pair.motion)[..., part], axis=2)
            whole = np.linalg.norm(pair.motion[..., part], axis=2)
            shares += [max(one) / max(other) for one, other in zip(off, whole, strict=True)]
        assert_allclose(quantity.uncorrected_largest, max(shares))


def test_places_left_out_are_predicted():
    error = leave_one_out(PAIRS, THICKNESS_MM)
    for quantity in (error.force, error.shift, error.rotation):
        assert quantity.corrected_largest < 1e-9
        assert quantity.uncorrected_rms > 0.02
        assert quantity.helps


def test_what_does_not_help_is_left_out():
    """Forces off at random: nothing that one place teaches about another."""
    rng = np.random.default_rng(3)
    random = [
        replace(pair, force_n=pair.linear_force_n * (1 + 0.1 * sign * rng.uniform(0.5, 1)))
        for pair, sign in zip(PAIRS, (1, -1, 1, -1, 1), strict=True)
    ]
    found = fit_correction(random, THICKNESS_MM)
    assert found.force == (0.0, 0.0)
    assert_allclose(found.shift, TRUE.shift, rtol=1e-9)
    turned = [
        replace(pair, motion=pair.linear_motion * (1 + 0.1 * sign * rng.uniform(0.5, 1)))
        for pair, sign in zip(PAIRS, (1, -1, 1, -1, 1), strict=True)
    ]
    found = fit_correction(turned, THICKNESS_MM)
    assert (found.shift, found.rotation) == ((0.0, 0.0), (0.0,))
    assert_allclose(found.force, TRUE.force, rtol=1e-9)


def test_noise_in_few_presses_moves_the_error_and_not_the_verdict():
    error = leave_one_out([made_up_pair(seed, noise=0.01) for seed in range(5)], THICKNESS_MM)
    assert 0.004 < error.force.corrected_rms < 0.04
    assert error.force.helps


def test_every_face_of_a_table_is_corrected_with_its_own_magnets_and_normal():
    spec = ObjectSpec(name="cube")
    lattice, rng = PlaceGrid(np.array([0.0, 1.0]), np.array([0.0])), np.random.default_rng(5)
    faces, depths = np.array([1, 4]), np.array([1.0, 2.0])
    force = rng.uniform(1, 2, (2, 2, 2))
    motion = rng.normal(0, 1e-3, (2, 2, 2, 25, 6))
    motion[1, 0, 1, 17, 1] = -0.8  # magnet 17 belongs to face 4, whose normal is +y
    motion[0, 0, 1, 17, 1] = -0.8  # the same while face 1 is pressed squeezes nothing there
    correction = StrainCorrection(8.0, (0.0, 1.0), (0.0, 0.0), (0.0,))
    forces, motions = corrected_table(
        spec,
        PressForces(faces, lattice, depths, force, force),
        MagnetMotions(faces, lattice, depths, motion),
        correction,
    )
    gain = forces.force_n / force - 1
    assert_allclose(gain[1, 0, 1], 2.0 / 8.0 * 0.8 / 2.0, rtol=1e-9)
    assert (gain[0] < 0.001).all()
    assert_allclose(motions.motion, motion, rtol=1e-12)
    assert_allclose(forces.contact_area_mm2, force)

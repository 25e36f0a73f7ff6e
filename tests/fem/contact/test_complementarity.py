"""Unilateral contact: complementarity, an independent oracle, Hertz and the bonded layer."""

import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose

from design.errors import SolverError
from fem.contact import complementarity as contact
from fem.contact.complementarity import contact_pressures
from tests.support.mechanics.fem_cases import (
    dimitriadis_force_n,
    forces_on_quarter_block,
    graded_axis,
    hertz_force_n,
)

DEPTHS = np.array([0.05, 0.3, 0.9])


def random_problem(seed, count):
    rng = np.random.default_rng(seed)
    factor = rng.standard_normal((count, count))
    compliance = factor @ factor.T + 0.05 * np.eye(count)
    return compliance, rng.uniform(0, 0.5, count), rng.uniform(0.2, 1, count)


def by_enumeration(compliance, gap):
    """The one active set whose solution satisfies every sign, among all 2ⁿ."""
    count = len(gap)
    for active in itertools.product([False, True], repeat=count):
        active = np.array(active)
        pressure = np.zeros(count)
        if active.any():
            pressure[active] = np.linalg.solve(compliance[np.ix_(active, active)], -gap[active])
        if (pressure >= 0).all() and (compliance @ pressure + gap >= -1e-9)[~active].all():
            return pressure
    raise AssertionError("a positive definite complementarity problem has a solution")


@settings(max_examples=25, deadline=None)
@given(seed=st.integers(0, 10**6), count=st.integers(1, 8))
def test_pressures_are_those_of_exhaustive_enumeration(seed, count):
    compliance, moments, weights = random_problem(seed, count)
    pressures = contact_pressures(compliance, moments, weights, DEPTHS)
    for depth, pressure in zip(DEPTHS, pressures, strict=True):
        exact = by_enumeration(compliance, moments - depth * weights)
        assert_allclose(pressure, exact, rtol=0, atol=1e-8 * max(1, abs(exact).max()))


def test_least_squares_takes_over_where_the_active_set_gives_up(monkeypatch):
    compliance, moments, weights = random_problem(12, 30)
    expected = contact_pressures(compliance, moments, weights, DEPTHS)
    assert (expected[-1] > 0).any()
    monkeypatch.setattr(contact, "MAX_SWITCHES", 0)
    pressures = contact_pressures(compliance, moments, weights, DEPTHS)
    assert_allclose(pressures, expected, rtol=0, atol=1e-9 * expected.max())


def test_a_press_beside_leaves_the_pressures_and_saves_systems(monkeypatch):
    """At each depth more unknowns touch; the second tip stands a little aside."""
    rng, depths = np.random.default_rng(5), np.linspace(0.1, 1.2, 8)
    compliance, moments, weights = random_problem(4, 60)
    compliance += 20 * np.eye(60)
    aside = compliance + 0.01 * np.diag(rng.random(60)), moments + 1e-3 * rng.random(60), weights
    solved = []

    def counted(matrix, right_side):
        solved.append(len(matrix))
        return solve(matrix, right_side)

    solve = contact.solve_positive
    beside = contact.contact(compliance, moments, weights, depths)
    monkeypatch.setattr(contact, "solve_positive", counted)
    alone = contact.contact(*aside, depths)
    count = len(solved)
    found = contact.contact(*aside, depths, beside)
    np.testing.assert_array_equal(found.pressure_mpa, alone.pressure_mpa)
    assert 8 <= len(solved) - count < 0.8 * count
    touching = found.pressure_mpa > 0
    np.testing.assert_array_equal(found.firmness_mm3 > 0, touching)
    gap = found.pressure_mpa @ aside[0] + moments - depths[:, None] * weights
    assert_allclose(-found.firmness_mm3[~touching], gap[~touching], atol=2e-3)


def test_no_touch_no_pressure():
    compliance, _, weights = random_problem(3, 6)
    pressures = contact_pressures(compliance, 2 * weights, weights, np.array([0.5, 1.9]))
    assert (pressures == 0).all()


def hertz_errors(poisson_ratio, block_mm):
    """Relative error of the force on a block of this half width and height; sphere of R 5."""
    depths = np.array([0.1, 0.15, 0.25])
    plan, height = graded_axis(0.2, 8, 1.8, block_mm), graded_axis(0.2, 1, 1.7, block_mm)
    force = forces_on_quarter_block(poisson_ratio, 5.0, depths, plan, height, 1.6)
    return force / hertz_force_n(depths, 5.0, poisson_ratio) - 1


@pytest.mark.slow
def test_hertz_sphere_on_a_large_block():
    """δ/R ≤ 0.05 on 160 × 160 × 80 mm: the finite block leaves about +1 %."""
    assert_allclose(hertz_errors(0.4999, 80.0), 0, rtol=0, atol=0.02)


@pytest.mark.slow
@pytest.mark.parametrize("poisson_ratio", [0.3, 0.4999])
def test_hertz_s_error_is_the_truncation_of_the_block(poisson_ratio):
    """Far displacements fall as 1/distance: the error halves with every doubling."""
    errors = [hertz_errors(poisson_ratio, size)[-1] for size in (20.0, 40.0, 80.0)]
    assert 1.7 < errors[0] / errors[1] < 2.9
    assert 1.7 < errors[1] / errors[2] < 2.9
    assert_allclose(2 * errors[2] - errors[1], 0, rtol=0, atol=0.006)


def test_bonded_incompressible_layer():
    """Sphere of R 5 on 8 mm bonded below, ν = 0.5, 80 mm wide, against published factors."""
    depths = np.array([0.5, 1.0, 2.0])
    plan = graded_axis(0.5, 8, 1.6, 40.0)
    force = forces_on_quarter_block(0.5, 5.0, depths, plan, np.linspace(0, 8, 6), 4.9)
    assert_allclose(force[:2], dimitriadis_force_n(depths[:2], 5.0, 8.0), rtol=0.025)
    assert_allclose(force[1:], [1.69, 5.5], rtol=0.015)  # axisymmetric Taylor–Hood


def test_a_compliance_that_is_not_positive_definite_is_told():
    indefinite = np.array([[1.0, 2.0], [2.0, 1.0]])
    with pytest.raises(SolverError, match="smaller mesh"):
        contact_pressures(indefinite, np.zeros(2), np.ones(2), np.array([0.5]))

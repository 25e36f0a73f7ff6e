"""A frictionless core that only pushes: complementarity, and a solve with the openings as unknowns."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

import fem.contact.lift_off
import fem.linear.response
from fem.linear.core_interface import wall_openings
from fem.linear.response import build_response
from fem.linear.sparse import columns_of
from fem.presses.joint import Tip, press_tips
from fem.presses.to_force import press_to_force
from tests.support.objects.small_object import small_spec

TIPS, DEPTHS_MM = [Tip(3, 4.0, -2.0), Tip(1, -5.0, 3.0)], np.array([1.5, 1.0])


@pytest.fixture(scope="module")
def spec():
    return small_spec("frictionless", rim="held")


@pytest.fixture(scope="module")
def sliding(small_mesh, spec):
    return build_response(small_mesh, spec)


@pytest.fixture(scope="module")
def lifted(spec, sliding):
    return press_tips(spec, sliding, TIPS, DEPTHS_MM)


def assert_complementary(press):
    force, opening = press.core.force_n, press.core.opening_mm
    assert force.min() > -1e-8 * force.max()
    assert opening.min() >= 0
    assert abs(force * opening).max() < 1e-12
    assert 0.1 < (opening > 0).mean() < 0.9


def test_the_core_only_pushes_and_only_where_it_is_touched(lifted):
    assert_complementary(lifted)


def test_a_core_that_also_pulls_is_stiffer(spec, sliding, lifted, monkeypatch):
    """The planted fault: nothing ever lets go."""
    monkeypatch.setattr(fem.contact.lift_off, "MAX_STEPS", 1)
    monkeypatch.setattr(fem.contact.lift_off, "NOTHING", 1e9)
    stuck = press_tips(spec, sliding, TIPS, DEPTHS_MM)
    assert (stuck.force_n > 1.02 * lifted.force_n).all()
    with pytest.raises(AssertionError):
        assert_complementary(stuck)


def test_it_is_one_solve_with_the_open_vertices_as_unknowns(small_mesh, spec, lifted, monkeypatch):
    """Independent of the core's forces: openings join the motions before the factorization."""
    basis_of = fem.linear.response.motion_basis_of

    def with_openings(mesh, space, given):
        openings = wall_openings(space, given).displacement[:, lifted.core.opening_mm > 0]
        return columns_of([openings, basis_of(mesh, space, given)])

    monkeypatch.setattr(fem.linear.response, "motion_basis_of", with_openings)
    opened = replace(build_response(small_mesh, spec), core=None)
    direct = press_tips(spec, opened, TIPS, DEPTHS_MM)
    assert_allclose(lifted.force_n, direct.force_n, rtol=2e-3)
    scale = abs(direct.motion).max(axis=(0, 1))
    assert_allclose(lifted.motion, direct.motion, rtol=0, atol=5e-3 * scale)


def test_a_press_to_a_force_lifts_off_too(spec, sliding):
    press = press_to_force(spec, sliding, [[TIPS[0]]], 4.0)
    assert_allclose(press.force_n, 4.0, rtol=1e-5)
    assert_complementary(press)

"""Depths at which groups of indenters bear a force, of presses in closed form."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError, SolverError
from design.spec.object import ObjectSpec
from fem.presses import to_force
from fem.presses.joint import JointPress, Tip

SPEC = ObjectSpec(name="cube")
STIFFNESS = np.array([2.0, 3.0, 1.0])
COUPLED = np.array([[0, 0.1, 0.2], [0.1, 0, 0.0], [0.2, 0.0, 0]])
GROUPS = [[Tip(3, 0.0, 0.0), Tip(3, 9.0, 0.0)], [Tip(5, 0.0, 0.0)]]
"""Two tips of one depth, and one of another."""


def press(depth_mm):
    """Forces grow as the depth to the power of 1.5, and less where others press too."""
    force = STIFFNESS * depth_mm**1.5 - COUPLED @ depth_mm
    tips = tuple(tip for group in GROUPS for tip in group)
    return JointPress(tips, depth_mm, force, np.zeros((3, 2)), np.ones(3), np.zeros((1, 6)))


@pytest.mark.parametrize("force_n", [0.05, 2.0, 9.0])
def test_each_group_bears_the_force_at_its_own_depth(force_n):
    found = to_force.press_to_depths.__wrapped__(SPEC, press, GROUPS, force_n)
    assert_allclose(found.depth_mm[0], found.depth_mm[1])
    assert_allclose([found.force_n[:2].sum(), found.force_n[2]], force_n, rtol=1e-6)


def test_a_start_near_by_ends_at_the_same_depths():
    plain = to_force.press_to_depths.__wrapped__(SPEC, press, GROUPS, 4.0)
    for near in ([0.5, 1.5], [4.9, 4.9], [99.0, 0.1]):
        found = to_force.press_to_depths.__wrapped__(SPEC, press, GROUPS, 4.0, np.array(near))
        assert_allclose(found.depth_mm, plain.depth_mm, rtol=1e-5)


def test_forces_that_are_none_or_out_of_reach_are_refused():
    """The single tip bears 5^1.5 − 0.2 · 5 = 10.2 N at the tip's radius."""
    for force in (0.0, -1.0, np.inf, np.nan):
        with pytest.raises(InputError, match="needs a positive one"):
            to_force.press_to_depths.__wrapped__(SPEC, press, GROUPS, force)
    with pytest.raises(InputError, match=r"not reached within 5 mm.*most 10\.2 N"):
        to_force.press_to_depths.__wrapped__(SPEC, press, GROUPS, 10.3)
    thin = ObjectSpec.model_validate({"name": "x", "shell": {"thickness_mm": 3.5}})
    with pytest.raises(InputError, match=r"within 3\.5 mm"):
        to_force.press_to_depths.__wrapped__(thin, press, GROUPS, 9.0)


def test_what_does_not_settle_is_an_error(monkeypatch):
    monkeypatch.setattr(to_force, "MAX_STEPS", 1)
    with pytest.raises(SolverError, match="the press to 4 N did not converge: off by"):
        to_force.press_to_depths.__wrapped__(SPEC, press, GROUPS, 4.0)

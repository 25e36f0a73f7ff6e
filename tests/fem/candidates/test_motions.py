"""Which steps of a table belong to a force, and which candidates stay in a curved shell, by hand."""

from types import SimpleNamespace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError
from design.spec.object import ObjectSpec
from fem.candidates.motions import (
    CandidateMotions,
    FaceCandidates,
    candidate_lattices,
    require_below_the_surface,
    stands_out_mm,
)
from tests.support.objects.body_cases import body_spec


def steps(force_n, wanted_n):
    table = SimpleNamespace(force_n=np.asarray(force_n, float))
    return CandidateMotions.steps_around.__wrapped__(table, wanted_n)


def test_a_force_has_the_two_steps_about_the_nearest_judged_one():
    """Of two places, the first of which cannot be loaded beyond 5 N."""
    judged = [[[1.6, 2.4, 4.0, 5.0, 9.6, 5.0], [1.6, 2.4, 4.0, 6.0, 9.6, 14.4]]]
    found = [steps(judged, force) for force in (0.1, 3.4, 3.6, 5.0, 8.4, 8.6, 99.0)]
    assert found == [[0, 1], [0, 1], [2, 3], [2, 3], [2, 3], [4, 5], [4, 5]]
    judged[0][0] = [np.nan] * 6
    assert steps(judged, 8.6) == [4, 5]
    assert steps([[[6.4, 9.6]]], 1.0) == [0, 1]
    assert steps([[[6.4, 8.0, 9.6]]], 1.0) == [0, 2]


def test_a_magnet_must_lie_as_deep_in_a_ball_as_its_rim_does():
    """R − √(R² − r²) = 0.206 mm under a ball of 22 mm, for magnets of 3 mm radius."""
    spec = body_spec("sphere")
    axis = np.array([-4.0, 0.0, 4.0])
    for depth, sound in ((0.20, False), (0.21, True)):
        lattice = FaceCandidates(3, axis, axis, np.array([depth, 2.0]))
        assert_allclose(stands_out_mm(spec, lattice), 22 - np.sqrt(22**2 - 9) - depth, atol=2e-4)
        if sound:
            require_below_the_surface(spec, lattice)
        else:
            with pytest.raises(InputError, match=r"magnet 0\.2 mm deep stands 0\.00\d+ mm out"):
                require_below_the_surface(spec, lattice)


def test_a_magnet_under_a_flat_face_has_its_depth_of_silicone_over_it():
    axis = np.array([-4.0, 0.0, 4.0])
    lattice = FaceCandidates(2, axis, axis, np.array([1.3, 2.0]))
    assert stands_out_mm(ObjectSpec(name="cube"), lattice) == -1.3


def test_lattices_are_regular_up_to_a_pocket_s_radius_and_the_margins():
    spec = ObjectSpec(name="cube")
    for lattice in candidate_lattices(spec, pitch_mm=4.0, depth_step_mm=1.5, margin_mm=1.5):
        assert_allclose(lattice.x_mm, np.linspace(-18, 18, 10))
        assert_allclose(lattice.y_mm, np.linspace(-18, 18, 10))
        assert_allclose(lattice.depth_mm, np.linspace(1.5, 6.5, 5))
    usual = candidate_lattices(spec)[0]
    assert usual.shape == (19, 19, 6)
    assert (usual.x_mm[1] - usual.x_mm[0], usual.depth_mm[1] - usual.depth_mm[0]) == (2.0, 1.0)


@pytest.mark.parametrize(
    ("pocket_mm", "margin_mm", "sound"),
    [(6.0, 3.9, True), (6.0, 4.0, False), (41.9, 1.5, True), (42.0, 1.5, False)],
)
def test_a_shell_too_thin_or_a_face_too_small_has_no_room(pocket_mm, margin_mm, sound):
    spec = ObjectSpec.model_validate({"name": "x", "shell": {"pocket_diameter_mm": pocket_mm}})
    if sound:
        assert len(candidate_lattices(spec, margin_mm=margin_mm)) == 5
    else:
        with pytest.raises(InputError, match="face 1 has no room for candidates"):
            candidate_lattices(spec, margin_mm=margin_mm)

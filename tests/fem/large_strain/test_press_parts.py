"""Rows and results of a large-strain press put together from states that are made up."""

from types import SimpleNamespace

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation

from design.spec.object import ObjectSpec
from fem.large_strain import correction, press
from fem.large_strain.hyperelastic import yeoh
from fem.large_strain.single_press import LinearPress, PressRow

MATERIAL = yeoh(0.06)
RNG = np.random.default_rng(2)


def test_a_row_is_the_force_area_and_motions_of_a_state(monkeypatch):
    """Magnets move by their own shifts and rotations."""
    turn = Rotation.from_rotvec([[0.1, -0.2, 0.3], [0.5, 0, -0.4]])
    state = SimpleNamespace(
        displacement_mm=RNG.normal(size=9), contact_mpa=np.array([0.5, 0.0, 0.125, 0.0]),
        rotation=turn.as_matrix(), shift_mm=RNG.normal(size=(2, 3)),
    )  # fmt: skip
    face = SimpleNamespace(weights_mm2=np.array([1.0, 2.0, 4.0, 8.0]))
    setting = SimpleNamespace(problem=SimpleNamespace(face=face, radius_mm=5.0))
    monkeypatch.setattr(press, "sphere_centre_mm", lambda given, depth: 10 * depth)
    monkeypatch.setattr(
        press, "contact_state", lambda face, moved, centre, radius: (moved, centre, radius)
    )
    monkeypatch.setattr(
        press, "normal_force_n", lambda face, contact, mpa: float(contact[1] + contact[2] + mpa[2])
    )
    row = press.row_of_state.__wrapped__(setting, 0.75, state)
    assert (row.depth_mm, row.force_n, row.contact_area_mm2) == (0.75, 7.5 + 5 + 0.125, 5.0)
    assert_allclose(row.motion, np.hstack([state.shift_mm, turn.as_rotvec()]))


def rows(*depths, times=1.0):
    return [
        PressRow(depth, times * 2 * depth, times * 3 * depth, times * depth * np.ones((2, 6)))
        for depth in depths
    ]


@pytest.mark.parametrize(("wanted_mm", "status"), [(1.5, "converged"), (1.51, "diverged")])
def test_a_result_holds_both_models_at_the_depths_that_were_reached(monkeypatch, wanted_mm, status):
    near, state = (
        np.array([1, 3]),
        SimpleNamespace(
            displacement_mm=np.zeros(3), pressure_mpa=np.zeros(2), contact_mpa=np.array([5.0, 7.0])
        ),
    )
    frame = SimpleNamespace(number=4)
    setting = SimpleNamespace(
        frame=frame, xy_mm=np.array([3.0, -2.0]), mesh=None, near=near, spec=None,
        system=SimpleNamespace(space=None),
    )  # fmt: skip
    asked, shown = [], []

    def linear_press(given, depths_mm):
        asked.append(depths_mm.tolist())
        return LinearPress(rows(*depths_mm, times=10.0), np.ones(4), np.array([0.5, 0.25]))

    monkeypatch.setattr(press, "linear_press", linear_press)
    monkeypatch.setattr(press, "face_vertices", lambda system, spec, face: np.array([9, 8, 7, 6]))
    monkeypatch.setattr(press, "deformed_shape", lambda *given: shown.append(given[-1]))
    monkeypatch.setattr(press, "shape_of_unknowns", lambda *given: shown.append(given[-1]))
    monkeypatch.setattr(press, "vertices_under_the_tip", press.vertices_under_the_tip.__wrapped__)
    monkeypatch.setattr(press, "LargeStrainPress", lambda **given: SimpleNamespace(**given))
    found = press.collected_press.__wrapped__(setting, MATERIAL, rows(0.5, 1.5), state, wanted_mm)
    assert (found.face, found.x_mm, found.y_mm, found.status) == (4, 3.0, -2.0, status)
    assert asked == [[0.5, 1.5]]
    assert found.depth_mm.tolist() == [0.5, 1.5]
    assert found.force_n.tolist() == [1, 3]
    assert found.linear_force_n.tolist() == [10, 30]
    assert found.contact_area_mm2.tolist() == [1.5, 4.5]
    assert found.linear_contact_area_mm2.tolist() == [15, 45]
    assert found.motion[:, 1, 5].tolist() == [0.5, 1.5]
    assert found.linear_motion[:, 1, 5].tolist() == [5, 15]
    assert [one.vertices.tolist() for one in shown] == [[9, 8, 7, 6]] * 2
    assert [one.pressure_mpa.tolist() for one in shown] == [[0, 5, 0, 7], [0, 0.5, 0, 0.25]]


def test_a_correction_learns_from_depths_at_which_both_models_bear_a_force(monkeypatch):
    given = SimpleNamespace(
        face=3, depth_mm=np.arange(1.0, 6.0), force_n=np.array([0.0, 0.5, 0.25, 1.0, 2.0]),
        linear_force_n=np.array([0.125, 0.0, 0.75, 0.5, 3.0]), motion=RNG.normal(size=(5, 2, 6)),
        linear_motion=RNG.normal(size=(5, 2, 6)),
    )  # fmt: skip
    spec = ObjectSpec(name="cube")
    own = np.array([True, False]), np.array([0.0, 1.0, 0.0])
    monkeypatch.setattr(correction, "own_bodies", lambda given, face: own)
    found = correction.press_pair.__wrapped__(spec, given)
    kept = [2, 3, 4]
    assert found.depth_mm.tolist() == [3, 4, 5]
    assert found.force_n.tolist() == [0.25, 1, 2]
    assert found.linear_force_n.tolist() == [0.75, 0.5, 3]
    assert_allclose(found.motion, given.motion[kept])
    assert_allclose(found.linear_motion, given.linear_motion[kept])
    assert found.on_pressed_face is own[0]
    assert found.normal is own[1]

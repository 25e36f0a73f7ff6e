"""Shares, borders and averages of presses, by hand."""

from types import SimpleNamespace

import numpy as np
import pytest
from numpy.testing import assert_allclose
from threadpoolctl import threadpool_info, threadpool_limits

from design.errors import InputError
from design.layout.places.contact_grid import PlaceGrid
from design.processes import one_blas_thread
from design.spec.object import IndenterSpec, ObjectSpec
from fem.candidates import presses as candidates
from fem.presses import discretisation, shape
from fem.presses.joint import Tip, require_apart
from fem.presses.results import MagnetMotions
from fem.presses.table import require_on_face


def test_up_to_five_rows_and_columns_are_spread_over_the_locations_that_a_face_has():
    there = np.ones((9, 4), bool)
    found = discretisation.spread_places(there).reshape(9, 4)
    assert np.flatnonzero(found.any(axis=1)).tolist() == [0, 2, 4, 6, 8]
    assert found.any(axis=0).all()
    there[0] = there[8] = False
    some = discretisation.spread_places(there).reshape(9, 4)
    assert np.flatnonzero(some.any(axis=1)).tolist() == [1, 3, 4, 5, 7]


def test_errors_are_the_share_of_differences_and_none_where_a_press_missed():
    force, motion = np.array([0.03, -0.04]), np.array([0.1, 0.2])
    found = discretisation.depth_error(1.5, 0.8, force, motion)
    root = np.sqrt((0.03**2 + 0.04**2) / 2)
    assert_allclose([found.force_rms, found.force_worst], [0.8 * root, 0.8 * 0.04])
    assert_allclose([found.motion_rms, found.motion_worst], [0.8 * np.sqrt(0.025), 0.16])
    missed = discretisation.depth_error(1.5, 0.8, np.array([0.1, np.nan]), motion)
    assert (missed.depth_mm, missed.force_rms, missed.motion_worst) == (1.5, None, None)


def test_fields_at_edges_are_means_of_ends_that_carry_them():
    tets = np.array([[0, 1, 2, 3, 4, 5, 6, 7, 8, 9]])
    mesh = SimpleNamespace(tets=np.array([[0, 1, 2, 3]]))
    vertex, every = np.array([1.0, 2.0, 4.0, 8.0]), np.ones(4, bool)
    found = shape.pressures_on_nodes.__wrapped__(mesh, tets, vertex, every)
    assert_allclose(found, [1, 2, 4, 8, 1.5, 3, 2.5, 4.5, 5, 6])
    some = shape.pressures_on_nodes.__wrapped__(
        mesh, tets, vertex, np.array([True, True, False, True])
    )
    assert_allclose(some[4:], [1.5, 0, 0, 4.5, 5, 0])
    assert_allclose(shape.pressures_on_nodes.__wrapped__(mesh, tets[:, :4], vertex, every), vertex)


def face(flat=True, round_=False, high=(10.0, 8.0)):
    corners = np.array([[-1, -1], [1, 1], [-1, 1]]) * high
    frame = SimpleNamespace(flat=flat, round=round_, number=3)
    return SimpleNamespace(frame=frame, surface=SimpleNamespace(xy_mm=corners))


TIP = IndenterSpec(kind="hemisphere", radius_mm=3.0)


@pytest.mark.parametrize(
    ("xy", "inside"),
    [
        ((7.0, 5.0), True), ((7.002, 0.0), False), ((-7.0, -5.0), True), ((-7.002, 0.0), False),
        ((0.0, 5.002), False), ((0.0, -5.002), False), ((7.0005, 5.0005), True),
    ],
)  # fmt: skip
def test_a_tip_may_reach_the_border_to_a_micrometre(xy, inside):
    given = np.array([[0.0, 0.0], xy])
    if inside:
        require_on_face.__wrapped__(face(), TIP, given)
    else:
        with pytest.raises(InputError, match="hangs over the border of face 3"):
            require_on_face.__wrapped__(face(), TIP, given)
    require_on_face.__wrapped__(face(flat=False), TIP, given)


def test_a_tip_larger_than_the_face_and_one_beyond_a_round_border_are_refused():
    with pytest.raises(InputError, match="covers 6 × 6 mm, more than face 3"):
        require_on_face.__wrapped__(face(high=(10.0, 2.9)), TIP, np.zeros((1, 2)))
    round_face = face(round_=True, high=(10.0, 10.0))
    require_on_face.__wrapped__(round_face, TIP, np.array([[4.9, 4.9]]))
    with pytest.raises(InputError, match="hangs over"):
        require_on_face.__wrapped__(round_face, TIP, np.array([[5.0, 5.0]]))


def test_two_tips_may_touch_and_not_overlap_on_one_face():
    spec = ObjectSpec(name="c")
    apart = 2 * spec.indenter.radius_mm
    require_apart(spec, [Tip(3, 0.0, 0.0), Tip(3, apart, 0.0), Tip(5, 1.0, 0.0)])
    with pytest.raises(InputError, match=r"two indenters on face 3, 9\.9 mm apart"):
        require_apart(spec, [Tip(5, 0.0, 0.0), Tip(3, 0.0, 0.0), Tip(3, 0.0, 9.9)])


def test_presses_to_forces_are_mixed_of_the_depths_on_both_sides(monkeypatch):
    """Two vertices bear 1, 4 and 9 N at 1, 2 and 3 mm in all; 2 and 6 N lie a third and 0.4 beyond."""
    steps = np.array([[[0.5, 0.5], [1.0, 3.0], [4.0, 5.0]]])
    monkeypatch.setattr(candidates, "press_places", lambda *given: steps)
    monkeypatch.setattr(candidates, "pressed_nodes", lambda spec: np.array([[True]]))
    monkeypatch.setattr(
        candidates, "press_lattice", lambda spec: SimpleNamespace(xy_mm=np.zeros((1, 2)))
    )
    monkeypatch.setattr(candidates, "surface_weights_mm2", lambda surface: np.ones(2))
    press = SimpleNamespace(depths_mm=(1.0, 2.0, 3.0))
    spec = SimpleNamespace(press=press, pressed_forces_n=(4.0,))
    response = SimpleNamespace(surfaces=[None])
    found = candidates.presses_at_forces.__wrapped__(spec, response, 0, (0.5, 1.5))
    assert_allclose(found.force_n, [[2.0, 6.0]])
    assert_allclose(found.depth_mm, [[1 + 1 / 3, 2.4]])
    assert_allclose(found.pressure_mpa[0, 0], [0.5 + 0.5 / 3, 0.5 + 2.5 / 3])
    assert_allclose(found.pressure_mpa[0, 1], [1 + 0.4 * 3, 3 + 0.4 * 2])
    far = SimpleNamespace(press=press, pressed_forces_n=(4.0, 20.0))
    both = candidates.presses_at_forces.__wrapped__(far, response, 0, (0.5, 1.5))
    assert_allclose(both.force_n, [[2.0, 6.0, 3.0, 9.0]])
    assert_allclose(both.depth_mm[0, 3], 3.0)
    shallow = SimpleNamespace(press=press, pressed_forces_n=(1.0,))
    low = candidates.presses_at_forces.__wrapped__(shallow, response, 0, (0.5, 1.0))
    assert_allclose(low.depth_mm, [[0.5, 1.0]])
    assert_allclose(low.pressure_mpa[0], [[0.25, 0.25], [0.5, 0.5]])


def test_places_that_a_face_has_not_are_left_out_of_every_press():
    motion = np.arange(2 * 3 * 2 * 2 * 6, dtype=float).reshape(2, 3, 2, 2, 6)
    grid = PlaceGrid(np.arange(3.0), np.zeros(1))
    whole = MagnetMotions(np.array([1, 3]), grid, np.array([0.5, 1.0]), motion)
    assert whole.pressed.all()
    assert_allclose(whole.all_motions, motion.reshape(12, 2, 6))
    motion[1, 0] = np.nan
    assert whole.pressed.tolist() == [[True] * 3, [False, True, True]]
    assert_allclose(whole.all_motions, np.concatenate([motion[0], motion[1, 1:]]).reshape(10, 2, 6))


def test_presses_take_one_thread_of_linear_algebra_and_give_the_others_back():
    with threadpool_limits(2, "blas"):
        with one_blas_thread():
            assert blas_threads() == {1}
        assert blas_threads() == {2}


def blas_threads():
    return {one["num_threads"] for one in threadpool_info() if one["user_api"] == "blas"}

"""Axes of magnets and chips in batches, and layouts of several faces."""

import numpy as np
import torch
from numpy.testing import assert_allclose, assert_array_equal
from scipy.spatial.transform import Rotation

from design.layout.places.positions import chip_on_board
from design.layout.pockets import board_frame
from design.spec.object import ObjectSpec
from estimator.layouts.batch import Layouts, chip_axes, layouts_by_face, magnet_axes
from tests.support.mechanics.candidate_cases import random_layouts


def test_axes_are_the_normal_turned_by_the_rotation_vector():
    turns = np.array([[0.3, -0.2], [0.0, 0.0], [-1.2, 0.5]])
    layouts = random_layouts(1, dtype=torch.float64)
    few = Layouts(
        layouts.magnet_mm[:, :3],
        torch.as_tensor(turns)[None],
        layouts.polarity[:, :3],
        layouts.sensor_mm,
    )
    wanted = Rotation.from_rotvec(np.column_stack([turns, np.zeros(3)])).apply([0, 0, 1.0])
    assert_allclose(magnet_axes(few)[:, 0].T, wanted, atol=1e-12)


def test_chips_turn_with_the_azimuth_and_stand_at_azimuth_0_in_the_middle():
    spec = ObjectSpec.model_validate({"name": "c", "sensors": {"chip": "outward"}})
    on_board = chip_on_board(spec.sensors)
    places = np.array([[3.0, 4.0], [-2.0, 1.0], [0.0, -5.0], [0.0, 0.0]])
    found = chip_axes(torch.as_tensor(places)[None], torch.as_tensor(on_board))
    for place, axes in zip(places, found[0], strict=True):
        board = board_frame(np.arctan2(place[1], place[0]))
        assert_allclose(axes, (board @ on_board).T, atol=1e-12)


def test_rows_and_changes_reach_the_layouts_of_all_faces():
    one, two = random_layouts(3, seed=1), random_layouts(3, seed=2)
    both = layouts_by_face({1: one, 4: two}, 4)
    assert (both.face, len(both)) == (4, 3)
    assert both.layouts_of_face(1) is one
    assert both.layouts_of_face(2) is both
    some = both[1:]
    assert (some.face, len(some), len(some.layouts_of_face(1))) == (4, 2, 2)
    for name in ("magnet_mm", "turn_rad", "polarity", "sensor_mm"):
        assert_array_equal(getattr(some, name), getattr(two, name)[1:])
        assert_array_equal(getattr(some.layouts_of_face(1), name), getattr(one, name)[1:])
    seen = []

    def change(layouts, face):
        seen.append(face)
        return layouts[:1]

    changed = both.map_faces(change)
    assert (seen, len(changed), len(changed.layouts_of_face(1)), changed.face) == ([1, 4], 1, 1, 4)
    assert len(one.map_faces(change)) == 1
    assert seen[-1] is None

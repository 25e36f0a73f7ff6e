"""Depths of pockets, boards that need to move inwards, and corners of grids, with borders by hand."""

from types import SimpleNamespace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.fit import curved
from design.spec.object import ObjectSpec

CYLINDER = ObjectSpec.model_validate(
    {"name": "x", "body": {"kind": "cylinder", "size_mm": [44.0, 44.0, 60.0]}}
)


@pytest.fixture
def told(monkeypatch):
    """What is said of a magnet's height and its pocket's depth, in 8 mm of silicone; pockets are 3 mm
    deep unless magnets have depths of their own."""
    monkeypatch.setattr(curved, "body_of", lambda spec: SimpleNamespace(silicone_mm=8.0))

    def of(height_mm, deep_mm, depth_mm=None):
        spec = SimpleNamespace(
            shell=SimpleNamespace(pocket_depth_mm=3.0), magnets=SimpleNamespace(depth_mm=depth_mm)
        )
        body = SimpleNamespace(height_mm=height_mm, label="magnet 1")
        pocket = SimpleNamespace(body=body, lowest_mm=-deep_mm)
        return list(curved._check_depth.__wrapped__(spec, pocket))

    return of


def test_a_magnet_lies_within_its_pocket_and_that_within_the_silicone(told):
    assert told(2.99, 7.99) == []
    assert told(3.5, 7.99, 4.0) == []  # of its own depth: no pocket to be higher than
    (tall,) = told(3.0, 7.0)
    assert tall.startswith(
        "magnet 1: a magnet 3 mm high in a pocket 7 mm deep does not lie within the 8"
    )
    assert tall.endswith("Make shell.pocket_depth_mm more than 3, or take a thinner magnet")
    for deep, by in ((8.0, 0), (8.25, 0.25)):
        (text,) = told(2.0, deep)
        assert text.endswith(f"Lower shell.pocket_depth_mm by more than {by:g} mm")
        (text,) = told(2.0, deep, 4.0)
        assert text.endswith(f"Lower magnets.depth_mm by more than {by:g} mm")
    (both,) = told(5.0, 9.5)
    assert both.endswith("Lower shell.pocket_depth_mm by more than 1.5 mm")


def test_boards_move_inwards_until_they_and_the_walls_between_them_have_room(monkeypatch):
    """Boards sink by their radius less 4 mm, walls between recesses are 9 mm less the radius."""
    step, core, sensors = curved._STEP_MM, CYLINDER.core, CYLINDER.sensors
    monkeypatch.setattr(curved, "room_for_recesses", lambda spec: (room[0], "core.wall_mm"))
    monkeypatch.setattr(
        curved,
        "board_sinks_mm",
        lambda spec: (np.array([0.0, spec.sensors.radius_mm - 4]), np.array([0.1])),
    )
    monkeypatch.setattr(curved, "smallest_recess_wall_mm", lambda spec: walls[0](spec))
    wide = CYLINDER.printer.wall_mm

    def moved():
        text = curved._nearer_boards(CYLINDER)
        return text.removeprefix("With ").split(" they would")[0]

    def inwards(by_mm):
        return (
            f"sensors.radius_mm = {sensors.radius_mm - by_mm:g}, core.recess_inner_radius_mm = "
            f"{core.recess_inner_radius_mm - by_mm:g} and core.recess_outer_radius_mm = "
            f"{core.recess_outer_radius_mm - by_mm:g}"
        )

    sink = sensors.radius_mm - 4
    walls = [lambda spec: wide]
    room = [core.recess_depth_mm + sink + 1]
    assert moved() == inwards(step)
    room = [core.recess_depth_mm + sink - 1.5 * step]
    assert moved() == inwards(2 * step)
    room = [core.recess_depth_mm + sink - 2 * step]  # not enough where it is just as deep
    assert moved() == inwards(3 * step)
    walls = [
        lambda spec: (
            wide if spec.sensors.radius_mm < sensors.radius_mm - 4.5 * step else wide - 1e-3
        )
    ]
    assert moved() == inwards(5 * step)
    alone = CYLINDER.changed(
        sensors=sensors.changed(count_per_face=1), body=CYLINDER.body.changed(sensed_faces=(1,))
    )
    assert inwards(3 * step) in curved._nearer_boards(alone)
    two = CYLINDER.changed(
        sensors=sensors.changed(count_per_face=2), body=CYLINDER.body.changed(sensed_faces=(1,))
    )
    assert inwards(5 * step) in curved._nearer_boards(two)
    room = [core.recess_depth_mm - 50.0]
    assert curved._nearer_boards(CYLINDER) == (
        "Take a smaller board (sensors.package_mm), a thinner shell or a larger body"
    )
    own = CYLINDER.changed(
        sensors=sensors.changed(positions_mm=((1.0, 2.0), (3.0, 0.0), (-2.0, 1.0)))
    )
    assert curved._nearer_boards(own).startswith(
        "Move them inwards (sensors.positions_mm), or take a s"
    )


def test_all_four_corners_of_a_grid_must_stay_for_every_share(monkeypatch):
    asked = []

    def stays(frame, places, reach):
        asked.append((places, reach))
        return ~((places[:, 0] > 0) & (places[:, 1] < -2.9))

    monkeypatch.setattr(curved, "stays_on_patch", stays)
    shares = np.array([0.0, 0.5, 0.75, 1.0])
    found = curved._corners_stay.__wrapped__(None, np.array([2.0, 4.0]), shares, 1.5)
    assert found.tolist() == [True, True, False, False]
    ((places, reach),) = asked
    assert reach == 1.5
    wanted = [(s * x, s * y) for s in shares for x in (2, -2) for y in (4, -4)]
    assert_allclose(places, wanted)

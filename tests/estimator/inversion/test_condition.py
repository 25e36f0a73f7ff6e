"""Condition of an object: the one that asks for the most work, and why."""

import pytest

from estimator.inversion.condition import object_condition


@pytest.mark.parametrize(
    ("shows", "name", "why"),
    [
        ({}, "fine", ""),
        ({"chips_out": ["F3-1"]}, "fine", "read without F3-1"),
        ({"drifting": ["F1-X1", "F2-Y1"]}, "zero again", "drifted in F1-X1 and F2-Y1"),
        ({"unexplained": 0.5, "beside_magnet": 0.4}, "zero again", "50 % of the last frames"),
        ({"unexplained": 0.5, "beside_magnet": 0.1}, "recalibrate", "nothing that the estimator"),
        ({"slip_mm": 0.07}, "recalibrate", "the core slipped by about 0.07 mm: calibrate again"),
        ({"slip_mm": 0.07, "drifting": ["F1-X1"]}, "recalibrate", "slipped"),
        ({"slip_mm": 0.07, "chips_out": ["F1-1", "F1-2"]}, "recast", "F1-1 and F1-2"),
        ({"chips_out": [f"F1-{n}" for n in range(9)]}, "recast", "F1-4 and 4 more"),
    ],
)
def test_the_condition_that_asks_for_most_is_named(shows, name, why):
    condition = object_condition(**{"unexplained": 0.0} | shows)
    assert condition.name == name
    assert why in condition.why
    assert str(condition).startswith(name)


def test_a_few_strange_frames_are_fine():
    assert object_condition(0.1, 0.1).name == "fine"

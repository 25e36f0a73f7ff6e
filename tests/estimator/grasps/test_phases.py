"""Grasps are found, numbered and split into phases."""

import numpy as np
import pytest

from estimator.grasps.phases import find_grasps

TIME_S = np.arange(100) / 10


def found(force):
    return find_grasps(TIME_S[: len(force)], np.asarray(force, float))


def trapezium(first, rise, hold, fall, level, frames=100):
    x = np.arange(frames)
    return level * np.interp(
        x, [first, first + rise, first + rise + hold, first + rise + hold + fall], [0, 1, 1, 0]
    )


def test_phases_of_a_trapezium():
    (grasp,) = found(trapezium(20, 10, 30, 5, 8.0))
    assert (grasp.number, grasp.approach, grasp.regrasps) == (1, 0, 0)
    assert grasp.level_n == pytest.approx(8.0)
    # above 0.3 N from frame 20 + 10·0.3/8 on, above 0.9 of the level from frame 29 to 60.5
    assert (grasp.start, grasp.hold, grasp.release, grasp.end) == (21, 29, 61, 65)


def test_grasps_are_numbered_and_the_next_is_approached_from_the_end_of_the_last():
    first, second = found(trapezium(10, 4, 12, 4, 5.0) + trapezium(60, 4, 12, 4, 9.0))
    assert (first.number, second.number) == (1, 2)
    assert second.approach == first.end
    assert second.level_n == pytest.approx(9.0)


def test_a_grip_lost_and_taken_again_is_a_regrasp():
    force = trapezium(10, 4, 60, 4, 6.0)
    force[40:44] = 1.5
    (grasp,) = found(force)
    assert grasp.regrasps == 1


def test_a_short_gap_belongs_to_the_grasp_and_a_long_one_parts_it():
    for gap, number in ((1, 1), (8, 2)):
        force = trapezium(10, 4, 60, 4, 6.0)
        force[40 : 40 + gap] = 0.0
        assert len(found(force)) == number


def test_rest_holds_no_grasp_and_noise_is_none():
    noise = 0.25 * np.random.default_rng(0).standard_normal(100)
    assert found(np.zeros(100)) == []
    assert found(abs(noise)) == []
    assert found(np.where(np.arange(100) % 50 < 3, 5.0, 0.0)) == []  # ghosts of three frames
    assert found(np.zeros(0)) == []


def test_a_grasp_that_the_recording_cuts_off_is_one():
    (grasp,) = found(trapezium(60, 5, 80, 5, 6.0))
    assert grasp.end == 100

"""Offsets and gains from Earth's field: intervals hold the truth, and what cannot be told is not told."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from design.layout.places.positions import sensor_layout
from estimator.calibration.most_probable import MostProbable
from instobj.bench.bringup.asking.asked import POSES
from instobj.bench.bringup.diagnosis.earth import (
    first_field,
    from_earth,
    stated_intervals,
    turn_to_object,
)
from instobj.bench.bringup.diagnosis.findings import ChipFound
from tests.support.new_objects import SMALL
from tests.support.physics_pages import assert_page, chosen

FRAMES = 210
CHIPS = tuple(ChipFound(site, np.eye(3)) for site in range(10))
RNG = np.random.default_rng(3)
GAIN = 1 + 0.02 * RNG.standard_normal((10, 3))
OFFSET = 80 * RNG.standard_normal((10, 3))
FIELD_UT = np.array([18.0, 3.0, -44.0])
TIMES_S = 25.0 * np.arange(7)


@pytest.fixture(scope="module")
def means():
    laid = Rotation.from_rotvec(np.deg2rad(4) * RNG.standard_normal((7, 3)))
    fields = np.stack([turn_to_object(k % 6) @ laid[k].apply(FIELD_UT) for k in range(7)])
    counts = 0.82 * np.einsum("cab,kb->kca", sensor_layout(SMALL).axes, fields)
    drift = 0.05 * RNG.standard_normal((10, 3)) * TIMES_S[:, None, None]
    noise = np.array([22.0, 22.0, 11.0]) / np.sqrt(FRAMES) * RNG.standard_normal((7, 10, 3))
    return GAIN * counts + OFFSET + drift - drift.mean(axis=0) + noise


@pytest.fixture(scope="module")
def found(means):
    return from_earth(SMALL, CHIPS, means, TIMES_S, FRAMES)


def test_every_pose_is_a_rotation_that_does_what_the_question_asks():
    for pose, (up, ahead) in enumerate(POSES):
        turn = turn_to_object(pose)
        assert np.allclose(turn @ turn.T, np.eye(3))
        assert np.linalg.det(turn) == pytest.approx(1)
        for name, room in ((up, turn[:, 2]), (ahead, turn[:, 0])):
            assert room["xyz".index(name[1])] == (1 if name[0] == "+" else -1)


def test_stated_intervals_hold_gains_and_offsets(found):
    gain = found.gain / found.gain.mean() - GAIN / GAIN.mean()
    assert np.mean(abs(gain) < found.gain_interval) >= 0.85
    assert np.mean(abs(found.offset - OFFSET) < found.offset_interval) >= 0.85
    assert found.gain_interval.max() < 0.2
    assert found.offset_interval.max() < 6
    assert abs(found.field_ut - np.linalg.norm(FIELD_UT)) < found.field_interval_ut


def test_intervals_are_1_96_standard_deviations_each_of_its_own_unknown():
    """Of one chip; of the field the deviation along it counts, (3, 4, 0) / 5; a dead axis has none."""
    values = {"field_ut": np.array([3.0, 4, 0]), "ln_gain": np.array([[0.1, -0.2, 0]])}
    values["offset"] = np.array([[5.0, 6, 7]])
    sd = np.array([0.5, 1, 2, 0.01, 0.02, 0.03, 0.4, 0.5, 0.6])
    found = MostProbable(values, np.diag(1 / sd**2))
    stated = stated_intervals(found, np.array([[1.0, 1, np.nan]]), 0.4)
    assert stated.field_ut == pytest.approx(5)
    assert stated.field_interval_ut == pytest.approx(1.96 * np.hypot(0.6 * 0.5, 0.8 * 1))
    gain = np.exp([0.1, -0.2])
    assert np.allclose(stated.gain[0, :2], gain)
    assert np.allclose(stated.gain_interval[0, :2], 1.96 * np.array([0.01, 0.02]) * gain)
    assert np.allclose(stated.offset[0, :2], [5, 6])
    assert np.allclose(stated.offset_interval[0, :2], 1.96 * np.array([0.4, 0.5]))
    assert np.isnan([stated.gain[0, 2], stated.gain_interval[0, 2], stated.offset[0, 2]]).all()
    assert stated.misfit == 0.4


def test_all_gains_together_are_told_as_a_stronger_field(means, found):
    stronger = OFFSET + 1.1 * (means - OFFSET)
    again = from_earth(SMALL, CHIPS, stronger, TIMES_S, FRAMES)
    assert again.field_ut == pytest.approx(1.1 * found.field_ut, rel=0.01)
    assert np.allclose(again.gain, found.gain, atol=0.02)


def test_what_is_found_in_earth_s_field_is_as_on_the_page(found):
    lines = chosen(found, "field_ut", "field_interval_ut", "offset", "gain", "gain_interval")
    assert_page("instobj/bench/bringup", [*lines, ("misfit", found.misfit)], "earth, ")


def test_the_first_field_is_that_of_least_squares_about_the_mean_pose():
    """Chips turned any way, offsets of their own that the mean over the poses takes away; a channel
    that is not known."""
    rng = np.random.default_rng(6)
    axes = Rotation.random(4, random_state=1).as_matrix()
    poses = Rotation.random(5, random_state=2).as_matrix()
    field = np.array([21.0, -4.0, 39.0])
    counts = 0.8 * np.einsum("cab,kbd,d->kca", axes, poses, field) + rng.normal(0, 80, (4, 3))
    counts[:, 2, 1] = np.nan
    found = first_field(counts - counts.mean(axis=0), axes, poses, 0.8)
    assert found == pytest.approx(field)

"""Novelty and the widths of intervals at places that training never saw."""

import numpy as np
import pytest

from design.spec.object import TrainingSpec
from estimator.evaluation.evaluation import evaluate_intervals
from estimator.frames.face_data import face_data
from estimator.frames.splits import split_presses
from estimator.networks.face_model import predict
from estimator.networks.intervals.conformal import student_bound
from estimator.networks.training.face import FitSettings, fit_estimator
from tests.support.recordings.synthetic_frames import synthetic_frames

pytestmark = pytest.mark.usefixtures("statistics_in_full")
FACE = 4
TRAINING = TrainingSpec(hidden_units=(48,), epochs=20, ensemble=2, trees=10)
PLACES = (0, 2, 4, 5, 7, 9)
"""On one half of the face; the other half is new."""


@pytest.fixture(scope="module")
def frames():
    return synthetic_frames(faces=(FACE,), presses=5, loaded=14, places=PLACES)


@pytest.fixture(scope="module")
def model(frames):
    split = split_presses(frames, 1)
    parts = frames.select(split.train), frames.select(split.validation)
    return fit_estimator(*parts, FitSettings(FACE, TRAINING, 1))


@pytest.fixture(scope="module")
def elsewhere():
    """Presses on the other half, 6 mm and more away."""
    return synthetic_frames(faces=(FACE,), presses=2, loaded=14, places=range(15, 20), seed=4)


def test_new_places_are_novel_and_new_presses_of_known_places_are_not(model, frames, elsewhere):
    test = frames.select(split_presses(frames, 1).test)
    known, new = (predict(model, face_data(part, FACE).frames).novel for part in (test, elsewhere))
    assert known.mean() < 0.15
    pressed = face_data(elsewhere, FACE).heatmap_n.sum(axis=(1, 2)) > 3
    assert new[pressed].mean() > 0.8


def test_intervals_hold_at_new_places_because_they_are_wider(model, frames, elsewhere):
    report = evaluate_intervals(model, elsewhere)
    assert report.force_cover > 0.85
    assert report.position_cover > 0.85
    known = evaluate_intervals(model, frames.select(split_presses(frames, 1).test))
    assert report.median_position_radius_mm > 2 * known.median_position_radius_mm
    network = model.network.coverage
    kept = network.place_slope_mm.clone()
    network.place_slope_mm.fill_(0.0)
    without = evaluate_intervals(model, elsewhere)
    network.place_slope_mm.copy_(kept)
    assert without.position_cover < 0.6, "planted fault: radii that do not grow"


def test_bounds_of_few_groups_hold_the_errors_of_one_more():
    """Three groups of unlike sizes that err alike in all frames: t of 3 degrees holds 90 % of a fourth,
    where the largest of three holds 75 %."""
    rng = np.random.default_rng(0)
    group = np.repeat([4, 7, 9], [1, 5, 20])
    off = np.abs(rng.normal(0, 3.0, (1500, 4)))
    frames = np.repeat([0, 1, 2], [1, 5, 20])
    bounds = np.array([student_bound(one[frames], group, 0.9) for one in off])
    assert np.mean(off[:, 3] <= bounds) == pytest.approx(0.9, abs=0.025)
    assert np.mean(off[:, 3] <= off[:, :3].max(axis=1)) == pytest.approx(0.75, abs=0.04)
    assert student_bound(np.array([3.0, 4.0]), np.array([0, 0]), 0.9) == pytest.approx(
        6.313752 * np.sqrt(12.5)
    )

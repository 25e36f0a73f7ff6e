"""Simple regressions beside a model: what they are fitted to, their errors, differences by press."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError
from design.spec.object import TrainingSpec
from estimator.evaluation import baselines
from estimator.evaluation.baselines import (
    REGRESSORS,
    ContactAnswers,
    HeldOutAnswers,
    baseline_reports,
    held_out_answers,
    paired_difference,
)
from estimator.frames.splits import split_presses
from estimator.networks.training.face import FitSettings, fit_estimator
from tests.support.recordings.synthetic_frames import synthetic_frames

pytestmark = pytest.mark.usefixtures("statistics_in_full")
FACE = 4


@pytest.fixture(scope="module")
def frames():
    return synthetic_frames(faces=(FACE,), presses=4, loaded=12, places=range(0, 20, 4))


@pytest.fixture(scope="module")
def held_out(frames):
    split = split_presses(frames, 1)
    training = TrainingSpec(hidden_units=(32,), epochs=4, history_frames=2, ensemble=1)
    model = fit_estimator(
        frames.select(split.train), frames.select(split.validation), FitSettings(FACE, training, 1)
    )
    return held_out_answers(model, frames, split)


def test_every_baseline_learns_force_and_place_from_the_training_presses(held_out):
    rows = {row.name: row for row in baseline_reports(held_out)}
    assert list(rows) == ["model", *REGRESSORS]
    always_the_mean_n = np.abs(held_out.true_force_n - held_out.true_force_n.mean()).mean()
    for name in REGRESSORS:
        assert rows[name].total_force_n < 0.5 * always_the_mean_n, name
        assert rows[name].place_mm < 3.0, name
        assert rows[name].fitted_frames > len(held_out.true_force_n)
    assert rows["extra trees"].presses == len(np.unique(held_out.press_id)) > 1


def test_what_the_test_says_is_not_learned(frames, held_out):
    """Labels of the test presses that are all wrong leave every answer as it is."""
    split = split_presses(frames, 1)
    wrong = frames.force_n.copy()
    wrong[split.test] *= 3
    training = TrainingSpec(hidden_units=(32,), epochs=1, history_frames=2, ensemble=1)
    model = fit_estimator(
        frames.select(split.train), frames.select(split.validation), FitSettings(FACE, training, 1)
    )
    other = held_out_answers(model, replace(frames, force_n=wrong), split)
    for mine, theirs in zip(held_out.answers[1:], other.answers[1:], strict=True):
        assert_allclose(mine.force_n, theirs.force_n)
    assert_allclose(other.true_force_n, 3 * held_out.true_force_n)


def test_presses_weigh_alike_however_long():
    """Two presses with differences 1 and 3: mean 2, whatever their lengths; bootstrap within."""
    press = np.array([5] * 30 + [8])
    error = np.where(press == 5, 2.0, 4.0)
    found = paired_difference(error, np.ones(31), press)
    assert found.mean == pytest.approx(2.0)
    assert (found.low, found.high) == (1.0, 3.0)
    alike = paired_difference(error, error, press)
    assert (alike.mean, alike.low, alike.high) == (0, 0, 0)


def test_a_test_part_without_contact_is_refused(frames, held_out):
    split = split_presses(frames, 1)
    rest = np.isnan(frames.contact_xy_mm[:, 0, 0])
    silent = replace(split, train=split.train | (split.test & ~rest), test=split.test & rest)
    training = TrainingSpec(hidden_units=(16,), epochs=1, ensemble=1)
    model = fit_estimator(
        frames.select(split.train), frames.select(split.validation), FitSettings(FACE, training, 1)
    )
    with pytest.raises(InputError, match="no contact in the tested part"):
        held_out_answers(model, frames, silent)


def test_reports_are_means_of_distances_and_of_forces_missed_over_their_span():
    """Three frames of two presses; the model is right but for 1 N and 5 mm in the last frame."""
    force, xy = np.array([4.0, 8.0, 10.0]), np.array([[0.0, 1], [2, 3], [4, -5]])
    held_out = HeldOutAnswers(
        face=FACE, true_force_n=force, true_xy_mm=xy, span_n=np.array([20.0, 10, 40]),
        press_id=np.array([3, 3, 9]), time_s=np.arange(3.0), grid_x_mm=np.zeros(1),
        grid_y_mm=np.zeros(1), force_halfwidth_n=np.ones(3), interval_cover=0.9,
        answers=(
            ContactAnswers("model", force - [0, 0, 1], xy - np.array([[0, 0], [0, 0], [-3, 4]])),
            ContactAnswers("ridge", force - [-2, 1, -4], xy - np.array([[-0.6, -0.8], [0, 3], [0, -6]])),
        ),
        fitted_frames={"ridge": 77},
    )  # fmt: skip
    model, ridge = baseline_reports(held_out)
    assert (model.name, model.fitted_frames, model.presses, model.face) == ("model", 0, 2, FACE)
    assert (ridge.name, ridge.fitted_frames, ridge.presses, ridge.face) == ("ridge", 77, 2, FACE)
    assert [model.total_force_n, model.place_mm] == pytest.approx([1 / 3, 5 / 3])
    assert [ridge.total_force_n, ridge.place_mm] == pytest.approx([7 / 3, 10 / 3])
    assert model.total_force_percent == pytest.approx(100 * (1 / 40) / 3)
    assert ridge.total_force_percent == pytest.approx(100 * (2 / 20 + 1 / 10 + 4 / 40) / 3)
    assert ridge.force_n_less_model.mean == pytest.approx((1.5 + 3) / 2)
    assert ridge.place_mm_less_model.mean == pytest.approx((2 + 1) / 2)
    assert model.place_mm_less_model.mean == 0


def test_no_more_frames_than_wanted_are_drawn_in_their_order():
    class Data(list):
        def select(self, rows):
            return Data(self[row] for row in rows)

    whole = Data(range(10, 40))
    assert baselines.drawn_frames.__wrapped__(whole, 30) is whole
    some = baselines.drawn_frames.__wrapped__(whole, 29)
    assert len(set(some)) == 29
    assert some == sorted(some)

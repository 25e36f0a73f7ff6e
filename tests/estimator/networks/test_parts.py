"""Parts of estimators by hand: blends, kernels of a process, and schedules."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
import torch
from numpy.testing import assert_allclose, assert_array_equal

from design.spec.object import TrainingSpec
from estimator.frames.face_data import HISTORY, channel_label
from estimator.networks import process
from estimator.networks.ensemble import sigma_counts
from estimator.networks.forest import LEAST_FRAMES_OF_LEAF
from estimator.networks.intervals import coverage, held_out
from estimator.networks.intervals.coverage import Coverage, gp_weight, growth
from estimator.networks.network import (
    ContactEstimator,
    HeadsNetwork,
    Reading,
    heatmap_centre_mm,
    with_force,
)
from estimator.networks.training import face as training
from estimator.networks.training.face import FitSettings


def test_noise_of_a_change_over_history_is_that_of_two_readings():
    data = SimpleNamespace(frames=SimpleNamespace(noise_counts=np.array([20.0, 10.0, 5.0])))
    channels = ((3, 0, 0), (3, 1, 2), (HISTORY + 3, 0, 0), (HISTORY, 0, 1), (HISTORY - 1, 0, 1))
    found = sigma_counts.__wrapped__(data, channels)
    assert_allclose(found, [20, 5, 20 * np.sqrt(2), 10 * np.sqrt(2), 10])
    assert channel_label((3, 0, 1)) == "F3-Y1"
    assert channel_label((HISTORY + 5, 2, 2)) == "dF5-Z3"


@pytest.mark.parametrize(
    ("truth", "shares"),
    [
        (lambda a, b, c: a, (1.0, 0.0, 0.0)),
        (lambda a, b, c: 0.5 * a + 0.25 * b + 0.25 * c, (0.5, 0.25, 0.25)),
        (lambda a, b, c: 0.7 * b + 0.3 * c, (0.0, 0.75, 0.25)),
    ],
)
def test_answers_are_blended_by_the_quarters_that_err_least(truth, shares):
    rng = np.random.default_rng(0)
    answers = [rng.normal(size=200) for _ in range(3)]
    wanted = truth(*answers)
    found, error = held_out.least_cost(answers, lambda blended: abs(blended - wanted))
    assert found == shares
    blend = sum(share * answer for share, answer in zip(shares, answers, strict=True))
    assert_allclose(error, abs(blend - wanted))


def test_the_pitch_is_the_narrowest_step_of_both_axes():
    def data(x, y):
        return SimpleNamespace(frames=SimpleNamespace(grid_x_mm=np.array(x), grid_y_mm=np.array(y)))

    pitch = held_out.pitch_mm.__wrapped__
    assert pitch(data([0.0, 3.0, 6.0], [0.0, 2.5, 7.0])) == 2.5
    assert pitch(data([0.0], [0.0])) == 1.0


def reading(heatmap, force):
    frames = len(force)
    return Reading(
        torch.as_tensor(heatmap), torch.as_tensor(force), torch.zeros(frames, 2),
        torch.ones(frames), torch.ones(frames), torch.ones(frames), torch.ones(frames),
    )  # fmt: skip


def test_another_force_scales_the_normal_heatmap_and_keeps_the_tangential_ones():
    maps = np.arange(24.0).reshape(2, 3, 2, 2)
    found = with_force(reading(maps, [2.0, 4.0]), torch.tensor([6.0, 2.0]))
    assert_allclose(found.heatmap_n[:, :2], maps[:, :2])
    assert_allclose(found.heatmap_n[0, 2], 3 * maps[0, 2])
    assert_allclose(found.heatmap_n[1, 2], maps[1, 2] / 2)
    assert_allclose(found.force_n, [6, 2])


def test_a_heatmap_s_centre_weighs_pushes_alone():
    grid = torch.tensor([[0.0, 0.0], [0.0, 4.0], [2.0, 0.0], [2.0, 4.0]])
    maps = torch.tensor([[[1.0, 3.0], [-9.0, 0.0]], [[-1.0, 0.0], [0.0, 0.0]]])
    assert_allclose(heatmap_centre_mm(maps, grid), [[0, 3], [0, 0]])


def estimator():
    x, y = np.array([-6.0, 0.0, 6.0]), np.array([-4.0, 8.0])
    member = HeadsNetwork(np.ones(2), x, y, (4,), 1.0, 1, False)
    return ContactEstimator([member], Coverage(2, 3), None, None)


def test_a_place_may_be_as_far_as_the_furthest_corner_of_the_grid():
    found = estimator().furthest_mm(torch.tensor([[0.0, 0.0], [6.0, 8.0], [-7.0, 0.0]]))
    assert_allclose(found, [10.0, np.hypot(12, 12), np.hypot(13, 8)])


@pytest.mark.parametrize(
    ("novelty", "share", "wider"),
    [
        (0.5, 0, 0),
        (1.0, 0, 0),
        (1.25, 0.15625, 0.5),
        (1.5, 0.5, 0.5**0.5),
        (2.0, 1, 1),
        (5.0, 1, 2),
    ],
)
def test_newness_and_growth_by_hand(novelty, share, wider):
    at = torch.tensor([novelty])
    assert float(gp_weight(at)) == pytest.approx(share, abs=1e-6)
    assert float(growth(at)) == pytest.approx(wider, abs=1e-6)


def test_the_radius_of_the_grid_holds_the_wanted_share_about_every_answer():
    frames = SimpleNamespace(grid_x_mm=np.array([0.0, 3.0]), grid_y_mm=np.array([0.0, 4.0]))
    data = SimpleNamespace(frames=frames)
    radius = coverage.radius_of_grid.__wrapped__
    assert radius(data, np.array([[0.0, 0.0]]), 1.0) == 5.0
    assert radius(data, np.array([[0.0, 0.0]]), 2 / 3) == pytest.approx(4.0)
    both = np.array([[0.0, 0.0], [3.0, 4.0], [3.0, 0.0]])
    away = np.sort([0, 3, 4, 5] * 3)
    assert radius(data, both, 0.9) == pytest.approx(np.quantile(away, 0.9))


def test_a_process_answers_with_pushes_within_the_grid():
    made = process.Process(process.ProcessShape(2, 2), 1)
    made.low_mm.copy_(torch.tensor([-1.0, -2.0]))
    made.high_mm.copy_(torch.tensor([1.0, 2.0]))
    made.force.mean.fill_(-3.0)
    made.force.weights.zero_()
    made.place.weights.zero_()
    made.place.mean.copy_(torch.tensor([5.0, -9.0], dtype=torch.float64))
    force, place = made(torch.zeros(1, 1))
    assert (force.tolist(), place.tolist()) == ([0.0], [[1.0, -2.0]])


def settings(source="recorded", **changes):
    asked = TrainingSpec(**{"epochs": 7, "ensemble": 4} | changes)
    return FitSettings(3, asked, seed=5, budget_s=40.0, patience_epochs=3)


def test_members_have_their_own_seeds_and_shares_of_the_time():
    first = training.schedule_of(settings(), 0, "recorded")
    assert (first.epochs, first.batch_frames, first.patience_epochs) == (7, 512, 3)
    assert (first.learning_rate, first.weight_decay, first.budget_s) == (3e-3, 1e-3, 10.0)
    assert (first.seed, training.schedule_of(settings(), 2, "recorded").seed) == (5, 15843)
    assert first.augmentation.other_faces == training.AUGMENTATION["recorded"].other_faces
    whole = training.schedule_of(settings(model="whole-object"), 0, "simulated")
    assert whole.augmentation == replace(training.AUGMENTATION["simulated"], other_faces=0.5)
    own = replace(settings(model="whole-object"), augmentation=training.AUGMENTATION["recorded"])
    assert training.schedule_of(own, 0, "simulated").augmentation == own.augmentation
    endless = replace(settings(ensemble=None), budget_s=None)
    assert training.schedule_of(endless, 0, "recorded").budget_s is None
    alone = training.schedule_of(settings(ensemble=None), 0, "recorded")
    assert alone.budget_s == 40.0


def test_a_fingerprint_tells_schedules_counts_maps_and_architectures_apart():
    schedule = training.schedule_of(settings(), 0, "recorded")
    counts, maps = torch.zeros(2, 3), torch.ones(2, 1)
    marks = {
        training.data_fingerprint(schedule, counts, maps, {}),
        training.data_fingerprint(replace(schedule, epochs=8), counts, maps, {}),
        training.data_fingerprint(schedule, counts + 1, maps, {}),
        training.data_fingerprint(schedule, counts, maps + 1, {}),
        training.data_fingerprint(schedule, counts, maps, {"members": 2}),
    }
    assert len(marks) == 5
    assert training.data_fingerprint(schedule, counts, maps, {}) in marks


def test_trees_that_stand_behind_networks_average_two_frames_at_least():
    """A leaf of a single frame repeats its noise."""
    assert LEAST_FRAMES_OF_LEAF == 2
    assert_array_equal(held_out.SHARPNESS, 2.0 ** np.arange(5))


def test_targets_of_tenths_choose_a_kernel_as_well():
    """Forces below 1 N tell lengths and noise; those that are all the same leave the kernel as it starts."""
    rng = np.random.default_rng(5)
    seen = rng.uniform(-2, 2, (25, 2))
    smooth = 0.2 * np.sin(seen[:, :1])
    variance, _, noise = process.chosen_kernel(seen, smooth)
    assert variance < 0.5
    assert noise < 5e-3
    start = process.chosen_kernel(seen, np.full((25, 1), 0.2))
    assert_allclose(start, (1.0, np.sqrt(2), 1e-2))

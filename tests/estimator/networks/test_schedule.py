"""Rates of learning, batches and stops, and how far signals lie from known ones, by hand."""

import time
from types import SimpleNamespace

import numpy as np
import pytest
import torch
from numpy.testing import assert_allclose

from design.errors import InputError
from estimator.networks.intervals.conformal import conformal_quantile
from estimator.networks.intervals.coverage import Coverage, growth
from estimator.networks.training import fitting
from estimator.networks.training.fitting import Schedule

PLAN = Schedule(22, 64, 1e-3, 0.0, 5, None, 0)


def test_rates_warm_up_over_two_epochs_and_decay_to_a_hundredth():
    rate = [fitting.rate_factor(epoch, PLAN) for epoch in (0.0, 0.5, 1.999, 2.0, 12.0, 22.0)]
    assert_allclose(rate, [0.02, 0.25, 0.9995, 1.0, 0.505, 0.01])
    short = Schedule(2, 64, 1e-3, 0.0, 5, None, 0)
    assert_allclose([fitting.rate_factor(e, short) for e in (0.5, 1.0, 1.5)], [0.5, 1.0, 0.505])


def test_batches_leave_twenty_steps_and_sixteen_frames():
    found = [fitting.frames_of_batch(frames, 64) for frames in (5, 319, 340, 1280, 10_000)]
    assert found == [16, 16, 17, 64, 64]
    assert fitting.frames_of_batch(10, 0) == 1


@pytest.mark.parametrize(("epoch", "best", "late"), [(9, 4, True), (8, 4, False)])
def test_a_fit_stops_after_its_patience(epoch, best, late):
    state = SimpleNamespace(epoch=epoch, best_epoch=best)
    assert fitting.is_stopped.__wrapped__(state, PLAN, time.monotonic()) == late


def test_a_fit_stops_at_its_budget_and_decays_towards_it(monkeypatch):
    """Steps at 2, 4, 6 and 8 of 10 s have the rates of those shares of all epochs."""
    plan = Schedule(20, 1, 1e-3, 0.0, 5, None, 0, budget_s=10.0)
    state = SimpleNamespace(epoch=1, best_epoch=1)
    clock = iter([1.99, 2.0, 3.99, 4.0, 5.99, 6.0, 7.99, 8.0, 10.0])
    now = {"s": 0.0}

    def monotonic():
        now["s"] = next(clock)
        return now["s"]

    monkeypatch.setattr(fitting.time, "monotonic", monotonic)
    monkeypatch.setattr(fitting, "frames_of_batch", lambda frames, wanted: 1)
    rates = []
    weight = torch.nn.Parameter(torch.zeros(1))
    optimizer = torch.optim.SGD([weight], lr=1.0)
    step = optimizer.step

    def stepped(*args):
        rates.append(optimizer.param_groups[0]["lr"])
        return step(*args)

    monkeypatch.setattr(optimizer, "step", stepped)
    monkeypatch.setattr(fitting, "heads_loss", lambda network, counts, rows: (weight * 0).sum())

    class Rows:
        counts = torch.zeros(9, 2)

        def __len__(self):
            return 9

        def rows(self, batch):
            return self

    fitting.one_epoch.__wrapped__(torch.nn.Linear(1, 1), optimizer, Rows(), None, plan, state, 0.0)
    assert_allclose(rates, [1e-3 * fitting.rate_factor(e, plan) for e in (4.0, 8.0, 12.0, 16.0)])
    clock = iter([10.0])
    assert fitting.is_stopped.__wrapped__(state, plan, 0.0)


def test_novelty_is_the_distance_to_the_nearest_known_frame():
    coverage = Coverage(2, 2)
    coverage.sigma_counts.copy_(torch.tensor([2.0, 4.0]))
    coverage.reference.copy_(torch.tensor([[0.0, 0.0], [1.0, 1.0]]))
    coverage.scale.fill_(0.5)
    counts = torch.tensor([[6.0, 0.0], [6.0 * np.sinh(1.0), 12.0 * np.sinh(1.5)]]).float()
    distance = [np.arcsinh(1.0), 0.5]
    assert_allclose(coverage.distance(counts), distance, rtol=1e-5)
    assert_allclose(coverage(counts), np.array(distance) / 0.5, rtol=1e-5)
    assert_allclose(growth(torch.tensor([0.5, 1.0, 1.25, 5.0])), [0.0, 0.0, 0.5, 2.0])


def test_quantiles_weigh_presses_alike_and_count_the_one_to_come():
    score = np.array([1.0, 2.0, 3.0, 4.0, 10.0, 20.0])
    press = np.array([0, 0, 0, 0, 1, 2])
    share = np.cumsum([1 / 12] * 4 + [1 / 3, 1 / 3])
    for level in (0.05, 0.2, 0.3, 0.34, 0.6, 0.67):
        wanted = score[np.searchsorted(share, level - 1e-9)]
        assert conformal_quantile(score, press, level, pooled_folds=True) == wanted
        later = score[min(np.searchsorted(share, min(1.0, level * 4 / 3) - 1e-9), 5)]
        assert conformal_quantile(score, press, level) == later
    assert conformal_quantile(score, press, 0.99) == 20.0
    with pytest.raises(InputError, match="calibrate"):
        conformal_quantile(np.array([]), np.array([], dtype=int), 0.9)

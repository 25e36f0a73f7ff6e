"""Expected loss of a task against drawn estimates, and of batches against their own bounds."""

import numpy as np
import pytest
import torch
from numpy.testing import assert_allclose

from design.spec.search import TaskSpec
from estimator.layouts.task_loss import expected_loss, press_loss

TASK = TaskSpec(from_n=1.0, within_mm=2.0, force_percent=20.0)


def drawn_loss(force_n, position_mm, force_bound_n, share_in_x=0.5, count=400_000):
    rng = np.random.default_rng(0)
    x, y = rng.normal(size=(2, count)) * position_mm
    away = np.hypot(x * np.sqrt(share_in_x), y * np.sqrt(1 - share_in_x))
    read = force_n + force_bound_n * rng.normal(size=count)
    seen = read > 2.326 * force_bound_n
    return 1 - np.mean((away < 2.0) & (abs(read - force_n) < 0.2 * force_n) & seen)


def loss(force_n, position_mm, force_bound_n, task=TASK):
    place, force = (torch.tensor([value]) for value in (position_mm, force_bound_n))
    return float(press_loss(task, force_n, place, force))


@pytest.mark.parametrize("position_mm", [0.5, 1.5, 4.0])
@pytest.mark.parametrize("force_bound_n", [0.05, 0.3, 0.6, 3.0])
def test_losses_are_those_of_drawn_estimates(position_mm, force_bound_n):
    found = loss(2.0, position_mm, force_bound_n)
    assert found == pytest.approx(drawn_loss(2.0, position_mm, force_bound_n), abs=3e-3)


def test_errors_along_one_line_are_off_by_as_much_as_is_said():
    bounds = (0.8, 1.0, 1.3, 1.6, 2.0, 3.0, 4.0, 6.0)
    off = [loss(2.0, b, 1e-3) - drawn_loss(2.0, b, 1e-3, share_in_x=1.0) for b in bounds]
    assert 0.15 < max(off) < 0.175
    assert bounds[int(np.argmax(off))] == 4.0
    assert -0.06 < min(off) < -0.03


def test_small_losses_keep_their_digits_and_slopes():
    place = torch.tensor([0.45], requires_grad=True)
    found = press_loss(TASK, 5.0, place, torch.tensor([0.01]))
    assert float(found.detach()) == pytest.approx(np.exp(-((2 / 0.45) ** 2)), rel=1e-3)
    found.log().sum().backward()
    assert float(place.grad) == pytest.approx(2 * 2.0**2 / 0.45**3, rel=1e-3)


def test_forces_below_the_task_do_not_count():
    by_force = {
        force: torch.tensor([share, 0.0]) for force, share in ((0.5, 0.9), (2.0, 0.4), (5.0, 0.2))
    }
    assert_allclose(expected_loss(TASK, by_force), [0.3, 1e-6], rtol=1e-6)
    light = TaskSpec(from_n=6.0)
    assert expected_loss(light, by_force).isnan().all()

"""Walks and runs end in no layout that breaks a limit which their start kept, however sums are rounded."""

import numpy as np
import pytest
import torch

from design.search.places import polarities
from design.search.space import search_space, start_params, unit_of
from design.search.structure import with_structure
from design.spec.search import SearchSpec
from estimator.layouts.polish import (
    ROUNDING_MM,
    Judged,
    LowestFidelity,
    judge,
    polish,
    walk,
)
from estimator.layouts.presses.basis import press_basis
from estimator.layouts.scorer import layout_scorer
from estimator.layouts.vectors import layout_space
from tests.support.mechanics.candidate_cases import made_up_motions, made_up_spec

FACES, OBJECTIVES, MEDIAN = (1, 3), ("worst_position_bound_mm",), "median_position_bound_mm"
MAGNETS = {"magnet_reach_mm": 14.0, "magnet_depth_mm": [2.0, 5.0]}
WITHIN, BOARDS_TOO_CLOSE = MAGNETS, MAGNETS | {"sensor_reach_mm": 10.0}
DISTURBANCE, STEPS, RATE = 1e-6, 40, 0.01


class Start:
    """A specification's own layout, with a median bound that may not become larger than it is."""

    def __init__(self, vary):
        search = SearchSpec.model_validate({"vary": vary})
        spec = made_up_spec().model_copy(update={"search": search})
        motions, space = made_up_motions(spec), search_space(spec)
        params = start_params(space)
        assert params is not None
        scorers = tuple(layout_scorer(spec, press_basis(spec, motions, face)) for face in FACES)
        tensors = layout_space(space, with_structure(spec, params))
        self.poles = torch.tensor([polarities(tensors.structured, params)])
        self.unit = torch.as_tensor(unit_of(space, params), dtype=torch.float32)
        self.lowest = LowestFidelity(tensors, scorers, {})
        median = float(self.judged(self.unit[None]).scores[MEDIAN])
        self.lowest = LowestFidelity(tensors, scorers, {MEDIAN: median})

    def judged(self, units):
        return judge(self.lowest, units, self.poles.expand(len(units), -1), OBJECTIVES)

    def disturbed(self, count, seed):
        away = np.random.default_rng(seed).uniform(-1, 1, (count, len(self.unit)))
        return (self.unit + DISTURBANCE * torch.as_tensor(away).float()).clamp(0, 1)

    def walked(self, count, seed=0):
        """Layouts where walks begin and end, judged."""
        begin = self.disturbed(count, seed)
        end = walk(self.judged, begin, torch.ones(1), STEPS, RATE)
        with torch.no_grad():
            return self.judged(begin), self.judged(end)


def broken_anew(begin, end):
    """How many ends break a limit that their beginning kept, by more than rounding."""
    return int(((begin.broken <= ROUNDING_MM) & (end.broken > ROUNDING_MM)).any(dim=1).sum())


def test_walks_from_within_all_limits_end_there_and_better():
    begin, end = Start(WITHIN).walked(6)
    assert (begin.broken_mm == 0).all()
    assert (end.broken_mm == 0).all()
    assert (end.penalized < 0.8 * begin.penalized).all()


def test_walks_from_a_broken_limit_break_no_other():
    """Boards of the start are 8 mm too close; one walk in seven is led to rest over the wire hole."""
    begin, end = Start(BOARDS_TOO_CLOSE).walked(12)
    assert (begin.broken_mm > 8).all()
    assert broken_anew(begin, end) == 0
    assert (end.broken.sum(dim=1) <= begin.broken.sum(dim=1) + ROUNDING_MM).all()
    assert (end.broken_mm == 0).sum() > 6


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(20))
@pytest.mark.parametrize("vary", [WITHIN, BOARDS_TOO_CLOSE])
def test_a_thousand_disturbed_starts_break_no_limit(vary, seed):
    begin, end = Start(vary).walked(50, 1 + seed)
    assert broken_anew(begin, end) == 0
    assert vary is BOARDS_TOO_CLOSE or (end.broken_mm == 0).all()


def hidden_limit(point, rows=None):
    """The first limit is kept from 0.9 on, the second, a little, breaks from 0.4 on."""
    first = point[:, 0]
    broken = torch.stack([torch.relu(0.9 - first), 0.05 * torch.relu(first - 0.4)], dim=1)
    worth = torch.ones_like(first)[:, None]
    return Judged(worth, broken, {}, worth)


def test_a_broken_limit_is_not_mended_by_breaking_another():
    begin = torch.full((1, 2), 0.2)
    for end in (
        walk(hidden_limit, begin, torch.ones(1), 120, 0.05),
        polish(hidden_limit, begin, 60, torch.ones(1, 1)),
    ):
        assert 0.35 < float(end[0, 0]) <= 0.4, "the nearest that keeps what the start kept"


def test_walks_take_one_thread_whatever_the_user_set_and_leave_that():
    """Two threads of two busy cores took ten times as long."""
    threads, before = [], torch.get_num_threads()

    def judged_at(point, rows=None):
        threads.append(torch.get_num_threads())
        return hidden_limit(point)

    torch.set_num_threads(2)
    try:
        walk(judged_at, torch.full((1, 2), 0.2), torch.ones(1), 3, 0.05)
        polish(judged_at, torch.full((1, 2), 0.2), 2, torch.ones(1, 1))
        assert {*threads} == {1}
        assert torch.get_num_threads() == 2
    finally:
        torch.set_num_threads(before)


def test_the_start_is_the_end_where_every_way_on_breaks_a_limit():
    """Judged a second time the start itself breaks its limit, as another order of a sum may tell."""
    calls = []

    def judged_at(point, rows=None):
        calls.append(len(point))
        missing = torch.relu(point[:, 0] - 0.2) + (1e-6 if len(calls) > 1 else 0.0)
        worth = (2 - point[:, 0])[:, None]
        return Judged(worth, missing[:, None], {}, worth)

    begin = torch.full((1, 2), 0.2)
    end = walk(judged_at, begin, torch.ones(1), 30, 0.05)
    assert torch.equal(end, begin)
    assert float(judged_at(end).broken_mm) == 0, "a millionth is rounding"

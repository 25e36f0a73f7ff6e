"""What plain engines beside a search score, on a bowl in place of the mechanics."""

from types import SimpleNamespace

import numpy as np
import pytest
import torch
from numpy.testing import assert_allclose

from estimator.layouts.polish import Judged
from instobj.search.outcome import history
from instobj.search.trials import Trial
from tests.support.objects.search_cases import made_up_space

OBJECTIVES = ("worst_position_bound_mm", "worst_force_bound_n")


@pytest.fixture
def bowl(monkeypatch):
    """The first objective is least, 1 mm, at 0.3 of every range; beyond 0.9 of the first a limit breaks."""

    def judged(lowest, units, poles, names):
        assert units.dtype == torch.float32
        assert len(poles) == len(units)
        first = 1 + ((units - 0.3) ** 2).sum(dim=1)
        scores = {OBJECTIVES[0]: first, OBJECTIVES[1]: 1 / first}
        worth = torch.stack([scores[name] for name in names], dim=1)
        broken = torch.relu(units[:, 0] - 0.9)
        return Judged(worth, broken[:, None], scores, worth)

    lowest = SimpleNamespace(space=SimpleNamespace(structured=None))
    monkeypatch.setattr(history, "structure_fidelity", lambda *_: lowest)
    monkeypatch.setattr(history, "polarities", lambda *_: [1])
    monkeypatch.setattr(history, "judge", judged)
    start = SimpleNamespace(scores=dict.fromkeys(OBJECTIVES, 2.0))
    monkeypatch.setattr(history, "start_scores", lambda spec: start)
    return made_up_space(objectives=list(OBJECTIVES), polish_steps=40)


def trial(value, feasible=True, scorings=3000):
    scores = dict.fromkeys(OBJECTIVES, value)
    return Trial({}, (value,), scores, 0.0 if feasible else 1.0, "", scorings, 0)


def test_plain_engines_score_as_many_layouts_and_only_those_within_limits_count(bowl, monkeypatch):
    monkeypatch.setattr(history, "MOST_SCORINGS", 3000)
    kept = SimpleNamespace(finished=[trial(2.0), trial(1.5, False, 2000)])
    found = history.search_history(bowl, kept)
    assert found.scorings.tolist() == [3000, 5000]
    assert found.feasible.tolist() == [True, False]
    assert_allclose(found.values[:, 0], [2.0, 1.5])
    drawn, evolved = found.peers
    assert (drawn.name, evolved.name) == ("random search", "plain CMA-ES")
    assert drawn.scored == 3000, "and no more than that"
    assert 0 <= evolved.scored - drawn.scored < 40, "whole generations"
    for peer in found.peers:
        assert 0 < len(peer.values) <= peer.scored
        assert (np.diff(peer.scorings) > 0).all()
        assert peer.scorings[-1] <= peer.scored
    assert 0.8 < len(drawn.values) / drawn.scored < 0.97, "a tenth breaks the limit"


def test_plain_engines_end_with_their_time_after_a_chunk_at_least(bowl, monkeypatch):
    kept = SimpleNamespace(finished=[trial(2.0, True, 30_000)])
    drawn, evolved = history.search_history(bowl, kept, seconds=0.0).peers
    assert drawn.scored == 512
    assert 0 < evolved.scored < 40, "a generation"


def test_plain_cma_es_goes_down_where_random_search_does_not(bowl):
    drawn = history.random_search(bowl, None, 3000, np.inf)
    evolved = history.cma_es_peer(bowl, None, 3000, np.inf)
    assert evolved.values.min() - 1 < 0.01 * (drawn.values.min() - 1)
    again = history.cma_es_peer(bowl, None, 3000, np.inf)
    assert_allclose(again.values, evolved.values)


def test_choices_alone_have_no_cma_es(bowl, monkeypatch):
    free = [v for v in bowl.variables if not v.choices]
    alone = SimpleNamespace(
        spec=bowl.spec, variables=[v for v in bowl.variables if v.choices] + free[:1]
    )
    monkeypatch.setattr(history, "params_at", lambda space, unit: {})
    monkeypatch.setattr(history, "structure_of", lambda space, params: ())
    found = history.search_history(alone, SimpleNamespace(finished=[trial(2.0)]))
    assert [peer.name for peer in found.peers] == ["random search"]

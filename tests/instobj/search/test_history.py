"""What a search's history holds, without any mechanics."""

from dataclasses import replace
from types import SimpleNamespace

from numpy.testing import assert_allclose

from instobj.search.outcome import history
from instobj.search.trials import Trial
from tests.support.objects.search_cases import made_up_space

OBJECTIVES = ("worst_position_bound_mm", "worst_force_bound_n")


def trial(value, feasible=True, scorings=3000):
    scores = dict(zip(OBJECTIVES, (value, 10 * value), strict=True))
    return Trial({}, (value,), scores, 0.0 if feasible else 1.0, "", scorings, 0)


def test_trials_stand_in_their_order_with_the_layouts_scored_until_then(monkeypatch):
    start = SimpleNamespace(scores=dict.fromkeys(OBJECTIVES, 2.0))
    monkeypatch.setattr(history, "start_scores", lambda spec: start)
    kept = SimpleNamespace(finished=[trial(2.0), trial(1.5, False, 2000)])
    found = history.search_history(made_up_space(objectives=list(OBJECTIVES)), kept)
    assert found.scorings.tolist() == [3000, 5000]
    assert found.feasible.tolist() == [True, False]
    assert_allclose(found.values, [[2.0, 20.0], [1.5, 15.0]])
    assert_allclose(found.start, [2.0, 2.0])


def test_the_start_is_not_scored_again_where_trials_hold_its_scores():
    """Without mechanics it could not be."""
    start = dict.fromkeys(OBJECTIVES, 3.0)
    kept = SimpleNamespace(finished=[replace(trial(2.0), start_scores=start), trial(1.5)])
    found = history.search_history(made_up_space(objectives=list(OBJECTIVES)), kept)
    assert_allclose(found.start, [3.0, 3.0])

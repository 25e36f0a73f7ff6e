"""What a search's history holds, without any mechanics."""

from types import SimpleNamespace

from numpy.testing import assert_allclose

from instobj.search.outcome import history
from instobj.search.trials import Trial
from tests.support.objects.search_cases import made_up_space

OBJECTIVES = ("worst_position_bound_mm", "worst_force_bound_n")


def trial(value, feasible=True, scorings=3000):
    scores = dict(zip(OBJECTIVES, (value, 10 * value), strict=True))
    start = dict.fromkeys(OBJECTIVES, 2.0)
    broken_mm = 0.0 if feasible else 1.0
    return Trial({}, (value,), scores, broken_mm, "", scorings, 0, start_scores=start)


def test_trials_stand_in_their_order_with_the_layouts_scored_until_then():
    kept = SimpleNamespace(finished=[trial(2.0), trial(1.5, False, 2000)])
    found = history.search_history(made_up_space(objectives=list(OBJECTIVES)), kept)
    assert found.scorings.tolist() == [3000, 5000]
    assert found.feasible.tolist() == [True, False]
    assert_allclose(found.values, [[2.0, 20.0], [1.5, 15.0]])
    assert_allclose(found.start, [2.0, 2.0])

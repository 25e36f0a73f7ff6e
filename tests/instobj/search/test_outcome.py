"""What a search's figures are drawn from."""

from dataclasses import replace

import numpy as np
from matplotlib.image import imread
from numpy.testing import assert_allclose, assert_array_equal

from design.spec_io import parse_spec
from instobj.search.outcome import moves
from instobj.search.outcome.figures import draw_convergence
from instobj.search.outcome.history import History, best_so_far, front_rows, pareto_front
from instobj.search.outcome.moves import paired
from tests.support.objects.made_histories import made_up_history


def test_the_best_so_far_counts_feasible_trials_only():
    values = np.array([5.0, 1.0, 4.0, 6.0, 3.0])
    counted = np.array([False, False, True, True, True])
    nan = np.nan
    assert_allclose(best_so_far("cost", values, counted), [nan, nan, 4.0, 4.0, 3.0])
    assert_allclose(best_so_far("sensitivity_ratio", values, counted), [nan, nan, 4.0, 6.0, 6.0])


def test_the_front_is_what_no_other_layout_beats():
    values = np.array([[1.0, 5.0], [2.0, 2.0], [2.0, 3.0], [4.0, 1.0], [5.0, 1.0], [3.0, 3.0]])
    assert_array_equal(pareto_front(values), [True, True, False, True, False, False])


def test_parts_are_paired_by_the_least_way_in_all():
    before = np.array([[0.0, 0.0], [10.0, 0.0]])
    after = np.array([[9.0, 0.0], [20.0, 0.0], [-1.0, 1.0]])
    assert dict(paired(before, after)) == {0: 2, 1: 0}


def test_the_front_holds_feasible_trials_by_their_first_objective():
    values = np.array([[3.0, 1.0], [1.0, 3.0], [2.0, 2.0], [0.5, 0.5], [3.0, 3.0]])
    feasible = np.array([True, True, True, False, True])
    names = ("worst_position_bound_mm", "worst_force_bound_n")
    history = History(names, values, feasible, np.ones(2), np.arange(5))
    assert front_rows(history) == [1, 2, 0]
    assert front_rows(replace(history, names=names[:1])) == []


def test_the_convergence_is_drawn(tmp_path):
    draw_convergence(made_up_history(), tmp_path / "convergence.png")
    assert np.ptp(imread(tmp_path / "convergence.png")[..., :3]) > 0.5


def test_sizes_that_a_search_chose_stand_beside_the_poles():
    places = {"positions_mm": [[8, 8], [-8, -8]]}
    start = parse_spec({"name": "a", "magnets": places}, "made up")
    chosen = places | {"grade": ["N35", "N52"], "north": ["outward", "inward"]}
    search = {"vary": {"magnet_sizes": ["D6x1", "D5x1"]}}
    found = parse_spec({"name": "b", "magnets": chosen, "search": search}, "made up")
    told = moves.moved_parts(start, found)
    norths = [row[-1] for row in told["moves"] if row[0].startswith("magnet")]
    assert norths == ["outward, N35", "inward, N52"]
    assert told["kinds"]
    assert not moves.moved_parts(start, start)["kinds"]

"""What a search's figures are drawn from."""

import numpy as np
import pytest
from matplotlib.image import imread
from matplotlib.patches import Circle
from numpy.testing import assert_allclose, assert_array_equal

from design.spec_io import parse_spec
from instobj.search.outcome import moves
from instobj.search.outcome.figures import (
    draw_convergence,
    draw_front,
    draw_moves,
    paired,
    pareto_front,
)
from instobj.search.outcome.history import best_so_far
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


@pytest.mark.parametrize("random", [0, 40])
def test_figures_are_drawn(tmp_path, random):
    history = made_up_history(random)
    draw_convergence(history, tmp_path / "convergence.png")
    draw_front(history, tmp_path / "front.png")
    start = parse_spec({"name": "a"}, "made up")
    moved = {"positions_mm": [[0, 1], [9, 8], [-9, 9]], "north": ["outward", "inward", "outward"]}
    found = parse_spec(
        {"name": "b", "magnets": moved | {"tilt_deg": [[5, 9], [0, 0], [0, 8]]}}, "b"
    )
    draw_moves(start, found, tmp_path / "moves.png")
    for name in ("convergence", "front", "moves"):
        assert np.ptp(imread(tmp_path / f"{name}.png")[..., :3]) > 0.5


def test_every_layout_of_a_body_with_faces_of_several_sizes_is_drawn(tmp_path):
    body = {"kind": "cylinder", "size_mm": [42.0, 42.0, 60.0], "open_faces": [6]}
    sensors = {"positions_mm": [[9.0, 0.0], [-9.0, 0.0], [0.0, 7.5]]}
    start = parse_spec({"name": "h", "body": body, "sensors": sensors}, "h")
    moved = {"positions_mm": [[3.0, 1.0], [12.0, 8.0]]}
    found = parse_spec({"name": "h", "body": body, "sensors": sensors, "magnets": moved}, "h")
    top, side = draw_moves(start, found, tmp_path / "moves.png").axes
    assert (top.get_xlabel(), side.get_xlabel()) == ("x of face 1 (mm)", "x of face 2 (mm)")
    assert side.get_title() == "faces 2, 3, 4, 5 (before: face 2)"
    for axes in (top, side):
        circles = [one for one in axes.patches if isinstance(one, Circle)]
        assert len(circles) == 5 + 2, "magnets of the start and of the found layout"
    cube = parse_spec({"name": "c"}, "c")
    assert len(draw_moves(cube, cube, tmp_path / "m.png").axes) == 1


def test_grades_that_a_search_chose_stand_beside_the_poles(tmp_path):
    places = {"positions_mm": [[8, 8], [-8, -8]]}
    start = parse_spec({"name": "a", "magnets": places}, "made up")
    chosen = places | {"grade": ["N35", "N52"], "north": ["outward", "inward"]}
    search = {"vary": {"magnet_grade": ["N35", "N52"]}}
    found = parse_spec({"name": "b", "magnets": chosen, "search": search}, "made up")
    told = moves.moved_parts(start, found, tmp_path)
    norths = [row[-1] for row in told["moves"] if row[0].startswith("magnet")]
    assert norths == ["outward, N35", "inward, N52"]
    assert told["kinds"]
    assert not moves.moved_parts(start, start, tmp_path)["kinds"]

"""Layouts beside each other, from the tables that their runs wrote."""

from dataclasses import fields, replace

import numpy as np
import pytest

from design.errors import StoreError
from design.layout.places.contact_grid import contact_grid
from design.spec.object import ObjectSpec
from estimator.information.scores import PlaceScores, save_scores_csv
from instobj.cli.tables import print_result
from instobj.commands.compare import compare_scores, comparison_row
from instobj.store.publish import run_folder
from tests.support.objects.made_scores import scores_of


def made_scores(spec, bound_mm):
    """Every score 1 but for the position bound, which has one weak place."""
    grid = contact_grid(spec)
    columns = {f.name: np.ones((5, len(grid))) for f in fields(PlaceScores)[2:]}
    bound = np.full((5, len(grid)), bound_mm)
    bound[3, 42] = 5 * bound_mm
    columns |= {"position_bound_mm": bound, "position_bound_drifted_mm": 3 * bound}
    columns["reaches_score_force"] = np.ones((5, len(grid)), bool)
    return PlaceScores(np.arange(1, 6), grid, **columns)


def test_objects_are_compared_in_one_table_and_one_figure(tmp_path, capsys):
    specs = [ObjectSpec(name="near"), ObjectSpec(name="far")]
    for spec, bound in zip(specs, (0.4, 2.0), strict=True):
        save_scores_csv(made_scores(spec, bound), run_folder(tmp_path, spec.name) / "scores.csv")
    found = compare_scores(specs, tmp_path)
    near, far = found["rows"]
    assert [near["object"], far["object"]] == ["near", "far"]
    assert (near["place mm"], near["place after 15 min mm"]) == (0.4, pytest.approx(1.2))
    assert (near["weakest place mm"], near["on face"]) == (2.0, 4)
    assert (near["places within limit %"], far["places within limit %"]) == (99.9, 0.0)
    picture = run_folder(tmp_path, "near+far") / "comparison.png"
    assert picture.read_bytes().startswith(b"\x89PNG")
    print_result({"comparison": found})
    shown = capsys.readouterr().out
    assert any(line.split() == ["object", "near", "far"] for line in shown.splitlines())
    assert any(line.split() == ["place", "mm", "0.4", "2"] for line in shown.splitlines())
    assert [row["path"] for row in found["files"]] == [str(picture)]


def test_an_object_without_scores_is_named(tmp_path):
    with pytest.raises(StoreError, match=r"near/scores.csv is not a table of scores"):
        compare_scores([ObjectSpec(name="near")], tmp_path)


def test_places_that_do_not_reach_the_force_are_in_no_figure_and_their_share_is_told():
    spec = ObjectSpec(name="cube")
    scores = scores_of(spec, 1.0)
    reached = scores.reaches_score_force.copy()
    reached[0] = False
    bound = np.where(reached, scores.position_bound_mm, np.nan)
    row = comparison_row(
        spec, replace(scores, reaches_score_force=reached, position_bound_mm=bound)
    )
    assert row["places that reach it %"] == 80
    assert row["place mm"] == row["weakest place mm"] == 1
    assert row["on face"] != spec.body.sensed[0]

"""The benchmark of estimators runs, and its figures hang together."""

import pytest


def test_quick_run_compares_both_recipes_in_the_same_time(quick_run):
    result, printed = quick_run("estimators", 1, ["estimators.json"])
    ours, paper = (result["recipes"][name] for name in ("compact", "paper"))
    assert ours["E_f_percent"] < paper["E_f_percent"]
    assert ours["epochs"] > paper["epochs"] >= 1
    assert paper["weights"] == pytest.approx(9.4e6, rel=0.03)
    hours = 1000 * 85_800 / result["frames"]["train"] * paper["seconds_an_epoch"] / 3600
    assert result["extrapolated_hours_of_the_papers_whole_recipe"] == pytest.approx(hours)
    assert result["inference"]["times_faster"] > 5
    assert "extrapolated" in printed

"""The benchmark of estimators runs, and its figures hang together."""

import importlib
from pathlib import Path

import pytest

BENCHMARKS = Path(__file__).parents[2] / "benchmarks"


@pytest.mark.slow
def test_quick_run_compares_both_recipes_in_the_same_time(quick_run):
    result, printed = quick_run("estimators", 1, ["estimators.json"])
    ours, paper = (result["recipes"][name] for name in ("compact", "paper"))
    assert ours["E_f_percent"] < paper["E_f_percent"]
    assert ours["epochs"] > paper["epochs"] >= 1
    assert paper["weights"] == pytest.approx(9.4e6, rel=0.03)
    hours = 1000 * 85_800 / result["frames"]["train"] * paper["seconds_an_epoch"] / 3600
    assert result["extrapolated_hours_of_the_papers_whole_recipe"] == pytest.approx(hours)
    assert result["inference"]["times_faster"] > 5
    assert list(result["budget_s"].values()) == pytest.approx([3.0, 3.0, 1.2])
    assert "extrapolated" in printed


def test_an_interrupted_run_goes_on_from_finished_trainings(tmp_path, monkeypatch):
    """What is trained, and how, is the quick run's to show: here a recipe says its name and budget."""
    monkeypatch.syspath_prepend(str(BENCHMARKS))
    estimators = importlib.import_module("estimators")
    begun, stopped = [], ["paper"]

    def trained(name, frames, split, budget_s, parts):
        begun.append(name)
        if name in stopped:
            raise KeyboardInterrupt
        return {"epochs": len(begun), "seconds": budget_s}

    monkeypatch.setattr(estimators, "trained", trained)
    with pytest.raises(KeyboardInterrupt):
        estimators.all_trained(None, None, 1.0, tmp_path)
    assert begun == ["compact", "paper"]
    stopped.clear()
    whole = estimators.all_trained(None, None, 1.0, tmp_path)
    assert begun == ["compact", "paper", "paper", estimators.SHORT]
    assert whole["compact"] == {"epochs": 1, "seconds": 0.5}
    assert whole[estimators.SHORT]["seconds"] == 0.2
    assert estimators.all_trained(None, None, 1.0, tmp_path) == whole
    assert len(begun) == 4

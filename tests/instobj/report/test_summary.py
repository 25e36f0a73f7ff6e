"""Numbers that the command line shows of stages."""

import json

import pytest

from instobj.report.summary import NETWORKS_TITLE, difference_row, summarize
from instobj.store.content import StoredResult


@pytest.mark.parametrize(("presses", "shown"), [(1, "–"), (2, "0.25")])
def test_one_press_has_no_range(presses, shown):
    """Its mean, drawn anew, is always itself: ± 0.00 was shown as if it were certain."""
    row = {"name": "ridge", "presses": presses}
    row["force_n_less_model"] = {"mean": -0.5, "low": -0.75, "high": -0.25}
    assert difference_row(row, "force_n_less_model", "N") == {"Δ N": "-0.50", "± N": shown}


@pytest.mark.parametrize(("high_n", "is_better"), [(-0.1, True), (0.1, False)])
def test_a_simple_regression_that_errs_surely_less_than_the_networks_is_named(
    tmp_path, high_n, is_better
):
    def row(name, force_n, place_mm, low, high):
        difference = {"mean": (low + high) / 2, "low": low, "high": high}
        errors = {"total_force_n": force_n, "total_force_percent": 5.0, "place_mm": place_mm}
        differences = dict.fromkeys(("force_n_less_model", "place_mm_less_model"), difference)
        return {"face": 1, "name": name, "presses": 49} | errors | differences

    rows = [row("model", 0.4, 1.05, 0, 0), row("nearest neighbours", 0.2, 0.5, -0.3, high_n)]
    others = ("faces", "intervals", "travel")
    content = {name: [] for name in others}
    (tmp_path / "metrics.json").write_text(json.dumps(content | {"baselines": rows}))
    made = summarize({"metrics": StoredResult("metrics", "key", tmp_path, True, 0.0, {})})
    line = made[NETWORKS_TITLE]["face 1"]
    assert line.startswith("force within 0.4 N, place within 1.1 mm (means over 49 held-out")
    assert ("nearest neighbours, force within 0.2 N, place within 0.5 mm" in line) == is_better

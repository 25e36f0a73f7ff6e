"""The benchmark of the solvers runs, and all of them find the same compliance."""

import pytest


@pytest.mark.slow
def test_quick_run_finds_one_compliance_by_three_solvers(quick_run):
    result, printed = quick_run("solvers", 1, ["solvers.json"])
    rows = result["bodies"]["hall_skin"]
    assert {"multifrontal", "SuperLU"} < set(rows)
    assert all(row["off"] < 1e-10 for row in rows.values())
    assert "hall_skin, multifrontal" in printed

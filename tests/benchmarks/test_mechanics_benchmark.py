"""The benchmark of the mechanics runs, and its figures hang together."""

import pytest


@pytest.mark.slow
def test_quick_run_writes_phases_and_rivals(quick_run):
    result, printed = quick_run("mechanics", 2, ["mechanics.json"])
    table = result["table"]
    assert table["presses"] == 5 * 100 * 20
    assert abs(sum(table["phases_s"].values()) / table["total_s"] - 1) < 1e-9
    for way in table["ways"].values():
        assert way["largest_difference"] < 1e-9
    # the target is 1000 on the default mesh; a busy machine must not fail the test
    assert table["ways"]["one independent solve per press"]["ratio"] > 200
    for contest in result["single_solves"]:
        installed = {"NGSolve", "CalculiX", "dolfinx"} - set(contest["missing"])
        assert len(contest["runs"]) > len(installed & {"NGSolve"})
        for runs in contest["runs"].values():
            assert all(run["difference"] < 2e-6 and run["total_s"] > 0 for run in runs)
    nodes = [row["nodes"] for row in result["growth"]]
    assert nodes == sorted(nodes)
    assert "target 1.0" in printed or all(c["missing"] for c in result["single_solves"])

"""The benchmark of the field runs, and its figures hang together."""

import pytest


@pytest.mark.slow
def test_quick_run_writes_rates_and_errors(quick_run):
    result, printed = quick_run("field", 1, ["field.json"])
    rows = {(row["nearest_mm"], row["model"], row["type"]): row for row in result["models"]}
    assert len(rows) == len(result["models"]) == 8
    for (_, model, _), row in rows.items():
        assert (row["largest_error"] <= 1e-3) is (model == "multipole")
        assert row["pairs_per_s"] > 0
    assert [rows[near, "multipole", "float32"]["order"] for near in (8.0, 7.0)] == [7, 9]
    # the targets are 30 and 20; a busy machine that swaps mid-run must not fail the test
    assert all(rows[near, "multipole", "float32"]["ratio"] > 5 for near in (8.0, 7.0))
    assert result["signals"]["presses"] == 1960
    assert "x magpylib" in printed

"""The benchmark of a slipped core runs, and its figures hang together."""

import pytest


@pytest.mark.slow
def test_quick_run_names_slips_and_none_without_one(quick_run):
    result, printed = quick_run("slipped_core", 1, ["slipped_core.json"])
    rows = result["rows"]
    assert sum(row["false_alarms"] for row in rows) == result["alarms"] == 0
    assert all(row["named"] == (row["streams"] if row["slip_mm"] else 0) for row in rows)
    assert all(row["presses_right"] > 0.9 for row in rows)
    assert printed.startswith("exact model, 0 mm: presses right")

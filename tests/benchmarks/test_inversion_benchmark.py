"""The benchmark of contacts by inversion runs, and its figures hang together."""

import pytest


@pytest.mark.slow
def test_quick_run_times_every_number_of_tips(quick_run):
    result, printed = quick_run("inversion", 1, ["inversion.json"])
    assert [row["tips"] for row in result["rows"]] == [1, 2, 3]
    for row in result["rows"]:
        assert 0 < row["tracked_ms"] <= row["tracked_ms_95"]
        assert row["tracked_ms"] < row["least_squares_ms"]
        assert 0 <= row["number_right"] <= 1
    assert printed.startswith("1 per jaw: tracked")

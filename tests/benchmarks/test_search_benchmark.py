"""The benchmark of layout scoring runs, and its figures hang together."""

import pytest


@pytest.mark.slow
def test_quick_run_beats_the_plain_way_and_agrees_with_it(quick_run):
    result, printed = quick_run("search", 1, ["search.json"])
    figures = result["figures"]
    assert (figures["places"], figures["layouts"]) == (20, 256)
    assert figures["layouts_per_s"] > 2000
    assert figures["ratio_to_fields_alone"] > 50
    plain_s = figures["plain_mechanics_s"] + figures["plain_fields_s"]
    assert figures["extrapolated_ratio"] == figures["layouts_per_s"] * plain_s > 1000
    for name in ("worst_position_bound_mm", "median_position_bound_mm", "worst_force_bound_n"):
        assert figures["linear"][name]["median_error"] < 0.05
        assert figures["as_pressed"][name]["median_error"] < 0.15
    assert "extrapolated from these" in printed

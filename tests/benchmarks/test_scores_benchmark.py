"""The benchmark of signals and scores runs, and its figures hang together."""

import pytest


@pytest.mark.slow
def test_quick_run_writes_times_and_beats_the_exact_hull(quick_run):
    result, printed = quick_run("scores", 1, ["scores.json"])
    times = result["times"]
    hull = times["hull"]
    assert (times["depths"], hull["frames"]) == (4, 40)
    assert 0 < times["signals_s"] < 5
    assert 0 < times["scores_s"] < 10
    assert hull["covariance_s_per_place"] < hull["exact_s_per_place"]
    # at 40 frames; the target is 1000 at 100, where the exact hull takes ten times as long
    assert times["exact_hulls_over_scores"] > 50
    assert times["exact_hulls_over_scores"] == 500 * hull["exact_s_per_place"] / times["scores_s"]
    assert "500 exact hulls over all scores" in printed

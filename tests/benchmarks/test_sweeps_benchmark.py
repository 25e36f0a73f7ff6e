"""The benchmark of sweeps by one and by two processes runs, and its figures hang together."""

import pytest


@pytest.mark.slow
def test_quick_run_times_one_and_two_processes(quick_run):
    result, printed = quick_run("sweeps", 1, ["sweeps.json"])
    (one,), (two,) = result["seconds"].values()
    assert min(one, two) > 0
    assert result["ratios"] == [pytest.approx(one / two, abs=0.001)]
    assert printed.startswith("2 specifications")

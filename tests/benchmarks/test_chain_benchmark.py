"""The benchmark of the chain from nothing runs, and its figures hang together."""

import pytest


@pytest.mark.slow
def test_quick_run_times_every_stage_once(quick_run):
    result, _ = quick_run("chain", 1, ["chain.json"])
    stages = result["stages_s"]
    assert list(stages) == [
        *("build", "mesh", "response", "shapes", "presses", "signals", "scores", "robustness")
    ]
    assert min(stages.values()) > 0
    assert result["all_s"] == pytest.approx(sum(stages.values()), abs=0.01)
    assert stages["shapes"] < stages["response"] + stages["build"]


@pytest.mark.slow
def test_a_cube_of_any_size_is_placed_and_scored_with_its_memory_and_error(quick_run):
    result, _ = quick_run("chain", 1, ["chain.json"], ["--edge", 25])
    assert "box of 25 × 25 × 25 mm" in result["object"]
    assert result["stages_s"]["coarse_response"] < result["stages_s"]["response"]
    assert "build" not in result["stages_s"]
    assert 0.3 < result["peak_gib"] < 16
    error = result["discretisation"]
    assert error["coarse_unknowns"] < error["unknowns"]
    assert all(0 < step["force_rms"] < 0.2 for step in error["steps"])

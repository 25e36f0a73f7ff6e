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

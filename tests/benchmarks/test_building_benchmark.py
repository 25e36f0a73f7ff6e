"""The benchmark of building runs, and its figures hang together."""

import pytest


@pytest.mark.slow
def test_quick_run_builds_the_cube_and_a_coarse_fruit(quick_run):
    result, printed = quick_run("building", 1, ["building.json"])
    cube, fruit = result["cube"], result["fruit"]
    assert cube["parts"] >= 9
    assert 48_983 < cube["shell_mm3"] < 48_984
    assert fruit["triangles"] == 2000
    for one in (cube, fruit):
        assert one["closed"]
        assert 0 < one["seconds"] < 10 * one["target_s"]
    assert "a fruit of 2000 triangles" in printed

"""The benchmark on recordings runs on a made-up one, and its figures hang together."""

import pytest

from tests.support.recordings.made_recordings import gripper_arrays, write_gripper

CASES = ((54, 57), (23, 28), (71, 80))


@pytest.mark.slow
def test_quick_run_on_a_made_up_recording(quick_run, tmp_path):
    path = write_gripper(tmp_path / "made.csv", gripper_arrays(CASES, presses=4), CASES)
    result, printed = quick_run(
        "recordings", 1, ["recordings.json"], arguments=[path, "--seeds", "1"]
    )
    assert set(result["faces"]) == {"3", "5"}
    for face in result["faces"].values():
        (row,) = face["seeds"]
        assert row["force_error_percent"] < 2 * face["mean_map"]["force_error_percent"]
        assert row["tested_presses"] == 3
        assert set(face["unseen_places"][0]) == {"heatmap", "position"}
    assert result["rest_offset_only"]["chance"] == pytest.approx(1 / 3)
    assert "90 % intervals cover" in printed

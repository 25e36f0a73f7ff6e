"""The benchmark on recordings runs on a made-up one, and its figures hang together."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[1] / "estimator"))

from made_recordings import gripper_arrays, write_gripper

SCRIPT = Path(__file__).parents[2] / "benchmarks" / "recordings.py"
CASES = ((54, 57), (23, 28), (71, 80))


def test_quick_run_on_a_made_up_recording(tmp_path):
    path = write_gripper(tmp_path / "made.csv", gripper_arrays(CASES, presses=4), CASES)
    out = tmp_path / "out"
    done = subprocess.run(
        [sys.executable, SCRIPT, path, "--quick", "--seeds", "1", "--out", out],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    result = json.loads((out / "recordings.json").read_text())
    assert set(result["faces"]) == {"3", "5"}
    for face in result["faces"].values():
        (row,) = face["seeds"]
        assert row["force_error_percent"] < 2 * face["mean_map"]["force_error_percent"]
        assert row["tested_presses"] == 3
        assert set(face["unseen_places"][0]) == {"heatmap", "position"}
    assert result["rest_offset_only"]["chance"] == pytest.approx(1 / 3)
    assert "90 % intervals cover" in done.stdout

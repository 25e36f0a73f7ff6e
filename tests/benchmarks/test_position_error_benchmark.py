"""The benchmark of position errors runs, and errors are nearer to what is read than bounds are."""

import numpy as np
import pytest


@pytest.mark.slow
def test_quick_run_compares_bounds_and_errors_with_readings(quick_run):
    result, printed = quick_run("position_error", 1, ["position_error.json"])
    every = [row for row in result["rows"] if row["error_over_bound"] == [0.0, None]]
    assert [row["places"] for row in every] == [16, 16, 16]
    two_sensors = every[2]
    off_bound, off_error = (
        np.hypot(*np.log(two_sensors[f"read_over_{what}"])) for what in ("bound", "error")
    )
    assert off_error < 0.5 * off_bound
    assert printed.startswith("8 N, all, 16 places: read ")

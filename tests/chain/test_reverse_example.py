"""The reverse cube of the examples through the commands, on a coarse mesh and few places."""

import json
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

from tests.support.cli import run

ROOT = Path(__file__).parents[2]
COARSE = [
    "mesh.edge_mm=8",
    "mesh.surface_edge_mm=3",
    "mesh.rim_edge_ratio=1",
    "contact_grid.count=[3, 3]",
    "contact_grid.pitch_mm=8",
    "press.depths_mm=[1.0, 2.0, 3.0, 4.0]",
]


def test_check_takes_the_reverse_cube(tmp_path):
    done = run("check", str(ROOT / "examples" / "reverse_cube.toml"), "--json", cwd=tmp_path)
    (row,) = json.loads(done.stdout)["specifications"]
    assert (row["magnets"], row["sensors"]) == (20, 15)
    assert row["surroundings"]["jaw_own_face_counts"][0] > 500


@pytest.mark.slow
def test_the_reverse_cube_is_built_simulated_and_scored(tmp_path):
    overrides = [part for change in COARSE for part in ("--set", change)]
    spec = str(ROOT / "examples" / "reverse_cube.toml")
    for command in ("build", "score"):
        done = run(command, spec, *overrides, "--json", cwd=tmp_path)
        assert done.returncode == 0, done.stderr
    (result,) = json.loads(done.stdout)["objects"]
    (scores,) = (rows for title, rows in result["summary"].items() if title.startswith("scores"))
    assert len(scores) >= 2
    assert result["summary"]["verdict"].keys() & {"GO", "NO-GO"}
    with xr.open_dataset(tmp_path / "runs" / "reverse_cube" / "signals.nc") as data:
        delta, face = data.delta_counts.values, data.sensor_face.values
    own = np.stack([abs(delta[index][:, :, face == index + 1]).max() for index in range(5)])
    others = np.stack([abs(delta[index][:, :, face != index + 1]).max() for index in range(5)])
    assert (own > 1000).all()
    assert (own > 3 * others).all()

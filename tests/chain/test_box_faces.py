"""Boxes with no open face and with two through the whole chain, on coarse meshes.

Three different edges, so that faces mixed up would show. The silicone over a face of the core is the
same slab on opposite faces of the closed box; beside an open face it has a free wall.
"""

import csv
from pathlib import Path

import numpy as np
import pytest
import trimesh
import xarray as xr
from numpy.testing import assert_allclose

from design.build.export import write_part
from design.build.parts import parts_of
from design.spec_io import load_spec
from tests.support.cli import run

TEXT = """
name = "{name}"
[body]
size_mm = [42.0, 45.0, 48.0]
open_faces = {open_faces}
[magnets]
positions_mm = [[0, 0], [9, 6]]
[mesh]
edge_mm = 9.0
surface_edge_mm = 3.6
rim_edge_ratio = 1
envelope_mm = 0.1
[contact_grid]
count = [3, 3]
pitch_mm = 4.0
[press]
depths_mm = [0.5, 1.0, 1.5, 2.0]
[score]
force_n = 4.0
[protocol]
presses_per_place = 4
frames_per_press = [4, 8]
"""
BOXES = {"closed": ([], (1, 2, 3, 4, 5, 6)), "two_open": ([5, 6], (1, 2, 3, 4))}


@pytest.fixture(
    scope="module",
    params=[
        ("closed", "score"),
        pytest.param(("closed", "run"), marks=pytest.mark.slow),
        pytest.param(("two_open", "run"), marks=pytest.mark.slow),
    ],
    ids="-".join,
)
def box(request, tmp_path_factory):
    """Name of a box, and the folder where a command left its results."""
    name, command = request.param
    folder = tmp_path_factory.mktemp(name)
    (folder / f"{name}.toml").write_text(TEXT.format(name=name, open_faces=BOXES[name][0]))
    done = run(command, f"{name}.toml", "--json", cwd=folder)
    assert done.returncode == 0, done.stderr
    return name, folder


def force_n(folder: Path, name: str) -> np.ndarray:
    """(face, place) at the deepest press."""
    with xr.open_dataset(folder / "runs" / name / "signals.nc") as data:
        assert tuple(data.face.values) == BOXES[name][1]
        return data.force_n.values[:, :, -1]


def test_presses_on_every_face_give_the_force_of_the_layer(box):
    """An R 5 mm sphere 2 mm deep in 8 mm of bonded silicone of 0.41 MPa: 7.6 N (5.5 N at 0.3 MPa),
    less where the wall is free; over such magnets an independent code has 11.25 N
    (`tests/fem/contact/test_forces_over_magnets.py`), and edges of 3.6 mm scatter by a tenth."""
    name, folder = box
    force = force_n(folder, name)
    assert (force > 6).all()
    assert (force < 1.15 * 11.25).all()
    if name == "closed":
        mean = force.mean(axis=1)  # single places scatter with the coarse mesh
        assert_allclose(mean[[0, 1, 2]], mean[[5, 3, 4]], rtol=0.1)


def test_own_sensors_see_most_and_every_score_is_finite(box):
    name, folder = box
    with xr.open_dataset(folder / "runs" / name / "signals.nc") as data:
        delta, of_face = data.delta_counts.values, data.sensor_face.values
    for index, face in enumerate(BOXES[name][1]):
        own = abs(delta[index][:, :, of_face == face]).max()
        assert own > max(300, 2 * abs(delta[index][:, :, of_face != face]).max())
    with (folder / "runs" / name / "scores.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == 9 * len(BOXES[name][1])
    for key in ("delta_scaled [1/N]", "position_bound_mm", "force_bound_n"):
        assert all(0 < float(row[key]) < np.inf for row in rows)
    assert all(0 < float(row["position_bound_mm"]) < 3 for row in rows)


def test_core_and_shell_are_closed_and_as_large_as_by_hand(box):
    name, folder = box
    if not (folder / "cad_out").exists():  # of the build, the two parts that are looked at
        spec = load_spec(folder / f"{name}.toml")
        (folder / "cad_out" / name).mkdir(parents=True)
        for part in parts_of(spec):
            if part.name in ("shell", "core"):
                write_part(part, part.make(), folder / "cad_out" / name, spec)
    shell, core = (
        trimesh.load_mesh(folder / f"cad_out/{name}/{part}.stl") for part in ("shell", "core")
    )
    assert shell.is_watertight
    assert core.is_watertight
    opened, sensed = BOXES[name]
    cavity = (26 + 8 * (5 in opened)) * 29 * (32 + 8 * (6 in opened))
    pockets = len(sensed) * 2 * np.pi * 9 * 3
    assert_allclose(shell.volume, 42 * 45 * 48 - cavity - pockets, rtol=2e-3)

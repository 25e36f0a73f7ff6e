"""The examples of other bodies through the commands: checked, and run on coarse meshes."""

import json
from pathlib import Path

import pytest
import trimesh
import xarray as xr

from design.spec_io import load_spec
from tests.support.cli import run

EXAMPLES = Path(__file__).parents[2] / "examples"
FACES = {
    "hall_skin": (1,),
    "three_axis_dome": (1,),
    "hollow_dome": (1,),
    "handle": (1, 2, 3, 4, 5),
    "capsule": (1, 2, 3, 4, 5),
    "ball": (1, 2, 3, 4, 5),
    "egg": (1, 2, 3, 4, 5),
    "pear": (2, 3, 4, 5),
}
COARSE = [
    "mesh.edge_mm=9",
    "mesh.surface_edge_mm=3.6",
    "mesh.rim_edge_ratio=1",
    "mesh.envelope_mm=0.1",
    "contact_grid.count=[3, 3]",
    "contact_grid.pitch_mm=2.5",
    "press.depths_mm=[0.5, 1.0, 1.5, 2.0]",
    "protocol.presses_per_place=4",
    "protocol.frames_per_press=[4, 8]",
]
OVERRIDES = [part for change in COARSE for part in ("--set", change)]


@pytest.mark.parametrize("name", sorted(FACES))
def test_examples_are_valid_and_sense_the_faces_they_say(name):
    spec = load_spec(EXAMPLES / f"{name}.toml")
    assert spec.body.sensed == FACES[name]


def _run(command: str, name: str, folder: Path, *more: str) -> dict:
    done = run(command, str(EXAMPLES / f"{name}.toml"), *OVERRIDES, *more, "--json", cwd=folder)
    assert done.returncode == 0, done.stderr
    (result,) = json.loads(done.stdout)["objects"]
    return result


def assert_signals(runs: Path, faces: tuple[int, ...]) -> None:
    with xr.open_dataset(runs / "signals.nc") as data:
        assert tuple(data.face.values) == faces
        assert (data.force_n.values[:, :, -1] > 0.3).all()
        delta, of_face = data.delta_counts.values, data.sensor_face.values
    for index, face in enumerate(faces):
        own = abs(delta[index][:, :, of_face == face]).max()
        others = abs(delta[index][:, :, of_face != face]).max(initial=0)
        assert own > max(30, others)


def assert_results(name: str, folder: Path, faces: tuple[int, ...]) -> None:
    runs, parts = folder / "runs" / name, folder / "cad_out" / name
    assert_signals(runs, faces)
    for part in ("core", "shell"):
        assert trimesh.load_mesh(parts / f"{part}.stl").is_watertight
    assert (runs / "report.html").stat().st_size > 100_000


def test_a_dome_is_pressed_and_scored(tmp_path):
    _run("score", "three_axis_dome", tmp_path, "--set", "contact_grid.pitch_mm=2")
    assert_signals(tmp_path / "runs" / "three_axis_dome", (1,))


@pytest.mark.slow
@pytest.mark.parametrize("name", sorted(FACES))
def test_every_body_goes_through_the_whole_chain(name, tmp_path):
    pitch = ("--set", "contact_grid.pitch_mm=2") if name == "three_axis_dome" else ()
    _run("run", name, tmp_path, *pitch)
    assert_results(name, tmp_path, FACES[name])

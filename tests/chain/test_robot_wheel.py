"""The distribution for robots: the same packages, read without what designs and trains."""

import json
import subprocess
import sys
import tomllib
from pathlib import Path
from threading import Event

import numpy as np
import pytest
from packaging.requirements import Requirement

from estimator.inversion.storage import save_inversion
from estimator.recordings.boards.lines import encode_frame
from tests.support.mechanics.inverted import inverted, noisy_counts
from tests.support.recordings.dummy_board import dummy_board
from tests.support.recordings.made_recordings import gripper_arrays, write_gripper

ROOT = Path(__file__).parents[2]
NOT_BROUGHT = {
    *("OCP", "cadquery", "cmaes", "jinja2", "magpylib", "manifold3d", "matplotlib", "networkx"),
    *("pytetwild", "pyvista", "safetensors", "skfem", "sklearn", "torch", "trimesh"),
    *("vtkmodules", "xarray", "foxglove", "pyarrow", "rosbags", "aiohttp", "onnxruntime"),
}
"""Modules that a robot's environment has not."""
BLOCKED = """
import sys
class Absent:
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] in {blocked!r}:
            raise ModuleNotFoundError(f"No module named {{name!r}}", name=name)
sys.meta_path.insert(0, Absent())
from instobj.cli.app import main
main()
"""
CHANNELS = tuple(
    f"F{face}-{axis}{chip}" for face in range(1, 6) for chip in (1, 2, 3) for axis in "XYZ"
)


def project(folder):
    return tomllib.loads((folder / "pyproject.toml").read_text())


def run_without(blocked, *command, **more):
    code = BLOCKED.format(blocked=blocked)
    return subprocess.run(
        [sys.executable, "-c", code, *map(str, command)], capture_output=True, text=True, **more
    )


def test_it_asks_for_a_part_of_what_instobj_asks_for_at_the_same_versions():
    whole, light = project(ROOT)["project"], project(ROOT / "robot")["project"]
    extras = whole["optional-dependencies"]
    known = {*whole["dependencies"], *(line for extra in extras.values() for line in extra)}
    asked = {
        *light["dependencies"],
        *(line for e in light["optional-dependencies"].values() for line in e),
    }
    assert asked <= known
    heavy = {"torch", "cadquery", "pytetwild", "pyvista", "scikit-fem", "trimesh", "pyarrow"}
    assert not heavy & {Requirement(line).name for line in light["dependencies"]}
    assert set(light["optional-dependencies"]) <= set(extras)


def test_it_holds_the_files_of_instobj():
    built = ("tool", "hatch", "build", "targets", "wheel")
    whole, light = project(ROOT), project(ROOT / "robot")
    for name in built:
        whole, light = whole[name], light[name]
    files = whole["force-include"] | {name: name for name in whole["packages"]}
    assert light["force-include"] == {f"../{path}": home for path, home in files.items()}


def test_first_contacts_of_a_board_need_nothing_else(tmp_path):
    save_inversion(inverted(), tmp_path / "contacts.nc")
    face, contact = np.full((1, 6), -1), np.zeros((1, 6, 3))
    face[0, 0], contact[0, 0] = 2, [3.0, -2.0, 7.0]
    rng = np.random.default_rng(1)
    counts = noisy_counts(inverted(), face, contact, rng, turned=False)[0]

    asked, since = Event(), []

    def lines(number):
        since.extend([number] * (asked.is_set() and not since))
        # rest for 1 s from the first question on, which gives the zero, and then a press
        held = counts if since and number - since[0] >= 100 else 0 * counts
        noisy = 300 + held + rng.normal(0, 5, 45)
        return encode_frame(number, 10 * number, [float(round(value)) for value in noisy])

    with dummy_board(lines, channels=CHANNELS, asked=asked) as port:
        command = ("predict", tmp_path / "contacts.nc", "--port", port, "--frames", 150)
        done = run_without(NOT_BROUGHT, *command)
    assert done.returncode == 0, done.stderr[-2000:]
    frames = [json.loads(line) for line in done.stdout.splitlines()]
    read = [contact for frame in frames for contact in frame["contacts"]]
    assert {contact["face"] for contact in read} == {3}
    assert np.median([contact["force_n"] for contact in read]) == pytest.approx(7.0, rel=0.2)


def test_a_recording_becomes_a_data_set_with_nothing_else(tmp_path):
    cases = ((54, 57), (23, 28))
    file = write_gripper(tmp_path / "g.csv", gripper_arrays(cases), cases)
    done = run_without(NOT_BROUGHT, "recordings", file, "--out", tmp_path)
    assert done.returncode == 0, done.stderr[-2000:]
    assert (tmp_path / "runs" / "g" / "frames.nc").is_file()
    assert "6 presses of 2 contact cases" in done.stdout


@pytest.mark.parametrize(
    ("blocked", "command", "wanted"),
    [
        ({"torch", "skfem", "cadquery"}, ["check", "cube.toml"], "instobj"),
        ({"rosbags"}, ["recordings", "a.mcap"], "'instobj-robot[robot]'"),
        ({"aiohttp"}, ["bench", "live", "--demo"], "'instobj[bench]'"),
    ],
)
def test_what_it_leaves_out_is_one_sentence(tmp_path, blocked, command, wanted):
    installed = tmp_path / "instobj_robot-0.2.0.dist-info"
    installed.mkdir()
    (installed / "METADATA").write_text(
        "Metadata-Version: 2.4\nName: instobj-robot\nVersion: 0.2.0\nProvides-Extra: robot\n"
    )
    (tmp_path / "cube.toml").write_text('name = "cube"\n')
    (tmp_path / "a.mcap").write_bytes(b"")
    code = "import sys; sys.path.append('.')" + BLOCKED.format(blocked=blocked)
    done = subprocess.run(
        [sys.executable, "-c", code, *command], cwd=tmp_path, capture_output=True, text=True
    )
    assert done.returncode == 2
    assert "Traceback" not in done.stderr
    assert done.stderr.splitlines()[-1].endswith(f"pip install {wanted}")

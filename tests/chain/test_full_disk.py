"""A disk that fills is one error that says so, in every writer and every stage; nothing earlier is lost.

The system's limit of a file's size stands in for the disk: writing beyond it fails as on a full one.
"""

import json
import shutil
import subprocess
import sys
from contextlib import contextmanager

import numpy as np
import pytest
import torch
import trimesh
from matplotlib.figure import Figure

import instobj
from design.build.export import write_part
from design.build.parts import parts_of
from design.build.scene import write_glb
from design.build.slicer_file import write_3mf
from design.errors import FullDisk
from design.files import atomic_path, reserve_room, write_whole
from design.netcdf import FileKind, write_netcdf
from design.tables import write_records
from estimator.networks.tensor_file import save_tensors
from fem.presses.shape import DeformedShape, save_deformed_shape
from instobj.figures.saving import save_figure
from instobj.stages.run import Run
from instobj.stages.table import STAGES
from instobj.store.content import stored
from instobj.store.record import RECORD
from instobj.store.space import WHOLE, entries
from instobj.store.stage import write_json

resource = pytest.importorskip("resource", reason="limits of a file's size are POSIX's")

LEAST_BYTES = 100
"""Less than any record of a result takes."""
TINY = {
    "name": "tiny",
    "body": {"sensed_faces": [1]},
    "contact_grid": {"count": [3, 3], "pitch_mm": 7.0},
    "press": {"depths_mm": [0.5, 1.5, 3.0]},
    "mesh": {
        "edge_mm": 8.0,
        "surface_edge_mm": 3.0,
        "rim_edge_ratio": 1,
        "envelope_mm": 0.1,
    },
    "score": {"force_n": 4.0},
    "search": {"forces_n": [4.0]},
    "protocol": {"presses_per_place": 4, "frames_per_press": (4, 16)},
    "training": {"model": "compact", "hidden_units": [16, 16], "epochs": 4},
}


@contextmanager
def files_limited_to(size):
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, hard))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))


def _netcdf(folder):
    kind = FileKind("trials", {"force_n": ("step", "N")})
    write_netcdf(kind, folder / "a.nc", {"force_n": np.arange(1e4)})


def _array(folder):
    """NumPy writes such an array without telling the number of the system's error."""
    with atomic_path(folder / "a.npy") as path, path.open("wb") as stream:
        np.save(stream, np.arange(1e4))


def _figure(folder):
    figure = Figure()
    figure.subplots().plot(np.random.default_rng(0).normal(size=500))
    save_figure(figure, folder / "a.png")


def _shape(folder):
    """Tetrahedra with a corner each in common: VTK's own writer of files crashed on these."""
    count = 9000
    save_deformed_shape(
        DeformedShape(
            nodes_mm=np.random.default_rng(0).normal(size=(count, 3)),
            tets=np.arange(count - count % 4).reshape(-1, 4),
            magnet=np.full(count // 4, -1),
            displacement_mm=np.zeros((count, 3)),
            pressure_mpa=np.zeros(count),
            contact_pressure_mpa=np.zeros(count),
        ),
        folder / "a.vtu",
    )


def _part(folder):
    spec = instobj.ObjectSpec.model_validate(TINY)
    core = parts_of(spec)[0]
    write_part(core, core.make(), folder, spec)


def _sphere():
    return trimesh.creation.icosphere(4)


WRITERS = {
    "netcdf": _netcdf,
    "figure": _figure,
    "shape": _shape,
    "part": _part,
    "glb": lambda folder: write_glb(trimesh.Scene(_sphere()), folder / "a.glb"),
    "3mf": lambda folder: write_3mf(_sphere(), "ball", folder / "a.3mf"),
    "tensors": lambda folder: save_tensors({"w": torch.ones(9999)}, {}, folder / "a.safetensors"),
    "array": _array,
    "csv": lambda folder: write_records(folder / "a.csv", [{"place": k} for k in range(9999)]),
    "json": lambda folder: write_json({"places": list(range(9999))}, folder / "a.json"),
}


@pytest.mark.parametrize("name", WRITERS)
def test_a_writer_says_that_the_disk_is_full_and_leaves_nothing(name, tmp_path):
    with (
        files_limited_to(1500),
        pytest.raises(FullDisk, match=r"cannot write .*: .*MB are free .*Make room"),
    ):
        WRITERS[name](tmp_path)
    assert not list(tmp_path.iterdir())


def test_room_for_a_map_is_taken_before_it_is_filled(tmp_path):
    """On a disk that is full the first number written into a map of holes ends the process."""
    path = tmp_path / "map.npy"
    values = np.lib.format.open_memmap(path, "w+", np.float32, (1000, 250))
    assert path.stat().st_blocks * 512 < 1e6
    reserve_room(path, values.offset)
    assert path.stat().st_blocks * 512 >= 1e6
    assert not np.load(path).any()


def test_a_line_that_the_system_writes_in_part_is_told(tmp_path):
    with (
        (tmp_path / "log").open("wb", buffering=0) as file,
        files_limited_to(10),
        pytest.raises(OSError, match="too large"),
    ):
        write_whole(file.fileno(), b"twenty bytes of text")


def test_a_result_that_does_not_fit_leaves_the_store_as_it_was(tmp_path):
    def make(folder):
        (folder / "a.json").write_text("1" * 5000)

    stored(tmp_path, "small", {}, lambda folder: (folder / "a.json").write_text("1"))
    with files_limited_to(1000), pytest.raises(FullDisk, match=f"{tmp_path / 'large'}: the system"):
        stored(tmp_path, "large", {}, make)
    assert [(entry.stage, entry.state) for entry in entries(tmp_path, True)] == [("small", WHOLE)]
    assert stored(tmp_path, "small", {}, make).reused
    assert not stored(tmp_path, "large", {}, make).reused


@pytest.fixture(scope="module")
def whole_store(tmp_path_factory):
    """The specification's file and a store that every stage of it is made in, as it is asked for."""
    folder = tmp_path_factory.mktemp("full")
    (folder / "tiny.json").write_text(json.dumps(TINY))
    return folder / "tiny.json", folder / "store"


_MAKE_ON_A_FULL_DISK = """
import json, resource, sys
from pathlib import Path
import instobj
from design.errors import FullDisk
from instobj.stages.run import Run
from instobj.stages.table import STAGES
source, store, name, size = sys.argv[1:]
run = Run(instobj.ObjectSpec.model_validate(json.loads(Path(source).read_text())), root=Path(store))
for need in STAGES[name].needs:
    run.require(need)
for other, spec in STAGES[name].of_others(run.spec).values():
    Run(spec, root=Path(store), checked=False).require(other)
resource.setrlimit(resource.RLIMIT_FSIZE, (int(size), resource.getrlimit(resource.RLIMIT_FSIZE)[1]))
try:
    run.require(name)
except FullDisk as error:
    print(error)
    sys.exit(7)
"""


@pytest.mark.slow
@pytest.mark.parametrize("name", STAGES)
def test_a_stage_on_a_full_disk_is_one_error_and_goes_on_from_there(name, whole_store):
    """In a process of its own: what crashes there is seen. Afterwards the stage is made in full."""
    source, store = whole_store
    command = [sys.executable, "-c", _MAKE_ON_A_FULL_DISK, source, store, name]
    said = subprocess.run(
        [*map(str, command), str(LEAST_BYTES)], capture_output=True, text=True, check=False
    )
    assert said.returncode == 7, said.stderr[-2000:]
    assert "MB are free" in said.stdout
    assert "Traceback" not in said.stderr
    assert name not in {entry.stage for entry in entries(store)}
    assert {entry.state for entry in entries(store, by_hash=True)} <= {WHOLE}
    assert not list(store.glob(".making-*"))
    run = Run(instobj.ObjectSpec.model_validate(TINY), root=store)
    size = max((path.stat().st_size for path in _files(run.require(name).folder)), default=0)
    result = run.results[name].folder
    result.rename(result.with_name("away"))
    said = subprocess.run(
        [*map(str, command), str(max(size // 2, LEAST_BYTES))],
        capture_output=True,
        text=True,
        check=False,
    )
    result.with_name("away").rename(result)
    assert said.returncode == 7, said.stderr[-2000:]


_MAKE_ALL = """
import json, sys
from pathlib import Path
import instobj
from instobj.stages.run import Run
source, store, *names = sys.argv[1:]
run = Run(instobj.ObjectSpec.model_validate(json.loads(Path(source).read_text())), root=Path(store))
for name in names:
    run.require(name)
"""


@pytest.mark.slow
def test_every_stage_made_again_elsewhere_is_the_same_byte_by_byte(whole_store, tmp_path):
    """By another process, on the same meshes: the mesher gives others each time."""
    source, store = whole_store
    command = [sys.executable, "-c", _MAKE_ALL, str(source)]
    subprocess.run([*command, str(store), *STAGES], capture_output=True, check=True)
    for name in ("mesh", "plain_mesh", "coarse_response"):
        shutil.copytree(store / name, tmp_path / name)
    subprocess.run([*command, str(tmp_path), *STAGES], capture_output=True, check=True)
    first, again = (
        {path.relative_to(root): path for name in STAGES for path in _files(root / name)}
        for root in (store, tmp_path)
    )
    assert again.keys() == first.keys(), "a stage depends on something that differs"
    for name, path in first.items():
        if name.name != RECORD:  # tells how long it took
            assert again[name].read_bytes() == path.read_bytes(), name


def _files(folder):
    return [path for path in folder.rglob("*") if path.is_file()]

"""Meshes on record: what the mesher once made of the same surfaces, in place of 5 to 20 s each.

A record is found by what the mesher is given, so that a changed body is meshed anew, here as there.
Real meshing is tested in `tests/fem/mesh`, by commands in a process of their own, by the wheel's test
in CI and by every slow test. `INSTOBJ_TESTS_MESHES=record make test` writes what is missing and
touches what is used; `INSTOBJ_TESTS_MESHES=anew make test` uses no record.
"""

import hashlib
import os
from pathlib import Path

import numpy as np

from design.files import atomic_path
from fem.mesh import tetrahedra
from fem.mesh.mesher import run_mesher

FOLDER = Path(__file__).parents[1] / "recorded_meshes"
MODE = "INSTOBJ_TESTS_MESHES"
MOST_VERTICES = 2**16 - 1
DIGITS = 7
"""Machines differ by rounding in the last bits of a surface."""


def install():
    """From now on code under test meshes from records."""
    if os.environ.get(MODE, "") != "anew":
        tetrahedra.run_mesher = mesh_from_record


def mesh_from_record(content, seconds=3600.0):
    """As `fem.mesh.mesher.run_mesher`, from a record where there is one."""
    file = FOLDER / f"{_key(content)}.npz"
    if file.exists():
        if os.environ.get(MODE) == "record":
            file.touch()  # what is older after a run is of no use any more
        with np.load(file, allow_pickle=False) as found:
            return found["points"], found["tets"].astype(np.int64)
    points, tets = run_mesher(content, seconds)
    if os.environ.get(MODE) == "record" and len(points) <= MOST_VERTICES:
        FOLDER.mkdir(exist_ok=True)
        with atomic_path(file) as temporary, temporary.open("wb") as stream:
            np.savez_compressed(stream, points=points, tets=tets.astype(np.uint16))
    return points, tets


def _key(content):
    digest = hashlib.sha256()
    for name in sorted(content):
        array = np.asarray(content[name])
        if array.dtype.kind == "f":
            array = np.round(array * 10**DIGITS).astype(np.int64)
        digest.update(f"{name}{array.shape}".encode())
        digest.update(np.ascontiguousarray(array, dtype="<i8").tobytes())
    return digest.hexdigest()[:24]

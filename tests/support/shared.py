"""Meshes and responses that all processes of a run of the tests share: each is made once.

Code under test that meshes (`tests/fem/mesh`) does so itself.
"""

import fcntl
import os
from contextlib import contextmanager
from pathlib import Path

from fem.linear.response import build_response, load_response, save_response
from fem.mesh.tetrahedra import load_mesh, mesh_sha256, save_mesh, tetrahedralize
from instobj.store.keys import content_key

FOLDER = "INSTOBJ_TESTS_SHARED"
"""Environment variable, set by tests/conftest.py before it starts its workers."""


def shared_mesh(spec):
    """The mesh of a specification."""
    with only_one(f"mesh_{content_key(spec.model_dump(mode='json'))}") as path:
        file = path.with_suffix(".npz")
        if not file.exists():
            save_mesh(tetrahedralize(spec), file)
        return load_mesh(file)


def shared_response(mesh, spec):
    """The response of a mesh, read-only and memory-mapped."""
    key = content_key({"mesh": mesh_sha256(mesh), "spec": spec.model_dump(mode="json")})
    with only_one(f"response_{key}") as path:
        if not (path / "surfaces.npz").exists():
            path.mkdir(exist_ok=True)
            save_response(build_response(mesh, spec), path)
        return load_response(path)


@contextmanager
def only_one(name):
    """A path of the shared folder, for one process at a time."""
    folder = Path(os.environ[FOLDER])
    with (folder / f"{name}.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        yield folder / name

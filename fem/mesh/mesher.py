"""fTetWild (by pytetwild) in a separate process: limits, and a crash is one error.

The extension cannot be interrupted, asks for no seed and leaves a stray surface file in the current
folder. Run as a module, this file is the child: `python -m fem.mesh.mesher INPUT.npz OUTPUT.npz`.
"""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from jaxtyping import Float, Int

from design.errors import SolverError
from design.files import full_disk_told
from design.imports import deferred
from design.processes import ChildFailed, ChildTooSlow, machine_memory_gib, run_child

SECONDS = (300.0, 3600.0)
"""Least and most time for one mesh. The default mesh of the paper's cube takes one to four minutes."""
_SECONDS_PER_VERTEX = 0.16
"""Twenty times what vertices of curved bodies take on one core."""
_GIB, _GIB_PER_VERTEX = 16.0, 1e-4
"""Address space: of libraries and threads, and sixteen times what vertices take within fTetWild."""
_VERTICES_PER_CELL = 2.2
_TRIES = 2
"""The mesher hangs now and then on a body that it finishes when it is asked again (pytetwild#47)."""

CHILD_COMMAND = ("-P", "-m", "fem.mesh.mesher")
_ADVICE = "Try a larger mesh.envelope_mm, or a larger mesh.edge_mm and mesh.surface_edge_mm"


def run_mesher(
    content: dict[str, np.ndarray], seconds: float | None = None
) -> tuple[Float[np.ndarray, "vertex 3"], Int[np.ndarray, "tet 4"]]:
    """Vertices (mm) and tetrahedra; `content` are the arguments of `pytetwild.tetrahedralize`.

    Time and memory are limited by the vertices that are expected; `seconds` are those of each of two tries.

    Raises
    ------
    SolverError
        The mesher fails, crashes, or needs more time or memory than such a mesh should.
    """
    vertices = expected_vertices(content)
    if seconds is None:
        seconds = float(np.clip(_SECONDS_PER_VERTEX * vertices, *SECONDS))
    gib = min(machine_memory_gib() or np.inf, _GIB + _GIB_PER_VERTEX * vertices)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        given, made = folder / "in.npz", folder / "out.npz"
        with full_disk_told(given, folder):
            np.savez(given, **content)  # pyright: ignore[reportArgumentType]
        command = (*CHILD_COMMAND, str(given), str(made))
        try:
            _run_again_if_it_hangs(command, folder, seconds, gib)
        except ChildTooSlow:
            raise SolverError(
                f"the mesher did not finish this body in {_TRIES} tries of {seconds:g} s. {_ADVICE}"
            ) from None
        except ChildFailed as failure:
            raise SolverError(f"the mesher failed on this body: {failure}. {_ADVICE}") from None
        with np.load(made, allow_pickle=False) as mesh:
            return mesh["points"], mesh["tets"]


def expected_vertices(content: dict[str, np.ndarray]) -> float:
    """Number of vertices of a mesh in the whole box of the background mesh: no fewer than in the body.

    A vertex for a volume of h³/2.2, which resources count with too, where edges are h long.
    """
    if "bg_tets" not in content:
        return 0.0
    corner = content["bg_vertices"][content["bg_tets"]]
    volume = abs(np.linalg.det(corner[:, 1:] - corner[:, :1])) / 6
    edge = np.minimum(
        content["bg_values"][content["bg_tets"]].mean(axis=1), content["edge_length_abs"]
    )
    return float(_VERTICES_PER_CELL * np.sum(volume / edge**3))


def _run_again_if_it_hangs(
    command: Sequence[str], folder: Path, seconds: float, gib: float
) -> None:
    for tries_left in reversed(range(_TRIES)):
        try:
            run_child(command, folder, seconds, gib)
            return
        except ChildTooSlow:
            if not tries_left:
                raise


def _mesh_as_child(given: str, made: str) -> int:
    # what it adds to PyVista, which takes as long to import as all the rest
    with deferred("pytetwild._accessor"):
        from pytetwild.pytetwild import tetrahedralize

    with np.load(given, allow_pickle=False) as content:
        arguments = {name: content[name][()] for name in content.files}
    try:
        points, tets = tetrahedralize(**arguments, quiet=True)
    except (RuntimeError, MemoryError) as error:
        print(f"{type(error).__name__}: {error}".replace("\n", " "), file=sys.stderr)
        return 1
    np.savez(made, points=points, tets=tets)
    return 0


if __name__ == "__main__":
    sys.exit(_mesh_as_child(*sys.argv[1:]))

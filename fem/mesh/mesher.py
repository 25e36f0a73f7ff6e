"""fTetWild (by pytetwild) in a separate process: limits, and a crash is one error.

The extension cannot be interrupted, asks for no seed and leaves a stray surface file in the current
folder. Run as a module, this file is the child: `python -m fem.mesh.mesher INPUT.npz OUTPUT.npz`.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

import numpy as np
from jaxtyping import Float, Int

from design.errors import SolverError
from design.files import full_disk_told
from design.imports import deferred
from design.processes import ChildFailed, ChildTooSlow, machine_memory_gib, run_child

SECONDS = 3600.0
"""Time limit of one mesh. The default mesh of the paper's cube takes one to four minutes."""

_CHILD = ("-P", "-m", "fem.mesh.mesher")
_ADVICE = "Try a larger mesh.envelope_mm, or a larger mesh.edge_mm and mesh.surface_edge_mm"


def run_mesher(
    content: dict[str, np.ndarray], seconds: float = SECONDS
) -> tuple[Float[np.ndarray, "vertex 3"], Int[np.ndarray, "tet 4"]]:
    """Vertices (mm) and tetrahedra; `content` are the arguments of `pytetwild.tetrahedralize`.

    Raises
    ------
    SolverError
        The mesher fails, crashes, or needs more than `seconds`.
    """
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        given, made = folder / "in.npz", folder / "out.npz"
        with full_disk_told(given, folder):
            np.savez(given, **content)  # pyright: ignore[reportArgumentType]
        command = (*_CHILD, str(given), str(made))
        try:
            run_child(command, folder, seconds, machine_memory_gib())
        except ChildTooSlow:
            raise SolverError(
                f"the mesher did not finish this body within {seconds:g} s. {_ADVICE}"
            ) from None
        except ChildFailed as failure:
            raise SolverError(f"the mesher failed on this body: {failure}. {_ADVICE}") from None
        with np.load(made, allow_pickle=False) as found:
            return found["points"], found["tets"]


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

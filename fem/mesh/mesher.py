"""fTetWild (by pytetwild) in a separate process: limits, progress, and a crash is one error.

The extension cannot be interrupted, asks for no seed and leaves a stray surface file in the current
folder. Run as a module, this file is the child: `python -m fem.mesh.mesher INPUT.npz OUTPUT.npz`.
"""

from __future__ import annotations

import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
from jaxtyping import Float, Int

from design.errors import InputError

Progress = Callable[[str], None]

SECONDS = 3600.0
"""Time limit of one mesh. The default mesh of the paper's cube takes one to four minutes."""

PROGRESS_EVERY_S = 15.0
_REFUSED = 3
_CHILD = ("-P", "-m", "fem.mesh.mesher")
_ADVICE = "Try a larger mesh.envelope_mm, or a larger mesh.edge_mm and mesh.surface_edge_mm"


def run_mesher(
    content: dict[str, np.ndarray], progress: Progress | None = None, seconds: float = SECONDS
) -> tuple[Float[np.ndarray, "vertex 3"], Int[np.ndarray, "tet 4"]]:
    """Vertices (mm) and tetrahedra; `content` are the arguments of `pytetwild.tetrahedralize`.

    `progress` is told every 15 s how long the mesher has worked.

    Raises
    ------
    InputError
        The mesher fails, crashes, or needs more than `seconds`.
    """
    with tempfile.TemporaryDirectory() as folder:
        given, made, said = (Path(folder) / name for name in ("in.npz", "out.npz", "said.txt"))
        np.savez(given, **content)  # pyright: ignore[reportArgumentType]
        command = [sys.executable, *_CHILD, str(given), str(made)]
        with said.open("w") as stream:
            child = subprocess.Popen(command, cwd=folder, stdout=subprocess.DEVNULL, stderr=stream)
            try:
                _wait(child, progress, seconds)
            finally:
                child.kill()
                child.wait()
        if child.returncode != 0:
            why = _reason(child.returncode, said.read_text(errors="replace"))
            raise InputError(f"the mesher failed on this body: {why}. {_ADVICE}")
        with np.load(made, allow_pickle=False) as found:
            return found["points"], found["tets"]


def _wait(child: subprocess.Popen[bytes], progress: Progress | None, seconds: float) -> None:
    start = time.monotonic()
    while child.poll() is None:
        elapsed = time.monotonic() - start
        if elapsed >= seconds:
            raise InputError(f"the mesher did not finish this body within {seconds:g} s. {_ADVICE}")
        try:
            child.wait(min(PROGRESS_EVERY_S, seconds - elapsed))
        except subprocess.TimeoutExpired:
            if progress:
                progress(f"the mesher has worked for {time.monotonic() - start:.0f} s")


def _reason(code: int, said: str) -> str:
    if code < 0:
        return f"it crashed ({signal.Signals(-code).name})"
    lines = said.strip().splitlines()
    return lines[-1] if lines else f"it ended with code {code}"


def _mesh_as_child(given: str, made: str) -> int:
    from pytetwild.pytetwild import tetrahedralize

    _limit_memory()
    with np.load(given, allow_pickle=False) as content:
        arguments = {name: content[name][()] for name in content.files}
    try:
        points, tets = tetrahedralize(**arguments, quiet=True)
    except (RuntimeError, MemoryError) as error:
        print(str(error).replace("\n", " ") or type(error).__name__, file=sys.stderr)
        return _REFUSED
    np.savez(made, points=points, tets=tets)
    return 0


def _limit_memory() -> None:
    """At most what the machine has, so that a mesh too fine ends here and nothing else does."""
    if sys.platform != "linux":
        return
    import os
    import resource

    most = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    resource.setrlimit(resource.RLIMIT_AS, (most, most))


if __name__ == "__main__":
    sys.exit(_mesh_as_child(*sys.argv[1:]))

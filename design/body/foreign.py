"""Surfaces in files that others wrote, read in a separate process.

Parsers of STEP and of meshes crash, hang or fill the memory on damaged files. Here that is one
error: the reader (`design.solids.foreign`) gets limits of time and, on Linux, of memory.
"""

from __future__ import annotations

import signal
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import numpy as np
from jaxtyping import Float, Int

from design.errors import InputError
from design.files import require_regular_file

FORMATS = (".stl", ".obj", ".ply", ".off", ".step", ".stp")
SECONDS = 180.0
MEMORY_GIB = 8
_REFUSED = 3
_READER = "design.solids.foreign"


class ForeignSurface(NamedTuple):
    """Triangles of a file, as they stand there.

    Attributes
    ----------
    vertices_mm : (vertex, 3)
    triangles : (triangle, 3) rows of vertices
    """

    vertices_mm: Float[np.ndarray, "vertex 3"]
    triangles: Int[np.ndarray, "triangle 3"]


def read_foreign_surface(path: Path, missing: str, seconds: float = SECONDS) -> ForeignSurface:
    """The surface in an STL, OBJ, PLY, OFF or STEP file; `missing` is said where there is none.

    Raises
    ------
    InputError
        The file is missing or no file, cannot be read, holds no triangles, or its reader crashed, or
        needed more than `seconds` or 8 GiB.
    """
    require_regular_file(path, missing)
    if path.suffix.lower() not in FORMATS:
        raise InputError(
            f"{path} cannot be read as a body: its name ends in {path.suffix or 'nothing'}, not in one "
            f"of {', '.join(FORMATS)}. Export it as STL or STEP"
        )
    with tempfile.TemporaryDirectory() as folder:
        target = Path(folder) / "surface.npz"
        command = [sys.executable, "-P", "-m", _READER, str(path.resolve()), str(target)]
        try:
            done = subprocess.run(
                command,
                capture_output=True,
                text=True,
                errors="replace",
                timeout=seconds,
                preexec_fn=_memory_limit(),
                check=False,
            )
        except subprocess.TimeoutExpired:
            raise InputError(
                f"{path} was not read within {seconds:g} s. Export it coarser, or repair it"
            ) from None
        if done.returncode != 0:
            raise InputError(f"{path} cannot be read: {_reason(done)}. Export it anew")
        with np.load(target, allow_pickle=False) as content:
            found = ForeignSurface(content["vertices"], content["triangles"])
    if not len(found.triangles):
        raise InputError(f"{path} holds no solid and no triangles. Export one closed body in mm")
    return found


def _reason(done: subprocess.CompletedProcess[str]) -> str:
    if done.returncode < 0:
        return f"its reader crashed ({signal.Signals(-done.returncode).name}); the file is damaged"
    lines = done.stderr.strip().splitlines()
    if done.returncode == _REFUSED and lines:
        return lines[-1]
    if "MemoryError" in done.stderr or "bad_alloc" in done.stderr:
        return f"it needs more than {MEMORY_GIB} GiB of memory"
    return lines[-1] if lines else f"its reader ended with code {done.returncode}"


def _memory_limit() -> Callable[[], None] | None:
    """Sets the limit in the child; other systems than Linux do not keep it."""
    if sys.platform != "linux":
        return None
    import resource

    most = MEMORY_GIB * 2**30
    return lambda: resource.setrlimit(resource.RLIMIT_AS, (most, most))

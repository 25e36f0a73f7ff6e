"""Surfaces in files that others wrote, read in a separate process (`design.solids.foreign`).

Parsers of STEP and of meshes crash, hang or fill the memory on damaged files.
"""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import NamedTuple

import numpy as np
from jaxtyping import Float, Int

from design.errors import InputError
from design.files import require_regular_file
from design.processes import ChildFailed, ChildTooSlow, run_child

STEP = (".step", ".stp")
FORMATS = (".stl", ".obj", ".ply", ".off", *STEP)
SECONDS = 180.0
"""Time after which the reading of another person's file is stopped."""
MEMORY_GIB = 8.0
"""Memory that the process which reads it may take."""
READER = "design.solids.foreign"


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
        command = ("-P", "-m", READER, str(path.resolve()), str(target))
        try:
            run_child(command, Path(folder), seconds, MEMORY_GIB)
        except ChildTooSlow:
            raise InputError(
                f"{path} was not read within {seconds:g} s. Export it coarser, or repair it"
            ) from None
        except ChildFailed as failure:
            raise InputError(f"{path} cannot be read: {failure}. Export it anew") from None
        with np.load(target, allow_pickle=False) as content:
            surface = ForeignSurface(content["vertices"], content["triangles"])
    if not len(surface.triangles):
        raise InputError(f"{path} holds no solid and no triangles. Export one closed body in mm")
    return surface

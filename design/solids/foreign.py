"""Reader of surface files that others wrote, run as a program: a crash ends it and nothing else.

    python -m design.solids.foreign FILE OUT.npz

Writes vertices (vertex, 3) mm and triangles (triangle, 3) of the file's surface.
`design.body.foreign` calls it.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

_STEP = (".step", ".stp")
_TOLERANCE_MM, _ANGLE_RAD = 0.03, 0.2
_LARGEST_MM = 2000.0
"""Of a STEP solid: at that tolerance, larger ones take millions of triangles."""


def _of_mesh(path: Path) -> tuple[np.ndarray, np.ndarray]:
    import trimesh

    surface = trimesh.load_mesh(path)
    if not isinstance(surface, trimesh.Trimesh):
        return np.empty((0, 3)), np.empty((0, 3), dtype=np.int64)
    return np.asarray(surface.vertices), np.asarray(surface.faces)


def _of_step(path: Path) -> tuple[np.ndarray, np.ndarray]:
    import cadquery as cq

    vertices, triangles, count = [], [], 0
    for shape in cq.importers.importStep(str(path)).vals():
        length_mm = shape.BoundingBox().DiagonalLength  # type: ignore[union-attr]
        if length_mm > _LARGEST_MM:
            raise ValueError(
                f"it is {length_mm / 1e3:.3g} m long, more than {_LARGEST_MM / 1e3:g} m"
            )
        points, faces = shape.tessellate(_TOLERANCE_MM, _ANGLE_RAD)  # type: ignore[union-attr]
        vertices += [point.toTuple() for point in points]
        triangles += [[count + corner for corner in face] for face in faces]
        count = len(vertices)
    return np.reshape(vertices, (-1, 3)), np.reshape(triangles, (-1, 3)).astype(np.int64)


def main(source: str, target: str) -> int:
    """Exit code: 0, or 1 with the reason on standard error."""
    path = Path(source)
    try:
        vertices, triangles = (_of_step if path.suffix.lower() in _STEP else _of_mesh)(path)
    except Exception as error:  # readers raise whatever their parsers meet
        print(f"{type(error).__name__}: {error}".splitlines()[0][:200], file=sys.stderr)
        return 1
    np.savez(target, vertices=vertices.astype(float), triangles=triangles)
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))

"""Reader of surface files that others wrote, run as a program: a crash ends it and nothing else.

    python -m design.solids.foreign FILE OUT.npz

Writes vertices (vertex, 3) mm and triangles (triangle, 3) of the file's surface.
`design.body.foreign` calls it.
"""

# pyright: reportAttributeAccessIssue=false
from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import numpy as np

from design.body.foreign import STEP

_TOLERANCE_MM, _ANGLE_RAD = 0.03, 0.2
_LARGEST_MM = 2000.0
"""Largest size of a STEP solid: at that tolerance, larger ones take millions of triangles."""

_NOTHING = np.empty((0, 3)), np.empty((0, 3), np.int64)
"""Vertices and triangles of what has no surface."""


def solid_of_mesh(path: Path) -> tuple[np.ndarray, np.ndarray]:
    import trimesh

    surface = trimesh.load_mesh(path, process=False)
    if not isinstance(surface, trimesh.Trimesh):
        return _NOTHING
    return np.asarray(surface.vertices), np.asarray(surface.faces)


def solid_of_step(path: Path) -> tuple[np.ndarray, np.ndarray]:
    """Read by the kernel itself: CadQuery's import took 2.4 s more."""
    from OCP.BRepMesh import BRepMesh_IncrementalMesh
    from OCP.IFSelect import IFSelect_RetDone
    from OCP.Interface import Interface_Static
    from OCP.STEPControl import STEPControl_Reader
    from OCP.TopAbs import TopAbs_FACE
    from OCP.TopExp import TopExp_Explorer
    from OCP.TopoDS import TopoDS

    Interface_Static.SetCVal_s("xstep.cascade.unit", "MM")
    reader = STEPControl_Reader()
    if reader.ReadFile(str(path)) != IFSelect_RetDone:
        raise ValueError("STEP File could not be loaded")
    for root in range(1, reader.NbRootsForTransfer() + 1):
        reader.TransferRoot(root)
    vertices, triangles, count = [_NOTHING[0]], [_NOTHING[1]], 0
    for number in range(1, reader.NbShapes() + 1):
        shape = reader.Shape(number)
        _require_length(shape)
        BRepMesh_IncrementalMesh(shape, _TOLERANCE_MM, True, _ANGLE_RAD)
        faces = TopExp_Explorer(shape, TopAbs_FACE)
        while faces.More():
            points, corners = _face_triangles(TopoDS.Face_s(faces.Current()))
            vertices.append(points)
            triangles.append(corners + count)
            count += len(points)
            faces.Next()
    return np.concatenate(vertices), np.concatenate(triangles)


def _require_length(shape: Any) -> None:
    from OCP.Bnd import Bnd_Box
    from OCP.BRepBndLib import BRepBndLib

    box = Bnd_Box()
    BRepBndLib.AddOptimal_s(shape, box)
    length_mm = 0.0 if box.IsVoid() else box.SquareExtent() ** 0.5
    if length_mm > _LARGEST_MM:
        raise ValueError(f"it is {length_mm / 1e3:.3g} m long, more than {_LARGEST_MM / 1e3:g} m")


def _face_triangles(face: Any) -> tuple[np.ndarray, np.ndarray]:
    """Vertices (vertex, 3) and triangles (triangle, 3) of a meshed face, turned outwards."""
    from OCP.BRep import BRep_Tool
    from OCP.TopAbs import TopAbs_REVERSED
    from OCP.TopLoc import TopLoc_Location

    location = TopLoc_Location()
    mesh = BRep_Tool.Triangulation_s(face, location)
    if mesh is None:
        return _NOTHING
    placed = location.Transformation()
    points = [mesh.Node(i).Transformed(placed) for i in range(1, mesh.NbNodes() + 1)]
    vertices = np.array([(p.X(), p.Y(), p.Z()) for p in points])
    corners = np.array([[t.Value(1), t.Value(2), t.Value(3)] for t in mesh.Triangles()]) - 1
    if face.Orientation() == TopAbs_REVERSED:
        corners = corners[:, [0, 2, 1]]
    return vertices, corners


def main(source: str, target: str) -> int:
    """Exit code: 0, or 1 with the reason on standard error."""
    path = Path(source)
    try:
        vertices, triangles = (solid_of_step if path.suffix.lower() in STEP else solid_of_mesh)(
            path
        )
    except Exception as error:  # readers raise whatever their parsers meet
        print(f"{type(error).__name__}: {error}".splitlines()[0][:200], file=sys.stderr)
        return 1
    np.savez(target, vertices=vertices.astype(float), triangles=triangles)
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))

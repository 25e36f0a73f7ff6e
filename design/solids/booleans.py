"""Booleans over exact solids and closed triangle surfaces alike.

A body that is known by its triangles meets mould tools that are exact: whatever an operation has
triangles among its operands is done with triangles, everything else stays exact.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextvars import ContextVar
from typing import Any, Literal, TypeAlias

import numpy as np
import trimesh
from OCP.BRepMesh import BRepMesh_IncrementalMesh  # pyright: ignore[reportAttributeAccessIssue]
from OCP.Standard import Standard_Failure  # pyright: ignore[reportAttributeAccessIssue]

from design.body.meshes import boolean_of, height_mm, one_closed_surface, signed_mm3
from design.errors import NotOneSolid
from design.solids.kernel import cq
from design.solids.primitives import single_solid

Shape: TypeAlias = cq.Shape | trimesh.Trimesh
Solid: TypeAlias = cq.Solid | trimesh.Trimesh

_NOTHING_MM3 = 1e-9
FINENESS = (0.005, 0.1)
"""Tools leave their solids by 5 µm where they become triangles."""
_TRIANGLES_ALONE = ContextVar("triangles alone", default=False)
"""True where exact solids are made triangles in every operation."""
_FOLD_DEG, _FILM_MM = 175.0, 1e-3
"""Turn between neighbouring triangles beyond which they are a fold, and height below which a triangle
is a film, whose normal says nothing."""


def exact_or_triangles(make: Callable[[], Solid], fineness: tuple[float, float]) -> Solid:
    """Return what `make` builds, exact where its triangles are sound, else of triangles within 5 µm.

    The kernel fails where a cut grazes another, or a ball's pole: it finds no valid solid, or one whose
    triangles (`fineness`, mm and rad) fold back on each other.

    Raises
    ------
    NotOneSolid
        An InputError: triangles do not give one closed body either.
    """
    try:
        solid = make()
    except (NotOneSolid, Standard_Failure):
        return _make_of_triangles(make)
    # of a copy: triangles that a solid keeps widen its box
    if not isinstance(solid, cq.Shape) or not _is_folded(
        convert_to_triangles(solid.copy(), fineness, False)
    ):
        return solid
    try:
        surface = _make_of_triangles(make)
    except NotOneSolid:
        return solid
    return solid if _is_folded(convert_to_triangles(surface, fineness, False)) else surface


def _make_of_triangles(make: Callable[[], Solid]) -> Solid:
    token = _TRIANGLES_ALONE.set(True)
    try:
        return make()
    except Standard_Failure as error:  # of what is exact throughout
        raise NotOneSolid(
            f"the kernel finds no solid ({error}). Move recesses, holes or pockets apart",
            cq.Compound.makeCompound([]),
        ) from None
    finally:
        _TRIANGLES_ALONE.reset(token)


def _is_folded(surface: trimesh.Trimesh) -> bool:
    """Return whether neighbouring triangles, films left out, lie on each other as those of a fold."""
    turned = np.degrees(surface.face_adjacency_angles) > _FOLD_DEG
    low = height_mm(surface)[surface.face_adjacency].min(axis=1) <= _FILM_MM
    return bool((turned & ~low).any())


def cut(body: Shape, *tools: Shape) -> Shape:
    """Return what is left of a body without the tools."""
    if not tools:
        return body
    exact = _exact(body, *tools)
    if exact:
        return exact[0].cut(*exact[1:])
    return _manifold("difference", [body, *tools])


def join(body: Shape, *tools: Shape) -> Shape:
    """The union of a body and the tools."""
    if not tools:
        return body
    exact = _exact(body, *tools)
    if exact:
        return exact[0].fuse(*exact[1:])
    return _manifold("union", [body, *tools])


def common(body: Shape, tool: Shape) -> Shape:
    """Return what a body and a tool share."""
    exact = _exact(body, tool)
    if exact:
        return exact[0].intersect(exact[1])
    return _manifold("intersection", [body, tool])


def volume_mm3(body: Shape) -> float:
    """Volume; 0 of nothing."""
    if isinstance(body, cq.Shape):
        return float(sum(solid.Volume() for solid in body.Solids()))
    return float(body.volume) if len(body.faces) else 0.0


def one_solid(shape: Shape, part: str) -> Solid:
    """Return the one closed body that a shape is made of, with its voids.

    Raises
    ------
    NotOneSolid
        An InputError: several pieces, or a surface that is not closed.
    """
    exact = isinstance(shape, cq.Shape)
    return single_solid(shape, part) if exact else one_closed_surface(shape, part)


def one_body(shape: Shape, part: str) -> Solid:
    """Return the same with its voids filled.

    Raises
    ------
    NotOneSolid
        As `one_solid`.
    """
    surface = one_solid(shape, part)
    if isinstance(surface, cq.Solid):
        return cq.Solid.makeSolid(surface.outerShell()) if surface.innerShells() else surface
    pieces = surface.split(only_watertight=False)
    return surface if len(pieces) == 1 else next(piece for piece in pieces if piece.volume > 0)


def pieces_that_meet(shape: Shape, other_shape: Shape) -> Shape:
    """Keep a shape's separate pieces that share volume with another shape.

    Folded triangles without volume, which booleans leave where surfaces touch, are dropped.
    """
    if isinstance(shape, cq.Shape):
        solids = shape.Solids()
        kept = [solid for solid in solids if volume_mm3(common(solid, other_shape)) > 0]
        return shape if len(kept) == len(solids) else cq.Compound.makeCompound(kept)
    pieces = shape.split(only_watertight=False)
    solid = [piece for piece in pieces if abs(signed_mm3(piece)) > _NOTHING_MM3]
    kept = [
        piece for piece in solid if piece.volume < 0 or volume_mm3(common(piece, other_shape)) > 0
    ]
    if len(kept) == len(pieces):
        return shape
    joined: Any = trimesh.util.concatenate(kept)
    return joined


def without_offcuts(shape: Shape, share: float) -> Shape:
    """Without separate pieces smaller than a share of the largest."""
    if isinstance(shape, cq.Shape):
        solids = shape.Solids()
        least = share * max(map(volume_mm3, solids), default=0.0)
        kept = [solid for solid in solids if volume_mm3(solid) >= least]
        return shape if len(kept) == len(solids) else cq.Compound.makeCompound(kept)
    pieces = shape.split(only_watertight=False)
    sizes = [signed_mm3(piece) for piece in pieces]
    least = share * max(sizes, default=0.0)
    whole = [p for p, size in zip(pieces, sizes, strict=True) if size < 0 or size >= least]
    joined: Any = shape if len(whole) == len(pieces) else trimesh.util.concatenate(whole)
    return joined


TRIANGLES = 0.05, 0.2
"""Distance by which triangles of STL, 3MF and GLB files may leave the solids (mm), and turn at a step
(rad): on a sphere of 50 mm the first holds, on fillets of 1 mm the second."""


def convert_to_triangles(
    shape: Shape, fineness: tuple[float, float] = FINENESS, relative: bool = True
) -> trimesh.Trimesh:
    """Triangles of an exact solid within a tolerance (mm, of edges' lengths where `relative`) and an angle
    (rad); what consists of triangles is returned."""
    if not isinstance(shape, cq.Shape):
        return shape
    if not relative:
        BRepMesh_IncrementalMesh(shape.wrapped, fineness[0], False, fineness[1], True)
    points, triangles = shape.tessellate(*fineness)
    mesh = trimesh.Trimesh([point.toTuple() for point in points], triangles)
    mesh.merge_vertices(digits_vertex=7)
    corners = np.sort(mesh.faces, axis=1)
    mesh.update_faces((np.diff(corners, axis=1) > 0).all(axis=1))
    return mesh


def stl_surface(mesh: trimesh.Trimesh) -> trimesh.Trimesh | None:
    """The surface as an STL holds it, in single precision; None where it does not close then.

    Corners that become one are merged; triangles that lose a corner by it, and pairs that become one
    fold, are left out.
    """
    corners = np.asarray(mesh.vertices, np.float32).astype(np.float64)
    rounded = trimesh.Trimesh(corners, mesh.faces, process=False)
    rounded.merge_vertices()
    order = np.argsort(rounded.faces, axis=1)
    ways = np.linalg.det(np.eye(3)[order])  # 1 or -1: round the sorted corners, or against
    _, first, group = np.unique(
        np.sort(rounded.faces, axis=1), axis=0, return_index=True, return_inverse=True
    )
    folded = np.bincount(group, weights=ways)[group] == 0
    kept = ~folded & np.isin(np.arange(len(ways)), first)
    kept &= (np.diff(np.sort(rounded.faces, axis=1), axis=1) > 0).all(axis=1)
    rounded.update_faces(kept)
    rounded.remove_unreferenced_vertices()
    closed = rounded.is_watertight and rounded.is_winding_consistent
    return rounded if closed else None


def _exact(*shapes: Shape) -> list[cq.Shape]:
    """The same shapes if all of them are exact, else nothing."""
    if _TRIANGLES_ALONE.get():
        return []
    exact = [shape for shape in shapes if isinstance(shape, cq.Shape)]
    return exact if len(exact) == len(shapes) else []


def _manifold(
    operation: Literal["union", "difference", "intersection"], shapes: Sequence[Shape]
) -> Any:
    meshes = [convert_to_triangles(shape) for shape in shapes]
    return boolean_of(operation, meshes)

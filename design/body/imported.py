"""Bodies from files: read, repaired where that is safe, or refused with the reason."""

from __future__ import annotations

import hashlib
import warnings
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from design.body.foreign import read_foreign_surface
from design.errors import InputError
from design.files import require_regular_file

if TYPE_CHECKING:
    import trimesh

_PIERCED_MM = 0.1
"""How far one triangle may stand through another: less is lost in the body's own triangles."""


def body_of_file(path: Path, mm_per_unit: float = 1.0) -> dict[str, Any]:
    """What `[body]` takes from a file: its path and the size of its box.

    A unit of the file is `mm_per_unit` long; STEP files are read in mm whatever they are drawn in.

    Raises
    ------
    InputError
        A file that is missing, not a solid, open, in several pieces or crossing itself.
    """
    size = [round(float(edge), 6) for edge in _surface_in(path, mm_per_unit).extents]
    return {"file": str(path.resolve()), "size_mm": size}


def read_surface(file: str | None, mm_per_unit: float = 1.0) -> trimesh.Trimesh:
    """The surface in a file, its box centred on the origin.

    Raises
    ------
    InputError
        As `body_of_file`, or no file is given.
    """
    if file is None:
        raise InputError("body.kind = 'imported' needs body.file. Name an STL or STEP file")
    return _surface_in(Path(file), mm_per_unit).copy()


def file_digest(file: str | None) -> str | None:
    """SHA-256 (hex) of the file that a body comes from, if any."""
    return None if file is None else _digest(Path(file))


def _digest(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()


def _surface_in(path: Path, mm_per_unit: float) -> trimesh.Trimesh:
    require_regular_file(path, _missing(path))
    return _closed_surface(path.resolve(), _digest(path), mm_per_unit)


@lru_cache(maxsize=4)
def _closed_surface(path: Path, digest: str, mm_per_unit: float) -> trimesh.Trimesh:
    """The file's surface, kept while its content is the same."""
    surface = _as_it_is(path)
    surface.apply_scale(mm_per_unit)
    surface = _repaired(surface, path)
    surface.apply_translation(-surface.bounds.mean(axis=0))
    _require_simple(surface, path)
    return surface


def _as_it_is(path: Path) -> trimesh.Trimesh:
    import trimesh

    found = read_foreign_surface(path, _missing(path))
    return trimesh.Trimesh(found.vertices_mm, found.triangles)


def _missing(path: Path) -> str:
    return f"no body at {path}. Name an STL or STEP file in body.file"


def _repaired(surface: trimesh.Trimesh, path: Path) -> trimesh.Trimesh:
    """Merged, holes filled, turned outwards, overlapping pieces united; tells what it did."""
    import trimesh

    surface.merge_vertices()
    surface.update_faces(surface.nondegenerate_faces() & surface.unique_faces())
    done = []
    if not surface.is_watertight:
        before = len(surface.faces)
        trimesh.repair.fill_holes(surface)
        done.append(f"closed small holes with {len(surface.faces) - before} triangles")
    _require_closed(surface, path)
    if not surface.is_winding_consistent or surface.volume < 0:
        trimesh.repair.fix_normals(surface)
        done.append("turned triangles outwards")
    if surface.body_count > 1:
        pieces = surface.body_count
        surface = _united(surface, path)
        done.append(f"united {pieces} pieces that overlap")
    if done:
        warnings.warn(f"{path}: {' and '.join(done)}", stacklevel=2)
    return surface


def _require_closed(surface: trimesh.Trimesh, path: Path) -> None:
    if surface.is_watertight:
        return
    _, count = np.unique(surface.edges_sorted, axis=0, return_counts=True)
    raise InputError(
        f"the surface in {path} is open: {(count == 1).sum()} edges have a triangle on one side only, "
        f"{(count > 2).sum()} edges more than two triangles. Close it in the program that made it"
    )


def _united(surface: trimesh.Trimesh, path: Path) -> trimesh.Trimesh:
    """The union of pieces that overlap.

    Raises
    ------
    InputError
        Pieces apart from each other, or voids inside.
    """
    import trimesh

    pieces = surface.split()
    whole = all(piece.volume > 0 for piece in pieces)
    united = trimesh.boolean.union(pieces, engine="manifold") if whole else surface
    if united.body_count != 1:
        raise InputError(
            f"{path} holds {len(pieces)} separate surfaces. Export one closed body without holes inside"
        )
    return united


def _require_simple(surface: trimesh.Trimesh, path: Path) -> None:
    """Refuse a surface that crosses itself: one of its edges then runs through a triangle."""
    from design.body.meshes import manifold_of

    solid, corners = manifold_of(surface), np.asarray(surface.vertices)
    for start, end in corners[surface.edges_unique]:
        for hit in solid.ray_cast(tuple(start), tuple(end)):
            place, normal = np.asarray(hit.position), np.asarray(hit.normal)
            beyond = min(abs((start - place) @ normal), abs((end - place) @ normal))
            if beyond > _PIERCED_MM:
                raise InputError(
                    f"the surface in {path} crosses itself, {beyond:.2g} mm deep at "
                    f"({', '.join(f'{x:.3g}' for x in place)}) mm from its middle. Unite its pieces in the "
                    "program that made it"
                )

"""Bodies from files: read, repaired where that is safe, or refused with the reason."""

from __future__ import annotations

import hashlib
import warnings
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from design.errors import InputError

if TYPE_CHECKING:
    import trimesh

    from design.spec_body import BodySpec

_STEP = (".step", ".stp")
_TOLERANCE_MM, _ANGLE_RAD = 0.03, 0.2
_SAMPLES = 20_000
_OVERLAP = 0.04
"""Share of the volume from which on a surface counts as crossing itself; 20 000 samples scatter by
1 % where the body fills half of its box."""


def body_of_file(path: Path) -> dict[str, Any]:
    """What `[body]` takes from a file: its path and the size of its box.

    Raises
    ------
    InputError
        A file that is missing, not a solid, open, in several pieces or crossing itself.
    """
    size = [round(float(edge), 6) for edge in _closed_surface(path).extents]
    return {"file": str(path.resolve()), "size_mm": size}


def read_body(body: BodySpec) -> trimesh.Trimesh:
    """The surface in `body.file`, its box centred on the origin.

    Raises
    ------
    InputError
        As `body_of_file`.
    """
    if body.file is None:
        raise InputError("body.kind = 'imported' needs body.file. Name an STL or STEP file in mm")
    return _closed_surface(Path(body.file))


def file_digest(body: BodySpec) -> str | None:
    """SHA-256 (hex) of the file that a body comes from, if any."""
    return None if body.file is None else hashlib.sha256(Path(body.file).read_bytes()).hexdigest()


def _closed_surface(path: Path) -> trimesh.Trimesh:
    if not path.is_file():
        raise InputError(f"no body at {path}. Name an STL or STEP file in mm in body.file")
    surface = _of_step(path) if path.suffix.lower() in _STEP else _of_mesh(path)
    surface = _repaired(surface, path)
    surface.apply_translation(-surface.bounds.mean(axis=0))
    _require_simple(surface, path)
    return surface


def _of_mesh(path: Path) -> trimesh.Trimesh:
    import trimesh

    try:
        surface = trimesh.load_mesh(path)
    except (ValueError, IndexError, KeyError, OSError, NotImplementedError) as error:
        raise InputError(f"{path} cannot be read as a surface: {error}. Export it anew") from error
    if not isinstance(surface, trimesh.Trimesh) or not len(surface.faces):
        raise InputError(f"{path} holds no triangles. Export a closed surface in mm")
    return surface


def _of_step(path: Path) -> trimesh.Trimesh:
    import cadquery as cq
    import trimesh

    try:
        shape = cq.importers.importStep(str(path)).val()
        points, triangles = shape.tessellate(_TOLERANCE_MM, _ANGLE_RAD)  # pyright: ignore
    except (ValueError, RuntimeError, AttributeError, IndexError) as error:
        raise InputError(f"{path} cannot be read as STEP: {error}. Export it anew") from error
    if not triangles:
        raise InputError(f"{path} holds no solid. Export one closed body in mm")
    return trimesh.Trimesh([point.toTuple() for point in points], triangles)


def _repaired(surface: trimesh.Trimesh, path: Path) -> trimesh.Trimesh:
    """Merged, holes filled, turned outwards; tells what it did."""
    import trimesh

    surface.merge_vertices()
    surface.update_faces(surface.nondegenerate_faces() & surface.unique_faces())
    done = []
    if not surface.is_watertight:
        before = len(surface.faces)
        trimesh.repair.fill_holes(surface)
        done.append(f"closed small holes with {len(surface.faces) - before} triangles")
    if not surface.is_winding_consistent or surface.volume < 0:
        trimesh.repair.fix_normals(surface)
        done.append("turned triangles outwards")
    if not surface.is_watertight:
        edges = trimesh.grouping.group_rows(surface.edges_sorted, require_count=1)
        raise InputError(
            f"the surface in {path} is open: {len(edges)} edges have a triangle on one side only. Close "
            "it in the program that made it"
        )
    if surface.body_count != 1:
        raise InputError(
            f"{path} holds {surface.body_count} separate surfaces. Export one closed body without holes "
            "inside"
        )
    if done:
        warnings.warn(f"{path}: {' and '.join(done)}", stacklevel=2)
    return surface


def _require_simple(surface: trimesh.Trimesh, path: Path) -> None:
    """Refuse a surface that overlaps itself: parts of its volume then count twice."""
    import pyvista

    points = np.random.default_rng(1).uniform(surface.bounds[0], surface.bounds[1], (_SAMPLES, 3))
    polydata = pyvista.PolyData.from_regular_faces(surface.vertices, surface.faces)
    cloud = pyvista.PolyData(points).compute_implicit_distance(polydata)
    inside = float(np.mean(np.asarray(cloud["implicit_distance"]) < 0))
    volume = inside * float(np.prod(surface.extents))
    if abs(volume / surface.volume - 1) > _OVERLAP:
        raise InputError(
            f"the surface in {path} crosses itself: it encloses {volume:.4g} mm³, while its triangles "
            f"add up to {surface.volume:.4g}. Unite its pieces in the program that made it"
        )

"""Bodies from files: read, repaired where that is safe, or refused with the reason."""

from __future__ import annotations

import hashlib
import warnings
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from jaxtyping import Bool, Float

from design.body.foreign import read_foreign_surface
from design.errors import InputError
from design.files import require_regular_file

if TYPE_CHECKING:
    import trimesh

_PIERCED_MM = 0.1
"""Depth to which one triangle may stand through another: less is lost in the body's own triangles."""
_WELD_MM = 1e-3
"""Corners that are closer are one where a surface does not close: less than any printer or mould shows,
and more than STL's single precision loses on bodies of a metre (6e-5 mm)."""
_WIDEST_HOLE = 0.5
"""Widest hole that is closed, as a share of the box's shortest edge: what a table hides of a thing on it."""
_FEWEST_CORNERS, _RAGGED = 1000, 0.05
"""Corners from which on a surface may be a scan, which is drawn again where it crosses itself, up to that
share of its shortest edge."""
_GRID_POINTS, _REDRAWN_MM = 250_000, 0.05
"""Points of the grid on which it is drawn, as castable bodies, and tolerance of its triangles."""
_NOTHING = 1e-9
"""Share of the box's volume, below which a piece encloses nothing."""
_CRUMB = 0.01
"""Share of the largest piece's volume, below which a piece apart from it, or a void in it, is no body."""


def body_of_file(path: Path, scale: float = 1.0) -> dict[str, Any]:
    """Return what `[body]` takes from a file: its path and the size of its box.

    A unit of the file is `scale` mm long; STEP files are read in mm whatever they are drawn in.

    Raises
    ------
    InputError
        A file that is missing, not a solid, open, in several pieces or crossing itself.
    """
    size = [round(float(edge), 6) for edge in _surface_in(path, scale).extents]
    return {"file": str(path.resolve()), "size_mm": size}


def read_surface(file: str | None, scale: float = 1.0) -> trimesh.Trimesh:
    """The surface in a file, its box centred on the origin.

    Raises
    ------
    InputError
        As `body_of_file`, or no file is given.
    """
    if file is None:
        raise InputError("body.kind = 'imported' needs body.file. Name an STL or STEP file")
    return _surface_in(Path(file), scale).copy()


def file_digest(file: str | None) -> str | None:
    """SHA-256 (hex) of the file that a body comes from, if any."""
    return None if file is None else _digest(Path(file))


def _digest(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()


def _surface_in(path: Path, scale: float) -> trimesh.Trimesh:
    require_regular_file(path, _missing(path))
    return _closed_surface(path.resolve(), _digest(path), scale)


@lru_cache(maxsize=4)
def _closed_surface(path: Path, digest: str, scale: float) -> trimesh.Trimesh:
    """The file's surface, kept while its content is the same."""
    surface = _read_unchanged(path, digest).copy()
    surface.apply_scale(scale)
    surface = _repaired(surface, path)
    surface.apply_translation(-surface.bounds.mean(axis=0))
    crossing = _deepest_crossing(surface)
    if crossing is None:
        return surface
    deep_mm, place = crossing
    if len(surface.vertices) < _FEWEST_CORNERS or deep_mm > _RAGGED * min(surface.extents):
        raise InputError(
            f"the surface in {path} crosses itself, {deep_mm:.2g} mm deep at "
            f"({', '.join(f'{x:.3g}' for x in place)}) mm from its middle. Unite its pieces in the program "
            "that made it"
        )
    surface, step_mm = _redrawn(surface)
    warnings.warn(
        f"{path}: drawn again on a grid of {step_mm:.2g} mm, as it crosses itself {deep_mm:.2g} mm deep",
        stacklevel=2,
    )
    return surface


@lru_cache(maxsize=4)
def _read_unchanged(path: Path, digest: str) -> trimesh.Trimesh:
    """The file's triangles as they stand there, for all scales."""
    import trimesh

    surface = read_foreign_surface(path, _missing(path))
    if not np.isfinite(surface.vertices_mm).all():
        raise InputError(
            f"the surface in {path} is open: it has corners that are no numbers. Export it anew"
        )
    return trimesh.Trimesh(surface.vertices_mm, surface.triangles)


def _missing(path: Path) -> str:
    return f"no body at {path}. Name an STL or STEP file by --from, or in body.file"


def _repaired(surface: trimesh.Trimesh, path: Path) -> trimesh.Trimesh:
    """Merge, weld, fill holes, turn outwards and unite overlapping pieces; warn of what was done."""
    import trimesh

    surface.merge_vertices()
    surface.update_faces(_has_three_corners(surface))
    done = []
    if not surface.is_watertight:
        surface.update_faces(surface.unique_faces())
        done += _weld(surface)
    if not surface.is_watertight:
        unfilled = surface.copy()
        done += _fill_holes(surface)
        # each triangle of a soup gets one more on its back, and both enclose nothing
        if not surface.is_watertight or not _solid_pieces(surface):
            _require_closed(unfilled, path)
    if not surface.is_winding_consistent or surface.volume < 0:
        trimesh.repair.fix_normals(surface)
        done.append("turned triangles outwards")
    surface = _without_flat_triangles(surface)
    if surface.body_count > 1:
        count = len(_solid_pieces(surface))
        flat = surface.body_count - count
        done += [f"left out {flat} flat pieces, which enclose nothing"] if flat else []
        surface, crumbs = united_surface(surface, path)
        largest_mm = max((float(max(crumb.extents)) for crumb in crumbs), default=0.0)
        done += [f"left out {len(crumbs)} crumbs of up to {largest_mm:.2g} mm"] if crumbs else []
        united = count - len(crumbs)
        done += [f"united {united} pieces that overlap"] if united > 1 else []
    if done:
        warnings.warn(f"{path}: {' and '.join(done)}", stacklevel=2)
    return surface


def _has_three_corners(surface: trimesh.Trimesh) -> Bool[np.ndarray, "face"]:
    """Return which triangles have three different corners; others close nothing."""
    steps = np.diff(np.sort(surface.faces, axis=1), axis=1)
    return np.logical_and(steps[:, 0] > 0, steps[:, 1] > 0)


def _weld(surface: trimesh.Trimesh) -> list[str]:
    """Join corners within `_WELD_MM` of each other, in place; return in words how many were moved."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components
    from scipy.spatial import KDTree

    corners = np.asarray(surface.vertices)
    if not np.isfinite(corners).all():
        return []
    pairs = KDTree(corners).query_pairs(_WELD_MM, output_type="ndarray")
    if not len(pairs):
        return []
    near = coo_array((np.ones(len(pairs)), pairs.T), shape=(len(corners),) * 2)
    _, group = connected_components(near, directed=False)
    _, first = np.unique(group, return_index=True)
    surface.vertices = corners[first][group]
    surface.merge_vertices()
    surface.update_faces(_has_three_corners(surface))
    surface.update_faces(surface.unique_faces())
    return [f"welded {len(corners) - len(first)} corners within {_WELD_MM:g} mm of others"]


def _fill_holes(surface: trimesh.Trimesh) -> list[str]:
    """Close holes up to `_WIDEST_HOLE` wide, in place; return in words by how many triangles, how wide."""
    import pyvista
    import trimesh

    faces_open = len(surface.faces)
    # a hole is as large as the sphere round its box: half the diagonal, w/√2 of one w wide
    largest_mm = _WIDEST_HOLE * min(surface.extents) / 2**0.5
    closed = pyvista.PolyData.from_regular_faces(surface.vertices, surface.faces)
    # of a ragged border VTK may leave a smaller hole, which is closed likewise
    count = -1
    while closed.n_cells != count:
        count, closed = closed.n_cells, closed.fill_holes(largest_mm)
    faces = closed.faces.reshape(-1, 4)[:, 1:]
    if count == faces_open:
        return []
    surface.vertices, surface.faces = np.asarray(closed.points, float), faces
    trimesh.repair.fix_winding(surface)
    sides = np.diff(
        surface.triangles[faces_open:], axis=1, append=surface.triangles[faces_open:, :1]
    )
    widest_mm = np.linalg.norm(sides, axis=2).max()
    return [
        f"closed small holes with {len(faces) - faces_open} triangles, up to {widest_mm:.2g} mm wide"
    ]


def _without_flat_triangles(surface: trimesh.Trimesh) -> trimesh.Trimesh:
    """A closed surface without triangles of no height, which have no normal, and closed again.

    Such a triangle closes the side of a wide one at a corner in its middle: left out, it leaves a slit.
    """
    if surface.nondegenerate_faces().all():
        return surface
    from design.body.meshes import simplified

    closed = simplified(surface, _WELD_MM)
    # nothing is left of a surface that crosses itself, which Manifold does not take
    return closed if len(closed.faces) else surface


def _require_closed(surface: trimesh.Trimesh, path: Path) -> None:
    if surface.is_watertight:
        return
    _, count = np.unique(surface.edges_sorted, axis=0, return_counts=True)
    single, many = int((count == 1).sum()), int((count > 2).sum())
    meet = f"{many} edges have more than two triangles"
    if single:
        raise InputError(
            f"the surface in {path} is open: {single} edges have a triangle on one side only, "
            f"{meet.replace(' have', '')}; corners within {_WELD_MM:g} mm count as one. Close it in the "
            "program that made it"
        )
    raise InputError(
        f"the surface in {path} is closed, but meets itself: {meet}, as where two bodies touch along an "
        "edge or a sheet divides the inside. Unite the bodies, or move them apart, in the program that "
        "made it"
    )


def united_surface(
    surface: trimesh.Trimesh, path: Path
) -> tuple[trimesh.Trimesh, list[trimesh.Trimesh]]:
    """Return the union of pieces that overlap, and crumbs that are left out: pieces of no size apart from
    it, and voids of none in it. Flat pieces, which enclose nothing, are left out as well.

    Raises
    ------
    InputError
        Pieces apart from each other, or voids inside.
    """
    from design.body.meshes import boolean_of, signed_mm3

    larger, small = _parted_by_size(_solid_pieces(surface))
    voids = [piece for piece in small if signed_mm3(piece) < 0]
    solid = larger + [piece for piece in small if signed_mm3(piece) > 0]
    whole = all(signed_mm3(piece) > 0 for piece in solid)
    pieces = _solid_pieces(boolean_of("union", solid)) if solid and whole else solid
    whole_pieces, crumbs = _parted_by_size(pieces)
    if len(whole_pieces) != 1:
        raise InputError(
            f"{path} holds {len(pieces)} separate surfaces. Export one closed body without holes inside"
        )
    return whole_pieces[0], voids + crumbs


def _parted_by_size(
    pieces: list[trimesh.Trimesh],
) -> tuple[list[trimesh.Trimesh], list[trimesh.Trimesh]]:
    """Return pieces that count, and crumbs."""
    from design.body.meshes import signed_mm3

    volumes = [abs(signed_mm3(piece)) for piece in pieces]
    least = _CRUMB * max(volumes, default=0.0)
    counted = [piece for piece, mm3 in zip(pieces, volumes, strict=True) if mm3 >= least]
    return counted, [piece for piece, mm3 in zip(pieces, volumes, strict=True) if mm3 < least]


def _solid_pieces(surface: trimesh.Trimesh) -> list[trimesh.Trimesh]:
    """Separate pieces that enclose something, voids too."""
    from design.body.meshes import signed_mm3

    nothing = _NOTHING * float(np.prod(surface.extents))
    pieces = surface.split(only_watertight=False)
    return [piece for piece in pieces if abs(signed_mm3(piece)) > nothing]


def _deepest_crossing(
    surface: trimesh.Trimesh,
) -> tuple[float, Float[np.ndarray, "3"]] | None:
    """Return how deep a surface crosses itself (mm) at most, and where; None of a simple one.

    One of its edges then runs through a triangle.
    """
    from design.body.meshes import manifold_of

    solid, corners = manifold_of(surface), np.asarray(surface.vertices)
    deepest, deepest_at = _PIERCED_MM, None
    for start, end in corners[surface.edges_unique]:
        for hit in solid.ray_cast(tuple(start), tuple(end)):
            place, normal = np.asarray(hit.position), np.asarray(hit.normal)
            beyond = min(abs((start - place) @ normal), abs((end - place) @ normal))
            if beyond > deepest:
                deepest, deepest_at = float(beyond), place
    return None if deepest_at is None else (deepest, deepest_at)


def _redrawn(surface: trimesh.Trimesh) -> tuple[trimesh.Trimesh, float]:
    """Return a surface drawn again where the signed distance to it is 0, its largest piece, and the grid's
    step (mm).

    What is inside is counted along lines: next to a fold, the nearest triangle does not show it.
    """
    import pyvista

    from design.body.meshes import signed_mm3, simplified
    from design.body.sampled import contour_of, grid_points, measured_where_near

    step = (float(np.prod(surface.extents)) / _GRID_POINTS) ** (1 / 3)
    points, count = grid_points(surface.extents / 2, step)
    grid = pyvista.ImageData(dimensions=count, spacing=(step,) * 3, origin=tuple(points[0]))
    closed = pyvista.PolyData.from_regular_faces(surface.vertices, surface.faces)
    mask = closed.voxelize_binary_mask(reference_volume=grid)["mask"]
    inside = np.asarray(mask, bool).reshape(count, order="F")
    distance = abs(measured_where_near(surface, points, count, step, mirrored=False))
    distance = np.where(inside, -distance, distance)
    drawn = max(contour_of(distance, points[0], step).split(only_watertight=True), key=signed_mm3)
    drawn = simplified(drawn, _REDRAWN_MM)
    drawn.apply_translation(-drawn.bounds.mean(axis=0))
    return drawn, step

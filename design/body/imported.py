"""Bodies from files: read, repaired where that is safe, or refused with the reason."""

from __future__ import annotations

import hashlib
import warnings
from dataclasses import dataclass, field
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

_MENDED_MM = 100.0
"""Length to which a file's surface is brought, by a power of ten, before it is mended: what is done to it is
then the same at every scale. Millimetres of the constants below are those of that surface."""
_PIERCED_MM = 0.1
"""Depth to which one triangle may stand through another: less is lost in the body's own triangles."""
_WELD_MM = 1e-3
"""Corners that are closer are one where a surface does not close: less than any printer or mould shows,
and more than STL's single precision loses on bodies of a metre (6e-5 mm)."""
_WIDEST_HOLE = 0.5
"""Widest hole that is closed, as a share of the box's shortest edge: what a table hides of a thing on it."""
FEWEST_CORNERS = 1000
"""A file of fewer corners is drawn, not scanned."""
GRID_POINTS = 250_000
"""Points of the grid over a scan's box on which distances are measured: 1.2 mm apart in a soup can's."""
MERGED_MM = 0.05
"""Tolerance within which a scan's triangles are merged: less than a printed layer."""
_RAGGED = 0.05
"""Depth, over the shortest edge, up to which a scan that crosses itself is drawn again."""
_MOST_SHRUNK = 3.0
"""Steps of that grid by which a side of the box may move: edges lose one, a lost limb more."""
_COMPARED = 5000
"""Corners of a surface, at most, at which its distance to another is measured."""
_NOTHING = 1e-9
"""Share of the box's volume, below which a piece encloses nothing."""
_CRUMB, _CRUMB_LONG = 0.01, 0.1
"""Share of the largest piece's volume, below which all pieces apart from it, or voids in it, are no body, and
share of its longest edge, up to which each is none: a thin plate has little volume, but is a part."""


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
    """SHA-256 (hex) of the file that a body comes from; None where there is none."""
    return _digest(Path(file)) if file is not None and Path(file).is_file() else None


def _digest(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()


@dataclass(frozen=True)
class _Source:
    """A file's content; its surface is one for all scales, and words of it are in the first one's mm."""

    path: Path
    digest: str
    scale: float = field(compare=False)


def _surface_in(path: Path, scale: float) -> trimesh.Trimesh:
    require_regular_file(path, _missing(path))
    surface = _closed_surface(_Source(path.resolve(), _digest(path), scale)).copy()
    surface.apply_scale(scale)
    return surface


@lru_cache(maxsize=4)
def _closed_surface(source: _Source) -> trimesh.Trimesh:
    """The file's surface in the file's own unit, mended at one size for all scales."""
    surface, path = _read_unchanged(source.path), source.path
    longest = float(np.ptp(surface.vertices, axis=0).max())
    size = 10.0 ** np.round(np.log10(_MENDED_MM / longest)) if longest > 0 else 1.0
    mm = source.scale / size  # of the body, for each of the surface that is mended
    surface.apply_scale(size)
    surface = _repaired(surface, path, mm)
    surface.apply_translation(-surface.bounds.mean(axis=0))
    crossing = _deepest_crossing(surface)
    if crossing is not None:
        deep_mm, place = crossing
        crosses = f"crosses itself {mm * deep_mm:.2g} mm deep"
        if len(surface.vertices) < FEWEST_CORNERS or deep_mm > _RAGGED * min(surface.extents):
            raise InputError(
                f"the surface in {path} {crosses} at ({', '.join(f'{mm * x:.3g}' for x in place)}) mm "
                "from its middle. Unite its pieces in the program that made it"
            )
        surface, step_mm, change = _redrawn(surface, f"the surface in {path} {crosses}", mm)
        warnings.warn(
            f"{path}: drawn again on a grid of {mm * step_mm:.2g} mm, as it {crosses}; {change}",
            stacklevel=2,
        )
    surface.apply_scale(1 / size)
    return surface


def _read_unchanged(path: Path) -> trimesh.Trimesh:
    """The file's triangles as they stand there."""
    import trimesh

    surface = read_foreign_surface(path, _missing(path))
    if not np.isfinite(surface.vertices_mm).all():
        raise InputError(
            f"the surface in {path} is open: it has corners that are no numbers. Export it again"
        )
    return trimesh.Trimesh(surface.vertices_mm, surface.triangles)


def _missing(path: Path) -> str:
    return f"no body at {path}. Name an STL or STEP file by --from, or in body.file"


def _repaired(surface: trimesh.Trimesh, path: Path, mm: float) -> trimesh.Trimesh:
    """Merge, weld, fill holes, turn outwards and unite overlapping pieces; warn of what was done.

    A unit of the surface is `mm` long in the warnings, here and below.
    """
    import trimesh

    from design.body.meshes import signed_mm3

    surface.merge_vertices()
    surface.update_faces(_has_three_corners(surface))
    done = []
    if not surface.is_watertight:
        surface.update_faces(surface.unique_faces())
        done += _weld(surface, mm)
    if not surface.is_watertight:
        unfilled = surface.copy()
        done += _fill_holes(surface, mm)
        # each triangle of a soup gets one more on its back, and both enclose nothing
        if not surface.is_watertight or abs(signed_mm3(surface)) <= _nothing_mm3(surface):
            _require_closed(unfilled, path, mm)
    if not surface.is_winding_consistent or surface.volume < 0:
        trimesh.repair.fix_normals(surface)
        done.append("turned triangles outwards")
    surface = _without_flat_triangles(surface)
    if surface.body_count > 1:
        surface, changes = united_surface(surface, path, mm)
        done += changes
    if done:
        warnings.warn(f"{path}: {' and '.join(done)}", stacklevel=2)
    return surface


def _has_three_corners(surface: trimesh.Trimesh) -> Bool[np.ndarray, "face"]:
    """Return which triangles have three different corners; others close nothing."""
    steps = np.diff(np.sort(surface.faces, axis=1), axis=1)
    return np.logical_and(steps[:, 0] > 0, steps[:, 1] > 0)


def _weld(surface: trimesh.Trimesh, mm: float) -> list[str]:
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
    return [f"welded {len(corners) - len(first)} corners within {mm * _WELD_MM:.2g} mm of others"]


def _fill_holes(surface: trimesh.Trimesh, mm: float) -> list[str]:
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
    count = len(faces) - faces_open
    return [f"closed small holes with {count} triangles, up to {mm * widest_mm:.2g} mm wide"]


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


def _require_closed(surface: trimesh.Trimesh, path: Path, mm: float) -> None:
    if surface.is_watertight:
        return
    _, count = np.unique(surface.edges_sorted, axis=0, return_counts=True)
    single, many = int((count == 1).sum()), int((count > 2).sum())
    meet = f"{many} edges have more than two triangles"
    if single:
        raise InputError(
            f"the surface in {path} is open: {single} edges have a triangle on one side only, "
            f"{meet.replace(' have', '')}; corners within {mm * _WELD_MM:.2g} mm count as one. Close it in "
            "the program that made it"
        )
    raise InputError(
        f"the surface in {path} is closed, but meets itself: {meet}, as where two bodies touch along an "
        "edge or a sheet divides the inside. Unite the bodies, or move them apart, in the program that "
        "made it"
    )


def united_surface(
    surface: trimesh.Trimesh, path: Path, mm: float = 1.0
) -> tuple[trimesh.Trimesh, list[str]]:
    """Return the union of pieces that overlap, without crumbs and flat pieces, small voids filled, and in
    words what was done.

    Raises
    ------
    InputError
        Pieces apart from each other, or voids inside.
    """
    from design.body.meshes import boolean_of, signed_mm3

    pieces = _solid_pieces(surface)
    flat = surface.body_count - len(pieces)
    larger, small = _parted_by_size(pieces)
    voids = [piece for piece in small if signed_mm3(piece) < 0]
    solid = larger + [piece for piece in small if signed_mm3(piece) > 0]
    whole = all(signed_mm3(piece) > 0 for piece in solid)
    parts = _solid_pieces(boolean_of("union", solid)) if solid and whole else solid
    counted, small = _parted_by_size(parts)
    if len(counted) != 1:
        raise InputError(
            f"{path} holds {len(counted)} separate surfaces. Export one closed body without holes inside"
        )
    crumbs = [piece for piece in small if signed_mm3(piece) > 0]
    voids += [piece for piece in small if signed_mm3(piece) < 0]
    united = len(solid) - len(crumbs)
    encloses = "encloses" if flat == 1 else "enclose"
    done = [f"left out {_counted(flat, 'flat piece')}, which {encloses} nothing"] if flat else []
    done += [f"left out {_pieces_text(crumbs, 'crumb', mm)}"] if crumbs else []
    done += [f"filled {_pieces_text(voids, 'void', mm)}"] if voids else []
    done += [f"united {united} pieces that overlap"] if united > 1 else []
    return counted[0], done


def _counted(count: int, name: str) -> str:
    return f"{count} {name}{'s' if count != 1 else ''}"


def _pieces_text(pieces: list[trimesh.Trimesh], name: str, mm: float) -> str:
    """Return the number of pieces and the longest edge of their boxes."""
    longest = max(float(max(piece.extents)) for piece in pieces)
    return f"{_counted(len(pieces), name)} of up to {mm * longest:.2g} mm"


def _parted_by_size(
    pieces: list[trimesh.Trimesh],
) -> tuple[list[trimesh.Trimesh], list[trimesh.Trimesh]]:
    """Return pieces that count, and crumbs."""
    from design.body.meshes import signed_mm3

    if not pieces:
        return [], []
    volumes = np.array([abs(signed_mm3(piece)) for piece in pieces])
    lengths = np.array([max(piece.extents) for piece in pieces])
    largest, rising = volumes.argmax(), volumes.argsort()
    crumb = lengths <= _CRUMB_LONG * lengths[largest]
    # the smallest first, as long as their sum is small
    crumb[rising] &= volumes[rising].cumsum() < _CRUMB * volumes[largest]
    counted = [piece for piece, small in zip(pieces, crumb, strict=True) if not small]
    return counted, [piece for piece, small in zip(pieces, crumb, strict=True) if small]


def _solid_pieces(surface: trimesh.Trimesh) -> list[trimesh.Trimesh]:
    """Separate pieces that enclose something, voids too."""
    from design.body.meshes import signed_mm3

    nothing = _nothing_mm3(surface)
    pieces = surface.split(only_watertight=False)
    return [piece for piece in pieces if abs(signed_mm3(piece)) > nothing]


def _nothing_mm3(surface: trimesh.Trimesh) -> float:
    return _NOTHING * float(np.prod(surface.extents))


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


def _redrawn(
    surface: trimesh.Trimesh, crosses: str, mm: float
) -> tuple[trimesh.Trimesh, float, str]:
    """Return a surface drawn again where the signed distance to it is 0, the grid's step, and in words how
    far off it lies.

    What is inside is counted along lines: next to a fold, the nearest triangle does not show it.

    Raises
    ------
    InputError
        The grid is too coarse: nothing is left, several pieces are, or a limb is lost; `crosses` begins it.
    """
    import pyvista

    from design.body.meshes import distance_mm, simplified
    from design.body.sampled import contour_of, measured_distance_mm, measured_on_grid

    distance, origin, step = measured_on_grid(surface, surface.extents, GRID_POINTS)
    grid = pyvista.ImageData(dimensions=distance.shape, spacing=(step,) * 3, origin=tuple(origin))
    closed = pyvista.PolyData.from_regular_faces(surface.vertices, surface.faces)
    mask = closed.voxelize_binary_mask(reference_volume=grid)["mask"]
    inside = np.asarray(mask, bool).reshape(distance.shape, order="F")
    contour = contour_of(np.where(inside, -1, 1) * abs(distance), origin, step)
    pieces, crumbs = _parted_by_size(_solid_pieces(contour) if len(contour.faces) else [])
    lost = f"{crosses}, and drawn again on a grid of {mm * step:.2g} mm"
    fix = "Unite its pieces in the program that made it, or make its thin parts thicker"
    if len(pieces) != 1 or not pieces[0].is_watertight:
        raise InputError(f"{lost} it is {_counted(len(pieces), 'piece')}, not one closed. {fix}")
    drawn = simplified(pieces[0], MERGED_MM)
    shrunk = float(abs(drawn.bounds - surface.bounds).max())
    if shrunk > _MOST_SHRUNK * step:
        raise InputError(f"{lost} its box loses {mm * shrunk:.2g} mm on a side. {fix}")
    # folds lie inside and are meant to go; what stands out is lost
    out_mm = measured_distance_mm(drawn, _some_corners(surface)).max()
    off_mm = max(float(out_mm), float(distance_mm(surface, _some_corners(drawn)).max()))
    change = f"it lies up to {mm * off_mm:.2g} mm off the file"
    change += f", without {_pieces_text(crumbs, 'piece', mm)}" if crumbs else ""
    drawn.apply_translation(-drawn.bounds.mean(axis=0))
    return drawn, step, change


def _some_corners(surface: trimesh.Trimesh) -> Float[np.ndarray, "corner 3"]:
    return np.asarray(surface.vertices)[:: -(-len(surface.vertices) // _COMPARED)]

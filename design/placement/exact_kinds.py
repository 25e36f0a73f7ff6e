"""Bodies from files that are, within a tolerance, one of the kinds with exact solids."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float

from design.body.castable import without_noise
from design.body.imported import read_surface
from design.body.kinds.registry import KINDS
from design.body.meshes import distance_mm

if TYPE_CHECKING:
    import trimesh

    from design.placement.objects import Request

TOLERANCE_MM = 0.3
"""Largest distance between a file's surface and an exact kind that stands for it: a layer and a half of a
print."""
_ENVELOPE_MM = 0.03
"""Distance by which triangles of an exact kind may leave it: a tenth of the tolerance."""
_CONVEX = 0.99
"""Share of its convex hull that a body fills which has no hollows."""
_DECIMALS = 1
"""Decimals of the sizes in mm."""
_SAMPLES, _FEW = 2000, 200
"""Points of an exact kind at which its distance to the file's surface is measured, besides its corners, and
corners of that surface that are measured first."""


@dataclass(frozen=True)
class ExactKind:
    """A kind of body and its size, and its largest distance to a surface, from either to the other."""

    kind: str
    size_mm: tuple[float, float, float]
    off_mm: float


def exact_kind(surface: trimesh.Trimesh) -> ExactKind | None:
    """Return the kind that a closed surface is within `TOLERANCE_MM`, however it is turned; None of others.

    Of the closed kinds those with the fewest measures come first. The axes are those of inertia, which noise
    hardly turns, or, as a cube's inertia has none, of the tightest box.
    """
    import trimesh

    thickness_mm = abs(surface.volume) / surface.area
    box_axes, _ = trimesh.bounds.oriented_bounds(surface.convex_hull)
    for axes in (surface.principal_inertia_transform, box_axes):
        turned = surface.copy()
        turned.apply_transform(axes)
        turned.apply_translation(-turned.bounds.mean(axis=0))
        for order, kind, size_mm in _kinds_in_a_box(turned.extents):
            exact = KINDS[kind](size_mm, 0.0, _ENVELOPE_MM).outer_surface()
            # surfaces this near to each other differ in volume by no more than that times the area
            if abs(exact.volume / surface.volume - 1) * thickness_mm > TOLERANCE_MM:
                continue
            # a turn or a mirror image, which closed kinds are of themselves
            exact.vertices = exact.vertices[:, np.argsort(order)]
            off_mm = _off_mm(exact, turned)
            if off_mm <= TOLERANCE_MM:
                return ExactKind(kind, size_mm, off_mm)
    return None


def exact_kind_in_words(request: Request) -> str:
    """Return which options take the exact kind in place of the request's file, whose hollows are filled;
    empty where none does."""
    file = dict(request.file)
    surface, _ = without_noise(read_surface(file["file"], file["scale"]))
    exact = exact_kind(surface.convex_hull)
    if exact is None:
        return ""
    hollow = "with its hollows filled " * bool(
        surface.volume < _CONVEX * surface.convex_hull.volume
    )
    size = " ".join(f"{edge:g}" for edge in exact.size_mm)
    return (
        f"{hollow}this body is a {exact.kind} within {max(exact.off_mm, 0.01):.2f} mm: `--kind "
        f"{exact.kind} --size {size}` instead of --from takes the exact kind"
    )


def _kinds_in_a_box(
    extents_mm: Float[np.ndarray, "3"],
) -> Iterator[tuple[list[int], str, tuple[float, float, float]]]:
    """Yield the axes that become x, y and z, a closed kind and its size: of one measure, of two, of three."""
    a, b, c = np.argsort(extents_mm).tolist()
    for order, alike in (([a, b, c], 3), ([a, b, c], 2), ([b, c, a], 2), ([a, b, c], 1)):
        edges = extents_mm[order]
        edges[:alike] = edges[:alike].mean()
        x, y, z = np.round(edges, _DECIMALS).tolist()
        for kind, body in KINDS.items():
            if not (body.from_file or body.on_base) and body.takes_size((x, y, z)):
                yield order, kind, (x, y, z)


def _off_mm(exact: trimesh.Trimesh, surface: trimesh.Trimesh) -> float:
    """Return the largest distance from the corners of either surface, and points between, to the other.

    Less where a few of the corners are too far off already.
    """
    import trimesh

    corners = np.asarray(surface.vertices)
    few_mm = distance_mm(exact, corners[:: len(corners) // _FEW + 1]).max()
    if few_mm > TOLERANCE_MM:
        return float(few_mm)
    between = trimesh.sample.sample_surface(exact, _SAMPLES, seed=0)[0]
    to_surface = distance_mm(surface, np.concatenate([between, exact.vertices]))
    return float(max(to_surface.max(), distance_mm(exact, corners).max()))

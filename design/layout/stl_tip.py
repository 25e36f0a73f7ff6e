"""Corners of a convex indenter from an STL file."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from design.body.foreign import read_foreign_surface
from design.errors import InputError

if TYPE_CHECKING:
    from trimesh import Trimesh

_CONVEX_TO = 1e-3
"""Share of its volume by which a tip's hull may exceed it; more, and it is not convex."""
_MOST_CORNERS = 5000
"""Corners of a tip's hull, at most."""


def stl_tip_vertices_mm(path: Path) -> tuple[tuple[float, float, float], ...]:
    """Corners of the convex hull of a watertight, convex body (mm, to 1e-6).

    Raises
    ------
    InputError
        The file cannot be read, is no closed surface, is not convex to 0.1 % of its volume, or has
        more than 5000 corners.
    """
    body = read_stl_tip(path)
    if not body.is_watertight or body.volume <= 0:
        raise InputError(
            f"indenter.vertices_mm {path}: the surface is not closed with its normals outward. Fix the STL"
        )
    hull = body.convex_hull
    if hull.volume > (1 + _CONVEX_TO) * body.volume:
        raise InputError(
            f"indenter.vertices_mm {path}: the body is not convex (it fills {body.volume / hull.volume:.1%} "
            "of its hull). Use a convex tip, or indenter.tip_count for several"
        )
    if len(hull.vertices) > _MOST_CORNERS:
        raise InputError(
            f"indenter.vertices_mm {path} has {len(hull.vertices)} corners, more than {_MOST_CORNERS}. "
            "Export it coarser"
        )
    return tuple((x, y, z) for x, y, z in hull.vertices.round(6).tolist())


def read_stl_tip(path: Path) -> Trimesh:
    from trimesh import Trimesh

    missing = f"no indenter.vertices_mm at {path}. Give the path from the specification's folder"
    surface = read_foreign_surface(path, missing)
    return Trimesh(surface.vertices_mm, surface.triangles)

"""The body for the page: its skin with the faces that the map lies on, its core, contact locations."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import trimesh
from jaxtyping import Bool, Float, Int
from trimesh.remesh import subdivide_to_size

from design.body.surface_chart import FaceFrame
from design.catalogue.hall_sensors import HALL_PARTS
from design.catalogue.magnets import GRADES
from design.catalogue.silicones import SILICONES
from design.layout.body import body_of, face_frames
from design.layout.places.contact_grid import PlaceGrid
from design.search.space import reaches_that_fit_mm
from design.spec.object import ObjectSpec
from instobj.explore.design import design_of
from instobj.explore.engine import Explorer
from instobj.viewer.archive import Stepped, pack
from instobj.viewer.scene import Arrays, add_surface, face_content
from instobj.viewer.surface import Shaded, shaded, shaded_part

_READ = (
    "A press is read by the chips of its face, after a fresh zero. Where the object is turned and warmed "
    "since, the other faces' chips say how far, unless score.channels is 'own'; figures of comparison are "
    "of one that stands still. The whole is computed by instobj run."
)
ACCURACY = (
    "Quick model: stiff magnets on stored presses of the shell without magnets. For 34 layouts of "
    "the paper's cube the next level gave 0.94 to 1.22 times its median and 0.87 to 1.67 times its "
    f"worst value; single locations scattered by 13 %. Other bodies were not compared so. {_READ}"
)
"""Text on the page about its level: docs/measured/layout_search.md, fidelity levels."""
COARSE_LEVEL = "A first look: whole chains had 0.6 to 2.4 times its median."
"""Line under the numbers of a shell whose mechanics is not there yet."""
COARSE_ACCURACY = (
    "First look: the shell as a layer by a closed form, without a mesh, at few places. Whole chains of "
    "eleven bodies had 0.6 to 2.4 times its median and 0.3 to 1.9 times its 95th percentile; the few places "
    f"change the median by up to a third. {_READ}"
)
"""The same of a shell whose mechanics is not there yet: docs/measured/bodies.md."""
_BENT = 0.1
"""Longest edge of the skin's triangles, as a share of the body's longest: a press bends several of them."""


def explorer_scene(explorer: Explorer, name: str) -> bytes:
    """Return the archive that the page fetches; answers with another `name` need another one."""
    spec, body, grid = explorer.spec, body_of(explorer.spec), explorer.grid
    arrays: Arrays = {}
    core, faces = body.core_surface(), face_frames(spec)
    skin = _bendable(body.outer_surface(), _BENT * max(spec.body.size_mm))
    add_surface(arrays, "silicone", skin)
    if core is not None:
        add_surface(arrays, "core", shaded_part(core))
    locations = [explorer.presses[face.number][0][0].on_face for face in faces]
    on_face = [
        _mapped_vertices(*each, grid, skin.points_mm) for each in zip(faces, locations, strict=True)
    ]
    arrays["link_vertex"] = np.concatenate(on_face).astype("<u4")
    arrays["link_source"] = np.repeat(
        range(len(faces)), [len(vertices) for vertices in on_face]
    ).astype("<u4")
    xy = grid.xy_mm
    arrays["place_xy_mm"] = Stepped(xy.astype("<f4"))
    surface = [
        face.to_object(np.column_stack([face.to_plane(xy), np.zeros(len(xy))])) for face in faces
    ]
    arrays["place_mm"] = Stepped(np.stack(surface).astype("<f4"))
    arrays["there"] = np.stack(locations).astype("<u1")
    content: dict[str, Any] = {
        "name": spec.name,
        "scene": name,
        "thickness_mm": spec.shell.thickness_mm,
        "size_mm": list(spec.body.size_mm),
        "faces": [face_content(face) for face in faces],
        "room_mm": _room_mm(spec, faces),
        "face_vertices": [1] * len(faces),
        "grid": {"x_mm": grid.x_mm.tolist(), "y_mm": grid.y_mm.tolist()},
        "magnets_in_shell": spec.arrangement == "sensors-in-core",
        "tiltable": all(face.flat for face in faces) and spec.arrangement == "sensors-in-core",
        "forces_n": list(explorer.forces_n),
        "first_force_n": explorer.first_force_n,
        "limits": {
            "position": spec.limits.position_bound_mm,
            "least": spec.limits.detectable_force_n,
        },
        "chips": _ranges_by_chip(spec),
        "grades": list(GRADES),
        "as_written": ", ".join(dict.fromkeys(spec.magnets.kinds)),
        "design": design_of(spec),
        "level": COARSE_LEVEL if explorer.coarse else "",
        "accuracy": COARSE_ACCURACY if explorer.coarse else ACCURACY,
        "silicones": sorted({spec.silicone.name, *SILICONES}),
        "sizable": not body.from_file,
    }
    return pack(content, arrays)


def _ranges_by_chip(spec: ObjectSpec) -> dict[str, list[float]]:
    """Return the ranges (mT) of the specification's own chip and of those whose noise is known."""
    parts = {spec.sensors.part: HALL_PARTS.named(spec.sensors.part)} | HALL_PARTS
    return {
        name: [entry.range_mt for entry in part.ranges]
        for name, part in parts.items()
        if name == spec.sensors.part or (part.ranges and part.noise is not None)
    }


def _room_mm(spec: ObjectSpec, faces: Sequence[FaceFrame]) -> dict[str, list[list[float]]]:
    """Return how far hands may drag magnets and chips from the middle of every face, along x and y: as far
    from its border as a search takes them on the longest one."""
    halves = np.array([face.half_extents_mm for face in faces])
    reaches, core = reaches_that_fit_mm(spec), spec.core
    # A recess turns with its place: askew its corner reaches farther than the search's straight one.
    length = core.recess_outer_radius_mm - spec.sensors.radius_mm
    askew = {"magnet": 0.0, "sensor": np.hypot(length, core.recess_width_mm / 2) - length}
    return {
        part: np.maximum(
            halves - halves.max() + reaches[f"{part}_reach_mm"] - askew[part], 0.0
        ).tolist()
        for part in askew
    }


def _bendable(mesh: trimesh.Trimesh, edge_mm: float) -> Shaded:
    """Return the skin with edges that are short enough to be drawn bent."""
    few = shaded_part(mesh)
    points, triangles, *_ = subdivide_to_size(few.points_mm, few.triangles, edge_mm)
    fine = trimesh.Trimesh(points, triangles)
    fine.merge_vertices()
    return shaded(np.asarray(fine.vertices), np.asarray(fine.faces))


def _mapped_vertices(
    face: FaceFrame,
    locations: Bool[np.ndarray, "place"],
    grid: PlaceGrid,
    points_mm: Float[np.ndarray, "vertex 3"],
) -> Int[np.ndarray, "own"]:
    """Return vertices that may carry a face's map: the page keeps the ones that look the face's way.

    On a curved body patches overlap, so those far from every location of the face are left to others.
    """
    plane = face.plane_coordinates(points_mm)[:, :2]
    covered = np.flatnonzero(face.covers(plane))
    if face.flat:
        return covered
    away = face.from_plane(plane[covered])[:, None] - grid.xy_mm[locations]
    # One and a half pitches: what triangles of the skin reach beyond the outermost locations.
    reach = 1.5 * max(np.ptp(grid.x_mm) / max(1, len(grid.x_mm) - 1), 0.1)
    return covered[np.linalg.norm(away, axis=2).min(axis=1) <= reach]

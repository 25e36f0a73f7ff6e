"""Maker of the scene that the page shows: the object, its presses and its maps.

Heavy imports stay inside.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from jaxtyping import Float

from design.files import atomic_path
from design.spec.object import ObjectSpec
from instobj.store.readers import (
    DISCRETISATION,
    MESH,
    PRESSES,
    RESPONSE,
    SCENE,
    SCORES,
    SIGNALS,
    STILL,
)
from instobj.store.stage import StageContext

if TYPE_CHECKING:
    from estimator.signals.presses import Signals
    from instobj.viewer.scene import Arrays

_SHARES_OF_DEEPEST = (0.25, 0.625, 1.0)
"""Depths whose shapes are stored. Between them, shapes per newton are interpolated: on the paper's
cube within 0.22 mm of the shape anywhere, 0.4 % of the depth (rms): docs/measured/view.md."""


def make_scene(context: StageContext, folder: Path) -> None:
    """The archive that the page reads, and a still picture for paper and for browsers without WebGL."""
    from design.layout.places.contact_grid import contact_grid
    from instobj.render.still import draw_still
    from instobj.viewer.archive import pack
    from instobj.viewer.scene import object_scene

    spec, build = context.spec, context.inputs["build"]
    context.step("triangles of the object and its mould")
    content, arrays = object_scene(spec, build)
    signals = context.read(SIGNALS)
    steps = shown_steps(signals.depth_mm)
    content["face_vertices"] = _add_silicone(context, arrays, signals.depth_mm[steps])
    context.step("signals and magnet motions")
    content["press"] = _add_presses(context, arrays, signals, steps)
    content["maps"] = _add_maps(context, arrays, signals)
    grid = contact_grid(spec)
    content["grid"] = {"x_mm": grid.x_mm.tolist(), "y_mm": grid.y_mm.tolist()}
    with atomic_path(SCENE.path(folder)) as temporary:
        temporary.write_bytes(pack(content, arrays))
    context.step("a still picture")
    draw_still(spec, build, STILL.path(folder))


def shown_steps(depth_mm: Float[np.ndarray, "step"]) -> list[int]:
    """Steps nearest to a quarter, five eighths and all of the deepest press."""
    wanted = depth_mm[-1] * np.array(_SHARES_OF_DEEPEST)
    return sorted({int(abs(depth_mm - depth).argmin()) for depth in wanted})


def _places_mm(spec: ObjectSpec) -> Float[np.ndarray, "place 2"]:
    """Contact locations of the grid; a face may have some of them only."""
    from design.layout.places.contact_grid import contact_grid

    return contact_grid(spec).xy_mm


def _add_silicone(
    context: StageContext, arrays: Arrays, depths_mm: Float[np.ndarray, "step"]
) -> list[int]:
    """The silicone's surface, and how far presses move it inwards, as shares of their depths.

    Returns the number of vertices of each face.

    `shape` (face, step, vertex of the faces, place); `link` says which vertex of the picture moves
    with which vertex of the faces, and along which vector per millimetre.
    """
    from design.layout.places.contact_places import contact_places
    from fem.presses.surface_motion import inward_motion_mm, mesh_vertices
    from instobj.viewer.archive import stepped
    from instobj.viewer.scene import add_surface
    from instobj.viewer.surface import boundary_triangles, links_of, shaded

    spec, mesh, response = context.spec, context.read(MESH), context.read(RESPONSE)
    surface = shaded(mesh.points_mm, boundary_triangles(mesh.points_mm, mesh.tets))
    add_surface(arrays, "silicone", surface)
    vertices, normals = mesh_vertices(spec, response, mesh.points_mm)
    links = links_of(surface.source, vertices, normals)
    arrays["link_vertex"] = links.picture.astype("<u4")
    arrays["link_source"] = links.face.astype("<u4")
    arrays["link_mm"] = stepped(links.vector, "i1")
    shapes, xy = [], _places_mm(spec)
    of_faces = sum(len(face.xy_mm) for face in response.surfaces)
    for index, (face, has_place) in enumerate(
        zip(response.surfaces, contact_places(spec), strict=True)
    ):
        context.step(f"shapes of presses on face {face.number}")
        motion = np.full((len(xy), len(depths_mm), of_faces), np.nan)
        motion[has_place] = inward_motion_mm(spec, response, index, xy[has_place], depths_mm)
        shapes.append(np.moveaxis(motion / depths_mm[:, None], 0, 2))
    arrays["shape"] = stepped(np.stack(shapes), "i1")
    return [len(face.xy_mm) for face in response.surfaces]


def _add_presses(
    context: StageContext, arrays: Arrays, signals: Signals, steps: list[int]
) -> dict[str, Any]:
    """Places, forces, signals and motions of the table's presses."""
    from design.layout.body import face_frames
    from design.layout.places.contact_grid import grid_places_in_lattice
    from design.layout.places.positions import live_channels
    from instobj.viewer.archive import stepped

    spec, xy = context.spec, _places_mm(context.spec)
    grid = grid_places_in_lattice(spec)
    arrays["place_xy_mm"] = xy.astype("<f4")
    frames = [(frame, frame.to_plane(xy)) for frame in face_frames(spec)]
    touched = [
        f.to_object(np.column_stack([plane_mm, np.zeros(len(plane_mm))])) for f, plane_mm in frames
    ]
    arrays["place_mm"] = np.stack(touched).astype("<f4")
    arrays["place_axes"] = stepped(np.stack([f.axes_at(plane_mm) for f, plane_mm in frames]), "i2")
    arrays["force_n"] = signals.force_n[:, grid].astype("<f4")
    arrays["counts"] = stepped(signals.delta_counts[:, grid], "i2")
    arrays["live"] = live_channels(spec).astype("<u1")
    _, motions = context.read(PRESSES)
    motion = motions.motion[:, grid][:, :, steps]
    arrays["motion_mm"] = stepped(motion[..., :3], "i1")
    arrays["motion_rad"] = stepped(motion[..., 3:], "i1")
    error = context.read(DISCRETISATION)["steps"]
    return {
        "depth_mm": signals.depth_mm.tolist(),
        "shown_steps": steps,
        "noise_counts": list(spec.sensors.noise_counts),
        "counts_per_mt": spec.sensors.counts_per_mt,
        "force_error": [step["force_rms"] for step in error],
    }


def _add_maps(context: StageContext, arrays: Arrays, signals: Signals) -> list[dict[str, Any]]:
    """The scores that the page can draw on the body, and the ellipses of the position bound."""
    from estimator.information.ellipses import position_covariances_mm2
    from instobj.figures.maps.files import SCORE_MAPS, unit_of
    from instobj.figures.maps.scale import BOUND_COLOURS

    spec, scores = context.spec, context.read(SCORES)
    covariance = position_covariances_mm2(spec, signals, scores)
    ellipses = covariance[..., [0, 0, 1], [0, 1, 1]]
    arrays["ellipse_mm2"] = ellipses.astype("<f4")
    maps = []
    for score_map in SCORE_MAPS:
        values = getattr(scores, score_map.field)
        arrays[f"map_{score_map.stem}"] = values.astype("<f4")
        maps.append(
            {
                "stem": score_map.stem,
                "title": score_map.title,
                "unit": unit_of(score_map, spec),
                "log": score_map.log,
                "weak": "high" if score_map.colours == BOUND_COLOURS else "low",
                "force_n": spec.score.force_n,
            }
        )
    return maps

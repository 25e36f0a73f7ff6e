"""The object as the page shows it: parts, frames of the faces, mould, in the object's frame and mm.

Everything comes from the specification's own solids and layouts: nothing is solved or scored here.
"""

from __future__ import annotations

from dataclasses import fields
from pathlib import Path
from typing import Any

import numpy as np

from design.body.section_lengths import SectionLengths
from design.body.surface_chart import FaceFrame
from design.body.triangles import Block
from design.layout.boards import board_blocks, mounted_sensors
from design.layout.body import face_frames
from design.layout.mould.frame import mould_frame
from design.layout.places.positions import MagnetLayout, magnet_layout, sensor_layout
from design.spec.object import ObjectSpec
from instobj.render.pieces import load_stl
from instobj.viewer.archive import Stepped, stepped
from instobj.viewer.mould import mould_pieces
from instobj.viewer.surface import Shaded, shaded_part

Arrays = dict[str, Stepped | np.ndarray]
_POSITION_STEP_MM = 0.005
_KNOTS = 129
"""Knots of a curved face's section: straight between them, lengths are good to 0.01 mm."""


def object_scene(spec: ObjectSpec, build: Path) -> tuple[dict[str, Any], Arrays]:
    """Core, magnets, boards, chips, faces and mould of a build: what is small, and arrays."""
    arrays: Arrays = {}
    add_surface(arrays, "core", shaded_part(load_stl(build / "core.stl")))
    _add_magnets(spec, arrays)
    arrays |= _blocks("boards", board_blocks(spec))
    arrays |= _blocks("chips", [mounted.chip for mounted in mounted_sensors(spec)])
    sensors = sensor_layout(spec)
    arrays["sensor_mm"] = stepped(sensors.position_mm, "i2", _POSITION_STEP_MM)
    arrays["sensor_axes"] = stepped(sensors.axes, "i2")
    arrays["sensor_face"] = sensors.face.astype("<u1")
    pieces = mould_pieces(spec, build)
    for index, piece in enumerate(pieces):
        add_surface(arrays, f"mould_{index}", shaded_part(piece.mesh))
    frame = mould_frame(spec)
    away = np.array([0.0, 0.0, 1.0]) if frame.opening == "closed" else -frame.out
    content = {
        "name": spec.name,
        "size_mm": list(spec.body.size_mm),
        "faces": [face_content(face) for face in face_frames(spec)],
        "magnets_in_shell": spec.arrangement == "sensors-in-core",
        "away": away.tolist(),
        "mould": [piece.content for piece in pieces],
        "tip": _tip(spec),
    }
    return content, arrays


def add_surface(arrays: Arrays, name: str, surface: Shaded) -> None:
    """Vertices, triangles and normals of a part."""
    few = len(surface.points_mm) < 2**16
    arrays[f"{name}_mm"] = stepped(surface.points_mm, "i2", _POSITION_STEP_MM)
    arrays[f"{name}_triangles"] = surface.triangles.astype("<u2" if few else "<u4")
    arrays[f"{name}_normals"] = stepped(surface.normals, "i1")


def face_content(face: FaceFrame) -> dict[str, Any]:
    """A face's frame, border and lengths, for the page."""
    return {
        "number": face.number,
        "centre_mm": face.centre_mm.tolist(),
        "x": face.x.tolist(),
        "y": face.y.tolist(),
        "normal": face.normal.tolist(),
        "half_mm": list(face.half_extents_mm),
        "round": bool(face.round),
        "flat": bool(face.flat),
        "sections": [_knots(section) for section in face.sections],
    }


def _knots(section: SectionLengths | None) -> dict[str, list[float]] | None:
    """Lengths along a section and where they are in the plane; None where they are the same."""
    if section is None:
        return None
    first, *_, last = section.length.x.tolist()
    plane = np.linspace(first, last, _KNOTS)
    lengths = section.to_lengths(plane)
    return {"plane_mm": plane.round(5).tolist(), "length_mm": lengths.round(5).tolist()}


def _add_magnets(spec: ObjectSpec, arrays: Arrays) -> None:
    """The first magnet's north half in its own axes (x its side, z to its north), and all frames, their
    columns as much longer as a magnet is larger than the first."""
    from design.build.scene import magnet_halves

    layout = magnet_layout(spec)
    first = MagnetLayout(*(getattr(layout, part.name)[:1] for part in fields(layout)))
    sizes = [(*size.half_mm, size.height_mm / 2) for size in spec.magnets.distinct_sizes]
    larger = (np.array(sizes) / sizes[0])[layout.size]
    ((north, _),) = magnet_halves(spec, first)
    turn = first.frames[0]
    north.apply_translation(-first.centre_mm[0])
    north.vertices = np.asarray(north.vertices) @ turn
    add_surface(arrays, "magnet_half", shaded_part(north))
    arrays["magnet_mm"] = stepped(layout.centre_mm, "i2", _POSITION_STEP_MM)
    arrays["magnet_axes"] = stepped(layout.frames * larger[:, None], "i2")
    arrays["magnet_face"] = layout.face.astype("<u1")


def _blocks(name: str, blocks: list[Block]) -> Arrays:
    if not blocks:
        return {}
    return {
        f"{name}_mm": stepped(np.stack([b.centre_mm for b in blocks]), "i2", _POSITION_STEP_MM),
        f"{name}_axes": stepped(np.stack([b.axes for b in blocks]), "i2"),
        f"{name}_half_mm": stepped(np.stack([b.half_mm for b in blocks]), "i2", _POSITION_STEP_MM),
    }


def _tip(spec: ObjectSpec) -> dict[str, Any]:
    """Kind and radius of the indenter; no radius where it is no sphere."""
    tip = spec.indenter
    return {"kind": tip.kind, "radius_mm": tip.radius_mm if tip.kind == "hemisphere" else None}

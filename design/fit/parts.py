"""Fit of keys, slits, seal layer, channels, bay and mould with what else is in the object."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from math import atan2, cos, floor, hypot, sin, sqrt
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float

from design.body.triangles import Block
from design.fit.curved_parts import check_curved_bay, check_curved_keys, check_curved_slits
from design.fit.nearest import nearest_bay, nearest_keys, nearest_slits, with_nearest
from design.layout.blocks import relief_slits, slit_end_mm
from design.layout.boards import (
    channel_heights_mm,
    passage_radius_mm,
)
from design.layout.body import body_of, core_frames, face_frames
from design.layout.dents import dents_mm
from design.layout.places.positions import cover_mm, shell_covers_mm
from design.layout.pockets import Pocket, sensor_places, shell_pockets, widest_mm

if TYPE_CHECKING:
    from design.spec.object import ObjectSpec

Corners = Float[np.ndarray, "corner 2"]


def check_parts(spec: ObjectSpec) -> Iterator[str]:
    """Yield what of these does not fit."""
    cuboid = body_of(spec).cuboid
    if spec.core.keys.positions_mm:
        yield from with_nearest(spec, _check_keys if cuboid else check_curved_keys, nearest_keys)
    if spec.shell.slits.depth_mm:
        yield from with_nearest(spec, _check_slits if cuboid else check_curved_slits, nearest_slits)
    if spec.shell.seal_layer_mm:
        yield from _check_seal_layer(spec)
    yield from _check_pocket_width(spec)
    yield from _check_dents(spec)
    yield from check_channels(spec)
    if spec.core.bay_mm is not None:
        yield from with_nearest(spec, _check_bay if cuboid else check_curved_bay, nearest_bay)


def check_mesh(spec: ObjectSpec) -> Iterator[str]:
    """Edges that the body has no room for, and a mesh that may leave its surfaces too far.

    The mesher then works on without end or memory.
    """
    mesh, thickness, least = spec.mesh, spec.shell.thickness_mm, min(spec.body.size_mm)
    for key, most, what in (
        ("edge_mm", least, "the shortest edge of the body"),
        ("surface_edge_mm", least / 2, "half of the shortest edge of the body"),
        ("envelope_mm", thickness / 8, "an eighth of shell.thickness_mm"),
    ):
        if getattr(mesh, key) > most:
            yield (
                f"mesh.{key} = {getattr(mesh, key):g} is more than {what}, {most:g} mm. Make it smaller; "
                f"by default it is {type(mesh).model_fields[key].default:g}"
            )


def _check_keys(spec: ObjectSpec) -> Iterator[str]:
    keys = spec.core.keys
    if spec.mechanics.interface != "bonded":
        yield (
            "core.keys lock the shell, so that it cannot slide on a frictionless core. Set "
            'mechanics.interface = "bonded", or leave the keys out'
        )
    half = [edge / 2 - spec.shell.thickness_mm for edge in _smallest_face_mm(spec)]
    for index, (x, y) in enumerate(keys.positions_mm):
        where = f"core.keys.positions_mm[{index}] = ({x:g}, {y:g})"
        width, length = keys.size_mm
        if abs(x) + width / 2 > half[0] or abs(y) + length / 2 > half[1]:
            yield (
                f"{where} reaches past the core's face (±{half[0]:g}, ±{half[1]:g} mm). Move it "
                "inwards or make core.keys.size_mm smaller"
            )
        key = rectangle((x, y), (width / 2, length / 2), 0.0)
        yield from _check_key_clear_of_core(spec, where, key)
        yield from _check_key_below_pockets(spec, where, key)


def _check_pocket_width(spec: ObjectSpec) -> Iterator[str]:
    wide, least = spec.shell.pocket_diameter_mm, widest_mm(spec)
    if spec.arrangement == "sensors-in-core" and spec.magnets.shape != "block" and wide < least:
        yield (
            f"shell.pocket_diameter_mm = {wide:g} is narrower than the magnets of {least:g} "
            f"mm, which would stand in the silicone. Make it {least:g} or more, or take a "
            "smaller magnet"
        )


def _check_dents(spec: ObjectSpec) -> Iterator[str]:
    measured = [magnet for magnet in spec.as_built.magnets if magnet.dent_mm is not None]
    if measured and spec.arrangement == "sensors-in-shell":
        yield ("as_built gives dent_mm of a magnet, but the magnets lie in the core. Leave it out")
        return
    depth = dents_mm(spec)
    not_with = {
        "mechanics.correction": (spec.mechanics.correction, "none"),
        "mechanics.slip": (spec.mechanics.slip.slipped, False),
        "indenter.friction": (spec.indenter.friction, "none"),
    }
    for key, (given, needed) in not_with.items():
        if depth.any() and given != needed:
            yield (
                f"dents of the seals (as_built) are not known with {key}; got "
                f"{given!r}. Leave one of the two out"
            )
    for frame, pockets, dents in zip(face_frames(spec), shell_pockets(spec), depth, strict=True):
        for pocket, dent in zip(pockets, dents, strict=True):
            if not dent:
                continue
            cover = cover_mm(frame, pocket.body)
            if dent >= cover:
                yield (
                    f"a dent of {dent:g} mm on face {frame.number} reaches {pocket.body.label}, over "
                    f"which there are {cover:.3g} mm of silicone. Make dent_mm (as_built) "
                    f"smaller than {floor(1e3 * cover) / 1e3:g}"
                )


def _check_key_clear_of_core(spec: ObjectSpec, where: str, key: Corners) -> Iterator[str]:
    for face, openings in zip(spec.body.sensed, core_openings(spec), strict=True):
        for name, corners in openings:
            if overlap(key, corners):
                yield (
                    f"{where} stands over {name} of face {face}. Move it, or make "
                    "core.keys.size_mm smaller"
                )
    others = [rectangle(p, _half(spec.core.keys.size_mm), 0.0) for p in spec.core.keys.positions_mm]
    if sum(overlap(key, other_key) for other_key in others) > 1:
        yield f"{where} meets another key. Move one of them"


def core_openings(spec: ObjectSpec) -> list[list[tuple[str, Corners]]]:
    """Outlines of recesses, channels and wire hole on every face of the core."""
    core = spec.core
    middle = passage_radius_mm(spec)
    hub = ("the wire hole", rectangle((0.0, 0.0), (middle, middle), 0.0))
    faces = []
    for places in sensor_places(spec):
        openings: list[tuple[str, Corners]] = [hub]
        for x, y, azimuth in places if spec.arrangement == "sensors-in-core" else ():
            openings.append(("a sensor's recess", recess_outline(spec, x, y, azimuth)))
            if core.wire_channel_width_mm:
                reach = (0.0, hypot(x, y))
                channel = _radial(atan2(y, x), reach, core.wire_channel_width_mm)
                openings.append(("a wire channel", channel))
        faces.append(openings)
    return faces


def _check_key_below_pockets(spec: ObjectSpec, where: str, key: Corners) -> Iterator[str]:
    room = spec.shell.thickness_mm - spec.core.keys.height_mm
    for face in shell_pockets(spec):
        for pocket in face:
            below = [end[:2] for end in pocket.axis_ends_mm]
            near = any(distance_mm(key, xy) < pocket.outline.radius_mm for xy in below)
            if -pocket.lowest_mm >= (room if near else spec.shell.thickness_mm):
                yield (
                    f"{where} reaches {spec.core.keys.height_mm:g} mm up, into the pocket of "
                    f"{pocket.body.label}. Lower core.keys.height_mm, or move the key"
                )
    if room <= 0:
        yield (
            f"core.keys.height_mm must be below shell.thickness_mm = {spec.shell.thickness_mm:g}; got "
            f"{spec.core.keys.height_mm:g}. Lower it"
        )


def _check_slits(spec: ObjectSpec) -> Iterator[str]:
    slits, thickness = spec.shell.slits, spec.shell.thickness_mm
    if slits.depth_mm + slits.width_mm / 2 >= sqrt(2) * thickness:
        yield (
            f"shell.slits.depth_mm = {slits.depth_mm:g} reaches the core, {sqrt(2) * thickness:.3g} mm "
            "below the edge. Make the slits shallower or the shell thicker"
        )
    if 2 * slit_end_mm(spec) >= min(spec.body.size_mm):
        yield (
            f"shell.slits end {slit_end_mm(spec):.3g} mm before the corners, which leaves no slit along "
            f"an edge of {min(spec.body.size_mm):g} mm. Leave shell.slits.depth_mm out"
        )
    for frame, face in zip(face_frames(spec), shell_pockets(spec), strict=True):
        for pocket, slit in product(face, relief_slits(spec)):
            if _slit_meets(slit, np.asarray(frame.to_object(_along(pocket))), pocket):
                yield (
                    f"the pocket of {pocket.body.label} meets a relief slit. Move the magnet inwards "
                    "or make shell.slits.depth_mm smaller"
                )


def _along(pocket: Pocket) -> Float[np.ndarray, "n 3"]:
    floor, mouth = pocket.axis_ends_mm
    return floor + np.linspace(0, 1, 25)[:, None] * (mouth - floor)


def _slit_meets(slit: Block, axis_mm: np.ndarray, pocket: Pocket) -> bool:
    """Return whether a slit comes within a pocket's radius of its axis, in steps of an eighth of its
    depth."""
    local = abs((axis_mm - slit.centre_mm) @ slit.axes) - slit.half_mm
    return bool((np.linalg.norm(local.clip(min=0), axis=1) <= pocket.outline.radius_mm).any())


def _check_seal_layer(spec: ObjectSpec) -> Iterator[str]:
    layer = spec.shell.seal_layer_mm
    room = float(np.min(np.concatenate(shell_covers_mm(spec))))
    if layer > room:
        yield (
            f"shell.seal_layer_mm = {layer:g} would leave magnets sticking out of the first pour: at "
            f"most {room:.3g} mm of silicone lie over them. Lower it or seat them deeper"
        )


def check_channels(spec: ObjectSpec) -> Iterator[str]:
    core = spec.core
    if not core.wire_channel_width_mm:
        return
    deepest = max(
        -channel_heights_mm(spec, frame, np.array([x, y]), 0.0)[0]
        for frame, places in zip(core_frames(spec), sensor_places(spec), strict=True)
        for x, y, _ in places
    )
    if deepest >= core.wall_mm:
        fall = deepest - core.wire_channel_depth_mm
        wall_left_mm = core.wall_mm - max(fall, 0.0)
        shallower = (
            f"Make the channels less than {wall_left_mm:.3g} mm deep, "
            if wall_left_mm > 0
            else "Make "
        )
        curved = f" and {fall:.3g} mm of the curved core's fall" if fall > 0 else ""
        yield (
            f"core.wire_channel_depth_mm{curved} must be below core.wall_mm = {core.wall_mm:g}; got "
            f"{core.wire_channel_depth_mm:g}. {shallower}the wall thicker than {deepest:.4g} mm, or move "
            "the sensors inwards"
        )


def recess_outline(spec: ObjectSpec, x: float, y: float, azimuth: float) -> Corners:
    """Outline of a sensor's recess on the core's face."""
    core, offset = spec.core, hypot(x, y) - spec.sensors.radius_mm
    radii = (core.recess_inner_radius_mm + offset, core.recess_outer_radius_mm + offset)
    return _radial(azimuth, radii, core.recess_width_mm)


def _check_bay(spec: ObjectSpec) -> Iterator[str]:
    core, size = spec.core, spec.core_size_mm
    assert core.bay_mm is not None
    deepest = core.recess_depth_mm
    limits = (size[0] - 2 * deepest, size[1] - 2 * deepest, size[2] - deepest)
    for axis, edge, limit in zip("xyz", core.bay_mm, limits, strict=True):
        if edge >= limit:
            yield (
                f"core.bay_mm is {edge:g} mm in {axis}; the core leaves less than {limit:g} mm behind "
                "its recesses. Make the bay smaller or the body larger"
            )


def _smallest_face_mm(spec: ObjectSpec) -> tuple[float, float]:
    """Smallest extent along x, and along y, of the sensed faces in their own frames."""
    extents = np.array([frame.half_extents_mm for frame in face_frames(spec)]).min(axis=0)
    return float(2 * extents[0]), float(2 * extents[1])


def _half(size: tuple[float, float]) -> tuple[float, float]:
    return size[0] / 2, size[1] / 2


def rectangle(centre: tuple[float, float], half: tuple[float, float], azimuth: float) -> Corners:
    turn = np.array([[cos(azimuth), -sin(azimuth)], [sin(azimuth), cos(azimuth)]])
    corners = np.array([[1, 1], [-1, 1], [-1, -1], [1, -1]]) * np.asarray(half)
    return corners @ turn.T + np.asarray(centre)


def _radial(azimuth: float, radii: tuple[float, float], width: float) -> Corners:
    """Rectangle between two radii along an azimuth."""
    middle = (radii[0] + radii[1]) / 2
    centre = (middle * cos(azimuth), middle * sin(azimuth))
    return rectangle(centre, ((radii[1] - radii[0]) / 2, width / 2), azimuth)


def overlap(a: Corners, b: Corners) -> bool:
    """Return whether two convex polygons (corners counter-clockwise) overlap: no edge separates them."""
    for polygon, other_polygon in ((a, b), (b, a)):
        edge = np.roll(polygon, -1, axis=0) - polygon
        outward = np.column_stack([edge[:, 1], -edge[:, 0]])
        heights = (other_polygon[None] - polygon[:, None]) @ outward[:, :, None]
        if (heights[..., 0].min(axis=1) >= -1e-9).any():
            return False
    return True


def distance_mm(polygon: Corners, point: Float[np.ndarray, "2"]) -> float:
    """Distance of a point from a convex polygon (corners counter-clockwise); 0 inside."""
    edge = np.roll(polygon, -1, axis=0) - polygon
    away = point - polygon
    left_of_edge = edge[:, 0] * away[:, 1] - edge[:, 1] * away[:, 0]
    if (left_of_edge >= 0).all():
        return 0.0
    length2 = np.maximum((edge**2).sum(axis=1), 1e-12)  # of a recess without length, 0
    share = np.clip((away * edge).sum(axis=1) / length2, 0, 1)
    return float(np.linalg.norm(away - share[:, None] * edge, axis=1).min())

"""Shell and core as closed surfaces: the parts of bodies that are known by their triangles."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from design.body.meshes import boolean_of, one_closed_surface
from design.body.sampled import sampled_core
from design.body.surface_chart import FaceFrame
from design.body.triangles import block_surface
from design.errors import InputError
from design.layout.blocks import core_keys, relief_slits
from design.layout.boards import wire_channels
from design.layout.body import body_of, face_frames
from design.layout.core_hold import Locator, core_outlet, locators
from design.layout.core_sockets import Socket
from design.layout.places.positions import board_places
from design.layout.pockets import Pocket, shell_pockets
from design.layout.surface import cast_surface

if TYPE_CHECKING:
    import trimesh

    from design.spec.object import ObjectSpec

_OVERSHOOT_MM = 0.5
_SECTIONS = 64
_LEAST_HOLLOW_MM = 3.0
_LEANING = 0.5
"""Share of its radius, by which a hole goes on beyond a surface that leans."""


def sampled_shell(spec: ObjectSpec) -> trimesh.Trimesh:
    """The cast shell, pockets open outwards, in the object's frame (mm), of any body.

    Of bodies that are known by their triangles it is the part itself; of all others it leaves the
    exact shell by the mesh's envelope, and round pockets by 0.004 mm.

    Raises
    ------
    NotOneSolid
        An InputError: the dimensions do not give one closed surface.
    """
    pockets = [
        _pocket(frame.tangent(pocket.body.centre_mm[:2]), pocket)
        for frame, face in zip(face_frames(spec), shell_pockets(spec), strict=True)
        for pocket in face
    ]
    blocks = [block_surface(block) for block in (*core_keys(spec), *relief_slits(spec))]
    holes = [_locator_hole(locator) for locator in locators(spec)]
    cavity = body_of(spec).cavity_surface()
    removed = [*pockets, *blocks, *holes, *([] if cavity is None else [cavity])]
    return _one(cast_surface(spec), removed, "shell")


def _locator_hole(locator: Locator) -> trimesh.Trimesh:
    """From within the core to outside the face."""
    import trimesh

    middle, normal = locator.frame.centre_mm, locator.frame.normal
    past = _OVERSHOOT_MM + locator.radius_mm * locator.rise_mm
    ends = [middle - (locator.depth_mm + past) * normal, middle + past * normal]
    return trimesh.creation.cylinder(locator.radius_mm, segment=ends, sections=_SECTIONS)


def sampled_core_part(spec: ObjectSpec) -> trimesh.Trimesh:
    """The core with its recesses and wire holes, hollow with an outlet by the bore if there is room.

    Raises
    ------
    NotOneSolid
        An InputError: the dimensions do not give one closed surface.
    """
    removed = []
    for frame, places in board_places(spec):
        removed += [_recess(spec, frame, place, sink) for place, sink in places]
        channels = wire_channels(spec, frame, [place for place, _ in places], _OVERSHOOT_MM)
        removed += [block_surface(channel) for channel in channels]
        removed.append(_wire_hole(spec, frame))
    removed += [_socket(locator.socket) for locator in locators(spec) if locator.socket]
    if 6 in spec.body.opened:
        removed.append(hollow_mesh(spec))
    return _one(keyed_core(spec), removed, "core")


def keyed_core(spec: ObjectSpec) -> trimesh.Trimesh:
    """The core's outside with its keys, recesses and holes filled."""
    core, keys = sampled_core(body_of(spec)), map(block_surface, core_keys(spec))
    for key in keys:
        core = core.union(key)
    return core


def _socket(socket: Socket) -> trimesh.Trimesh:
    import trimesh

    mouth = socket.frame.centre_mm - (socket.depth_mm - _OVERSHOOT_MM) * socket.frame.normal
    ends = [socket.end_mm, mouth + _LEANING * socket.radius_mm * socket.frame.normal]
    return trimesh.creation.cylinder(socket.radius_mm, segment=ends, sections=_SECTIONS)


def hollow_mesh(spec: ObjectSpec) -> trimesh.Trimesh:
    """The core's cavity where there is room for one, and its outlet with a flat on one side."""
    import trimesh

    wall, outlet = spec.core.wall_mm, core_outlet(spec)
    length = spec.body.size_mm[2] / 2
    hollow = trimesh.creation.cylinder(outlet.radius_mm, length, sections=_SECTIONS)
    hollow.apply_translation((0, 0, -length / 2))
    body = body_of(spec)
    if body.core_half_mm.min() - wall > _LEAST_HOLLOW_MM:
        with suppress(InputError):  # of walls, as a mug's: no room in one piece, whatever its box
            room = sampled_core(replace(body, thickness_mm=body.thickness_mm + wall))
            hollow = hollow.union(room)
    return hollow.difference(trimesh.creation.box(bounds=outlet.key_mm))


def _pocket(frame: FaceFrame, pocket: Pocket) -> trimesh.Trimesh:
    """The pocket's prism from its floor to above the plane that touches the body there."""
    import trimesh

    floor, mouth = frame.to_object(pocket.axis_ends_mm)
    mouth = mouth + _OVERSHOOT_MM * frame.normal
    half, length = pocket.outline.half_mm, float(np.linalg.norm(mouth - floor))
    if pocket.outline.round:
        solid = trimesh.creation.cylinder(half[0], length, sections=_SECTIONS)
    else:
        solid = trimesh.creation.box((2 * half[0], 2 * half[1], length))
    solid.apply_transform(_placed(frame.axes @ pocket.body.frame, (floor + mouth) / 2))
    return solid


def _recess(
    spec: ObjectSpec, frame: FaceFrame, place: tuple[float, float, float], sink_mm: float
) -> trimesh.Trimesh:
    import trimesh

    core, (x, y, azimuth) = spec.core, place
    length = core.recess_outer_radius_mm - core.recess_inner_radius_mm
    middle = (
        core.recess_outer_radius_mm + core.recess_inner_radius_mm
    ) / 2 - spec.sensors.radius_mm
    depth = core.recess_depth_mm + sink_mm
    height = depth + _OVERSHOOT_MM
    radial = np.array([np.cos(azimuth), np.sin(azimuth), 0.0])
    turn = np.column_stack([radial, np.cross([0, 0, 1.0], radial), [0, 0, 1.0]])
    centre = np.array([x, y, height / 2 - depth]) + middle * radial
    tangent = frame.tangent(np.array([x, y]))
    box = trimesh.creation.box((length, core.recess_width_mm, height))
    box.apply_transform(_placed(tangent.axes @ turn, tangent.to_object(centre)))
    return box


def _wire_hole(spec: ObjectSpec, frame: FaceFrame) -> trimesh.Trimesh:
    """From beyond the body's centre out of its box: where the core leans, it stands on next to a face's
    middle. Holes that ended at the centre met those of opposite faces in a circle alone."""
    import trimesh

    radius, middle = spec.core.wire_hole_side_diameter_mm / 2, frame.centre_mm
    rest = abs(frame.normal) @ body_of(spec).half_mm - middle @ frame.normal
    ends = [-radius * frame.normal, middle + (rest + _OVERSHOOT_MM) * frame.normal]
    return trimesh.creation.cylinder(radius, segment=ends, sections=_SECTIONS)


def _placed(axes: np.ndarray, origin_mm: np.ndarray) -> np.ndarray:
    transform = np.eye(4)
    transform[:3, :3], transform[:3, 3] = axes, origin_mm
    return transform


def _one(body: trimesh.Trimesh, removed: list[trimesh.Trimesh], name: str) -> trimesh.Trimesh:
    return one_closed_surface(boolean_of("difference", [body, *removed]), name)

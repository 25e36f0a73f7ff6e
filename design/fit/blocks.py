"""Fit of keys, slits and a bay with what else is in the object, as blocks in its frame."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations
from typing import TYPE_CHECKING

import numpy as np

from design.body.triangles import Block
from design.layout.blocks import SUNK_MM, core_keys, relief_slits, slit_end_mm
from design.layout.boards import (
    LID_RIM_MM,
    bay_block,
    cuts_of_core,
    gap_mm,
    has_lid,
    passage_radius_mm,
)
from design.layout.body import body_of, core_frames, face_frames
from design.layout.core_hold import locators
from design.layout.pockets import axis_in_object_mm, shell_pockets

if TYPE_CHECKING:
    from design.body.surface_chart import FaceFrame
    from design.spec.object import ObjectSpec

_STEPS = 25
"""Points along a slit at which it is checked."""


def check_keys(spec: ObjectSpec) -> Iterator[str]:
    """Keys on their patches, clear of what is cut into the core, of pockets and of each other."""
    keys, thickness = spec.core.keys, spec.shell.thickness_mm
    if not body_of(spec).takes_keys or spec.body.inside != "core":
        yield (
            "core.keys stand in silicone that a plug or the core itself shapes; this "
            f"{spec.body.kind} is filled to the rim of its mould or holds air. Leave core.keys out"
        )
        return
    if spec.mechanics.interface != "bonded":
        yield (
            "core.keys lock the shell, so that it cannot slide on a frictionless core. Set "
            'mechanics.interface = "bonded", or leave the keys out'
        )
    half = np.asarray(keys.size_mm[:2]) / 2
    beyond = [
        (frame, xy)
        for frame in core_frames(spec)
        for xy in keys.positions_mm
        if not frame.covers(np.abs(xy) + half)
    ]
    # A place that several faces share is told once, of the face that has the least room.
    tightest: dict[tuple[float, float], FaceFrame] = {}
    for frame, xy in sorted(beyond, key=lambda pair: min(pair[0].half_extents_mm)):
        tightest.setdefault(xy, frame)
    for (x, y), frame in tightest.items():
        reach = frame.half_extents_mm
        yield (
            f"core.keys.positions_mm: the key at ({x:g}, {y:g}) reaches past the core's patch of face "
            f"{frame.number} (±{reach[0]:.4g}, ±{reach[1]:.4g} mm). Move it inwards or make "
            "core.keys.size_mm smaller"
        )
    if keys.size_mm[2] >= thickness:
        yield (
            f"the height of core.keys.size_mm must be below shell.thickness_mm = {thickness:g}; got "
            f"{keys.size_mm[2]:g}. Lower it"
        )
    if not beyond:
        yield from _check_blocks(spec)


def _check_blocks(spec: ObjectSpec) -> Iterator[str]:
    count = len(spec.core.keys.positions_mm)
    placed = [
        (f"core.keys: key {index % count + 1} of face {spec.body.sensed[index // count]}", key)
        for index, key in enumerate(core_keys(spec))
    ]
    above = [(label, _without_root(key)) for label, key in placed]
    for (label, key), (other_label, other_key) in combinations(above, 2):
        if gap_mm(key, other_key) <= 0:
            yield f"{label} meets {other_label.removeprefix('core.keys: ')}. Move one of them"
    cuts = cuts_of_core(spec)
    for label, key in placed:
        if any(gap_mm(key, cut) <= 0 for cut in cuts):
            yield (
                f"{label} stands over a sensor's recess or a wire channel. Move it, or make "
                "core.keys.size_mm smaller"
            )
        yield from check_passages(spec, label, key)
        yield from _check_pockets(spec, label, key)


def _without_root(key: Block) -> Block:
    """A key without the end that lies in the core, where keys of two faces may meet."""
    up = key.axes[:, 2] * SUNK_MM / 2
    return Block(key.centre_mm + up, key.axes, key.half_mm - np.array([0.0, 0.0, SUNK_MM / 2]))


def check_passages(spec: ObjectSpec, where: str, key: Block) -> Iterator[str]:
    """Wire holes, through which pins may stand, and the bore."""
    body, radius = body_of(spec), passage_radius_mm(spec)
    for core, face in zip(core_frames(spec), face_frames(spec), strict=True):
        if _line_distance_mm(key, 0.5 * core.centre_mm, face.centre_mm) < radius:
            yield f"{where} stands over the wire hole of face {core.number}. Move it outwards"
    low = np.array([0.0, 0.0, -spec.body.size_mm[2] / 2])
    if body.opening == "bore" and _line_distance_mm(key, 0 * low, low) < body.bore_mm / 2:
        yield f"{where} stands in the bore. Move it away from face 6"


def _check_pockets(spec: ObjectSpec, where: str, key: Block) -> Iterator[str]:
    for frame, face in zip(face_frames(spec), shell_pockets(spec), strict=True):
        for pocket in face:
            ends = axis_in_object_mm(frame, pocket)
            away = _line_distance_mm(key, *ends)
            if away < pocket.outline.radius_mm and _is_under(key, ends, away):
                yield (
                    f"{where} reaches {spec.core.keys.size_mm[2]:g} mm up, into the pocket of "
                    f"{pocket.body.label} of face {frame.number}. Lower the height of core.keys.size_mm, "
                    "or move the key"
                )


def _is_under(key: Block, ends_mm: np.ndarray, away_mm: float) -> bool:
    """Return whether a key that is nearer to a pocket's axis than its radius reaches above its floor."""
    direction = (ends_mm[1] - ends_mm[0]) / np.linalg.norm(ends_mm[1] - ends_mm[0])
    return bool(((key.corners_mm - ends_mm[0]) @ direction).max() > 0 or away_mm == 0)


def check_slits(spec: ObjectSpec) -> Iterator[str]:
    """Slits that leave silicone over the core and end before the body does, clear of pockets and keys."""
    slits, body, slit_blocks = spec.shell.slits, body_of(spec), relief_slits(spec)
    if slit_blocks and body.opening != "open" and not body.cuboid:
        yield (
            "shell.slits need a mould that is open at one side: round a core that is cast in it parts into "
            f"two halves, and fins in their seam would hook the silicone; this {spec.body.kind} has "
            f"body.open_faces = {list(spec.body.opened)}. Leave shell.slits.depth_mm out, or cut the slits"
        )
        return
    if not slit_blocks:
        yield (
            f"shell.slits lie between sensed sides 2 to 5 that meet; this {spec.body.kind} has none. Leave "
            "shell.slits.depth_mm out"
        )
    # Of boxes all edges may have slits, of other bodies those along z.
    least = min(spec.body.size_mm) if body.cuboid else spec.body.size_mm[2]
    if 2 * slit_end_mm(spec) >= least:
        yield (
            f"shell.slits end {slit_end_mm(spec):.3g} mm before the corners, which leaves no slit along "
            f"an edge of {least:g} mm. Leave shell.slits.depth_mm out"
        )
        return
    for slit in slit_blocks:
        steps = np.linspace(-1, 1, _STEPS)
        floor = np.column_stack([steps, np.ones(_STEPS), np.zeros(_STEPS)]) * slit.half_mm
        cover_mm = float(body.core_distance_mm(slit.centre_mm + floor @ slit.axes.T).min())
        if cover_mm < spec.silicone.thinnest_wall_mm:
            yield (
                f"shell.slits.depth_mm = {slits.depth_mm:g} leaves {cover_mm:.3g} mm of silicone over "
                f"the core, less than silicone.thinnest_wall_mm = {spec.silicone.thinnest_wall_mm:g}. Make "
                "the slits shallower or the shell thicker"
            )
            break
    if any(gap_mm(slit, key) <= 0 for slit in slit_blocks for key in core_keys(spec)):
        yield "a relief slit meets a key of the core. Move the key, or make shell.slits.depth_mm smaller"
    for frame, face in zip(face_frames(spec), shell_pockets(spec), strict=True):
        for pocket in face:
            ends = axis_in_object_mm(frame, pocket)
            if any(
                _line_distance_mm(slit, *ends) <= pocket.outline.radius_mm for slit in slit_blocks
            ):
                yield (
                    f"the pocket of {pocket.body.label} of face {frame.number} meets a relief slit. Move "
                    "the magnet inwards or make shell.slits.depth_mm smaller"
                )


def check_bay(spec: ObjectSpec) -> Iterator[str]:
    """A bay that can be reached, with walls to what is cut into the core and to its sides."""
    body, bay, wall = body_of(spec), bay_block(spec), spec.printer.wall_mm
    if bay is None:
        return
    lid = has_lid(spec)
    if (lid and body.sampled) or not (
        lid or body.on_base or (body.opens_sides and 6 in body.opened)
    ):
        yield (
            "core.bay_mm opens at the core's lower end, or lies in a closed core that is printed in two "
            f"parts; the core of this {spec.body.kind} has neither. Leave core.bay_mm out, open face 6 of a "
            "box or cylinder, or leave no face open"
        )
        return
    if lid:
        yield from _check_closed_bay(spec, bay)
        return
    upper = bay.corners_mm[4:]
    across = np.hypot(*upper[:, :2].T) if body.size_mm[0] == body.size_mm[1] else 0 * upper[:, 0]
    beside = np.maximum(
        across - body.half_mm[0], np.max(abs(upper[:, :2]) - body.half_mm[:2], axis=1)
    )
    middle = bay.centre_mm + np.array([0.0, 0.0, bay.half_mm[2]])
    above = body.core_distance_mm(np.vstack([upper, middle]))
    wall_left_mm = -max(float(np.max(np.maximum(above[:-1], beside))), float(above[-1]))
    if wall_left_mm < wall:
        yield (
            f"core.bay_mm leaves {wall_left_mm:.3g} mm of the core's wall at its upper corners, less than "
            f"printer.wall_mm = {wall:g}. Make the bay smaller by twice what is missing"
        )
    gaps = [gap_mm(bay, cut) for cut in cuts_of_core(spec)]
    if min(gaps, default=wall) < wall:
        yield (
            f"core.bay_mm comes within {min(gaps):.3g} mm of a sensor's recess or a wire channel, less than "
            f"printer.wall_mm = {wall:g}. Make the bay smaller"
        )


def _check_closed_bay(spec: ObjectSpec, bay: Block) -> Iterator[str]:
    """Wall all round, to what is cut into the core and to its pins; height for the lid's rim."""
    body, wall = body_of(spec), spec.printer.wall_mm
    sides = np.vstack(
        [bay.centre_mm + bay.half_mm * np.eye(3), bay.centre_mm - bay.half_mm * np.eye(3)]
    )
    around_mm = -float(np.max(body.core_distance_mm(np.vstack([bay.corners_mm, sides]))))
    cuts_mm = min((gap_mm(bay, cut) for cut in cuts_of_core(spec)), default=wall)
    sockets = [locator.socket for locator in locators(spec) if locator.socket is not None]
    pins_mm = min(
        (float(bay.distance_mm(s.end_mm[None])[0]) - s.radius_mm for s in sockets), default=wall
    )
    for left_mm, what in (
        (around_mm, "of the core's wall"),
        (cuts_mm, "to a sensor's recess or a wire channel"),
    ):
        if left_mm < wall:
            yield (
                f"core.bay_mm leaves {left_mm:.3g} mm {what}, less than printer.wall_mm = {wall:g}. Make the "
                "bay smaller by twice what is missing"
            )
    if pins_mm < wall:
        yield (
            f"core.bay_mm is in the way of pins that hold the core in its mould: {pins_mm:.3g} mm to "
            f"their holes, less than printer.wall_mm = {wall:g}. Move shell pockets out of the middles of "
            "two faces, where pins then stand in the wire holes, or make the bay smaller"
        )
    least_mm = 2 * (wall + spec.printer.clearance_mm) + wall
    size_mm = 2 * bay.half_mm
    if size_mm[:2].min() < least_mm or size_mm[2] <= LID_RIM_MM:
        yield (
            f"core.bay_mm = {size_mm.tolist()} has no room for the lid's rim. Give {least_mm:g} mm or "
            f"more in x and y, and more than {LID_RIM_MM:g} in depth"
        )


def _line_distance_mm(block: Block, start_mm: np.ndarray, end_mm: np.ndarray) -> float:
    """Least distance of points along a straight piece from a block."""
    points = start_mm + np.linspace(0, 1, _STEPS)[:, None] * (end_mm - start_mm)
    return float(block.distance_mm(points).min())

"""Gaps in core and shell that can be printed and cast, beyond what must fit."""

from __future__ import annotations

import numpy as np
from jaxtyping import Float

from design.body.surface_chart import FaceFrame
from design.fit.boards import distance_beyond_core_mm
from design.fit.parts import ROOMY
from design.layout.boards import (
    Recess,
    passage_radius_mm,
    sensor_recesses,
    smallest_recess_wall_mm,
)
from design.layout.body import body_of, core_frames, face_frames
from design.layout.mould.frame import mould_style
from design.layout.mould.pins import least_rim_mm, loose_pins
from design.layout.places.positions import shell_covers_mm
from design.layout.pockets import (
    Pocket,
    axis_in_object_mm,
    sensor_places,
    shell_pockets,
    smallest_gap_mm,
)
from design.layout.template_marks import thinnest_mark_wall_mm
from design.spec.object import ObjectSpec

Points = Float[np.ndarray, "point 3"]
_LAYER_MM = 0.25
"""Thickness of a floor below a sloping core, at least: what a printer lays in one layer."""
_WALL_DEG, _STEP_MM, _EDGE_POINTS = 45.0, 0.05, 5
_EXACT_MM = 1e-6
_FACING_DEG, _ROUND, _ALONG_MM = 18.0, 24, 0.25
"""Beside a bore: how squarely a wall's side faces it, and where walls are looked at."""


def tight_core(spec: ObjectSpec, sunk: bool = True) -> bool:
    """Return whether a wall between two recesses is too thin to print.

    Not `sunk`: as deep as on a flat core, which is quicker and never tighter.
    """
    sensors = sum(len(places) for places in sensor_places(spec))
    return sensors > 1 and smallest_recess_wall_mm(spec, sunk) < spec.printer.wall_mm


def low_rim(spec: ObjectSpec) -> bool:
    """Return whether a recess's floor comes nearer to the core's surface than a wall that can be printed.

    Where another side of the core is so near, the wall is too thin (`tight_rim`); where the core only
    slopes away, the wall is low there.
    """
    floors = np.concatenate([recess.corners_mm[:4] for recess in sensor_recesses(spec)])
    return bool(distance_beyond_core_mm(spec, floors).max() > -ROOMY * spec.printer.wall_mm)


def tight_rim(spec: ObjectSpec) -> bool:
    """Return whether a recess ends so near another side of the core that the wall there is too thin to print.

    A wall is where the core's surface faces a side of the recess, or its floor, within 45°. What is
    less steep is no wall but a slope, on which the recess must only keep its floor a printed layer
    below the surface.
    """
    least = ROOMY * spec.printer.wall_mm
    points, outward = map(
        np.concatenate, zip(*map(_floor_edges, sensor_recesses(spec)), strict=True)
    )
    if distance_beyond_core_mm(spec, points).max() > -_LAYER_MM:
        return True
    past = points + least * outward
    beyond = distance_beyond_core_mm(spec, past)
    rise = beyond - distance_beyond_core_mm(spec, past - _STEP_MM * outward)
    return bool(np.any((beyond > 0) & (rise > np.cos(np.deg2rad(_WALL_DEG)) * _STEP_MM)))


def _floor_edges(recess: Recess) -> tuple[Points, Points]:
    """Points along the edges of a recess's floor, each with the normal outward of its side, and of
    the floor."""
    steps = np.linspace(-1, 1, _EDGE_POINTS)
    ones, (x, y, z) = np.ones(_EDGE_POINTS), recess.axes.T
    sides = [
        (share, normal)
        for sign in (-1, 1)
        for share, normal in (
            (np.column_stack([sign * ones, steps, -ones]), sign * x),
            (np.column_stack([steps, sign * ones, -ones]), sign * y),
        )
    ]
    shares = np.concatenate([share for share, _ in sides] * 2)
    normals = np.array([*(normal for _, normal in sides), *[-z] * len(sides)])
    points = recess.centre_mm + (shares * recess.half_mm) @ recess.axes.T
    return points, normals.repeat(_EDGE_POINTS, axis=0)


def tight_middle(spec: ObjectSpec) -> bool:
    """Return whether a wall between a recess and the wire hole is too thin to print.

    A recess in the middle of its face swallows the hole.
    """
    core, least = spec.core, spec.printer.wall_mm
    hole = passage_radius_mm(spec)
    inward = spec.sensors.radius_mm - core.recess_inner_radius_mm
    away = [np.hypot(x, y) for places in sensor_places(spec) for x, y, _ in places]
    return any(0 < middle < hole + least + inward for middle in away)


def thin_beside_wire_hole(spec: ObjectSpec) -> bool:
    """Return whether a recess that leans towards the wire hole of its face, as on a curved core, comes so
    near it at its floor that the wall between them is too thin to print.

    One that leans by more than what rays take for a wall leaves a wedge.
    """
    least = passage_radius_mm(spec) + spec.printer.wall_mm
    frames = {frame.number: frame for frame in core_frames(spec)}
    places = [place[:2] for face in sensor_places(spec) for place in face]
    for recess, place in zip(sensor_recesses(spec), places, strict=True):
        frame = frames[recess.face]
        leans = recess.axes[:, 2] @ frame.normal < np.cos(np.deg2rad(_FACING_DEG))
        if np.hypot(*place) > 0 and not leans:
            aside = (_points_of(recess) - frame.centre_mm) @ frame.axes[:, :2]
            if np.linalg.norm(aside, axis=1).min() < least - _EXACT_MM:
                return True
    return False


def outlet_room_mm(spec: ObjectSpec) -> float:
    """Radius about −z that leaves a wall to every recess that reaches as low as a core's outlet."""
    points = _points_of_recesses(spec)
    beside = points[points[:, 2] < 0]
    away = np.linalg.norm(beside[:, :2], axis=1).min(initial=np.inf)
    return float(away) - spec.printer.wall_mm - _STEP_MM


def _points_of_recesses(spec: ObjectSpec) -> Points:
    return np.concatenate([_points_of(recess) for recess in sensor_recesses(spec)])


def _points_of(recess: Recess) -> Points:
    steps = np.linspace(-1, 1, _EDGE_POINTS)
    shares = np.stack(np.meshgrid(steps, steps, steps), axis=-1).reshape(-1, 3)
    return recess.centre_mm + (shares * recess.half_mm) @ recess.axes.T


def thin_over_outlet(spec: ObjectSpec) -> bool:
    """Return whether a recess ends too little above the middle of a core without a cavity, from where
    wires leave downwards in a hole of their own: the floor between both is too thin to print."""
    room, _ = body_of(spec).room_for_recesses
    if body_of(spec).on_base or spec.core.wall_mm < room:
        return False
    points = _points_of_recesses(spec)
    above = np.hypot(*points[:, :2].T) <= spec.core.wire_hole_side_diameter_mm / 2
    return bool(np.any(above & (points[:, 2] > 0) & (points[:, 2] < spec.printer.wall_mm)))


def thin_round_bore(spec: ObjectSpec) -> bool:
    """Return whether a side of the core that runs along its bore is too thin to print, as of a flat body's.

    Where the core slopes away from the bore by more than what rays take for a wall, it has an edge there.
    """
    turn = 2 * np.pi * np.arange(_ROUND) / _ROUND
    outward = np.column_stack([np.cos(turn), np.sin(turn), np.zeros(_ROUND)])
    heights = np.arange(-float(body_of(spec).core_half_mm[2]), 0.0, _ALONG_MM)
    rings = spec.body.bore_mm / 2 * outward + heights[:, None, None] * [0.0, 0.0, 1.0]
    points, outward = rings.reshape(-1, 3), np.tile(outward, (len(heights), 1))
    beyond = distance_beyond_core_mm(spec, points)
    thin = (beyond < 0) & (beyond > -spec.printer.wall_mm)
    points, outward, beyond = points[thin], outward[thin], beyond[thin]
    further = [distance_beyond_core_mm(spec, points + _STEP_MM * way) for way in np.eye(3)]
    normal = np.column_stack(further) - beyond[:, None]
    # Cosine between the core's outward normal (difference quotients of its distance) and the bore's
    # (i point, j coordinate).
    facing = np.einsum("ij,ij->i", normal, outward) / np.linalg.norm(normal, axis=1)
    return bool(np.any(facing > np.cos(np.deg2rad(_FACING_DEG))))


def tight_shell(spec: ObjectSpec) -> bool:
    """Return whether silicone over, under, between or next to the magnets' pockets is too thin to cast, or is
    not known, where a pocket reaches past its patch."""
    least = ROOMY * spec.silicone.thinnest_wall_mm
    placed = [
        (frame, pocket, axis_in_object_mm(frame, pocket))
        for frame, pockets in zip(face_frames(spec), shell_pockets(spec), strict=True)
        for pocket in pockets
    ]
    over = float(np.min(np.concatenate(shell_covers_mm(spec))))
    under = min(body_of(spec).silicone_mm + pocket.lowest_mm for _, pocket, _ in placed)
    radii = np.array([pocket.outline.radius_mm for _, pocket, _ in placed])
    between = smallest_gap_mm(np.stack([ends for *_, ends in placed]), radii)
    beside = min(_border_silicone_mm(frame, pocket) for frame, pocket, _ in placed)
    return not np.min([over, under, between, beside]) >= least


def tight_marks(spec: ObjectSpec) -> bool:
    """Return whether marks of polarity leave walls too thin to print on the templates of flat faces."""
    if not all(frame.flat for frame in face_frames(spec)):
        return False
    return thinnest_mark_wall_mm(spec) < spec.printer.wall_mm


def narrow_heads(spec: ObjectSpec) -> bool:
    """Return whether pins of a split mould stand so close that their heads rest on rims too narrow to
    print."""
    pins = loose_pins(spec) if mould_style(spec) == "split" else ()
    return bool(pins) and pins[0].rim_mm < least_rim_mm(spec)


def _border_silicone_mm(frame: FaceFrame, pocket: Pocket) -> float:
    """Silicone between a pocket and the border of a flat face, which on a pad ends in the air."""
    if not frame.flat:
        return np.inf
    ends, half = abs(pocket.axis_ends_mm[:, :2]), np.array(frame.half_extents_mm)
    away = half[0] - np.linalg.norm(ends, axis=1) if frame.round else half - ends
    return float(away.min()) - pocket.outline.radius_mm

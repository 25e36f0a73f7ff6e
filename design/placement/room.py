"""Gaps in core and shell that can be printed and cast, beyond what must fit."""

from __future__ import annotations

from itertools import combinations

import numpy as np

from design.fit.parts import beyond_core_mm
from design.layout.boards import passage_radius_mm, sensor_recesses, smallest_recess_wall_mm
from design.layout.body import body_of, face_frames
from design.layout.places.positions import cover_mm
from design.layout.pockets import distance_of_segments_mm, sensor_places, shell_pockets
from design.spec.object import ObjectSpec

_ROOMY = 1.25
"""Times the least that can be made, below which the checks of fabrication warn."""


def tight_core(spec: ObjectSpec, sunk: bool = True) -> bool:
    """Whether a wall between two recesses is too thin to print.

    Not `sunk`: as deep as on a flat core, which is quicker and never tighter.
    """
    sensors = sum(len(places) for places in sensor_places(spec))
    return sensors > 1 and smallest_recess_wall_mm(spec, sunk) < spec.printer.wall_mm


def tight_rim(spec: ObjectSpec) -> bool:
    """Whether a recess ends so near another side of the core that the wall there is too thin to print."""
    floors = [recess.corners_mm[:4] for recess in sensor_recesses(spec)]
    beyond = beyond_core_mm(spec, np.concatenate(floors))
    return bool(beyond.max() > -_ROOMY * spec.printer.wall_mm)


def tight_middle(spec: ObjectSpec) -> bool:
    """Whether a wall between a recess and the wire hole is too thin to print.

    A recess in the middle of its face swallows the hole.
    """
    core, least = spec.core, spec.printer.wall_mm
    hole = passage_radius_mm(spec)
    inward = spec.sensors.radius_mm - core.recess_inner_radius_mm
    away = [np.hypot(x, y) for places in sensor_places(spec) for x, y, _ in places]
    return any(0 < middle < hole + least + inward for middle in away)


def tight_shell(spec: ObjectSpec) -> bool:
    """Whether silicone over, under or between the magnets' pockets is too thin to cast."""
    least = _ROOMY * spec.silicone.thinnest_wall_mm
    placed = [
        (frame, pocket, frame.tangent(pocket.body.centre_mm[:2]).to_object(pocket.axis_ends_mm))
        for frame, pockets in zip(face_frames(spec), shell_pockets(spec), strict=True)
        for pocket in pockets
    ]
    over = min(cover_mm(frame, pocket.body) for frame, pocket, _ in placed)
    under = min(body_of(spec).silicone_mm + pocket.lowest_mm for _, pocket, _ in placed)
    between = min(
        (
            distance_of_segments_mm(ends, others) - a.outline.radius_mm - b.outline.radius_mm
            for (_, a, ends), (_, b, others) in combinations(placed, 2)
        ),
        default=np.inf,
    )
    return bool(min(over, under, between) < least)

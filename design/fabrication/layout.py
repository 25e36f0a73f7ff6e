"""Checks of fabrication that a layout of magnets and sensors decides, without a solid: milliseconds.

What of these fails is refused before anything is solved. Walls of the core are taken as planes leave
them, which is never thicker than what rays find in the printed part.
"""

from __future__ import annotations

import numpy as np

from design.fabrication.assembly import check_pockets
from design.fabrication.finding import Finding, place_of, status_above
from design.fit.boards import distance_beyond_core_mm
from design.fit.parts import distance_mm, recess_outline
from design.layout.boards import passage_radius_mm, sensor_recesses, smallest_recess_wall_mm
from design.layout.body import face_frames
from design.layout.pockets import (
    gaps_across_edge_mm,
    neighbours,
    pocket_ends,
    sensor_places,
    shell_pockets,
)
from design.layout.template_marks import thinnest_mark_wall_mm
from design.spec.object import ObjectSpec


def layout_findings(spec: ObjectSpec, recesses: bool = True) -> list[Finding]:
    """Silicone round the pockets, and with `recesses` walls of the core round these (boxes only).

    Recesses that meet leave no wall between them and can be printed, as on the paper's cube; here they
    fail, as a layout search keeps them apart.
    """
    findings = [*check_pockets(spec), *_edge_spacing(spec), *_marks(spec)]
    return findings + _recess_walls(spec) if recesses else findings


def failures(findings: list[Finding]) -> list[str]:
    """Return what fails, in words."""
    return [finding.told for finding in findings if finding.status == "fail"]


def _edge_spacing(spec: ObjectSpec) -> list[Finding]:
    """Silicone between pockets of neighbouring faces."""
    faces = {
        frame.number: pocket_ends(frame, pockets)
        for frame, pockets in zip(face_frames(spec), shell_pockets(spec), strict=True)
    }
    pairs = [(faces[a.number], faces[b.number]) for a, b in neighbours(face_frames(spec))]
    gaps_by_pair = [
        (gaps_across_edge_mm(a, b), a) for a, b in pairs if len(a.radii_mm) * len(b.radii_mm)
    ]
    if not gaps_by_pair:
        return []
    gaps, ones = min(gaps_by_pair, key=lambda pair: pair[0].min())
    gap, place = float(gaps.min()), ones.axes_mm[gaps.min(axis=1).argmin(), 0]
    text = "silicone between pockets of neighbouring faces. Below the limit: move them inwards"
    limit = spec.silicone.thinnest_wall_mm
    return [
        Finding(
            "pocket spacing across an edge",
            "shell",
            gap,
            limit,
            "mm",
            status_above(gap, limit),
            text,
            place_of(place),
        )
    ]


def _recess_walls(spec: ObjectSpec) -> list[Finding]:
    """Walls between recesses, from a recess to the next side of the core, and to the wire hole."""
    recesses = sensor_recesses(spec)
    floors = np.concatenate([recess.corners_mm[:4] for recess in recesses])
    findings = [
        _printed(
            spec,
            "wall beside a side of the core",
            -float(distance_beyond_core_mm(spec, floors).max()),
        )
    ]
    if len(recesses) > 1:
        wall = smallest_recess_wall_mm(spec)
        findings.append(_printed(spec, "wall between two recesses", wall))
    away = [
        distance_mm(recess_outline(spec, *place), np.zeros(2))
        for places in sensor_places(spec)
        for place in places
    ]
    beside = [distance - passage_radius_mm(spec) for distance in away if distance > 0]
    if beside:
        findings.append(_printed(spec, "wall beside the wire hole", min(beside)))
    return findings


def _printed(spec: ObjectSpec, check: str, wall_mm: float) -> Finding:
    limit = spec.printer.wall_mm
    text = f"core: {check}. Below the limit: move the sensors"
    return Finding(check, "core", wall_mm, limit, "mm", status_above(wall_mm, limit), text)


def _marks(spec: ObjectSpec) -> list[Finding]:
    """Walls of the magnets' template next to the marks of polarity."""
    wall, limit = thinnest_mark_wall_mm(spec), spec.printer.wall_mm
    text = "wall beside a mark of polarity. Below the limit: move magnets apart"
    status = status_above(wall, limit)
    return [Finding("mark of polarity", "magnet_template", wall, limit, "mm", status, text)]

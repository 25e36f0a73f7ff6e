"""Checks of single parts against the printer: walls, features, bed; and of resin against silicone."""

from __future__ import annotations

from math import floor
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float

from design.body.meshes import sharpest_edge, thinnest_wall
from design.build.parts import Part
from design.fabrication.finding import Finding, place_of, status_above
from design.fit.parts import ROOMY
from design.fit.seam import better_azimuth
from design.layout.blocks import core_keys, relief_slits
from design.layout.boards import all_wire_channels, wire_holes
from design.layout.body import face_frames
from design.layout.core_hold import has_mould, locators
from design.layout.mould.frame import mould_style
from design.layout.pockets import Pocket, shell_pockets
from design.spec.object import ObjectSpec

if TYPE_CHECKING:
    import trimesh

Point = Float[np.ndarray, "3"]
SHARPEST_DEG = 40.0
"""Angle of an edge below which there is a warning."""


def check_walls(
    part: Part, mesh: trimesh.Trimesh, spec: ObjectSpec, failures_alone: bool = False
) -> list[Finding]:
    """Thinnest wall of a printed or cast part; with `failures_alone` no seam is sought that mends a warning,
    which takes seconds."""
    wall = thinnest_wall(mesh)
    if wall is None:
        return []
    cast = part.material == "silicone"
    limit = spec.silicone.thinnest_wall_mm if cast else spec.printer.wall_mm
    advice = "move pockets and slits apart" if cast else "thicken it, or move what thins it"
    if part.name.startswith("mould_half"):
        enough = limit if failures_alone else ROOMY * limit
        azimuth = better_azimuth(spec) if wall.thickness_mm < enough else None
        value = "" if azimuth is None else f" = {azimuth:g}"
        turned = f"turn the seam (mould.parting_azimuth_deg{value})"
        advice += f", or {turned} away from holes of pins that it grazes"
    return [
        Finding(
            "thinnest wall",
            part.name,
            wall.thickness_mm,
            limit,
            "mm",
            status_above(wall.thickness_mm, limit, ROOMY),
            f"thinnest {'silicone' if cast else 'printed'} wall, measured by rays. Below "
            f"{ROOMY:g} times the limit: {advice}",
            place_of(wall.place_mm),
        )
    ]


def check_edges(part: Part, mesh: trimesh.Trimesh) -> list[Finding]:
    """Knife edges: where two cuts leave a wedge that prints as a ragged fin."""
    edge = sharpest_edge(mesh)
    if edge is None:
        return []
    return [
        Finding(
            "sharpest edge",
            part.name,
            edge[0],
            SHARPEST_DEG,
            "°",
            "pass" if edge[0] >= SHARPEST_DEG - 1e-6 else "warn",
            "least angle of material at an edge. Below the limit it prints ragged or breaks off: let "
            "the two cuts overlap more, or keep them apart",
            place_of(edge[1]),
        )
    ]


def check_bed(part: Part, mesh: trimesh.Trimesh, spec: ObjectSpec) -> list[Finding]:
    """Return whether a printed part fits the bed in some upright position."""
    if part.material != "printed":
        return []
    room = [limit - edge for limit, edge in zip(*_rising(spec.printer.bed_mm, mesh), strict=True)]
    least = min(room)
    return [
        Finding(
            "fits the bed",
            part.name,
            least,
            0.0,
            "mm",
            status_above(least, 0.0),
            "room left on the printer's bed, turned as fits best. Below the limit: split the part or "
            "take a larger printer",
        )
    ]


def _rising(
    bed_mm: tuple[float, float, float], mesh: trimesh.Trimesh
) -> tuple[list[float], list[float]]:
    return sorted(bed_mm), sorted(float(edge) for edge in mesh.extents)


def check_features(spec: ObjectSpec) -> list[Finding]:
    """Holes, channels, keys, fins and bosses against what the printer resolves.

    Places are in the object's frame: of the first of features that are alike.
    """
    core, printer = spec.core, spec.printer
    findings = list[Finding]()
    for key, hole in wire_holes(spec).items():
        name, least = f"wire hole, {'top' if 'top' in key else 'sides'}", printer.hole_mm
        findings.append(_feature(name, "core", hole.diameter_mm, least, f"core.{key}", hole.end_mm))
    if width := core.wire_channel_mm[0]:
        key, channels = "a width in core.wire_channel_mm", all_wire_channels(spec)
        place = channels[0].centre_mm if channels else None
        findings.append(_feature("wire channel", "core", width, printer.hole_mm, key, place))
    if core.keys.positions_mm:
        *edges, height = core.keys.size_mm
        narrow, name, place = min(edges), "anti-slip key", core_keys(spec)[0].centre_mm
        findings += [
            _feature(name, "core", narrow, printer.wall_mm, "core.keys.size_mm", place),
            _aspect(name, "core", height, narrow, spec, place, "a height in core.keys.size_mm"),
        ]
    findings += _fins(spec) if spec.shell.slits.depth_mm else []
    return findings + (_bosses(spec) + _holding(spec) if has_mould(spec) else [])


def _fins(spec: ObjectSpec) -> list[Finding]:
    """Fins of the mould that form the shell's slits."""
    slits, part, name = spec.shell.slits, _mould(spec), "fin of a slit"
    place, wide = relief_slits(spec)[0].centre_mm, slits.width_mm
    return [
        _feature(name, part, wide, spec.printer.wall_mm, "shell.slits.width_mm", place),
        _aspect(name, part, slits.depth_mm, wide, spec, place, "shell.slits.depth_mm"),
    ]


def _holding(spec: ObjectSpec) -> list[Finding]:
    """Pins that hold the core of a closed body."""
    return [
        _aspect(
            "locating pin",
            f"mould_locator_{k}",
            locator.depth_mm,
            2 * locator.radius_mm,
            spec,
            locator.frame.centre_mm,
        )
        for k, locator in enumerate(locators(spec), start=1)
    ]


def _bosses(spec: ObjectSpec) -> list[Finding]:
    """The narrowest and the most slender of all that form pockets."""
    part = "mould_box" if mould_style(spec) == "one-piece" else "mould_pin"
    placed = [
        (pocket, frame.to_object(pocket.axis_ends_mm[0]))
        for frame, pockets in zip(face_frames(spec), shell_pockets(spec), strict=True)
        for pocket in pockets
    ]

    def width(pocket: Pocket) -> float:
        return 2 * min(pocket.outline.half_mm)

    def slender(pocket: Pocket) -> float:
        high = -pocket.axis_ends_mm[0, 2] - spec.shell.seal_layer_mm
        return float(high / pocket.axis[2] / width(pocket))

    narrow, narrow_mm = min(placed, key=lambda boss: width(boss[0]))
    tall, tall_mm = max(placed, key=lambda boss: slender(boss[0]))
    key, name, least = "shell.pocket_diameter_mm", "boss of a pocket", spec.printer.wall_mm
    return [
        _feature(name, part, width(narrow), least, key, narrow_mm),
        _aspect(name, part, slender(tall), 1.0, spec, tall_mm),
    ]


def _mould(spec: ObjectSpec) -> str:
    return "mould_box" if mould_style(spec) == "one-piece" else "mould_half_a"


def _feature(
    what: str, part: str, value: float, limit: float, key: str, at_mm: Point | None
) -> Finding:
    text = (
        f"{what}: width. Below what the printer resolves it closes or breaks: make it wider ({key} of "
        f"{limit:g} or more)"
    )
    place, status = None if at_mm is None else place_of(at_mm), status_above(value, limit)
    return Finding("smallest feature", part, value, limit, "mm", status, text, place)


def _aspect(
    what: str,
    part: str,
    height: float,
    width: float,
    spec: ObjectSpec,
    at_mm: Point,
    key: str = "",
) -> Finding:
    limit, value = spec.printer.preset.aspect, height / width
    status = "pass" if value <= limit else "warn"
    most = f" ({key} of {floor(100 * limit * width + 1e-6) / 100:g} or less)" if key else ""
    text = f"{what}: height over width. Beyond the limit it may break off: make it wider or lower{most}"
    return Finding("slenderness", part, value, limit, "", status, text, place_of(at_mm))


def check_inhibition(spec: ObjectSpec) -> list[Finding]:
    """Platinum-cured silicone stays sticky on resin prints."""
    risky = spec.printer.preset.process == "resin" and spec.silicone.cure == "platinum"
    text = (
        f"{spec.silicone.name} cures by platinum, which residues of printed resin inhibit: wash, cure "
        "under UV and bake the mould (60 °C, some hours), coat it, or print it by FDM; test first"
        if risky
        else f"{spec.silicone.name} ({spec.silicone.cure}) cures on {spec.printer.preset.process} prints"
    )
    status = "warn" if risky else "pass"
    return [Finding("inhibition of the cure", "mould", float(risky), 0.0, "", status, text)]

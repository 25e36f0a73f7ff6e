"""Checks of single parts against the printer: walls, features, bed; and of resin against silicone."""

from __future__ import annotations

from math import floor
from typing import TYPE_CHECKING

from design.body.meshes import sharpest_edge, thinnest_wall
from design.build.parts import Part
from design.fabrication.finding import Finding, at_least, place_of
from design.layout.core_hold import locators
from design.layout.mould.frame import mould_style
from design.layout.pockets import shell_pockets
from design.mould.whole import has_mould
from design.spec.object import ObjectSpec

if TYPE_CHECKING:
    import trimesh

_TIGHT = 1.25
SHARPEST_DEG = 40.0


def check_walls(part: Part, mesh: trimesh.Trimesh, spec: ObjectSpec) -> list[Finding]:
    """Thinnest wall of a printed or cast part."""
    wall = thinnest_wall(mesh)
    if wall is None:
        return []
    cast = part.material == "silicone"
    limit = spec.silicone.thinnest_wall_mm if cast else spec.printer.wall_mm
    advice = "move pockets and slits apart" if cast else "thicken it, or move what thins it"
    return [
        Finding(
            "thinnest wall",
            part.name,
            wall.thickness_mm,
            limit,
            "mm",
            at_least(wall.thickness_mm, limit, _TIGHT),
            f"thinnest {'silicone' if cast else 'printed'} wall, measured by rays. Below "
            f"{_TIGHT:g} times the limit: {advice}",
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
    """Whether a printed part fits the bed in some upright position."""
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
            at_least(least, 0.0),
            "room left on the printer's bed, turned as fits best. Below the limit: split the part or "
            "take a larger printer",
        )
    ]


def _rising(
    bed_mm: tuple[float, float, float], mesh: trimesh.Trimesh
) -> tuple[list[float], list[float]]:
    return sorted(bed_mm), sorted(float(edge) for edge in mesh.extents)


def check_features(spec: ObjectSpec) -> list[Finding]:
    """Holes, channels, keys, fins and bosses against what the printer resolves."""
    core, printer, slits = spec.core, spec.printer, spec.shell.slits
    found = [
        _feature(f"wire hole, {where}", "core", getattr(core, key), printer.hole_mm, f"core.{key}")
        for where, key in (
            ("top", "wire_hole_top_diameter_mm"),
            ("sides", "wire_hole_side_diameter_mm"),
        )
    ]
    if width := core.wire_channel_width_mm:
        key = "core.wire_channel_width_mm"
        found.append(_feature("wire channel", "core", width, printer.hole_mm, key))
    if core.keys.positions_mm:
        narrow, name = min(core.keys.size_mm), "anti-slip key"
        found += [
            _feature(name, "core", narrow, printer.feature_mm, "core.keys.size_mm"),
            _aspect(name, "core", core.keys.height_mm, narrow, spec, "core.keys.height_mm"),
        ]
    if slits.depth_mm:
        part, name, wide = _mould(spec), "fin of a slit", slits.width_mm
        found += [
            _feature(name, part, wide, printer.wall_mm, "shell.slits.width_mm"),
            _aspect(name, part, slits.depth_mm, wide, spec, "shell.slits.depth_mm"),
        ]
    return found + (_bosses(spec) + _holding(spec) if has_mould(spec) else [])


def _holding(spec: ObjectSpec) -> list[Finding]:
    """Pins that hold the core of a closed body, and vents."""
    found = [
        _aspect("locating pin", f"mould_locator_{k}", locator.depth_mm, 2 * locator.radius_mm, spec)
        for k, locator in enumerate(locators(spec), start=1)
    ]
    if spec.mould.vent_mm is not None:
        wide = spec.mould.vent_mm
        found.append(_feature("vent", "mould", wide, spec.printer.hole_mm, "mould.vent_mm"))
    return found


def _bosses(spec: ObjectSpec) -> list[Finding]:
    part = "mould_box" if mould_style(spec) == "one-piece" else "mould_pin"
    pockets = [pocket for face in shell_pockets(spec) for pocket in face]
    narrow = min(2 * min(pocket.outline.half_mm) for pocket in pockets)
    slender = max(
        (-pocket.axis_ends_mm[0, 2] - spec.shell.seal_layer_mm)
        / pocket.axis[2]
        / (2 * min(pocket.outline.half_mm))
        for pocket in pockets
    )
    return [
        _feature(
            "boss of a pocket", part, narrow, spec.printer.feature_mm, "shell.pocket_diameter_mm"
        ),
        _aspect("boss of a pocket", part, float(slender), 1.0, spec),
    ]


def _mould(spec: ObjectSpec) -> str:
    return "mould_box" if mould_style(spec) == "one-piece" else "mould_half_a"


def _feature(what: str, part: str, value: float, limit: float, key: str) -> Finding:
    text = (
        f"{what}: width. Below what the printer resolves it closes or breaks: make it wider ({key} of "
        f"{limit:g} or more)"
    )
    return Finding("smallest feature", part, value, limit, "mm", at_least(value, limit), text)


def _aspect(
    what: str, part: str, height: float, width: float, spec: ObjectSpec, key: str = ""
) -> Finding:
    limit, value = spec.printer.aspect, height / width
    status = "pass" if value <= limit else "warn"
    most = f" ({key} of {floor(100 * limit * width + 1e-6) / 100:g} or less)" if key else ""
    text = f"{what}: height over width. Beyond the limit it may break off: make it wider or lower{most}"
    return Finding("slenderness", part, value, limit, "", status, text)


def check_inhibition(spec: ObjectSpec) -> list[Finding]:
    """Platinum-cured silicone stays sticky on resin prints."""
    risky = spec.printer.process == "resin" and spec.silicone.cure == "platinum"
    text = (
        f"{spec.silicone.name} cures by platinum, which residues of printed resin inhibit: wash, cure "
        "under UV and bake the mould (60 °C, some hours), coat it, or print it by FDM; test first"
        if risky
        else f"{spec.silicone.name} ({spec.silicone.cure}) cures on {spec.printer.process} prints"
    )
    status = "warn" if risky else "pass"
    return [Finding("inhibition of the cure", "mould", float(risky), 0.0, "", status, text)]

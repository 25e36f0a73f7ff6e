"""Checks of what goes together: pockets in the silicone, boards and wires in the core, play."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations
from math import ceil
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from design.body.meshes import manifold_of
from design.body.surface_chart import FaceFrame
from design.fabrication.finding import Finding, place_of, status_above
from design.fit.parts import ROOMY
from design.layout.blocks import block_manifold
from design.layout.boards import (
    Mounted,
    count_wires,
    hole_for_wires_mm,
    mounted_sensors,
    wire_bundle_mm,
    wire_holes,
    wires_through,
)
from design.layout.body import body_of, face_frames
from design.layout.core_hold import FLAT_SHARE, core_outlet, locators
from design.layout.places.positions import cover_mm
from design.layout.pockets import (
    Pocket,
    axis_in_object_mm,
    distance_of_segments_mm,
    shell_pockets,
)
from design.solids.body import core_hollow
from design.spec.object import ObjectSpec

if TYPE_CHECKING:
    import trimesh

Named: TypeAlias = "tuple[str, trimesh.Trimesh]"

TOUCHING_MM3 = 1e-3
"""Common volume above which two bodies are said to interfere."""
MATING_MM3 = 1.0
"""Common volume of two parts that touch: their triangles leave curved surfaces by 5 µm."""


def check_pockets(spec: ObjectSpec) -> list[Finding]:
    """Silicone between pockets of a face, under the deepest pocket, and over the magnets."""
    faces = list(zip(face_frames(spec), shell_pockets(spec), strict=True))
    findings = [_spacing(spec, frame, face) for frame, face in faces if len(face) > 1]
    frame, deepest = min(
        ((frame, pocket) for frame, face in faces for pocket in face),
        key=lambda pair: pair[1].lowest_mm,
    )
    limit, thickness = spec.silicone.thinnest_wall_mm, spec.shell.thickness_mm
    below_mm = thickness + deepest.lowest_mm
    text = "silicone under the deepest pocket. Below 1.25 times the limit: seat the magnet higher"
    place = place_of(frame.to_object(deepest.axis_ends_mm[0]))
    findings.append(_silicone("breakthrough", below_mm, limit, text, place))
    return [*min_by_value(findings), _seal(spec, faces)]


def min_by_value(findings: list[Finding]) -> list[Finding]:
    """Keep the finding with the smallest value of every check."""
    least: dict[str, Finding] = {}
    for finding in findings:
        smallest = least.get(finding.check)
        if smallest is None or finding.value < smallest.value:
            least[finding.check] = finding
    return list(least.values())


def _spacing(spec: ObjectSpec, frame: FaceFrame, pockets: tuple[Pocket, ...]) -> Finding:
    placed = [(pocket, axis_in_object_mm(frame, pocket)) for pocket in pockets]
    gap, a, b, middle = min(
        (
            (
                distance_of_segments_mm(ends, others) - a.outline.radius_mm - b.outline.radius_mm,
                a,
                b,
                (ends + others).mean(axis=0) / 2,
            )
            for (a, ends), (b, others) in combinations(placed, 2)
        ),
        key=lambda pair: pair[0],
    )
    return _silicone(
        "pocket spacing",
        gap,
        spec.silicone.thinnest_wall_mm,
        f"silicone between the pockets of {a.body.label} and {b.body.label}. Below 1.25 times the limit: "
        "move them apart",
        place_of(middle),
    )


def _seal(spec: ObjectSpec, faces: list[tuple[FaceFrame, tuple[Pocket, ...]]]) -> Finding:
    def cover(pair: tuple[FaceFrame, Pocket]) -> float:
        return cover_mm(pair[0], pair[1].body)

    frame, thinnest = min(((f, p) for f, face in faces for p in face), key=cover)
    return _silicone(
        "seal over the magnets",
        cover((frame, thinnest)),
        spec.silicone.thinnest_wall_mm,
        "silicone over the highest magnet or board. Below 1.25 times the limit it may tear off: seat "
        "it deeper",
        place_of(frame.to_object(thinnest.body.centre_mm)),
    )


def _silicone(check: str, value: float, limit: float, text: str, place) -> Finding:
    value = float(value)
    return Finding(
        check, "shell", value, limit, "mm", status_above(value, limit, ROOMY), text, place
    )


def check_electronics(spec: ObjectSpec, core: trimesh.Trimesh) -> list[Finding]:
    """Boards and chips against the core and each other, and wires against their holes."""
    mounted = mounted_sensors(spec)
    findings = [check_wires(spec), *_way_out(spec)]
    if not mounted:
        return findings
    return [*findings, *check_fits(spec), *interference(mounted, core), *collisions(mounted)]


def check_wires(spec: ObjectSpec) -> Finding:
    bundle, holes = wire_bundle_mm(spec), wire_holes(spec)
    key = min(holes, key=lambda name: holes[name].diameter_mm)
    room = holes[key].diameter_mm - bundle
    return Finding(
        "wires in their hole",
        "core",
        room,
        0.0,
        "mm",
        status_above(room, 0.0),
        f"the narrowest hole less the bundle of {bundle:.2f} mm of a face's wires. Below the limit: "
        f"widen core.{key} to {_up(bundle):g} or take thinner wires",
        place_of(holes[key].end_mm),
    )


def _way_out(spec: ObjectSpec) -> list[Finding]:
    """All wires of the object against what leads them out; none of a base, whose wire hole does."""
    body, core, wires = body_of(spec), spec.core, count_wires(spec)
    if body.on_base:
        return []
    key, wider = "core.wire_hole_side_diameter_mm", 1.0
    if body.opening == "bore":
        key, wider = "body.bore_mm", 2 / (1 + FLAT_SHARE)
        ways, outlet = [(1 + FLAT_SHARE) * core_outlet(spec).radius_mm], "the core's outlet"
    elif body.opening == "closed":
        ways, outlet = [2 * pin.radius_mm for pin in locators(spec)], "the holes of locating pins"
    elif core_hollow(spec):
        key = "core.wall_mm"
        ways = [2 * float((body.core_half_mm - core.wall_mm).min())]
        outlet = "the core's cavity"
    else:
        ways, outlet = [core.wire_hole_side_diameter_mm] * len(spec.body.opened), "the open faces"
    room = float(sum(wires_through(way, spec) for way in ways) - wires)
    least = wider * hole_for_wires_mm(ceil(wires / max(len(ways), 1)), spec)
    fix = "lower core.wall_mm" if key == "core.wall_mm" else f"raise {key} to {_up(least):g}"
    text = (
        f"wires that fit through {outlet} less the object's {wires}. Below the limit: {fix}, take thinner "
        "wires, or fewer (core.wires_per_sensor) where sensors share supply and bus"
    )
    status = status_above(room, 0.0)
    return [Finding("wires in their way out", "core", room, 0.0, "wires", status, text)]


def _up(value: float) -> float:
    """Rounded up to hundredths."""
    return ceil(100 * value - 1e-6) / 100


def check_fits(spec: ObjectSpec) -> list[Finding]:
    """Room of the board in its recess: across, along, and for chip and board in its depth."""
    core, sensors = spec.core, spec.sensors
    width, length, thick = sensors.package_mm
    radial = core.recess_outer_radius_mm - core.recess_inner_radius_mm
    stack = thick + sensors.chip_mm[2]
    rooms = {
        "across": (core.recess_width_mm - width) / 2,
        "along": (radial - length) / 2,
        "deep": core.recess_depth_mm - stack,
    }
    place = place_of(mounted_sensors(spec)[0].chip.centre_mm)
    return [
        Finding(
            f"board in its recess, {way}",
            "core",
            room,
            0.0,
            "mm",
            "fail" if room < -1e-9 else status_above(room, 0.0) if room > 0.02 else "warn",
            f"room of board and chip in the recess ({way}). Below the limit they do not go in: change "
            "core.recess_* or the board",
            place,
        )
        for way, room in rooms.items()
    ]


def interference(mounted: Sequence[Mounted], core: trimesh.Trimesh) -> list[Finding]:
    """The board or chip that shares most volume with the core."""
    solid = manifold_of(core)
    shares = [
        ((solid ^ block_manifold(block)).volume(), sensor, block)
        for sensor in mounted
        for block in (sensor.board, sensor.chip)
    ]
    volume, sensor, block = max(shares, key=lambda share: share[0])
    return [
        Finding(
            "boards and chips clear of the core",
            "core",
            volume,
            TOUCHING_MM3,
            "mm³",
            "pass" if volume <= TOUCHING_MM3 else "fail",
            f"largest common volume of a board or chip with the core ({sensor.label}). Above the "
            "limit: deepen or widen the recess, or move the sensor",
            place_of(block.centre_mm),
        )
    ]


def collisions(mounted: Sequence[Mounted]) -> list[Finding]:
    """Largest common volume of the boards and chips of two sensors."""
    worst, place, names = 0.0, None, ""
    for a, b in combinations(mounted, 2):
        for block_a in (a.board, a.chip):
            for block_b in (b.board, b.chip):
                reach = float(sum(block_a.half_mm**2) ** 0.5 + sum(block_b.half_mm**2) ** 0.5)
                if float(sum((block_a.centre_mm - block_b.centre_mm) ** 2) ** 0.5) > reach:
                    continue
                common = (block_manifold(block_a) ^ block_manifold(block_b)).volume()
                if common > worst:
                    worst, names = common, f"{a.label} and {b.label}"
                    place = place_of((block_a.centre_mm + block_b.centre_mm) / 2)
    return [
        Finding(
            "boards clear of each other",
            "core",
            worst,
            TOUCHING_MM3,
            "mm³",
            "pass" if worst <= TOUCHING_MM3 else "fail",
            f"largest common volume of two sensors' boards or chips{f' ({names})' if names else ''}. "
            "Above the limit: move one of them",
            place,
        )
    ]


def largest_common(check: str, part: str, pairs: list[tuple[Named, Named]], text: str) -> Finding:
    """The finding of the two parts, of some pairs, that share most volume; `text` says what to do."""
    worst, names, place = 0.0, "", None
    meshes = {id(mesh): mesh for pair in pairs for _, mesh in pair}
    solids = {key: manifold_of(mesh) for key, mesh in meshes.items()}
    for (a, mesh_a), (b, mesh_b) in pairs:
        if (mesh_a.bounds[0] > mesh_b.bounds[1]).any() or (
            mesh_b.bounds[0] > mesh_a.bounds[1]
        ).any():
            continue
        common = solids[id(mesh_a)] ^ solids[id(mesh_b)]
        if common.volume() > worst:
            worst, names = common.volume(), f"; most: {a} and {b}"
            place = place_of(np.reshape(common.bounding_box(), (2, 3)).mean(axis=0))
    status = "pass" if worst <= MATING_MM3 else "fail"
    return Finding(check, part, worst, MATING_MM3, "mm³", status, f"{text}{names}", place)

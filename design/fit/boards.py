"""Fit of boards, chips and their recesses with the core and with each other."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations, product
from typing import TYPE_CHECKING

import numpy as np

from design.fit.parts import distance_mm, recess_outline
from design.layout.boards import Mounted, gap_mm, mounted_sensors, sensor_recesses
from design.layout.body import body_of
from design.layout.pockets import sensor_places

if TYPE_CHECKING:
    from design.spec.object import ObjectSpec

_TOUCHING_MM = 0.01
_FLUSH_MM = 0.05
"""Height by which a board may stand above the core: offsets of triangles are known to that."""
_EXACT_MM = 1e-6
"""Rounding that is no violation."""


def check_boards(spec: ObjectSpec) -> Iterator[str]:
    """Yield what of them does not fit; nothing where the boards lie in the shell."""
    if spec.arrangement == "sensors-in-core":
        yield from _check_recesses_off_passages(spec)
        yield from _check_boards_in_core(spec)
        yield from _check_boards_in_recesses(spec)
        yield from _check_boards_apart(spec)


def _check_recesses_off_passages(spec: ObjectSpec) -> Iterator[str]:
    """A recess may run into the hub or the wire hole, or stay clear of it, but not touch it in a line."""
    core, beside = spec.core, np.zeros(2)
    passages = {
        "half of core.wire_hole_top_diameter_mm": core.wire_hole_top_diameter_mm / 2,
        "half of core.wire_hole_side_diameter_mm": core.wire_hole_side_diameter_mm / 2,
    }
    for places in sensor_places(spec):
        for x, y, azimuth in places:
            near = distance_mm(recess_outline(spec, x, y, azimuth), beside)
            for name, radius in passages.items():
                if abs(near - radius) < _TOUCHING_MM:
                    yield (
                        f"a sensor's recess begins {near:.4g} mm from the middle of the core's face, just "
                        f"where {name} = {radius:g} ends: they would touch in a line. Move "
                        f"core.recess_inner_radius_mm, or that radius, by {_TOUCHING_MM:g} mm or more"
                    )


def _check_boards_in_core(spec: ObjectSpec) -> Iterator[str]:
    """Boards and chips wholly in the core, floors of recesses below its surface."""
    for mounted, recess in zip(mounted_sensors(spec), sensor_recesses(spec), strict=True):
        for what, corners in (
            ("the board", mounted.board.corners_mm),
            ("the chip", mounted.chip.corners_mm),
            ("the recess", recess.corners_mm[:4]),
        ):
            if not np.isfinite(corners).all():
                break  # beyond its patch, which is told with the sinking of boards
            beyond = distance_beyond_core_mm(spec, corners)
            worst = int(np.argmax(beyond))
            if beyond[worst] > _FLUSH_MM:
                place = ", ".join(f"{float(p):.3g}" for p in corners[worst])
                yield (
                    f"{what} of {mounted.label} reaches {float(beyond[worst]):.3g} mm out of the core at "
                    f"({place}). Move the sensor inwards by more than that (sensors.radius_mm, "
                    "sensors.positions_mm), or take a smaller board or recess"
                )
                break


def _check_boards_in_recesses(spec: ObjectSpec) -> Iterator[str]:
    """Board and chip within the recess, which is alike at every sensor."""
    core, sensors = spec.core, spec.sensors
    width, length, thick = sensors.package_mm
    chip_width, chip_length, high = sensors.chip_mm
    inner, outer = core.recess_inner_radius_mm, core.recess_outer_radius_mm
    widest, deepest = max(width, chip_width), thick + high
    if core.recess_width_mm < widest - _EXACT_MM:
        yield (
            f"core.recess_width_mm = {core.recess_width_mm:g} is narrower than board and chip of "
            f"{widest:g} mm (sensors.package_mm, chip_mm). Make it {widest:g} or more, or take a "
            "smaller board"
        )
    if outer - inner < length - _EXACT_MM:
        yield (
            f"core.recess_inner_radius_mm = {inner:g} and recess_outer_radius_mm = {outer:g} leave "
            f"{outer - inner:.4g} mm along the board of {length:g} mm (sensors.package_mm). Make the "
            f"outer one {inner + length:.4g} or more, or take a smaller board"
        )
    if core.recess_depth_mm < deepest - _EXACT_MM:
        yield (
            f"core.recess_depth_mm = {core.recess_depth_mm:g} is shallower than board and chip, which are "
            f"{thick:g} + {high:g} mm high (sensors.package_mm, chip_mm). Make it {deepest:.4g} or more, or "
            "take a thinner board"
        )
    low, top = sensors.radius_mm - chip_length / 2, sensors.radius_mm + chip_length / 2
    if low < inner - _EXACT_MM or top > outer + _EXACT_MM:
        yield (
            f"the chip reaches from {low:.4g} to {top:.4g} mm from the middle of the face (sensors."
            f"radius_mm ± half of chip_mm), its recess from {inner:g} to {outer:g}. Move core."
            f"recess_inner_radius_mm to {min(inner, low):.4g} and recess_outer_radius_mm to "
            f"{max(outer, top):.4g}, or the sensors"
        )


def _check_boards_apart(spec: ObjectSpec) -> Iterator[str]:
    """No board or chip in the room of another one of its face; pairs alike on several faces once."""
    overlaps: dict[str, list[tuple[int, float]]] = {}
    for a, b, common in _meeting(spec):
        if a.face == b.face:
            overlaps.setdefault(f"{a.number} and {b.number}", []).append((a.face, common))
    for numbers, cases in overlaps.items():
        faces = [str(face) for face, _ in cases]
        yield (
            f"the boards of sensors {numbers} on face{'s' * (len(faces) > 1)} {', '.join(faces)} meet, by "
            f"{max(common for _, common in cases):.3g} mm. Move one of them away by more than that "
            "(sensors.radius_mm, sensors.positions_mm), or take smaller boards"
        )


def boards_across_edges(spec: ObjectSpec) -> str | None:
    """Boards of two faces that meet in the core, in words; None where there are none.

    Such an object can be simulated, as layouts under search are, but not built.
    """
    pairs = [(a, b, common) for a, b, common in _meeting(spec) if a.face != b.face]
    if not pairs:
        return None
    meeting_boards = ", ".join(
        f"{a.label} and {b.label} (by {common:.3g} mm)" for a, b, common in pairs
    )
    return (
        f"boards of two faces meet in the core: {meeting_boards}. The object can be simulated, but not "
        "built. Move sensors inwards or turn them (sensors.positions_mm, first_azimuth_deg), "
        "or take smaller boards"
    )


def _meeting(spec: ObjectSpec) -> Iterator[tuple[Mounted, Mounted, float]]:
    """Pairs of sensors one of which has board or chip in the other's room, and by how much."""
    mounted = mounted_sensors(spec)
    if not mounted:
        return
    corners = np.concatenate([mounted[0].board.corners_mm, mounted[0].chip.corners_mm])
    reach = float(np.linalg.norm(corners - mounted[0].board.centre_mm, axis=1).max())
    for a, b in combinations(mounted, 2):
        if np.linalg.norm(a.board.centre_mm - b.board.centre_mm) > 2 * reach:
            continue
        pairs = product((a.board, a.chip), (b.board, b.chip))
        common = -min(gap_mm(block_a, block_b) for block_a, block_b in pairs)
        if common > _EXACT_MM:
            yield a, b, common


def distance_beyond_core_mm(spec: ObjectSpec, points_mm: np.ndarray) -> np.ndarray:
    """Return how far points lie outside the core, or the base with its border (mm)."""
    body = body_of(spec)
    beside = np.max(abs(points_mm) - body.half_mm, axis=1)
    return np.maximum(body.core_distance_mm(points_mm), beside)

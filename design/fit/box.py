"""Fit of a box: core, pockets, sensors and presses."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice
from math import cos, floor, sin
from typing import TYPE_CHECKING

from design.fit.magnet_places import MOST_TOLD
from design.fit.nearest import excess
from design.layout.boards import passage_radius_mm
from design.layout.body import core_frames, face_frames
from design.layout.places.contact_places import LEAST_COUNT, place_problems
from design.layout.pockets import (
    Pocket,
    core_pockets,
    near_pairs,
    sensor_places,
    shell_pockets,
)
from design.spec.body import HUB_DEPTH_MM

if TYPE_CHECKING:
    from design.spec.object import ObjectSpec

_NO_WIRES_MM = 0.5
"""Radius of a hole through which no sensor's wires go."""


def check_box(spec: ObjectSpec) -> Iterator[str]:
    """Yield what does not fit in a box that has room for its core."""
    yield from _check_recesses(spec)
    yield from _check_wire_passages(spec)
    yield from _check_pockets(spec)
    yield from _check_core_contents(spec)


def _smallest_half_extents_mm(spec: ObjectSpec) -> tuple[float, float]:
    """Half extents (x, y) that every sensed face of the body offers, in the face's own axes."""
    half_x, half_y = zip(*(frame.half_extents_mm for frame in face_frames(spec)), strict=True)
    return min(half_x), min(half_y)


def check_box_core(spec: ObjectSpec) -> Iterator[str]:
    """Yield a problem where there is no room for a core."""
    smallest = min(spec.core_size_mm)
    if smallest <= 2 * spec.core.wall_mm:
        yield (
            f"the core must be larger than two core walls ({2 * spec.core.wall_mm:g} mm); got a core "
            f"of {smallest:g} mm. Make the body larger than "
            f"{2 * (spec.shell.thickness_mm + spec.core.wall_mm):g} mm, or shell.thickness_mm or "
            f"core.wall_mm smaller by more than {spec.core.wall_mm - smallest / 2:.4g} mm"
        )


def _check_recesses(spec: ObjectSpec) -> Iterator[str]:
    core, half = spec.core, min(spec.core_size_mm) / 2
    if core.recess_depth_mm >= core.wall_mm:
        yield (
            f"core.recess_depth_mm must be below core.wall_mm = {core.wall_mm:g}; got "
            f"{core.recess_depth_mm:g}. Make the recess shallower or the wall thicker"
        )
    inner, outer = core.recess_inner_radius_mm, core.recess_outer_radius_mm
    if spec.sensors.positions_mm is not None and not inner < outer:
        yield (
            "core recesses must satisfy recess_inner_radius_mm < recess_outer_radius_mm; got "
            f"{inner:g} and {outer:g}. Make the outer one larger"
        )
    elif spec.sensors.positions_mm is None and not inner < outer < half:
        yield (
            "core recesses must satisfy recess_inner_radius_mm < recess_outer_radius_mm < half the "
            f"core ({half:g} mm); got {inner:g} and {outer:g}. Move the recess inwards"
        )


def _check_wire_passages(spec: ObjectSpec) -> Iterator[str]:
    core, smallest = spec.core, min(spec.core_size_mm)
    if core.wall_mm <= HUB_DEPTH_MM:
        yield (
            f"core.wall_mm must be above the hub recess's depth of {HUB_DEPTH_MM:g} mm; got "
            f"{core.wall_mm:g}. Make the wall thicker"
        )
    # The cavity is the narrowest across two walls; a side hole must also clear the top wall.
    room = smallest - 2 * core.wall_mm
    widest = max(core.wire_hole_top_diameter_mm, core.wire_hole_side_diameter_mm)
    if widest >= room:
        yield (
            f"core.wire_hole_*_diameter_mm must be below the core's cavity, {room:g} mm wide; got "
            f"{widest:g}. Use a smaller hole or thinner core walls"
        )


def _check_pockets(spec: ObjectSpec) -> Iterator[str]:
    shell = spec.shell
    if shell.pocket_depth_mm >= shell.thickness_mm:
        yield (
            f"shell.pocket_depth_mm must be below shell.thickness_mm = {shell.thickness_mm:g}; got "
            f"{shell.pocket_depth_mm:g}. Make the pocket shallower or the shell thicker"
        )
    for frame, face in zip(face_frames(spec), shell_pockets(spec), strict=True):
        half = frame.half_extents_mm
        for index, pocket in enumerate(face):
            yield from _check_body_in_pocket(spec, pocket)
            yield from _check_sealed(spec, index, pocket)
            if (pocket.reach_mm >= half).any():
                at_most = [h - r + abs(c) for h, r, c in _columns(half, pocket)]
                yield (
                    f"{pocket.body.label} puts its pocket of radius {pocket.outline.radius_mm:g} mm "
                    f"outside the shell's face (±{half[0]:g}, ±{half[1]:g} mm). Move it inwards, to "
                    f"|x| below {at_most[0]:.4g}, |y| below {at_most[1]:.4g} mm"
                )
        yield from _check_pockets_apart(face)
    halves = [frame.half_extents_mm for frame in face_frames(spec)]
    yield from _check_pockets_across_edges(shell_pockets(spec), halves, "shell")


def _check_body_in_pocket(spec: ObjectSpec, pocket: Pocket) -> Iterator[str]:
    body, depth = pocket.body, spec.shell.pocket_depth_mm
    wide, tall = 2 * body.outline.half_mm[0], body.height_mm
    if tall >= depth or wide > 2 * pocket.outline.half_mm[0]:
        what = "a magnet" if spec.arrangement == "sensors-in-core" else "a sensor board"
        larger = [f"deeper than {tall:g} mm (shell.pocket_depth_mm)"] if tall >= depth else []
        if wide > 2 * pocket.outline.half_mm[0]:
            larger.append(f"{wide:g} mm wide or more (shell.pocket_diameter_mm)")
        yield (
            f"{what} of {wide:g} × {tall:g} mm must fit below the seal in a pocket of "
            f"{2 * pocket.outline.half_mm[0]:g} × {depth:g} mm; it does not. Choose a smaller one, or a "
            f"pocket {' and '.join(larger)}"
        )


def _check_sealed(spec: ObjectSpec, index: int, pocket: Pocket) -> Iterator[str]:
    """Silicone must be left between the body and the face, and between the pocket and the core."""
    thickness, body = spec.shell.thickness_mm, pocket.body
    upwards = body.outline.support_mm(body.frame[2, :2]) + pocket.axis[2] * body.height_mm / 2
    depth = -body.centre_mm[2]
    if depth <= upwards or -pocket.lowest_mm >= thickness:
        low, high = upwards, thickness + depth + pocket.lowest_mm
        yield (
            f"magnets.depth_mm[{index}] = {depth:g} does not seal the magnet within the "
            f"{thickness:g} mm of silicone: at this tilt its mid-plane must lie deeper than {low:.4g} "
            f"and its pocket's floor above the core, less deep than {high:.4g} mm. Change depth_mm or "
            "tilt_deg"
        )


def _check_pockets_apart(pockets: tuple[Pocket, ...]) -> Iterator[str]:
    axes = [pocket.axis_ends_mm for pocket in pockets]
    near = near_pairs(axes, [pocket.outline.radius_mm for pocket in pockets])
    for index_a, index_b, distance in islice(near, MOST_TOLD):
        a, b = pockets[index_a], pockets[index_b]
        needed = a.outline.radius_mm + b.outline.radius_mm
        yield (
            f"the pockets of {a.body.label} and {b.body.label} touch or overlap: axes "
            f"{distance:.3g} mm apart, more than {needed:.4g} mm needed. Move one of them away by "
            f"more than {needed - distance:.3g} mm"
        )


def _check_pockets_across_edges(
    faces: tuple[tuple[Pocket, ...], ...], halves_mm: list[tuple[float, float]], part: str
) -> Iterator[str]:
    """The boxes round the pockets of neighbouring faces must not meet at an edge."""
    all_pockets = [(p, half) for face, half in zip(faces, halves_mm, strict=True) for p in face]
    deepest = max(-pocket.lowest_mm for pocket, _ in all_pockets)
    for pocket, half in all_pockets:
        half_x, half_y = (edge - deepest for edge in half)
        if (pocket.reach_mm >= (half_x, half_y)).any():
            at_most = [h - r + abs(c) for h, r, c in _columns((half_x, half_y), pocket)]
            yield (
                f"{pocket.body.label} reaches into the {deepest:.4g} mm zone of the neighbouring "
                f"face's pockets in the {part}: pockets of two faces could overlap. Its pocket reaches "
                f"{pocket.reach_mm[0]:.4g}, {pocket.reach_mm[1]:.4g} mm from the middle, less than "
                f"{half_x:.4g}, {half_y:.4g} mm is needed. Move it inwards, to |x| below {at_most[0]:.4g}, "
                f"|y| below {at_most[1]:.4g} mm"
            )


def _columns(half_mm: tuple[float, float], pocket: Pocket) -> list[tuple[float, float, float]]:
    """Half extent, the pocket's reach and its body's place, along x and along y (mm)."""
    return list(zip(half_mm, pocket.reach_mm, pocket.body.centre_mm[:2], strict=True))


def _check_core_contents(spec: ObjectSpec) -> Iterator[str]:
    if spec.arrangement == "sensors-in-core":
        return _check_sensors(spec)
    return _check_magnets_in_core(spec)


def _check_magnets_in_core(spec: ObjectSpec) -> Iterator[str]:
    core = spec.core
    if spec.magnets.depth_mm is not None:
        yield (
            "magnets.depth_mm is that of magnets in the shell; with arrangement = 'sensors-in-shell' "
            "they sit in the core. Give magnets.depth_below_core_face_mm instead"
        )
    middle = passage_radius_mm(spec)
    for pocket in (pocket for face in core_pockets(spec) for pocket in face):
        if -pocket.lowest_mm >= core.wall_mm:
            yield (
                f"{pocket.body.label} needs a pocket {-pocket.lowest_mm:.4g} mm deep in a core wall of "
                f"core.wall_mm = {core.wall_mm:g}. Use a flatter magnet or a thicker wall"
            )
        clear = float((pocket.body.centre_mm[:2] ** 2).sum() ** 0.5) - pocket.outline.radius_mm
        # a hole too narrow for wires carries none, and a magnet may close it wholly
        closed = middle <= _NO_WIRES_MM and clear <= -middle
        if clear <= middle and not closed:
            yield (
                f"{pocket.body.label} meets the wire hole of radius {middle:g} mm at the middle "
                f"of the core's face. Move it outwards by more than {middle - clear:.3g} mm"
            )
    for pockets in core_pockets(spec):
        yield from _check_pockets_apart(pockets)
    halves = [frame.half_extents_mm for frame in core_frames(spec)]
    yield from _check_pockets_across_edges(core_pockets(spec), halves, "core")


def _check_sensors(spec: ObjectSpec) -> Iterator[str]:
    sensors, core = spec.sensors, spec.core
    half = min(spec.core_size_mm) / 2
    if sensors.depth_below_core_face_mm > core.recess_depth_mm:
        yield (
            f"sensors.depth_below_core_face_mm must not exceed core.recess_depth_mm = "
            f"{core.recess_depth_mm:g}; got {sensors.depth_below_core_face_mm:g}. Deepen the recess"
        )
    if sensors.positions_mm is not None:
        yield from _check_sensor_places(spec)
        return
    if sensors.radius_mm >= half:
        yield (
            f"sensors.radius_mm puts the sensors outside the core: it must be below {half:g} (half "
            f"the core's edge); got {sensors.radius_mm:g}. Choose a smaller radius"
        )
    if not core.recess_inner_radius_mm <= sensors.radius_mm <= core.recess_outer_radius_mm:
        yield (
            f"sensors.radius_mm must lie in the core's recess ({core.recess_inner_radius_mm:g} to "
            f"{core.recess_outer_radius_mm:g} mm); got {sensors.radius_mm:g}. Move the sensor or the recess"
        )


def _check_sensor_places(spec: ObjectSpec) -> Iterator[str]:
    """Explicit places: each recess, moved along with its sensor, must stay on the core's face."""
    core = spec.core
    beyond = core.recess_outer_radius_mm - spec.sensors.radius_mm
    for frame, places in zip(core_frames(spec), sensor_places(spec), strict=True):
        face, limits = frame.number, frame.half_extents_mm
        for index, (x, y, azimuth) in enumerate(places):
            reach = (
                abs(x + beyond * cos(azimuth)) + core.recess_width_mm / 2 * abs(sin(azimuth)),
                abs(y + beyond * sin(azimuth)) + core.recess_width_mm / 2 * abs(cos(azimuth)),
            )
            if reach[0] >= limits[0] or reach[1] >= limits[1]:
                yield (
                    f"sensors.positions_mm: sensor {index + 1} of face {face} at ({x:g}, {y:g}) puts its "
                    f"recess outside the core's face: it reaches {reach[0]:.4g}, {reach[1]:.4g} mm from "
                    f"the middle, less than {limits[0]:.4g}, {limits[1]:.4g} mm is needed. Move it inwards "
                    f"by more than {excess(reach, limits)}"
                )


def check_box_presses(spec: ObjectSpec) -> Iterator[str]:
    yield from _check_indenter(spec)
    deepest = spec.press.depths_mm[-1]
    if deepest > 0.6 * spec.shell.thickness_mm:
        yield (
            f"press.depths_mm must stay below 60 % of shell.thickness_mm (linear mechanics); got "
            f"{deepest:g} of {spec.shell.thickness_mm:g} mm. Press {0.6 * spec.shell.thickness_mm:.4g} mm "
            f"deep at most, or make shell.thickness_mm {deepest / 0.6:.4g} or more"
        )


def fewer_places(count: tuple[int, int], pitch_mm: float, axis: int, room_mm: float) -> str:
    """Advise how a grid fits whose places, with half a pitch round them, have `room_mm` on an axis."""
    most, widest = int(room_mm / pitch_mm + 1e-9), floor(100 * room_mm / count[axis]) / 100
    fewer = f"fewer places ({most} at most)" if most >= LEAST_COUNT else "fewer places"
    nearer = f", contact_grid.pitch_mm of {widest:g} or less" if widest > 0 else ""
    return f'Use {fewer}{nearer}, contact_grid.count = "fill", or a smaller indenter'


def _check_indenter(spec: ObjectSpec) -> Iterator[str]:
    """Every place of the grid, half a pitch of margin and the tips' paths lie on the faces."""
    from design.layout.tips import footprint_mm, path_mm, tip_places_mm, tip_shape

    deepest, height = spec.press.depths_mm[-1], tip_shape(spec.indenter).height_mm
    if deepest >= height:
        yield (
            f"press.depths_mm must stay below the indenter's height, {height:g} mm (a hemisphere's "
            f"radius); got {deepest:g}. Press less deep or use a larger indenter"
        )
    footprint = footprint_mm(spec.indenter)
    size = footprint[1] - footprint[0]
    landing = footprint if spec.shell.slits.depth_mm else tip_places_mm(spec.indenter)
    farthest = abs(landing + path_mm(spec.indenter, spec.press.depths_mm)[-1]).max(axis=0)
    reach = [max(pair) for pair in zip(farthest, abs(landing).max(axis=0), strict=True)]
    grid = spec.contact_grid
    yield from place_problems(spec)
    for axis, limit in enumerate(_smallest_half_extents_mm(spec)):
        if size[axis] > 2 * limit:
            yield (
                f"the indenter is {size[axis]:.4g} mm wide, larger than the face of {2 * limit:g} mm. "
                "Use a smaller indenter"
            )
        if grid.count == "fill":
            continue
        needed = grid.count[axis] * grid.pitch_mm / 2 + reach[axis]
        if needed > limit:
            yield (
                f"contact_grid.count[{axis}] × pitch_mm, half a pitch of margin and the indenter need "
                f"{2 * needed:.4g} mm on a face of {2 * limit:g} mm. "
                f"{fewer_places(grid.count, grid.pitch_mm, axis, 2 * (limit - reach[axis]))}"
            )

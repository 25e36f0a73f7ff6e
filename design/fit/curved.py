"""Fit of everything in bodies other than boxes, and what only boxes can.

Neighbouring patches of a curved body overlap, so that pockets are compared in the object's frame.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import islice, product
from typing import TYPE_CHECKING

import numpy as np

from design.fit.magnet_places import (
    MOST_TOLD,
    Placed,
    lies_on_patch,
    patch_problems,
    placed_pockets,
)
from design.layout.boards import smallest_recess_wall_mm
from design.layout.body import body_of, core_frames, face_frames
from design.layout.places.contact_places import (
    LEAST_COUNT,
    place_problems,
    stays_on_patch,
    touched_reach_mm,
)
from design.layout.places.positions import board_places, board_sinks_mm, shell_covers_mm
from design.layout.pockets import (
    Pocket,
    axis_in_object_mm,
    near_pairs,
)
from design.layout.tips import tip_places_mm

if TYPE_CHECKING:
    from design.body.surface_chart import FaceFrame
    from design.spec.object import ObjectSpec

_LARGEST_SHARE = 0.6
_STEP_MM = 0.2
"""In which boards that find no room are moved inwards."""


def check_body(spec: ObjectSpec, ways: bool = True) -> Iterator[str]:
    """Problems of a body that has room for its core; unless `ways` without places that are looked
    for."""
    yield from check_recesses(spec)
    yield from _check_pockets(spec, ways)
    yield from check_sensors(spec)


def check_curved_presses(spec: ObjectSpec) -> Iterator[str]:
    """Yield where a press of the table would leave its patch or goes too deep."""
    deepest, silicone = spec.press.depths_mm[-1], body_of(spec).silicone_mm
    if deepest > _LARGEST_SHARE * silicone:
        yield (
            f"press.depths_mm must stay below {_LARGEST_SHARE:.0%} of the silicone (linear mechanics); "
            f"got {deepest:g} of {silicone:g} mm. Press {_LARGEST_SHARE * silicone:.4g} mm deep at most, or "
            f"make shell.thickness_mm {deepest / _LARGEST_SHARE:.4g} or more"
        )
    yield from place_problems(spec)
    if spec.contact_grid.count == "fill":
        return
    reach, tips = touched_reach_mm(spec), tip_places_mm(spec.indenter)
    corner = np.asarray(spec.contact_grid.count) * spec.contact_grid.pitch_mm / 2
    for frame in face_frames(spec):
        if not _corners_stay(frame, corner, np.ones(1), reach, tips)[0]:
            stays = _corners_stay(frame, corner, np.linspace(0.0, 1.0, 201), reach, tips)
            half, fewer = frame.half_lengths_mm, _largest_grid(spec, int(stays.argmin()))
            yield (
                f"contact_grid.count × pitch_mm / 2 = ({corner[0]:g}, {corner[1]:g}) mm, and {reach:.3g} mm "
                f"round the tip, leave face {frame.number}, {'an ellipse' if frame.round else 'a rectangle'} "
                f"of ±{half[0]:.4g}, ±{half[1]:.4g} mm along it. Use fewer places{fewer}, "
                'contact_grid.count = "fill", a smaller tip or lesser depths'
            )


def _corners_stay(
    frame: FaceFrame,
    corner_mm: np.ndarray,
    shares: np.ndarray,
    reach_mm: float,
    tips_mm: np.ndarray,
) -> np.ndarray:
    """Return whether all four corners of a grid, drawn in to each share of the way, stay on their patch."""
    signs = np.array(list(product((1.0, -1.0), repeat=2)))
    places = shares[:, None, None] * corner_mm * signs
    stays = stays_on_patch(frame, places.reshape(-1, 2), reach_mm, tips_mm)
    return np.asarray(stays.reshape(-1, len(signs)).all(axis=1))


def _largest_grid(spec: ObjectSpec, first_outside: int) -> str:
    """Largest grid in words, for one whose corner leaves its patch at the step `first_outside` of 200 from
    the middle."""
    grid, share = spec.contact_grid, max(first_outside - 1, 0) / 200
    assert grid.count != "fill"
    pitch, count = int(100 * share * grid.pitch_mm) / 100, [int(share * n) for n in grid.count]
    fewer = f" ({count[0]} × {count[1]} at most)" if min(count) >= LEAST_COUNT else ""
    return fewer + (f", contact_grid.pitch_mm of {pitch:g} or less" if pitch else "")


def _check_what_boxes_can(spec: ObjectSpec) -> Iterator[str]:
    kind, mechanics = spec.body.kind, spec.mechanics
    wants = {
        "mechanics.interface": mechanics.interface != "bonded",
        "mechanics.slip": mechanics.slip.slipped or mechanics.slip.rim != "free",
        "mechanics.correction": mechanics.correction != "none",
        "arrangement": spec.arrangement != "sensors-in-core",
        "magnets.tilt_deg": bool(spec.magnets.tilt_deg)
        and not all(f.flat for f in face_frames(spec)),
    }
    for key in (key for key, wanted in wants.items() if wanted):
        yield (
            f"{key} is known for boxes only, with its default otherwise; body.kind is {kind!r}. Leave "
            f"{key} out"
        )


def check_body_core(spec: ObjectSpec) -> Iterator[str]:
    """Return what other bodies than boxes cannot have; else whether there is room for a core."""
    return iter([*_check_what_boxes_can(spec)] or [*_check_core(spec)])


def _check_core(spec: ObjectSpec) -> Iterator[str]:
    body, core = body_of(spec), spec.core
    room, what = body.room_for_recesses
    if room <= core.recess_depth_mm:
        short = core.recess_depth_mm - room
        larger = f"larger by more than {(1 if body.on_base else 2) * short:.4g} mm"
        thinner = (
            f"below {body.thickness_mm - short:.4g}" if body.thickness_mm > short else "smaller"
        )
        shallower = f"core.recess_depth_mm below {room:.4g}" if room > 0 else "the recess smaller"
        yield (
            f"{what} is {room:.4g} mm thick and must be more than core.recess_depth_mm = "
            f"{core.recess_depth_mm:g}. Make body.size_mm {larger}, or shell.thickness_mm {thinner}, "
            f"or {shallower}"
        )
    if body.thickness_mm >= body.thickness_below_mm:
        yield (
            f"shell.thickness_mm must be below the {body.name}'s radius of {body.thickness_below_mm:g} mm; "
            f"got {body.thickness_mm:g}. Make it thinner, or body.inside = 'silicone'"
        )
    if body.opening == "bore" and body.bore_mm >= 2 * room:
        yield (
            f"body.bore_mm must be below the core's width, {2 * room:.4g} mm; got {body.bore_mm:g}. "
            "Make the bore narrower or the core wider (body.size_mm, shell.thickness_mm)"
        )


def check_recesses(spec: ObjectSpec) -> Iterator[str]:
    core = spec.core
    widest = min(float(np.hypot(*frame.half_extents_mm)) for frame in core_frames(spec))
    if not core.recess_inner_radius_mm < core.recess_outer_radius_mm < widest:
        yield (
            "core recesses must satisfy recess_inner_radius_mm < recess_outer_radius_mm < the reach "
            f"of the core's smallest patch, {widest:.4g} mm; got {core.recess_inner_radius_mm:g} and "
            f"{core.recess_outer_radius_mm:g}. Move the recess inwards"
        )


def _check_pockets(spec: ObjectSpec, ways: bool) -> Iterator[str]:
    covers = np.concatenate(shell_covers_mm(spec)).tolist()
    placed = placed_pockets(spec)
    for (frame, pocket), cover in zip(placed, covers, strict=True):
        yield from _check_depth(spec, pocket)
        if cover <= 0 and lies_on_patch(frame, pocket, cover):
            yield (
                f"{pocket.body.label} stands {-cover:.3g} mm out of the curved face {frame.number}. Deepen "
                "shell.pocket_depth_mm or magnets.depth_mm by more than that, or take a smaller magnet"
            )
    yield from patch_problems(spec, ways)
    axes = [axis_in_object_mm(frame, pocket) for frame, pocket in placed]
    near = near_pairs(axes, [pocket.outline.radius_mm for _, pocket in placed])
    for index_a, index_b, distance in islice(near, MOST_TOLD):
        yield _describe_near_pockets(placed[index_a], placed[index_b], distance)


def _check_depth(spec: ObjectSpec, pocket: Pocket) -> Iterator[str]:
    """A magnet wholly within its pocket, and that within the silicone."""
    shell, silicone, body = spec.shell, body_of(spec).silicone_mm, pocket.body
    tall = body.height_mm >= shell.pocket_depth_mm and spec.magnets.depth_mm is None
    over = -pocket.lowest_mm - silicone
    if over >= 0 or tall:
        key = "shell.pocket_depth_mm" if spec.magnets.depth_mm is None else "magnets.depth_mm"
        nearest = (
            f"Lower {key} by more than {over:.3g} mm"
            if over >= 0
            else f"Make shell.pocket_depth_mm more than {body.height_mm:g}, or take a thinner magnet"
        )
        yield (
            f"{body.label}: a magnet {body.height_mm:g} mm high in a pocket "
            f"{-pocket.lowest_mm:.4g} mm deep does not lie within the {silicone:g} mm of silicone. "
            f"{nearest}"
        )


def _inwards(frame: FaceFrame, xy_mm: np.ndarray) -> str:
    """Return where on its way to the middle a place lies on the patch."""
    shares = np.linspace(1, 0, 101)[:, None]
    x, y = np.round(shares[np.argmax(frame.covers(shares * abs(xy_mm)))] * xy_mm, 3) + 0.0
    return f"inwards, as to ({x:.4g}, {y:.4g})"


def _describe_near_pockets(placed_a: Placed, placed_b: Placed, distance_mm: float) -> str:
    (face, a), (other_face, b) = placed_a, placed_b
    needed = a.outline.radius_mm + b.outline.radius_mm
    return (
        f"the pockets of {a.body.label} of face {face.number} and {b.body.label} of face {other_face.number} "
        f"touch or overlap: axes {distance_mm:.3g} mm apart, more than {needed:.4g} mm needed. Move one of "
        f"them away by more than {needed - distance_mm:.3g} mm, or leave a face out with body.sensed_faces"
    )


def check_sensors(spec: ObjectSpec) -> Iterator[str]:
    sensors, core = spec.sensors, spec.core
    if sensors.depth_below_core_face_mm > core.recess_depth_mm:
        yield (
            f"sensors.depth_below_core_face_mm must not exceed core.recess_depth_mm = "
            f"{core.recess_depth_mm:g}; got {sensors.depth_below_core_face_mm:g}. Deepen the recess"
        )
    (room, what), roomless = room_for_recesses(spec), dict[int, list[int]]()
    for frame, places in board_places(spec):
        for index, ((x, y, _), sink_mm) in enumerate(places):
            outside = not frame.covers(np.array([x, y]))
            if outside and sensors.positions_mm is not None:
                yield (
                    f"sensor {index + 1} of face {frame.number} at ({x:.4g}, {y:.4g}) lies outside the "
                    f"core's patch (±{frame.half_extents_mm[0]:.4g}, ±{frame.half_extents_mm[1]:.4g} mm). "
                    f"Move it {_inwards(frame, np.array([x, y]))} (sensors.radius_mm or "
                    "sensors.positions_mm)"
                )
            elif outside or not np.isfinite(sink_mm):
                roomless.setdefault(frame.number, []).append(index + 1)
            elif not core.recess_depth_mm + sink_mm < room:
                yield _too_deep(spec, frame.number, index + 1, sink_mm, room, what)
    if roomless:
        yield _no_room_for_boards(spec, roomless)


def room_for_recesses(spec: ObjectSpec) -> tuple[float, str]:
    """Return what recesses must be less deep than (mm), and what it is called."""
    body, wall = body_of(spec), spec.core.wall_mm
    room, what = body.room_for_recesses
    hollow = body.opening != "closed" and not body.on_base
    return (wall, "core.wall_mm") if hollow and wall < room else (room, what)


def _too_deep(
    spec: ObjectSpec, face: int, sensor: int, sink_mm: float, room_mm: float, what: str
) -> str:
    deep = spec.core.recess_depth_mm + sink_mm
    grow = f"core.wall_mm larger than {deep:.4g}"
    if what != "core.wall_mm":
        walls = 1 if body_of(spec).on_base else 2
        grow = f"body.size_mm larger by more than {walls * (deep - room_mm):.3g} mm"
    return (
        f"the recess of sensor {sensor} of face {face} is {deep:.4g} mm deep: "
        f"core.recess_depth_mm = {spec.core.recess_depth_mm:g}, and {sink_mm:.3g} mm until no corner of "
        f"the board stands out of the curved core; {what} is {room_mm:.4g} mm. Make {grow}, "
        "the recess less deep, or the board (sensors.package_mm) smaller"
    )


def _no_room_for_boards(spec: ObjectSpec, sensors_of: dict[int, list[int]]) -> str:
    """Boards, by face, of which no depth is known that makes them flush with the core."""
    faces_of: dict[tuple[int, ...], list[int]] = {}
    for face, sensor_list in sensors_of.items():
        faces_of.setdefault(tuple(sensor_list), []).append(face)
    board_list = "; ".join(
        f"{_listed('sensor', sensor_list)} of {_listed('face', faces)}"
        for sensor_list, faces in faces_of.items()
    )
    width, length, _ = spec.sensors.package_mm
    return (
        f"boards of {width:g} × {length:g} mm reach beyond the core's patch, or find no room in it: "
        f"{board_list}. {_nearer_boards(spec)}"
    )


def _listed(what: str, numbers: Sequence[int]) -> str:
    return f"{what}{'s' * (len(numbers) > 1)} {', '.join(map(str, numbers))}"


def _nearer_boards(spec: ObjectSpec) -> str:
    """Return how far from the middles of the faces all boards find room, with their recesses."""
    core, sensors = spec.core, spec.sensors
    otherwise = "a smaller board (sensors.package_mm), a thinner shell or a larger body"
    if sensors.positions_mm is not None:
        return f"Move them inwards (sensors.positions_mm), or take {otherwise}"
    for inwards in np.arange(_STEP_MM, core.recess_inner_radius_mm, _STEP_MM):
        radius, inner, outer = (
            round(radius - float(inwards), 3)
            for radius in (
                sensors.radius_mm, core.recess_inner_radius_mm, core.recess_outer_radius_mm
            )
        )  # fmt: skip
        nearer = spec.changed(
            sensors=sensors.changed(radius_mm=radius),
            core=core.changed(recess_inner_radius_mm=inner, recess_outer_radius_mm=outer),
        )
        room, _ = room_for_recesses(nearer)
        deepest = core.recess_depth_mm + float(np.max(np.concatenate(board_sinks_mm(nearer))))
        alone = sensors.count_per_face * len(spec.body.sensed) == 1
        if deepest < room and (alone or smallest_recess_wall_mm(nearer) >= spec.printer.wall_mm):
            return (
                f"With sensors.radius_mm = {radius:g}, core.recess_inner_radius_mm = {inner:g} and "
                f"core.recess_outer_radius_mm = {outer:g} they would; or take {otherwise}"
            )
    return f"Take {otherwise}"

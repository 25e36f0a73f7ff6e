"""Room of sensor boards, chips, wires and the core's recesses, and the walls left between recesses."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np
from jaxtyping import Float

from design.body.surface_chart import FaceFrame
from design.body.triangles import Block
from design.layout.body import body_of, core_frames
from design.layout.places.positions import (
    board_places,
    board_sinks_mm,
    mounted_stack,
    shell_body_layout,
)
from design.layout.pockets import board_frame, sensor_places
from design.spec.cached_geometry import cached_geometry
from design.spec.object import ObjectSpec

WIRE_DIAMETER_MM = 0.4
"""Diameter of a wire with its insulation (AWG 30 wrapping wire has 0.5 mm, enamelled wire less)."""
PACKING = 0.7
"""Share of a round hole that loose wires fill, at most (densest packing of equal circles: 0.91)."""
_AT_THE_HOLE_MM = 1e-3
"""Distance from the wire hole's middle below which a recess lies over it and needs no channel."""
_TOP_FACE = 1
"""Number of the face that points along +z."""


@dataclass(frozen=True)
class Mounted:
    """One sensor as mounted: its face, its number on it, board and chip in the object's frame."""

    face: int
    number: int
    board: Block
    chip: Block

    @property
    def label(self) -> str:
        return f"sensor {self.number} of face {self.face}"


LID_RIM_MM = 2.0
"""Height of the rim under a lid, that centres it in its bay."""


@cached_geometry
def mounted_sensors(spec: ObjectSpec) -> tuple[Mounted, ...]:
    """Boards in the core's recesses, face by face; empty where the sensors sit in the shell.

    Each board lies in the middle of its recess, as `mounted_stack` says; on a curved core deeper, by
    `board_sinks_mm`.
    """
    if spec.arrangement == "sensors-in-shell":
        return ()
    return tuple(
        _mounted(spec, frame.tangent(np.array(place[:2])), number, place, sink)
        for frame, places in board_places(spec)
        for number, (place, sink) in enumerate(places, start=1)
    )


def board_blocks(spec: ObjectSpec) -> list[Block]:
    """Every sensor board, in the core or cast into the shell."""
    if spec.arrangement == "sensors-in-core":
        return [mounted.board for mounted in mounted_sensors(spec)]
    layout, half = shell_body_layout(spec), np.asarray(spec.sensors.package_mm) / 2
    return [Block(c, f, half) for c, f in zip(layout.centre_mm, layout.frame, strict=True)]


def _mounted(
    spec: ObjectSpec,
    frame: FaceFrame,
    number: int,
    place: tuple[float, float, float],
    sink_mm: float,
) -> Mounted:
    sensors, stack = spec.sensors, mounted_stack(spec, place)
    axes = frame.axes @ board_frame(place[2])
    board_z = stack.board_top_mm - sink_mm - sensors.package_mm[2] / 2
    chip_z = stack.chip_top_mm - sink_mm - sensors.chip_mm[2] / 2
    board = frame.to_object(np.append(stack.board_xy_mm, board_z))
    chip = frame.to_object(np.array([*place[:2], chip_z]))
    return Mounted(
        frame.number,
        number,
        Block(board, axes, np.asarray(sensors.package_mm) / 2),
        Block(chip, axes, np.asarray(sensors.chip_mm) / 2),
    )


def bay_block(spec: ObjectSpec) -> Block | None:
    """The bay of the core, `core.bay_mm` from its lower end upwards, about its middle where the body is
    closed; None where there is none."""
    if spec.core.bay_mm is None:
        return None
    body, half = body_of(spec), np.asarray(spec.core.bay_mm) / 2
    if has_lid(spec):
        return Block(np.zeros(3), np.eye(3), half)
    low = -float(body.half_mm[2] if body.on_base else body.core_half_mm[2])
    return Block(np.array([0.0, 0.0, low + half[2]]), np.eye(3), half)


def has_lid(spec: ObjectSpec) -> bool:
    """Return whether the core is printed in two parts, a base and a lid, round the bay of a closed body."""
    body = body_of(spec)
    return spec.core.bay_mm is not None and body.opening == "closed" and not body.on_base


def cuts_of_core(spec: ObjectSpec) -> list[Block]:
    """Recesses of the sensors and wire channels; none where the sensors sit in the shell."""
    if spec.arrangement != "sensors-in-core":
        return []
    return [*sensor_recesses(spec), *all_wire_channels(spec)]


def all_wire_channels(spec: ObjectSpec) -> list[Block]:
    """Wire channels of all faces of the core, up to its surface; none where the sensors sit in the shell."""
    if spec.arrangement != "sensors-in-core":
        return []
    return [
        channel
        for frame, places in board_places(spec)
        for channel in wire_channels(spec, frame, [place for place, _ in places], 0.0)
    ]


def wire_bundle_mm(spec: ObjectSpec) -> float:
    """Diameter of the bundle of one face's wires, loosely packed."""
    return hole_for_wires_mm(spec.core.wires_per_sensor * spec.sensors.count_per_face, spec)


def wires_through(diameter_mm: float, spec: ObjectSpec) -> int:
    """Return how many wires a round hole takes, loosely packed."""
    return int(PACKING * (diameter_mm / WIRE_DIAMETER_MM) ** 2 + 1e-9)


def hole_for_wires_mm(count: int, spec: ObjectSpec) -> float:
    """Diameter of the round hole that takes `count` wires: the diameter of their bundle."""
    return WIRE_DIAMETER_MM * float(np.sqrt(count / PACKING))


def count_wires(spec: ObjectSpec) -> int:
    """Number of wires of all sensors of the object."""
    faces = len(spec.body.sensed)
    return spec.core.wires_per_sensor * spec.sensors.count_per_face * faces


@dataclass(frozen=True)
class Recess(Block):
    """The box of one sensor's recess, and the face that it is in."""

    face: int


@cached_geometry
def sensor_recesses(spec: ObjectSpec) -> tuple[Recess, ...]:
    """Every recess of the core, face by face, in the object's frame (sensors in the core)."""
    return _recesses(spec, board_sinks_mm(spec))


def _recesses(spec: ObjectSpec, sinks_mm: tuple[tuple[float, ...], ...]) -> tuple[Recess, ...]:
    core = spec.core
    length = core.recess_outer_radius_mm - core.recess_inner_radius_mm
    recesses = []
    for frame, places, sinks in zip(core_frames(spec), sensor_places(spec), sinks_mm, strict=True):
        for (x, y, azimuth), sink in zip(places, sinks, strict=True):
            depth = core.recess_depth_mm + sink
            half = np.array([length, core.recess_width_mm, depth]) / 2
            cosine, sine = np.cos(azimuth), np.sin(azimuth)
            turn = np.array([[cosine, -sine, 0.0], [sine, cosine, 0.0], [0.0, 0.0, 1.0]])
            aside = core.recess_inner_radius_mm + length / 2 - spec.sensors.radius_mm
            local = np.array([x + aside * cosine, y + aside * sine, -depth / 2])
            tangent = frame.tangent(np.array([x, y]))
            centre = np.asarray(tangent.to_object(local))
            recesses.append(Recess(centre, tangent.axes @ turn, half, frame.number))
    return tuple(recesses)


def smallest_recess_wall_mm(spec: ObjectSpec, sunk: bool = True) -> float:
    """Largest gap that a plane between two recesses has, for the two that are nearest.

    Without `sunk`, of recesses as deep as on a flat core, which lie within the true ones.

    Negative where recesses meet, by how far one must move. Not above the true distance of two
    boxes, and less than it where they face each other with two edges or corners.
    """
    flat = tuple((0.0,) * len(places) for places in sensor_places(spec))
    recesses = sensor_recesses(spec) if sunk else _recesses(spec, flat)
    first_of_pairs, second_of_pairs = zip(*combinations(recesses, 2), strict=True)
    return float(_gaps_mm(first_of_pairs, second_of_pairs).min())


@dataclass(frozen=True)
class WireHole:
    """A hole for wires in the middle of a face of the core, and its end in the core's surface (mm)."""

    diameter_mm: float
    end_mm: Float[np.ndarray, "3"]


def wire_holes(spec: ObjectSpec) -> dict[str, WireHole]:
    """Return the first wire hole, face by face, of every key that gives wire holes their diameter."""
    holes: dict[str, WireHole] = {}
    for frame in core_frames(spec):
        hole = WireHole(wire_hole_diameter_mm(spec, frame.number), frame.centre_mm)
        holes.setdefault(_wire_hole_key(spec, frame.number), hole)
    return holes


def wire_hole_diameter_mm(spec: ObjectSpec, face: int) -> float:
    """Diameter of the hole in the middle of a face of the core."""
    return getattr(spec.core, _wire_hole_key(spec, face))


def _wire_hole_key(spec: ObjectSpec, face: int) -> str:
    if face == _TOP_FACE and not body_of(spec).sampled:
        return "wire_hole_top_diameter_mm"
    return "wire_hole_side_diameter_mm"


def passage_radius_mm(spec: ObjectSpec) -> float:
    """Radius of the widest passage for wires in the middle of a core's face: wire hole and hub's recess."""
    core = spec.core
    return max(core.wire_hole_top_diameter_mm, core.wire_hole_side_diameter_mm) / 2


def gap_mm(a: Block, b: Block) -> float:
    """Between two blocks, at most the true one: the largest along any normal or product of edges (the
    separating-axis theorem); negative where they meet."""
    return float(_gaps_mm([a], [b])[0])


def _gaps_mm(blocks_a: Sequence[Block], blocks_b: Sequence[Block]) -> Float[np.ndarray, "pair"]:
    """The same between each of some blocks and its partner."""
    axes_a, axes_b = (np.stack([block.axes for block in blocks]) for blocks in (blocks_a, blocks_b))
    half_a, half_b = (
        np.stack([block.half_mm for block in blocks]) for blocks in (blocks_a, blocks_b)
    )
    between = np.stack([b.centre_mm - a.centre_mm for a, b in zip(blocks_a, blocks_b, strict=True)])
    normals_a, normals_b = axes_a.transpose(0, 2, 1), axes_b.transpose(0, 2, 1)
    # Separating axis theorem for boxes: the 3 + 3 normals and their 9 cross products are enough
    # (Gottschalk, Lin and Manocha, OBBTree, SIGGRAPH 1996).
    crossed = np.cross(normals_a[:, :, None], normals_b[:, None]).reshape(len(blocks_a), -1, 3)
    directions = np.concatenate([normals_a, normals_b, crossed], axis=1)
    length = np.linalg.norm(directions, axis=2)
    # Parallel edges have no cross product; the normals serve them.
    parallel = length <= 1e-9
    directions /= np.where(parallel, 1.0, length)[..., None]
    # p pair of boxes, d direction, i coordinate, e half edge: the gap along a direction is the
    # centres' distance less both half widths Σ |axis · direction| · half.
    apart = abs(np.einsum("pdi,pi->pd", directions, between))
    reach = sum(
        np.einsum("pde,pe->pd", abs(directions @ axes), half)
        for axes, half in ((axes_a, half_a), (axes_b, half_b))
    )
    return np.where(parallel, -np.inf, apart - reach).max(axis=1)


def wire_channels(
    spec: ObjectSpec, frame: FaceFrame, places: Sequence[tuple[float, float, float]], over_mm: float
) -> list[Block]:
    """Channels from the wire hole in the middle of a core's face to the recesses at these places.

    Their floors are level, and the depth of `core.wire_channel_mm` or more below the surface all the
    way; they end so far above it. A recess over the hole needs none.
    """
    width, away = spec.core.wire_channel_mm[0], [np.array(place[:2]) for place in places]
    if not width:
        return []
    return [_channel(spec, frame, xy, over_mm) for xy in away if np.hypot(*xy) > _AT_THE_HOLE_MM]


def _channel(
    spec: ObjectSpec, frame: FaceFrame, xy_mm: Float[np.ndarray, "2"], over_mm: float
) -> Block:
    low, high = channel_heights_mm(spec, frame, xy_mm, over_mm)
    length = float(np.hypot(*xy_mm))
    (cosine, sine), width = xy_mm / length, spec.core.wire_channel_mm[0]
    turned = np.array([[cosine, -sine, 0], [sine, cosine, 0], [0, 0, 1.0]])
    centre = frame.centre_mm + frame.axes @ np.append(xy_mm / 2, (low + high) / 2)
    return Block(centre, frame.axes @ turned, np.array([length, width, high - low]) / 2)


def channel_heights_mm(
    spec: ObjectSpec, frame: FaceFrame, xy_mm: Float[np.ndarray, "2"], over_mm: float
) -> tuple[float, float]:
    """Floor and top of a wire channel over the plane that touches the core in the middle of a face.

    The floor is level, and the depth of `core.wire_channel_mm` or more below the surface all the way from the
    wire hole to a place; the top is so far above it.
    """
    way = np.linspace(0.0, 1.0, 17)[:, None] * np.asarray(xy_mm, float)
    heights = frame.relief.evaluate(way)[0]
    return float(heights.min()) - spec.core.wire_channel_mm[1], float(heights.max()) + over_mm

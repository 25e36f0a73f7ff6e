"""Sensor boards, chips, wires and recesses of the core as the room that they take, and the walls
that are left between recesses."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations

import numpy as np
from jaxtyping import Float

from design.body.surface_chart import FaceFrame
from design.body.triangles import Block
from design.layout.pockets import board_frame
from design.layout.positions import board_places, mounted_stack, shell_body_layout
from design.spec.object import ObjectSpec
from design.spec.worked_out import once

PACKING = 0.7
"""Share of a round hole that loose wires fill, at most (densest packing of equal circles: 0.91)."""


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


def mounted_sensors(spec: ObjectSpec) -> list[Mounted]:
    """Boards in the core's recesses, face by face; empty where the sensors sit in the shell.

    Each board lies in the middle of its recess, as `mounted_stack` says; on a curved core deeper, by
    `board_sinks_mm`.
    """
    if spec.arrangement == "sensors-in-shell":
        return []
    return [
        _mounted(spec, frame.tangent(np.array(place[:2])), number, place, sink)
        for frame, places in board_places(spec)
        for number, (place, sink) in enumerate(places, start=1)
    ]


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


def wire_bundle_mm(spec: ObjectSpec) -> float:
    """Diameter of the bundle of one face's wires, loosely packed."""
    wires = spec.core.wires_per_sensor * spec.sensors.count_per_face
    return spec.core.wire_diameter_mm * float(np.sqrt(wires / PACKING))


@dataclass(frozen=True)
class Recess:
    """The box of one sensor's recess: centre (mm), axes as columns, half edges (mm)."""

    face: int
    centre_mm: Float[np.ndarray, "3"]
    axes: Float[np.ndarray, "3 3"]
    half_mm: Float[np.ndarray, "3"]


@once
def sensor_recesses(spec: ObjectSpec) -> tuple[Recess, ...]:
    """Every recess of the core, face by face, in the object's frame (sensors in the core)."""
    core = spec.core
    length = core.recess_outer_radius_mm - core.recess_inner_radius_mm
    found = []
    for frame, places in board_places(spec):
        for (x, y, azimuth), sink in places:
            depth = core.recess_depth_mm + sink
            half = np.array([length, core.recess_width_mm, depth]) / 2
            cosine, sine = np.cos(azimuth), np.sin(azimuth)
            turn = np.array([[cosine, -sine, 0.0], [sine, cosine, 0.0], [0.0, 0.0, 1.0]])
            aside = core.recess_inner_radius_mm + length / 2 - spec.sensors.radius_mm
            local = np.array([x + aside * cosine, y + aside * sine, -depth / 2])
            found.append(
                Recess(frame.number, np.asarray(frame.to_object(local)), frame.axes @ turn, half)
            )
    return tuple(found)


def smallest_recess_wall_mm(spec: ObjectSpec) -> float:
    """Largest gap that a plane between two recesses has, for the two that are nearest.

    Negative where recesses meet, by how far one must move. Not above the true distance of two
    boxes, and less than it where they face each other with two edges or corners.
    """
    pairs = combinations(sensor_recesses(spec), 2)
    return min(_gap_mm(a, b) for a, b in pairs)


def _gap_mm(a: Recess, b: Recess) -> float:
    """Of the separating-axis theorem: the largest gap along any normal or product of edges."""
    crossed = np.cross(a.axes.T[:, None], b.axes.T[None]).reshape(-1, 3)
    directions = np.concatenate([a.axes.T, b.axes.T, crossed])
    length = np.linalg.norm(directions, axis=1)
    directions = directions[length > 1e-9] / length[length > 1e-9, None]
    apart = abs(directions @ (b.centre_mm - a.centre_mm))
    reach = abs(directions @ a.axes) @ a.half_mm + abs(directions @ b.axes) @ b.half_mm
    return float((apart - reach).max())

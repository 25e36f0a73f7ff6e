"""Lengths of the sensors' wires, from the board's pads through the core to the reading board."""

from __future__ import annotations

import numpy as np

from design.body.surface_chart import FACE_AXES
from design.layout.boards import mounted_sensors
from design.layout.body import core_frames
from design.layout.core_hold import locators
from design.layout.mould.frame import opening_of
from design.layout.places.positions import sensor_layout
from design.spec.object import ObjectSpec

LEAD_MM = 200.0
"""From the object to the board, where nothing else is said."""


def wire_lengths_mm(spec: ObjectSpec, lead_mm: float = LEAD_MM) -> tuple[float, ...]:
    """Length of each sensor's wires, face by face.

    In the core: along the recess to the wire hole in the middle of the face, through the wall, straight
    to where the wires leave the object, and the lead. Sensors in the shell: straight from the chip.
    """
    exit_mm = _exit_mm(spec)
    if spec.arrangement == "sensors-in-shell":
        straight = np.linalg.norm(sensor_layout(spec).position_mm - exit_mm, axis=1)
        return tuple(float(length) + lead_mm for length in straight)
    frames = {frame.number: frame for frame in core_frames(spec)}
    lengths = []
    for mounted in mounted_sensors(spec):
        frame = frames[mounted.face]
        inside = frame.centre_mm - spec.core.wall_mm * frame.normal
        to_hole = mounted.board.centre_mm - frame.centre_mm
        to_hole = to_hole - (to_hole @ frame.normal) * frame.normal
        path = np.linalg.norm(to_hole) + spec.core.wall_mm + np.linalg.norm(inside - exit_mm)
        lengths.append(float(path) + lead_mm)
    return tuple(lengths)


def _exit_mm(spec: ObjectSpec) -> np.ndarray:
    """Middle of the first open face, or of face 6 where the body opens by a bore; of a closed body the
    hole of the first locating pin."""
    if opening_of(spec) == "closed" and locators(spec):
        return locators(spec)[0].frame.centre_mm
    normal = np.array(FACE_AXES[(*spec.body.opened, 6)[0]][0], dtype=float)
    return normal * np.asarray(spec.body.size_mm) / 2

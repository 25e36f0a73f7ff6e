"""Layouts with what was measured on the built object in place of the design.

They are what sensors see. Mechanics goes on with the design: a magnet found 0.3 mm from its seat is
carried by the motion of the seat (`estimator.tolerances.budget` says how wrong that is).
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Bool, Float, Int

from design.spec.assembly import BuiltMagnet
from design.spec.object import ObjectSpec

if TYPE_CHECKING:
    from design.layout.positions import FaceFrame, MagnetLayout, SensorLayout

_AXIS_NAMES = "XYZ"


def magnets_as_built(
    spec: ObjectSpec, designed: MagnetLayout, frames: tuple[FaceFrame, ...]
) -> MagnetLayout:
    """Magnets where `as_built` found them; `frames` are those of the surfaces that they sit under."""
    layout = designed
    of_face = {frame.number: frame for frame in frames}
    for found in spec.as_built.magnets:
        row = _row(layout.face, found.face, found.magnet)
        layout = _with_magnet(spec, layout, row, found, of_face[found.face])
    return layout


def _with_magnet(
    spec: ObjectSpec, layout: MagnetLayout, row: int, found: BuiltMagnet, frame: FaceFrame
) -> MagnetLayout:
    centre, axis, side, strength = (
        given.copy() for given in (layout.centre_mm, layout.axis, layout.side, layout.strength)
    )
    if found.centre_mm is not None:
        centre[row] = frame.to_object(np.array(found.centre_mm))
    if found.axis is not None:
        axis[row] = _unit(frame.axes @ np.array(found.axis))
        side[row] = _unit(side[row] - (side[row] @ axis[row]) * axis[row])
    if found.flipped:
        axis[row] = -axis[row]
    if found.remanence_t is not None:
        strength[row] = found.remanence_t / spec.magnets.remanence_t
    return replace(layout, centre_mm=centre, axis=axis, side=side, strength=strength)


def sensors_as_built(
    spec: ObjectSpec, designed: SensorLayout, frames: tuple[FaceFrame, ...]
) -> SensorLayout:
    """Sensors where `as_built` found them; `frames` are those of the surfaces that they sit under."""
    from scipy.spatial.transform import Rotation

    of_face = {frame.number: frame for frame in frames}
    position, axes = designed.position_mm.copy(), designed.axes.copy()
    for found in spec.as_built.sensors:
        row, frame = _row(designed.face, found.face, found.sensor), of_face[found.face]
        if found.position_mm is not None:
            position[row] = frame.to_object(np.array(found.position_mm))
        turn = Rotation.from_rotvec(frame.axes @ np.deg2rad(found.rotation_deg)).as_matrix()
        axes[row] = axes[row] @ turn.T
    return replace(designed, position_mm=position, axes=axes)


def live_channels(spec: ObjectSpec) -> Bool[np.ndarray, "sensor 3"]:
    """Which channels work: the axes that the part measures, but those that `as_built` calls dead."""
    count, faces = spec.sensors.count_per_face, spec.body.sensed
    live = np.zeros((len(faces) * count, 3), bool)
    live[:, [_AXIS_NAMES.index(axis) for axis in spec.sensors.axes]] = True
    for found in spec.as_built.sensors:
        row = faces.index(found.face) * count + found.sensor - 1
        live[row, [_AXIS_NAMES.index(axis) for axis in found.dead]] = False
    return live


def _row(face: Int[np.ndarray, "part"], number: int, count_from_1: int) -> int:
    return int(np.flatnonzero(face == number)[count_from_1 - 1])


def _unit(vector: Float[np.ndarray, "3"]) -> Float[np.ndarray, "3"]:
    return vector / np.linalg.norm(vector)

"""Magnets, sensors and surroundings of an object, and the field that the sensors feel.

In a press either the magnets move with the silicone and the sensors rest in the core, or, in the
reverse arrangement, the sensors move and the magnets rest. Both are one flow here: every press
gives the motions of the shell's bodies, and whatever sits in the core has none.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np
from jaxtyping import Bool, Float, Int

from design.errors import InputError
from design.layout.places.positions import (
    MagnetLayout,
    SensorLayout,
    magnet_layout,
    sensor_layout,
    slipped,
)
from design.spec.object import ObjectSpec
from estimator.field.environment import Environment, environment, with_images
from estimator.field.models import MagnetsModel
from estimator.field.vectors import Vector, components, rotated
from estimator.signals.hall import ChipErrors, chip_errors, counts_of_field

_PAIRS_PER_CHUNK = 9000
"""Magnet–sensor pairs at a time: a dozen arrays of them in float64 fit a second-level cache. Larger
ones may be handed back to the system at every step, which costs three times the arithmetic."""


@dataclass(frozen=True)
class Scene:
    """Magnets and sensors at rest, which of them move, the chips' errors and the environment."""

    magnets: MagnetLayout
    sensors: SensorLayout
    chips: ChipErrors
    environment: Environment
    sensors_move: bool = False

    @property
    def bodies(self) -> int:
        """Return how many bodies move with the silicone."""
        return len(self.body_face)

    @property
    def body_face(self) -> Int[np.ndarray, "body"]:
        """The face that each of them belongs to."""
        return self.sensors.face if self.sensors_move else self.magnets.face


def scene(spec: ObjectSpec, core_slipped: bool = False) -> Scene:
    """The scene that a specification describes.

    With `core_slipped`, `mechanics.slip` moves what sits in the core, in the shell's frame.
    """
    magnets, sensors = magnet_layout(spec), sensor_layout(spec)
    sensors_move = spec.arrangement == "sensors-in-shell"
    if core_slipped and sensors_move:
        magnets = slipped(magnets, spec.mechanics.slip)
    elif core_slipped:
        sensors = slipped(sensors, spec.mechanics.slip)
    return Scene(
        magnets,
        sensors,
        chip_errors(spec.sensors, len(sensors.face), spec.seed),
        environment(spec),
        sensors_move,
    )


def sensed_field(
    scene: Scene, motion: Float[np.ndarray, "press body 6"], model: MagnetsModel
) -> Float[np.ndarray, "press sensor 3"]:
    """Flux density (T) at every sensor with the shell's bodies moved, in cache-sized chunks.

    A sensor that turns feels the field turned back: the result is in the directions that it has at
    rest, so that `SensorLayout.axes` serve all presses. Presses run along the last dimension, one
    sensor at a time: long contiguous rows; of few presses several sensors at a time.
    """
    chunk = max(1, _PAIRS_PER_CHUNK // len(scene.magnets.face))
    sensors = len(scene.sensors.face)
    field = np.empty((len(motion), sensors, 3))
    for start in range(0, len(motion), chunk):
        rows = slice(start, start + chunk)
        moved = motion[rows].transpose(2, 1, 0).copy()
        magnets = _magnets(scene, moved, model)
        group = max(1, chunk // moved.shape[2])
        for first in range(0, sensors, group):
            some = slice(first, first + group)
            parts = _field_at_sensors(scene, some, moved, magnets, model)
            field[rows, some] = np.stack(parts, axis=-1).swapaxes(0, 1)
    return field


@dataclass(frozen=True)
class KnownField:
    """Field that `sensed_field` found for a scene and its motions; others that differ in few magnets cost
    those alone."""

    scene: Scene
    motion: Float[np.ndarray, "press body 6"]
    field_t: Float[np.ndarray, "press sensor 3"]
    _of_some: dict[bytes, Float[np.ndarray, "press sensor 3"]] = field(
        default_factory=dict, init=False, repr=False, compare=False
    )

    def field_of(
        self, scene: Scene, motion: Float[np.ndarray, "press body 6"], model: MagnetsModel
    ) -> Float[np.ndarray, "press sensor 3"]:
        """`sensed_field` of another scene, to rounding."""
        changed = self._changed(scene, motion)
        if changed is None or 2 * changed.sum() > len(changed):
            return sensed_field(scene, motion, model)
        if not changed.any():
            return self.field_t
        key = changed.tobytes()
        if key not in self._of_some:
            self._of_some[key] = sensed_field(
                _some_magnets(self.scene, changed), self.motion[:, changed], model
            )
        after = sensed_field(_some_magnets(scene, changed), motion[:, changed], model)
        return self.field_t + (after - self._of_some[key])

    def _changed(
        self, scene: Scene, motion: Float[np.ndarray, "press body 6"]
    ) -> Bool[np.ndarray, "magnet"] | None:
        """Magnets that differ; None where more does, or where sensors move."""
        old, around, was = self.scene.magnets, scene.environment, self.scene.environment
        if scene.sensors_move or motion.shape != self.motion.shape:
            return None
        if around.strays is not was.strays or around.plates is not was.plates:
            return None
        alike = (
            np.array_equal(scene.sensors.position_mm, self.scene.sensors.position_mm),
            np.array_equal(around.uniform_t, was.uniform_t),
        )
        if not all(alike):
            return None
        moved = scene.magnets.strength != old.strength
        if motion is not self.motion:
            moved |= (motion != self.motion).any(axis=0).any(axis=1)
        for name in ("centre_mm", "axis", "side"):
            moved |= np.any(getattr(scene.magnets, name) != getattr(old, name), axis=1)
        return moved


def _some_magnets(scene: Scene, chosen: Bool[np.ndarray, "magnet"]) -> Scene:
    return replace(scene, magnets=scene.magnets.choose(chosen))


def counts(
    scene: Scene, field_t: Float[np.ndarray, "*any sensor 3"], spec: ObjectSpec
) -> Float[np.ndarray, "*any sensor 3"]:
    """Expected counts of a field as `sensed_field` gives it."""
    axes = scene.chips.matrix @ scene.sensors.axes
    offset = spec.sensors.counts_per_mt * scene.chips.offset_mt
    return counts_of_field(1e3 * field_t, axes, spec.sensors) + offset


def zero_motion(scene: Scene) -> Float[np.ndarray, "1 body 6"]:
    """No motion of any body."""
    return np.zeros((1, scene.bodies, 6))


_Magnets = tuple[Vector, Vector, Vector]
"""Centres, axes and sides (those of blocks turn with them, round magnets need none)."""


def _magnets(
    scene: Scene, moved: Float[np.ndarray, "6 body press"], model: MagnetsModel
) -> _Magnets:
    magnets = scene.magnets
    centre, axis, side = (
        components(given[:, None]) for given in (magnets.centre_mm, magnets.axis, magnets.side)
    )
    if scene.sensors_move:
        return centre, axis, side
    x, y, z, *turns = moved
    turn = (turns[0], turns[1], turns[2])
    shifted = (centre[0] + x, centre[1] + y, centre[2] + z)
    if model.has_side:
        side = rotated(side, turn)
    return shifted, rotated(axis, turn), side


def _field_at_sensors(
    scene: Scene,
    some: slice,
    moved: Float[np.ndarray, "6 body press"],
    magnets: _Magnets,
    model: MagnetsModel,
) -> list[Float[np.ndarray, "sensor press"]]:
    """Field of all sources at some sensors, in the directions that they have at rest.

    Magnets run along a dimension before those of sensors and presses.
    """
    shape = len(scene.sensors.face[some]), moved.shape[2]
    point = components(scene.sensors.position_mm[some, None])
    sensor_motion = moved[:, some] if scene.sensors_move else None
    if sensor_motion is not None:
        point = (
            point[0] + sensor_motion[0],
            point[1] + sensor_motion[1],
            point[2] + sensor_motion[2],
        )
    centres, axes, sides = (_among_sensors(given) for given in magnets)
    size = scene.magnets.size
    if model.exact:
        check_sensor_clear(point, (centres, axes, sides), model, size)
    strength, plates = scene.magnets.strength[:, None, None], scene.environment.plates
    field = with_images(point, centres, axes, model, plates, sides, strength, size)
    around = scene.environment.field_at(point)
    field = (field[0] + around[0], field[1] + around[1], field[2] + around[2])
    if sensor_motion is not None:
        field = rotated(field, (-sensor_motion[3], -sensor_motion[4], -sensor_motion[5]))
    return [np.broadcast_to(part, shape) for part in field]


def _among_sensors(vector: Vector) -> Vector:
    """With a dimension for sensors."""
    x, y, z = vector
    return x[:, None], y[:, None], z[:, None]


def check_sensor_clear(
    point: Vector, magnets: _Magnets, model: MagnetsModel, size: Int[np.ndarray, "magnet"]
) -> None:
    for number, size_model in enumerate(model.size_models):
        centres, axes, sides = (tuple(part[size == number] for part in given) for given in magnets)
        offset = (point[0] - centres[0], point[1] - centres[1], point[2] - centres[2])
        if size_model.magnet.holds(offset, axes, sides).any():
            raise InputError(
                f"a press drives {size_model.magnet.description} onto a sensor. "
                "Press less deep or move sensors and magnets further apart"
            )


def min_distance_mm(scene: Scene, motion: Float[np.ndarray, "press body 6"]) -> float:
    """Smallest distance between a magnet's centre and a sensor over all presses and at rest.

    |c − s|² is expanded, so that one matrix product serves all pairs: 1e-14 of |c|² is lost.
    Images in steel plates are further away than their magnets.
    """
    moving, fixed = scene.magnets.centre_mm, scene.sensors.position_mm
    if scene.sensors_move:
        moving, fixed = fixed, moving
    chunk = max(1, _PAIRS_PER_CHUNK // len(fixed))
    smallest = _nearest_squared(moving, fixed)
    for start in range(0, len(motion), chunk):
        here = (moving + motion[start : start + chunk, :, :3]).reshape(-1, 3)
        smallest = min(smallest, _nearest_squared(here, fixed))
    return float(np.sqrt(max(smallest, 0.0)))


def _nearest_squared(
    moving_mm: Float[np.ndarray, "moving 3"], fixed_mm: Float[np.ndarray, "fixed 3"]
) -> float:
    squared = np.sum(moving_mm**2, axis=1) - 2 * fixed_mm @ moving_mm.T
    return float(np.min(squared.min(axis=1) + np.sum(fixed_mm**2, axis=1)))

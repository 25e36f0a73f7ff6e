"""One object as it may be assembled: magnets, sensors and surroundings off the design, and its counts.

Draws are standard normal numbers, one array per contribution, scaled by `design.spec.assembly`.
Contributions that are not drawn stay at the design. Mechanics is the design's throughout
(`estimator.tolerances.budget` makes up for bodies that sit aside).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Float, Int

from design.catalogue.magnets import NDFEB_REMANENCE_PER_KELVIN
from design.layout.body import face_frames
from design.layout.places.positions import MagnetLayout, SensorLayout, slipped
from design.spec.assembly import TolerancesSpec
from design.spec.mechanics import SlipSpec
from design.spec.object import ObjectSpec
from estimator.field.models import MagnetsModel
from estimator.field.vectors import rotate
from estimator.signals.field_setup import Scene, counts, scene, sensed_field
from estimator.signals.hall import ChipErrors

CONTRIBUTIONS = {
    "magnet_seat": ("magnet_seat_mm", "magnet seat, lateral"),
    "magnet_depth": ("magnet_seat_mm", "magnet seat, depth"),
    "magnet_tilt": ("magnet_tilt_deg", "magnet tilt"),
    "remanence": ("remanence_relative", "remanence"),
    "sensor_seat": ("sensor_seat_mm", "sensor seat"),
    "sensor_rotation": ("sensor_rotation_deg", "sensor rotation"),
    "sensor_gain": ("sensor_gain_relative", "sensor gain"),
    "sensor_offset": ("sensor_offset_ut", "sensor offset"),
    "core_shift": ("core_shift_mm", "core shift"),
    "core_yaw": ("core_yaw_deg", "core yaw"),
    "modulus": ("modulus_relative", "modulus"),
    "temperature": ("temperature_k", "temperature"),
    "earth_field": ("earth_field_ut", "Earth's field"),
}
"""Name → the field of `tolerances` that scales it, and what people read."""

Draws = Mapping[str, Float[np.ndarray, "number"]]
_Numbers = dict[str, Float[np.ndarray, "number"]]


@dataclass(frozen=True)
class Assembly:
    """One assembled object.

    Attributes
    ----------
    scene : magnets, sensors, chips; its environment is that in which the object is zeroed
    modulus_ratio : Young's modulus over the design's
    earth_change_t : (3,) change of Earth's field (T) between zeroing and the press
    aside_mm : (body, 2) how far each body in the silicone sits from its seat, in x, y of its face
    """

    scene: Scene
    modulus_ratio: float
    earth_change_t: Float[np.ndarray, "3"]
    aside_mm: Float[np.ndarray, "body 2"]

    @property
    def pressed_scene(self) -> Scene:
        """The scene in the press, when the object may have been turned."""
        around = self.scene.environment
        uniform = around.uniform_t + self.earth_change_t
        return replace(self.scene, environment=replace(around, uniform_t=uniform))


def designed(spec: ObjectSpec) -> Assembly:
    """The object of the specification, with `as_built` and its own environment."""
    return undisturbed(scene(spec))


def undisturbed(place: Scene) -> Assembly:
    """A scene as it is, assembled to the design."""
    return Assembly(place, 1.0, np.zeros(3), np.zeros((place.bodies, 2)))


def counts_of(
    spec: ObjectSpec,
    place: Scene,
    motion: Float[np.ndarray, "press body 6"],
    model: MagnetsModel,
    face: int | None = None,
) -> Float[np.ndarray, "press sensor 3"]:
    """Expected counts (absolute) with the bodies moved, of one face's sensors or of all."""
    place, motion = read_by(place, motion, face)
    return counts(place, sensed_field(place, motion, model), spec)


def read_by(
    place: Scene, motion: Float[np.ndarray, "press body 6"], face: int | None
) -> tuple[Scene, Float[np.ndarray, "press some_body 6"]]:
    """With the sensors of one face alone, and the motions of what then moves; all where None."""
    if face is None:
        return place, motion
    chosen = place.sensors.face == face
    sensors, chips = place.sensors, place.chips
    some = replace(
        place,
        sensors=SensorLayout(
            sensors.position_mm[chosen], sensors.axes[chosen], sensors.face[chosen]
        ),
        chips=ChipErrors(chips.matrix[chosen], chips.offset_mt[chosen]),
    )
    return some, motion[:, chosen] if place.sensors_move else motion


def contribution_sizes(assembly: Assembly) -> dict[str, int]:
    """Return how many independent numbers each contribution has."""
    magnets, sensors = len(assembly.scene.magnets.face), len(assembly.scene.sensors.face)
    return {
        "magnet_seat": 2 * magnets,
        "magnet_depth": magnets,
        "magnet_tilt": 2 * magnets,
        "remanence": magnets,
        "sensor_seat": 3 * sensors,
        "sensor_rotation": 3 * sensors,
        "sensor_gain": 3 * sensors,
        "sensor_offset": 3 * sensors,
        "core_shift": 3,
        "core_yaw": 1,
        "modulus": 1,
        "temperature": 1,
        "earth_field": 6,
    }


def assembled(spec: ObjectSpec, design: Assembly, draws: Draws) -> Assembly:
    """The design with the drawn disturbances.

    Directions are those of the face that a magnet or sensor belongs to (its x, y, normal), turns of
    the core those of the object. Earth's field is normal with its size as rms, twice independently.
    """
    numbers = {name: np.zeros(size) for name, size in contribution_sizes(design).items()}
    for name, values in draws.items():
        numbers[name] = numbers[name] + values
    tolerances, place = spec.tolerances, design.scene
    magnets = _moved_magnets(spec, place.magnets, tolerances, numbers)
    sensors = moved_sensors(spec, place.sensors, tolerances, numbers)
    slip = SlipSpec(
        shift_mm=(tolerances.core_shift_mm * numbers["core_shift"]).tolist(),
        rotation_deg=(0.0, 0.0, tolerances.core_yaw_deg * float(numbers["core_yaw"][0])),
    )
    if place.sensors_move:
        magnets = slipped(magnets, slip)
    else:
        sensors = slipped(sensors, slip)
    gain = 1 + tolerances.sensor_gain_relative * numbers["sensor_gain"].reshape(-1, 3, 1)
    zeroed_t, pressed_t = (
        1e-6 * tolerances.earth_field_ut / np.sqrt(3) * numbers["earth_field"].reshape(2, 3)
    )
    around = replace(place.environment, uniform_t=place.environment.uniform_t + zeroed_t)
    offset_mt = 1e-3 * tolerances.sensor_offset_ut * numbers["sensor_offset"].reshape(-1, 3)
    chips = ChipErrors(gain * place.chips.matrix, place.chips.offset_mt + offset_mt)
    return Assembly(
        replace(place, magnets=magnets, sensors=sensors, chips=chips, environment=around),
        design.modulus_ratio * float(np.exp(tolerances.modulus_relative * numbers["modulus"][0])),
        design.earth_change_t + pressed_t - zeroed_t,
        design.aside_mm + shift_aside_mm(tolerances, place.sensors_move, numbers),
    )


def shift_aside_mm(
    tolerances: TolerancesSpec, sensors_move: bool, numbers: _Numbers
) -> Float[np.ndarray, "body 2"]:
    if sensors_move:
        return tolerances.sensor_seat_mm * numbers["sensor_seat"].reshape(-1, 3)[:, :2]
    return tolerances.magnet_seat_mm * numbers["magnet_seat"].reshape(-1, 2)


def draw(spec: ObjectSpec, design: Assembly, rng: np.random.Generator) -> Assembly:
    """One object at random, all contributions together."""
    sizes = contribution_sizes(design)
    return assembled(
        spec, design, {name: rng.standard_normal(size) for name, size in sizes.items()}
    )


def _moved_magnets(
    spec: ObjectSpec, magnets: MagnetLayout, tolerances: TolerancesSpec, numbers: _Numbers
) -> MagnetLayout:
    axes = face_axes(spec, magnets.face)
    lateral = tolerances.magnet_seat_mm * numbers["magnet_seat"].reshape(-1, 2)
    depth = tolerances.magnet_seat_mm * numbers["magnet_depth"]
    tilt = np.deg2rad(tolerances.magnet_tilt_deg) * numbers["magnet_tilt"].reshape(-1, 2)
    # Drawn in the face's frame, wanted in the object's: m magnet, j axis of the face, i coordinate
    shift = np.einsum("mij,mj->mi", axes, np.column_stack([lateral, depth]))
    turn = np.einsum("mij,mj->mi", axes[:, :, :2], tilt)
    stronger = 1 + tolerances.remanence_relative * numbers["remanence"]
    rise_k = tolerances.temperature_k * float(numbers["temperature"][0])
    # remanence is stated at 20 °C, and falls linearly
    warmer = 1 + NDFEB_REMANENCE_PER_KELVIN * rise_k
    return replace(
        magnets,
        centre_mm=magnets.centre_mm + shift,
        axis=rotate(magnets.axis, turn),
        side=rotate(magnets.side, turn),
        strength=magnets.strength * stronger * warmer,
    )


def moved_sensors(
    spec: ObjectSpec, sensors: SensorLayout, tolerances: TolerancesSpec, numbers: _Numbers
) -> SensorLayout:
    axes = face_axes(spec, sensors.face)
    seat = tolerances.sensor_seat_mm * numbers["sensor_seat"].reshape(-1, 3)
    turn = np.deg2rad(tolerances.sensor_rotation_deg) * numbers["sensor_rotation"].reshape(-1, 3)
    return replace(
        sensors,
        # s sensor, j axis of its face, i object coordinate
        position_mm=sensors.position_mm + np.einsum("sij,sj->si", axes, seat),
        axes=rotate(sensors.axes, np.einsum("sij,sj->si", axes, turn)[:, None].repeat(3, axis=1)),
    )


def face_axes(spec: ObjectSpec, face: Int[np.ndarray, "part"]) -> Float[np.ndarray, "part 3 3"]:
    """x, y and outward normal of each part's face, as columns."""
    frames = {frame.number: frame.axes for frame in face_frames(spec)}
    return np.stack([frames[number] for number in face.tolist()])

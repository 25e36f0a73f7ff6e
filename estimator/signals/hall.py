"""Three-axis Hall sensors: field to counts, one noisy reading, saturation.

Counts per mT, range and noise of known parts stand in `catalogue.hall_sensors`; those of the TMAG5273A1
were measured on the public recordings (16× averaging, ±40 mT), drift too.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from design.catalogue.hall_sensors import wider_range
from design.errors import InputError
from design.layout.places.positions import MagnetLayout, SensorLayout
from design.spec.object import SensorSpec
from estimator.field.sources import Magnet

LARGEST_COUNT = 32767
"""16-bit converter."""
_AXIS_NAMES = "XYZ"
_CHIPS = 5273
"""Keeps this stream of random numbers apart from others of the same seed."""


def full_scale_counts(sensors: SensorSpec) -> float:
    """Largest magnitude that a reading can take, counts."""
    return float(min(np.floor(sensors.range_mt * sensors.counts_per_mt), LARGEST_COUNT))


def counts_of_field(
    field_mt: Float[np.ndarray, "*any sensor 3"],
    axes: Float[np.ndarray, "sensor 3 3"],
    sensors: SensorSpec,
) -> Float[np.ndarray, "*any sensor 3"]:
    """Expected counts of the chip axes X, Y, Z for fields (mT) in the object's frame.

    `axes` holds the chip axes as rows (`design.layout.places.positions.SensorLayout.axes`). No noise,
    no rounding, no limit: `read_out` adds them.
    """
    by_sensor = np.moveaxis(field_mt, -2, 0).reshape(len(axes), -1, 3)
    turned = (by_sensor @ axes.swapaxes(1, 2)).swapaxes(0, 1)  # einsum takes three times as long
    return sensors.counts_per_mt * turned.reshape(field_mt.shape)


@dataclass(frozen=True)
class ChipErrors:
    """Deviations of real chips from nominal ones: signals = matrix · B + offset.

    `matrix` (sensor, axis, axis) holds gains on its diagonal and cross-axis shares off it.
    """

    matrix: Float[np.ndarray, "sensor 3 3"]
    offset_mt: Float[np.ndarray, "sensor 3"]


def chip_errors(sensors: SensorSpec, count: int, seed: int) -> ChipErrors:
    """Chips drawn at random within the tolerances of the specification (rms, normal).

    Without tolerances every chip is nominal.
    """
    rng = np.random.default_rng([seed, _CHIPS])
    diagonal = np.eye(3, dtype=bool)
    rms = np.where(diagonal, *sensors.chip_spread)
    matrix = np.eye(3) + rms * rng.standard_normal((count, 3, 3))
    return ChipErrors(matrix, np.zeros((count, 3)))


def read_out(
    expected_counts: Float[np.ndarray, "*any 3"], sensors: SensorSpec, rng: np.random.Generator
) -> Float[np.ndarray, "*any 3"]:
    """One reading: white noise of `sensors.noise_counts`, whole counts, clipped to full scale."""
    noise = rng.standard_normal(expected_counts.shape) * np.asarray(sensors.noise_counts)
    limit = full_scale_counts(sensors)
    return np.clip(np.round(expected_counts + noise), -limit, limit)


def check_rest(
    rest_counts: Float[np.ndarray, "sensor 3"], layout: SensorLayout, sensors: SensorSpec
) -> None:
    """Refuse a design in which a sensor saturates with nothing pressed.

    Raises
    ------
    InputError
        Names the sensor and its axis, by how much it saturates and which range would do.
    """
    sensor, axis = np.unravel_index(np.argmax(abs(rest_counts)), rest_counts.shape)
    largest_counts = abs(rest_counts[sensor, axis])
    if largest_counts <= full_scale_counts(sensors):
        return
    largest_mt = largest_counts / sensors.counts_per_mt
    wider = wider_range(sensors.part, sensors.range_mt, largest_mt)
    change = "a magnet farther away or weaker"
    if wider is not None:
        part, selectable = wider
        change = (
            f"the ±{selectable.range_mt:g} mT range of {part.name} (sensors.range_mt = "
            f"{selectable.range_mt:g}, sensors.counts_per_mt = {selectable.counts_per_mt:.4g}), "
            f"or {change}"
        )
    limit = full_scale_counts(sensors)
    raise InputError(
        f"{_sensor_name(int(sensor), layout)} saturates at rest: axis {_AXIS_NAMES[axis]} sees "
        f"{largest_mt:.3g} mT, {largest_counts / limit - 1:.1%} beyond full scale "
        f"(±{limit:.0f} counts at {sensors.counts_per_mt:g} counts/mT). Choose {change}"
    )


def check_sensors_outside_magnets(
    layout: SensorLayout, magnets: MagnetLayout, bodies: tuple[Magnet, ...]
) -> None:
    """Refuse a design in which a sensor's sensing point lies in a magnet at rest.

    `bodies` are one of each of the magnets' sizes.
    """
    offset = (layout.position_mm[:, None] - magnets.centre_mm).transpose(2, 0, 1)
    inside = np.zeros(offset.shape[1:], bool)
    for number, body in enumerate(bodies):
        is_of_size = magnets.size == number
        axis, side = magnets.axis[is_of_size].T[:, None], magnets.side[is_of_size].T[:, None]
        inside[:, is_of_size] = body.holds(
            tuple(offset[:, :, is_of_size]), tuple(axis), tuple(side)
        )
    if inside.any():
        sensor, magnet = np.argwhere(inside)[0]
        distance = np.linalg.norm(offset[:, sensor, magnet])
        raise InputError(
            f"{_sensor_name(int(sensor), layout)} lies inside magnet {magnet} (face "
            f"{magnets.face[magnet]}): {distance:.3g} mm from the centre of "
            f"{bodies[magnets.size[magnet]].description}. Move the sensor or the magnet"
        )


def _sensor_name(sensor: int, layout: SensorLayout) -> str:
    face = layout.face[sensor]
    return f"sensor {sensor - int(np.argmax(layout.face == face)) + 1} of face {face}"

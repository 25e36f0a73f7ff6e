"""Field to counts along the chip axes, one reading, saturation at rest."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError
from design.layout.places.positions import magnet_layout, sensor_layout
from design.spec.object import ObjectSpec, SensorSpec
from estimator.field.sources import magnet_sources
from estimator.signals.hall import (
    check_rest,
    check_sensors_outside_magnets,
    counts_of_field,
    full_scale_counts,
    read_out,
)

SPEC = ObjectSpec(name="cube")
LAYOUT = sensor_layout(SPEC)


def test_counts_are_field_components_along_the_chip_axes():
    rng = np.random.default_rng(1)
    field_mt = rng.normal(size=(2, 4, len(LAYOUT.face), 3))
    counts = counts_of_field(field_mt, LAYOUT.axes, SPEC.sensors)
    for sensor in (0, 7, 14):
        for axis in range(3):
            expected = 820 * field_mt[..., sensor, :] @ LAYOUT.axes[sensor, axis]
            assert_allclose(counts[..., sensor, axis], expected, rtol=1e-12)
    transposed = counts_of_field(field_mt, LAYOUT.axes.transpose(0, 2, 1), SPEC.sensors)
    assert abs(transposed - counts).max() > 500


def test_outward_field_reads_positive_on_z_of_every_face():
    normal = np.array([LAYOUT.axes[sensor, 2] for sensor in range(15)])
    counts = counts_of_field(2.5 * normal, LAYOUT.axes, SPEC.sensors)
    assert_allclose(counts, np.tile([0, 0, 2050.0], (15, 1)), atol=1e-9)


def test_reading_has_the_noise_of_each_axis_and_whole_counts():
    expected = np.full((20000, 2, 3), 100.25)
    reading = read_out(expected, SPEC.sensors, np.random.default_rng(2))
    assert_allclose(reading, np.round(reading), rtol=0)
    assert_allclose(reading.std(axis=(0, 1)), [22, 22, 11], rtol=0.02)
    assert_allclose(reading.mean(axis=(0, 1)), 100.25, atol=0.4)


def test_reading_clips_at_the_range_or_at_16_bits():
    narrow = SensorSpec(range_mt=2.0)
    assert full_scale_counts(narrow) == 1640
    assert full_scale_counts(SensorSpec()) == 32767
    expected = np.array([[5000.0, -5000.0, 10.0]])
    reading = read_out(expected, narrow, np.random.default_rng(3))
    assert reading[0, 0] == 1640
    assert reading[0, 1] == -1640


def test_saturation_at_rest_names_sensor_excess_and_remedy():
    counts = np.zeros((15, 3))
    counts[7, 2] = -45.0 * 820
    with pytest.raises(InputError, match=r"sensor 2 of face 3 .* axis Z sees 45 mT.*±80 mT"):
        check_rest(counts, LAYOUT, SPEC.sensors)
    check_rest(counts * 39.9 / 45, LAYOUT, SPEC.sensors)
    with pytest.raises(InputError, match="Choose a magnet farther away"):
        check_rest(counts * 10, LAYOUT, SPEC.sensors)


def test_sensor_in_a_magnet_is_refused():
    magnets, disk = magnet_layout(SPEC), magnet_sources(SPEC.magnets)
    check_sensors_outside_magnets(LAYOUT, magnets, disk)
    moved = LAYOUT.position_mm.copy()
    moved[4] = magnets.centre_mm[8] + 0.4 * magnets.axis[8]
    with pytest.raises(InputError, match=r"sensor 2 of face 2 lies inside magnet 8 \(face 2\)"):
        check_sensors_outside_magnets(replace(LAYOUT, position_mm=moved), magnets, disk)


def test_a_wider_range_of_the_part_is_named_where_it_would_do():
    narrow = SPEC.sensors.changed(range_mt=20.0, counts_per_mt=1640.0)
    counts = np.zeros((15, 3))
    counts[14, 0] = 1640 * 20.0
    check_rest(np.minimum(counts, full_scale_counts(narrow)), LAYOUT, narrow)
    counts[14, 0] = 1640 * 30.0
    with pytest.raises(InputError) as told:
        check_rest(counts, LAYOUT, narrow)
    beyond = 1640 * 30.0 / full_scale_counts(narrow) - 1
    assert str(told.value).startswith(
        f"sensor 3 of face 5 saturates at rest: axis X sees 30 mT, {beyond:.1%} beyond full scale "
        f"(±{full_scale_counts(narrow):.0f} counts at 1640 counts/mT)."
    )

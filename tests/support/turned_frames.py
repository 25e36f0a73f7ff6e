"""Frames of an object that is zeroed, turned in Earth's field and pressed: a second forward model.

Its magnets are magpylib's, moved by motions that are given; its chips count by hand. It shares the
layout and the magnets' working point with the product, and no field law, spline or sum of signals.
"""

import magpylib
import numpy as np
from scipy.spatial.transform import Rotation

from design.layout.places.positions import sensor_layout
from estimator.field.sources import magnet_source
from estimator.signals.field_setup import scene


def magnets_field_t(spec, motion, built=None):
    """Flux density (state, sensor, 3) of disk magnets that have moved (state, body, 6) from rest; `built` is
    the scene of a drawn object in place of the specification's."""
    built = scene(spec) if built is None else built
    magnets, disk = built.magnets, magnet_source(spec.magnets)
    sensors_m = built.sensors.position_mm / 1e3
    field = np.zeros((len(motion), len(sensors_m), 3))
    for number, (centre, axis) in enumerate(zip(magnets.centre_mm, magnets.axis, strict=True)):
        own = motion[:, number]
        upright = Rotation.align_vectors(axis[None], [[0.0, 0.0, 1.0]])[0]
        moved = magpylib.magnet.Cylinder(
            polarization=(0, 0, disk.polarization_t * magnets.strength[number]),
            dimension=(disk.diameter_mm / 1e3, disk.height_mm / 1e3),
            position=(centre + own[:, :3]) / 1e3,
            orientation=Rotation.from_rotvec(own[:, 3:]) * upright,
        )
        field += moved.getB(sensors_m).reshape(field.shape)
    return field


def expected_counts(spec, field_t, built=None):
    """Counts (state, channel) of a field (T) at every sensor along its own axes, by its own gains."""
    built = scene(spec) if built is None else built
    # n state, s sensor, a axis of the chip as read, b as it stands, c coordinate
    matrix, axes = built.chips.matrix, built.sensors.axes
    seen_mt = 1e3 * np.einsum("sab,sbc,nsc->nsa", matrix, axes, field_t)
    return spec.sensors.counts_per_mt * seen_mt.reshape(len(field_t), -1)


def read_out(spec, field_t, rng, built=None):
    """One reading of each state: white noise, whole counts."""
    expected = expected_counts(spec, field_t, built)
    noise = np.resize(spec.sensors.noise_counts, expected.shape[1])
    return np.round(expected + noise * rng.standard_normal(expected.shape))


def earth_fields_t(rng, frames, earth_ut=50.0):
    """Earth's field in the object's frame at the zero and in each frame, of random directions."""
    direction = rng.standard_normal((2, frames, 3))
    return 1e-6 * earth_ut * direction / np.linalg.norm(direction, axis=2, keepdims=True)


def foreign_magnets_t(spec, rng, frames, distance_mm, moment_am2):
    """Field (frame, sensor, 3) of a dipole anywhere at a distance from the middle, in any direction."""
    sensors_m, field = sensor_layout(spec).position_mm / 1e3, []
    for place, moment in rng.standard_normal((frames, 2, 3)):
        position = 1e-3 * distance_mm * place / np.linalg.norm(place)
        moment = moment_am2 * moment / np.linalg.norm(moment)
        field.append(magpylib.misc.Dipole(moment=moment, position=position).getB(sensors_m))
    return np.array(field)


def zeroed_counts(spec, motion, rng, turned=True, earth_ut=50.0, foreign_t=0.0, built=None):
    """Changes of counts (frame, channel) against a zero of each frame's own, taken in another orientation
    with the error that the specification has; `foreign_t` has come since. Of the object as `built`."""
    before, now = earth_fields_t(rng, len(motion), earth_ut)
    now = now if turned else before
    still = magnets_field_t(spec, np.zeros((1, *motion.shape[1:])), built)
    zero = expected_counts(spec, still + before[:, None], built)
    zero += spec.sensors.zeroing_counts * rng.standard_normal(zero.shape)
    pressed_t = magnets_field_t(spec, motion, built) + now[:, None] + foreign_t
    return read_out(spec, pressed_t, rng, built) - zero

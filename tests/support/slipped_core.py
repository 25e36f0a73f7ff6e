"""Grasps of the object of analytic presses whose core slips, by the second forward model of turned frames."""

import numpy as np

from estimator.inversion.slip import REST_FRAMES
from tests.support.mechanics.inverted import SPEC, contacts, motion_of
from tests.support.turned_frames import (
    earth_fields_t,
    expected_counts,
    magnets_field_t,
    read_out,
)

GRASP = 25
"""Frames of a grasp: eight of a press, then rest."""


def shift(rng, mm):
    """Motion of every magnet when the core has shifted in some direction."""
    way = rng.standard_normal(3)
    return np.append(mm * way / np.linalg.norm(way), [0.0, 0.0, 0.0])


def grasps(rng, slip_mm, slips_at=0, presses=4):
    """Raw counts of rest and presses; the core slips in that frame. With the true faces."""
    frames = GRASP * (presses + 1)
    face, contact = np.full((frames, 6), -1), np.zeros((frames, 6, 3))
    for number in range(1, presses + 1):
        pressed = slice(GRASP * number, GRASP * number + 8)
        face[pressed], contact[pressed] = contacts(rng, 1, 1, (4.0, 8.0))
    motion = motion_of(face, contact)
    motion[slips_at:] += shift(rng, slip_mm)
    field_t = magnets_field_t(SPEC, motion) + earth_fields_t(rng, 1)[0][:, None]
    return read_out(SPEC, field_t, rng), face


def zeroed(raw, rng):
    """Changes against a zero of the unslipped object in another orientation."""
    still_t = magnets_field_t(SPEC, np.zeros((1, 25, 6))) + earth_fields_t(rng, 1)[1][:, None]
    zero = expected_counts(SPEC, still_t)
    return raw - zero - SPEC.sensors.zeroing_counts * rng.standard_normal(zero.shape)


def resting_mean(rng, motion=None, foreign_t=0.0):
    """Mean change of ten frames at rest."""
    moved = np.zeros((REST_FRAMES, 25, 6)) + (0.0 if motion is None else motion)
    field_t = magnets_field_t(SPEC, moved) + earth_fields_t(rng, 1)[0][:, None] + foreign_t
    return zeroed(read_out(SPEC, field_t, rng), rng).mean(axis=0)


def noisy_means(rng, number):
    """Yield mean changes of ten frames at rest, each turned after a zero of its own."""
    still_t = magnets_field_t(SPEC, np.zeros((1, 25, 6)))
    rest = expected_counts(SPEC, still_t)
    noise = np.resize(SPEC.sensors.noise_counts, rest.shape[1])
    for _ in range(number):
        before_t, now_t = earth_fields_t(rng, 1)
        turned = expected_counts(SPEC, np.broadcast_to(now_t - before_t, (1, *still_t.shape[1:])))
        zero = SPEC.sensors.zeroing_counts * rng.standard_normal(rest.shape)
        counts = np.round(rest + turned + noise * rng.standard_normal((REST_FRAMES, rest.shape[1])))
        yield (counts - rest - zero).mean(axis=0)

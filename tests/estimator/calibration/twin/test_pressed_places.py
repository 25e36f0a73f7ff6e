"""Which frames become means of pressed places, and the variance of these, worked out by hand."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from design.errors import InputError
from design.spec.object import ObjectSpec
from estimator.calibration.twin.pressed_places import (
    PressedPlaces,
    drift_rate,
    pressed_places,
)
from estimator.frames.press_protocol import DRIFT_TIME_S
from tests.support.mechanics.synthetic_presses import coarse_spec
from tests.support.recordings.frame_sets import frame_set


def test_variance_is_that_of_frames_and_of_labelled_forces_through_the_slope():
    spec = ObjectSpec.model_validate(
        {
            "name": "c",
            "protocol": {"force_noise_n": 0.1},
            "sensors": {"noise_counts": (2.0, 3.0, 4.0)},
        }
    )
    counts = np.array([[[10.0, 20.0, -30.0], [40.0, 0.0, 60.0]]])
    seen = PressedPlaces(
        *(1, np.array([0, 4, 8]), np.zeros((1, 2)), np.array([[2.0, 5.0]]), counts),
        *(np.array([[4, 9]]), np.zeros((1, 2, 2))),
    )
    by_hand = [
        [(4 + 0.5**2) / 4, (9 + 1.0**2) / 4, (16 + 1.5**2) / 4],
        [(4 + 0.8**2) / 9, 9 / 9, (16 + 1.2**2) / 9],
    ]
    assert_allclose(seen.white_counts2(spec), [by_hand])
    recorded = replace(seen, noise_counts=np.array([2.0, np.nan, 5.0]))
    by_hand[0][2] += (25 - 16) / 4
    by_hand[1][2] += (25 - 16) / 9
    assert_allclose(recorded.white_counts2(spec), [by_hand])


def made_frames(spec, frames_of_place, face=2):
    """Presses straight down on one face, four frames each, at places 3 mm apart, and some others."""
    rows = [(place, k) for place, count in enumerate(frames_of_place) for k in range(count)]
    place, k = np.array(rows).T
    count = len(rows)
    force = 2.0 + (k // 4)
    signal = np.full((count, 5, 3, 3), np.nan)
    signal[:, face - 1] = (100.0 * place + 10.0 * force)[:, None, None]
    xy = np.column_stack([3.0 * place - 6.0, 0.0 * place])[:, None]
    press = {"press_id": 10 * place + k // 4, "place_id": place}
    return frame_set(signal, np.full((count, 1), face), xy, force[:, None], **press)


def test_places_with_twelve_frames_or_more_become_means_of_like_force():
    spec = coarse_spec(contact_grid={"count": (9, 9), "pitch_mm": 3.0})
    found = pressed_places(spec, made_frames(spec, [12, 16, 12, 11, 24]), 2)
    assert len(found) == 4
    assert_allclose(found.xy_mm, [[-6, 0], [-3, 0], [0, 0], [6, 0]])
    assert_array_equal(found.channels, np.arange(9))
    assert found.frames.sum(axis=1).tolist() == [12, 16, 12, 24]
    assert (np.diff(found.force_n, axis=1) > 0).all()
    assert_allclose(found.force_n[0, 0], 2.0)
    place = np.array([0.0, 1.0, 2.0, 4.0])
    wanted = 100 * place[:, None] + 10 * found.force_n
    assert_allclose(found.counts, np.repeat(wanted[..., None], 9, axis=2))
    with pytest.raises(
        InputError, match="got 3 such places: of 70 frames that press this face 0 press"
    ):
        pressed_places(spec, made_frames(spec, [12, 11, 12, 11, 24]), 2)


def test_frames_that_are_pulled_shared_invalid_or_of_other_faces_are_left_out():
    spec = coarse_spec(contact_grid={"count": (9, 9), "pitch_mm": 3.0})
    frames = made_frames(spec, [13, 13, 13, 13, 13])
    noise = spec.protocol.force_noise_n
    first = np.searchsorted(frames.place_id, np.arange(5))
    pulled, other, valid = (
        one.copy() for one in (frames.force_n, frames.contact_face, frames.valid)
    )
    pulled[first[0] : first[0] + 2, 0, 0] = 4.01 * noise
    pulled[first[1], 0, 1] = 4.01 * noise
    pulled[first[1] + 1, 0, 1] = 3.99 * noise
    other[first[2]] = 3
    valid[first[3]] = False
    changed = replace(frames, force_n=pulled, contact_face=other, valid=valid)
    found = pressed_places(spec, changed, 2)
    assert found.frames.sum(axis=1).tolist() == [12, 12, 12, 13]
    assert_allclose(found.xy_mm[:, 0], [-3, 0, 3, 6])


def test_drift_grows_over_its_time_and_half_the_frames_that_follow_a_zero():
    spec = ObjectSpec.model_validate(
        {
            "name": "c",
            "sensors": {"drift_counts": 30.0, "zeroing_counts": 7.0, "frame_rate_hz": 20.0},
        }
    )
    assert DRIFT_TIME_S == 900
    rate = 30.0**2 / 900
    assert_allclose(drift_rate(spec), rate)

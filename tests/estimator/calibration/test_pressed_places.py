"""Variance of mean signals of pressed places, worked out by hand."""

import numpy as np
from numpy.testing import assert_allclose

from design.spec.object import ObjectSpec
from estimator.calibration.twin.pressed_places import PressedPlaces


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

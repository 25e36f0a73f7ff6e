"""Interfaces judged on presses that are made up: forces, travels, cosines, labels."""

from types import SimpleNamespace

import numpy as np
from numpy.testing import assert_allclose

from design.spec.object import ObjectSpec
from estimator.calibration.recorded_presses import RecordedPresses, own_channels
from studies.recorded import interface_fits as interfaces

SPEC = ObjectSpec(name="cube")
CASES = (((2, 1.0, 2.0), (4, 3.0, -1.0)), ((3, 5.0, 6.0),), ((3, -2.0, 1.0),))


def presses():
    """Two of the first case, one of each other; 3 N on each of the faces that they press."""
    force = np.zeros((4, 6))
    force[:2, 1], force[:2, 3], force[2:, 2] = 2.0, 4.0, 3.0
    counts = np.random.default_rng(0).normal(size=(4, 45))
    return RecordedPresses(
        counts, force, np.array([0, 0, 1, 2]), np.zeros(4, int), np.full(4, 9), CASES, np.ones(3)
    )


def test_cosines_are_over_the_live_channels_of_the_pressed_faces():
    given = presses()
    given.face_force_n[:] /= 8  # a face counts as pressed from any force on
    given.signal_counts[1, own_channels(SPEC, 4)[2]] = np.nan
    predicted = np.random.default_rng(1).normal(size=(4, 3, 45))
    found = interfaces.own_cosine.__wrapped__(SPEC, given, SimpleNamespace(counts=predicted))
    for row, faces in ((0, (2, 4)), (1, (2, 4)), (2, (3,)), (3, (3,))):
        own = np.concatenate([own_channels(SPEC, face) for face in faces])
        own = own[np.isfinite(given.signal_counts[row, own])]
        assert len(own) == (17 if row == 1 else 9 * len(faces))
        a, b = given.signal_counts[row, own], predicted[row][:, own]
        assert_allclose(found[row], b @ a / np.linalg.norm(a) / np.linalg.norm(b, axis=1))

"""Labelled frames of a cube from what a test says of them, and defaults for the rest."""

import numpy as np

from estimator.frames.dataset import FrameSet


def frame_set(signal_counts, contact_face, contact_xy_mm, normal_n, **more):
    """Frames at 10 Hz of one session, all valid; forces (frame, contact) along the normal, N.

    Unless `more` says otherwise every frame is a press of its own at one case.
    """
    count = len(signal_counts)
    given = {
        "force_n": np.stack([0 * normal_n, 0 * normal_n, normal_n], axis=-1),
        "valid": np.ones(count, bool),
        "press_id": np.arange(count),
        "place_id": np.zeros(count, int),
        "session_id": np.zeros(count, int),
        "time_s": np.arange(count) / 10,
        "faces": np.arange(1, 6),
        "grid_x_mm": np.arange(3.0),
        "grid_y_mm": np.arange(3.0),
        "noise_counts": np.ones(3),
        "source": "recorded",
        "spec_hash": "made",
        "seed": 1,
    }
    return FrameSet(signal_counts, contact_face, contact_xy_mm, **given | more)

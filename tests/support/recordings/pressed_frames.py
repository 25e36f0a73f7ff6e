"""A small recorded data set, made: two places of one face, two sensors."""

import numpy as np

from tests.support.recordings.frame_sets import frame_set

FACE = 3


def made_frames():
    """Presses at two places of face 3, seen by its first sensor and by that of face 1."""
    rng = np.random.default_rng(3)
    presses, rest, loaded = 24, 4, 10
    count = presses * (rest + loaded)
    force = np.tile(np.r_[np.zeros(rest), np.linspace(1, 9, loaded)], presses)
    press = np.repeat(np.arange(presses), rest + loaded)
    signal = np.full((count, 5, 1, 3), np.nan)
    place = press % 2
    gains = np.array([[40, -25, 60], [-30, 55, 20]])[place]
    signal[:, 2, 0] = gains * force[:, None] + rng.normal(0, 20, (count, 3))
    signal[:, 0, 0] = rng.normal(0, 20, (count, 3))
    touched = force > 0
    xy = np.where(touched[:, None], np.array([[-3.0, 3.0], [3.0, 0.0]])[place], np.nan)
    normal = np.where(touched, force, np.nan)
    return frame_set(
        signal,
        np.where(touched, FACE, 0)[:, None],
        xy[:, None],
        normal[:, None],
        press_id=press,
        place_id=np.where(touched, place, -1),
        grid_x_mm=np.array([-3.0, 0.0, 3.0]),
        grid_y_mm=np.array([0.0, 3.0]),
        noise_counts=np.array([20.0, 20.0, 20.0]),
    )

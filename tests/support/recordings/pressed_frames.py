"""A small recorded data set, made: two places of one face, two sensors."""

import numpy as np

from estimator.frames.dataset import FrameSet

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
    return FrameSet(
        signal_counts=signal,
        contact_face=np.where(touched, FACE, 0)[:, None],
        contact_xy_mm=xy[:, None],
        force_n=np.stack([0 * normal, 0 * normal, normal], axis=1)[:, None],
        valid=np.ones(count, dtype=bool),
        press_id=press,
        place_id=np.where(touched, place, -1),
        session_id=np.zeros(count, dtype=int),
        time_s=np.arange(count) / 10.0,
        faces=np.arange(1, 6),
        grid_x_mm=np.array([-3.0, 0.0, 3.0]),
        grid_y_mm=np.array([0.0, 3.0]),
        noise_counts=np.array([20.0, 20.0, 20.0]),
        source="recorded",
        spec_hash="made",
        seed=1,
    )

"""A small synthetic data set: a smooth random map from place and force to the counts of faces."""

import numpy as np

from estimator.frames.dataset import FrameSet

GRID_X_MM = np.arange(4) * 3.0 - 4.5
GRID_Y_MM = np.arange(5) * 3.0 - 6.0
NOISE_COUNTS = np.array([22.0, 20.0, 11.0])


def synthetic_frames(
    faces=(2, 4),
    presses=5,
    rest=4,
    loaded=16,
    seed=0,
    places=None,
    zero_error=8.0,
    cross=0.05,
    noise=1.0,
    sides=5,
    sensors=3,
) -> FrameSet:
    """Presses of every place on each face; a press is rest frames, then a rise and fall."""
    rng = np.random.default_rng(seed)
    places = range(len(GRID_X_MM) * len(GRID_Y_MM)) if places is None else places
    plan = [(f, p) for _ in range(presses) for f in faces for p in places]
    parts = [
        _press(face, place, number, rest, loaded, rng) for number, (face, place) in enumerate(plan)
    ]
    joined = {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}
    signal = np.stack([_signal(f, joined, cross, 3 * sensors) for f in range(1, sides + 1)], axis=1)
    error = rng.normal(0, zero_error, (len(plan), *signal.shape[1:]))[joined["press_id"]]
    white = noise * rng.normal(0, 1, signal.shape) * NOISE_COUNTS
    return FrameSet(
        signal_counts=signal + white + error,
        contact_face=np.where(joined["force"] > 0, joined["face"], 0)[:, None],
        contact_xy_mm=np.where(joined["force"][:, None] > 0, joined["xy"], np.nan)[:, None],
        force_n=_normal(joined["force"])[:, None],
        valid=np.ones(len(signal), dtype=bool),
        press_id=joined["press_id"],
        place_id=np.where(joined["force"] > 0, joined["place_id"], -1),
        session_id=joined["press_id"] * presses // len(plan),
        time_s=np.arange(len(signal)) / 10.5,
        faces=np.arange(1, sides + 1),
        grid_x_mm=GRID_X_MM,
        grid_y_mm=GRID_Y_MM,
        noise_counts=NOISE_COUNTS,
        source="simulated",
        spec_hash="synthetic",
        seed=seed,
    )


def _press(face, place, number, rest, loaded, rng):
    x, y = GRID_X_MM[place // len(GRID_Y_MM)], GRID_Y_MM[place % len(GRID_Y_MM)]
    peak = rng.uniform(9, 14)
    phase = (np.arange(loaded) + 0.5) / loaded
    force = np.concatenate([np.zeros(rest), np.maximum(peak * np.sin(np.pi * phase), 0.4)])
    frames = len(force)
    return {
        "force": force,
        "xy": np.tile([x, y], (frames, 1)) + rng.uniform(-0.2, 0.2, 2),
        "face": np.full(frames, face),
        "press_id": np.full(frames, number),
        "place_id": np.full(frames, place + 1000 * face),
    }


def _signal(face, frames, cross, channels):
    """Counts (frame, sensor, axis): strong for the face's own contacts, weak for another's."""
    rng = np.random.default_rng(100 + face)
    centre, width = rng.uniform(-6, 6, (channels, 2)), rng.uniform(4, 7, channels)
    gain = rng.choice([-1, 1], channels) * rng.uniform(60, 160, channels)
    away = np.sum((frames["xy"][:, None] - centre) ** 2, axis=2) / (2 * width**2)
    own = np.where(frames["face"] == face, 1.0, cross)[:, None]
    bent = frames["force"] / (1 + 0.02 * frames["force"])
    return (own * gain * np.exp(-away) * bent[:, None]).reshape(-1, channels // 3, 3)


def _normal(force):
    return np.stack([0 * force, 0 * force, force], axis=1) * np.where(force > 0, 1, np.nan)[:, None]

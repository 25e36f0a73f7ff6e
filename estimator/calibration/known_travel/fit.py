"""Registration and calibration of an object under a machine, from a few of the places pressed.

The resting level was never recorded (every reading is one of a press), so it is what the readings of
the registered places leave on average over the model's changes. Registration is four numbers beside it:
shift (two), turn, height of the first contact. Calibration moves and tilts the magnets too, with
Gaussian priors, and their field at rest then has to be that level.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Bool, Float
from scipy.optimize import least_squares

from estimator.calibration.known_travel.model import SYMMETRIES, Pose, TravelModel, Twin
from estimator.recordings.formats.travel import TravelRecording

MODEL_ERROR_MT = 0.05
"""Of a change, rms: what registered presses leave on the eFlesh recordings."""
RESTING_ERROR_MT = 0.1
MAGNET_SEAT_MM, MAGNET_TILT_RAD, STRENGTH = 1.0, 0.1, 0.1
"""Prior standard deviations of what is calibrated: magnets lie loosely in printed pouches."""
POSE_SCALES = (1.0, 1.0, 0.05, 1.0)
"""Of shift (two), turn and contact: sizes of steps, no priors."""
_START_ABOVE_MM = 2.0
"""Height above the highest tip at which the contact plane is first assumed."""
_ROUNDS, _STARTS_KEPT = 30, 2
"""Evaluations of a fit, and starts that are refined."""


@dataclass(frozen=True)
class Fitted:
    """A twin with the resting level (mT along the chips' axes) and the rms of what is left (mT)."""

    twin: Twin
    resting_mt: Float[np.ndarray, "sensor 3"]
    left_mt: float


def drawn_places(recording: TravelRecording, share: float, seed: int) -> Bool[np.ndarray, "press"]:
    """Presses of a random share of the places (at least four)."""
    count = max(4, round(share * recording.places))
    chosen = np.random.default_rng(seed).permutation(recording.places)[:count]
    return np.isin(recording.place_id, chosen)


def register(model: TravelModel, recording: TravelRecording) -> Fitted:
    """Pose of the designed object, of all symmetries that which leaves least."""
    middle = (recording.tip_mm[:, :2].min(axis=0) + recording.tip_mm[:, :2].max(axis=0)) / 2
    contact = float(recording.tip_mm[:, 2].max()) + _START_ABOVE_MM
    found = [
        fit_twin(
            model,
            recording,
            model.as_designed(Pose(middle, 0.0, contact, k)),
            POSE_NUMBERS,
            rounds=6,
        )
        for k in range(len(SYMMETRIES))
    ]
    found.sort(key=lambda fitted: fitted.left_mt)
    better = [fit_twin(model, recording, one.twin, POSE_NUMBERS) for one in found[:_STARTS_KEPT]]
    return min(better, key=lambda fitted: fitted.left_mt)


def calibrate(model: TravelModel, recording: TravelRecording, start: Twin) -> Fitted:
    """Pose, places and tilts of the magnets and their strength, from a registered twin."""
    return fit_twin(model, recording, start, _ALL)


def left_over(
    model: TravelModel, fitted: Fitted, recording: TravelRecording
) -> Float[np.ndarray, "press sensor 3"]:
    """Recorded less predicted, mT."""
    return recording.field_mt - fitted.resting_mt - model.pressed(fitted.twin, recording.tip_mm)


POSE_NUMBERS, _ALL = "pose", "pose and magnets"


def fit_twin(
    model: TravelModel, recording: TravelRecording, start: Twin, free: str, rounds: int = _ROUNDS
) -> Fitted:
    magnets = len(start.magnet_mm)
    scales = np.array(POSE_SCALES)
    if free == _ALL:
        of_magnets = [MAGNET_SEAT_MM] * (3 * magnets) + [MAGNET_TILT_RAD] * (2 * magnets)
        scales = np.array([*scales, *of_magnets, STRENGTH])

    def residual(numbers: np.ndarray) -> np.ndarray:
        twin = moved_twin(start, numbers * scales)
        left = recording.field_mt - model.pressed(twin, recording.tip_mm)
        resting = left.mean(axis=0)
        parts = [(left - resting).ravel() / MODEL_ERROR_MT]
        if free == _ALL:
            off = (resting - model.resting(twin)).ravel() / RESTING_ERROR_MT
            parts += [off, numbers[len(POSE_SCALES) :]]
        return np.concatenate(parts)

    found = least_squares(
        residual, np.zeros(len(scales)), max_nfev=rounds, diff_step=1e-3, x_scale=1.0
    )
    twin = moved_twin(start, found.x * scales)
    left = recording.field_mt - model.pressed(twin, recording.tip_mm)
    resting = left.mean(axis=0)
    return Fitted(twin, resting, float(np.sqrt(np.mean((left - resting) ** 2))))


def moved_twin(start: Twin, numbers: np.ndarray) -> Twin:
    """The start with all numbers moved: shift, turn, contact, then magnets, tilts, strength."""
    pose = start.pose.moved(numbers)
    if len(numbers) == len(POSE_SCALES):
        return replace(start, pose=pose)
    magnets = len(start.magnet_mm)
    seats = numbers[4 : 4 + 3 * magnets].reshape(magnets, 3)
    tilts = numbers[4 + 3 * magnets : -1].reshape(magnets, 2)
    return Twin(
        pose,
        start.magnet_mm + seats,
        start.tilt_rad + tilts,
        start.strength * float(np.exp(numbers[-1])),
    )

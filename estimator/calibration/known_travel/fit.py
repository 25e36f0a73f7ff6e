"""Registration and calibration of an object under a machine, from a few of the places pressed.

The resting level was never recorded (every reading is one of a press), so it is what the readings of
the registered places leave on average over the model's changes. Registration adds four numbers:
shift (two), turn, height of the first contact. Calibration moves and tilts the magnets too, with
Gaussian priors, and their field at rest then has to be that level.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float

from estimator.calibration.known_travel.model import SYMMETRIES, Pose, TravelModel, Twin
from estimator.calibration.most_probable import Unknown, Values, most_probable
from estimator.recordings.formats.travel import TravelRecording

Changes = Float[np.ndarray, "press sensor 3"]
REGISTERED_SHARE, CALIBRATED_SHARE = 0.05, 0.1
"""Shares of the places that are fitted; all others are judged."""
MODEL_ERROR_MT = 0.05
"""Error of a change, rms: what registered presses leave on the eFlesh recordings."""
RESTING_ERROR_MT = 0.1
_POSE = {
    "shift_mm": Unknown(1.0, (2,), has_prior=False),
    "turn_rad": Unknown(0.05, has_prior=False),
    "contact_mm": Unknown(1.0, has_prior=False),
}
"""Pose of the object under the machine."""
_START_ABOVE_MM = 2.0
"""Height above the highest tip at which the contact plane is first assumed."""
_ROUNDS, _FIRST_ROUNDS, _STARTS_KEPT = 30, 6, 2
"""Evaluations of a fit, of one from every symmetry, and starts that are refined."""


@dataclass(frozen=True)
class Freed:
    """Assumptions freed together with the pose: their numbers, and the changes (mT) of presses with them."""

    unknowns: Mapping[str, Unknown]
    change: Callable[[Twin, Values, np.ndarray], Changes]


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


def fits_and_judged(
    model: TravelModel, recording: TravelRecording, seed: int
) -> dict[str, tuple[Fitted, TravelRecording, TravelRecording]]:
    """Registered on few of the places and calibrated on some more; each with the presses that it was
    made on and all others, by which it is judged."""
    fits = {}
    for name, share in (("registered", REGISTERED_SHARE), ("calibrated", CALIBRATED_SHARE)):
        shown = drawn_places(recording, share, seed)
        part, judged = recording.select(shown), recording.select(~shown)
        fitted = register(model, part)
        if name == "calibrated":
            fitted = calibrate(model, part, fitted.twin)
        fits[name] = fitted, part, judged
    return fits


def register(model: TravelModel, recording: TravelRecording) -> Fitted:
    """Pose of the designed object, of all symmetries that which leaves least."""
    middle = (recording.tip_mm[:, :2].min(axis=0) + recording.tip_mm[:, :2].max(axis=0)) / 2
    contact = float(recording.tip_mm[:, 2].max()) + _START_ABOVE_MM
    starts = [model.design_twin(Pose(middle, 0.0, contact, k)) for k in range(len(SYMMETRIES))]
    fits = [fit_pose(model, recording, start, _FIRST_ROUNDS) for start in starts]
    fits.sort(key=lambda fitted: fitted.left_mt)
    better = [fit_pose(model, recording, fit.twin) for fit in fits[:_STARTS_KEPT]]
    return min(better, key=lambda fitted: fitted.left_mt)


def fit_pose(
    model: TravelModel, recording: TravelRecording, start: Twin, rounds: int = _ROUNDS
) -> Fitted:
    """The start with its pose fitted alone."""
    pose_alone = Freed({}, lambda twin, _, tip: model.pressed(twin, tip))
    return fit_beside_pose(start, pose_alone, recording, rounds)[0]


def calibrate(model: TravelModel, recording: TravelRecording, start: Twin) -> Fitted:
    """Pose, places and tilts of the magnets and their strength, from a registered twin."""
    return fit_beside_pose(start, freed_magnets(model), recording, resting=model.resting)[0]


def freed_magnets(model: TravelModel) -> Freed:
    """Seats, tilts and common strength of the magnets, which lie loosely in printed pouches."""
    count = len(model.scene.magnets.face)
    unknowns = {
        "magnet_mm": Unknown(1.0, (count, 3)),
        "tilt_rad": Unknown(0.1, (count, 2)),
        "ln_strength": Unknown(0.1),
    }
    return Freed(unknowns, lambda twin, _, tip: model.pressed(twin, tip))


def left_over(model: TravelModel, fitted: Fitted, recording: TravelRecording) -> Changes:
    """Recorded less predicted, mT."""
    return recording.field_mt - fitted.resting_mt - model.pressed(fitted.twin, recording.tip_mm)


def fit_beside_pose(
    start: Twin,
    freed: Freed,
    recording: TravelRecording,
    rounds: int = _ROUNDS,
    resting: Callable[[Twin], Float[np.ndarray, "sensor 3"]] | None = None,
) -> tuple[Fitted, Values]:
    """The start with its pose and what is freed fitted to presses, and the values found.

    `resting` predicts the level at rest, where that is to be met as well.
    """

    def fit_with_residual(values: Values) -> tuple[Fitted, Changes]:
        twin = start.moved(values)
        residual = recording.field_mt - freed.change(twin, values, recording.tip_mm)
        level = residual.mean(axis=0)
        return Fitted(
            twin, level, float(np.sqrt(np.mean((residual - level) ** 2)))
        ), residual - level

    def misfit(values: Values) -> Float[np.ndarray, "residual"]:
        fitted, residual = fit_with_residual(values)
        parts = [residual.ravel() / MODEL_ERROR_MT]
        if resting is not None:
            off = fitted.resting_mt - resting(fitted.twin)
            parts.append(off.ravel() / RESTING_ERROR_MT)
        return np.concatenate(parts)

    values = most_probable(
        misfit, _POSE | dict(freed.unknowns), max_nfev=rounds, diff_step=1e-3
    ).values
    return fit_with_residual(values)[0], values

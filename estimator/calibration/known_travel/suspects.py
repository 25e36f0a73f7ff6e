"""Assumptions that residuals point to: each freed by itself, ranked by what that explains elsewhere.

Each assumption is a few numbers with Gaussian priors, fitted beside the pose to the registered
presses and judged on all others. Numbers that stand for nothing gain nothing there, or lose. A group
that gains need not be the cause: what looks alike in the field (height and strength of a magnet, travel
and Poisson's ratio) cannot be told apart.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Float
from scipy.optimize import least_squares

from estimator.calibration.known_travel.fit import (
    MAGNET_SEAT_MM,
    MAGNET_TILT_RAD,
    MODEL_ERROR_MT,
    POSE_SCALES,
    STRENGTH,
    Fitted,
    left_over,
)
from estimator.calibration.known_travel.model import TravelModel, Twin
from estimator.recordings.formats.travel import TravelRecording

LEAN_RAD, TRAVEL_SHARE, CHIP_SHARE = 0.05, 0.2, 0.1
"""Prior standard deviations: machine against face, travel's scale, every entry of a chip's matrix."""
_DRAWS = 500
"""Bootstrap draws of an interval."""
_ROUNDS = 15
"""Evaluations of a fit, at most."""

Changes = Float[np.ndarray, "press sensor 3"]
Numbers = Float[np.ndarray, "number"]


@dataclass(frozen=True)
class Suspect:
    """One assumption freed.

    Attributes
    ----------
    numbers : how many were fitted beside the pose
    explained : share of the change of the judged presses (about the resting level of the pose alone)
    gained : over the pose alone, which was fitted to the same presses
    low, high : 90 % of what is gained with the judged places drawn anew
    found : what was found, in words
    """

    name: str
    numbers: int
    explained: float
    gained: float
    low: float
    high: float
    found: str


@dataclass(frozen=True)
class _Freed:
    """Prior scales of an assumption's numbers, the changes (mT) that they give, and what they say."""

    scales: Numbers
    change: Callable[[Twin, Numbers, np.ndarray], Changes]
    words: Callable[[Numbers], str]


def ranked_suspects(
    model: TravelModel,
    fitted: Fitted,
    registered: TravelRecording,
    judged: TravelRecording,
    others: Mapping[str, tuple[TravelModel, Callable[[float], str]]],
    seed: int = 0,
) -> list[Suspect]:
    """Every assumption, that which explains most first; `fitted` is the registration to the same
    presses.

    `others` are models of the same object with one assumption of the mechanics changed, by its name:
    one number mixes their motions (1) with those of `model` (0), and the function says what it means.
    """
    freed = _freed(model, fitted) | {
        name: _mixed(model, other, words) for name, (other, words) in others.items()
    }
    alone = squares_left(left_over(model, fitted, judged))
    size = squares_left(judged.field_mt - fitted.resting_mt)
    rng = np.random.default_rng((seed, 15))
    found = []
    for name, one in freed.items():
        left, numbers = _left(fitted.twin, one, registered, judged)
        gained, low, high = gain_of_suspect(alone, left, size, judged.place_id, rng)
        explained = float(1 - left.sum() / size.sum())
        words = one.words(numbers)
        found.append(Suspect(name, len(numbers), explained, gained, low, high, words))
    return sorted(found, key=lambda suspect: -suspect.gained)


def _freed(model: TravelModel, fitted: Fitted) -> dict[str, _Freed]:
    count, sensors = len(model.scene.magnets.face), len(model.scene.sensors.face)
    middle = fitted.twin.pose.shift_mm

    def leaning(twin: Twin, numbers: Numbers, tip: np.ndarray) -> Changes:
        lower = tip.copy()
        lower[:, 2] += (tip[:, :2] - middle) @ numbers
        return model.pressed(twin, lower)

    def deeper(twin: Twin, numbers: Numbers, tip: np.ndarray) -> Changes:
        xy, travel = twin.pose.in_object(tip)
        return model.change(twin, model.motion(xy, travel * np.exp(numbers[0])))

    def read(twin: Twin, numbers: Numbers, tip: np.ndarray) -> Changes:
        matrix = np.eye(3) + numbers.reshape(sensors, 3, 3)
        # s sensor, j axis as designed, i axis as freed, n press
        return np.einsum("sij,nsj->nsi", matrix, model.pressed(twin, tip))

    def moved(twin: Twin, numbers: Numbers, tip: np.ndarray) -> Changes:
        seats = numbers[: 3 * count].reshape(count, 3)
        tilts = numbers[3 * count : -1].reshape(count, 2)
        off = replace(twin, magnet_mm=seats, tilt_rad=tilts, strength=float(np.exp(numbers[-1])))
        return model.pressed(off, tip)

    seats = [MAGNET_SEAT_MM] * (3 * count) + [MAGNET_TILT_RAD] * (2 * count)
    return {
        "machine leans": _Freed(
            np.full(2, LEAN_RAD),
            leaning,
            lambda n: f"{np.rad2deg(np.linalg.norm(n)):.1f}°",
        ),
        "scale of travel": _Freed(
            np.array([TRAVEL_SHARE]), deeper, lambda n: f"× {np.exp(n[0]):.2f}"
        ),
        "chips": _Freed(
            np.full(9 * sensors, CHIP_SHARE),
            read,
            lambda n: f"gains off by {np.sqrt(np.mean(n**2)):.2f}",
        ),
        "magnets": _Freed(
            np.array([*seats, STRENGTH]),
            moved,
            lambda n: (
                f"up to {np.linalg.norm(n[: 3 * count].reshape(-1, 3), axis=1).max():.1f} mm, "
                f"× {np.exp(n[-1]):.2f}"
            ),
        ),
    }


def _mixed(model: TravelModel, other: TravelModel, words: Callable[[float], str]) -> _Freed:
    def change(twin: Twin, numbers: Numbers, tip: np.ndarray) -> Changes:
        given = twin.pose.in_object(tip)
        motion = (1 - numbers[0]) * model.motion(*given) + numbers[0] * other.motion(*given)
        return model.change(twin, motion)

    return _Freed(np.ones(1), change, lambda n: words(float(n[0])))


def _left(
    start: Twin, freed: _Freed, registered: TravelRecording, judged: TravelRecording
) -> tuple[Float[np.ndarray, "press"], Numbers]:
    """Squares (mT²) left of every judged press, and what was found."""
    pose = len(POSE_SCALES)

    def at(values: np.ndarray, tip: np.ndarray) -> Changes:
        twin = replace(start, pose=start.pose.moved(values[:pose] * POSE_SCALES))
        return freed.change(twin, values[pose:] * freed.scales, tip)

    def residual(values: np.ndarray) -> np.ndarray:
        left = registered.field_mt - at(values, registered.tip_mm)
        return np.concatenate([(left - left.mean(axis=0)).ravel() / MODEL_ERROR_MT, values[pose:]])

    begin = np.zeros(pose + len(freed.scales))
    found = least_squares(residual, begin, max_nfev=_ROUNDS, diff_step=1e-3).x
    resting = (registered.field_mt - at(found, registered.tip_mm)).mean(axis=0)
    left = judged.field_mt - resting - at(found, judged.tip_mm)
    return squares_left(left), found[pose:] * freed.scales


def squares_left(field_mt: Changes) -> Float[np.ndarray, "press"]:
    return np.sum(field_mt**2, axis=(1, 2))


def gain_of_suspect(
    alone: Float[np.ndarray, "press"],
    left: Float[np.ndarray, "press"],
    size: Float[np.ndarray, "press"],
    place: np.ndarray,
    rng: np.random.Generator,
) -> tuple[float, float, float]:
    """Share gained, and 90 % of the shares with places drawn anew."""
    _, number = np.unique(place, return_inverse=True)
    less, all_of = (np.bincount(number, weights=given) for given in (alone - left, size))
    drawn = rng.integers(len(less), size=(_DRAWS, len(less)))
    shares = less[drawn].sum(axis=1) / all_of[drawn].sum(axis=1)
    low, high = np.percentile(shares, (5, 95))
    return float(less.sum() / all_of.sum()), float(low), float(high)

"""Places at which a calibrated twin knows least: which press says most of all signals.

Signals at all places are jointly Gaussian: the numbers of the object through the Jacobian of its
signals, and the process of what they leave over (`discrepancy`). Every press is chosen to leave the
least mean variance over all places (A-optimal, one after the other; Cohn, Neural Networks 9, 1996; Krause et
al., J. Mach. Learn. Res. 9, 2008). A variance is not changed by what a press shows, only by where it
was, so the whole order is known before the first press, but for what calibration changes of the Jacobian.
A press is a block update of one covariance: about 0.1 s for 100 places.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Float, Int
from scipy.linalg import cholesky, solve_triangular

from design.layout.places.contact_grid import contact_grid
from design.layout.places.contact_places import contact_places
from design.spec.object import ObjectSpec
from estimator.calibration.twin.digital_twin import PlaceMechanics
from estimator.calibration.twin.discrepancy import Discrepancy, Prior
from estimator.calibration.twin.pressed_places import REACH, PressedPlaces, zero_covariance
from estimator.calibration.twin.unknowns import Unknowns, jacobian_of
from fem.presses.results import MagnetMotions, PressForces

SHARES = (0.5, 1.0)
"""Shares of the force of a press at which its signals count."""
PRIOR = Prior(0.05, 10.0)


@dataclass(frozen=True)
class PressErrors:
    """Errors of the signals of one press.

    Attributes
    ----------
    frames : at each of `SHARES`
    zero_counts2 : variance of the level under the press
    """

    frames: int
    zero_counts2: float


@dataclass(frozen=True)
class PosteriorVariance:
    """Covariance (counts²) of all signals at all places, and that of one press's errors at each."""

    covariance_counts2: Float[np.ndarray, "place signal place signal"]
    noise_counts2: Float[np.ndarray, "place signal signal"]

    @property
    def rms_counts(self) -> float:
        """Root of the mean variance over all places and signals."""
        places, signals, *_ = self.covariance_counts2.shape
        flat = self.covariance_counts2.reshape(places * signals, -1)
        return float(np.sqrt(np.trace(flat) / len(flat)))

    def gains_counts2(self) -> Float[np.ndarray, "place"]:
        """Return how much a press at each place would lower the sum of all variances."""
        return np.array(
            [np.sum(self._gained_root(place) ** 2) for place in range(len(self.noise_counts2))]
        )

    def condition_on(self, place: int) -> PosteriorVariance:
        """Return what is left after a press."""
        gained = self._gained_root(place)
        remaining = self.covariance_counts2 - np.tensordot(gained, gained, axes=([0], [0]))
        return replace(self, covariance_counts2=remaining)

    def _gained_root(self, place: int) -> Float[np.ndarray, "signal place signal"]:
        """Return what a press says of all signals: a root of the covariance that it takes away."""
        covariance = self.covariance_counts2[place]
        size = len(covariance)
        root = cholesky(covariance[:, place] + self.noise_counts2[place], lower=True)
        return solve_triangular(root, covariance.reshape(size, -1), lower=True).reshape(
            covariance.shape
        )


def prior_variance(
    spec: ObjectSpec,
    forces: PressForces,
    motions: MagnetMotions,
    face: int,
    force_n: float,
    errors: PressErrors | None = None,
) -> PosteriorVariance:
    """Return the variance at the contact locations of a face before any press of up to `force_n`.

    It is that at the design; forces end where those of the table do. `errors` are those of one press
    (by default 8 frames at each force after a zero of their own).
    """
    unknowns = Unknowns(spec, (face,))
    point = np.zeros(len(unknowns))
    errors = errors or PressErrors(8, zero_covariance(spec, 8 * len(SHARES)))
    pressed = _all_places(spec, forces, face, force_n, errors)
    mechanics = PlaceMechanics(unknowns, forces, motions, pressed)
    here = mechanics.expected(point)
    jacobian = jacobian_of(mechanics, point, here)
    pressed = replace(pressed, counts=here.reshape(pressed.counts.shape))
    process = Discrepancy(spec, PRIOR, pressed).covariance(pressed.xy_mm, pressed.force_n)
    flat = jacobian.reshape(-1, len(point))
    places, levels = pressed.force_n.shape
    covariance = flat @ flat.T
    rows = covariance.reshape(places * levels, here.shape[1], places * levels, here.shape[1])
    for channel, channel_covariance in enumerate(process):
        rows[:, channel, :, channel] += channel_covariance
    signals = levels * here.shape[1]
    shape = (places, signals, places, signals)
    return PosteriorVariance(
        covariance.reshape(shape), _press_noise(spec, pressed).reshape(places, signals, signals)
    )


def _press_noise(
    spec: ObjectSpec, pressed: PressedPlaces
) -> Float[np.ndarray, "place level channel level channel"]:
    """Noise of every mean, and the error of the zero that a press's levels share."""
    white, channels = pressed.white_counts2(spec), len(pressed.channels)
    # p place, i and j levels, c and d channels: a zero's error is shared by levels, not by channels
    noise = np.einsum("pij,cd->picjd", pressed.zero_counts2, np.eye(channels))
    level, channel = np.indices(white.shape[1:])
    noise[:, level, channel, level, channel] += white
    return noise


def press_order(
    doubt: PosteriorVariance, presses: int, pressed: Sequence[int] = ()
) -> tuple[Int[np.ndarray, "press"], list[float]]:
    """Return places in the order in which each press says most, none twice before all, and the doubt (rms
    counts) that is left after each; places of `pressed` are pressed anyway."""
    order, deviations = [], []
    for place in pressed:
        doubt = doubt.condition_on(place)
    for number in range(presses):
        gains = doubt.gains_counts2()
        gains[order[len(order) - number % len(gains) :]] = -np.inf
        place = int(gains.argmax())
        doubt = doubt.condition_on(place)
        order.append(place)
        deviations.append(doubt.rms_counts)
    return np.array(order, int), deviations


def _all_places(
    spec: ObjectSpec, forces: PressForces, face: int, force_n: float, errors: PressErrors
) -> PressedPlaces:
    """Every contact location of a face as if it had been pressed, without signals."""
    xy = contact_grid(spec).xy_mm[contact_places(spec)[spec.body.sensed.index(face)]]
    deepest = REACH * float(np.nanmin(forces.force_n[forces.faces == face][..., -1]))
    levels = np.tile(min(force_n, deepest) * np.array(SHARES), (len(xy), 1))
    channels = np.arange(3 * spec.sensors.count_per_face)
    zero = errors.zero_counts2 * np.ones((len(SHARES), len(SHARES)))
    return PressedPlaces(
        face,
        channels,
        xy,
        levels,
        np.zeros((*levels.shape, len(channels))),
        np.full(levels.shape, errors.frames),
        np.tile(zero, (len(xy), 1, 1)),
    )

"""Least error that any choice of presses can leave: a bound below every order, greedy or not.

The mean variance of the judged signals falls with the information of all presses, and is convex in how
often each is done. Let presses be done fractions of times: the least over such designs (Pukelsheim,
Optimal Design of Experiments, SIAM 2006, chapters 6 and 9) lies below that of all choices of whole ones,
and a tangent at any design bounds it from below. So the bound holds however far the search for the
design went.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float
from scipy.linalg import cho_factor, cho_solve, solve_triangular

from estimator.calibration.twin.least_known import PosteriorVariance

_POWER = 0.6


@dataclass(frozen=True)
class PressChoices:
    """Presses to choose among, of one vector of independent standard normal unknowns.

    Attributes
    ----------
    told : what each press shows, divided by its errors: they have variance 1 there
    judged : Jacobian of the signals that are judged, in their unit
    """

    told: Float[np.ndarray, "press row unknown"]
    judged: Float[np.ndarray, "signal unknown"]

    def left(self, times: Float[np.ndarray, "press"]) -> float:
        """Rms error of the judged signals after each press was done so many times."""
        return float(np.sqrt(self._spread(times)[0]))

    def slopes(self, times: Float[np.ndarray, "press"]) -> tuple[float, np.ndarray]:
        """Mean variance, and by how much it falls with the number of times of each press."""
        variance, spread = self._spread(times)
        seen = self.told.reshape(-1, self.told.shape[2]) @ spread
        return variance, np.sum(seen.reshape(len(self.told), -1) ** 2, axis=1) / len(self.judged)

    def greedy(self, presses: int, pressed: tuple[int, ...] = ()) -> Float[np.ndarray, "press"]:
        """Times of each press where every next one leaves the least, repeats allowed; those of
        `pressed` are done anyway and count."""
        times = np.bincount(pressed, minlength=len(self.told)).astype(float)
        for _ in range(presses - len(pressed)):
            times[self.gains_at(times).argmax()] += 1
        return times

    def gains_at(self, times: Float[np.ndarray, "press"]) -> Float[np.ndarray, "press"]:
        """By how much one more time of each lowers the sum of variances."""
        factor = self.factor_of(times)
        spread = cho_solve(factor, self.judged.T)
        gains = np.empty(len(self.told))
        for press, rows in enumerate(self.told):
            half = solve_triangular(factor[0], rows.T, lower=True)
            root = np.linalg.cholesky(np.eye(len(rows)) + half.T @ half)
            gains[press] = np.sum(solve_triangular(root, rows @ spread, lower=True) ** 2)
        return gains

    def factor_of(self, times: Float[np.ndarray, "press"]) -> tuple[np.ndarray, bool]:
        done = times > 0
        rows = (np.sqrt(times[done])[:, None, None] * self.told[done]).reshape(
            -1, self.told.shape[2]
        )
        return cho_factor(np.eye(self.told.shape[2]) + rows.T @ rows, lower=True)

    def _spread(self, times: Float[np.ndarray, "press"]) -> tuple[float, np.ndarray]:
        """Mean variance, and covariance of unknowns and judged signals."""
        spread = cho_solve(self.factor_of(times), self.judged.T)
        return float(np.sum(self.judged.T * spread)) / len(self.judged), spread


def choices_of(doubt: PosteriorVariance) -> PressChoices:
    """The places of a doubt, with all their signals judged."""
    places, signals, *_ = doubt.covariance_counts2.shape
    flat = doubt.covariance_counts2.reshape(places * signals, -1)
    values, vectors = np.linalg.eigh(flat)
    root = vectors * np.sqrt(np.maximum(values, 0.0))
    told = [
        solve_triangular(np.linalg.cholesky(noise), rows, lower=True)
        for noise, rows in zip(doubt.noise_counts2, root.reshape(places, signals, -1), strict=True)
    ]
    return PressChoices(np.stack(told), root)


def least_possible(
    choices: PressChoices, presses: int, within: float = 0.01, rounds: int = 40
) -> tuple[float, Float[np.ndarray, "press"]]:
    """Rms error below which no choice of so many presses gets, repeats allowed, and a design (times of
    each press, fractions) that comes near; ends where both differ by less than `within`."""
    times = np.full(len(choices.told), presses / len(choices.told))
    least = 0.0
    for _ in range(rounds):
        variance, slopes = choices.slopes(times)
        least = max(least, variance + float(slopes @ times) - presses * float(slopes.max()))
        if np.sqrt(variance) - np.sqrt(least) < within * np.sqrt(variance):
            break
        times = times * slopes**_POWER
        times *= presses / times.sum()
    return float(np.sqrt(least)), times

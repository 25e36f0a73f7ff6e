"""Most probable values of what is unknown of an object: named numbers with Gaussian priors.

One solver for every fit whose errors are independent: least squares over what was read and the
priors together, which is the largest posterior (maximum a posteriori).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from jaxtyping import Float
from scipy.optimize import least_squares

Values = dict[str, np.ndarray]
"""Values of unknowns by their names, each in its own unit and shape."""


@dataclass(frozen=True)
class Unknown:
    """Numbers of one kind.

    Attributes
    ----------
    sd : standard deviation beforehand, and size of the fit's steps
    mean : most probable value beforehand
    bound : how far a number may be from `mean`
    has_prior : without one `sd` is the size of steps alone
    """

    sd: float
    shape: tuple[int, ...] = ()
    mean: float | np.ndarray = 0.0
    bound: float = np.inf
    has_prior: bool = True

    @property
    def size(self) -> int:
        """Return how many numbers there are."""
        return int(np.prod(self.shape))


@dataclass(frozen=True)
class MostProbable:
    """Most probable values, and the precision of all numbers in the order of the unknowns."""

    values: Values
    precision: Float[np.ndarray, "number number"]

    def covariance(self, name: str) -> Float[np.ndarray, "own own"]:
        """Return the covariance of the numbers of one unknown, all others unknown too."""
        sizes = {key: value.size for key, value in self.values.items()}
        first = sum(list(sizes.values())[: list(sizes).index(name)])
        numbers = slice(first, first + sizes[name])
        return np.linalg.inv(self.precision)[numbers, numbers]

    def sd(self, name: str) -> Float[np.ndarray, "*any"]:
        """Return the standard deviation of every number of one unknown."""
        return np.sqrt(np.diag(self.covariance(name))).reshape(self.values[name].shape)


def most_probable(
    misfit: Callable[[Values], Float[np.ndarray, "*any"]],
    unknowns: Mapping[str, Unknown],
    start: Values | None = None,
    **options: Any,
) -> MostProbable:
    """Values at which the whitened `misfit` of readings and the priors are least together.

    The fit begins at the means, but for values of `start`. `options` are those of
    `scipy.optimize.least_squares`, whose numbers are in standard deviations.
    """
    ends = np.cumsum([unknown.size for unknown in unknowns.values()])[:-1]
    sd, bound, has_prior = (
        np.concatenate(
            [np.full(unknown.size, getattr(unknown, name)) for unknown in unknowns.values()]
        )
        for name in ("sd", "bound", "has_prior")
    )

    def values_at(scaled: Float[np.ndarray, "number"]) -> Values:
        parts = zip(unknowns.items(), np.split(scaled * sd, ends), strict=True)
        return {name: unknown.mean + part.reshape(unknown.shape) for (name, unknown), part in parts}

    def residual(scaled: Float[np.ndarray, "number"]) -> Float[np.ndarray, "residual"]:
        return np.concatenate([np.ravel(misfit(values_at(scaled))), scaled[has_prior]])

    begin = values_at(np.zeros(len(sd))) | (start or {})
    off = [np.ravel(begin[name] - unknown.mean) for name, unknown in unknowns.items()]
    bounds = (-bound / sd, bound / sd)
    fit: Any = least_squares(residual, np.concatenate(off) / sd, bounds=bounds, **options)
    # Of the model linear about the fit, JᵀJ with the priors' rows, from standard deviations to units.
    return MostProbable(values_at(fit.x), fit.jac.T @ fit.jac / np.outer(sd, sd))

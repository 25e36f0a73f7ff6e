"""Contacts on given faces in frames (problems), and the frames that they are to explain."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from jaxtyping import Float, Int

from estimator.inversion.model.arrays import Array, diagonals, library, like, on_host, zeros
from estimator.inversion.model.columns import Columns
from estimator.inversion.model.forward import NONE


@dataclass(frozen=True)
class Problems(Columns):
    """Contacts on given faces in frames, and how well they explain them.

    Attributes
    ----------
    frame : (problem,) row of the frame
    face, contact : as in `ContactModel`
    extra : (problem, channel) interaction of the contacts, counts
    misfit : (problem,) half χ² of signals and priors
    slope : (problem, 3k) of the misfit
    curvature : (problem, 3k, 3k) of the misfit, empty slots as ones on the diagonal
    log_spread : (problem,) half the log determinant of the covariance of the signals over that of the
        noise: tangential forces widen it; of no contact below 0, as it has no error of the model
    """

    frame: Int[np.ndarray, "problem"]
    face: Int[np.ndarray, "problem contact"]
    contact: Float[np.ndarray, "problem contact 3"]
    extra: Float[Array, "problem channel"]
    misfit: Float[np.ndarray, "problem"]
    slope: Float[Array, "problem parameter"]
    curvature: Float[Array, "problem parameter parameter"]
    log_spread: Float[np.ndarray, "problem"]

    def on_host(self) -> Problems:
        """As NumPy arrays."""
        return Problems(*map(on_host, self._columns()))

    @cached_property
    def number(self) -> Int[np.ndarray, "problem"]:
        """Return how many contacts."""
        return np.sum(self.face != NONE, axis=1)


@dataclass(frozen=True)
class Observed:
    """Frames to be explained.

    Attributes
    ----------
    counts : changes of counts
    sigma : their standard deviations around contacts
    still : the same without the error of the forward model, which nothing pressed has not
    strict : the same as `sigma` with no more of that error than a model may have that explains a frame
    """

    counts: Float[Array, "frame channel"]
    sigma: Float[Array, "frame channel"]
    still: Float[Array, "frame channel"]
    strict: Float[Array, "frame channel"]

    def on(self, reference: Array) -> Observed:
        """The same where the reference is."""
        parts = (self.counts, self.sigma, self.still, self.strict)
        return Observed(*(like(reference, part) for part in parts))

    def resting(
        self, frame: Int[Array, "problem"]
    ) -> tuple[Float[Array, "problem"], Float[Array, "problem"]]:
        """Misfit and log spread of frames in which nothing is pressed."""
        still = self.still[frame]
        misfit = 0.5 * ((self.counts[frame] / still) ** 2).sum(axis=1)
        return misfit, library(still).log(still / self.sigma[frame]).sum(axis=1)


def empty(seen: Observed, frame: Int[np.ndarray, "problem"], slots: int) -> Problems:
    """Frames explained by nothing."""
    problems, (misfit, log_spread) = len(frame), seen.resting(like(seen.counts, frame))
    return Problems(
        frame,
        np.full((problems, slots), NONE),
        np.zeros((problems, slots, 3)),
        zeros(seen.counts, (problems, seen.counts.shape[1])),
        on_host(misfit),
        zeros(seen.counts, (problems, 3 * slots)),
        identities(seen.counts, problems, 3 * slots),
        on_host(log_spread),
    )


def identities(reference: Array, many: int, size: int) -> Float[Array, "many size size"]:
    found = zeros(reference, (many, size, size))
    diagonals(found)[:] = 1.0
    return found

"""Contacts on given faces in frames (problems), and the frames that they are to explain."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from jaxtyping import Float, Int

from estimator.inversion.model.arrays import Array, diagonals, library, like, to_host, zeros
from estimator.inversion.model.columns import Columns
from estimator.inversion.model.forward import NONE
from estimator.inversion.model.whitening import Whitening, whitening

BLIND = 1e9
"""Standard deviation (counts) of a channel that says nothing."""


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
        noise and nuisances: tangential forces widen it; of no contact below 0, as it has no error of
        the model
    """

    frame: Int[np.ndarray, "problem"]
    face: Int[np.ndarray, "problem contact"]
    contact: Float[np.ndarray, "problem contact 3"]
    extra: Float[Array, "problem channel"]
    misfit: Float[np.ndarray, "problem"]
    slope: Float[Array, "problem parameter"]
    curvature: Float[Array, "problem parameter parameter"]
    log_spread: Float[np.ndarray, "problem"]

    def to_host(self) -> Problems:
        """Return the problems as NumPy arrays."""
        return Problems(*map(to_host, self._columns()))

    @cached_property
    def number(self) -> Int[np.ndarray, "problem"]:
        """Return the number of contacts."""
        return np.sum(self.face != NONE, axis=1)


@dataclass(frozen=True)
class Observations:
    """Frames to be explained.

    Attributes
    ----------
    counts : changes of counts
    sigma : their standard deviations around contacts
    still : the same without the error of the forward model, which nothing pressed has not
    strict : the same as `sigma` with no more of that error than a model may have that explains a frame
    columns : counts that nuisances common to all channels add, a standard deviation of each, alike in
        all frames or of each frame; or None
    """

    counts: Float[Array, "frame channel"]
    sigma: Float[Array, "frame channel"]
    still: Float[Array, "frame channel"]
    strict: Float[Array, "frame channel"]
    columns: Float[Array, "*frame channel k"] | None = None

    def moved_to(self, reference: Array) -> Observations:
        """The same where the reference is."""
        if type(reference) is type(self.counts) is np.ndarray:
            return self
        parts = (self.counts, self.sigma, self.still, self.strict, self.shared)
        return Observations(*(like(reference, part) for part in parts))

    def select(self, frames: Int[np.ndarray, "some"]) -> Observations:
        """Some of the frames, on the processor."""
        counts, sigma, still, strict = (
            part[frames] for part in (self.counts, self.sigma, self.still, self.strict)
        )
        columns = self.columns
        if columns is not None and columns.ndim > 2:
            columns = columns[frames]
        return Observations(counts, sigma, still, strict, columns)

    def without(self, chip: Int[np.ndarray, "frame"]) -> Observations:
        """The same without what one chip shows in each frame; all of it where that is `NONE`."""
        out = np.arange(self.counts.shape[1]) // 3 == chip[:, None]
        sigma, still, strict = (
            np.where(out, BLIND, part) for part in (self.sigma, self.still, self.strict)
        )
        return Observations(np.where(out, 0.0, self.counts), sigma, still, strict, self.columns)

    def add_nuisances(self, columns: Float[np.ndarray, "channel more"]) -> Observations:
        """The same where further nuisances add to all channels."""
        return replace(self, columns=np.hstack([self.shared, columns]))

    def with_error_share(self, share: float | Float[np.ndarray, "frame 1"]) -> Observations:
        """The same around contacts of a model with that share of the strict error, of all or each frame."""
        still, strict = self.still**2, self.strict**2
        return replace(self, sigma=(still + share**2 * (strict - still)) ** 0.5)

    @cached_property
    def readings(self) -> Int[np.ndarray, "frame"]:
        """Return how many channels of each frame say something."""
        return (self.sigma < BLIND / 2).sum(axis=1)

    @cached_property
    def white(self) -> Whitening:
        """Return the whitening of the disturbances around contacts."""
        return whitening(self.sigma, self.shared)

    @cached_property
    def _white_still(self) -> Whitening:
        return whitening(self.still, self.shared)

    @property
    def shared(self) -> Float[Array, "*frame channel k"]:
        """Return the nuisances' columns, none where there are none."""
        none = zeros(self.counts, (self.counts.shape[1], 0))
        return none if self.columns is None else self.columns

    def resting(
        self, frame: Int[Array, "problem"]
    ) -> tuple[Float[Array, "problem"], Float[Array, "problem"]]:
        """Misfit and log spread of frames in which nothing is pressed."""
        white = self._white_still.select(frame)(self.counts[frame][:, None])
        ratio = library(self.still).log(self.still / self.sigma).sum(axis=1)
        spread = ratio + self._white_still.log_spread() - self.white.log_spread()
        return 0.5 * (white * white).sum(axis=2)[:, 0], spread[frame]


def empty(observations: Observations, frame: Int[np.ndarray, "problem"], slots: int) -> Problems:
    """Frames explained by nothing."""
    problems, (misfit, log_spread) = (
        len(frame),
        observations.resting(like(observations.counts, frame)),
    )
    return Problems(
        frame,
        np.full((problems, slots), NONE),
        np.zeros((problems, slots, 3)),
        zeros(observations.counts, (problems, observations.counts.shape[1])),
        to_host(misfit),
        zeros(observations.counts, (problems, 3 * slots)),
        identities(observations.counts, problems, 3 * slots),
        to_host(log_spread),
    )


def identities(reference: Array, many: int, size: int) -> Float[Array, "many size size"]:
    matrices = zeros(reference, (many, size, size))
    diagonals(matrices)[:] = 1.0
    return matrices

"""p values of contacts, with as much error of the model as its frames show.

A forward model is believed to be wrong by a share of the signals (`Disturbances.model_error`), the
same in every direction. Contacts take up part of a real error, and some objects have less of it than
their tolerances allow. By the error that is believed, p values would then crowd at 1 and nothing be
left unexplained. So the error's share is taken at which half of the pressed frames have a p value
above ½. It counts for p values alone: places and forces keep the whole error.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass, field, replace

import numpy as np
from jaxtyping import Float

from estimator.inversion.model.forward import ContactModel
from estimator.inversion.posterior import lowered_misfits
from estimator.inversion.priors import Priors
from estimator.inversion.problems import Observations, Problems

UNEXPLAINED = 1e-3
"""p value below which no contact that the model knows explains a frame."""
_SHARES = (0.0, 0.1, 0.2, 0.35, 0.5, 0.75, 1.0)
"""Shares of the believed error that are tried."""
_LEAST_FRAMES, MOST_FRAMES = 20, 100
"""Pressed frames from which a share is learnt, and of which the latest count."""


@dataclass
class ErrorShare:
    """Share of the believed error that pressed frames show; the whole until there are enough of them.

    `p_values` holds one row for each pressed frame: p by `_SHARES`.
    """

    model: ContactModel
    priors: Priors
    p_values: deque[np.ndarray] = field(default_factory=lambda: deque(maxlen=MOST_FRAMES))

    def learn(self, observations: Observations, problems: Problems) -> None:
        """Take pressed frames, one problem each; frames at rest have no error of the model."""
        rows = np.flatnonzero(problems.number)[-MOST_FRAMES:]
        if not len(rows):
            return
        pressed = problems.select(rows)
        self.p_values.extend(self.refitted_p_values(observations, pressed, *_SHARES))

    @property
    def share(self) -> float:
        """Return the share at which the median p value is ½.

        1 where the median is less with the whole error, 0 where it is more without any.
        """
        if len(self.p_values) < _LEAST_FRAMES:
            return 1.0
        median = np.maximum.accumulate(np.median(self.p_values, axis=0))
        return float(np.interp(0.5, median, _SHARES))

    def refitted_p_values(
        self, observations: Observations, problems: Problems, *shares: float
    ) -> Float[np.ndarray, "problem share"]:
        """Return p values of contacts, refitted, with shares of the model's error."""
        shape = len(problems), len(shares)
        repeated = problems.select(np.repeat(np.arange(len(problems)), len(shares)))
        frames = observations.select(repeated.frame)
        strict = frames.with_error_share(np.tile(shares, len(problems))[:, None])
        alone = replace(repeated, frame=np.arange(len(repeated)))
        if not np.array_equal(strict.sigma, frames.sigma):
            misfit = lowered_misfits(self.model, self.priors, strict, alone)
            alone = replace(alone, misfit=misfit)
        return p_values(strict, alone).reshape(shape)


def p_values(observations: Observations, problems: Problems) -> Float[np.ndarray, "problem"]:
    """Return the chance of a misfit as large if a problem's contacts were true."""
    from scipy.special import chdtrc

    return chdtrc(_freedoms(observations, problems), 2 * problems.misfit)


def excess(observations: Observations, problems: Problems) -> Float[np.ndarray, "problem"]:
    """Return χ² over its degrees of freedom, 1 at least.

    An unknown disturbance is larger than the known ones by that factor, squared (Birge's ratio).
    """
    return np.maximum(2 * problems.misfit / _freedoms(observations, problems), 1.0)


def _freedoms(observations: Observations, problems: Problems) -> Float[np.ndarray, "problem"]:
    return np.maximum(observations.readings[problems.frame] - 3.0 * problems.number, 1.0)

"""Magnets and steel near the object: frames that their field explains better than contacts alone do."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from jaxtyping import Bool, Float

from estimator.inversion.model.forward import NONE
from estimator.inversion.posterior import most_probable
from estimator.inversion.problems import Observations
from estimator.inversion.search import Hypotheses, Search

_LOG_ODDS = -10.0
"""Log odds, before a frame is seen, that a magnet or steel is near: one frame of 20 000. Its free field also
explains part of what a model is wrong by, and at even odds took contacts of imperfect twins away."""
_STEPS = 3
"""Steps of fits with a magnet near by, from contacts that were fitted without it."""


@dataclass(frozen=True)
class BesideMagnet:
    """Frames seen as they are (`plain`), and with the field of a magnet near by as a nuisance (`wide`)."""

    plain: Observations
    columns: Float[np.ndarray, "channel k"]

    @cached_property
    def wide(self) -> Observations:
        """Return the frames with the magnet's field integrated out."""
        return self.plain.add_nuisances(self.columns)

    def comparable(self, beside: Hypotheses) -> Float[np.ndarray, "set"]:
        """Return the log evidence of sets in `wide` on the scale of those in `plain`.

        Evidence leaves out the density of each whitening; the wider one is the lower by the share of
        signals that it allows for.
        """
        spread = self.wide.white.log_spread() - self.plain.white.log_spread()
        return beside.log_evidence - spread[beside.problems.frame] + _LOG_ODDS

    def explains_with_fewer(
        self, search: Search, believed: Hypotheses
    ) -> Bool[np.ndarray, "frame"]:
        """Return where a magnet and some of the strongest contacts of the believed sets, or none, are
        more probable than the whole set; one set a frame."""
        best = believed.problems
        order = np.argsort(-best.contact[..., 2] * (best.face != NONE), axis=1)
        face = np.take_along_axis(best.face, order, 1)
        contact = np.take_along_axis(best.contact, order[..., None], 1)
        slot = np.arange(face.shape[1])
        row, kept = np.nonzero(slot < best.number[:, None])
        if not len(row):
            return np.zeros(len(best), bool)
        face = np.where(slot < kept[:, None], face[row], NONE)
        given = best.frame[row], face, contact[row], None, 1, _STEPS
        fewer = most_probable(
            search.model, search.priors, self.wide.moved_to(search.reference), *given
        ).to_host()
        better = self.comparable(search.judged(fewer)) > believed.log_evidence[row]
        return np.bincount(row, better, len(best)) > 0

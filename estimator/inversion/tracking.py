"""Contacts followed from frame to frame: they slide and grow, appear and vanish."""

from __future__ import annotations

import numpy as np
from jaxtyping import Float

from estimator.inversion.inversion import Inversion
from estimator.inversion.posterior import Observed, Problems, empty, most_probable
from estimator.inversion.readings import ContactSets, contact_sets
from estimator.inversion.search import Hypotheses, together

_STEPS = 3
_CHANGE = np.log(0.02)
"""Log prior odds that a frame has another number of contacts than the last."""
_FAINT = 3.0
"""Contacts below so many standard deviations of their force may have gone."""
_STRAINED, _UNEXPLAINED = 0.02, 1e-3
"""p values below which one more contact is tried, and all are looked for anew."""


class Tracker:
    """Reads frame after frame from where the last contacts were.

    A number of contacts that changes costs evidence, so that noise does not make it flicker. Where
    the contacts of the last frame no longer explain what is seen, all are looked for anew. `seen_anew`
    counts these frames.
    """

    def __init__(self, inversion: Inversion) -> None:
        self.inversion = inversion
        self.seen_anew = 0
        self._last: Problems | None = None

    def feed(self, counts: Float[np.ndarray, "channel"], averaged: int = 1) -> ContactSets:
        """The contacts of the next frame (changes of counts against rest)."""
        seen = self.inversion.disturbances.observed(counts[None], averaged)
        found, odds = self._followed(seen)
        sets = contact_sets(self.inversion.model, seen, found, odds)
        if sets.p_value[0] < _UNEXPLAINED:
            self.seen_anew += 1
            every = self.inversion.search.contacts(seen)
            best, odds = every.most_probable(1)
            anew = every.problems.select(best)
            if anew.misfit[0] < found.misfit[0]:
                found = anew
                sets = contact_sets(self.inversion.model, seen, found, odds)
        self._last = found
        return sets.with_force_error(self.inversion.disturbances.force_error)

    def _followed(self, seen: Observed) -> tuple[Problems, Float[np.ndarray, "1"]]:
        """The last contacts refitted, with one more or one less where the frame says so."""
        search, last = self.inversion.search, self._last
        if last is None:
            last = empty(seen, np.zeros(1, int), search.priors.most)
        if last.number[0]:
            extra = search.model.interaction(last.face, last.contact)
            same = most_probable(
                search.model,
                search.priors,
                seen,
                last.frame,
                last.face,
                last.contact,
                extra,
                1,
                _STEPS,
            )
        else:
            same = empty(seen, np.zeros(1, int), search.priors.most)
        every = [search.judged(same)]
        if contact_sets(search.model, seen, same, np.ones(1)).p_value[0] < _STRAINED:
            every.append(_changed(search.grown(seen, same)))
        if self._faint(same):
            every.append(_changed(search.fewer(seen, same)))
        judged = every[0] if len(every) == 1 else together(every)
        best, odds = judged.most_probable(1)
        return judged.problems.select(best), odds

    def _faint(self, same: Problems) -> bool:
        number = int(same.number[0])
        if not number:
            return False
        covariance = np.linalg.inv(same.curvature[0])
        sigma = np.sqrt(np.diagonal(covariance)[2 : 3 * number : 3])
        return bool(np.any(same.contact[0, :number, 2] < _FAINT * sigma))


def _changed(judged: Hypotheses) -> Hypotheses:
    return Hypotheses(judged.problems, judged.log_evidence + _CHANGE)

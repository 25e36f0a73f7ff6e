"""Chips that lie in frames which nothing explains: which one, left out, lets contacts explain them."""

from __future__ import annotations

import numpy as np
from jaxtyping import Float, Int

from estimator.inversion.explained import ErrorShare
from estimator.inversion.model.forward import NONE
from estimator.inversion.posterior import most_probable
from estimator.inversion.problems import BLIND, Observations, Problems
from estimator.inversion.search import Hypotheses, Search
from estimator.signals.hall import full_scale_counts

_EXPLAINS = 0.02
"""Least p value of a frame without the chip: of some fifteen tries on a frame that no contact explains
one reaches it in a third of the frames at p = 0.001, and in none of those far off."""
_STEPS = 3
"""Steps from the frame before: contacts have moved little."""
_DIAGNOSED, _SUSPECTS = 6, 2
"""Frames in which every chip is left out in turn, and chips named there that are left out of others."""


def lying_chips(
    search: Search, observations: Observations, error: ErrorShare
) -> Int[np.ndarray, "frame"]:
    """Return the chip (row of sensors) to be left out of each frame, or `NONE`.

    One chip at most: what two chips or more feel is a magnet, steel or a slipped core.
    """
    frames = np.arange(len(observations.counts))
    few = frames[np.unique(np.linspace(0, len(frames) - 1, _DIAGNOSED).astype(int))]
    chips = np.flatnonzero((observations.sigma[0].reshape(-1, 3) < BLIND / 2).any(axis=1))
    p_value = _p_without(search, observations, error, few, chips)
    named = chips[p_value.argmax(axis=1)][p_value.max(axis=1) >= _EXPLAINS]
    suspects = np.argsort(-np.bincount(named, minlength=1), kind="stable")[:_SUSPECTS]
    suspects = suspects[np.isin(suspects, named)]
    if not len(suspects):
        return np.full(len(frames), NONE)
    p_value = _p_without(search, observations, error, frames, suspects)
    best = suspects[p_value.argmax(axis=1)]
    return np.where(p_value.max(axis=1) >= _EXPLAINS, best, NONE)


def lying_chip_beside(
    search: Search, observations: Observations, contacts: Problems, error: ErrorShare
) -> int:
    """Return the chip without which contacts near those of the frame before explain a frame, or `NONE`.

    Quick: no contact is looked for. `observations` and `contacts` are of one frame.
    """
    chips = np.flatnonzero((observations.sigma[0].reshape(-1, 3) < BLIND / 2).any(axis=1))
    tried = observations.select(np.zeros(len(chips), int)).without(chips)
    many = contacts.select(np.zeros(len(chips), int))
    given = np.arange(len(chips)), many.face, many.contact, many.extra, 1, _STEPS
    fit = most_probable(search.model, search.priors, tried, *given).to_host()
    p_value = error.refitted_p_values(tried, fit, error.share)[:, 0]
    best = int(p_value.argmax())
    return int(chips[best]) if p_value[best] >= _EXPLAINS else NONE


def log_evidence_without(
    search: Search,
    observations: Observations,
    chip: Int[np.ndarray, "frame"],
    sets: Hypotheses,
) -> Float[np.ndarray, "frame"]:
    """Return the log evidence of sets found without a chip, one a frame, on the scale of those of frames
    in which all is believed: what the chip shows may be anything in its range."""
    without_chip = observations.without(chip)
    out = observations.sigma != without_chip.sigma
    anywhere = np.log(2 * full_scale_counts(search.model.spec.sensors))
    # 1 / range instead of 1 / (σ √(2π)) for each channel of the chip, and what the others share
    lost = np.where(out, anywhere - np.log(np.sqrt(2 * np.pi) * observations.sigma), 0.0)
    spread = observations.white.log_spread() - without_chip.white.log_spread()
    return sets.log_evidence + spread - lost.sum(axis=1)


def _p_without(
    search: Search,
    observations: Observations,
    error: ErrorShare,
    frames: Int[np.ndarray, "frame"],
    chips: Int[np.ndarray, "chip"],
) -> Float[np.ndarray, "frame chip"]:
    """p values of the best contacts of frames, each read without each chip."""
    tried = observations.select(np.repeat(frames, len(chips))).without(np.tile(chips, len(frames)))
    hypotheses = search.contacts(tried)
    best = hypotheses.problems.select(hypotheses.best()).to_host()
    return error.refitted_p_values(tried, best, error.share).reshape(len(frames), len(chips))

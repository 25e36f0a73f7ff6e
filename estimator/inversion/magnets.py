"""Magnets and steel near the object, small slips of its core: frames that contacts explain less well."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from jaxtyping import Bool, Float, Int

from design.layout.places.positions import shell_body_layout
from estimator.inversion.explained import UNEXPLAINED, p_values
from estimator.inversion.model.arrays import like, rows_of
from estimator.inversion.model.forward import NONE, ContactModel
from estimator.inversion.posterior import most_probable, refitted
from estimator.inversion.problems import Observations, Problems
from estimator.inversion.search import Hypotheses, Search

_LOG_ODDS = -0.5
"""Log odds, before a frame is seen, of a magnet or steel near by to one contact more. A tenth of the magnets
that look like contacts are then read so (a sixth at −1); of presses of 1 to 3 N, 2 % are taken for
magnets (0.5 % at −1)."""
_TOGETHER = 2.5
"""Log odds against a magnet for every contact more than one that it stands for: jaws and hands bring
several contacts at once. Without it, grasps of weak signals are taken for magnets (tests)."""
_STEPS = 3
"""Steps of fits with a magnet near by, from contacts that were fitted without it."""
_HOPELESS = 100.0
"""Misfit over that without a magnet, from which a fit ends with its first step: no magnet shows what strong
contacts show."""

_SLIP_MM, _SLIP_RAD = 0.1, 0.005
"""Deviations of a small slip of the core: 0.005 rad at 20 mm is 0.1 mm. Signals are linear in slips so small,
and contacts explain none above 0.1 mm (tests)."""


def slip_columns(model: ContactModel) -> Float[np.ndarray, "channel 6"]:
    """Return columns A, with A Aᵀ the covariance of the counts that a small slip of the core adds at rest.

    Shifts along x, y and z of the object, then turns about them: all that the shell holds moves the
    other way.
    """
    moved = slip_motions(model, np.eye(6))
    return (model.counts_of_motions(moved) - model.counts_of_motions(-moved)).T / 2


def slip_motions(
    model: ContactModel, unknowns: Float[np.ndarray, "slip 6"]
) -> Float[np.ndarray, "slip body 6"]:
    """Return how all that the shell holds moves against the core (mm, rad) in slips of the core, given in
    standard deviations as in `slip_columns`."""
    shift_mm = -_SLIP_MM * unknowns[:, None, :3]
    turn_rad = -_SLIP_RAD * unknowns[:, None, 3:]
    moved = np.zeros((len(unknowns), *model.rest.shape))
    moved[..., :3] = shift_mm + np.cross(turn_rad, shell_body_layout(model.spec).centre_mm)
    moved[..., 3:] = turn_rad
    return moved


@dataclass(frozen=True)
class BesideMagnet:
    """Frames seen as they are (`plain`), and with the field of a magnet near by as a nuisance.

    `columns` of each shell of distances, and of a slip (`Inversion.lookalike_columns`).
    """

    plain: Observations
    columns: tuple[Float[np.ndarray, "channel k"], ...]

    @property
    def wide(self) -> Observations:
        """Return the frames with the field of a magnet in the nearest shell integrated out."""
        return self.plain.add_nuisances(self.columns[0])

    @cached_property
    def _shells(self) -> Observations:
        """Return the frames with the field of a magnet integrated out, shell by shell."""
        frames = len(self.plain.counts)
        columns = np.stack([self.plain.add_nuisances(shell).shared for shell in self.columns])
        repeated = self.plain.select(np.tile(np.arange(frames), len(columns)))
        return replace(repeated, columns=columns.repeat(frames, axis=0))

    def log_evidence(self, search: Search, sets: Problems) -> Float[np.ndarray, "set"]:
        """Return the log evidence of contacts near a magnet, on the scale of those without one.

        Contacts are fitted again in every shell; shells are equally likely.
        """
        return self._judged_sets(search, sets)[0]

    def _judged_sets(
        self, search: Search, sets: Problems
    ) -> tuple[Float[np.ndarray, "set"], Float[np.ndarray, "set"]]:
        """Return `log_evidence` and the largest p value of any shell."""
        frames, shells = len(self.plain.counts), len(self.columns)
        rows = np.tile(np.arange(len(sets)), shells)
        many = sets.select(rows)
        frame = many.frame + frames * np.arange(shells).repeat(len(sets))
        face, contact = (like(search.reference, part) for part in (sets.face, sets.contact))
        extra = rows_of(search.model.interaction(face, contact), rows)
        moved = self._shells.moved_to(search.reference)
        given = frame, many.face, many.contact, extra, 1, 1
        fit = most_probable(search.model, search.priors, moved, *given)
        (hopeful,) = np.nonzero(fit.misfit < many.misfit + _HOPELESS)
        if len(hopeful):
            again = fit.select(hopeful)
            again = refitted(search.model, search.priors, moved, again, 1, _STEPS - 1)
            fit = fit.replaced(hopeful, again)
        fit = fit.to_host()
        # Evidence leaves out the density of each whitening; a wider one is the lower by the share
        # of signals that it allows for.
        spread = self._shells.white.log_spread()[frame] - self.plain.white.log_spread()[many.frame]
        evidence = (search.judged(fit).log_evidence - spread).reshape(shells, -1)
        p_value = p_values(self._shells, fit).reshape(shells, -1).max(axis=0)
        return np.logaddexp.reduce(evidence) - np.log(shells) + _LOG_ODDS, p_value

    def explains_with_fewer(
        self, search: Search, believed: Hypotheses
    ) -> Bool[np.ndarray, "frame"]:
        """Return where a magnet and some of the strongest contacts of the believed sets, or none, explain
        a frame and are more probable than the whole set; one set a frame.

        Contacts of a model that is known to be wrong are vague: any magnet would be more probable,
        also one that does not explain the frame.
        """
        best = believed.problems
        # Any magnet explains fewer readings than it has unknowns: they tell nothing of one.
        readings = self.plain.readings[best.frame]
        # A magnet beside the whole set is a further source, and no better place of any contact.
        beside, p_value = self._judged_by_number(search, best, best.number - 1)
        beside = np.where(p_value < UNEXPLAINED, -np.inf, beside)
        dropped = best.number[:, None] - np.arange(beside.shape[1])
        beside = beside - _TOGETHER * np.maximum(dropped - 1, 0)
        likelier = beside.max(axis=1, initial=-np.inf) > believed.log_evidence
        return likelier & (readings > self.columns[0].shape[1])

    def is_likelier_than_chip(
        self, search: Search, believed: Hypotheses, without_chip: Float[np.ndarray, "frame"]
    ) -> Bool[np.ndarray, "frame"]:
        """Return where a magnet and some of the believed contacts are more probable than a chip that
        lies; `without_chip` as `log_evidence_without` gives it."""
        sets = believed.problems
        return self._judged_by_number(search, sets, sets.number)[0].max(axis=1) > without_chip

    def _judged_by_number(
        self, search: Search, sets: Problems, most: Int[np.ndarray, "frame"]
    ) -> tuple[Float[np.ndarray, "frame kept"], Float[np.ndarray, "frame kept"]]:
        """Return log evidence and p value of a magnet and the strongest 0, 1, 2, … contacts of each
        frame's set; −∞ beyond the most that are kept of it."""
        order = np.argsort(-sets.contact[..., 2] * (sets.face != NONE), axis=1, kind="stable")
        face = np.take_along_axis(sets.face, order, 1)
        contact = np.take_along_axis(sets.contact, order[..., None], 1)
        slots = face.shape[1]
        row, kept = np.nonzero(np.arange(slots + 1) <= most[:, None])
        few = np.where(np.arange(slots) < kept[:, None], face[row], NONE)
        tried = replace(sets.select(row), face=few, contact=contact[row])
        evidence, p_value = np.full((2, len(sets), slots + 1), -np.inf)
        evidence[row, kept], p_value[row, kept] = self._judged_sets(search, tried)
        return evidence, p_value

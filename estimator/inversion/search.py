"""Contacts of frames from scratch: one after the other, all refitted, as many as the evidence bears.

The next contact (or probe, where probes are known) comes from a coarse dictionary, or by halving one
that is there. The best few sets of each number go on; then every contact of the best set is taken
away and sought again, and one more is sought. On the way sets are fitted by a few steps, the
best of all numbers together to the end: half of the time of fitting each, with as many frames right.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from jaxtyping import Bool, Float, Int

from estimator.inversion.evidence import log_evidence, log_inside
from estimator.inversion.model.arrays import Array, concatenated, rows_of
from estimator.inversion.model.dictionary import Dictionary, dictionary
from estimator.inversion.model.forward import NONE, ContactModel
from estimator.inversion.posterior import most_probable, refitted
from estimator.inversion.priors import Priors, log_paired, number_on
from estimator.inversion.problems import Observations, Problems, empty

_KEPT, _KEPT_OF_MANY, _MANY = 3, 8, 4
"""Sets of one number that go on: usual, and from `_MANY` contacts on, where more are nearly as good."""
_ROUGH_STEPS = 2
"""Steps of fits that only choose among sets."""
_NEAR, _FEW = (1, 3), 2
"""Rounds and steps of sets on the way from `_FEW` contacts on: most frames have no more;
tangential forces, which make the posterior flat, need all steps."""
_SETTLED, _OUT_OF_THE_RACE = 4, 20.0
"""Sets of a frame that are fitted to the end, and by how much the log evidence of others is less."""
_QUIET, _HOPELESS = 0.75, 2.0
"""Sets go on while their misfit exceeds the first times what noise gives by more than the second: the
evidence asks four to eight of a further contact, but where noise is small there is more to explain."""
_EQUAL = 0.05
"""Difference of misfit or log evidence below which two sets are the same."""
_VISITS, _BETTER = 2, 1.0
"""Most visits to the best set of a frame, and the log evidence that it must have gained since."""
_HALF_MM = 6.0
"""Half the distance of two contacts that replace one."""
_HALVED_BY = _HALF_MM * np.array(
    [(1, 0, 0), (0, 1, 0), (0.5**0.5, 0.5**0.5, 0), (0.5**0.5, -(0.5**0.5), 0)]
)


@dataclass(frozen=True)
class Hypotheses:
    """Sets of contacts of frames, and the log of each one's evidence but for the frame's constant."""

    problems: Problems
    log_evidence: Float[np.ndarray, "problem"]

    def select(self, rows: Int[np.ndarray, "some"]) -> Hypotheses:
        """Return some of the sets, as sets of the frames 0, 1, 2, …"""
        few = replace(self.problems.select(rows), frame=np.arange(len(rows)))
        return Hypotheses(few, self.log_evidence[rows])

    def distinct(self) -> Hypotheses:
        """Return the sets without repeats; equal number and evidence mark a repeat."""
        number, frame = self.problems.number, self.problems.frame
        order = np.lexsort((self.log_evidence, number, frame))
        again = (
            (np.diff(frame[order]) == 0)
            & (np.diff(number[order]) == 0)
            & (np.diff(self.log_evidence[order]) < _EQUAL)
        )
        kept = np.sort(order[np.concatenate([[True], ~again])])
        return Hypotheses(self.problems.select(kept), self.log_evidence[kept])

    @cached_property
    def share(self) -> Float[np.ndarray, "problem"]:
        """Posterior probability of each set among all those found for its frame."""
        frame = self.problems.frame
        top = np.full(frame.max(initial=-1) + 1, -np.inf)
        np.maximum.at(top, frame, self.log_evidence)
        weight = np.exp(self.log_evidence - top[frame])
        return weight / np.bincount(frame, weight)[frame]

    @cached_property
    def odds(self) -> Float[np.ndarray, "problem"]:
        """Posterior probability of as many contacts on each face as a set has: of all such sets together."""
        return np.bincount(self._answer, self.share)[self._answer]

    @cached_property
    def _answer(self) -> Int[np.ndarray, "problem"]:
        """Equal for sets of one frame with as many contacts on each face."""
        faces = np.sort(self.problems.face, axis=1)
        answers = np.column_stack([self.problems.frame, faces])
        return np.unique(answers, axis=0, return_inverse=True)[1].reshape(-1)

    def best(self) -> Int[np.ndarray, "frame"]:
        """Row of each frame's most probable set of its most probable numbers of contacts."""
        return first_of_frame(self.problems.frame, -self.odds, -self.log_evidence)

    def second(self, best: Int[np.ndarray, "frame"]) -> Int[np.ndarray, "frame"]:
        """Row of each frame's next answer, of other numbers; that of the best where none was found."""
        (rows_of_other_answers,) = np.nonzero(
            self._answer != self._answer[best][self.problems.frame]
        )
        costs = -self.odds[rows_of_other_answers], -self.log_evidence[rows_of_other_answers]
        rows = rows_of_other_answers[
            first_of_frame(self.problems.frame[rows_of_other_answers], *costs)
        ]
        row_of_second = best.copy()
        row_of_second[self.problems.frame[rows]] = rows
        return row_of_second


@dataclass(frozen=True)
class Search:
    """Contacts of any frames of an object under priors."""

    model: ContactModel
    priors: Priors

    @cached_property
    def dictionary(self) -> Dictionary:
        """Return what a contact begins as."""
        return dictionary(self.model, self.priors)

    @property
    def reference(self) -> Array:
        """An array of the kind that the model works with, where it does."""
        return self.model.signals.coefficients

    @property
    def probes(self) -> bool:
        """Return whether contacts come as known probes, one a face."""
        return bool(self.priors.spacing_mm)

    @property
    def _rough_effort(self) -> tuple[int, ...]:
        return _NEAR if self.model.shear is None else ()

    def contacts(self, observations: Observations) -> Hypotheses:
        """Every frame's sets of contacts with their evidence."""
        observations = observations.moved_to(self.reference)
        level = empty(observations, np.arange(len(observations.counts)), self.priors.most)
        levels = [self.judged(level)]
        best = levels[0].log_evidence.copy()
        while len(level):
            effort = self._rough_effort if int(level.number.max()) >= _FEW else ()
            judged = self.judged(self._grown(observations, level, effort))
            levels.append(judged)
            np.maximum.at(best, judged.problems.frame, judged.log_evidence)
            level = judged.problems.select(self.worth_extending(judged, best))
        near = self.revisited(observations, together(levels)).distinct()
        return self._settled(observations, self._believed(near))

    def sets_of_number(self, observations: Observations, number: int) -> Problems:
        """Return the most probable set of `number` contacts of every frame that has one."""
        sets = empty(observations, np.arange(len(observations.counts)), self.priors.most)
        for _ in range(number):
            sets = self._grown(observations, sets)
        if number > 1:
            fewer = self.fewer(observations, sets.select(best_of_frame(sets, 1))).problems
            sets = Problems.joined([sets, self._grown(observations, fewer)])
        return sets.select(first_of_frame(sets.frame, sets.misfit))

    def grown(
        self, observations: Observations, sets: Problems, effort: tuple[int, ...] = ()
    ) -> Hypotheses:
        """The best sets of one contact more; `effort` is rounds and steps."""
        return self.judged(self._grown(observations, sets, effort))

    def fewer(
        self, observations: Observations, sets: Problems, effort: tuple[int, ...] = ()
    ) -> Hypotheses:
        """Each set without each of its contacts (or probes); `effort` is rounds and steps."""
        parts = []
        groups = range(self.priors.faces) if self.probes else range(self.priors.most)
        for group in groups:
            gone = np.zeros(sets.face.shape, bool)
            if self.probes:
                gone = sets.face == group
            else:
                gone[:, group] = sets.face[:, group] != NONE
            (rows,) = np.nonzero(gone.any(axis=1))
            face, contact = packed_slots(np.where(gone, NONE, sets.face)[rows], sets.contact[rows])
            parts.append((sets.frame[rows], face, contact))
        frame, face, contact = (np.concatenate(column) for column in zip(*parts, strict=True))
        given = frame, face, contact, None
        return self.judged(most_probable(self.model, self.priors, observations, *given, *effort))

    def judged(self, problems: Problems) -> Hypotheses:
        """Sets with their evidence under these priors."""
        inside = log_inside(self.model.bounds, self.priors, problems)
        return Hypotheses(problems, log_evidence(problems, self.priors) + inside)

    def _believed(self, hypotheses: Hypotheses) -> Hypotheses:
        """Sets with what is known of two jaws. Not on the way, which goes contact by contact."""
        paired = log_paired(self.priors, hypotheses.problems.face)
        return Hypotheses(hypotheses.problems, hypotheses.log_evidence + paired)

    def revisited(self, observations: Observations, hypotheses: Hypotheses) -> Hypotheses:
        """Return all sets, more of one contact more than the best, and more with a contact sought again.

        The visit is repeated where these are better.
        """
        reached = np.full(len(observations.counts), -np.inf)
        for _ in range(_VISITS):
            best = hypotheses.best()
            evidence = hypotheses.log_evidence[best]
            better = (evidence > reached + _BETTER) & (hypotheses.problems.number[best] > 1)
            if not better.any():
                break
            reached, sets = evidence, hypotheses.problems.select(best[better])
            fewer = self.fewer(observations, sets, self._rough_effort)
            starts = Problems.joined([fewer.problems, sets.select(self.may_add_contact(sets))])
            hypotheses = together(
                [hypotheses, fewer, self.grown(observations, starts, self._rough_effort)]
            )
        return hypotheses

    def _settled(self, observations: Observations, near: Hypotheses) -> Hypotheses:
        """The best sets of each frame, fitted to the end."""
        problems, evidence = near.problems, near.log_evidence
        order = np.lexsort((-evidence, problems.frame))
        frame = problems.frame[order]
        first = np.searchsorted(frame, frame)
        behind = evidence[order][first] - evidence[order]
        kept = (np.arange(len(order)) - first < _SETTLED) & (behind < _OUT_OF_THE_RACE)
        sets, others = problems.select(order[kept]), order[~kept]
        given = sets.frame, sets.face, sets.contact, sets.extra
        settled = self.judged(most_probable(self.model, self.priors, observations, *given))
        settled = self._believed(settled)
        rest = Hypotheses(problems.select(others), evidence[others])
        return together([settled, rest]).distinct()

    def _grown(
        self, observations: Observations, level: Problems, effort: tuple[int, ...] = ()
    ) -> Problems:
        rows, face, contact = self.dictionary.added(self.model, observations, level, self.probes)
        frame, extra = level.frame[rows], rows_of(level.extra, rows)
        if not self.probes:
            halved = half_contacts(level.select(best_of_frame(level, 1)))
            frame, face, contact, extra = (
                concatenated(pair)
                for pair in zip((frame, face, contact, extra), halved, strict=True)
            )
        if not len(frame):
            return empty(observations, frame, self.priors.most)
        rough = most_probable(
            self.model, self.priors, observations, frame, face, contact, extra, 1, _ROUGH_STEPS
        )
        going_on = _KEPT if level.number.max() < _MANY else _KEPT_OF_MANY
        kept = rough.select(best_of_frame(rough, 2 * going_on))
        refined = refitted(self.model, self.priors, observations, kept, *effort)
        return refined.select(best_of_frame(refined, going_on))

    def worth_extending(self, judged: Hypotheses, best: np.ndarray) -> np.ndarray:
        """Sets that a further contact may still bring beyond the best so far."""
        problems = judged.problems
        better = judged.log_evidence + self._possible(problems) > best[problems.frame]
        return better & self.may_add_contact(problems)

    def may_add_contact(self, problems: Problems) -> Bool[np.ndarray, "problem"]:
        """Return whether misfit, slots and jaws leave room for a further contact (or probe)."""
        room = (self._possible(problems) > _HOPELESS) & (problems.number < self.priors.most)
        if self.probes and self.priors.paired:
            room &= number_on(self.priors, problems.face).astype(bool).sum(axis=1) < 2
        return room

    def _possible(self, problems: Problems) -> Float[np.ndarray, "problem"]:
        """Return how much further contacts may raise the evidence: the misfit, and the odds of a second jaw
        where one of two has no contact."""
        unexplained = problems.misfit - _QUIET * 0.5 * (self.model.channels - 3 * problems.number)
        return unexplained - log_paired(self.priors, problems.face)


def together(parts: list[Hypotheses]) -> Hypotheses:
    """All sets of several finds."""
    evidence = np.concatenate([part.log_evidence for part in parts])
    return Hypotheses(Problems.joined([part.problems for part in parts]), evidence)


def half_contacts(level: Problems) -> tuple[np.ndarray, np.ndarray, np.ndarray, Array]:
    """Every contact split in two, four ways: frame, face, contact, extra."""
    slots = level.face.shape[1]
    some = (level.face != NONE) & (level.number < slots)[:, None]
    rows, slot, way = (
        index.ravel() for index in np.nonzero(np.repeat(some[..., None], len(_HALVED_BY), axis=2))
    )
    face, contact = level.face[rows], level.contact[rows]
    each, new = np.arange(len(rows)), level.number[rows]
    half = contact[each, slot] * [1, 1, 0.5]
    offset = _HALVED_BY[way]
    face[each, new] = face[each, slot]
    contact[each, slot], contact[each, new] = half + offset, half - offset
    return level.frame[rows], face, contact, rows_of(level.extra, rows)


def first_of_frame(frame: np.ndarray, *costs: np.ndarray) -> Int[np.ndarray, "n"]:
    order = np.lexsort((*costs[::-1], frame))
    return order[np.unique(frame[order], return_index=True)[1]]


def best_of_frame(problems: Problems, kept: int) -> Int[np.ndarray, "n"]:
    """Rows of the sets of least misfit of each frame, of one number of contacts each, equal ones once."""
    number = problems.number
    order = np.lexsort((problems.misfit, number, problems.frame))
    columns = (part[order].tolist() for part in (problems.frame, number, problems.misfit))
    chosen: list[int] = []
    group, taken, last = (-1, -1), 0, 0.0
    for row, frame, contacts, misfit in zip(order.tolist(), *columns, strict=True):
        if (frame, contacts) != group:
            group, taken = (frame, contacts), 0
        if taken < kept and not (taken and misfit - last < _EQUAL):
            taken, last = taken + 1, misfit
            chosen.append(row)
    return np.array(chosen, int)


def packed_slots(face: np.ndarray, contact: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Filled slots first."""
    order = np.argsort(face == NONE, axis=1, kind="stable")
    return np.take_along_axis(face, order, 1), np.take_along_axis(contact, order[..., None], 1)

"""Contacts followed from frame to frame: they slide and grow, appear and vanish."""

from __future__ import annotations

import math
from collections import deque
from dataclasses import replace

import numpy as np
from jaxtyping import Bool, Float

from estimator.inversion.condition import Condition, object_condition
from estimator.inversion.evidence import joint_covariance
from estimator.inversion.explained import UNEXPLAINED, p_values
from estimator.inversion.inversion import SURE, Inversion
from estimator.inversion.jaws import JawFit
from estimator.inversion.lying import log_evidence_without, lying_chip_beside, lying_chips
from estimator.inversion.magnets import BesideMagnet
from estimator.inversion.model.forward import NONE
from estimator.inversion.posterior import most_probable
from estimator.inversion.problems import Observations, Problems, empty
from estimator.inversion.readings import ContactSets, widened
from estimator.inversion.search import Hypotheses, together
from estimator.inversion.slip import REST_FRAMES, Slip, slip_at_rest

_STEPS = 3
"""Steps from the frame before: contacts have moved little."""
_CHANGE = np.log(0.1)
"""Log prior odds that a frame has another number of contacts than the last."""
_FAINT = 3.0
"""Standard deviations of its force below which a contact may have gone."""
_LONGEST_PAUSE = 8
"""Frames after which a further contact is tried again, at most; the pause doubles up to it."""
_WORSE = 0.1
"""A p value that falls by more than this ends the wait."""
_LEARNT_EVERY = 5
"""Interval, in pressed frames, at which the error of the model is learnt, and at which contacts that go on
are weighed against a magnet, two frames later: that takes more time than the rest of a frame."""
_GROWN = 2.0
"""Factor by which the force of jaws has grown where they are weighed against tips again."""
_STRAINED = 0.02
"""p value below which one more contact is tried."""
_TRUSTED_AFTER = 8
"""Frames in a row that must be explained with all chips and no magnet. A channel of ten times its
noise agrees by chance in one of four."""
_JUDGED_FRAMES = 200
"""Last frames that the object's condition is judged by."""
_GONE_AFTER = 2
"""Frames in a row in which contacts alone must be more probable than near a magnet: then it is gone."""


class Tracker:
    """Reads frame after frame from where the last contacts were.

    A number of contacts that changes costs evidence, so that noise does not make it flicker. Where
    the contacts of the last frame no longer explain what is seen, one more is tried, then all are
    sought again; after a vain try only every second frame, every fourth, every eighth, unless the
    misfit grows: meanwhile the odds of the last try stand. `seen_anew` counts the frames in which all
    were looked for. All are sought too where the force of jaws that may be tips has doubled, and in the
    second, fourth, eighth, … frame near a magnet: light contacts are weak evidence of either. A chip without
    which a frame is explained that is not with it is left out, and the field of a magnet near by is a
    nuisance where that is more probable than contacts: until several frames in a row are explained as they
    are.

    A core that slipped shows in frames at rest; from then on what the slip adds is taken off, and what is
    uncertain of it is a nuisance.

    Attributes
    ----------
    beside_magnet : whether a magnet near by is believed
    slip : of the core, as far as it is known; None where it has not slipped
    """

    def __init__(self, inversion: Inversion) -> None:
        self.inversion = inversion
        self.seen_anew = 0
        self._last: Problems | None = None
        self._wait, self._pause, self._tried_p = 0, 1, 1.0
        self._odds = np.ones(1)
        self._error = inversion.error_share()
        self._pressed = 0
        self._strange, self._sound, self._chip_out = 0, 0, NONE
        self._jaws: tuple[JawFit, ContactSets] | None = None
        self._rival: JawFit | None = None
        self.beside_magnet = False
        self._weighed_n, self._beside_for = 0.0, 0
        self.slip: Slip | None = None
        self._resting: deque[np.ndarray] = deque(maxlen=REST_FRAMES)
        self._unjudged = 0
        self._recent: deque[tuple[bool, bool]] = deque(maxlen=_JUDGED_FRAMES)
        self._widened = 1.0
        fresh = inversion.disturbances
        self._fresh_counts = float(np.median(np.hypot(fresh.noise_counts, fresh.offset_counts)))

    def feed(
        self,
        counts: Float[np.ndarray, "channel"],
        drift_counts: float = 0.0,
        left_counts: float | None = None,
    ) -> ContactSets:
        """Return the contacts of the next frame (changes of counts against rest).

        `drift_counts` is the deviation of what every channel drifted since rest, `left_counts` of what of it
        a hold has not shown (default: all). What a hold has shown widens `covariance` alone, with the common
        error of forces in it: not the sizes of jaws, tangential forces, nor what changed since the zero.
        """
        unshown = drift_counts if left_counts is None else left_counts
        self._widened = math.hypot(1.0, unshown / self._fresh_counts)
        sets = self._contacts_in(self._without_slip(counts, unshown))
        if drift_counts > unshown:
            # Drift along a hold's own pattern shows in no channel: it was steady, or it was not.
            factor = (1 + (drift_counts / self._fresh_counts) ** 2) / self._widened**2
            wide = widened(sets.covariance, np.full(1, factor), self.inversion.priors)
            sets = replace(sets, covariance=wide)
        self._notice_slip(counts, unshown, sets)
        self._recent.append((not sets.explained[0], self.beside_magnet))
        return sets

    def condition(self, out: Bool[np.ndarray, "channel"] | None = None) -> Condition:
        """Return the object's condition by its last frames; channels `out` gave no readings to believe."""
        silent = ~self.believed if out is None else ~self.believed | out
        chips = np.flatnonzero(silent.reshape(-1, 3).any(axis=1)).tolist()
        frames = np.array(self._recent, float).reshape(-1, 2)
        unexplained, beside_magnet = frames.mean(axis=0).tolist() if len(frames) else (0.0, 0.0)
        return object_condition(
            unexplained,
            beside_magnet,
            0.0 if self.slip is None else self.slip.size_mm,
            [self.inversion.chip_name(chip) for chip in chips],
        )

    def _without_slip(
        self, counts: Float[np.ndarray, "channel"], drift_counts: float
    ) -> Observations:
        """Return a frame without what a slip of the core adds to it."""
        if self.slip is None:
            return self.inversion.disturbances.observed(counts[None], drift_counts=drift_counts)
        change = (counts - self.slip.counts)[None]
        frame = self.inversion.disturbances.observed(change, drift_counts=drift_counts)
        return frame.add_nuisances(self.slip.columns)

    def _notice_slip(
        self, counts: Float[np.ndarray, "channel"], drift_counts: float, sets: ContactSets
    ) -> None:
        """Judge the mean of frames in which no contact is read, or that none explains."""
        if sets.number[0] and sets.explained[0]:
            self._resting.clear()
            return
        self._resting.append(counts)
        self._unjudged += 1
        due = not sets.explained[0] or self._unjudged >= REST_FRAMES
        if len(self._resting) < REST_FRAMES or not due:
            return
        self._unjudged = 0
        mean = np.where(self.believed, np.mean(self._resting, axis=0), np.nan)
        slip = slip_at_rest(self.inversion, mean, REST_FRAMES, drift_counts, self.slip)
        if slip is not None:
            self._resting.clear()
            self._recent.clear()
            self.slip, self._last = slip, None
            self.beside_magnet, self._chip_out = False, NONE

    def _contacts_in(self, plain: Observations) -> ContactSets:
        """Return the contacts of the next frame, as `feed`."""
        followed = self._follow_jaws(plain)
        if followed is not None:
            return followed
        anew = self.seen_anew
        self._believe_again(plain)  # may look for contacts from scratch
        last = self._last
        sets = self._followed(self._seen(plain))
        # Tips that go on as they were need no other kind of contact.
        changed = last is None or sets.number[0] != last.number[0] or self.seen_anew > anew
        if changed or self._rival is not None or not sets.explained[0]:
            sets = self._try_jaws(plain, sets, bool(changed))
        self._strange = 0 if sets.explained[0] else self._strange + 1
        if self._strange:
            sets = self._diagnosed(plain, last, sets)
        elif (
            self._jaws is None
            and (changed or self._pressed % _LEARNT_EVERY == 2)
            and self._is_magnet(plain)
        ):
            sets = self._turned(plain, None, NONE, magnet=True)
        if self.beside_magnet:
            sets = replace(sets, p_value=np.zeros(1))
        return replace(sets, chip_out=np.full(1, self._chip_out))

    def _follow_jaws(self, plain: Observations) -> ContactSets | None:
        """Return the jaws of the frame before refitted, or tips that are far more probable once the force has
        grown. None where the last frame had no jaws, where refitted they leave too much of this one, or
        where one of them is faint."""
        if self._jaws is None:
            return None
        (last, reading), self._jaws, self._last = self._jaws, None, None
        fit = self.inversion.jaws.refit(plain, last)
        force, sigma = fit.values[:, 2], np.sqrt(fit.covariance[:, 2, 2])
        if fit.p_value < _STRAINED or np.any(force < _FAINT * sigma):
            return None
        sets = self.inversion.jaw_reading(fit, reading)
        if not self.inversion.flat and force.sum() > _GROWN * self._weighed_n:
            self._weighed_n = float(force.sum())
            sought, odds = self._anew(plain)
            tips = self.inversion.reading(plain, sought.problems, odds, self._error)
            sets = self.inversion.weighed(fit, tips, float(sought.log_evidence[0]), -SURE)
            if not sets.jaws[0]:
                self._last, self._odds = sought.problems, odds
                self._rival = None if sets is tips else fit
                return sets
        self._jaws = fit, sets
        return sets

    def _try_jaws(self, plain: Observations, tips: ContactSets, changed: bool) -> ContactSets:
        """Return the frame's jaws where these are far more probable than the tips just read, and these tips
        as uncertain as jaws make them: the last rival as it is now, a new one where contacts changed."""
        rival, self._rival = self._rival, None
        if self._chip_out != NONE or self.beside_magnet or self._last is None:
            return tips
        if not self.inversion.jaw_tables or not tips.number[0]:
            return tips
        evidence = float(self.inversion.search.judged(self._last).log_evidence[0])
        if rival is None or changed or not tips.explained[0]:
            fit = self.inversion.rival_jaws(plain, tips, evidence)
        else:
            fit = self.inversion.jaws.refit(plain, rival)
        if fit is None:
            return tips
        sets = self.inversion.weighed(fit, tips, evidence)
        if sets.jaws[0]:
            self._jaws, self._weighed_n = (fit, sets), float(fit.values[:, 2].sum())
        elif sets is not tips:
            self._rival = fit
        return sets

    @property
    def believed(self) -> Bool[np.ndarray, "channel"]:
        """Return which channels are not those of a chip that is left out."""
        return np.arange(self.inversion.model.channels) // 3 != self._chip_out

    def _seen(self, plain: Observations) -> Observations:
        """Return the frame without a chip that lies, or with a magnet near by, where that is believed."""
        if self.beside_magnet:
            return plain.add_nuisances(self.inversion.lookalike_columns[0])
        return plain if self._chip_out == NONE else plain.without(np.array([self._chip_out]))

    def _believe_again(self, plain: Observations) -> None:
        """Believe all once the last contacts have explained several frames in a row as they are, or contacts
        sought from scratch explain one better than a magnet."""
        if self._chip_out == NONE and not self.beside_magnet:
            return
        refitted = self._same(plain)
        explains = p_values(plain, refitted)[0] >= _STRAINED
        search = self.inversion.search
        beside = BesideMagnet(plain, self.inversion.lookalike_columns)
        if self.beside_magnet and explains:
            alone = search.judged(refitted).log_evidence
            explains = (alone > beside.log_evidence(search, refitted)).all()
        self._sound = self._sound + 1 if explains else 0
        self._beside_for += self.beside_magnet
        if self.beside_magnet and not explains and _is_due(self._beside_for):
            sought, _ = self._anew(plain)
            explains = p_values(plain, sought.problems)[0] >= _STRAINED
            if explains and not beside.explains_with_fewer(search, sought)[0]:
                refitted, self._sound = sought.problems, _GONE_AFTER
        if self._sound >= (_GONE_AFTER if self.beside_magnet else _TRUSTED_AFTER):
            self._chip_out, self.beside_magnet = NONE, False
            self._last, self._sound = refitted, 0

    def _is_magnet(self, plain: Observations) -> bool:
        """Return whether a magnet and fewer contacts are more probable than the contacts found."""
        if (
            self.beside_magnet
            or self._chip_out != NONE
            or self._last is None
            or not self._last.number[0]
        ):
            return False
        search = self.inversion.search
        beside = BesideMagnet(plain, self.inversion.lookalike_columns)
        return bool(beside.explains_with_fewer(search, search.judged(self._last))[0])

    def _diagnosed(
        self, plain: Observations, previous: Problems | None, sets: ContactSets
    ) -> ContactSets:
        """Return the contacts of a frame that nothing explains, without a chip or with a magnet near by.

        By the contacts of the frame before at once; from scratch in the second, fourth, eighth, …
        frame on end.
        """
        search, error, contacts = self.inversion.search, self._error, self._last
        previous = (
            empty(plain, np.zeros(1, int), search.priors.most) if previous is None else previous
        )
        chip = lying_chip_beside(search, plain, previous, error)
        if chip != NONE and self._chip_lies(plain, previous, chip):
            return self._turned(plain, previous, chip, magnet=False)
        if self._is_magnet(plain):
            return self._turned(plain, None, NONE, magnet=True)
        if not _is_due(self._strange):
            return sets
        (chip,) = lying_chips(search, plain, error).tolist()
        if chip != NONE and self._chip_lies(plain, previous, chip):
            return self._turned(plain, None, chip, magnet=False)
        beside = self._turned(plain, None, NONE, magnet=True)
        if beside.explained[0]:
            return beside
        self.beside_magnet, self._last = False, contacts
        return sets

    def _chip_lies(self, plain: Observations, contacts: Problems, chip: int) -> bool:
        """Return whether a chip that lies is more probable than a magnet near by, with contacts near the
        given ones."""
        search, out = self.inversion.search, np.array([chip])
        given = contacts.frame, contacts.face, contacts.contact, None, 1, _STEPS
        fit = most_probable(search.model, search.priors, plain.without(out), *given).to_host()
        sound = search.judged(fit)
        beside = BesideMagnet(plain, self.inversion.lookalike_columns)
        evidence = log_evidence_without(search, plain, out, sound)
        return not beside.is_likelier_than_chip(search, sound, evidence)[0]

    def _turned(
        self, plain: Observations, contacts: Problems | None, chip: int, magnet: bool
    ) -> ContactSets:
        """Return contacts from given ones, or from scratch, with another belief of chips and magnets."""
        self._chip_out, self.beside_magnet = chip, magnet
        self._last, self._sound, self._beside_for = contacts, 0, 0
        return self._followed(self._seen(plain))

    def _followed(self, observations: Observations) -> ContactSets:
        """The next frame's contacts, of channels that are believed."""
        problems = self._same(observations)
        p_value = float(p_values(observations, problems)[0])
        if p_value >= _STRAINED and not self.faint_contacts(problems):
            self._wait, self._pause, self._odds = 0, 1, np.ones(1)
        elif self._wait and p_value > _WORSE * self._tried_p:
            self._wait -= 1
        else:
            number_of_last, self._tried_p = problems.number[0], p_value
            problems, self._odds = self.has_changed(observations, problems)
            if problems.number[0] == number_of_last:
                self._pause = min(2 * self._pause, _LONGEST_PAUSE)
                self._wait = self._pause - 1
        self._last = problems
        self._pressed += int(problems.number[0] > 0)
        if problems.number[0] and self._pressed % _LEARNT_EVERY == 0:
            self._error.learn(observations, problems)
        return self.inversion.reading(observations, problems, self._odds, self._error)

    def _same(self, observations: Observations) -> Problems:
        """The last contacts refitted."""
        search, last = self.inversion.search, self._last
        if last is None or not last.number[0]:
            return empty(observations, np.zeros(1, int), search.priors.most)
        start = last.frame, last.face, last.contact, None, 1, _STEPS
        return most_probable(search.model, search.priors, observations, *start)

    def has_changed(
        self, observations: Observations, same: Problems
    ) -> tuple[Problems, Float[np.ndarray, "1"]]:
        """Return one contact more, or without faint ones, or all sought again, as the evidence says."""
        search = self.inversion.search
        if search.priors.paired:  # of two jaws none changes alone
            sought, odds = self._anew(observations)
            return sought.problems, odds
        hypotheses = [search.judged(same)]
        if p_values(observations, same)[0] < _STRAINED:
            hypotheses.append(_penalised(search.grown(observations, same)))
        kept = same
        # One after the other: a grasp that lets go leaves several at once.
        while self.faint_contacts(kept):
            fewer = search.fewer(observations, kept)
            hypotheses.append(_penalised(fewer))
            kept = fewer.problems.select(fewer.best())
        judged = together(hypotheses)
        best = judged.best()
        changed = judged.problems.select(best), judged.odds[best]
        if p_values(observations, changed[0])[0] >= UNEXPLAINED:
            return changed
        sought, odds = self._anew(observations)
        return min(changed, (sought.problems, odds), key=lambda candidate: candidate[0].misfit[0])

    def _anew(self, observations: Observations) -> tuple[Hypotheses, Float[np.ndarray, "1"]]:
        """Return the best contacts of a frame, sought from scratch, and their odds among all."""
        self.seen_anew += 1
        judged = self.inversion.search.contacts(observations)
        best = judged.best()
        return judged.select(best), judged.odds[best]

    def faint_contacts(self, same: Problems) -> bool:
        number = int(same.number[0])
        if not number:
            return False
        variance = joint_covariance(same, self.inversion.priors)[0].diagonal()
        sigma = np.sqrt(variance[2 : 3 * number : 3])
        # By the deviations of a fresh zero: drift makes a hold less certain, and does not end it.
        return bool(np.any(same.contact[0, :number, 2] < _FAINT * sigma / self._widened))


def _is_due(frames: int) -> bool:
    """Return whether what takes long is tried again: in the second, fourth, eighth, … frame on end."""
    # a power of two has one bit, which the number below it lacks
    return frames > 1 and not frames & (frames - 1)


def _penalised(judged: Hypotheses) -> Hypotheses:
    return Hypotheses(judged.problems, judged.log_evidence + _CHANGE)

"""Most probable contacts of frames, for given faces: Levenberg–Marquardt on many problems at once.

Each problem is a frame with some contacts on given faces. The posterior is Gaussian signals around
the forward model times the priors; its peak, its curvature (Laplace) and with them the evidence of
that number of contacts follow (MacKay, Information Theory, Inference and Learning Algorithms,
2003, chapter 27). The derivatives are those of single presses: what contacts do to each other
changes them by a few percent, which costs steps, not accuracy.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from jaxtyping import Bool, Float, Int

from estimator.inversion.model.arrays import (
    Array,
    chosen,
    diagonals,
    float64,
    library,
    like,
    to_host,
    true_rows,
    zeros,
)
from estimator.inversion.model.forward import NONE, ContactModel
from estimator.inversion.model.whitening import Whitening
from estimator.inversion.priors import Pairs, Priors, Quadratic, held_between
from estimator.inversion.problems import Observations, Problems, identities

_ROUNDS = 3
"""Times, at most, that the interaction of contacts is computed again and the fit goes on."""
_STEPS = 8
"""Levenberg–Marquardt steps of a round, at most."""
_SETTLED = 1e-3
"""Gain that a step promises, in half χ², below which a problem has settled: it is the last, and not tried.

Such a step moves contacts by 0.045 standard deviations of their posterior (½ z² = 0.001).
"""
_LONGEST = np.array([4.0, 4.0, 6.0])
"""Largest step in x (mm), y (mm) and force (N); longer ones are cut, component by component."""
_SAME_SIGMA = 0.02
"""Change of the interaction, over a channel's noise, below which another round is not needed."""
_FIRST_DAMPING = 1e-3
"""Share of the curvature's diagonal that is added first: nearly a Gauss–Newton step."""
_MOST_DAMPING = 1e2
"""Damping at which a problem whose steps gain nothing is given up: steps are then 1 % of Newton's."""


def most_probable(
    model: ContactModel,
    priors: Priors,
    observations: Observations,
    frame: Int[np.ndarray, "problem"],
    face: Int[np.ndarray, "problem contact"],
    contact: Float[np.ndarray, "problem contact 3"],
    extra: Float[np.ndarray, "problem channel"] | None = None,
    rounds: int = _ROUNDS,
    steps: int = _STEPS,
) -> Problems:
    """Return the contacts of the largest posterior near a start; faces stay.

    `extra` is a first guess of the interaction, which each round computes again. The readings'
    device does the work; `extra` and `curvature` stay there.
    """
    slots, used = face.shape[1], used_slots(face)
    fit = _Fit(model, priors, observations, steps)
    frame_at, face_at = like(observations.sigma, frame), like(observations.sigma, face[:, :used])
    at_contact = fit.hold(face_at, like(observations.sigma, contact[:, :used]))
    extra = model.interaction(face_at, at_contact) if extra is None else extra
    start = _Start(frame_at, face_at, at_contact, extra)
    return widened_covariance(fit.problems(start, rounds), slots)


def lowered_misfits(
    model: ContactModel, priors: Priors, observations: Observations, problems: Problems
) -> Float[np.ndarray, "problem"]:
    """Return the misfit of contacts that were fitted with other deviations, after one step.

    Step and gain are those of the quadratic at the contacts: both fits are near.
    """
    used = used_slots(problems.face)
    frame, face, contact, extra = (
        like(observations.sigma, part)
        for part in (
            problems.frame,
            problems.face[:, :used],
            problems.contact[:, :used],
            problems.extra,
        )
    )
    hold = HeldBounds(model, priors, observations.sigma)
    quadratic = _posterior(model, priors, observations, frame, face, extra).expand(contact)
    damping = zeros(contact, (len(contact),)) + _FIRST_DAMPING
    _, promised, _ = _promised_step(face, hold, contact, quadratic, damping)
    # A cut step may promise a loss: it is then not made.
    return to_host(library(contact).minimum(promised.misfit, quadratic.misfit))


def refitted(
    model: ContactModel,
    priors: Priors,
    observations: Observations,
    problems: Problems,
    rounds: int = _ROUNDS,
    steps: int = _STEPS,
) -> Problems:
    """Return `most_probable` from where one round left problems: misfit and slope are known there."""
    slots, used = problems.face.shape[1], used_slots(problems.face)
    parameters = slice(3 * used)
    quadratic = Quadratic(
        like(observations.sigma, problems.misfit),
        problems.slope[:, parameters],
        problems.curvature[:, parameters, parameters],
        like(observations.sigma, problems.log_spread),
    )
    given = problems.frame, problems.face[:, :used], problems.contact[:, :used], problems.extra
    start = _Start(*(like(observations.sigma, part) for part in given), quadratic=quadratic)
    return widened_covariance(
        _Fit(model, priors, observations, steps).problems(start, rounds), slots
    )


@dataclass(frozen=True)
class _Start:
    """Start of a fit: fields of `Problems`, and the misfit there if it is known."""

    frame: Array
    face: Array
    contact: Array
    extra: Array
    quadratic: Quadratic | None = None


@dataclass(frozen=True)
class _Fit:
    """Model, priors and frames of a fit, and its steps in a round."""

    model: ContactModel
    priors: Priors
    observations: Observations
    steps: int

    @cached_property
    def hold(self) -> HeldBounds:
        return HeldBounds(self.model, self.priors, self.observations.sigma)

    def problems(self, start: _Start, rounds: int) -> Problems:
        """The most probable contacts, in the slots of the start."""
        contact, extra, quadratic = self._peak(start, rounds)
        return Problems(
            to_host(start.frame),
            to_host(start.face),
            to_host(contact),
            extra,
            to_host(quadratic.misfit),
            quadratic.slope,
            quadratic.curvature,
            to_host(quadratic.log_spread),
        )

    def _peak(self, start: _Start, rounds: int) -> tuple[Array, Array, Quadratic]:
        """Return contacts, interaction and misfit.

        Problems whose interaction has changed get another round: none depends on the others fitted
        with it.
        """
        given = start.frame, start.face, start.extra
        posterior = _posterior(self.model, self.priors, self.observations, *given)
        quadratic = posterior.expand(start.contact) if start.quadratic is None else start.quadratic
        contact, quadratic = _descend(posterior, self.hold, start.contact, quadratic, self.steps)
        # One contact alone has no interaction.
        several = (start.face != NONE).sum(axis=1) > 1
        if rounds == 1 or not bool(several.any()):
            return contact, start.extra, quadratic
        extra = self.model.interaction(start.face, contact)
        changed = (abs(extra - start.extra) * posterior.white.weight >= _SAME_SIGMA).any(axis=1)
        going = true_rows(changed)
        if not len(going):
            return contact, extra, quadratic
        again = _Start(*(part[going] for part in (start.frame, start.face, contact, extra)))
        later_contact, later_extra, later_at = self._peak(again, rounds - 1)
        if len(going) == len(contact):
            return later_contact, later_extra, later_at
        extra[going] = later_extra
        contact, quadratic = _put((contact, quadratic), going, (later_contact, later_at))
        return contact, extra, quadratic


def used_slots(face: np.ndarray) -> int:
    """Return how many slots hold a contact in some problem, at least one."""
    (used,) = np.nonzero(np.any(face != NONE, axis=0))
    return int(used[-1]) + 1 if len(used) else 1


def widened_covariance(problems: Problems, slots: int) -> Problems:
    """Return the problems with empty contact slots added, so that they have `slots` in all.

    An empty slot has no slope and a curvature of 1: matrices stay invertible, and it never moves.
    """
    some, used = problems.face.shape
    if used == slots:
        return problems
    face, contact = np.full((some, slots), NONE), np.zeros((some, slots, 3))
    face[:, :used], contact[:, :used] = problems.face, problems.contact
    curvature = identities(problems.curvature, some, 3 * slots)
    curvature[:, : 3 * used, : 3 * used] = problems.curvature
    slope = zeros(problems.slope, (some, 3 * slots))
    slope[:, : 3 * used] = problems.slope
    return replace(problems, face=face, contact=contact, slope=slope, curvature=curvature)


class HeldBounds:
    """Keeps contacts where model and priors know them."""

    def __init__(self, model: ContactModel, priors: Priors, reference: Array) -> None:
        self.model = model
        self.lowest, self.highest = (
            like(reference, end) for end in held_between(model.bounds, priors)
        )
        self.longest = like(reference, _LONGEST)

    def __call__(self, face: Array, contact: Array) -> Array:
        xp = library(contact)
        inside = xp.minimum(xp.maximum(contact, self.lowest), self.highest)
        return self.model.select_faces(face, inside)


def _descend(
    posterior: _Posterior, hold: HeldBounds, contact: Array, quadratic: Quadratic, steps: int
) -> tuple[Array, Quadratic]:
    """Return contacts after damped steps with the interaction held, and the misfit there."""
    xp, damping = library(contact), zeros(contact, (len(contact),)) + _FIRST_DAMPING
    all_problems, rows = (
        (contact, quadratic),
        None,
    )  # of all problems; which of them still go on (None: all)
    going = damping > 0
    for _ in range(steps):
        trial, promised, cut = _promised_step(posterior.face, hold, contact, quadratic, damping)
        gain = quadratic.misfit - promised.misfit
        # A cut step is tried whatever it promises: a shorter one may gain where it does not.
        small = ~cut & (gain <= _SETTLED)
        going = going & ~small
        if not going.all():
            # Settled problems take what is promised. They are stored and dropped, so that later
            # steps cost less.
            settled = _chosen_of(small & (gain > 0), (trial, promised), (contact, quadratic))
            all_problems = _put(all_problems, rows, settled)
            going = true_rows(going)
            rows = going if rows is None else rows[going]
            if not len(rows):
                return all_problems
            contact, trial, damping = contact[going], trial[going], damping[going]
            quadratic, posterior = quadratic.select(going), posterior.select(going)
        at_trial = posterior.expand(trial)
        gain = quadratic.misfit - at_trial.misfit
        better = gain > 0
        contact, quadratic = _chosen_of(better, (trial, at_trial), (contact, quadratic))
        # A step that gains is followed by a bolder one; one that does not is undone and shortened.
        damping = damping * xp.where(better, 1 / 8, 8.0)
        going = xp.where(better, gain > _SETTLED, damping < _MOST_DAMPING)
    return _put(all_problems, rows, (contact, quadratic))


def _promised_step(
    face: Array, hold: HeldBounds, contact: Array, quadratic: Quadratic, damping: Array
) -> tuple[Array, Quadratic, Bool[Array, "problem"]]:
    """Return contacts after one damped step, what the quadratic promises there, and which steps are cut."""
    xp, longest = library(contact), hold.longest
    step = damped_step(quadratic.slope, quadratic.curvature, damping).reshape(contact.shape)
    # Linear signals hold near the contact alone: cut long steps. `hold` keeps contacts on faces.
    trial = hold(face, contact + xp.minimum(xp.maximum(step, -longest), longest))
    cut = (trial != contact + step).any(axis=-1).any(axis=-1)
    moved = (trial - contact).reshape(quadratic.slope.shape)
    # Of the step d that is left of it: misfit + gᵀd + ½ dᵀHd, slope g + Hd
    turned = (quadratic.curvature @ moved[..., None])[..., 0]
    misfit = quadratic.misfit + ((quadratic.slope + 0.5 * turned) * moved).sum(axis=1)
    promised = Quadratic(
        misfit, quadratic.slope + turned, quadratic.curvature, quadratic.log_spread
    )
    return trial, promised, cut


_State = tuple[Array, Quadratic]


def _chosen_of(better: Array, new: _State, old: _State) -> _State:
    """Return contacts and their misfits, the new ones where they are better."""
    if better.all():
        return new
    xp = library(better)

    def pick(new_part: Array, old_part: Array) -> Array:
        return xp.where(better.reshape(-1, *[1] * (new_part.ndim - 1)), new_part, old_part)

    (new_contact, new_at), (old_contact, old_at) = new, old
    parts = (pick(*pair) for pair in zip(new_at.parts, old_at.parts, strict=True))
    return pick(new_contact, old_contact), Quadratic(*parts)


def _put(all_problems: _State, rows: Array | None, some: _State) -> _State:
    """Write `some` into the given rows of all problems; None stands for all rows."""
    if rows is None:
        return some
    (contact, quadratic), (some_contact, some_at) = all_problems, some
    for column, part in zip(
        (contact, *quadratic.parts), (some_contact, *some_at.parts), strict=True
    ):
        column[rows] = part
    return all_problems


def damped_step(slope: Array, curvature: Array, damping: Array) -> Array:
    """Return the step −(H + μ diag H)⁻¹ g of each problem (Marquardt, J. SIAM 11, 1963).

    Scaling by the diagonal makes the step independent of units: mm and N stand side by side.
    """
    damped = curvature + 0.0  # a copy: `diagonals` is a view
    diagonal = diagonals(damped)
    diagonal *= 1 + damping[:, None]
    diagonal += 1e-9  # a parameter that no channel sees gets step 0, not a singular matrix
    return -library(slope).linalg.solve(damped, slope[..., None])[..., 0]


@dataclass(frozen=True)
class _Posterior:
    """Problems with all that stays while their contacts move.

    Attributes
    ----------
    white : makes the disturbances of each problem's frame independent and of unit size
    wanted : (problem, channel) counts that the contacts' own signals have to give
    nothing, resting : problems without contacts; their misfit and log spread; None where there is none
    unused : (problem, 3k) 1 where a slot is empty
    """

    model: ContactModel
    face: Int[Array, "problem contact"]
    pairs: Pairs
    white: Whitening
    wanted: Float[Array, "problem channel"]
    unused: Float[Array, "problem parameter"]
    nothing: Bool[Array, "problem"] | None = None
    resting: tuple[Float[Array, "problem"], ...] = ()

    def select(self, rows: Array) -> _Posterior:
        """Those of some problems."""
        return replace(
            self,
            face=self.face[rows],
            pairs=self.pairs.select(rows),
            white=self.white.select(rows),
            wanted=self.wanted[rows],
            unused=self.unused[rows],
            nothing=None if self.nothing is None else self.nothing[rows],
            resting=tuple(part[rows] for part in self.resting),
        )

    def expand(self, contact: Float[Array, "problem contact 3"]) -> Quadratic:
        """Misfit and its derivatives at contacts."""
        # Rows r, J: residual and its derivatives. One product gives ½ rᵀr, the slope Jᵀr and the
        # Gauss–Newton curvature JᵀJ; second derivatives of the model are left out.
        white = self.white(self._residual_rows(contact))
        turned = white.swapaxes(1, 2)
        gram = white @ turned
        quadratic = Quadratic(
            0.5 * gram[:, 0, 0],
            gram[:, 1:, 0],
            gram[:, 1:, 1:],
            zeros(white, (len(white),)),
        )
        if self.model.shear is not None:
            pulls = self.model.pulls(self.face, contact)
            pulls = pulls.reshape(len(pulls), 2 * contact.shape[1], white.shape[2])
            marginalise_tangential_forces(quadratic, turned, self.white(pulls))
        # Frames without contacts have a noise of their own (no error of a model of presses).
        if self.nothing is not None:
            pairs = zip((quadratic.misfit, quadratic.log_spread), self.resting, strict=True)
            for part, resting in pairs:
                part[self.nothing] = resting[self.nothing]
        self.pairs.add(quadratic, contact)
        # 1 on the diagonal of empty slots: the matrix stays invertible, and their step is 0.
        diagonal = diagonals(quadratic.curvature)
        diagonal += self.unused
        return quadratic

    def _residual_rows(self, contact: Array) -> Float[Array, "problem row channel"]:
        """Return residuals (row 0) and their derivatives by x, y, force of each slot, counts."""
        singles = self.model.singles(self.face, contact)
        problems, slots, _, channels = singles.shape
        rows = zeros(self.wanted, (problems, 1 + 3 * slots, channels))
        rows[:, 0] = singles[:, :, 0].sum(axis=1) - self.wanted
        rows[:, 1:] = singles[:, :, 1:].reshape(problems, 3 * slots, channels)
        return rows


def _posterior(
    model: ContactModel,
    priors: Priors,
    observations: Observations,
    frame: Array,
    face: Array,
    extra: Array,
) -> _Posterior:
    nothing = (face == NONE).all(axis=1)
    some = bool(nothing.any())
    return _Posterior(
        model,
        face,
        Pairs(priors, face),
        observations.white.select(frame),
        observations.counts[frame] - extra,
        # (problem, 3 · contact): each slot's flag for x, y and force
        float64(chosen(face == NONE, like(face, np.arange(3 * face.shape[1]) // 3))),
        nothing if some else None,
        observations.resting(frame) if some else (),
    )


def marginalise_tangential_forces(quadratic: Quadratic, turned: Array, pulls: Array) -> None:
    """Integrate tangential forces out of the misfit, in place.

    They are linear in the signals, r + Pᵀ t, and normal a priori, t ~ N(0, 1): so the noise's covariance
    is 1 + PᵀP with P = `pulls`. Its inverse is 1 − Pᵀ (1 + PPᵀ)⁻¹ P (Woodbury), and its determinant
    equals det(1 + PPᵀ) (Sylvester): small matrices, two rows for each contact.
    """
    xp = library(pulls)
    spread = pulls @ pulls.swapaxes(1, 2) + identities(pulls, len(pulls), pulls.shape[1])
    projection = pulls @ turned
    taken = projection.swapaxes(1, 2) @ xp.linalg.solve(spread, projection)
    quadratic.misfit -= 0.5 * taken[:, 0, 0]
    quadratic.slope -= taken[:, 1:, 0]
    quadratic.curvature -= taken[:, 1:, 1:]
    quadratic.log_spread += 0.5 * xp.linalg.slogdet(spread)[1]


def curvature_at(
    model: ContactModel,
    observations: Observations,
    frame: Int[np.ndarray, "problem"],
    face: Int[np.ndarray, "problem contact"],
    contact: Float[np.ndarray, "problem contact 3"],
) -> Float[np.ndarray, "problem parameter parameter"]:
    """Return the Fisher information of contacts, without priors; 1 on the diagonal of empty slots."""
    # Without distances, spreads or jaws `Pairs` adds no term: the curvature is that of signals alone.
    nothing = Priors((1.0,), len(model.signals.faces), 1.0, (0.0, 1.0))
    extra = np.zeros((len(frame), model.channels))
    return _posterior(model, nothing, observations, frame, face, extra).expand(contact).curvature

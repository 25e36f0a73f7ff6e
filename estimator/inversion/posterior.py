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
    on_host,
    where_true,
    zeros,
)
from estimator.inversion.model.columns import Columns
from estimator.inversion.model.forward import NONE, ContactModel
from estimator.inversion.priors import Pairs, Priors, Quadratic, log_density, widths

Bounds = tuple[Float[np.ndarray, "3"], Float[np.ndarray, "3"]]
"""Least and largest x, y (mm) and force (N)."""
_ROUNDS = 3
_STEPS = 8
_SETTLED = 1e-3
"""Of half χ²: no step that gains less is worth taking."""
_LONGEST = np.array([4.0, 4.0, 6.0])
"""Of one step, mm, mm and N."""
_AT_BOUND = 1e-6
"""In mm and N: a contact nearer is held there."""
_SAME_SIGMA = 0.02
"""Of the noise: an interaction that changes by less is the same."""


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
        """How many contacts."""
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


def most_probable(
    model: ContactModel,
    priors: Priors,
    seen: Observed,
    frame: Int[np.ndarray, "problem"],
    face: Int[np.ndarray, "problem contact"],
    contact: Float[np.ndarray, "problem contact 3"],
    extra: Float[np.ndarray, "problem channel"] | None = None,
    rounds: int = _ROUNDS,
    steps: int = _STEPS,
) -> Problems:
    """Contacts of the largest posterior near a start; faces stay.

    `extra` is a first guess of the interaction, which each of the rounds works out anew. What is
    seen decides on which device the work is done; `extra` and `curvature` stay there.
    """
    slots, used = face.shape[1], _used_slots(face)
    frame_at, face_at = like(seen.sigma, frame), like(seen.sigma, face[:, :used])
    hold = _Hold(model, priors, seen.sigma)
    at_contact = hold(face_at, like(seen.sigma, contact[:, :used]))
    extra = model.interaction(face_at, at_contact) if extra is None else extra
    start = _Start(frame_at, face_at, at_contact, extra)
    return _widened(_fitted(model, priors, seen, start, hold, rounds, steps), slots)


def refitted(
    model: ContactModel,
    priors: Priors,
    seen: Observed,
    problems: Problems,
    rounds: int = _ROUNDS,
    steps: int = _STEPS,
) -> Problems:
    """`most_probable` from where one round left problems: misfit and slope are known there."""
    slots, used = problems.face.shape[1], _used_slots(problems.face)
    parameters = slice(3 * used)
    at = Quadratic(
        like(seen.sigma, problems.misfit),
        problems.slope[:, parameters],
        problems.curvature[:, parameters, parameters],
        like(seen.sigma, problems.log_spread),
    )
    given = problems.frame, problems.face[:, :used], problems.contact[:, :used], problems.extra
    start = _Start(*(like(seen.sigma, part) for part in given), at=at)
    hold = _Hold(model, priors, seen.sigma)
    return _widened(_fitted(model, priors, seen, start, hold, rounds, steps), slots)


@dataclass(frozen=True)
class _Start:
    """Where a fit begins: as of `Problems`, and the misfit there if it is known."""

    frame: Array
    face: Array
    contact: Array
    extra: Array
    at: Quadratic | None = None


def _fitted(
    model: ContactModel,
    priors: Priors,
    seen: Observed,
    start: _Start,
    hold: _Hold,
    rounds: int,
    steps: int,
) -> Problems:
    contact, extra, at = _peak(model, priors, seen, start, hold, rounds, steps)
    return Problems(
        on_host(start.frame),
        on_host(start.face),
        on_host(contact),
        extra,
        on_host(at.misfit),
        at.slope,
        at.curvature,
        on_host(at.log_spread),
    )


def _peak(
    model: ContactModel,
    priors: Priors,
    seen: Observed,
    start: _Start,
    hold: _Hold,
    rounds: int,
    steps: int,
) -> tuple[Array, Array, Quadratic]:
    """Contacts, interaction and misfit; another round for problems whose interaction has changed, so that
    none depends on which others are fitted beside it."""
    posterior = _posterior(model, priors, seen, start.frame, start.face, start.extra)
    at = posterior.at(start.contact) if start.at is None else start.at
    contact, at = _descend(posterior, hold, start.contact, at, steps)
    several = (start.face != NONE).sum(axis=1) > 1
    if rounds == 1 or not bool(several.any()):
        return contact, start.extra, at
    extra = model.interaction(start.face, contact)
    changed = (abs(extra - start.extra) * posterior.weight >= _SAME_SIGMA).any(axis=1)
    going = where_true(changed)
    if not len(going):
        return contact, extra, at
    again = _Start(*(part[going] for part in (start.frame, start.face, contact, extra)))
    found = _peak(model, priors, seen, again, hold, rounds - 1, steps)
    if len(going) == len(contact):
        return found
    extra[going] = found[1]
    contact, at = _put((contact, at), going, (found[0], found[2]))
    return contact, extra, at


def _used_slots(face: np.ndarray) -> int:
    (used,) = np.nonzero(np.any(face != NONE, axis=0))
    return int(used[-1]) + 1 if len(used) else 1


def _widened(problems: Problems, slots: int) -> Problems:
    """Empty contact slots added."""
    some, used = problems.face.shape
    if used == slots:
        return problems
    face, contact = np.full((some, slots), NONE), np.zeros((some, slots, 3))
    face[:, :used], contact[:, :used] = problems.face, problems.contact
    curvature = _identities(problems.curvature, some, 3 * slots)
    curvature[:, : 3 * used, : 3 * used] = problems.curvature
    slope = zeros(problems.slope, (some, 3 * slots))
    slope[:, : 3 * used] = problems.slope
    return replace(problems, face=face, contact=contact, slope=slope, curvature=curvature)


def _identities(reference: Array, many: int, size: int) -> Float[Array, "many size size"]:
    found = zeros(reference, (many, size, size))
    diagonals(found)[:] = 1.0
    return found


class _Hold:
    """Keeps contacts where model and priors know them."""

    def __init__(self, model: ContactModel, priors: Priors, reference: Array) -> None:
        self.model = model
        self.lowest, self.highest = (
            like(reference, end) for end in held_between(model.bounds, priors)
        )

    def __call__(self, face: Array, contact: Array) -> Array:
        xp = library(contact)
        inside = xp.minimum(xp.maximum(contact, self.lowest), self.highest)
        return self.model.on_faces(face, inside)


def held_between(bounds: Bounds, priors: Priors) -> Bounds:
    """What bounds of a model leave of the priors, or these of them."""
    (low, high), (least, most) = bounds, priors.force_n
    return np.array([*low[:2], least]), np.array([*high[:2], min(most, high[2])])


def _descend(
    posterior: _Posterior, hold: _Hold, contact: Array, at: Quadratic, steps: int
) -> tuple[Array, Quadratic]:
    """Steps with the interaction held; rows that have settled are left alone."""
    xp = library(contact)
    longest = like(contact, np.tile(_LONGEST, contact.shape[1]))
    damping = zeros(contact, (len(contact),)) + 1e-3
    every, rows = (contact, at), None
    for _ in range(steps):
        step = _step(at.slope, at.curvature, damping)
        step = xp.minimum(xp.maximum(step, -longest), longest).reshape(contact.shape)
        trial = hold(posterior.face, contact + step)
        there = posterior.at(trial)
        gain = at.misfit - there.misfit
        better = gain > 0
        contact, at = _chosen_of(better, (trial, there), (contact, at))
        damping = damping * xp.where(better, 1 / 8, 8.0)
        going = xp.where(better, gain > _SETTLED, damping < 1e2)
        if going.all():
            continue
        every = _put(every, rows, (contact, at))
        going = where_true(going)
        rows = going if rows is None else rows[going]
        if not len(rows):
            return every
        contact, at, damping = contact[going], at.select(going), damping[going]
        posterior = posterior.select(going)
    return _put(every, rows, (contact, at))


_State = tuple[Array, Quadratic]


def _chosen_of(better: Array, new: _State, old: _State) -> _State:
    """Contacts and their misfits, the new ones where they are better."""
    if better.all():
        return new
    xp = library(better)

    def pick(one: Array, other: Array) -> Array:
        return xp.where(better.reshape(-1, *[1] * (one.ndim - 1)), one, other)

    (contact, there), (before, at) = new, old
    parts = (pick(*pair) for pair in zip(there.parts, at.parts, strict=True))
    return pick(contact, before), Quadratic(*parts)


def _put(every: _State, rows: Array | None, some: _State) -> _State:
    """`some` in the given rows of all problems."""
    if rows is None:
        return some
    (contact, at), (there, found) = every, some
    for column, part in zip((contact, *at.parts), (there, *found.parts), strict=True):
        column[rows] = part
    return every


def _step(slope: Array, curvature: Array, damping: Array) -> Array:
    damped = curvature + 0.0
    diagonal = diagonals(damped)
    diagonal *= 1 + damping[:, None]
    diagonal += 1e-9
    return -library(slope).linalg.solve(damped, slope[..., None])[..., 0]


@dataclass(frozen=True)
class _Posterior:
    """Problems with all that stays while their contacts move.

    Attributes
    ----------
    weight : (problem, channel) one over the standard deviations
    wanted : (problem, channel) counts that the contacts' own signals have to give, weighed
    nothing, resting : problems without contacts; their misfit and log spread; None where there is none
    unused : (problem, 3k) 1 where a slot is empty
    """

    model: ContactModel
    face: Int[Array, "problem contact"]
    pairs: Pairs
    weight: Float[Array, "problem channel"]
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
            weight=self.weight[rows],
            wanted=self.wanted[rows],
            unused=self.unused[rows],
            nothing=None if self.nothing is None else self.nothing[rows],
            resting=tuple(part[rows] for part in self.resting),
        )

    def at(self, contact: Float[Array, "problem contact 3"]) -> Quadratic:
        """Misfit and its derivatives at contacts."""
        white = self._white(contact)
        turned = white.swapaxes(1, 2)
        gram = white @ turned
        found = Quadratic(
            0.5 * gram[:, 0, 0],
            gram[:, 1:, 0],
            gram[:, 1:, 1:],
            zeros(white, (len(white),)),
        )
        if self.model.shear is not None:
            pulls = self.model.pulls(self.face, contact) * self.weight[:, None, None]
            _loosen(found, turned, pulls.reshape(len(pulls), 2 * contact.shape[1], white.shape[2]))
        if self.nothing is not None:
            for part, resting in zip((found.misfit, found.log_spread), self.resting, strict=True):
                part[self.nothing] = resting[self.nothing]
        self.pairs.add(found, contact)
        diagonal = diagonals(found.curvature)
        diagonal += self.unused
        return found

    def _white(self, contact: Array) -> Float[Array, "problem row channel"]:
        """What is left, and its derivatives, in standard deviations."""
        singles = self.model.singles(self.face, contact) * self.weight[:, None, None]
        problems, slots, _, channels = singles.shape
        white = zeros(singles, (problems, 1 + 3 * slots, channels))
        white[:, 0] = singles[:, :, 0].sum(axis=1) - self.wanted
        white[:, 1:] = singles[:, :, 1:].reshape(problems, 3 * slots, channels)
        return white


def _posterior(
    model: ContactModel, priors: Priors, seen: Observed, frame: Array, face: Array, extra: Array
) -> _Posterior:
    weight = 1 / seen.sigma[frame]
    nothing = (face == NONE).all(axis=1)
    some = bool(nothing.any())
    return _Posterior(
        model,
        face,
        Pairs(priors, face),
        weight,
        (seen.counts[frame] - extra) * weight,
        float64(chosen(face == NONE, like(face, np.arange(3 * face.shape[1]) // 3))),
        nothing if some else None,
        seen.resting(frame) if some else (),
    )


def _loosen(found: Quadratic, turned: Array, pulls: Array) -> None:
    """Tangential forces integrated out: linear in the signals, normal a priori, they widen the noise
    along `pulls` (Woodbury's identity)."""
    xp = library(pulls)
    spread = pulls @ pulls.swapaxes(1, 2) + _identities(pulls, len(pulls), pulls.shape[1])
    along = pulls @ turned
    taken = along.swapaxes(1, 2) @ xp.linalg.solve(spread, along)
    found.misfit -= 0.5 * taken[:, 0, 0]
    found.slope -= taken[:, 1:, 0]
    found.curvature -= taken[:, 1:, 1:]
    found.log_spread += 0.5 * xp.linalg.slogdet(spread)[1]


def curvature_at(
    model: ContactModel,
    seen: Observed,
    frame: Int[np.ndarray, "problem"],
    face: Int[np.ndarray, "problem contact"],
    contact: Float[np.ndarray, "problem contact 3"],
) -> Float[np.ndarray, "problem parameter parameter"]:
    """Fisher information of contacts, without priors; ones on the diagonal of empty slots."""
    nothing = Priors((1.0,), len(model.signals.faces), 1.0, (0.0, 1.0))
    extra = np.zeros((len(frame), model.channels))
    return _posterior(model, nothing, seen, frame, face, extra).at(contact).curvature


def log_evidence(problems: Problems, priors: Priors) -> Float[np.ndarray, "problem"]:
    """Log of the posterior mass about each peak, priors included, but for the frame's constant."""
    curvature = bounded_curvature(problems, priors)
    log_volume = on_host(library(curvature).linalg.slogdet(curvature)[1])
    mass = 0.5 * (3 * problems.number * np.log(2 * np.pi) - log_volume)
    return (
        mass
        - problems.misfit
        - problems.log_spread
        + log_density(priors, problems.face, problems.contact)
    )


def log_inside(bounds: Bounds, priors: Priors, problems: Problems) -> Float[np.ndarray, "problem"]:
    """Log of the share of each peak's mass within the bounds of the model and the priors, axis by axis.

    A contact that is held at a bound would lie beyond it: where the top of a normal peak is d standard
    deviations outside, the mass inside is exp(d²/2) Φ(−d) of what Laplace's approximation makes of the
    height at the bound.
    """
    from scipy.special import log_ndtr

    curvature = bounded_curvature(problems, priors)
    shape = problems.contact.shape
    variance = diagonals(library(curvature).linalg.inv(curvature))
    sigma = np.sqrt(on_host(variance)).reshape(shape)
    slope = on_host(problems.slope).reshape(shape) * sigma
    low, high = held_between(bounds, priors)
    mass = np.zeros(shape)
    for room, out in ((problems.contact - low, slope), (high - problems.contact, -slope)):
        beyond = np.where(room < _AT_BOUND, np.maximum(out, 0.0), 0.0)
        mass += log_ndtr(room / sigma - beyond) + 0.5 * beyond * beyond
    return np.where((problems.face != NONE)[..., None], mass, 0.0).sum(axis=(1, 2))


def covariances(problems: Problems, priors: Priors) -> Float[np.ndarray, "problem contact 3 3"]:
    """Of x, y (mm) and force (N) of each contact, with the uncertainty of the others; no wider than
    the priors. Of empty slots the identity."""
    slots = problems.face.shape[1]
    every = np.linalg.inv(bounded_curvature(problems, priors)).reshape(-1, slots, 3, slots, 3)
    return np.moveaxis(np.diagonal(every, axis1=1, axis2=3), -1, 1)


def bounded_curvature(
    problems: Problems, priors: Priors
) -> Float[Array, "problem parameter parameter"]:
    """With that of normal priors as wide as the even ones: it has an inverse."""
    flat = (problems.face != NONE)[..., None] * (12 / np.square(widths(priors)))
    found = problems.curvature + 0.0
    diagonal = diagonals(found)
    diagonal += like(found, flat.reshape(diagonal.shape))
    return found


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
        _identities(seen.counts, problems, 3 * slots),
        on_host(log_spread),
    )


def strict_misfit(
    model: ContactModel, priors: Priors, seen: Observed, problems: Problems
) -> Float[np.ndarray, "problem"]:
    """Misfit of problems around the strict deviations instead of the true ones."""
    strict = replace(seen, sigma=seen.strict)
    given = problems.frame, problems.face, problems.extra
    return _posterior(model, priors, strict, *given).at(problems.contact).misfit

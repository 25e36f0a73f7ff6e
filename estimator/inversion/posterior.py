"""Most probable contacts of frames, for given faces: Levenberg–Marquardt on many problems at once.

Each problem is a frame with some contacts on given faces. The posterior is Gaussian signals around
the forward model times the priors; its peak, its curvature (Laplace) and with them the evidence of
that number of contacts follow (MacKay, Information Theory, Inference and Learning Algorithms,
2003, chapter 27). The derivatives are those of single presses: what contacts do to each other
changes them by a few percent, which costs steps, not accuracy.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np
from jaxtyping import Bool, Float, Int

from estimator.inversion.forward import NONE, ContactModel

_ROUNDS = 3
_STEPS = 8
_SETTLED = 1e-3
"""Of half χ²: no step that gains less is worth taking."""
_LONGEST = np.array([4.0, 4.0, 6.0])
"""Of one step, mm, mm and N."""
_SAME_SIGMA = 0.02
"""Of the noise: an interaction that changes by less is the same."""
_OVERLAP_MM, SPACING_SIGMA_MM = 0.5, 0.2
"""Standard deviations of how far tips may seem to overlap, and of distances within a known probe."""


@dataclass(frozen=True)
class Priors:
    """What is believed of contacts before a frame is seen.

    Attributes
    ----------
    number : probabilities of 0, 1, 2, … contacts
    faces, area_mm2 : number and whole area of the sensed faces; contacts are equally likely
        everywhere on them
    force_n : least and largest, forces between are equally likely
    apart_mm : least distance of two contacts on a face (twice the tip's radius); 0 for none
    force_spread : relative standard deviation of the forces of a face's contacts, where they are
        tips of one probe that bear alike; None where nothing is known of that
    spacing_mm : of probes, where they are known: distance between the tips of the probe of two, of
        three, … of which a face meets one; empty where contacts are free
    """

    number: tuple[float, ...]
    faces: int
    area_mm2: float
    force_n: tuple[float, float]
    apart_mm: float = 0.0
    force_spread: float | None = None
    spacing_mm: tuple[float, ...] = ()

    @property
    def free(self) -> Priors:
        """Without what is known of probes."""
        return replace(self, force_spread=None, spacing_mm=())

    @property
    def most(self) -> int:
        """Largest number of contacts."""
        return len(self.number) - 1


@dataclass(frozen=True)
class Problems:
    """Contacts on given faces in frames, and how well they explain them.

    Attributes
    ----------
    frame : (problem,) row of the frame
    face, contact : as in `ContactModel`
    extra : (problem, channel) interaction of the contacts, counts
    misfit : (problem,) half χ² of signals and priors
    curvature : (problem, 3k, 3k) of the misfit, empty slots as ones on the diagonal
    """

    frame: Int[np.ndarray, "problem"]
    face: Int[np.ndarray, "problem contact"]
    contact: Float[np.ndarray, "problem contact 3"]
    extra: Float[np.ndarray, "problem channel"]
    misfit: Float[np.ndarray, "problem"]
    curvature: Float[np.ndarray, "problem parameter parameter"]

    def __len__(self) -> int:
        return len(self.frame)

    @property
    def number(self) -> Int[np.ndarray, "problem"]:
        """How many contacts."""
        return np.sum(self.face != NONE, axis=1)

    def select(self, rows: Int[np.ndarray, "n"] | Bool[np.ndarray, "problem"]) -> Problems:
        """Some of the problems."""
        return Problems(*(getattr(self, name)[rows] for name in Problems.__dataclass_fields__))


@dataclass(frozen=True)
class Observed:
    """Frames to be explained: changes of counts and their standard deviations."""

    counts: Float[np.ndarray, "frame channel"]
    sigma: Float[np.ndarray, "frame channel"]


@dataclass
class _Linear:
    """Misfit, its slope and curvature at the contacts of some problems."""

    misfit: np.ndarray
    slope: np.ndarray
    curvature: np.ndarray


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

    `extra` is a first guess of the interaction, which each of the rounds works out anew.
    """
    slots, used = face.shape[1], _used_slots(face)
    face, contact = face[:, :used], _held(model, priors, contact[:, :used])
    extra = model.interaction(face, contact) if extra is None else extra
    for number in range(rounds):
        contact, at = _descend(model, priors, seen, frame, face, contact, extra, steps)
        if number == rounds - 1 or not np.any((face != NONE).sum(axis=1) > 1):
            break
        before, extra = extra, model.interaction(face, contact)
        if np.max(np.abs(extra - before) / seen.sigma[frame], initial=0.0) < _SAME_SIGMA:
            break
    return _widened(Problems(frame, face, contact, extra, at.misfit, at.curvature), slots)


def _used_slots(face: np.ndarray) -> int:
    (used,) = np.nonzero(np.any(face != NONE, axis=0))
    return int(used[-1]) + 1 if len(used) else 1


def _widened(problems: Problems, slots: int) -> Problems:
    """Empty contact slots added."""
    used = problems.face.shape[1]
    more = slots - used
    if not more:
        return problems
    curvature = np.broadcast_to(np.eye(3 * slots), (len(problems), 3 * slots, 3 * slots)).copy()
    curvature[:, : 3 * used, : 3 * used] = problems.curvature
    return replace(
        problems,
        face=np.pad(problems.face, ((0, 0), (0, more)), constant_values=NONE),
        contact=np.pad(problems.contact, ((0, 0), (0, more), (0, 0))),
        curvature=curvature,
    )


def _held(model: ContactModel, priors: Priors, contact: np.ndarray) -> np.ndarray:
    (low, high), (least, most) = model.bounds, priors.force_n
    return np.clip(contact, [*low[:2], least], [*high[:2], min(most, high[2])])


def _descend(
    model: ContactModel,
    priors: Priors,
    seen: Observed,
    frame: np.ndarray,
    face: np.ndarray,
    contact: np.ndarray,
    extra: np.ndarray,
    steps: int,
) -> tuple[np.ndarray, _Linear]:
    """Steps with the interaction held; rows that have settled are left alone."""
    at = _linear(model, priors, seen, frame, face, contact, extra)
    contact, damping = contact.copy(), np.full(len(frame), 1e-3)
    active = np.arange(len(frame))
    for _ in range(steps):
        if not len(active):
            break
        step = _step(at.slope[active], at.curvature[active], damping[active])
        trial = contact[active] + np.clip(step.reshape(-1, *contact.shape[1:]), -_LONGEST, _LONGEST)
        trial = _held(model, priors, trial)
        there = _linear(model, priors, seen, frame[active], face[active], trial, extra[active])
        gain = at.misfit[active] - there.misfit
        better = gain > 0
        rows = active[better]
        contact[rows] = trial[better]
        for name in ("misfit", "slope", "curvature"):
            getattr(at, name)[rows] = getattr(there, name)[better]
        damping[active] = np.where(better, damping[active] / 8, damping[active] * 8)
        going = np.where(better, gain > _SETTLED, damping[active] < 1e2)
        active = active[going]
    return contact, at


def _step(slope: np.ndarray, curvature: np.ndarray, damping: np.ndarray) -> np.ndarray:
    size = np.diagonal(curvature, axis1=1, axis2=2)
    damped = curvature + (damping[:, None] * size + 1e-9)[:, :, None] * np.eye(size.shape[1])
    return -np.linalg.solve(damped, slope[..., None])[..., 0]


def _linear(
    model: ContactModel,
    priors: Priors,
    seen: Observed,
    frame: np.ndarray,
    face: np.ndarray,
    contact: np.ndarray,
    extra: np.ndarray,
) -> _Linear:
    problems, slots = face.shape
    singles = model.singles(face, contact)
    sigma = seen.sigma[frame]
    left = (singles[:, :, 0].sum(axis=1) + extra - seen.counts[frame]) / sigma
    jacobian = singles[:, :, 1:].reshape(problems, 3 * slots, model.channels) / sigma[:, None]
    slope = (jacobian @ left[..., None])[..., 0]
    curvature = jacobian @ jacobian.transpose(0, 2, 1)
    found = _Linear(0.5 * np.sum(left**2, axis=1), slope, curvature)
    _add_priors(found, priors, face, contact)
    rows = np.repeat(face == NONE, 3, axis=1)
    diagonal = np.arange(3 * slots)
    found.curvature[:, diagonal, diagonal] += rows
    return found


def _add_priors(found: _Linear, priors: Priors, face: np.ndarray, contact: np.ndarray) -> None:
    """Tips that do not overlap, stand as their probe has them, and bear alike where they are known to."""
    alike = np.sum(face[:, :, None] == face[:, None, :], axis=2)
    for a, b in combinations(range(face.shape[1]), 2):
        both = (face[:, a] == face[:, b]) & (face[:, a] != NONE)
        if not both.any():
            continue
        pair = _Pair(found, contact, a, b, alike[:, a])
        if priors.spacing_mm:
            pair.stand(np.flatnonzero(both), priors.spacing_mm)
        elif priors.apart_mm:
            pair.keep_apart(np.flatnonzero(both), priors.apart_mm)
        if priors.force_spread is not None:
            pair.bear_alike(np.flatnonzero(both), priors.force_spread)


@dataclass(frozen=True)
class _Pair:
    """Contacts `a` and `b` of all problems; `alike` counts those of their face."""

    found: _Linear
    contact: np.ndarray
    a: int
    b: int
    alike: np.ndarray

    def keep_apart(self, rows: np.ndarray, apart_mm: float) -> None:
        distance = self._between(rows)[1]
        self._hold(rows[distance < apart_mm], apart_mm, _OVERLAP_MM)

    def stand(self, rows: np.ndarray, spacing_mm: tuple[float, ...]) -> None:
        wanted = np.array([0.0, 0.0, *spacing_mm])
        known = self.alike[rows] < len(wanted)
        self._hold(rows[known], wanted[self.alike[rows[known]]], SPACING_SIGMA_MM)

    def bear_alike(self, rows: np.ndarray, spread: float) -> None:
        first, second = self.contact[rows, self.a, 2], self.contact[rows, self.b, 2]
        scale = 1 / (spread * np.sqrt(self.alike[rows]))
        row = np.zeros((len(rows), self.found.slope.shape[1]))
        row[:, 3 * self.a + 2], row[:, 3 * self.b + 2] = scale / first, -scale / second
        _add_row(self.found, rows, scale * np.log(first / second), row)

    def _between(self, rows: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        between = self.contact[rows, self.a, :2] - self.contact[rows, self.b, :2]
        return between, np.maximum(np.linalg.norm(between, axis=1), 1e-6)

    def _hold(self, rows: np.ndarray, wanted_mm: np.ndarray | float, sigma_mm: float) -> None:
        between, distance = self._between(rows)
        unit = between / distance[:, None] / sigma_mm
        row = np.zeros((len(rows), self.found.slope.shape[1]))
        row[:, 3 * self.a : 3 * self.a + 2], row[:, 3 * self.b : 3 * self.b + 2] = unit, -unit
        _add_row(self.found, rows, (distance - wanted_mm) / sigma_mm, row)


def _add_row(found: _Linear, rows: np.ndarray, left: np.ndarray, row: np.ndarray) -> None:
    found.misfit[rows] += 0.5 * left**2
    found.slope[rows] += left[:, None] * row
    found.curvature[rows] += row[:, :, None] * row[:, None, :]


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
    return _linear(model, nothing, seen, frame, face, contact, extra).curvature


def log_evidence(problems: Problems, priors: Priors) -> Float[np.ndarray, "problem"]:
    """Log of the posterior mass about each peak, priors included, but for the frame's constant."""
    number = problems.number
    filled = np.repeat(problems.face != NONE, 3, axis=1)
    flat = np.tile(12 / np.square(_widths(priors)), problems.face.shape[1])
    bounded = problems.curvature + (filled * flat)[:, :, None] * np.eye(len(flat))
    _, log_volume = np.linalg.slogdet(bounded)
    parameters = 3 * number
    density = -np.log(priors.area_mm2 * np.ptp(priors.force_n))
    counted = np.log(np.maximum(np.asarray(priors.number), 1e-300))[number]
    orders = np.array([np.sum(np.log(np.arange(1, n + 1))) for n in range(priors.most + 1)])
    mass = 0.5 * (parameters * np.log(2 * np.pi) - log_volume)
    free = -problems.misfit + mass + number * density + counted + orders[number]
    return free + _probe_density(problems, priors)


def _probe_density(problems: Problems, priors: Priors) -> Float[np.ndarray, "problem"]:
    """Log of how much denser the prior is where probes and equal forces are known.

    Of a face's n contacts one stands anywhere; the second then stands on a ring, the third at one
    of two points. Forces but one follow the first.
    """
    gained = np.zeros(len(problems))
    for face in range(priors.faces):
        here = problems.face == face
        number = here.sum(axis=1)
        more = np.maximum(number - 1, 0)
        if priors.force_spread is not None:
            force = np.where(here, problems.contact[..., 2], 0.0).sum(axis=1)
            width = _ROOT * priors.force_spread * np.maximum(force, 1e-9) / np.maximum(number, 1)
            gained += np.where(more > 0, more * np.log(np.ptp(priors.force_n) / width), 0.0)
        if priors.spacing_mm:
            gained += _standing(priors)[np.minimum(number, len(priors.spacing_mm) + 2)]
    return gained


_ROOT = np.sqrt(2 * np.pi)


def _standing(priors: Priors) -> Float[np.ndarray, "number"]:
    """Log density of the places of n tips of a known probe over that of n contacts anywhere."""
    ring = 2 * np.pi * np.asarray(priors.spacing_mm) * _ROOT * SPACING_SIGMA_MM
    point = 2 * (_ROOT * SPACING_SIGMA_MM) ** 2
    extra = np.arange(len(priors.spacing_mm))
    gained = np.log(priors.area_mm2 / ring) + extra * np.log(priors.area_mm2 / point)
    return np.concatenate([[0.0, 0.0], gained, [-np.inf]])


def _widths(priors: Priors) -> Float[np.ndarray, "3"]:
    """Of the priors of x, y and force on one face: no posterior is wider."""
    side = np.sqrt(priors.area_mm2 / priors.faces)
    return np.array([side, side, np.ptp(priors.force_n)])


def empty(seen: Observed, frame: Int[np.ndarray, "problem"], slots: int) -> Problems:
    """Frames explained by nothing."""
    problems = len(frame)
    return Problems(
        frame,
        np.full((problems, slots), NONE),
        np.zeros((problems, slots, 3)),
        np.zeros((problems, seen.counts.shape[1])),
        0.5 * np.sum((seen.counts[frame] / seen.sigma[frame]) ** 2, axis=1),
        np.broadcast_to(np.eye(3 * slots), (problems, 3 * slots, 3 * slots)).copy(),
    )


def joined(parts: Sequence[Problems]) -> Problems:
    """Problems one after the other."""
    return Problems(
        *(
            np.concatenate([getattr(part, name) for part in parts])
            for name in Problems.__dataclass_fields__
        )
    )

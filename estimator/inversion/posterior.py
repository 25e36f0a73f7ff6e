"""Most probable contacts of frames, for given faces: Levenberg–Marquardt on many problems at once.

Each problem is a frame with some contacts on given faces. The posterior is Gaussian signals around
the forward model times the priors; its peak, its curvature (Laplace) and with them the evidence of
that number of contacts follow (MacKay, Information Theory, Inference and Learning Algorithms,
2003, chapter 27). The derivatives are those of single presses: what contacts do to each other
changes them by a few percent, which costs steps, not accuracy.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Float, Int

from estimator.inversion.model.columns import Columns
from estimator.inversion.model.forward import NONE, ContactModel
from estimator.inversion.priors import Priors, Quadratic, add_priors, log_density, widths

_ROUNDS = 3
_STEPS = 8
_SETTLED = 1e-3
"""Of half χ²: no step that gains less is worth taking."""
_LONGEST = np.array([4.0, 4.0, 6.0])
"""Of one step, mm, mm and N."""
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
    curvature : (problem, 3k, 3k) of the misfit, empty slots as ones on the diagonal
    log_spread : (problem,) half the log determinant of the covariance of the signals over that of the
        noise: tangential forces widen it; of no contact below 0, as it has no error of the model
    """

    frame: Int[np.ndarray, "problem"]
    face: Int[np.ndarray, "problem contact"]
    contact: Float[np.ndarray, "problem contact 3"]
    extra: Float[np.ndarray, "problem channel"]
    misfit: Float[np.ndarray, "problem"]
    curvature: Float[np.ndarray, "problem parameter parameter"]
    log_spread: Float[np.ndarray, "problem"]

    @property
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

    counts: Float[np.ndarray, "frame channel"]
    sigma: Float[np.ndarray, "frame channel"]
    still: Float[np.ndarray, "frame channel"]
    strict: Float[np.ndarray, "frame channel"]

    def resting(
        self, frame: Int[np.ndarray, "problem"]
    ) -> tuple[Float[np.ndarray, "problem"], Float[np.ndarray, "problem"]]:
        """Misfit and log spread of frames in which nothing is pressed."""
        still = self.still[frame]
        misfit = 0.5 * np.sum((self.counts[frame] / still) ** 2, axis=1)
        return misfit, np.sum(np.log(still / self.sigma[frame]), axis=1)


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
    face, contact = face[:, :used], _held(model, priors, face[:, :used], contact[:, :used])
    extra = model.interaction(face, contact) if extra is None else extra
    for number in range(rounds):
        contact, at = _descend(model, priors, seen, frame, face, contact, extra, steps)
        if number == rounds - 1 or not np.any((face != NONE).sum(axis=1) > 1):
            break
        before, extra = extra, model.interaction(face, contact)
        if np.max(np.abs(extra - before) / seen.sigma[frame], initial=0.0) < _SAME_SIGMA:
            break
    found = Problems(frame, face, contact, extra, at.misfit, at.curvature, at.log_spread)
    return _widened(found, slots)


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


def _held(model: ContactModel, priors: Priors, face: np.ndarray, contact: np.ndarray) -> np.ndarray:
    (low, high), (least, most) = model.bounds, priors.force_n
    lowest, highest = [*low[:2], least], [*high[:2], min(most, high[2])]
    return model.on_faces(face, np.minimum(np.maximum(contact, lowest), highest))


def _descend(
    model: ContactModel,
    priors: Priors,
    seen: Observed,
    frame: np.ndarray,
    face: np.ndarray,
    contact: np.ndarray,
    extra: np.ndarray,
    steps: int,
) -> tuple[np.ndarray, Quadratic]:
    """Steps with the interaction held; rows that have settled are left alone."""
    at = _linear(model, priors, seen, frame, face, contact, extra)
    contact, damping = contact.copy(), np.full(len(frame), 1e-3)
    active = np.arange(len(frame))
    for _ in range(steps):
        if not len(active):
            break
        step = _step(at.slope[active], at.curvature[active], damping[active])
        step = np.minimum(np.maximum(step.reshape(-1, *contact.shape[1:]), -_LONGEST), _LONGEST)
        trial = _held(model, priors, face[active], contact[active] + step)
        there = _linear(model, priors, seen, frame[active], face[active], trial, extra[active])
        gain = at.misfit[active] - there.misfit
        better = gain > 0
        rows = active[better]
        contact[rows] = trial[better]
        for name in ("misfit", "slope", "curvature", "log_spread"):
            getattr(at, name)[rows] = getattr(there, name)[better]
        damping[active] = np.where(better, damping[active] / 8, damping[active] * 8)
        going = np.where(better, gain > _SETTLED, damping[active] < 1e2)
        active = active[going]
    return contact, at


def _step(slope: np.ndarray, curvature: np.ndarray, damping: np.ndarray) -> np.ndarray:
    damped, diagonal = curvature.copy(), np.arange(curvature.shape[1])
    damped[:, diagonal, diagonal] += damping[:, None] * damped[:, diagonal, diagonal] + 1e-9
    return -np.linalg.solve(damped, slope[..., None])[..., 0]


def _linear(
    model: ContactModel,
    priors: Priors,
    seen: Observed,
    frame: np.ndarray,
    face: np.ndarray,
    contact: np.ndarray,
    extra: np.ndarray,
) -> Quadratic:
    problems, slots = face.shape
    singles = model.singles(face, contact)
    sigma = seen.sigma[frame]
    left = (singles[:, :, 0].sum(axis=1) + extra - seen.counts[frame]) / sigma
    jacobian = singles[:, :, 1:].reshape(problems, 3 * slots, model.channels) / sigma[:, None]
    slope = (jacobian @ left[..., None])[..., 0]
    curvature = jacobian @ jacobian.transpose(0, 2, 1)
    found = Quadratic(0.5 * np.sum(left**2, axis=1), slope, curvature, np.zeros(problems))
    if model.shear is not None:
        pulls = model.pulls(face, contact).reshape(problems, 2 * slots, model.channels)
        pulls = pulls / sigma[:, None]
        _loosen(found, left, jacobian, pulls)
    nothing = np.all(face == NONE, axis=1)
    if nothing.any():
        found.misfit[nothing], found.log_spread[nothing] = seen.resting(frame[nothing])
    add_priors(found, priors, face, contact)
    diagonal = np.arange(3 * slots)
    found.curvature[:, diagonal, diagonal] += (face == NONE).repeat(3, axis=1)
    return found


def _loosen(found: Quadratic, left: np.ndarray, jacobian: np.ndarray, pulls: np.ndarray) -> None:
    """Tangential forces integrated out: linear in the signals, normal a priori, they widen the noise
    along `pulls` (Woodbury's identity)."""
    spread = np.eye(pulls.shape[1]) + pulls @ pulls.transpose(0, 2, 1)
    along = pulls @ np.concatenate([left[:, None], jacobian], axis=1).transpose(0, 2, 1)
    solved = np.linalg.solve(spread, along)
    taken = along.transpose(0, 2, 1) @ solved
    found.misfit -= 0.5 * taken[:, 0, 0]
    found.slope -= taken[:, 1:, 0]
    found.curvature -= taken[:, 1:, 1:]
    found.log_spread += 0.5 * np.linalg.slogdet(spread)[1]


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
    _, log_volume = np.linalg.slogdet(bounded_curvature(problems, priors))
    mass = 0.5 * (3 * problems.number * np.log(2 * np.pi) - log_volume)
    return (
        mass
        - problems.misfit
        - problems.log_spread
        + log_density(priors, problems.face, problems.contact)
    )


def covariances(problems: Problems, priors: Priors) -> Float[np.ndarray, "problem contact 3 3"]:
    """Of x, y (mm) and force (N) of each contact, with the uncertainty of the others; no wider than
    the priors. Of empty slots the identity."""
    slots = problems.face.shape[1]
    every = np.linalg.inv(bounded_curvature(problems, priors)).reshape(-1, slots, 3, slots, 3)
    return np.moveaxis(np.diagonal(every, axis1=1, axis2=3), -1, 1)


def bounded_curvature(
    problems: Problems, priors: Priors
) -> Float[np.ndarray, "problem parameter parameter"]:
    """With that of normal priors as wide as the even ones: it has an inverse."""
    filled = np.repeat(problems.face != NONE, 3, axis=1)
    flat = np.tile(12 / np.square(widths(priors)), problems.face.shape[1])
    return problems.curvature + (filled * flat)[:, :, None] * np.eye(len(flat))


def empty(seen: Observed, frame: Int[np.ndarray, "problem"], slots: int) -> Problems:
    """Frames explained by nothing."""
    problems, (misfit, log_spread) = len(frame), seen.resting(frame)
    return Problems(
        frame,
        np.full((problems, slots), NONE),
        np.zeros((problems, slots, 3)),
        np.zeros((problems, seen.counts.shape[1])),
        misfit,
        np.broadcast_to(np.eye(3 * slots), (problems, 3 * slots, 3 * slots)).copy(),
        log_spread,
    )


def strict_misfit(
    model: ContactModel, priors: Priors, seen: Observed, problems: Problems
) -> Float[np.ndarray, "problem"]:
    """Misfit of problems around the strict deviations instead of the true ones."""
    strict = replace(seen, sigma=seen.strict)
    given = problems.frame, problems.face, problems.contact, problems.extra
    return _linear(model, priors, strict, *given).misfit

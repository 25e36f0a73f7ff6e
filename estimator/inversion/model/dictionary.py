"""Coarse dictionary of presses, and which of them would explain what a set of contacts leaves over."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import product

import numpy as np
from jaxtyping import Bool, Float, Int

from design.layout.tips import tip_positions_mm
from estimator.inversion.model.arrays import (
    Array,
    diagonals,
    float32,
    library,
    like,
    to_host,
    true_rows,
)
from estimator.inversion.model.forward import NONE, ContactModel
from estimator.inversion.priors import Priors
from estimator.inversion.problems import Observations, Problems

_PITCH_MM = 3.0
"""Distance of the places at which fits may start."""
_FORCES_N = (0.7, 3.0, 10.0)
"""Forces of these starts."""
_PROBE_FORCES_N = (1.0, 5.0)
"""Forces of starts with known probes."""
_SCALES = (0.3, 2.5)
"""Bounds on the factor by which a start's force is scaled to the readings."""
_CHOSEN, _CHOSEN_PROBES = 4, 3
"""Starts that are chosen for a frame of each number of tips: of free contacts, and of probes."""
_APART_MM = 6.0
"""Distance below which two starts are one."""
_ANGLES = 8
"""Turns of a probe that are tried, over its symmetry."""
_SEEN, _ALIKE = 1e-6, 1e-9
"""Signals of a contact that shifts, in standard deviations, below which it shows nothing, and the share
of them by which contacts that look alike are separated."""


@dataclass(frozen=True)
class Dictionary:
    """Presses of one tip, or of whole probes where these are known.

    Attributes
    ----------
    face : (press,) index of the face
    tips : (press,) how many contacts it has
    contact : (press, tip, 3), as in `ContactModel`; rows beyond `tips` are not used
    counts : (press, channel), contacts summed; frames are given as arrays of this one's kind
    """

    face: Int[np.ndarray, "press"]
    tips: Int[np.ndarray, "press"]
    contact: Float[np.ndarray, "press tip 3"]
    counts: Float[Array, "press channel"]

    def added(
        self, model: ContactModel, observations: Observations, level: Problems, probes: bool
    ) -> tuple[
        Int[np.ndarray, "new"], Int[np.ndarray, "new slot"], Float[np.ndarray, "new slot 3"]
    ]:
        """Sets with the presses added that would explain most of what each problem leaves, once its
        own contacts may shift (orthogonal least squares: Chen, Billings & Luo, Int. J. Control 50,
        1989): row of the problem, faces and contacts.

        Of probes, one a face, the best few of each number of tips; of tips, the best few that stand
        apart.
        """
        gain, scale = self.gains_of(model, observations, level)
        xp = library(gain)
        room = level.face.shape[1] - level.number
        gain[like(gain, self.tips > room[:, None])] = -np.inf
        if probes:
            used = np.stack(
                [np.any(level.face == f, axis=1) for f in range(self.face.max() + 1)], axis=1
            )
            gain[like(gain, used[:, self.face])] = -np.inf
        sets, each = [], like(gain, np.arange(len(level)))
        for number in np.unique(self.tips):
            of_number = xp.where(like(gain, self.tips == number), gain, -np.inf)
            for _ in range(_CHOSEN_PROBES if probes else _CHOSEN):
                press = of_number.argmax(axis=1)
                rows = true_rows(of_number[each, press] > 0)
                few = press[rows]
                starts = (to_host(part) for part in (rows, few, scale[rows, few]))
                sets.append(self.placed_sets(level, *starts))
                of_number[self.near_rows(press)] = -np.inf
        rows, faces, contacts = zip(*sets, strict=True)
        return np.concatenate(rows), np.concatenate(faces), np.concatenate(contacts)

    def placed_sets(
        self, level: Problems, rows: np.ndarray, press: np.ndarray, scale: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """The presses in the first empty slots of the problems."""
        face, contact = level.face[rows].copy(), level.contact[rows].copy()
        first = np.sum(face != NONE, axis=1)
        for tip in range(self.contact.shape[1]):
            (some,) = np.nonzero(self.tips[press] > tip)
            face[some, first[some] + tip] = self.face[press[some]]
            contact[some, first[some] + tip] = self.contact[press[some], tip]
            contact[some, first[some] + tip, 2] *= scale[some]
        return rows, face, contact

    def gains_of(
        self, model: ContactModel, observations: Observations, level: Problems
    ) -> tuple[Float[Array, "problem press"], Float[Array, "problem press"]]:
        """Return how much each press would lower the misfit, and its force over the dictionary's."""
        frame = like(observations.sigma, level.frame)
        white = observations.white.select(frame)
        slots = int(level.number.max(initial=0))
        counts, squared = self._squared_counts
        residual = observations.counts[frame] - level.extra
        length = float32(white.weight**2) @ squared
        # Rows whose products with a press, squared, are what its length loses: to nuisances, contacts
        rows = [white.taken()]
        if slots:
            face, contact = (
                like(residual, part[:, :slots]) for part in (level.face, level.contact)
            )
            singles = model.singles(face, contact)
            residual = white((residual - singles[:, :, 0].sum(axis=1))[:, None])
            jacobian = singles[:, :, 1:].reshape(len(level), 3 * slots, model.channels)
            basis = _basis(white(jacobian))
            residual = residual - (residual @ basis.swapaxes(1, 2)) @ basis
            rows.append(white.transposed(basis))
        else:
            residual = white(residual[:, None])
        for part in rows:
            shared = float32(part) @ counts
            length = library(length).maximum(length - (shared * shared).sum(axis=1), 1e-3 * length)
        projection = float32(white.transposed(residual)[:, 0]) @ counts
        scale = (projection / length).clip(*_SCALES)
        return scale * projection - 0.5 * scale * scale * length, scale

    @cached_property
    def _squared_counts(
        self,
    ) -> tuple[Float[Array, "channel press"], Float[Array, "channel press"]]:
        """Counts and their squares."""
        counts = self.counts.swapaxes(0, 1)
        return counts, counts * counts

    def near_rows(self, press: Int[Array, "problem"]) -> Bool[Array, "problem press"]:
        """Presses that are one start with a chosen one: of as many tips whose centres are near."""
        kind, *places = self._marks
        near = kind[press, None] == kind
        for x_mm, y_mm in zip(places[::2], places[1::2], strict=True):
            x, y = x_mm[press, None] - x_mm, y_mm[press, None] - y_mm
            near &= x * x + y * y < _APART_MM**2
        return near

    @cached_property
    def _marks(self) -> list[Array]:
        """Face and tips as one number; x and y of the centre and, of probes, of the first tip."""
        kind = self.face * (self.tips.max() + 1) + self.tips
        number = np.arange(self.contact.shape[1])[:, None] < self.tips
        # Mean over the tips t that probe p has: d is x or y
        centre = np.einsum("tp,ptd->dp", number / self.tips, self.contact[..., :2])
        first = self.contact[:, 0, :2].T
        places = (*centre, *first) if self.contact.shape[1] > 1 else tuple(centre)
        return [like(self.counts, part) for part in (kind, *map(float32, places))]


def _basis(jacobian: Float[Array, "problem row channel"]) -> Float[Array, "problem row channel"]:
    """Orthonormal rows that span those given (Cholesky); rows of nothing stay so."""
    xp, gram = library(jacobian), jacobian @ jacobian.swapaxes(1, 2)
    diagonal = diagonals(gram)
    diagonal *= 1 + _ALIKE
    diagonal += _SEEN**2
    return xp.linalg.solve(xp.linalg.cholesky(gram), jacobian)


def dictionary(model: ContactModel, priors: Priors) -> Dictionary:
    """Presses on a grid of 3 mm, of one tip, or of every known probe at several angles."""
    low, high = (bound[:2] for bound in model.bounds)
    grids = [
        np.linspace(a, b, max(3, round((b - a) / _PITCH_MM) + 1))
        for a, b in zip(low, high, strict=True)
    ]
    most = 1 + len(priors.spacing_mm)
    faces, tips, contacts = [], [], []
    forces = _PROBE_FORCES_N if priors.spacing_mm else _FORCES_N
    centres = list(product(range(len(model.signals.faces)), *grids))
    for number, angle in probe_shapes(priors):
        offsets = np.zeros((most, 2))
        offsets[:number] = probe_tips_mm(number, angle, priors)
        for face, *centre in centres:
            tips_mm = offsets + np.array(centre)
            if np.any((tips_mm < low - 1e-6) | (tips_mm > high + 1e-6)):
                continue
            if not _fits_on_face(model, face, tips_mm[:number]):
                continue
            for force in forces:
                faces.append(face)
                tips.append(number)
                contacts.append(np.column_stack([tips_mm, np.full(most, force)]))
    face, number, contact = np.array(faces), np.array(tips), np.array(contacts)
    is_tip = np.arange(most) < number[:, None]
    tables, singles = model.signals, np.zeros((*is_tip.shape, model.channels))
    given = (like(tables.coefficients, part) for part in (np.repeat(face, number), contact[is_tip]))
    singles[is_tip] = to_host(tables.values(*given)[:, 0])
    counts = like(tables.coefficients, singles.sum(axis=1).astype(np.float32))
    return Dictionary(face, number, contact, counts)


def _fits_on_face(model: ContactModel, face: int, tips_mm: Float[np.ndarray, "tip 2"]) -> bool:
    contact = np.column_stack([tips_mm, np.zeros(len(tips_mm))])[None]
    stays = model.select_faces(np.full((1, len(tips_mm)), face), contact)
    return bool(np.allclose(stays, contact, atol=1e-6))


def probe_shapes(priors: Priors) -> list[tuple[int, float]]:
    """Numbers of tips and angles; a probe of n tips looks alike after a turn by 1/n."""
    several = range(2, len(priors.spacing_mm) + 2)
    return [(1, 0.0)] + [(n, 2 * np.pi / n * k / _ANGLES) for n in several for k in range(_ANGLES)]


def probe_tips_mm(tips: int, angle: float, priors: Priors) -> Float[np.ndarray, "tip 2"]:
    """Tips of a known probe about its middle, turned by an angle (rad)."""
    spacing_mm = None if tips == 1 else priors.spacing_mm[tips - 2]
    c, s = np.cos(angle), np.sin(angle)
    return tip_positions_mm(tips, spacing_mm=spacing_mm) @ np.array([[c, s], [-s, c]])

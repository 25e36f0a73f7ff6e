"""Coarse dictionary of presses, and which of them would explain what a set of contacts leaves over."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import product

import numpy as np
from jaxtyping import Bool, Float, Int

from design.layout.tips import tip_positions_mm
from estimator.inversion.model.forward import NONE, ContactModel
from estimator.inversion.posterior import Observed, Problems
from estimator.inversion.priors import Priors

_PITCH_MM = 3.0
_FORCES_N = (0.7, 3.0, 10.0)
_PROBE_FORCES_N = (1.0, 5.0)
_SCALES = (0.3, 2.5)
_CHOSEN, _CHOSEN_PROBES = 4, 3
_APART_MM = 6.0
_ANGLES = 8
_SEEN = 1e-6


@dataclass(frozen=True)
class Dictionary:
    """Presses of one tip, or of whole probes where these are known.

    Attributes
    ----------
    face : (press,) index of the face
    tips : (press,) how many contacts it has
    contact : (press, tip, 3), as in `ContactModel`; rows beyond `tips` are not used
    counts : (press, channel), contacts summed
    """

    face: Int[np.ndarray, "press"]
    tips: Int[np.ndarray, "press"]
    contact: Float[np.ndarray, "press tip 3"]
    counts: Float[np.ndarray, "press channel"]

    def added(
        self, model: ContactModel, seen: Observed, level: Problems, probes: bool
    ) -> tuple[
        Int[np.ndarray, "new"], Int[np.ndarray, "new slot"], Float[np.ndarray, "new slot 3"]
    ]:
        """Sets with the presses added that would explain most of what each problem leaves, once its
        own contacts may shift (orthogonal least squares: Chen, Billings & Luo, Int. J. Control 50,
        1989): row of the problem, faces and contacts.

        Of probes, one a face, the best few of each number of tips; of tips, the best few that stand
        apart.
        """
        gain, scale = self._gains(model, seen, level)
        used = np.stack(
            [np.any(level.face == f, axis=1) for f in range(self.face.max() + 1)], axis=1
        )
        room = level.face.shape[1] - level.number
        gain[self.tips > room[:, None]] = -np.inf
        if probes:
            gain[used[:, self.face]] = -np.inf
        found = []
        for number in np.unique(self.tips):
            of_number = np.where(self.tips == number, gain, -np.inf)
            for _ in range(_CHOSEN_PROBES if probes else _CHOSEN):
                press = np.argmax(of_number, axis=1)
                (rows,) = np.nonzero(of_number[np.arange(len(level)), press] > 0)
                found.append(self._placed(level, rows, press[rows], scale[rows, press[rows]]))
                of_number[self._near(press)] = -np.inf
        rows, faces, contacts = zip(*found, strict=True)
        return np.concatenate(rows), np.concatenate(faces), np.concatenate(contacts)

    def _placed(
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

    def _gains(
        self, model: ContactModel, seen: Observed, level: Problems
    ) -> tuple[Float[np.ndarray, "problem press"], Float[np.ndarray, "problem press"]]:
        """By how much each press would lower the misfit, and its force over the dictionary's."""
        weight = (1 / seen.sigma[level.frame]).astype(np.float32)
        slots = int(level.number.max(initial=0))
        left = seen.counts[level.frame] - level.extra
        length = weight**2 @ self._squared.T
        if not slots:
            along = (left * weight**2).astype(np.float32) @ self.counts.T
        else:
            singles = model.singles(level.face[:, :slots], level.contact[:, :slots])
            left = left - singles[:, :, 0].sum(axis=1)
            jacobian = (
                singles[:, :, 1:].reshape(len(level), 3 * slots, model.channels) * weight[:, None]
            )
            basis, triangle = np.linalg.qr(jacobian.transpose(0, 2, 1))
            basis = basis * (abs(np.diagonal(triangle, axis1=1, axis2=2)) > _SEEN)[:, None]
            white = left * weight
            white = white - (basis @ (basis.transpose(0, 2, 1) @ white[..., None]))[..., 0]
            shared = (basis * weight[..., None]).transpose(0, 2, 1).astype(np.float32)
            shared = shared @ self.counts.T
            length = np.maximum(length - np.einsum("pkn,pkn->pn", shared, shared), 1e-3 * length)
            along = (white * weight).astype(np.float32) @ self.counts.T
        scale = np.clip(along / length, *_SCALES)
        return scale * along - 0.5 * scale**2 * length, scale

    @cached_property
    def _squared(self) -> Float[np.ndarray, "press channel"]:
        return self.counts**2

    def _near(self, press: Int[np.ndarray, "problem"]) -> Bool[np.ndarray, "problem press"]:
        """Presses that are one start with a chosen one: of as many tips whose centres are near."""
        near = (self.face[press, None] == self.face) & (self.tips[press, None] == self.tips)
        for places in (self._centre_mm, self._first_mm):
            x, y = (axis[press, None] - axis for axis in places)
            near &= x * x + y * y < _APART_MM**2
        return near

    @cached_property
    def _centre_mm(self) -> Float[np.ndarray, "2 press"]:
        number = np.arange(self.contact.shape[1])[:, None] < self.tips
        return np.einsum("tp,ptd->dp", number / self.tips, self.contact[..., :2]).astype(np.float32)

    @cached_property
    def _first_mm(self) -> Float[np.ndarray, "2 press"]:
        return self.contact[:, 0, :2].T.astype(np.float32)


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
    for number, angle in _probes(priors):
        offsets = np.zeros((most, 2))
        offsets[:number] = probe_tips_mm(number, angle, priors)
        for face, *centre in centres:
            tips_mm = offsets + np.array(centre)
            if np.any((tips_mm < low - 1e-6) | (tips_mm > high + 1e-6)):
                continue
            if not _on_face(model, face, tips_mm[:number]):
                continue
            for force in forces:
                faces.append(face)
                tips.append(number)
                contacts.append(np.column_stack([tips_mm, np.full(most, force)]))
    face, number, contact = np.array(faces), np.array(tips), np.array(contacts)
    there = np.arange(most) < number[:, None]
    singles = np.zeros((*there.shape, model.channels))
    singles[there] = model.signals.values(np.repeat(face, number), contact[there])[:, 0]
    return Dictionary(face, number, contact, singles.sum(axis=1).astype(np.float32))


def _on_face(model: ContactModel, face: int, tips_mm: Float[np.ndarray, "tip 2"]) -> bool:
    contact = np.column_stack([tips_mm, np.zeros(len(tips_mm))])[None]
    stays = model.on_faces(np.full((1, len(tips_mm)), face), contact)
    return bool(np.allclose(stays, contact, atol=1e-6))


def _probes(priors: Priors) -> list[tuple[int, float]]:
    """Numbers of tips and angles; a probe of n tips looks alike after a turn by 1/n."""
    several = range(2, len(priors.spacing_mm) + 2)
    return [(1, 0.0)] + [(n, 2 * np.pi / n * k / _ANGLES) for n in several for k in range(_ANGLES)]


def probe_tips_mm(tips: int, angle: float, priors: Priors) -> Float[np.ndarray, "tip 2"]:
    """Tips of a known probe about its middle, turned by an angle (rad)."""
    spacing_mm = None if tips == 1 else priors.spacing_mm[tips - 2]
    c, s = np.cos(angle), np.sin(angle)
    return tip_positions_mm(tips, spacing_mm=spacing_mm) @ np.array([[c, s], [-s, c]])

"""Counts under many contacts of many objects at once: single presses, and what they do to each other.

Signals of single presses add up. What two contacts do to each other's signals comes from the curvature
of each magnet's field: the second derivatives of the counts by its motion, times both motions. One
product of matrices serves it, so that no field is computed while contacts come and go.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Float, Int

from estimator.inversion.model.arrays import Array, apply_in_chunks, float32, like, zeros
from estimator.inversion.model.forward import NONE, ContactModel
from estimator.inversion.model.table import PressTable

_STEPS = np.array([0.5, 0.5, 0.5, 0.05, 0.05, 0.05])
"""Motions (mm, rad) over which second derivatives are taken: those of presses of some newtons."""
_CHUNK = 64
"""Objects at a time: their pairs of motions fit a second-level cache."""


@dataclass(frozen=True)
class JointResponse:
    """Tables of single presses, and second derivatives of counts by the motions of each body.

    Attributes
    ----------
    table : signals (channel), then motions (6 a body) of single presses
    curvature : half the second derivatives, (body · 36, channel)
    """

    table: PressTable
    curvature: Float[Array, "pair channel"]

    def moved_to(self, reference: Array) -> JointResponse:
        """The same where the reference is."""
        return JointResponse(self.table.moved_to(reference), like(reference, self.curvature))

    def changes(
        self,
        face: Int[Array, "object contact"],
        contact: Float[Array, "object contact 3"],
        share: Float[Array, "object contact"],
    ) -> Float[Array, "object channel"]:
        """Return what contacts change, counts.

        `face` is `NONE` in empty slots, `contact` x and y (mm) and force (N). A contact that shares its
        silicone with others has their common force, and `share` of what that force does.
        """
        return apply_in_chunks(self._changes, _CHUNK, face, contact, share)

    def _changes(self, face: Array, contact: Array, share: Array) -> Float[Array, "object channel"]:
        touching = face != NONE
        channels = self.curvature.shape[1]
        expected = zeros(self.table.coefficients, (*face.shape, self.table.coefficients.shape[-1]))
        expected[touching] = self.table.expected(face[touching], contact[touching])
        weight = float32(share)[..., None]
        # sums each contact's share of its signals: (object, 1, contact) @ (object, contact, channel)
        alone = (weight.swapaxes(1, 2) @ expected[..., :channels])[:, 0]
        if face.shape[1] < 2:
            return alone
        return alone + self._interaction(expected[..., channels:], weight)

    def _interaction(
        self,
        moved: Float[Array, "object contact component"],
        weight: Float[Array, "object contact 1"],
    ) -> Float[Array, "object channel"]:
        """Return what motions together do beyond the sum of each alone, to second order."""
        objects, contacts, components = moved.shape
        shared = (moved * weight).reshape(objects, contacts, components // 6, 6)
        each = moved.reshape(shared.shape)
        together = shared.sum(1)
        # (Σ w m)(Σ w m)ᵀ − Σ w m mᵀ of each body: 0 for one contact, however often it is split
        pairs = together[..., :, None] * together[..., None, :]
        # sums w m mᵀ over contacts: (object, body, component, contact) @ (…, contact, component)
        contact_last, contact_third = shared.swapaxes(1, 2).swapaxes(2, 3), each.swapaxes(1, 2)
        pairs = pairs - contact_last @ contact_third
        return pairs.reshape(objects, -1) @ self.curvature


def joint_response(model: ContactModel) -> JointResponse:
    """The response of a forward model, in single precision."""
    both = np.concatenate([model.signals.coefficients, model.motions.coefficients], axis=-1)
    curvature = np.concatenate([_curvature(model, body) for body in range(len(model.rest))])
    return JointResponse(replace(model.signals, coefficients=both), curvature.astype(np.float32))


def _curvature(model: ContactModel, body: int) -> Float[np.ndarray, "pair channel"]:
    """Return half the second derivatives of the counts by one body's motion, by central differences."""
    # (f(+i +j) − f(+i −j) − f(−i +j) + f(−i −j)) / 4; for i = j this is the difference over 2 steps
    signs = np.array([[1, 1], [1, -1], [-1, 1], [-1, -1]])
    ends = np.eye(6) * _STEPS
    states = np.zeros((6, 6, 4, *model.rest.shape))
    for corner, (first, second) in enumerate(signs):
        states[:, :, corner, body] = first * ends[:, None] + second * ends[None]
    counts = model.counts_of_motions(states.reshape(-1, *model.rest.shape)).reshape(36, 4, -1)
    # p pair of components, c corner, n channel
    second = np.einsum("pcn,c->pn", counts, signs.prod(axis=1)) / 4
    return second / 2 / np.outer(_STEPS, _STEPS).reshape(36, 1)

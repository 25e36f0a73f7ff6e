"""Counts under many contacts of many objects at once, some of which share their silicone."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Float, Int

from estimator.inversion.model.arrays import Array, apply_in_chunks, float32, like, zeros
from estimator.inversion.model.forward import NONE, ContactModel, interaction_counts
from estimator.inversion.model.table import PressTable

_CHUNK = 64
"""Objects at a time: their pairs of motions fit a second-level cache."""


@dataclass(frozen=True)
class JointResponse:
    """Table of single presses, and what contacts do to each other.

    Attributes
    ----------
    table : signals (channel), then motions (6 a body) of single presses
    pair_counts : as in `ContactModel`
    """

    table: PressTable
    pair_counts: Float[Array, "pair channel"]

    def moved_to(self, reference: Array) -> JointResponse:
        """The same where the reference is."""
        return JointResponse(self.table.moved_to(reference), like(reference, self.pair_counts))

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
        channels = self.pair_counts.shape[1]
        expected = zeros(self.table.coefficients, (*face.shape, self.table.coefficients.shape[-1]))
        expected[touching] = self.table.expected(face[touching], contact[touching])
        weight = float32(share)[..., None]
        # sums each contact's share of its signals: (object, 1, contact) @ (object, contact, channel)
        alone = (weight.swapaxes(1, 2) @ expected[..., :channels])[:, 0]
        if face.shape[1] < 2:
            return alone
        moved = expected[..., channels:].reshape(*face.shape, -1, 6)
        return alone + interaction_counts(moved, moved * weight[..., None], self.pair_counts)


def joint_response(model: ContactModel) -> JointResponse:
    """The response of a forward model, in single precision."""
    both = np.concatenate([model.signals.coefficients, model.motions.coefficients], axis=-1)
    table = replace(model.signals, coefficients=both)
    return JointResponse(table, model.pair_counts.astype(np.float32))

"""Order and turn of the chips of a log: recorded against predicted changes under every convention.

One turn of the axes (24, with either pole outwards 48) holds for all chips of a face, as chips are soldered
alike; the order is the best assignment of columns to designed chips. What order and turn explain by
chance is what they explain with the chips exchanged.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import permutations, product

import numpy as np
from jaxtyping import Float, Int
from scipy.optimize import linear_sum_assignment

TURNS = tuple(
    matrix
    for order in permutations(range(3))
    for signs in product((1, -1), repeat=3)
    if np.linalg.det(matrix := np.eye(3)[list(order)] * np.array(signs)[:, None]) > 0
)
"""All turns that take chip axes to chip axes; the first leaves them."""

Changes = Float[np.ndarray, "press chip 3"]


@dataclass(frozen=True)
class Convention:
    """Designed chip k is column `order[k]` of the face's chips; axes: designed = recorded @ `turn`.

    A `turn` of determinant −1 means that the magnets' poles lie the other way than designed.
    """

    order: Int[np.ndarray, "chip"]
    turn: Float[np.ndarray, "3 3"]
    cosine: float

    @property
    def reversed_poles(self) -> bool:
        """Return whether the poles lie the other way than designed."""
        return bool(np.linalg.det(self.turn) < 0)

    def agrees(self, convention: Convention) -> bool:
        """Return whether both have the same order and turn."""
        same_turn = np.array_equal(self.turn, convention.turn)
        return same_turn and np.array_equal(self.order, convention.order)

    def designed(self, recorded: Float[np.ndarray, "*any chip 3"]) -> np.ndarray:
        """Return readings of the log in the order and along the axes of the design."""
        return recorded[..., self.order, :] @ self.turn


def best_convention(recorded: list[np.ndarray], predicted: list[np.ndarray]) -> Convention:
    """Find order and turn of the chips that agree best, by the mean cosine over sets of readings.

    Parameters
    ----------
    recorded, predicted : arrays (…, chip, 3)
        Such as changes of all presses, and levels at rest; each set counts alike.
    """
    products = []
    for ours, theirs in zip(recorded, predicted, strict=True):
        a, b = ours.reshape(-1, *ours.shape[-2:]), theirs.reshape(-1, *theirs.shape[-2:])
        size = np.linalg.norm(a) * np.linalg.norm(b)
        # Σ over readings n of recorded chip c axis i times predicted chip s axis j
        products.append(np.einsum("nci,nsj->csij", a, b) / max(size, 1e-30))
    product = sum(products) / len(products)
    best = None
    for turn in (*TURNS, *(-turn for turn in TURNS)):
        score = np.einsum("csij,ij->cs", product, turn)
        column, chip = linear_sum_assignment(-score)
        cosine = float(score[column, chip].sum())
        if best is None or cosine > best.cosine:
            best = Convention(column[np.argsort(chip)], turn, cosine)
    assert best is not None
    return best

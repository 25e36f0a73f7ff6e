"""Seals that have sunk: dents of the surface over the bodies that lie in the silicone.

A dent is a paraboloid over its pocket's mouth, deepest in the middle, flush at the rim (over a
rectangular pocket a parabola along each edge).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float

from design.layout.pockets import Pocket, shell_pockets
from design.spec.cached_geometry import cached_geometry

if TYPE_CHECKING:
    from design.spec.object import ObjectSpec


@cached_geometry
def dents_mm(spec: ObjectSpec) -> Float[np.ndarray, "face body"]:
    """Depth of every dent in its middle, sensed face by face, as found."""
    count = len(shell_pockets(spec)[0])
    depth = np.zeros((len(spec.body.sensed), count))
    for magnet in spec.as_built.magnets:
        if magnet.dent_mm is not None:
            depth[spec.body.sensed.index(magnet.face), magnet.magnet - 1] = magnet.dent_mm
    return depth


def sunk_mm(
    spec: ObjectSpec, face: int, xy_mm: Float[np.ndarray, "point 2"]
) -> Float[np.ndarray, "point"]:
    """Return how far the surface lies below the face as designed, at places of the face (its number)."""
    index = spec.body.sensed.index(face)
    pockets, depths = shell_pockets(spec)[index], dents_mm(spec)[index]
    dishes = [d * _dish(pocket, xy_mm) for pocket, d in zip(pockets, depths, strict=True)]
    return np.max(dishes, axis=0)


def _dish(pocket: Pocket, xy_mm: Float[np.ndarray, "point 2"]) -> Float[np.ndarray, "point"]:
    """1 in the middle of the mouth, 0 at its rim and beyond."""
    mouth = pocket.body.centre_mm[:2] + pocket.mouth_mm * pocket.axis[:2]
    mouth_share = (xy_mm - mouth) @ pocket.body.frame[:2, :2] / np.asarray(pocket.outline.half_mm)
    if pocket.outline.round:
        return np.clip(1 - np.sum(mouth_share**2, axis=1), 0, None)
    return np.prod(np.clip(1 - mouth_share**2, 0, None), axis=1)

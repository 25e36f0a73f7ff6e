"""Wrenches that a grasp can resist: force closure, ε, volume, and the friction that it needs.

Ferrari & Canny, Planning optimal grasps, ICRA 1992 (ε as the largest ball within the hull of the
contacts' wrenches); Li & Sastry, Task-oriented optimal grasping, IEEE J. Robotics Automation 4, 1988
(volume); Nguyen, Constructing force-closure grasps, IJRR 7(3), 1988 (two contacts).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float
from scipy.optimize import linprog
from scipy.spatial import ConvexHull, QhullError

EDGES = 12
"""Edges of the pyramid within each friction cone: it needs at most 1/cos(π/12) − 1 = 3.5 % more friction."""
_MOST_FRICTION = 2.0
"""Friction up to which closure is looked for."""
_STEPS = 8
"""Halvings: friction to 0.01."""
_INSIDE = 1e-9
"""Least distance of the origin from the hull's faces for closure; below is rounding."""


@dataclass(frozen=True)
class WrenchSpace:
    """Hull of the wrenches of contacts whose normal forces are at most 1.

    Attributes
    ----------
    closed : the origin lies inside: any small wrench can be resisted (force closure)
    epsilon : largest wrench that is resisted in every direction, as a share of a contact's force
    volume : of the hull
    """

    closed: bool
    epsilon: float
    volume: float


def contact_wrenches(
    point_mm: Float[np.ndarray, "contact 3"],
    axes: Float[np.ndarray, "contact 3 3"],
    friction: float,
    patch_mm: float,
    reach_mm: float,
) -> Float[np.ndarray, "wrench 6"]:
    """Force and moment of unit normal forces at the edges of soft-finger contacts.

    Moments are about the object's origin and in units of `reach_mm`. A soft finger also turns by up to
    2/3 μ a F about its normal, a the patch's radius: Coulomb friction under even pressure. Without
    friction each contact gives one wrench.
    """
    if friction <= 0:
        force = axes[..., 2]
        return np.concatenate([force, np.cross(point_mm, force) / reach_mm], axis=1)
    turn = 2 * np.pi * np.arange(EDGES) / EDGES
    local = np.column_stack([friction * np.cos(turn), friction * np.sin(turn), np.ones(EDGES)])
    # contact c, edge e, component i
    force = np.einsum("cij,ej->cei", axes, local)
    moment = np.cross(point_mm[:, None], force)
    normal = axes[..., 2]
    straight = np.cross(point_mm, normal)
    twist = 2 / 3 * friction * patch_mm * normal
    parts = [np.concatenate([force, moment / reach_mm], axis=2).reshape(-1, 6)]
    for sign in (1, -1):
        parts.append(np.concatenate([normal, (straight + sign * twist) / reach_mm], axis=1))
    return np.concatenate(parts)


def wrench_space(wrenches: Float[np.ndarray, "wrench dimension"]) -> WrenchSpace:
    """Closure, ε and volume of the hull of wrenches; all 0 where it is flat."""
    try:
        hull = ConvexHull(wrenches)
    except QhullError:  # fewer wrenches than a body needs, or all in one plane
        return WrenchSpace(False, 0.0, 0.0)
    # a face's equation is n·w + offset <= 0 inside, so −offset is its distance from the origin
    distance = float(-hull.equations[:, -1].max())
    closed = distance > _INSIDE
    return WrenchSpace(closed, max(distance, 0.0) if closed else 0.0, float(hull.volume))


def is_closed(wrenches: Float[np.ndarray, "wrench dimension"]) -> bool:
    """Return whether the origin lies inside the wrenches' hull: some positive multiples of all of them
    cancel, and they span the space (Ferrari & Canny's condition as a linear programme)."""
    count, dimension = wrenches.shape
    if np.linalg.matrix_rank(wrenches, tol=_INSIDE) < dimension:
        return False
    # any multiples above 0 may be scaled to at least 1
    return linprog(
        np.zeros(count), A_eq=wrenches.T, b_eq=np.zeros(dimension), bounds=(1, None)
    ).success


def closing_friction(
    point_mm: Float[np.ndarray, "contact 3"],
    axes: Float[np.ndarray, "contact 3 3"],
    patch_mm: float,
) -> float:
    """Return the least friction with which the contacts have force closure; ∞ where none up to 2 does.

    For two soft fingers it is the tangent of the larger angle between their line and a normal (Nguyen
    1988). For more it is looked for, to 0.01, and at most 3.5 % too high.
    """
    if len(point_mm) == 2:
        return _opposed_friction(point_mm, axes[..., 2])
    reach = float(np.linalg.norm(point_mm, axis=1).max(initial=1.0))

    def closed(friction: float) -> bool:
        return is_closed(contact_wrenches(point_mm, axes, friction, patch_mm, reach))

    if len(point_mm) < 2 or not closed(_MOST_FRICTION):
        return float("inf")
    low, high = 0.0, _MOST_FRICTION
    for _ in range(_STEPS):
        middle = (low + high) / 2
        low, high = (low, middle) if closed(middle) else (middle, high)
    return high


def _opposed_friction(
    point_mm: Float[np.ndarray, "2 3"], inward: Float[np.ndarray, "2 3"]
) -> float:
    line = point_mm[1] - point_mm[0]
    towards = np.array([line, -line]) / max(float(np.linalg.norm(line)), 1e-9)
    cosine = float(np.min(np.sum(inward * towards, axis=1)))
    if cosine <= 1 / np.hypot(1, _MOST_FRICTION):
        return float("inf")
    return float(np.sqrt(max(0.0, 1 - min(cosine, 1.0) ** 2)) / cosine)


def friction_used(force_n: Float[np.ndarray, "contact 3"]) -> float:
    """Largest ratio of tangential to normal force among contacts; NaN where none was read."""
    ratio = np.hypot(force_n[:, 0], force_n[:, 1]) / np.maximum(force_n[:, 2], 1e-9)
    return float(np.nanmax(ratio)) if np.isfinite(ratio).any() else float("nan")

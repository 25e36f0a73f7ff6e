"""Several rigid tips at once, on one face or on several, with contact solved jointly.

Probes with two or three tips and parallel-jaw grasps: every tip's pressure moves the surface under
every other tip, through the compliance between all faces.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np
from jaxtyping import Float

from design.errors import InputError
from design.spec import ObjectSpec
from fem.contact import contact_pressures
from fem.presses import profile_moments_mm3, require_on_face, surface_weights_mm2
from fem.response import ResponseOperator

_FORCE_TOLERANCE = 1e-6
_MAX_STEPS = 60


@dataclass(frozen=True)
class Tip:
    """One hemispherical tip: the face (1…5) and where it lands in the face's frame, mm."""

    face: int
    x_mm: float
    y_mm: float


@dataclass(frozen=True)
class JointPress:
    """Tips pressed together: force of each tip (N) at its depth (mm), and all magnets' motions.

    `motion` (magnet, 6) is in mm and rad, in the object's frame, as in `MagnetMotions`.
    """

    tips: tuple[Tip, ...]
    depth_mm: Float[np.ndarray, "tip"]
    force_n: Float[np.ndarray, "tip"]
    motion: Float[np.ndarray, "magnet 6"]


@dataclass(frozen=True)
class _Candidates:
    """Vertices that the tips may touch: rows of the compliance, their tip, moments and weights."""

    loads: np.ndarray
    tip: np.ndarray
    moments: np.ndarray
    weights: np.ndarray


def press_tips(
    spec: ObjectSpec,
    response: ResponseOperator,
    tips: Sequence[Tip],
    depths_mm: Float[np.ndarray, "tip"],
) -> JointPress:
    """Press every tip to its own depth, all at once.

    Raises
    ------
    InputError
        A tip on no sensed face, over a face's border, or closer than two radii to another.
    """
    return _press(response, tuple(tips), _candidates(spec, response, tips), depths_mm)


def squeeze(
    spec: ObjectSpec,
    response: ResponseOperator,
    jaws: tuple[Sequence[Tip], Sequence[Tip]],
    force_n: float,
) -> JointPress:
    """Squeeze the object between two rigid jaws until each presses with `force_n` in all.

    The object hangs freely between the jaws, so their forces are equal; the tips of one jaw share
    its depth. Solved by a quasi-Newton (Broyden) iteration on the two depths, to 1e-6 of the force.

    Raises
    ------
    InputError
        As `press_tips`; or the force is not positive, or not reached within the tips' radius.
    """
    if not force_n > 0:
        raise InputError(f"a squeeze needs a positive force; got {force_n:g} N")
    tips = (*jaws[0], *jaws[1])
    candidates = _candidates(spec, response, tips)
    jaw = np.repeat([0, 1], [len(jaws[0]), len(jaws[1])])

    def missing(depth: np.ndarray) -> tuple[np.ndarray, JointPress]:
        press = _press(response, tips, candidates, depth[jaw])
        return np.bincount(jaw, press.force_n) - force_n, press

    return _solve_depths(missing, spec.indenter.radius_mm, force_n)


def _solve_depths(
    missing: Callable[[np.ndarray], tuple[np.ndarray, JointPress]],
    deepest_mm: float,
    force_n: float,
) -> JointPress:
    most, press = missing(np.full(2, deepest_mm))
    if most.min() < 0:
        raise InputError(
            f"the jaws do not reach {force_n:g} N within {deepest_mm:g} mm, the radius of the tips "
            f"(most {most.min() + force_n:.3g} N). Squeeze less hard"
        )
    depth = np.full(2, deepest_mm / 4)
    residual, press = missing(depth)
    stiffness = np.diag((residual + force_n) / depth * 1.5)
    for _ in range(_MAX_STEPS):
        if abs(residual).max() <= _FORCE_TOLERANCE * force_n:
            return press
        step = -np.linalg.solve(stiffness, residual)
        step = np.clip(step, -depth / 2, (deepest_mm - depth) / 2)
        before = residual
        depth = depth + step
        residual, press = missing(depth)
        change = residual - before - stiffness @ step
        stiffness = stiffness + np.outer(change, step) / (step @ step)
    raise ArithmeticError(
        f"the squeeze to {force_n:g} N did not converge: off by {abs(residual).max():.2g} N"
    )


def _press(
    response: ResponseOperator,
    tips: tuple[Tip, ...],
    candidates: _Candidates,
    depths_mm: np.ndarray,
) -> JointPress:
    loads, depth = candidates.loads, np.asarray(depths_mm, float)
    compliance = np.asarray(response.compliance[np.ix_(loads, loads)])
    moments = candidates.moments - depth[candidates.tip] * candidates.weights
    pressure = contact_pressures(compliance, moments, candidates.weights, np.zeros(1))[0]
    force = np.bincount(candidates.tip, pressure * candidates.weights, minlength=len(tips))
    motion = response.compliance[response.magnet_loads][:, loads] @ pressure
    return JointPress(tips, depth, force, np.asarray(motion).reshape(-1, 6))


def _candidates(spec: ObjectSpec, response: ResponseOperator, tips: Sequence[Tip]) -> _Candidates:
    _require_apart(tips, spec.indenter.radius_mm)
    numbers = [surface.number for surface in response.surfaces]
    parts = []
    for index, tip in enumerate(tips):
        if tip.face not in numbers:
            raise InputError(f"face {tip.face} is not a sensed face. Press one of {numbers}")
        face = numbers.index(tip.face)
        surface = response.surfaces[face]
        centre = np.array([[tip.x_mm, tip.y_mm]])
        require_on_face(surface, centre, spec.indenter.radius_mm)
        near = np.flatnonzero(
            np.linalg.norm(surface.xy_mm - centre, axis=1) < spec.indenter.radius_mm
        )
        moments = profile_moments_mm3(surface, centre, spec.indenter.radius_mm)[0]
        first = response.face_loads(face).start
        weights = surface_weights_mm2(surface)
        parts.append((first + near, np.full(len(near), index), moments[near], weights[near]))
    return _Candidates(*(np.concatenate(column) for column in zip(*parts, strict=True)))


def _require_apart(tips: Sequence[Tip], radius_mm: float) -> None:
    for a, b in combinations(tips, 2):
        distance = np.hypot(a.x_mm - b.x_mm, a.y_mm - b.y_mm)
        if a.face == b.face and distance < 2 * radius_mm:
            raise InputError(
                f"two tips on face {a.face} are {distance:.3g} mm apart, less than two radii "
                f"({2 * radius_mm:g} mm). Move them apart or use smaller tips"
            )

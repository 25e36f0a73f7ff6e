"""Presses to given forces: quasi-Newton iteration on the depths of indenters or jaws."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from jaxtyping import Float

from design.errors import InputError, SolverError
from design.layout.tips import tip_shape
from design.spec.object import ObjectSpec
from fem.contact.refined import RefinedFace
from fem.linear.response import ResponseOperator
from fem.presses.joint import JointPress, Tip, press_on_core, presser

_FORCE_TOLERANCE = 1e-6
"""Relative error of a force that is reached."""
MAX_STEPS = 60
"""Iterations towards a force, at most."""


def press_to_force(
    spec: ObjectSpec,
    response: ResponseOperator,
    groups: Sequence[Sequence[Tip]],
    force_n: float,
) -> JointPress:
    """Press every group of indenters, each group at one depth, until each bears `force_n` in all: two jaws,
    for a grasp.

    Solved by a quasi-Newton (Broyden) iteration on the groups' depths, to 1e-6 of the force.

    Raises
    ------
    InputError
        As `press_tips`; or the force is not positive, or not reached within the indenter's height
        and the shell's thickness.
    """
    tips = [tip for group in groups for tip in group]

    def press(given: ResponseOperator) -> JointPress:
        return press_to_depths(spec, presser(spec, given, tips), groups, force_n)

    return press_on_core(spec, response, press)


def squeeze_path(
    spec: ObjectSpec,
    response: ResponseOperator,
    jaws: tuple[Sequence[Tip], Sequence[Tip]],
    force_n: Sequence[float],
    faces: dict[int, RefinedFace] | None = None,
) -> tuple[JointPress, ...]:
    """Squeeze the object between two rigid jaws to several forces, at the cost of little more than one.

    It hangs freely between them, so that their forces are equal; the tips of one jaw share its depth. A
    frictionless core holds the shell both ways here.
    """
    press = presser(spec, response, [tip for jaw in jaws for tip in jaw], faces)
    path: list[JointPress] = []
    for force in force_n:
        near = None
        if path:  # forces grow about as depth to the power 3/2
            last, first_tips = path[-1], [0, len(jaws[0])]
            rise = (2 * force / last.force_n.sum()) ** (2 / 3)
            near = last.depth_mm[first_tips] * rise
        path.append(press_to_depths(spec, press, jaws, force, near))
    return tuple(path)


def press_to_depths(
    spec: ObjectSpec,
    press: Callable[[np.ndarray], JointPress],
    groups: Sequence[Sequence[Tip]],
    force_n: float,
    near_mm: Float[np.ndarray, "group"] | None = None,
) -> JointPress:
    if not (force_n > 0 and np.isfinite(force_n)):
        raise InputError(
            f"a press to a force needs a positive one; got {force_n:g} N. Give it in N"
        )
    group_of = np.repeat(np.arange(len(groups)), [len(group) for group in groups])

    def missing(depth: np.ndarray) -> tuple[np.ndarray, JointPress]:
        pressed = press(depth[group_of])
        return np.bincount(group_of, pressed.force_n) - force_n, pressed

    deepest = min(tip_shape(spec.indenter).height_mm, spec.shell.thickness_mm)
    return _solve_depths(missing, np.full(len(groups), deepest), force_n, near_mm)


def _solve_depths(
    missing: Callable[[np.ndarray], tuple[np.ndarray, JointPress]],
    deepest_mm: np.ndarray,
    force_n: float,
    near_mm: np.ndarray | None = None,
) -> JointPress:
    """From `near_mm` where it is given, else from a quarter of the deepest press."""
    if near_mm is None:
        _require_reach(missing, deepest_mm, force_n)
    depth = np.minimum(deepest_mm / 4 if near_mm is None else near_mm, deepest_mm)
    residual, press = missing(depth)
    stiffness = np.diag(np.maximum(residual + force_n, 1e-3 * force_n) / depth * 1.5)
    for _ in range(MAX_STEPS):
        if abs(residual).max() <= _FORCE_TOLERANCE * force_n:
            return press
        step = -np.linalg.solve(stiffness, residual)
        step = np.clip(step, -depth / 2, (deepest_mm - depth) / 2)
        previous_residual = residual
        depth = depth + step
        residual, press = missing(depth)
        change = residual - previous_residual - stiffness @ step
        stiffness = stiffness + np.outer(change, step) / (step @ step)
    raise SolverError(
        f"the press to {force_n:g} N did not converge: off by {abs(residual).max():.2g} N"
    )


def _require_reach(
    missing: Callable[[np.ndarray], tuple[np.ndarray, JointPress]],
    deepest_mm: np.ndarray,
    force_n: float,
) -> None:
    most, _ = missing(deepest_mm)
    if most.min() < 0:
        raise InputError(
            f"{force_n:g} N are not reached within {deepest_mm[0]:g} mm, the lesser of the indenter's "
            f"height and the shell's thickness (most {most.min() + force_n:.3g} N). Press less hard"
        )

"""A frictionless core that the shell may leave: openings g ≥ 0, forces f ≥ 0, f g = 0 everywhere.

`fem.linear.response` holds the shell on its frictionless core both ways. Where that would pull, the shell
lifts off. With F the core's forces per load and K their rise with openings (`CoreContact`),
    f = F p + K g,    motion of the loads = C p − Fᵀ g,
and vertices O that have let go bear nothing, so g_O = −K_OO⁻¹ F_O p and C grows by F_Oᵀ K_OO⁻¹ F_O.
The set O is found by a primal-dual active set method (Hintermüller, Ito & Kunisch, SIAM J. Optim.
13 (2003) 865) around the contact of the indenters.

Nothing presses the shell on its core at rest (no shrinkage of the cast, no weight), and without
friction nothing but the core's top keeps it from rising. A weak hold of `HOLD` times the layer's own
stiffness E/h on the openings picks the least motion; it changes forces by less than 0.2 %.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TypeVar

import numpy as np
import scipy.linalg
from jaxtyping import Bool, Float

from design.errors import SolverError
from design.spec.object import ObjectSpec
from fem.linear.core_interface import CoreContact, CoreState
from fem.linear.response import ResponseOperator

Pressed = TypeVar("Pressed")
HOLD = 1e-3
"""Weak hold of the shell on its core, over the layer's own stiffness: it picks the least motion."""
MAX_STEPS = 50
"""Steps after which lift-off has not settled."""
NOTHING = 1e-9
"""Share of the largest force that counts as none."""


def lift_off(
    spec: ObjectSpec,
    response: ResponseOperator,
    press: Callable[[ResponseOperator], Pressed],
    closed_force: Callable[[Pressed], Float[np.ndarray, "i"]],
) -> tuple[Pressed, CoreState]:
    """A press on a core that only pushes.

    Parameters
    ----------
    press : the press on a given response
    closed_force : F p of that press (N), what the core's vertices would bear if nothing let go

    Raises
    ------
    ValueError
        The shell is bonded to its core.
    SolverError
        The vertices that let go did not settle.
    """
    core = response.core
    if core is None:
        raise ValueError("a shell bonded to its core does not lift off")
    hold = HOLD * spec.silicone.youngs_modulus_mpa / spec.shell.thickness_mm * core.weights_mm2
    open_ = np.zeros(len(core.normal), bool)
    for _ in range(MAX_STEPS):
        pressed = press(with_open_core(response, open_, hold))
        state = core_state(core, closed_force(pressed), open_, hold)
        least = NOTHING * abs(state.force_n).max()
        now = np.where(open_, state.opening_mm > 0, state.force_n < -least)
        if (now == open_).all():
            return pressed, state
        open_ = now
    raise SolverError(
        f"where the shell lifts off its core did not settle in {MAX_STEPS} steps "
        f"({open_.sum()} of {len(open_)} vertices open)"
    )


def core_state(
    core: CoreContact,
    closed_force_n: Float[np.ndarray, "i"],
    open_: Bool[np.ndarray, "i"],
    hold_n_per_mm: Float[np.ndarray, "i"],
) -> CoreState:
    """Forces and openings when `open_` vertices have let go; `closed_force_n` is F p."""
    opening = np.zeros(len(open_))
    if open_.any():
        opening[open_] = -_opened(core, open_, hold_n_per_mm, closed_force_n[open_])
    force = np.where(open_, 0.0, closed_force_n + core.stiffness @ opening)
    return CoreState(force, opening)


def with_open_core(
    response: ResponseOperator, open_: Bool[np.ndarray, "i"], hold_n_per_mm: Float[np.ndarray, "i"]
) -> ResponseOperator:
    """The response with `open_` vertices of its core let go; `core` still describes the closed one."""
    core = response.core
    if core is None or not open_.any():
        return response
    forces = core.force_per_load[open_]
    softer = forces.T @ _opened(core, open_, hold_n_per_mm, forces)
    return replace(response, compliance=response.compliance + (softer + softer.T) / 2)


def _opened(
    core: CoreContact, open_: np.ndarray, hold_n_per_mm: np.ndarray, forces: np.ndarray
) -> np.ndarray:
    """(K_OO + hold)⁻¹ forces."""
    stiffness = core.stiffness[np.ix_(open_, open_)] + np.diag(hold_n_per_mm[open_])
    return scipy.linalg.solve(stiffness, forces, assume_a="sym")

"""Motions of all magnets in presses of a given force at given places, and a little next to them.

The same interpolation as that of signals (`estimator.signals.interpolation`), of motions instead of counts:
what reads them may then move magnets and sensors as it likes, without new mechanics.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from jaxtyping import Bool, Float, Int

from estimator.signals.interpolation import Traces, counts_at_force, press_traces
from estimator.signals.presses import Signals
from fem.presses.results import MagnetMotions, PressForces

ASIDE_MM = 0.1
"""Half the distance of the presses whose difference quotient is ∂/∂x or ∂/∂y."""
_FORCE_STEP = 0.01
"""Half that distance for ∂/∂F, over the force."""
SIDES_MM = ASIDE_MM * np.array([(0, 0), (1, 0), (-1, 0), (0, 1), (0, -1)])
"""Steps in x and y of the five presses."""


@dataclass(frozen=True)
class PressStates:
    """Presses of `force_n` (press,) N at places, ±`ASIDE_MM` from them in x and y, and ±1 % of force.

    `motion` gives seven states of each press; `differentiate` takes values in them to derivatives.
    """

    traces: tuple[Traces, ...]
    force_n: Float[np.ndarray, "press"]
    rest: Float[np.ndarray, "body 6"]

    @cached_property
    def design_motion(self) -> Float[np.ndarray, "7 press body 6"]:
        """`motion` in the design's silicone."""
        return self.motion(1.0)

    def slope_per_mm(self, motion: Float[np.ndarray, "7 press body 6"]) -> np.ndarray:
        """∂(motion)/∂(x, y) of the press, (2, press, body, 6)."""
        return (motion[1:5:2] - motion[2:5:2]) / (2 * ASIDE_MM)

    def motion(self, modulus_ratio: float) -> Float[np.ndarray, "7 press body 6"]:
        """States: at, +x, −x, +y, −y, +F, −F, in a silicone of another modulus.

        Small strain: a modulus e times as high moves by a force what the design moves by F/e.
        Forces beyond the deepest simulated press are clamped to it.
        """
        force = self.force_n / modulus_ratio
        rise = 1 + _FORCE_STEP * np.array([0.0, 1.0, -1.0])
        in_place, more, less = np.moveaxis(
            counts_at_force(self.traces[0], force[:, None] * rise, "clamp").counts, 1, 0
        )
        aside = [
            counts_at_force(traces, force[:, None], "clamp").counts[:, 0]
            for traces in self.traces[1:]
        ]
        moved = np.stack([in_place, *aside, more, less])
        return self.rest + moved.reshape(7, len(force), *self.rest.shape)

    def simulated(self, modulus_ratio: float) -> Bool[np.ndarray, "press"]:
        """Return which presses have all their states within the simulated depths (`motion` clamps)."""
        reach = np.min([traces.force_n[:, -1] for traces in self.traces], axis=0)
        return (1 + _FORCE_STEP) * self.force_n / modulus_ratio <= reach

    def differentiate(
        self, values: Float[np.ndarray, "7 press channel"]
    ) -> Float[np.ndarray, "press channel 3"]:
        """∂/∂(x, y, F) of values in the seven states, by central differences, per mm and N."""
        steps = 2 * np.stack([ASIDE_MM + 0 * self.force_n] * 2 + [_FORCE_STEP * self.force_n])
        return np.stack(
            [(values[1 + 2 * k] - values[2 + 2 * k]) / steps[k][:, None] for k in range(3)], axis=-1
        )


def press_states(
    forces: PressForces,
    motions: MagnetMotions,
    face: Int[np.ndarray, "press"],
    xy_mm: Float[np.ndarray, "press 2"],
    force_n: Float[np.ndarray, "press"],
) -> PressStates:
    """Interpolate the lattice's motions at places (mm in the face's frame).

    Raises
    ------
    InputError
        A place within `ASIDE_MM` of the lattice's border, or beyond it.
    """
    moving = motions_as_signals(forces, motions)
    traces = tuple(press_traces(moving, face, *(xy_mm + side).T) for side in SIDES_MM)
    return PressStates(traces, force_n, rest_motion(motions))


def rest_motion(motions: MagnetMotions) -> Float[np.ndarray, "body 6"]:
    """Return what is there without a press: nothing, unless the core slipped."""
    return np.zeros(motions.motion.shape[-2:]) if motions.rest is None else motions.rest


def motions_as_signals(forces: PressForces, motions: MagnetMotions) -> Signals:
    """Motions beyond those at rest in the place of counts: one interpolation serves both."""
    *lattice, bodies, _ = motions.motion.shape
    beyond = motions.motion if motions.rest is None else motions.motion - motions.rest
    return Signals(
        motions.faces,
        motions.lattice,
        motions.depth_mm,
        forces.force_n,
        beyond.reshape(*lattice, 2 * bodies, 3),
        np.zeros((2 * bodies, 3)),
    )

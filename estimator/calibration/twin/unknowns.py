"""Unknowns of a built object, and their most probable values given what labelled presses show."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from jaxtyping import Bool, Float

from design.spec.object import ObjectSpec
from estimator.signals.interpolation import unresolved_presses
from estimator.signals.press_states import motions_as_signals
from estimator.signals.presses import Signals
from estimator.tolerances.assembly import Assembly, assembled, contribution_sizes, designed
from estimator.tolerances.virtual_object import twin_signals
from fem.large_strain.correction import StrainCorrection, corrected_table
from fem.presses.results import MagnetMotions, PressForces

FACE_PARTS = (
    "magnet_seat", "magnet_depth", "magnet_tilt", "remanence",
    "sensor_seat", "sensor_rotation", "sensor_gain",
)  # fmt: skip
"""Contributions (`estimator.tolerances.assembly`) of which the face's own magnets and sensors count."""
WHOLE = ("core_shift", "core_yaw", "modulus")
STIFFENING = (0.7, 0.7, 0.5, 1.0, 0.5)
"""Standard deviations beforehand of the coefficients a to e of `fem.large_strain.correction`."""
ITERATIONS = 12
"""Gauss–Newton steps, at most."""
_STEP, _SETTLED = 0.05, 0.05
"""Step of difference quotients, and of the fit at which it ends (standard deviations)."""
FARTHEST = 5.0
"""Standard deviations that a number may go either way."""
Expected = Callable[[Float[np.ndarray, "number"]], Float[np.ndarray, "row channel"]]
"""Signals that an object of given numbers would show in labelled presses; NaN where it cannot be."""
Weighed = Callable[[np.ndarray], np.ndarray]
"""Inverse covariance of what no numbers explain, times values (row, channel, …)."""


@dataclass(frozen=True)
class Unknowns:
    """Unknowns of an object and of one of its faces, as standard normal numbers one after the other."""

    spec: ObjectSpec
    face: int

    @cached_property
    def design(self) -> Assembly:
        return designed(self.spec)

    @cached_property
    def free(self) -> dict[str, Bool[np.ndarray, "number"]]:
        """Return which numbers of each contribution concern the face, or the whole object."""
        place, sizes = self.design.scene, contribution_sizes(self.design)
        free = {}
        for name in FACE_PARTS:
            owner = (place.sensors if name.startswith("sensor") else place.magnets).face
            free[name] = np.repeat(owner == self.face, sizes[name] // len(owner))
        return free | {name: np.ones(sizes[name], bool) for name in WHOLE}

    def __len__(self) -> int:
        return sum(int(mask.sum()) for mask in self.free.values()) + len(STIFFENING)

    def assembly(self, numbers: Float[np.ndarray, "number"]) -> Assembly:
        """The object of these numbers."""
        draws, start = {}, 0
        for name, mask in self.free.items():
            draws[name] = np.zeros(len(mask))
            draws[name][mask] = numbers[start : start + mask.sum()]
            start += int(mask.sum())
        return assembled(self.spec, self.design, draws)

    def correction(self, numbers: Float[np.ndarray, "number"]) -> StrainCorrection:
        """Its departure from small strain."""
        a, b, c, d, e = (numbers[-len(STIFFENING) :] * STIFFENING).tolist()
        return StrainCorrection(self.spec.shell.thickness_mm, (a, b), (c, d), (e,))

    def signals(
        self, numbers: Float[np.ndarray, "number"], forces: PressForces, motions: MagnetMotions
    ) -> Signals | None:
        """Return signals of every press of the design's table, done by the object of these numbers.

        None where its forces would fall with depth and the design's do not.
        """
        table = corrected_table(self.spec, forces, motions, self.correction(numbers))
        unresolved_in_design, unresolved = (
            unresolved_presses(motions_as_signals(*presses))
            for presses in ((forces, motions), table)
        )
        if np.any(unresolved & ~unresolved_in_design):
            return None
        return twin_signals(self.spec, self.assembly(numbers), *table)


def count_at_limits(numbers: Float[np.ndarray, "number"]) -> int:
    """Return how many numbers went as far as they may."""
    return int(np.sum(abs(numbers) >= FARTHEST - 1e-6))


def most_probable(
    expected: Expected,
    weighed: Weighed,
    counts: Float[np.ndarray, "row channel"],
    numbers: Float[np.ndarray, "number"],
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Numbers of the largest posterior, what they predict, and its Jacobian.

    Steps are halved until the posterior grows.
    """

    def cost(residual: np.ndarray, point: np.ndarray) -> float:
        if not np.isfinite(residual).all():
            return np.inf
        return float(np.sum(residual * weighed(residual)) + point @ point)

    here = expected(numbers)
    for _ in range(ITERATIONS):
        jacobian = jacobian_of(expected, numbers, here)
        precision, pull = normal_equations(weighed, jacobian, counts - here)
        step = np.linalg.solve(precision, pull - numbers)
        last_cost = cost(counts - here, numbers)
        for _ in range(6):
            trial = np.clip(numbers + step, -FARTHEST, FARTHEST)
            trial_counts = expected(trial)
            if cost(counts - trial_counts, trial) <= last_cost:
                break
            step = step / 2
        else:
            return numbers, here, jacobian
        numbers, here = trial, trial_counts
        if np.abs(step).max() < _SETTLED:
            break
    return numbers, here, jacobian_of(expected, numbers, here)


def normal_equations(
    weighed: Weighed, jacobian: np.ndarray, residual: np.ndarray
) -> tuple[Float[np.ndarray, "number number"], Float[np.ndarray, "number"]]:
    """Precision of the numbers, their prior included, and the pull of what is left over."""
    weighed_slopes = weighed(jacobian)
    # 1 + Jᵀ W J, priors being standard normal: r row, c channel, n and m numbers of the twin
    precision = np.eye(jacobian.shape[-1]) + np.einsum("rcn,rcm->nm", jacobian, weighed_slopes)
    return precision, np.einsum("rcn,rc->n", weighed_slopes, residual)


def jacobian_of(
    expected: Expected,
    numbers: Float[np.ndarray, "number"],
    here: Float[np.ndarray, "row channel"],
) -> Float[np.ndarray, "row channel number"]:
    """Return the Jacobian by differences of a twentieth of each number's standard deviation.

    Differences are forward where that is possible; 0 where neither way is.
    """
    columns = []
    for step in np.diag(np.where(numbers < FARTHEST - _STEP, _STEP, -_STEP)):
        stepped = expected(numbers + step)
        if not np.isfinite(stepped).all():
            step = -step
            stepped = expected(numbers + step)
        columns.append((stepped - here) / step.sum())
    return np.nan_to_num(np.stack(columns, axis=-1))  # hemmed in both ways: it stays

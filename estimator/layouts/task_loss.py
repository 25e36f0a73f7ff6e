"""Expected loss of a task: the share of its presses that are missed, misplaced or misjudged.

Of estimates as good as their Cramér–Rao bounds, with normal errors; errors of place and force
are taken as independent. A press is found where the force that is read exceeds what one frame in a hundred
reads at rest. The error of its place is taken as alike in both directions: where all of it lies in one, up to
0.17 more of the presses lie within the distance asked for (where that is half the bound), or up to 0.05 fewer
(from 1.2 times the bound on).
"""

from __future__ import annotations

from collections.abc import Mapping

import torch
from jaxtyping import Float
from torch import Tensor

from design.spec.search import TaskSpec

_ONE_IN_A_HUNDRED = 2.326
"""Standard deviations that a normal variable exceeds so seldom."""
_LEAST = 1e-6
"""Below that losses are not told apart, and have a logarithm."""


def press_loss(
    task: TaskSpec,
    force_n: float,
    position_mm: Float[Tensor, "*place"],
    force_bound_n: Float[Tensor, "*place"],
) -> Float[Tensor, "*place"]:
    """Probability that a press of a force is not read as the task asks, from its bounds (both rms)."""
    misplaced = torch.exp(-((task.within_mm / position_mm) ** 2))
    off, seen = task.force_percent / 100 * force_n / force_bound_n, force_n / force_bound_n
    too_much = torch.special.ndtr(-off)
    too_little = torch.special.ndtr(torch.maximum(-off, _ONE_IN_A_HUNDRED - seen))
    return misplaced + (1 - misplaced) * (too_much + too_little).clamp(max=1)


def expected_loss(
    task: TaskSpec, by_force: Mapping[float, Float[Tensor, "*layout"]]
) -> Float[Tensor, "*layout"]:
    """Mean over the forces (N) that belong to the task, of their means over places; NaN where none does."""
    asked = [loss for force_n, loss in by_force.items() if force_n >= task.from_n]
    if not asked:
        return torch.full_like(next(iter(by_force.values())), torch.nan)
    return torch.stack(asked).mean(dim=0).clamp(min=_LEAST)

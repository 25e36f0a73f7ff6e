"""What the first rung says of a trial; light, as it travels between processes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Scored:
    """What became of a trial: its polished variables, values to minimise and scores.

    `broken_mm` is 0 where every limit is kept; `misfit` says what else does not fit, or nothing.
    """

    params: dict[str, Any]
    values: tuple[float, ...]
    scores: dict[str, float]
    broken_mm: float
    misfit: str

    @property
    def feasible(self) -> bool:
        return self.broken_mm == 0 and not self.misfit

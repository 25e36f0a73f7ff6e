"""Findings in a log: each once, with its evidence and what labels exchanged give."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

CERTAIN = 0.05
"""p up to which a finding counts; what does not beat its null is not used."""
EXCHANGES = 199
"""Exchanges of labels behind each null: p reaches 0.005."""


@dataclass(frozen=True)
class Finding:
    """One answer: the question, what was found, its evidence, and what the null gives.

    `p` is the share of exchanges that reach the evidence (None where no null applies).
    """

    question: str
    answer: str
    evidence: str = ""
    null: str = ""
    p: float | None = None

    def __str__(self) -> str:
        beside = [f"labels exchanged: {self.null}"] if self.null else []
        beside += [] if self.p is None else [f"p {self.p:.2g}"]
        evidence = f"{self.evidence} ({'; '.join(beside)})" if beside else self.evidence
        return f"{self.question}: {self.answer}\n    {evidence}"


def share_as_high(null: Sequence[float], value: float) -> float:
    """p of a value: the share of it and its null that reach it."""
    return float((1 + np.sum(np.array(null) >= value - 1e-12)) / (1 + len(null)))


def numbers_text(numbers: Sequence[int]) -> str:
    """Return whole numbers in a few words, such as `1-3, 7`."""
    parts: list[list[int]] = []
    for number in sorted(numbers):
        if parts and number == parts[-1][-1] + 1:
            parts[-1].append(number)
        else:
            parts.append([number])
    return ", ".join(f"{p[0]}-{p[-1]}" if len(p) > 1 else str(p[0]) for p in parts)

"""Outcomes of random designs, kind by kind, and shares with 95 % intervals (Wilson)."""

from __future__ import annotations

from collections import Counter
from typing import Any

from scipy.stats import binomtest

from tests.random_designs.draw import KINDS

LONGEST_S = 60.0


def summary(rows: list[dict[str, Any]]) -> str:
    """A table of outcomes and longest times, and the shares that a study asks for."""
    passed = [row for row in rows if row["outcome"] not in ("too small", "refused by check")]
    slow = [row for row in passed if not _seconds(row) <= LONGEST_S]
    unsound = ("violates", "told by fabrication")
    shares = [
        ("crashes", _count(rows, "crash"), rows),
        ("violations that nothing told", _count(passed, "violates"), passed),
        ("violations that check did not tell", _count(passed, *unsound), passed),
        ("violations, told or not", _count(passed, *unsound, "told by check"), passed),
        ("refused after check", _count(passed, "refused by build"), passed),
        (f"over {LONGEST_S:g} s", len(slow), passed),
    ]
    return "\n".join([*_table(rows), *_with_intervals(shares)])


def summary_of_requests(rows: list[dict[str, Any]]) -> str:
    """The same of requests for `instobj new`."""
    faults = ("crash", "slow", "fails", "false alarm", "false advice")
    outcomes = ("passes", "told", "fails", "false alarm")
    placed = [row for row in rows if row["outcome"] in outcomes]
    slow = [row for row in rows if not _seconds(row) <= LONGEST_S]
    shares = [
        ("faults", _count(rows, *faults), rows),
        ("placed, and pass at once", _count(placed, "passes"), placed),
        ("placed, told what fails", _count(placed, "told"), placed),
        ("refused", _count(rows, "refused", "false advice"), rows),
        (f"over {LONGEST_S:g} s", len(slow), rows),
    ]
    return "\n".join([*_table(rows), *_with_intervals(shares)])


def _table(rows: list[dict[str, Any]]) -> list[str]:
    outcomes = [name for name, _ in Counter(row["outcome"] for row in rows).most_common()]
    lines = ["| kind | drawn | " + " | ".join(outcomes) + " | longest, s |"]
    lines.append("|---" * (len(outcomes) + 3) + "|")
    for kind in (*KINDS, "all"):
        of_kind = [row for row in rows if kind in (row["kind"], "all")]
        counts = Counter(row["outcome"] for row in of_kind)
        longest = max(map(_seconds, of_kind), default=0.0)
        cells = [kind, len(of_kind), *(counts[name] for name in outcomes), f"{longest:.0f}"]
        lines.append("| " + " | ".join(map(str, cells)) + " |")
    return lines


def _with_intervals(shares: list[tuple[str, int, list[dict[str, Any]]]]) -> list[str]:
    lines = []
    for what, hits, among in shares:
        low, high = (
            binomtest(hits, len(among)).proportion_ci(method="wilson") if among else (0.0, 1.0)
        )
        lines.append(f"{what}: {hits} of {len(among)} ({low:.1%} to {high:.1%})")
    return lines


def _seconds(row: dict[str, Any]) -> float:
    """Infinite where a seed was given up."""
    return float("inf") if row["seconds"] is None else row["seconds"]


def _count(rows: list[dict[str, Any]], *outcomes: str) -> int:
    return sum(row["outcome"] in outcomes for row in rows)

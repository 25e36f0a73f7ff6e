"""Rows of a promotion, for terminal, page and JSON alike."""

from __future__ import annotations

from typing import Any

from instobj.search.fidelity import score_row
from instobj.search.verdict import FIRST, LAST, SECOND, Promoted, Promotion


def promotion_tables(promotion: Promotion) -> dict[str, list[dict[str, Any]]]:
    """Title → rows: scores at each fidelity level, and virtual objects."""
    return {
        "lowest fidelity level: rigid magnets in first reflection, linear signals": _level_rows(
            promotion, FIRST
        ),
        "second fidelity level: rigid magnets, contact and fields in full": _level_rows(
            promotion, SECOND
        ),
        "highest fidelity level: the chain": _level_rows(promotion, LAST),
        "highest fidelity level, between objects within tolerance": ratio_rows(promotion),
    }


def ratio_rows(promotion: Promotion) -> list[dict[str, Any]]:
    """Bounds of the start over those of the best, of the designs and between virtual objects."""
    return [
        {"score": name, "start / best": ratio.design, "95 % from": ratio.low, "to": ratio.high}
        for name, ratio in promotion.ratios.items()
    ]


def _level_rows(promotion: Promotion, level: str) -> list[dict[str, Any]]:
    """One row per score, one column per layout: there are more scores than fit side by side."""
    layouts: tuple[Promoted, ...] = (promotion.start, *promotion.leaders)
    columns = {
        layout.label: score_row(layout.levels[level])
        for layout in layouts
        if level in layout.levels
    }
    if not columns:  # the time ended before that level
        return []
    return [
        {"score": score} | {label: values[score] for label, values in columns.items()}
        for score in columns["start"]
    ]

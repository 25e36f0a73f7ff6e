"""Colours of figures, and lines that several of them draw."""

from __future__ import annotations

from typing import Any

import numpy as np

BLUE, RED, GREEN, GREY = "#1b6ca8", "#c8553d", "#6a994e", "#777777"
PALETTE = (BLUE, RED, GREEN, "#8d6cab", "#b08900", "#3d8f8f")
"""Colours of things that stand side by side, in this order."""


def draw_shares_within(axes: Any, errors: np.ndarray, *style: str, **look: Any) -> None:
    """Draw the share (%) of cases whose error is at most x."""
    ordered = np.sort(errors)
    axes.plot(ordered, 100 * np.arange(1, len(ordered) + 1) / len(ordered), *style, **look)
    axes.set_ylim(0, 102)
    axes.grid(alpha=0.3)


def draw_equality(axes: Any, low: float, high: float) -> None:
    """Draw the line on which both axes agree, in a square between two ends."""
    axes.plot([low, high], [low, high], color=GREY, lw=0.9, label="equal")
    axes.set(xlim=(low, high), ylim=(low, high), aspect="equal")


def draw_limit(axes: Any, limit_mm: float) -> None:
    """Draw a limit across and write it above its right end."""
    axes.axhline(limit_mm, color="0.35", ls="--", lw=1)
    axes.text(
        0.99, limit_mm * 1.05, f"limit {limit_mm:g} mm", ha="right", fontsize=8, color="0.25",
        bbox={"fc": "white", "ec": "none", "alpha": 0.75, "pad": 0.5},
        transform=axes.get_yaxis_transform(),
    )  # fmt: skip

"""What assembly, material and surroundings do to signals and bounds, as rows."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from design.spec.object import ObjectSpec
from instobj.figures.robustness import tolerance_text

if TYPE_CHECKING:
    from estimator.tolerances.result import Robustness


def robustness_summary(spec: ObjectSpec, folder: Path) -> dict[str, list[dict[str, Any]]]:
    """Title → rows of a stage's `robustness.json`."""
    from estimator.tolerances.result import load_robustness

    budget = load_robustness(folder / "robustness.json")
    return {
        f"what one standard deviation does, {budget.force_n:g} N, median place": budget_rows(
            spec, budget
        ),
        "bounds of objects within tolerance, freshly zeroed": bound_rows(budget),
    }


def budget_rows(spec: ObjectSpec, budget: Robustness) -> list[dict[str, Any]]:
    """One row a contribution, worst first, then all together both ways."""
    return [
        {
            "tolerance": tolerance_text(spec, row.name),
            "false place mm": row.false_place_mm,
            "worst mm": row.false_place_worst_mm,
            "false force N": row.false_force_n,
            "worst N": row.false_force_worst_n,
            "ΔS %": 100 * row.signal,
            "rest counts": row.baseline_counts,
            "place bound %": 100 * row.position_bound,
            "force bound %": 100 * row.force_bound,
        }
        for row in (*budget.contributions, budget.together, budget.monte_carlo)
    ]


def bound_rows(budget: Robustness) -> list[dict[str, Any]]:
    """Bounds of the design, and their 5 and 95 % quantiles over drawn objects."""
    named = {
        "place, median place, mm": budget.position_median_mm,
        "place, worst place, mm": budget.position_worst_mm,
        "force, median place, N": budget.force_median_n,
        "force, worst place, N": budget.force_worst_n,
    }
    return [
        {"bound": name, "design": bound.design, "5 %": bound.low, "95 %": bound.high}
        for name, bound in named.items()
    ]

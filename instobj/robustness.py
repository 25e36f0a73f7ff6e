"""`instobj robustness`: what assembly, material and surroundings do to signals and bounds."""

from __future__ import annotations

import json
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

from design.spec import ObjectSpec
from design.spec_io import load_spec, spec_hash
from instobj.chain import Chain
from instobj.publish import file_rows, publish, require_writable, stage_row
from instobj.report.robustness_figure import tolerance_text

if TYPE_CHECKING:
    from estimator.robustness import Robustness


def robustness_of(specs: list[Path], out: Path, overrides: list[str]) -> dict[str, Any]:
    """The budget of each specification, in `runs/<name>/robustness.{json,png}`."""
    require_writable(out)
    return {
        "command": "robustness",
        "objects": [_budget_of(load_spec(path, overrides), out) for path in specs],
    }


def _budget_of(spec: ObjectSpec, out: Path) -> dict[str, Any]:
    from estimator.robustness import load_robustness

    chain = Chain(spec)
    result = chain.require("robustness")
    budget = load_robustness(result.folder / "robustness.json")
    return {
        "name": spec.name,
        "spec_hash": spec_hash(spec),
        "stages": [stage_row(stage) for stage in chain.results.values()],
        "budget": json.loads(json.dumps(asdict(budget))),
        "summary": {
            f"what one standard deviation does, {budget.force_n:g} N, median place": budget_rows(
                spec, budget
            ),
            "bounds of objects within tolerance, freshly zeroed": bound_rows(budget),
        },
        "files": file_rows(publish(spec, result, out)),
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

"""Uncertainty in words and rows: discretisation, modulus, and the budget of tolerances."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from design.spec.object import ObjectSpec
from instobj.figures.robustness import tolerance_text
from instobj.store.readers import ROBUSTNESS

if TYPE_CHECKING:
    from estimator.tolerances.result import Robustness

HEADER = ["depth, mm", "force, rms", "force, largest", "motions, rms", "motions, largest"]
_FIGURES = ("force_rms", "force_worst", "motion_rms", "motion_worst")
_DECIMALS = 4
"""Least value in mm, N, % and counts: what lies below is rounding, and reads as 0."""


def error_text(content: dict[str, Any]) -> str:
    """E.g. "force ±1.2 %, motions ±0.8 % at 2 mm" (root mean square), at half the deepest press."""
    steps = content["steps"]
    middle = steps[-1]["depth_mm"] / 2
    step = min(steps, key=lambda step: abs(step["depth_mm"] - middle))
    if step["force_rms"] is None:
        return f"not known at {step['depth_mm']:g} mm: a coarser mesh misses the contact"
    return (
        f"force ±{_percent(step['force_rms'])}, motions ±{_percent(step['motion_rms'])} "
        f"at {step['depth_mm']:g} mm"
    )


def coarse_mesh_text(spec: ObjectSpec, content: dict[str, Any] | None) -> str:
    """Return that edges of the mesh are longer than the usual ones, and how far motions may be off by the
    discretisation error where it is known; nothing where they are not longer."""
    usual, mesh = type(spec.mesh)(), spec.mesh
    longer = [
        f"{getattr(mesh, key):g} instead of {getattr(usual, key):g} mm"
        for key in ("edge_mm", "surface_edge_mm")
        if getattr(mesh, key) > getattr(usual, key)
    ]
    if not longer:
        return ""
    worst = [step["motion_worst"] for step in content["steps"]] if content else []
    shares = [share for share in worst if share is not None]
    off = f"motions up to {100 * max(shares):.0f} % off" if shares else "motions less exact"
    return f"coarse, edges of {', '.join(longer)}: {off}; confirm with the usual edges, without --set mesh"


def error_rows(content: dict[str, Any]) -> list[list[str]]:
    """A row of `HEADER` for every depth."""
    return [
        [
            f"{step['depth_mm']:g}",
            *("–" if step[n] is None else _percent(step[n]) for n in _FIGURES),
        ]
        for step in content["steps"]
    ]


def error_note(content: dict[str, Any]) -> str:
    """Return how the figures were obtained."""
    return (
        f"Discretisation error, estimated from the same {content['presses']} presses on a mesh with "
        f"edges 1.5 times as long ({content['coarse_unknowns']} unknowns): "
        f"{100 * content['share_of_difference']:.0f} % of the difference, as for an error of second "
        "order. Motions are those of all magnets per newton. A patch load's compliance at a face's "
        f"centre: ±{_percent(content['patch_compliance'])} at most. A dash: the tip misses the coarser "
        "mesh's vertices."
    )


def summary_of(content: dict[str, Any]) -> dict[str, Any]:
    """Return what the command line prints."""
    return {
        "estimate": error_text(content),
        "patch compliance": f"±{_percent(content['patch_compliance'])} at most",
        "coarse unknowns": content["coarse_unknowns"],
    }


def _percent(share: float) -> str:
    return f"{100 * share:.1f} %"


def modulus_text(spec: ObjectSpec) -> str:
    """The modulus with its interval and source, for a person."""
    silicone = spec.silicone
    spread = silicone.youngs_modulus_range_mpa
    ends = f"{spread[0]:.3g} to {spread[1]:.3g}" if spread else "uncertainty not known"
    return f"{silicone.youngs_modulus_mpa:.3g} MPa ({ends}; {silicone.modulus_source})"


def force_spread_text(spec: ObjectSpec) -> str:
    """Effect of the modulus interval on the force at a given depth."""
    spread = spec.silicone.relative_spread
    if spread is None:
        return "scales with the modulus, whose uncertainty is not known"
    return f"{spread[0]:.2f} to {spread[1]:.2f} times what is shown, as the silicone is softer or stiffer"


def travel_text(curves: dict[str, Any]) -> str:
    """Depth at the middle peak force, of what the stage `press_curves` stores."""
    spread = curves["travel"]
    if spread is None:
        return "not known"
    deepest = f"more than {curves['deepest_press_mm']:g} mm"
    nominal, least, most = (
        deepest if spread[name] is None else f"{spread[name]:.2f} mm"
        for name in ("nominal_mm", "stiffest_mm", "softest_mm")
    )
    return f"{nominal} ({least} to {most}) to {spread['force_n']:g} N at the median location"


def robustness_summary(spec: ObjectSpec, folder: Path) -> dict[str, list[dict[str, Any]]]:
    """Title → rows of a stage's `robustness.json`."""

    budget = ROBUSTNESS.read(folder)
    return {
        f"what one standard deviation does, {budget.force_n:g} N, median place": budget_rows(
            spec, budget
        ),
        f"bounds within tolerance, fresh zero, at {forces_text(budget)}": bound_rows(budget),
    }


def budget_rows(spec: ObjectSpec, budget: Robustness) -> list[dict[str, Any]]:
    """One row per contribution, worst first, then all together both ways."""
    figures = {
        "localisation error mm": lambda row: row.false_place_mm,
        "worst mm": lambda row: row.false_place_worst_mm,
        "force error N": lambda row: row.false_force_n,
        "worst N": lambda row: row.false_force_worst_n,
        "ΔS %": lambda row: 100 * row.signal,
        "rest counts": lambda row: row.baseline_counts,
        "position bound %": lambda row: 100 * row.position_bound,
        "force bound %": lambda row: 100 * row.force_bound,
    }
    return [
        {"tolerance": tolerance_text(spec, row.name)}
        | {title: round(figure(row), _DECIMALS) for title, figure in figures.items()}
        for row in (*budget.contributions, budget.together, budget.monte_carlo)
    ]


def forces_text(budget: Robustness) -> str:
    """The force of a budget, and at how many locations it is less as these hardly reach it."""
    from estimator.tolerances.result import REACH_SHARE

    less = f", {budget.reduced_places} places at {REACH_SHARE:g} of deepest press" * bool(
        budget.reduced_places
    )
    return f"{budget.force_n:g} N{less}"


def bound_rows(budget: Robustness) -> list[dict[str, Any]]:
    """Bounds of the design, and their 5 and 95 % quantiles over drawn objects."""
    named = {
        "position, median location, mm": budget.position_median_mm,
        "position, worst location, mm": budget.position_worst_mm,
        "force, median location, N": budget.force_median_n,
        "force, worst location, N": budget.force_worst_n,
    }
    return [
        {"bound": name, "design": bound.design, "5 %": bound.low, "95 %": bound.high}
        for name, bound in named.items()
    ]

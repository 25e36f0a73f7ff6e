"""One form for every proof of the mechanics: what is measured, against what, and a planted fault.

A `Check` measures curves and one error; the error must lie within its tolerance, and beyond it once
the planted fault is in. `write_page` shows them all, a figure each.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import numpy as np
import pytest

from design.files import atomic_path
from fem.linear.factorization import SingularSystemError


@dataclass(frozen=True)
class Curve:
    """Measured values over x, and the reference's values over the same x (None: no reference)."""

    label: str
    x: np.ndarray
    measured: np.ndarray
    reference: np.ndarray | None = None


@dataclass(frozen=True)
class Measured:
    """What a check found: the error that is judged, in words what was found, curves to draw."""

    error: float
    words: str
    curves: tuple[Curve, ...]


@dataclass(frozen=True)
class Fault:
    """A mistake that somebody could make, as a change of the code while the check runs."""

    words: str
    plant: Callable[[pytest.MonkeyPatch], None]


@dataclass(frozen=True)
class Check:
    """One proof: name (of its figure), claim, reference with its source, tolerance and fault.

    `figure` is how its curves are drawn: "values" with their reference, and below them the deviation
    over the tolerance as a band; "errors" on a logarithmic scale under the tolerance; "rates" on two
    logarithmic scales beside lines of the reference's slope. `axes` label x and y, with units.
    """

    name: str
    claim: str
    reference: str
    tolerance: float
    measure: Callable[[], Measured]
    fault: Fault
    figure: Literal["values", "errors", "rates"]
    axes: tuple[str, str]
    logarithmic_x: bool = False


@dataclass(frozen=True)
class Outcome:
    """A check's measurement, and that with the fault planted (None: the code refused to answer)."""

    check: Check
    measured: Measured
    faulty: Measured | None

    @property
    def faulty_error(self) -> float:
        return float("inf") if self.faulty is None else self.faulty.error


def outcome_of(check: Check) -> Outcome:
    """Measure as the code is, then with the fault planted."""
    measured = check.measure()
    with pytest.MonkeyPatch.context() as patch:
        check.fault.plant(patch)
        try:
            faulty = check.measure()
        except SingularSystemError:
            faulty = None
    return Outcome(check, measured, faulty)


def write_page(outcomes: Sequence[Outcome], folder: Path) -> None:
    """`README.md` with a table and a section with its figure for every check."""
    for outcome in outcomes:
        _draw(outcome, folder / f"{outcome.check.name}.svg")
    rows = [
        f"| [{o.check.claim}](#{o.check.name.replace('_', '-')}) | {o.measured.error:.2g} "
        f"| {o.check.tolerance:.2g} | {_faulty(o)} |"
        for o in outcomes
    ]
    sections = [
        f"## {o.check.name.replace('_', ' ')}\n{o.check.claim}. Reference: {o.check.reference}. "
        f"{o.measured.words} Planted fault: {o.check.fault.words} (error then {_faulty(o)}, "
        f"tolerance {o.check.tolerance:.2g}).\n\n![{o.check.claim}]({o.check.name}.svg)"
        for o in outcomes
    ]
    text = (
        "# Proofs of the mechanics\n"
        "Written by `make verify`, which fails where an error exceeds its tolerance or a planted "
        "fault goes unnoticed. The mesher is not deterministic: figures on the cube change a "
        "little from run to run. Further checks, and what is not covered: [scope](scope.md).\n\n"
        "| check | error | tolerance | with a planted fault |\n|---|---|---|---|\n"
    )
    with atomic_path(folder / "README.md") as temporary:
        temporary.write_text(text + "\n".join(rows) + "\n\n" + "\n\n".join(sections) + "\n")


def _faulty(outcome: Outcome) -> str:
    return "refused" if outcome.faulty is None else f"{outcome.faulty_error:.2g}"


def _draw(outcome: Outcome, path: Path) -> None:
    """Dots are measured, lines the reference, crosses are with the fault planted."""
    import matplotlib

    matplotlib.use("Agg")
    matplotlib.rcParams["svg.hashsalt"] = "verification"
    import matplotlib.pyplot as plt

    check = outcome.check
    panels = 2 if check.figure == "values" else 1
    figure, grid = plt.subplots(
        panels, 1, figsize=(7.2, 4.8), sharex=True, squeeze=False, height_ratios=[2, 1][:panels]
    )
    axes, lowest = grid[0, 0], grid[-1, 0]
    _draw_curves(axes, outcome)
    if check.figure == "values":
        _draw_deviations(lowest, outcome)
    if check.figure == "errors":
        top = axes.get_ylim()[1]
        axes.axhspan(check.tolerance, top, color="C3", alpha=0.08, linewidth=0)
        axes.axhline(check.tolerance, color="C3", linewidth=1, label="tolerance")
    lowest.set_xlabel(check.axes[0])
    axes.set_ylabel(check.axes[1])
    axes.set_title(check.claim, fontsize=10, loc="left", wrap=True)
    axes.legend(frameon=False, fontsize=8, loc="center left", bbox_to_anchor=(1.01, 0.5))
    for panel in grid[:, 0]:
        panel.spines[["top", "right"]].set_visible(False)
    with atomic_path(path) as temporary:
        figure.savefig(temporary, format="svg", metadata={"Date": None}, bbox_inches="tight")
    plt.close(figure)


def _draw_curves(axes, outcome: Outcome) -> None:
    check, every = outcome.check, []
    for index, curve in enumerate(outcome.measured.curves):
        colour = f"C{index + (index > 2)}"  # C3, red, is the tolerance's
        every.append(curve.measured)
        axes.plot(curve.x, _shown(check, curve.measured), "o", color=colour, label=curve.label)
        if curve.reference is not None:
            every.append(curve.reference)
            axes.plot(curve.x, curve.reference, "-", color=colour, linewidth=1)
        if outcome.faulty is not None and index < len(outcome.faulty.curves):
            wrong = outcome.faulty.curves[index].measured
            every.append(wrong)
            label = "with the planted fault" if index == 0 else None
            axes.plot(
                curve.x,
                _shown(check, wrong),
                "x",
                color=colour,
                alpha=0.6,
                markersize=5,
                label=label,
            )
    if check.figure != "values":
        axes.set_yscale("log")
        sizes = np.concatenate([_shown(check, np.asarray(values)) for values in every])
        bounds = (
            [*sizes[np.isfinite(sizes)], check.tolerance] if check.figure == "errors" else sizes
        )
        axes.set_ylim(0.4 * np.min(bounds), 2.5 * np.max(bounds))
    if check.figure == "rates" or check.logarithmic_x:
        axes.set_xscale("log")


def _draw_deviations(axes, outcome: Outcome) -> None:
    """Measured over reference, less 1, in per cent; the tolerance as a band."""
    percent = 100 * outcome.check.tolerance
    axes.axhspan(-percent, percent, color="C2", alpha=0.15, linewidth=0)
    axes.axhline(0, color="0.5", linewidth=0.6)
    for index, curve in enumerate(outcome.measured.curves):
        deviation = 100 * (curve.measured / curve.reference - 1)
        axes.plot(curve.x, deviation, "o", color=f"C{index}", markersize=4)
    bound = 2 * percent
    axes.set_ylim(-bound, bound)
    axes.set_ylabel("deviation, %\n(band: tolerance)")


def _shown(check: Check, values: np.ndarray) -> np.ndarray:
    """Errors of exactly zero are shown at rounding's level."""
    return values if check.figure == "values" else np.maximum(abs(values), 1e-17)

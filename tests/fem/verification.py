"""One form for every proof of the mechanics: what is measured, against what, and a planted fault.

A `Check` measures curves against a reference and one error; the error must lie within its
tolerance, and beyond it once the planted fault is in. `write_page` shows them all, a figure each.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

from design.files import atomic_path

INCH_PER_COLUMN = 4.6


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
    """One proof: name (of its figure), claim, reference with its source, tolerance and fault."""

    name: str
    claim: str
    reference: str
    tolerance: float
    measure: Callable[[], Measured]
    fault: Fault
    axes: tuple[str, str]
    logarithmic: bool = False


@dataclass(frozen=True)
class Outcome:
    """A check's measurement, and its error with the fault planted (infinite where it refused)."""

    check: Check
    measured: Measured
    faulty_error: float


def faulty_error(check: Check) -> float:
    """The check's error with its fault planted; infinite where the solver refuses to answer."""
    with pytest.MonkeyPatch.context() as patch:
        check.fault.plant(patch)
        try:
            return check.measure().error
        except (ArithmeticError, ValueError):
            return float("inf")


def write_page(outcomes: list[Outcome], folder: Path) -> None:
    """`README.md` with a table and a section with its figure for every check."""
    outcomes = sorted(outcomes, key=lambda outcome: outcome.check.name)
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
        "# The proofs, with a figure each\n"
        "Written by `make verify`, which fails where an error exceeds its tolerance or a planted "
        "fault goes unnoticed. The mesher is not deterministic: figures on the cube change a "
        "little from run to run.\n\n"
        "| check | error | tolerance | with a planted fault |\n|---|---|---|---|\n"
    )
    with atomic_path(folder / "README.md") as temporary:
        temporary.write_text(text + "\n".join(rows) + "\n\n" + "\n\n".join(sections) + "\n")


def _faulty(outcome: Outcome) -> str:
    if np.isinf(outcome.faulty_error):
        return "refused"
    return f"{outcome.faulty_error:.2g}"


def _draw(outcome: Outcome, path: Path) -> None:
    """Measured curves over their references, and below them the relative difference."""
    import matplotlib

    matplotlib.use("Agg")
    matplotlib.rcParams["svg.hashsalt"] = "verification"
    import matplotlib.pyplot as plt

    check = outcome.check
    figure, axes = plt.subplots(figsize=(1.5 * INCH_PER_COLUMN, INCH_PER_COLUMN))
    for index, curve in enumerate(outcome.measured.curves):
        colour = f"C{index}"
        axes.plot(curve.x, curve.measured, "o", color=colour, label=curve.label)
        if curve.reference is not None:
            axes.plot(curve.x, curve.reference, "-", color=colour, linewidth=1)
    if check.logarithmic:
        axes.set_xscale("log")
        axes.set_yscale("log")
    else:
        axes.axhline(0, color="0.7", linewidth=0.6)
    axes.set_xlabel(check.axes[0])
    axes.set_ylabel(check.axes[1])
    axes.set_title(f"{check.claim}\ndots: measured, lines: reference", fontsize=9, loc="left")
    axes.legend(frameon=False, fontsize=8)
    axes.spines[["top", "right"]].set_visible(False)
    figure.tight_layout()
    with atomic_path(path) as temporary:
        figure.savefig(temporary, format="svg", metadata={"Date": None})
    plt.close(figure)

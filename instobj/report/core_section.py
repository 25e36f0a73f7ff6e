"""The core in the report: what its slip costs, and where a sliding shell would lift off."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from design.spec.object import ObjectSpec
from instobj.report.pages import render
from instobj.store import readers

_ROWS = {
    "baseline change, median sensor, counts": "baseline_median_counts",
    "baseline change, worst sensor, counts": "baseline_largest_counts",
    "baseline change, median sensor, σ": "baseline_median_sigma",
    "baseline change, worst sensor, σ": "baseline_largest_sigma",
    "pattern of a press: cosine, median": "cosine_median",
    "pattern of a press: cosine, worst location": "cosine_worst",
    "size of a press's signal, smallest ratio": "size_ratio_smallest",
    "size of a press's signal, largest ratio": "size_ratio_largest",
    "localisation error, mm, median, old baseline": "false_place_mm_median",
    "localisation error, mm, worst, old baseline": "false_place_mm_worst",
    "force error, N, median, old baseline": "false_force_n_median",
    "force error, N, worst, old baseline": "false_force_n_worst",
    "localisation error, mm, median, new baseline": "rezeroed_place_mm_median",
    "localisation error, mm, worst, new baseline": "rezeroed_place_mm_worst",
    "force error, N, median, new baseline": "rezeroed_force_n_median",
    "force error, N, worst, new baseline": "rezeroed_force_n_worst",
}

FIGURES = tuple(_ROWS.values())
"""Names of the figures of a slip that tables show, chosen from what the stage stores."""


def core_section(spec: ObjectSpec, presses: Path, slip: Path) -> str:
    """HTML; empty for a bonded core that has not slipped.

    `presses` and `slip` are the folders of these stages.
    """
    tension = readers.CORE_TENSION.read(presses)
    if tension is not None:
        return render("core.html.j2", tension=tension)
    if not spec.mechanics.slip.slipped:
        return ""
    content = readers.SLIP.read(slip)
    return render(
        "core.html.j2",
        tension=None,
        slip=slip_title(content["slip"]),
        figure=readers.SLIP_PICTURE.path(slip),
        rows=slip_rows(content["figures"]),
    )


def slip_rows(figures: dict[str, float]) -> list[dict[str, Any]]:
    """One row per figure."""
    return [{"what": title, "value": figures[key]} for title, key in _ROWS.items()]


def slip_title(slip: dict[str, Any]) -> str:
    """The slip in words."""
    parts = []
    if any(slip["shift_mm"]):
        parts.append("shift " + _vector(slip["shift_mm"]) + " mm")
    if any(slip["rotation_deg"]):
        parts.append("rotation " + _vector(slip["rotation_deg"]) + "°")
    return f"core slipped: {', '.join(parts)}, rim {slip['rim']}"


def _vector(values: tuple[float, float, float]) -> str:
    return "(" + ", ".join(f"{value:g}" for value in values) + ")"

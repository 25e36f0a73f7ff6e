"""The report's words on the core: what its slip costs, and where a sliding shell would lift off."""

from __future__ import annotations

import json
from html import escape
from pathlib import Path

from design.spec.object import ObjectSpec
from instobj.report import elements


def core_section(spec: ObjectSpec, presses: Path, scratch: Path) -> str:
    """HTML; empty for a bonded core that has not slipped.

    `presses` is the folder of the presses' stage. The slip is measured by both models against the
    object as calibrated; its simulation is made, or reused from the store, here.
    """
    tension = presses / "core_tension.json"
    if tension.exists():
        return _sliding(json.loads(tension.read_text(encoding="utf-8")))
    return _slipped(spec, scratch) if spec.mechanics.slip.slipped else ""


def _sliding(tension: dict[str, float]) -> str:
    place = ", ".join(f"{tension[f'{axis}_mm']:.3g}" for axis in "xyz")
    drop = 100 * tension["force_drop_where_it_lifts_off"]
    return (
        "<h2>Sliding core</h2><p>The shell slides on its core; the table of presses takes it never to "
        f"lift off. It would: tension reaches {tension['largest_tension_kpa_per_n']:.3g} kPa per "
        f"newton of press force, at ({place}) mm, under a press on face {tension['press_face']:g} at "
        f"({tension['press_x_mm']:.3g}, {tension['press_y_mm']:.3g}) mm. On a core that only pushes "
        f"that press takes {drop:.3g} % less force at the deepest travel: so much softer than shown "
        "is the worst place where the silicone does not stick. <code>instobj press</code> and "
        "<code>instobj grasp</code> let it lift off.</p>"
    )


def _slipped(spec: ObjectSpec, scratch: Path) -> str:
    from instobj.commands.slip import comparison_rows, draw_slip, slip_costs, slip_title, summary

    slip = spec.mechanics.slip.model_dump(mode="json")
    _, costs = slip_costs(spec, slip)
    figure = scratch / "slip.png"
    draw_slip(spec, costs, figure, slip_title(slip))
    rows = comparison_rows({model: summary(cost) for model, cost in costs.items()})
    columns = ("fem", "sensors-only", "its error")
    cells = [[row["what"], *(f"{row[name]:.3g}" for name in columns)] for row in rows]
    return (
        f"<h2>Slipped core</h2><p>{escape(slip_title(slip))}. Signals in this report are those of the "
        f"model {escape(slip['model'])!r}. The table reads them as an estimator calibrated before the "
        "slip would, linearised, from each face's own channels; the last column is what moving the "
        "sensors alone gets wrong.</p>"
        + elements.image(figure, "Cost of the slip")
        + elements.table(list(rows[0]), cells)
    )
